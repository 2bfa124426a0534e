#include "src/app/create/kinds.h"

#include <fmt/format.h>

#include <array>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell::app {

namespace {

constexpr auto table = std::to_array<Kind>({
    {"blank", "a lit ball in one colour", "blank", ""},
    {"noise", "marble, by noise", "noise marble", ""},
    {"displace", "waves, by a vertex shader that moves a flat square", "displace displacement waves", ""},
    {"image", "a picture and filters of its texels", "image picture photo", ""},
    {"geometry", "a ball that a geometry shader takes apart", "geometry triangles", ""},
    {"reflect", "a teapot that mirrors the sky", "reflect reflection mirror metal", ""},
    {"refract", "a ball of glass under the sky", "refract refraction glass", "reflect/sky"},
});

// Lower-case runs of letters.
std::vector<std::string> words_in(std::string_view name) {
    std::vector<std::string> words(1);
    for (const char c : name) {
        const char small = lower(c);
        // Bytes of letters beyond ASCII belong to words, too.
        if ((small >= 'a' && small <= 'z') || static_cast<unsigned char>(c) >= 0x80)
            words.back() += small;
        else if (!words.back().empty())
            words.emplace_back();
    }
    return words;
}

}  // namespace

std::span<const Kind> kinds() { return table; }

Choice kind_for(std::string_view name) {
    Choice choice{nullptr, ""};
    for (const std::string& word : words_in(name))
        for (const Kind& kind : table) {
            const std::vector<std::string_view> own = split(kind.words, ' ');
            if (ranges::find(own, word) == own.end() || choice.kind == &kind) continue;
            if (choice.kind) return {table.data(), ""};
            choice = {&kind, word};
        }
    return choice.kind ? choice : Choice{table.data(), ""};
}

std::vector<NewFile> files_of(const Kind& kind, std::string_view stem) {
    const std::string own = fmt::format("{}/", kind.name), scene = fmt::format("{0}/{0}.glib", kind.name);
    std::vector<NewFile> files;
    for (const TemplateFile& file : template_files()) {
        const bool borrowed = !kind.borrows.empty() && file.path.starts_with(kind.borrows);
        if (file.path == scene)
            files.insert(files.begin(), {fmt::format("{}.glib", stem), file.bytes});
        else if (borrowed || file.path.starts_with(own))
            files.push_back({std::string(file.path.substr(file.path.find('/') + 1)), file.bytes});
    }
    return files;
}

}  // namespace snell::app
