// Where a name comes from.
#include <algorithm>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/read/words.h"
#include "src/language/names/links.h"
#include "src/language/services.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using What = Named::What;

Span name_span(Texts& texts, const DeclaredPlace& place) { return texts.outline(place.file).span(*place.declaration); }

void add(std::vector<Span>& found, const Span& span) {
    if (ranges::find(found, span) == found.end()) found.push_back(span);
}

// A function is defined where its body is; a prototype only if there is no body.
std::vector<Span> best(Texts& texts, const std::vector<DeclaredPlace>& all) {
    std::vector<Span> found;
    for (const DeclaredPlace& place : all)
        if (place.declaration->kind == Kind::function && place.declaration->body) add(found, name_span(texts, place));
    if (found.empty())
        for (const DeclaredPlace& place : all) add(found, name_span(texts, place));
    return found;
}

// From a declaration, on to what gives it its value: the scene, or the stage before.
std::vector<Span> behind_declaration(Texts& texts, const Named& named) {
    std::vector<Span> found;
    const Linked all = linked(texts, named);
    for (const Place& place : places(texts, named.name, all))
        if (place.in_scene) add(found, place.span);
    if (found.empty())
        for (const ShaderUse& use : all.stages)
            for (const DeclaredPlace& place : declarations(texts, use, named.name))
                if (place.declaration->kind == Kind::output || place.declaration->kind == Kind::varying)
                    add(found, name_span(texts, place));
    return found;
}

std::vector<Span> of_global(Texts& texts, const Named& named) {
    std::vector<Span> found = best(texts, declarations(texts, named.span.file, named.name));
    if (ranges::find(found, named.span) != found.end()) {
        std::vector<Span> further = behind_declaration(texts, named);
        std::erase(further, named.span);
        if (!further.empty()) return further;
    }
    return found;
}

std::vector<Span> of_member(Texts& texts, const Named& named) {
    std::vector<Span> found;
    for (const FileId file : texts.together(named.span.file)) {
        const Outline& outline = texts.outline(file);
        for (const ShaderDeclaration& d : outline.declarations)
            if (d.kind == Kind::member && d.name == named.name) add(found, outline.span(d));
    }
    return found;
}

}  // namespace

std::vector<Span> definition(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    const Named named = named_at(texts, file, offset);
    std::vector<Span> found;
    switch (named.what) {
        case What::local: {
            const Outline& outline = texts.outline(file);
            found.push_back(outline.span(outline.declarations[static_cast<std::size_t>(named.declaration)]));
            break;
        }
        case What::global:
            return of_global(texts, named);
        case What::member:
            return of_member(texts, named);
        case What::uniform:
            for (const Place& place : places(texts, named))
                if (place.declares && !place.in_scene) found.push_back(place.span);
            break;
        case What::ladder: {
            const Ladder& ladder = project.scene().ladders[named.ladder];
            found.push_back(texts.first(named.rung ? ladder.rung_spans[*named.rung] : ladder.name_span));
            break;
        }
        case What::file:
            if (const auto source = named_file(texts, named)) found.push_back({*source, 0, 0});
            break;
        default:
            break;
    }
    return found;
}

// What is written at a place of a scene or a shader.

