// New names. A rename that could change the picture, or that would need files which are not the user's, is refused.
#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "parser/commands/commands.h"
#include "parser/text/ranges.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"
#include "src/language/names/links.h"
#include "src/language/services.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using What = Named::What;

bool set_by_snell(std::string_view name) {
    return name.starts_with("gl_") || name.starts_with("snell") ||
           ranges::any_of(glsl::system_names(), [&](const glsl::SystemName& s) { return s.name == name; }) ||
           ranges::any_of(glsl::attribute_names(), [&](const glsl::AttributeName& a) { return a.name == name; });
}

bool identifier(std::string_view name) {
    return !name.empty() && glsl::identifier_start(name.front()) && ranges::all_of(name, glsl::identifier_part);
}

// Why no name of a shader can be called so; empty if it can.
std::string unusable(std::string_view name) {
    if (!identifier(name)) return fmt::format("'{}' is not a name: use letters, digits and '_'", name);
    if (glsl::is_language_word(name)) return fmt::format("'{}' is a word of GLSL", name);
    if (name == "defined" || name == "main") return fmt::format("'{}' has a meaning in GLSL", name);
    if (name.find("__") != std::string_view::npos) return "GLSL reserves names with two underscores in a row";
    if (name.starts_with("GL_")) return "GLSL reserves names that begin with 'GL_'";
    if (set_by_snell(name)) return fmt::format("snell gives '{}' a value of its own", name);
    return {};
}

// The macros of ladders.
bool of_ladder(const Scene& scene, std::string_view name) {
    return ranges::any_of(scene.ladders, [&](const Ladder& ladder) {
        return name == ladder.name ||
               (name.starts_with(ladder.name) && name.substr(ladder.name.size()).starts_with('_'));
    });
}

class Renamer {
public:
    Renamer(Texts& texts, const Named& named) : texts_(texts), named_(named) {
        if (named.what == What::global || named.what == What::uniform) {
            linked_ = linked(texts, named);
            for (const ShaderUse& use : linked_.stages)
                for (const FileId file : texts.files(use)) files_.insert(file);
            if (named.what == What::global) files_.insert(named.span.file);
        }
    }

    // Why what is at the place can't be renamed at all.
    std::string refused() {
        switch (named_.what) {
            case What::local:
                return refused_local();
            case What::global:
            case What::uniform:
                return refused_global();
            case What::language:
                return fmt::format("'{}' is a word of the language", named_.name);
            case What::member:
                return "members are not renamed: other structures may have members of this name";
            case What::ladder:
                return "ladders are not renamed: their macros are parts of other names";
            default:
                return "there is no name here that can be renamed";
        }
    }

    std::string refused(std::string_view name) {
        if (std::string why = unusable(name); !why.empty()) return why;
        if (of_ladder(texts_.project.scene(), name)) return fmt::format("'{}' is a macro of a ladder", name);
        if (named_.what == What::local) return taken_in_function(name);
        if (!linked_.programs.empty() && find_command(name) != nullptr)
            return fmt::format("'{}' is a command: at the start of a line it would be read as one", name);
        // What the other stages call so could become linked with it.
        for (const FileId file : texts_of_programs())
            if (has_word(texts_.outline(file), name, 0, ~std::uint32_t{0}))
                return fmt::format("'{}' is already in {}", name, texts_.project.sources.name(file));
        for (const Index program : programs())
            if (program < scene().programs.size() &&
                ranges::any_of(scene().programs[program].uniforms,
                               [&](const UniformValue& value) { return base_name(value.name) == name; }))
                return fmt::format("program '{}' already has a uniform '{}'", scene().programs[program].name, name);
        return {};
    }

private:
    const Scene& scene() const { return texts_.project.scene(); }

    std::set<Index> programs() const {
        std::set<Index> all(linked_.programs.begin(), linked_.programs.end());
        for (const ShaderUse& use : linked_.stages) all.insert(use.program);
        if (named_.what == What::uniform) all.insert(named_.program);
        return all;
    }

    std::set<FileId> texts_of_programs() const {
        std::set<FileId> all = files_;
        for (const Index program : programs())
            for (const Shader& shader : texts_.project.shaders)
                if (ranges::any_of(shader.uses, [&](const ShaderUse& use) { return use.program == program; }))
                    all.insert(shader.file);
        return all;
    }

    std::string short_name(FileId file) const {
        return std::filesystem::path(texts_.project.sources.name(file)).filename().string();
    }
    std::string split(FileId file) const {
        return fmt::format("a name in {} goes on in the next line, behind a '\\'", short_name(file));
    }

