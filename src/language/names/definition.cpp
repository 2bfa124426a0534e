// Where a name comes from.
#include "parser/text/ranges.h"
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

}  // namespace snell::language
