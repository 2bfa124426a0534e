#include "src/language/offers/uniforms.h"

#include <algorithm>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/glsl.h"

namespace snell::language {

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

}  // namespace snell::language
