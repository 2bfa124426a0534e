#include "src/language/offers/offers.h"

#include <algorithm>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/glsl.h"
#include "src/glsl/read/macro.h"
#include "src/glsl/read/words.h"
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
    const std::vector<glsl::MacroToken> t = glsl::macro_tokens(text);
    for (std::size_t i = 3; i + 2 < t.size(); i += 3)
        found.push_back({std::string(t[i + 1].text), std::string(t[i].text)});
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

namespace {

using Kind = ShaderDeclaration::Kind;

std::string_view content(std::string_view comment) {
    if (comment.starts_with("/*")) {
        comment.remove_prefix(2);
        if (comment.ends_with("*/")) comment.remove_suffix(2);
    } else {
        while (comment.starts_with('/')) comment.remove_prefix(1);
    }
    return trimmed(comment);
}

// What is written behind `name =`.
std::string_view initialiser(const Outline& outline, std::uint32_t token) {
    const auto word = [&](std::size_t i) {
        return i < outline.tokens.size() ? outline.word(outline.tokens[i]) : std::string_view();
    };
    std::size_t i = token + 1;
    if (word(i) != "=") return {};
    const std::uint32_t begin = outline.tokens[i].end;
    std::uint32_t end = begin;
    int depth = 0;
    for (++i; i < outline.tokens.size(); ++i) {
        const std::string_view text = word(i);
        if (depth == 0 && (text == "," || text == ";")) break;
        depth += text == "(" || text == "{" ? 1 : text == ")" || text == "}" ? -1 : 0;
        end = outline.tokens[i].end;
    }
    return trimmed(outline.text.substr(begin, end - begin));
}

}  // namespace

std::string comment_of(const Outline& outline, std::uint32_t begin, std::uint32_t end) {
    const std::string_view text = outline.text;
    const auto lines_between = [&](std::uint32_t from, std::uint32_t to) {
        return std::count(text.begin() + from, text.begin() + std::max(from, to), '\n');
    };
    const auto next = std::lower_bound(outline.comments.begin(), outline.comments.end(), end,
                                       [](const Span& comment, std::uint32_t at) { return comment.begin < at; });
    const auto written = [&](const Span& comment) {
        return content(text.substr(comment.begin, comment.end - comment.begin));
    };
    if (next != outline.comments.end() && lines_between(end, next->begin) == 0) return std::string(written(*next));
    std::string above;
    std::uint32_t from = begin;
    for (auto it = next; it != outline.comments.begin();) {
        --it;
        if (it->end > begin) continue;
        const std::string_view gap = text.substr(it->end, from - it->end);
        if (gap.find_first_not_of(" \t\r\n") != std::string_view::npos || lines_between(it->end, from) > 1) break;
        const std::size_t line = text.rfind('\n', it->begin);
        const std::size_t start = line == std::string_view::npos ? 0 : line + 1;
        if (!trimmed(text.substr(start, it->begin - start)).empty()) break;  // it belongs to the line above
        above = std::string(written(*it)) + (above.empty() ? "" : "\n") + above;
        from = it->begin;
    }
    return above;
}

bool set_by_system(std::string_view name, std::string_view type) {
    if (name.starts_with("snell")) return true;
    static const std::vector<glsl::SystemName> names = glsl::system_names();
    return ranges::any_of(names, [&](const glsl::SystemName& s) { return s.name == name && s.type == type; });
}

std::vector<UniformFact> declared_uniforms(Texts& texts, Index program) {
    std::vector<UniformFact> found;
    std::vector<FileId> files;
    for (const Shader& shader : texts.project.shaders)
        if (ranges::any_of(shader.uses, [&](const ShaderUse& use) { return use.program == program; }))
            files.push_back(shader.file);
    for (const FileId file : files) {
        const Outline& outline = texts.outline(file);
        for (const ShaderDeclaration& d : outline.declarations) {
            if (d.kind != Kind::uniform || d.local || set_by_system(d.name, d.type)) continue;
            if (ranges::find(found, d.name, &UniformFact::name) != found.end()) continue;
            const std::uint32_t offset = outline.tokens[d.token].begin;
            found.push_back({d.name, d.type, file, offset, initialiser(outline, d.token),
                             comment_of(outline, d.begin, d.end), d.array});
        }
    }
    return found;
}

// What depends on whether the text is a scene or a shader.

namespace {

// Editors may ask about a text that is no longer as long.
std::uint32_t within(const Project& project, FileId file, std::uint32_t offset) {
    return std::min(offset, static_cast<std::uint32_t>(project.sources.text(file).size()));
}

}  // namespace

std::vector<Completion> completions(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    offset = within(project, file, offset);
    return texts.is_scene(file) ? scene_completions(texts, file, offset) : shader_completions(texts, file, offset);
}

std::optional<Hover> hover(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    offset = within(project, file, offset);
    return texts.is_scene(file) ? scene_hover(texts, file, offset) : shader_hover(texts, file, offset);
}

std::optional<SignatureHelp> signature_help(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    offset = within(project, file, offset);
    return texts.is_scene(file) ? scene_signature(texts, file, offset) : shader_signature(texts, file, offset);
}

}  // namespace snell::language
