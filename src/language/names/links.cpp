#include "src/language/names/links.h"

#include <algorithm>
#include <set>

#include "parser/text/ranges.h"
#include "src/plan/values/controls.h"

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

namespace {

using Kind = ShaderDeclaration::Kind;

bool crosses(Kind kind) { return kind == Kind::input || kind == Kind::output || kind == Kind::varying; }

// What the stage declares under the name.
struct InStage {
    bool declared = false, uniform = false, varying = false, used = false;
};

class Linker {
public:
    Linker(Texts& texts, std::string_view name) : texts_(texts), name_(name) {}

    void add_file(FileId file) {
        for (const ShaderUse& use : texts_.uses(file)) add_stage(use);
    }

    void add_stage(const ShaderUse& use) {
        if (ranges::find(found.stages, use) != found.stages.end()) return;
        found.stages.push_back(use);
        const InStage here = in_stage(use);
        for (const FileId file : texts_.files(use))
            if (!texts_.outline(file).uses(name_).empty()) add_file(file);
        if (here.uniform || !here.declared) add_program(use.program);
        if (here.varying) add_neighbours(use);
    }

    void add_program(Index program) {
        if (!sets(program) && !declares_uniform(program)) return;
        if (ranges::find(found.programs, program) != found.programs.end()) return;
        found.programs.push_back(program);
        for (const ShaderUse& use : stages_of(program)) {
            const InStage there = in_stage(use);
            if (there.uniform || (there.used && !there.declared)) add_stage(use);
        }
    }

    Linked found;

private:
    InStage in_stage(const ShaderUse& use) {
        InStage result;
        for (const FileId file : texts_.files(use)) {
            const Outline& outline = texts_.outline(file);
            for (const std::uint32_t at : outline.uses(name_)) {
                result.used = true;
                const ShaderToken& token = outline.tokens[at];
                if (!token.declares) continue;
                const Kind kind = outline.declaration(token).kind;
                result.declared = true;
                result.uniform = result.uniform || kind == Kind::uniform;
                // What a vertex shader takes, and a fragment shader gives, passes between no stages.
                const bool outer = (use.stage == Stage::vertex && kind == Kind::input) ||
                                   (use.stage == Stage::fragment && kind == Kind::output);
                result.varying = result.varying || (crosses(kind) && !outer);
            }
        }
        return result;
    }

    std::vector<ShaderUse> stages_of(Index program) const {
        std::vector<ShaderUse> all;
        for (const Shader& shader : texts_.project.shaders)
            for (const ShaderUse& use : shader.uses)
                if (use.program == program && ranges::find(all, use) == all.end()) all.push_back(use);
        return all;
    }

    void add_neighbours(const ShaderUse& use) {
        for (const ShaderUse& other : stages_of(use.program))
            if (in_stage(other).varying) add_stage(other);
    }

    bool sets(Index program) const {
        const auto& programs = texts_.project.scene().programs;
        return program < programs.size() && ranges::any_of(programs[program].uniforms, [&](const UniformValue& value) {
                   return base_name(value.name) == name_;
               });
    }
    bool declares_uniform(Index program) {
        return ranges::any_of(stages_of(program), [&](const ShaderUse& use) { return in_stage(use).uniform; });
    }

