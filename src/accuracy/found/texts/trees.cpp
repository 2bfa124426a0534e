// Expressions and statements of shaders, as far as changes need them: expressions are those of the translator's tree.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "parser/text/number.h"
#include "src/accuracy/found/texts/texts.h"
#include "src/glsl/read/tree.h"
#include "src/glsl/read/words.h"

namespace snell::accuracy::texts {

using glsl::Unit;

namespace {

constexpr int deepest = 100;  // a tree, and statements within one another

Tree::Kind kind_of(const Unit& unit, const glsl::Node& node) {
    using glsl::Form;
    using enum Tree::Kind;
    constexpr std::pair<Form, Tree::Kind> same_as[] = {
        {Form::name, name},     {Form::group, group}, {Form::select, select}, {Form::index, index},
        {Form::prefix, prefix}, {Form::infix, infix}, {Form::choose, choose}, {Form::assign, assign}};
    for (const auto& [form, kind] : same_as)
        if (node.form == form) return kind;
    const std::string_view first = unit.at(node.first).text;
    if (node.form == Form::number)  // also true and false
        return unit.at(node.first).kind == glsl::Kind::identifier ? name : number;
    if (node.form == Form::step) return first == node.text ? prefix : postfix;
    const bool calls = node.form == Form::construct || node.form == Form::call || node.form == Form::built_in;
    return calls && unit.at(node.first + 1).text == "(" ? call : other;  // not casts and arrays
}

// A tree with something in it that was not understood is not understood itself.
Tree tree_of(const Unit& unit, int node, int depth = 0) {
    const glsl::Node& n = (*unit.tree)[static_cast<std::size_t>(node)];
    if (n.first < 0 || n.last < n.first || depth > deepest) return {};
    Tree tree{kind_of(unit, n), n.first, n.last, n.text, {}};
    const bool written = tree.kind == Tree::Kind::call || tree.kind == Tree::Kind::number;
    if (written) tree.text = unit.at(n.first).text;
    for (const int part : glsl::parts(*unit.tree, node)) {
        tree.parts.push_back(tree_of(unit, part, depth + 1));
        if (tree.parts.back().kind == Tree::Kind::other) tree.kind = Tree::Kind::other;
    }
    return tree;
}

// By token: the outermost expression that begins there; -1: there is none.
std::vector<int> expressions(const Unit& unit) {
    std::vector<int> at(unit.tokens.size(), -1);
    for (std::size_t n = 0; n < unit.tree->size(); ++n) {
        const glsl::Node& node = (*unit.tree)[n];
        if (node.first >= 0 && node.form < glsl::Form::declarator && node.form != glsl::Form::comma)
            at[static_cast<std::size_t>(node.first)] = static_cast<int>(n);
    }
    return at;
}

Tree expression(const Unit& unit, const std::vector<int>& all, int first) {
    const int node = first >= 0 && first < static_cast<int>(all.size()) ? all[static_cast<std::size_t>(first)] : -1;
    return node < 0 ? Tree{} : tree_of(unit, node);
}

}  // namespace

Tree expression(const Unit& unit, int first) { return expression(unit, expressions(unit), first); }

const Tree& bare(const Tree& tree) {
    const Tree* inner = &tree;
    while (inner->kind == Tree::Kind::group) inner = &inner->parts.front();
    return *inner;
}

std::optional<double> number_of(const Tree& tree) {
    const Tree& t = bare(tree);
    if (t.is(Tree::Kind::prefix, "-")) {
        const auto value = number_of(t.parts.front());
        return value ? std::optional(-*value) : std::nullopt;
    }
    double value = 0;
    if (t.kind != Tree::Kind::number) return std::nullopt;
    read_real(t.text.data(), t.text.data() + t.text.size(), value);
    return value;
}

std::string numeral(double value, bool whole) {
    std::string text = whole ? fmt::format("{:.0f}", value) : fmt::format("{:.5g}", value);
    if (!whole && text.find_first_of(".e") == text.npos) text += ".";
    return text;
}

bool same(const Unit& unit, const Tree& a, const Tree& b) {
    const Tree &x = bare(a), &y = bare(b);
    if (x.last - x.first != y.last - y.first || x.first < 0) return false;
    for (int k = 0; k <= x.last - x.first; ++k)
        if (unit.at(x.first + k).text != unit.at(y.first + k).text) return false;
    return true;
}

namespace {

// Reads the pieces of one body, token by token; what it does not understand it leaves out.
class BodyReader {
public:
    // `expressions`: by token.
    BodyReader(const Unit& unit, const std::vector<int>& expressions, const glsl::Function& function)
        : u_(unit), expressions_(expressions), end_(function.close) {
        body_.function = &function;
        for (int k = function.open + 1; k < end_;) k = statement(k);
        for (Piece& piece : body_.pieces)
            for (std::size_t i = 0; i < body_.loops.size(); ++i)
                if (piece.first >= body_.loops[i].first && piece.last <= body_.loops[i].last)
                    piece.loops.push_back(static_cast<int>(i));
        find_certain();
    }
    Body take() { return std::move(body_); }

private:
    std::string_view text(int k) const { return k < end_ ? u_.at(k).text : std::string_view(); }

    void find_certain() {
        std::set<std::string_view> assigned;
        for (const Piece& piece : body_.pieces)
            for_each(piece.value, [&](const Tree& tree) {
                const bool changes = tree.kind == Tree::Kind::assign || tree.kind == Tree::Kind::postfix ||
                                     tree.is(Tree::Kind::prefix, "++") || tree.is(Tree::Kind::prefix, "--");
                if (changes) assigned.insert(u_.at(tree.parts[0].first).text);
            });
        for (std::size_t i = 0; i < body_.pieces.size(); ++i) {
            const Piece& piece = body_.pieces[i];
            if (piece.kind != Piece::Kind::declaration) continue;
            const bool known = piece.value.kind != Tree::Kind::other && !assigned.contains(piece.name);
            const auto [at, fresh] = body_.certain.emplace(piece.name, known ? static_cast<int>(i) : -1);
            if (!fresh) at->second = -1;
        }
    }

