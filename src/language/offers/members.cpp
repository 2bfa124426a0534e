#include "src/language/offers/members.h"

#include "src/glsl/read/legacy.h"
#include "src/glsl/read/words.h"
#include "src/language/names/links.h"
#include "src/language/shader/builtins.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using Role = ShaderToken::Role;

std::string element_of(std::string_view type) { return std::string(type.substr(0, type.find_first_of("[ ("))); }

// The member declarations of a structure or block; of all if `owner` is empty.
template <class Each>
void for_members(Texts& texts, FileId file, std::string_view owner, Each each) {
    for (const FileId one : texts.together(file))
        for (const ShaderDeclaration& d : texts.outline(one).declarations)
            if (d.kind == Kind::member && (owner.empty() || d.owner == owner)) each(d);
}

void add_vector(const glsl::Type& type, std::vector<MemberOffer>& found) {
    const std::string scalar(glsl::type_name(type.base, 1, 1));
    const std::string stem = scalar == "float" ? "vec" : scalar.substr(0, 1) + "vec";
    for (const std::string_view letters : {"xyzw", "rgba"})
        for (std::size_t n = 1; n <= type.rows; ++n) {
            found.push_back({std::string(letters.substr(n - 1, 1)), scalar, letters == "xyzw" ? 1 : 2});
            if (n > 1) found.push_back({std::string(letters.substr(0, n)), stem + std::to_string(n), 2});
        }
}

// "struct snell_FogParameters { vec4 color; float density; };"
void add_legacy(std::string_view text, std::vector<MemberOffer>& found) {
    std::size_t at = text.find('{');
    while (at != std::string_view::npos && at + 2 < text.size()) {
        const std::size_t type = text.find_first_not_of(" {;", at);
        const std::size_t blank = text.find(' ', type), end = text.find(';', type);
        if (type == std::string_view::npos || end == std::string_view::npos || blank > end || text[type] == '}') return;
        found.push_back(
            {std::string(text.substr(blank + 1, end - blank - 1)), std::string(text.substr(type, blank - type))});
        at = end;
    }
}

// The name whose member the token `point` selects: behind brackets, before them.
std::size_t name_before(const Outline& outline, std::size_t point) {
    int depth = 0;
    std::size_t i = point;
    while (i-- > 0) {
        const std::string_view word = outline.word(outline.tokens[i]);
        if (word == "]") ++depth;
        if (word == "[" && --depth == 0) continue;
        if (depth == 0) return i;
        if (word == ";" || word == "{") break;
    }
    return outline.tokens.size();
}

}  // namespace

std::string type_of_name(Texts& texts, FileId file, std::size_t token, Stage stage, int depth) {
    const Outline& outline = texts.outline(file);
    constexpr int most_members = 32;  // a.b.c…
    if (token >= outline.tokens.size() || depth > most_members) return {};
    const ShaderToken& name = outline.tokens[token];
    const std::string_view word = outline.word(name);
    if (name.role == Role::local) return element_of(outline.declaration(name).type);
    if (name.role == Role::member) {
        std::string type;
        const std::size_t whole = token >= 2 ? name_before(outline, token - 1) : outline.tokens.size();
        const std::string owner = type_of_name(texts, file, whole, stage, depth + 1);
        for_members(texts, file, owner, [&](const ShaderDeclaration& d) {
            if (d.name == word) type = element_of(d.type);
        });
        return type;
    }
    if (name.role != Role::global) return {};
    for (const DeclaredPlace& place : declarations(texts, file, word))
        if (place.declaration->kind != Kind::macro) return element_of(place.declaration->type);
    const VariableDoc* doc = variable_doc(stage, word);
    return doc == nullptr ? std::string() : element_of(doc->type);
}

std::vector<MemberOffer> members_before(Texts& texts, FileId file, std::size_t point, Stage stage) {
    std::vector<MemberOffer> found;
    const Outline& outline = texts.outline(file);
    const std::string type = type_of_name(texts, file, name_before(outline, point), stage);
    if (type.empty()) return found;
    if (const auto built_in = glsl::builtin_type(type)) {
        if (built_in->rows > 1 && built_in->cols == 1) add_vector(*built_in, found);
        return found;
    }
    if (type == "gl_PerVertex")
        return {{"gl_Position", "vec4"}, {"gl_PointSize", "float"}, {"gl_ClipDistance", "float[]"}};
    if (const std::string_view legacy = glsl::legacy_struct_text(type); !legacy.empty()) {
        add_legacy(legacy, found);
        return found;
    }
    for_members(texts, file, type, [&](const ShaderDeclaration& d) {
        found.push_back({std::string(d.name), std::string(d.type)});
    });
    return found;
}

}  // namespace snell::language
