// A look at the user's shader that is good enough for hints: words, declarations, braces.
#include <algorithm>
#include <unordered_map>

#include "parser/text/ranges.h"
#include "src/glsl/log/log.h"
#include "src/glsl/read/lexer.h"

namespace snell::glsl::log {
namespace {

bool one_of(std::string_view word, std::initializer_list<std::string_view> list) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_qualifier(std::string_view word) {
    return one_of(word, {"uniform", "in", "out", "inout", "varying", "attribute", "const", "buffer"});
}

// Words that stand where a type or a name might, and are neither.
bool is_keyword(std::string_view word) {
    return is_qualifier(word) ||
           one_of(word, {"return",    "else",      "do",       "case",          "if",      "for",   "while",   "switch",
                         "flat",      "smooth",    "centroid", "noperspective", "patch",   "highp", "mediump", "lowp",
                         "precision", "invariant", "layout",   "struct",        "discard", "break", "continue"});
}

// Collects declarations: a name after a type, further names after commas, macros.
class Declarations {
public:
    Declarations(std::string_view text, const std::vector<Word>& words) : text_(text), words_(words) {}

    std::vector<Declared> run() {
        for (std::size_t i = 0; i < words_.size(); ++i) step(i);
        count_uses();
        return std::move(found_);
    }

private:
    std::string_view word(std::size_t i) const {
        return i < words_.size() ? text_of(text_, words_[i]) : std::string_view();
    }

    void step(std::size_t i) {
        const std::string_view w = word(i);
        if (words_[i].directive) {
            if (w == "define" && i + 1 < words_.size()) add(i + 1, "");
            return;
        }
        if (w == "{") ++depth_;
        if (w == "}") --depth_;
        if (w == "(") ++parens_;
        if (w == ")") --parens_;
        if (one_of(w, {";", "{", "}", "(", ")"}) || (w == "," && parens_ > list_parens_)) {
            qualifier_ = {};
            type_ = {};
        }
        if (is_qualifier(w)) qualifier_ = w;
        if (i + 1 >= words_.size() || !words_[i + 1].name || words_[i + 1].directive || is_keyword(word(i + 1))) return;
        if (words_[i].name && !is_keyword(w) && (i == 0 || word(i - 1) != ".")) {
            type_ = w;
            list_parens_ = parens_;
            add(i + 1, word(i + 2));
        } else if (w == "," && !type_.empty() && parens_ == list_parens_ && one_of(word(i + 2), {",", ";", "=", "["})) {
            add(i + 1, "");
        }
    }

    void add(std::size_t i, std::string_view next) {
        const Word& w = words_[i];
        found_.push_back({.name = text_of(text_, w),
                          .qualifier = qualifier_,
                          .type = type_,
                          .begin = w.begin,
                          .end = w.end,
                          .line = w.line,
                          .depth = depth_ + (parens_ > 0 ? 1 : 0),
                          .function = next == "("});
    }

    void count_uses() {
        std::unordered_map<std::string_view, int> counts;
        for (const Word& w : words_)
            if (w.name) ++counts[text_of(text_, w)];
        for (Declared& d : found_) d.uses = counts[d.name] - 1;
    }

    std::string_view text_;
    const std::vector<Word>& words_;
    std::vector<Declared> found_;
    std::string_view qualifier_, type_;
    int depth_ = 0, parens_ = 0, list_parens_ = 0;
};

int indentation(std::string_view text, std::size_t offset) {
    const std::size_t end = text.find_last_of("\r\n", offset);
    std::size_t at = end == std::string_view::npos || offset == 0 ? 0 : end + 1;
    int columns = 0;
    for (; at < text.size() && (text[at] == ' ' || text[at] == '\t'); ++at)
        columns = text[at] == '\t' ? (columns / 4 + 1) * 4 : columns + 1;
    return columns;
}

}  // namespace

std::vector<Word> words(std::string_view original) {
    const Cleaned cleaned = clean(original);
    const std::string_view text = cleaned.text;
    std::vector<Word> words;
    std::size_t at = 0, directive_until = 0;
    int line = 1;
    bool line_start = true;
    while (true) {
        const std::size_t from = at;
        const Trivia trivia = skip_trivia(text, at);
        at = trivia.end;
        line_start = line_start || trivia.line_end;
        line += static_cast<int>(ranges::count(text.substr(from, at - from), '\n'));
        if (at >= text.size()) return words;
        if (line_start && text[at] == '#') directive_until = directive_end(text, at);
        line_start = false;
        const Lexeme lexeme = lex(text, at);
        const std::size_t end = at + (lexeme.kind == glsl::Kind::punct ? 1 : lexeme.text.size());
        words.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end), line,
                         lexeme.kind == glsl::Kind::identifier, at < directive_until});
        at = end;
    }
}

std::vector<Declared> declared(std::string_view text, const std::vector<Word>& words) {
    return Declarations(text, words).run();
}

Texts::View& Texts::view(FileId file) {
    const auto [it, is_new] = views_.try_emplace(file);
    if (is_new) it->second.words = log::words(sources_.text(file));
    return it->second;
}

const std::vector<Word>& Texts::words(FileId file) { return view(file).words; }

std::span<const Word> Texts::on_line(FileId file, int line) {
    const std::vector<Word>& all = words(file);
    const auto before = [line](const Word& w) { return w.line < line; };
    const auto not_after = [line](const Word& w) { return w.line <= line; };
    const auto first = std::partition_point(all.begin(), all.end(), before);
    const auto last = std::partition_point(first, all.end(), not_after);
    return {all.data() + (first - all.begin()), static_cast<std::size_t>(last - first)};
}

const std::vector<Declared>& Texts::declared(FileId file) {
    View& v = view(file);
    if (!v.declared) v.declared = log::declared(sources_.text(file), v.words);
    return *v.declared;
}

std::size_t unclosed_brace(std::string_view text) {
    std::vector<std::size_t> open;
    std::size_t suspect = std::string_view::npos;
    int last_line = 0;
    for (const Word& w : words(text)) {
        const bool first_of_line = w.line != last_line;
        last_line = w.line;
        if (w.directive) continue;
        const std::string_view t = text_of(text, w);
        if (t == "{") open.push_back(w.begin);
        if (t != "}" || open.empty()) continue;
        // A brace that closes a block indented deeper than itself was meant for an outer block.
        const bool meant_for_outer = first_of_line && indentation(text, w.begin) < indentation(text, open.back());
        if (meant_for_outer && suspect == std::string_view::npos) suspect = open.back();
        open.pop_back();
    }
    if (open.empty()) return std::string_view::npos;
    return suspect == std::string_view::npos ? open.back() : suspect;
}

std::size_t unclosed_parenthesis(std::string_view text) {
    std::vector<std::size_t> open;
    for (const Word& w : words(text)) {
        const std::string_view t = text_of(text, w);
        if (w.directive) continue;
        if (t == "(") open.push_back(w.begin);
        if (t == ")" && !open.empty()) open.pop_back();
        if ((t == "{" || t == "}") && !open.empty()) return open.back();
    }
    return open.empty() ? std::string_view::npos : open.back();
}

}  // namespace snell::glsl::log
