#include "src/app/open/command_text.h"

#include <fmt/format.h>

#include <filesystem>

#include "parser/text/ranges.h"
#include "src/document/save_values.h"

namespace snell {

namespace {

// Leaves out the program's name if no other program has a uniform of this name.
std::string option_name(const Document& document, const Control& control) {
    const auto same = ranges::count(document.controls.items, control.name, &Control::name);
    return same == 1 ? control.name
                     : fmt::format("{}.{}", document.scene().programs[control.program].name, control.name);
}

}  // namespace

std::string shell_word(std::string_view word) {
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:@%";
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string file_word(const std::string& name) { return shell_word(name.starts_with('-') ? "./" + name : name); }

std::vector<std::string> changed_rungs(const Scene& scene, const Rungs& rungs) {
    std::vector<std::string> chosen;
    for (std::size_t i = 0; i < scene.ladders.size() && i < rungs.size(); ++i) {
        const Ladder& ladder = scene.ladders[i];
        if (rungs[i] != ladder.current && rungs[i] < ladder.rungs.size())
            chosen.push_back(ladder.name + "=" + ladder.rungs[rungs[i]]);
    }
    return chosen;
}

std::vector<std::string> value_options(const Document& document, const View& view) {
    std::vector<std::string> words;
    const auto add = [&words](const char* option, std::string value) {
        words.insert(words.end(), {option, std::move(value)});
    };
    if (std::string text = view_text(view); !text.empty()) add("--view", std::move(text));
    for (const Control& control : document.controls.items)
        if (control.active && control.value != control.initial)
            add("--set", fmt::format("{}={}", option_name(document, control), fmt::join(control.value, ",")));
    for (std::string& choice : changed_rungs(document.scene(), document.controls.rungs))
        add("--ladder", std::move(choice));
    return words;
}

std::string render_command(const Document& document, const Picture& picture) {
    const std::string stem = std::filesystem::path(document.path).stem().string();
    std::string line =
        fmt::format("snell render {} -o {} --size {}x{}", file_word(document.path),
                    file_word(picture.file.empty() ? stem + ".png" : picture.file), picture.width, picture.height);
    if (picture.samples > 1) line += fmt::format(" --samples {}", picture.samples);
    if (picture.transparent) line += " --transparent";
    if (picture.frames > 0) line += fmt::format(" --frames {} --fps {}", picture.frames, picture.rate);
    if (picture.view.axes) line += " --axes";
    if (picture.time != 0) line += fmt::format(" --time {}", picture.time);
    for (const std::string& word : value_options(document, picture.view)) line += ' ' + shell_word(word);
    return line;
}

std::string accuracy_command(const std::string& scene, const std::vector<std::string>& choices) {
    std::string line = "snell accuracy " + file_word(scene);
    for (const std::string& choice : choices) line += " --ladder " + shell_word(choice);
    return line;
}

std::string apply_command(const std::string& scene, const std::vector<std::string>& choices, const std::string& rung,
                          const std::string& folder) {
    return fmt::format("{} --apply {} -o {}", accuracy_command(scene, choices), rung, file_word(folder));
}

}  // namespace snell
