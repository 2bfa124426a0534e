#include "src/language/names/texts.h"

#include "parser/text/ranges.h"

namespace snell::language {

const Outline& Texts::outline(FileId file) {
    const auto found = outlines_.find(file);
    if (found != outlines_.end()) return found->second;
    return outlines_.emplace(file, read_outline(file, project.sources.text(file))).first->second;
}

const Statements& Texts::statements(FileId file) {
    const auto found = statements_.find(file);
    if (found != statements_.end()) return found->second;
    return statements_.emplace(file, read_statements(file, project.sources.text(file))).first->second;
}

std::vector<ShaderUse> Texts::uses(FileId file) const {
    const Shader* shader = project.shader_of(file);
    return shader == nullptr ? std::vector<ShaderUse>() : shader->uses;
}

std::vector<FileId> Texts::files(const ShaderUse& use) const {
    std::vector<FileId> found;
    for (const Shader& shader : project.shaders)
        if (ranges::find(shader.uses, use) != shader.uses.end()) found.push_back(shader.file);
    return found;
}

std::vector<FileId> Texts::together(FileId file) const {
    std::vector<FileId> found{file};
    for (const ShaderUse& use : uses(file))
        for (const FileId other : files(use))
            if (ranges::find(found, other) == found.end()) found.push_back(other);
    return found;
}

}  // namespace snell::language