    Texts& texts_;
    std::string_view name_;
};

void add_scene_places(Texts& texts, std::string_view name, Index index, std::vector<Place>& found) {
    const auto& programs = texts.project.scene().programs;
    if (index >= programs.size()) return;
    const auto length = static_cast<std::uint32_t>(name.size());
    for (const UniformValue& value : programs[index].uniforms)
        if (base_name(value.name) == name) {
            const Span span = texts.first(value.name_span);
            found.push_back({{span.file, span.begin, span.begin + length}, false, true});
        }
    // A uniform that is given twice has two places, of which the scene keeps one.
    const Span span = texts.first(programs[index].span);
    const Statements& statements = texts.statements(span.file);
    const SceneStatement* statement = statements.at_statement(span.begin);
    if (statement == nullptr || statement->command == nullptr || statement->command->name != "Program") return;
    for (const WrittenUniform& one : written_uniforms(statements, *statement))
        if (one.name == name) found.push_back({one.name_span, false, true});
}

void tidy(std::vector<Place>& found) {
    ranges::stable_sort(found, [](const Place& a, const Place& b) {
        return std::tuple(a.span.file, a.span.begin) < std::tuple(b.span.file, b.span.begin);
    });
    found.erase(
        std::unique(found.begin(), found.end(), [](const Place& a, const Place& b) { return a.span == b.span; }),
        found.end());
}

void add_uses(Texts& texts, FileId file, std::string_view name, std::vector<Place>& found) {
    const Outline& outline = texts.outline(file);
    for (const std::uint32_t at : outline.uses(name))
        found.push_back({outline.span(outline.tokens[at]), outline.tokens[at].declares, false});
}

std::vector<Place> ladder_places(Texts& texts, const Named& named) {
    const Ladder& ladder = texts.project.scene().ladders[named.ladder];
    std::vector<Place> found{{texts.first(named.rung ? ladder.rung_spans[*named.rung] : ladder.name_span), true, true}};
    const std::string macro = named.rung ? ladder.name + "_" + ladder.rungs[*named.rung] : ladder.name;
    for (const Shader& shader : texts.project.shaders) add_uses(texts, shader.file, macro, found);
    return found;
}

std::vector<DeclaredPlace> declared_in(Texts& texts, const std::vector<FileId>& files, std::string_view name) {
    std::vector<DeclaredPlace> found;
    for (const FileId file : files) {
        const Outline& outline = texts.outline(file);
        for (const std::uint32_t at : outline.uses(name))
            if (outline.tokens[at].declares) found.push_back({file, &outline.declaration(outline.tokens[at])});
    }
    return found;
}

}  // namespace

Linked linked(Texts& texts, const Named& named) {
    Linker linker(texts, named.name);
    if (named.what == Named::What::global) linker.add_file(named.span.file);
    if (named.what == Named::What::uniform) linker.add_program(named.program);
    return std::move(linker.found);
}

std::vector<Place> places(Texts& texts, std::string_view name, const Linked& all) {
    std::vector<Place> found;
    std::set<FileId> files;
    for (const ShaderUse& use : all.stages)
        for (const FileId file : texts.files(use)) files.insert(file);
    for (const FileId file : files) add_uses(texts, file, name, found);
    for (const Index program : all.programs) add_scene_places(texts, name, program, found);
    tidy(found);
    return found;
}

std::vector<Place> places(Texts& texts, const Named& named) {
    std::vector<Place> found;
    if (named.what == Named::What::local) {
        const Outline& outline = texts.outline(named.span.file);
        for (const ShaderToken& token : outline.tokens)
            if (token.role == ShaderToken::Role::local && token.declaration == named.declaration)
                found.push_back({outline.span(token), token.declares, false});
    } else if (named.what == Named::What::ladder) {
        found = ladder_places(texts, named);
    } else if (named.what == Named::What::global || named.what == Named::What::uniform) {
        const Linked all = linked(texts, named);
        found = places(texts, named.name, all);
        if (all.stages.empty() && named.what == Named::What::global)  // a text that no program uses
            add_uses(texts, named.span.file, named.name, found);
        if (named.what == Named::What::uniform) found.push_back({named.span, false, true});
    }
    tidy(found);
    return found;
}

std::vector<DeclaredPlace> declarations(Texts& texts, const ShaderUse& use, std::string_view name) {
    return declared_in(texts, texts.files(use), name);
}

std::vector<DeclaredPlace> declarations(Texts& texts, FileId file, std::string_view name) {
    return declared_in(texts, texts.together(file), name);
}

Index program_at(Texts& texts, FileId file, std::uint32_t offset) {
    const Statements& statements = texts.statements(file);
    const SceneStatement* statement = statements.at_statement(offset);
    if (statement == nullptr) return none;
    const Span span = statements.span(*statement);
    const auto within = [&](Span place) {
        place = texts.first(place);
        return place.file == file && place.begin >= span.begin && place.begin < span.end;
    };
    const auto& programs = texts.project.scene().programs;
    for (Index i = 0; i < programs.size(); ++i)
        if (within(programs[i].span) || ranges::any_of(programs[i].uniforms, within, &UniformValue::name_span))
            return i;
    return none;
}

}  // namespace snell::language