    int matching(int open) const {
        int depth = 0;
        for (int k = open; k < end_; ++k) {
            const std::string_view t = text(k);
            if (t == "(" || t == "[" || t == "{") ++depth;
            if (t == ")" || t == "]" || t == "}") --depth;
            if (depth <= 0) return k;
        }
        return end_;
    }
    int semicolon(int from) const {
        for (int k = from; k < end_; ++k) {
            if (text(k) == "(" || text(k) == "[" || text(k) == "{") k = matching(k);
            if (text(k) == ";") return k;
            if (text(k) == "}") return k;
        }
        return end_;
    }
    // The last token of the statement, with every `else`.
    int statement_end(int from) const {
        int last = text(from) == "{" ? matching(from) : end_;
        if (last == end_ &&
            (text(from) == "for" || text(from) == "while" || text(from) == "if" || text(from) == "switch"))
            last = from + 1 < end_ ? statement_end_of(matching(from + 1) + 1) : end_;
        else if (last == end_)
            last = semicolon(from);
        while (text(last + 1) == "else" && last + 2 < end_) last = statement_end_of(last + 2);
        return std::min(last, end_);
    }
    int statement_end_of(int from) const {
        if (from >= end_ || nesting_ > deepest) return end_;
        ++nesting_;
        const int last = statement_end(from);
        --nesting_;
        return last;
    }

    int add(Piece::Kind kind, int first, int last, int value) {
        body_.pieces.push_back({.kind = kind,
                                .first = first,
                                .last = last,
                                .value = expression(u_, expressions_, value),
                                .depth = depth_});
        return last + 1;
    }

    int statement(int k) {
        const std::string_view t = text(k);
        if (t == "{") return ++depth_, k + 1;
        if (t == "}") return --depth_, k + 1;
        if (t == ";" || t == "else" || t == "do") return k + 1;
        if ((t == "if" || t == "switch") && text(k + 1) == "(") {
            add(Piece::Kind::condition, k, matching(k + 1), k + 2);
            return matching(k + 1) + 1;
        }
        if ((t == "for" || t == "while") && text(k + 1) == "(") return loop(k);
        if (t == "case" || t == "default") {
            while (k < end_ && text(k) != ":") ++k;
            return k + 1;
        }
        const int last = semicolon(k);
        if (t == "return") return add(Piece::Kind::result, k, last, k + 1);
        if (t == "discard" || t == "break" || t == "continue") return last + 1;
        if (declares(k)) return declaration(k, last);
        add(Piece::Kind::expression, k, last, k);
        if (body_.pieces.back().value.last != last - 1) body_.pieces.back().value = {};
        return last + 1;
    }

    bool declares(int k) const {
        if (glsl::is_qualifier(text(k)) || text(k) == "struct") return true;
        if (u_.at(k).kind != glsl::Kind::identifier || k + 1 >= end_) return false;
        int next = k + 1;
        if (text(next) == "[") next = matching(next) + 1;
        return next < end_ && u_.at(next).kind == glsl::Kind::identifier && !glsl::is_statement_word(text(k));
    }

    int declaration(int k, int last) {
        const int first = k;
        while (k < last && glsl::is_qualifier(text(k))) {
            if (text(k) == "layout" && text(k + 1) == "(") k = matching(k + 1);
            ++k;
        }
        const std::string_view type = text(k++);
        if (type == "struct") return last + 1;
        if (text(k) == "[") k = matching(k) + 1;
        const std::size_t begin = body_.pieces.size();
        while (k < last && u_.at(k).kind == glsl::Kind::identifier) {
            Piece piece{Piece::Kind::declaration, first, last, type, text(k), k++};
            piece.depth = depth_;
            if (text(k) == "[") k = matching(k) + 1, piece.type = "";
            if (text(k) == "=") {
                piece.value = expression(u_, expressions_, k + 1);
                while (k < last && text(k) != ",")
                    k = text(k) == "(" || text(k) == "[" || text(k) == "{" ? matching(k) + 1 : k + 1;
            }
            body_.pieces.push_back(std::move(piece));
            if (text(k) != ",") break;
            ++k;
        }
        if (body_.pieces.size() > begin + 1)
            for (std::size_t i = begin; i < body_.pieces.size(); ++i) body_.pieces[i].whole = false;
        return last + 1;
    }

    int loop(int word) {
        Loop loop;
        loop.word = word;
        loop.open = word + 1;
        loop.close = matching(loop.open);
        loop.first = loop.close + 1;
        loop.last = loop.first < end_ ? statement_end(loop.first) : end_;
        const int body = loop.close + 1;
        body_.loops.push_back(std::move(loop));
        return body;
    }

    const Unit& u_;
    const std::vector<int>& expressions_;
    int end_, depth_ = 0;
    mutable int nesting_ = 0;
    Body body_;
};

}  // namespace

std::vector<Body> bodies(const Unit& unit) {
    std::vector<Body> all;
    const std::vector<int> known = expressions(unit);
    for (const glsl::Function& function : unit.functions)
        if (function.open >= 0 && function.close > function.open &&
            function.close < static_cast<int>(unit.tokens.size()))
            all.push_back(BodyReader(unit, known, function).take());
    return all;
}

}  // namespace snell::accuracy::texts
