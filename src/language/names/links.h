// What a name means beyond its file: the same uniform in the scene and in every stage, the same varying in two stages,
// the same function wherever its file is included.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/language/project.h"
#include "src/language/scene/statements.h"
#include "src/language/shader/outline.h"

namespace snell::language {

// The texts of a project, each read once, and who uses them.
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

// What is written at a place.
struct Named {
    enum class What : std::uint8_t {
        nothing,
        language,  // a word of the language: a command, a keyword, a built-in function
        local,     // `declaration` of its outline
        member,
        global,   // of a shader
        uniform,  // in a scene; of `program`
        ladder,   // `ladder`, and a rung if `rung` is set; in a scene or a shader
        file      // of a statement or of #include
    };
    What what = What::nothing;
    std::string name;
    Span span;
    int declaration = -1;
    Index program = none, ladder = none;
    std::optional<std::size_t> rung;
};
Named named_at(Texts& texts, FileId file, std::uint32_t offset);

// A place that names it. Spans are in the files that editors have open.
struct Place {
    Span span;
    bool declares = false;
    bool in_scene = false;
};

// All that a global name, or a uniform of a scene, is linked to.
struct Linked {
    std::vector<ShaderUse> stages;
    std::vector<Index> programs;  // whose uniforms of that name belong to it
};
Linked linked(Texts& texts, const Named& named);

// Every place that names the same, sorted, each once.
std::vector<Place> places(Texts& texts, const Named& named);
std::vector<Place> places(Texts& texts, std::string_view name, const Linked& linked);

// The global declarations of the name in the stage, or in the file if no stage uses it.
struct DeclaredPlace {
    FileId file = 0;
    const ShaderDeclaration* declaration = nullptr;
};
std::vector<DeclaredPlace> declarations(Texts& texts, const ShaderUse& use, std::string_view name);
std::vector<DeclaredPlace> declarations(Texts& texts, FileId file, std::string_view name);

// The program whose Program statement, or stray line of uniforms, is at the place; `none` if there is none.
Index program_at(Texts& texts, FileId file, std::uint32_t offset);
// The source that the name of a file leads to; nullopt if it is not a text of the project.
std::optional<FileId> named_file(Texts& texts, const Named& named);

}  // namespace snell::language