namespace {

using Role = ShaderToken::Role;

bool holds(const Span& span, FileId file, std::uint32_t offset) {
    return span.file == file && span.begin <= offset && offset <= span.end && span.end > span.begin;
}

// The ladder, or the rung, that a macro of a shader tells.
bool ladder_named(const Scene& scene, std::string_view name, Named& named) {
    for (Index i = 0; i < scene.ladders.size(); ++i) {
        const Ladder& ladder = scene.ladders[i];
        if (!name.starts_with(ladder.name)) continue;
        const std::string_view rest = name.substr(ladder.name.size());
        const auto rung = ranges::find(ladder.rungs, rest.substr(rest.empty() ? 0 : 1));
        const bool is_rung = rest.starts_with('_') && rung != ladder.rungs.end();
        if (!rest.empty() && rest != "_VALUE" && !is_rung) continue;
        named.what = What::ladder;
        named.ladder = i;
        if (is_rung) named.rung = static_cast<std::size_t>(rung - ladder.rungs.begin());
        return true;
    }
    return false;
}

Named in_shader(Texts& texts, FileId file, std::uint32_t offset) {
    const Outline& outline = texts.outline(file);
    Named named;
    const ShaderDirective* directive = outline.directive_at(offset);
    if (directive != nullptr && holds({file, directive->name_begin, directive->name_end}, file, offset)) {
        named.what = What::file;
        named.span = {file, directive->name_begin, directive->name_end};
        named.name = outline.text.substr(directive->name_begin, directive->name_end - directive->name_begin);
        return named;
    }
    const ShaderToken* token = outline.at(offset);
    if (token == nullptr || token->kind != glsl::Kind::identifier) return named;
    named.span = outline.span(*token);
    named.name = outline.word(*token);
    named.declaration = token->declaration;
    switch (token->role) {
        case Role::local:
            named.what = What::local;
            break;
        case Role::member:
            named.what = What::member;
            break;
        case Role::global:
            named.what = What::global;
            if (declarations(texts, file, named.name).empty() &&
                !ladder_named(texts.project.scene(), named.name, named) && glsl::is_language_word(named.name))
                named.what = What::language;
            break;
        default:
            named.what = What::language;
    }
    return named;
}

Named in_scene(Texts& texts, FileId file, std::uint32_t offset) {
    const Statements& statements = texts.statements(file);
    Named named;
    const Token* token = statements.at(offset);
    const SceneStatement* statement = statements.at_statement(offset);
    if (token == nullptr || statement == nullptr || statements.in_comment(offset)) return named;
    named.span = statements.span(*token);
    named.name = statements.word(*token);
    for (const WrittenUniform& one : written_uniforms(statements, *statement)) {
        if (!holds(one.name_span, file, offset)) continue;
        named.program = program_at(texts, file, one.name_span.begin);
        const bool taken = statement->command == nullptr || statement->command->takes(ArgumentKind::uniforms);
        if (!taken || named.program == none) break;
        named.what = What::uniform;
        named.span = one.name_span;
        named.name = one.name;
        return named;
    }
    const auto& ladders = texts.project.scene().ladders;
    for (Index i = 0; i < ladders.size(); ++i) {
        const auto here = [&](const Span& span) { return holds(texts.first(span), file, offset); };
        const auto& rungs = ladders[i].rung_spans;
        const auto rung = ranges::find_if(rungs, here);
        if (rung == rungs.end() && !here(ladders[i].name_span)) continue;
        named.what = What::ladder;
        named.ladder = i;
        if (rung != rungs.end()) named.rung = static_cast<std::size_t>(rung - rungs.begin());
        return named;
    }
    const auto index = static_cast<std::size_t>(token - statements.tokens_of(*statement).data());
    if (index == 0) {
        named.what = statement->command != nullptr ? What::language : What::nothing;
        return named;
    }
    const ArgumentPlace place = argument_at(statements, *statement, index);
    if (place.parameter == nullptr || place.parameter->kind != ArgumentKind::path) return named;
    named.what = What::file;
    if (token->kind == TokenKind::text) named.name = without_quotes(named.name, !token->unclosed);
    return named;
}

}  // namespace

Named named_at(Texts& texts, FileId file, std::uint32_t offset) {
    offset = std::min(offset, static_cast<std::uint32_t>(texts.project.sources.text(file).size()));
    return texts.is_scene(file) ? in_scene(texts, file, offset) : in_shader(texts, file, offset);
}

std::optional<FileId> named_file(Texts& texts, const Named& named) {
    const Project& project = texts.project;
    for (const PlannedProgram& program : project.plan.programs)
        for (const glsl::StageInput& stage : program.stages)
            if (texts.first(stage.reference) == named.span) return texts.first(stage.file);
    if (project.files == nullptr) return std::nullopt;
    std::string name = named.name;
    for (char& c : name)
        if (c == '\\') c = '/';
    if (ranges::any_of(project.shaders,
                       [&](const Shader& s) { return s.path.empty() && project.sources.name(s.file) == name; }))
        return std::nullopt;
    const Resolved found =
        project.files->resolve_beside(project.path_of(named.span.file), name, {"glib", "inc", "glsl"});
    if (found.path.empty()) return std::nullopt;
    return project.file_of(found.path);
}

}  // namespace snell::language
