// The texts of a project, each read once, and who uses them.
#pragma once

#include <map>
#include <vector>

#include "src/language/project.h"
#include "src/language/scene/statements.h"
#include "src/language/shader/outline.h"

namespace snell::language {

class Texts {
public:
    explicit Texts(const Project& of) : project(of) {}

    const Project& project;

    const Outline& outline(FileId file);
    const Statements& statements(FileId file);
    bool is_scene(FileId file) const { return project.is_scene(file); }
    // The source of the same file that was read first: the one that editors have open.
    FileId first(FileId file) const { return project.first(file); }
    Span first(Span span) const { return {first(span.file), span.begin, span.end}; }
    // The stages whose text the file is a part of.
    std::vector<ShaderUse> uses(FileId file) const;
    // The files of a stage: what the scene names, and what that includes.
    std::vector<FileId> files(const ShaderUse& use) const;
    // The file, and those of all stages that it is a part of; each once, the file first.
    std::vector<FileId> together(FileId file) const;

private:
    std::map<FileId, Outline> outlines_;
    std::map<FileId, Statements> statements_;
};

}  // namespace snell::language
