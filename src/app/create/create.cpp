// `snell new`: new folders with a scene to start from, of the kinds of src/app/open/templates.h.
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/command_text.h"
#include "src/app/open/complain.h"
#include "src/app/open/templates.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

struct NewOptions {
    std::string name, kind;
};

// What is wrong with the name itself, and what to do; both empty if nothing is.
struct Objection {
    std::string what, help;
};

Objection objection_to(const fs::path& folder, const std::string& given) {
    const std::string last = folder.filename().string();
    if (last.empty() || last == "." || last == "..")
        return {fmt::format("'{}' is not a name for a new folder", given), "name it, as in 'snell new glass'"};
    if (ranges::any_of(given, [](unsigned char c) { return c < 0x20 || c == 0x7F; }))
        return {fmt::format("the name '{}' has control characters", given), "use letters, digits, '-' and '_'"};
    if (folder.extension() == ".glib")
        return {fmt::format("'{}' is the name of a scene: a folder with the scene in it is made", given),
                fmt::format("did you mean 'snell new {}'?", folder.stem().string())};
    return {};
}

// A name like it that is free.
fs::path free_name(const fs::path& folder) {
    std::error_code none;
    for (int i = 2;; ++i)
        if (fs::path free = fmt::format("{}-{}", folder.string(), i); !fs::exists(fs::symlink_status(free, none)))
            return free;
}

// The name does not say which kind is meant.
Exit ask_back(const std::vector<Choice>& chosen, const std::string& name) {
    std::string kinds_of_name, help = fmt::format("choose one: snell new {} --kind ", file_word(name));
    if (chosen.empty()) {
        for (const Kind& kind : kinds()) help += fmt::format("{}{}", &kind == kinds().data() ? "" : "|", kind.name);
        if (const std::string_view near = nearest_word(fs::path(name).filename().string()); !near.empty())
            help = fmt::format("did you mean '{}'? Otherwise {}", near, help);
        return complain(exit_usage, fmt::format("no word of the name '{}' says which kind of scene it is", name), help);
    }
    for (const Choice& choice : chosen) {
        kinds_of_name +=
            fmt::format("{}'{}' for {}", kinds_of_name.empty() ? "" : ", ", choice.word, choice.kind->name);
        help += fmt::format("{}{}", &choice == chosen.data() ? "" : "|", choice.kind->name);
    }
    return complain(exit_usage, fmt::format("words of the name '{}' disagree: {}", name, kinds_of_name), help);
}

Exit make_new(const NewOptions& options) {
    std::string name = options.name.empty() ? options.kind.empty() ? "blank" : options.kind : options.name;
    while (name.size() > 1 && name.back() == '/') name.pop_back();
    const fs::path folder = name;
    if (const Objection objection = objection_to(folder, name); !objection.what.empty())
        return complain(exit_usage, objection.what, objection.help);

    const std::string stem = folder.filename().string();
    std::vector<Choice> chosen = kinds_for(stem);
    if (const std::string given = options.name.empty() ? name : options.kind; !given.empty())
        chosen = {{&*ranges::find(kinds(), given, &Kind::name), ""}};
    if (chosen.size() != 1) return ask_back(chosen, name);
    const Choice& choice = chosen.front();

    std::error_code none;
    if (fs::exists(fs::symlink_status(folder, none)))
        return complain(exit_input, fmt::format("'{}' exists already", name),
                        fmt::format("choose another name, such as '{}'", free_name(folder).string()));
    if (const std::string error = write_folder(folder, files_of(*choice.kind, stem)); !error.empty())
        return complain(exit_input, fmt::format("cannot make '{}': {}", name, error),
                        "choose a folder where you may write, and a name that its file system takes");

    fmt::print("{}: {}, kind {}{}\nopen it: snell {}\n", utf8::printable(name), choice.kind->summary, choice.kind->name,
               choice.word.empty() ? "" : fmt::format(" because of '{}' in the name", utf8::printable(choice.word)),
               utf8::printable(file_word((folder / (stem + ".glib")).string())));
    return exit_fine;
}

std::string notes() {
    std::string text = "Kinds, each with the words that choose it:\n";
    for (const Kind& kind : kinds()) text += fmt::format("  {:<9} {} ({})\n", kind.name, kind.summary, kind.words);
    return text +
           "\nWithout --kind, the words of NAME choose: 'glass-1' is of kind refract. A name of which no word\n"
           "does, or several disagree, needs --kind. Without NAME and --kind, the kind is blank.";
}

}  // namespace

Run add_new(CLI::App& command) {
    auto options = std::make_shared<NewOptions>();
    command.add_option("NAME", options->name, "the new folder; the scene in it has the same name. Default: the kind")
        ->check([](const std::string& text) { return text.empty() ? "the name of the folder is empty" : ""; });
    std::vector<std::string> names;
    for (const Kind& kind : kinds()) names.emplace_back(kind.name);
    command.add_option("--kind", options->kind, "what the scene shows")->check(CLI::IsMember(names));
    command.footer(notes());
    return [options] { return make_new(*options); };
}

}  // namespace snell::app
