// All names of a scene and its shaders, renamed at once.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "src/language/services.h"

namespace snell::language {

// Writes the files of the scene; returns the old names by the new ones, which begin with `prefix`.
inline std::map<std::string, std::string> rename_all(const std::string& scene, const std::string& prefix) {
    const Project project = read_project(scene, {}, Depth::plan);
    std::vector<FileId> files{project.scene_file};
    for (const Shader& shader : project.shaders)
        if (!shader.path.empty()) files.push_back(shader.file);
    std::map<std::string, std::string> names;
    std::map<FileId, std::map<std::uint32_t, Edit>> edits;
    for (const FileId file : files)
        for (const SemanticToken& token : semantic_tokens(project, file)) {
            if (edits[file].contains(token.span.begin)) continue;
            const std::string name = prefix + std::to_string(names.size());
            const Rename result = rename(project, file, token.span.begin, name);
            if (result.edits.empty()) continue;
            const std::string_view text = project.sources.text(file);
            names[name] = text.substr(token.span.begin, token.span.end - token.span.begin);
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
