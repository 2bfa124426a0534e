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

constexpr int deepest = 100;  // a tree

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

}  // namespace

Tree expression(const Unit& unit, int first) {
    for (auto n = static_cast<int>(unit.tree->size()) - 1; n >= 0; --n) {
        const glsl::Node& node = (*unit.tree)[static_cast<std::size_t>(n)];
        const bool found = node.first == first && node.form < glsl::Form::declarator;
        if (found && node.form != glsl::Form::comma) return tree_of(unit, n);
    }
    return {};
}

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

// The pieces of one body.
class BodyReader {
public:
    BodyReader(const Unit& unit, const glsl::Function& function) : u_(unit) {
        body_.function = &function;
        for (const int part : glsl::parts(*unit.tree, function.block)) statement(part);
        find_certain();
    }
    Body take() { return std::move(body_); }

private:
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

    void add(Piece::Kind kind, int first, int last, const std::vector<int>& value) {
        body_.pieces.push_back({.kind = kind,
                                .first = first,
                                .last = last,
                                .value = value.size() == 1 ? tree_of(u_, value.front()) : Tree{},
                                .depth = depth_,
                                .loops = around_});
    }

    void statement(int node) {
        using glsl::Form;
        const glsl::Node& n = (*u_.tree)[static_cast<std::size_t>(node)];
        const std::vector<int> inside = glsl::parts(*u_.tree, node);
        switch (n.form) {
            case Form::block: {
                const int deeper = n.last >= n.first && u_.at(n.first).text == "{" ? 1 : 0;
                depth_ += deeper;
                for (const int part : inside) statement(part);
                depth_ -= deeper;
                break;
            }
            case Form::branch:
            case Form::choice:
                add(Piece::Kind::condition, n.first, last_of(inside.front()) + 1, {inside.front()});
                for (std::size_t i = 1; i < inside.size(); ++i) statement(inside[i]);
                break;
            case Form::loop:
                loop(n, inside);
                break;
            case Form::returned:
                add(Piece::Kind::result, n.first, n.last, inside);
                break;
            case Form::evaluated:
                add(Piece::Kind::expression, n.first, n.last, inside);
                break;
            case Form::declaration:
                declaration(n, inside);
                break;
            default:
                break;
        }
    }
    int last_of(int node) const { return (*u_.tree)[static_cast<std::size_t>(node)].last; }

    void declaration(const glsl::Node& n, const std::vector<int>& declarators) {
        int type = n.first;
        for (; type < n.last && glsl::is_qualifier(u_.at(type).text); ++type)
            if (u_.at(type).text == "layout")
                while (type < n.last && u_.at(type).text != ")") ++type;
        if (u_.at(type).text == "struct") return;
        for (const int node : declarators) {
            const glsl::Node& one = (*u_.tree)[static_cast<std::size_t>(node)];
            const bool array = u_.at(one.first + 1).text == "[", begins = !array && last_of(node) > one.first;
            add(Piece::Kind::declaration, n.first, n.last, begins ? glsl::parts(*u_.tree, node) : std::vector<int>{});
            Piece& piece = body_.pieces.back();
            piece.type = array ? std::string_view() : u_.at(type).text;
            piece.name = one.text;
            piece.name_token = one.first;
            piece.whole = declarators.size() == 1;
        }
    }

    void loop(const glsl::Node& n, const std::vector<int>& inside) {
        const bool first = n.text == "do", counted = n.text == "for";
        if (inside.size() != (counted ? 4 : 2)) return;  // not understood
        const int header = inside[first ? 1 : counted ? 2 : 0], body = inside[first ? 0 : inside.size() - 1];
        const int close = last_of(header) + 1;
        const int open = counted ? n.first + 1 : (*u_.tree)[static_cast<std::size_t>(header)].first - 1;
        around_.push_back(static_cast<int>(body_.loops.size()));
        body_.loops.push_back({n.first, open, close});
        statement(body);
        around_.pop_back();
    }

    const Unit& u_;
    int depth_ = 0;
    std::vector<int> around_;  // loops
    Body body_;
};

}  // namespace

std::vector<Body> bodies(const Unit& unit) {
    std::vector<Body> all;
    for (const glsl::Function& function : unit.functions)
        if (function.block >= 0) all.push_back(BodyReader(unit, function).take());
    return all;
}

}  // namespace snell::accuracy::texts
