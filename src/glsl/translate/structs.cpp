// Structures without a name, and those that are declared inside structures, which GLSL 1.10 has and later versions have
// not.

#include "parser/text/ranges.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

// The declaration `struct NAME { … }` that starts at a token.
struct Declared {
    int first = -1, close = -1;
};

Declared declared_at(const Unit& u, int i) {
    Declared d{i, -1};
    int k = u.at(i + 1).kind == Kind::identifier ? i + 2 : i + 1;
    if (u.at(k).text != "{") return d;
    for (int open = 0; u.at(k).kind != Kind::end; ++k) {
        if (u.at(k).text == "{") ++open;
        if (u.at(k).text == "}" && --open == 0) {
            d.close = k;
            break;
        }
    }
    return d;
}

// The first token of the declaration around token i.
int start_of_declaration(const Unit& u, int i) {
    while (i > 0 && u.at(i - 1).text != ";" && u.at(i - 1).text != "{" && u.at(i - 1).text != "}") --i;
    return i;
}

Token made(const Token& like, std::string_view text, Kind kind) {
    Token t;
    t.kind = kind;
    t.file = like.file;
    t.offset = like.offset;
    t.text = text;
    t.lead = " ";
    return t;
}

// The tokens of a structure go ahead of the declaration `before`; its name stays, with all that led the tokens.
void lift(Unit& u, const Declared& inner, int before) {
    const auto at = [&](int i) { return u.tokens.begin() + i; };
    std::vector<Token> moved(at(inner.first), at(inner.close + 1));
    std::string leads;
    for (Token& t : moved) {
        leads += t.lead;
        t.lead = " ";
    }
    const Token& like = u.at(inner.first);
    moved.push_back(made(like, ";", Kind::punct));
    Token use = made(like, u.at(inner.first + 1).text, Kind::identifier);
    use.lead = u.keep(std::move(leads));
    u.tokens.erase(at(inner.first), at(inner.close + 1));
    u.tokens.insert(at(inner.first), use);
    std::swap(moved.front().lead, u.tokens[static_cast<std::size_t>(before)].lead);
    u.tokens.insert(at(before), moved.begin(), moved.end());
}

// A structure without a name gets one, by the variable behind it: its zero can be written then, and two stages that
// declare the same uniform name it alike.
void name_structures(Unit& u) {
    std::vector<Token> named;
    std::vector<std::size_t> open;  // of each open brace: the token of a name that is to be found; 0: none
    named.reserve(u.tokens.size());
    for (std::size_t i = 0; i < u.tokens.size(); ++i) {
        const Token& t = u.tokens[i];
        const bool nameless = t.text == "{" && i > 0 && u.tokens[i - 1].text == "struct";
        if (nameless) named.push_back(made(t, {}, Kind::identifier));
        if (t.text == "{") open.push_back(nameless ? named.size() - 1 : 0);
        named.push_back(t);
        if (t.text != "}" || open.empty()) continue;
        const std::size_t name = open.back();
        open.pop_back();
        if (name == 0) continue;
        const Token& next = u.tokens[i + 1];
        named[name].text = u.keep(
            "struct_of_" + (next.kind == Kind::identifier ? std::string(next.text) : std::to_string(named.size())));
    }
    for (const std::size_t name : open)  // never closed
        if (name > 0) named[name].text = "struct_of_nothing";
    if (named.size() > u.tokens.size()) u.tokens = std::move(named);
}

}  // namespace

void lift_structures(Unit& u) {
    name_structures(u);
    constexpr int most = 64;  // far beyond any shader; each moves what stands behind it
    int lifted = 0;
    for (int i = 0; i + 1 < static_cast<int>(u.tokens.size()) && lifted < most; ++i) {
        if (u.at(i).text != "struct") continue;
        const Declared outer = declared_at(u, i);
        if (outer.close < 0) {
            if (u.at(i + 1).kind == Kind::identifier && u.at(i + 2).text == "{") return;  // never closed
            continue;
        }
        int inner = i + 1;
        while (inner < outer.close && u.at(inner).text != "struct") ++inner;
        const Declared found = inner < outer.close ? declared_at(u, inner) : Declared{};
        if (found.close < 0) {
            i = outer.close;
            continue;
        }
        const int before = start_of_declaration(u, i);
        lift(u, found, before);
        ++lifted;
        i = before - 1;  // what was lifted may hold others
    }
}

// Drivers walk the syntax tree of a shader by recursion: a tree that is too deep ends the process.

namespace {

bool opens(std::string_view t) { return t == "(" || t == "[" || t == "{"; }
bool closes(std::string_view t) { return t == ")" || t == "]" || t == "}"; }

// What may have a tree of its own below it: operators, brackets, and statements that contain statements.
bool deepens(const Token& t) {
    constexpr std::string_view words[] = {"if", "else", "for", "while", "do", "switch"};
    if (t.kind == Kind::identifier) return ranges::find(words, t.text) != std::end(words);
    return t.kind == Kind::punct && t.text != ";" && t.text != "," && !closes(t.text);
}

}  // namespace

// The depth at a token is at most what deepens the tree since the last comma or semicolon of each open bracket. An
// `else` continues at its `if`.
void refuse_deep_nesting(const Program& program, const Unit& u) {
    struct Depth {
        std::uint64_t here = 0, at_if = 0;
    };
    const std::uint64_t most = program.options.limits.expression_depth;
    std::vector<Depth> brackets{{}};  // as they open
    Depth depth;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const std::string_view t = u.tokens[i].text;
        if (deepens(u.tokens[i]) && ++depth.here > most) {
            program.diagnostics.error(
                "too-deep", u.span(static_cast<int>(i)),
                "this expression or statement nests too deeply, or has too many operators",
                "use several statements; " + limit_help(program.options.limits, &Limits::expression_depth));
            return;
        }
        if (t == "if") depth.at_if = depth.here;
        if (opens(t)) brackets.push_back(depth);
        if (closes(t) && brackets.size() > 1) {
            depth = brackets.back();
            brackets.pop_back();
        }
        const bool ends = t == ";" || t == "}";
        if (t == "," || ends) depth.here = ends && u.tokens[i + 1].text == "else" ? depth.at_if : brackets.back().here;
    }
}

}  // namespace snell::glsl
