// All names of a scene and its shaders, renamed at once.
#pragma once

#include <cctype>

#include "src/language/services.h"
#include "tests/std.h"

namespace snell::language {

// Whatever looks like a name, by its place.
inline std::map<std::uint32_t, std::string> words_of(std::string_view text) {
    const auto of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    std::map<std::uint32_t, std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && of_name(text[end])) ++end;
        if (end > at && std::isdigit(static_cast<unsigned char>(text[at])) == 0)
            words.emplace(static_cast<std::uint32_t>(at), text.substr(at, end - at));
        at = std::max(end, at + 1);
    }
    return words;
}

// Writes the files of the scene; returns the old names by the new ones, which begin with `prefix`.
inline std::map<std::string, std::string> rename_all(const std::string& scene, const std::string& prefix) {
    const Project project = read_project(scene, {}, Depth::plan);
    std::vector<FileId> files{project.scene_file};
    for (const Shader& shader : project.shaders)
        if (!shader.path.empty()) files.push_back(shader.file);
    std::map<std::string, std::string> names;
    std::map<FileId, std::map<std::uint32_t, Edit>> edits;
    for (const FileId file : files)
        for (const auto& [begin, word] : words_of(project.sources.text(file))) {
            if (edits[file].contains(begin)) continue;
            const std::string name = prefix + std::to_string(names.size());
            const Rename result = rename(project, file, begin, name);
            if (result.edits.empty()) continue;
            names[name] = word;
            for (const Edit& edit : result.edits)
                EXPECT_TRUE(edits[edit.span.file].emplace(edit.span.begin, edit).second)
                    << "two names claim '" << names[name] << "'";
        }
    for (const auto& [file, places] : edits) {
        std::vector<Edit> all;
        for (const auto& [place, edit] : places) all.push_back(edit);
        std::ofstream(std::string(project.path_of(file)), std::ios::binary | std::ios::trunc)
            << with_edits(project.sources.text(file), file, all);
    }
    return names;
}

}  // namespace snell::language
