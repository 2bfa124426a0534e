#include "src/app/open/command_text.h"

#include <fmt/format.h>

#include <filesystem>

#include "parser/text/ranges.h"
#include "src/plan/setup.h"

namespace snell {

std::string shell_word(std::string_view word) {
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:@%";
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string file_word(const std::string& name) { return shell_word(name.starts_with('-') ? "./" + name : name); }

std::vector<std::string> value_options(const Document& document, const View& view) {
    std::vector<std::string> words;
    const auto add = [&words](const char* option, std::string value) {
        words.insert(words.end(), {option, std::move(value)});
    };
    if (std::string text = view_text(view); !text.empty()) add("--view", std::move(text));
    for (std::string& value : set_arguments(document.scene(), document.controls, true)) add("--set", std::move(value));
    for (std::string& rung : arguments_of(changed_setup(document.scene(), document.controls), ladder_option))
        add("--ladder", std::move(rung));
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
