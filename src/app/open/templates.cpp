#include "src/app/open/templates.h"

#include <array>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/replace.h"

namespace snell::app {

namespace fs = std::filesystem;

namespace {

constexpr auto table = std::to_array<Kind>({
    {"blank", "a lit ball in one colour", "blank", ""},
    {"noise", "marble, by noise", "noise marble", ""},
    {"bump", "a flat wall of bricks that light shows as solid", "bump bumps bumpy bricks", ""},
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

std::vector<Choice> kinds_for(std::string_view name) {
    std::vector<Choice> found;
    for (const std::string& word : words_in(name))
        for (const Kind& kind : table) {
            const std::vector<std::string_view> own = split(kind.words, ' ');
            if (ranges::find(own, word) != own.end() && ranges::find(found, &kind, &Choice::kind) == found.end())
                found.push_back({&kind, word});
        }
    return found;
}

std::string_view nearest_word(std::string_view name) {
    std::vector<std::string_view> known;
    for (const Kind& kind : table)
        for (const std::string_view word : split(kind.words, ' ')) known.push_back(word);
    for (const std::string& word : words_in(name))
        if (const std::string_view near = nearest(word, known); !near.empty()) return near;
    return {};
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

std::string write_folder(const fs::path& folder, const std::vector<NewFile>& files) {
    const fs::path parent = folder.parent_path(),
                   part = parent / fmt::format(".{}.{}.part", folder.filename().string(), getpid());
    std::error_code wrong, ignored;
    std::string error;
    fs::path there = parent;
    while (!there.empty() && !fs::exists(there, ignored)) there = there.parent_path();
    if (fs::create_directories(part, wrong); wrong) error = wrong.message();
    for (const NewFile& file : files) {
        if (!error.empty()) break;
        fs::create_directories((part / file.path).parent_path(), wrong);
        error = wrong ? wrong.message() : content::write_file(part / file.path, file.bytes);
    }
    if (error.empty()) {
        fs::rename(part, folder, wrong);
        error = wrong ? wrong.message() : "";
    }
    if (error.empty()) return error;
    fs::remove_all(part, ignored);
    for (fs::path made = parent; made != there; made = made.parent_path()) fs::remove(made, ignored);
    return error;
}

}  // namespace snell::app