    static bool has_word(const Outline& outline, std::string_view name, std::uint32_t begin, std::uint32_t end) {
        return ranges::any_of(outline.tokens, [&](const ShaderToken& token) {
            return token.kind == glsl::Kind::identifier && token.role != ShaderToken::Role::member &&
                   (token.in_directive || (token.begin >= begin && token.end <= end)) && outline.word(token) == name;
        });
    }

    std::string refused_local() {
        const Outline& outline = texts_.outline(named_.span.file);
        if (outline.splits) return split(named_.span.file);
        for (const std::uint32_t at : outline.uses(named_.name))
            if (outline.tokens[at].in_directive)
                return fmt::format("a macro names '{}', which may be this variable", named_.name);
        return not_ours(named_.span.file);
    }

    std::string refused_global() {
        if (set_by_snell(named_.name) && !has(Kind::function)) return fmt::format("snell sets '{}'", named_.name);
        if (named_.name == "main") return "every shader starts at 'main'";
        if (glsl::is_language_word(named_.name))
            return fmt::format("calls of '{}' may mean the function of GLSL", named_.name);
        for (const FileId file : texts_of_programs()) {
            const Outline& outline = texts_.outline(file);
            if (outline.splits) return split(file);
            if (outline.pastes) return fmt::format("a macro in {} joins names by '##'", short_name(file));
        }
        bool macro = false, other = false;
        for (const FileId file : files_) {
            const Outline& outline = texts_.outline(file);
            if (outline.uses(named_.name).empty()) continue;
            if (std::string why = not_ours(file); !why.empty()) return why;
            for (const std::uint32_t at : outline.uses(named_.name)) {
                if (!outline.tokens[at].declares) continue;
                const bool is_macro = outline.declaration(outline.tokens[at]).kind == Kind::macro;
                (is_macro ? macro : other) = true;
            }
        }
        if (macro && other) return fmt::format("'{}' is a macro and a variable", named_.name);
        if (!macro && !other && named_.what == What::global && linked_.programs.empty())
            return fmt::format("'{}' is not declared", named_.name);
        for (const ShaderUse& use : linked_.stages)
            for (const DeclaredPlace& place : declarations(texts_, use, named_.name))
                if (use.stage == Stage::vertex && place.declaration->kind == Kind::input)
                    return "snell tells by its name what a vertex input is";
        if (has(Kind::block)) return "blocks are not renamed";
        return {};
    }

    bool has(Kind kind) {
        return ranges::any_of(files_, [&](FileId file) {
            const Outline& outline = texts_.outline(file);
            return ranges::any_of(outline.uses(named_.name), [&](std::uint32_t at) {
                return outline.tokens[at].declares && outline.declaration(outline.tokens[at]).kind == kind;
            });
        });
    }

    std::string not_ours(FileId file) const {
        if (!texts_.project.path_of(file).empty()) return {};
        return fmt::format("'{}' belongs to {}, which is snell's", named_.name, texts_.project.sources.name(file));
    }

    // Locals of other functions may have the name.
    std::string taken_in_function(std::string_view name) {
        const Outline& outline = texts_.outline(named_.span.file);
        std::uint32_t begin = 0, end = ~std::uint32_t{0};
        for (const ShaderDeclaration& d : outline.declarations)
            if (d.kind == Kind::function && d.begin <= named_.span.begin && named_.span.end <= d.end && d.body)
                begin = d.begin, end = d.end;
        if (has_word(outline, name, begin, end)) return fmt::format("'{}' is already in this function", name);
        for (const DeclaredPlace& place : declarations(texts_, named_.span.file, name))
            if (place.declaration->kind == Kind::macro) return fmt::format("'{}' is a macro", name);
        return {};
    }

    Texts& texts_;
    const Named& named_;
    Linked linked_;
    std::set<FileId> files_;
};

}  // namespace

Renaming renaming(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    const Named named = named_at(texts, file, offset);
    Renaming result;
    if (named.what != What::nothing) result.span = named.span, result.name = named.name;
    result.refused = Renamer(texts, named).refused();
    return result;
}

Rename rename(const Project& project, FileId file, std::uint32_t offset, std::string_view name) {
    Texts texts(project);
    const Named named = named_at(texts, file, offset);
    Renamer renamer(texts, named);
    Rename result;
    result.refused = renamer.refused();
    if (!result.refused.empty() || name == named.name) return result;
    result.refused = renamer.refused(name);
    if (!result.refused.empty()) return result;
    for (const Place& place : places(texts, named)) result.edits.push_back({place.span, std::string(name)});
    return result;
}

std::vector<Span> references(const Project& project, FileId file, std::uint32_t offset, bool declared) {
    Texts texts(project);
    std::vector<Span> found;
    for (const Place& place : places(texts, named_at(texts, file, offset)))
        if (declared || !place.declares) found.push_back(place.span);
    return found;
}

}  // namespace snell::language
