// Structures that are declared inside structures, which GLSL 1.10 has and later versions have not.
#include <algorithm>

#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

// The declaration `struct NAME { … }` that starts at a token; NAME may be missing.
struct Declared {
    int first = -1, name = -1, close = -1;
};

Declared declared_at(const Unit& u, int i) {
    Declared d{i, -1, -1};
    int k = i + 1;
    if (u.at(k).kind == Kind::identifier) d.name = k++;
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
    const std::string_view name =
        inner.name >= 0 ? u.at(inner.name).text : u.keep("snell_struct" + std::to_string(u.arena.size()));
    const Token& like = u.at(inner.first);
    if (inner.name < 0) moved.insert(moved.begin() + 1, made(like, name, Kind::identifier));
    moved.push_back(made(like, ";", Kind::punct));
    Token use = made(like, name, Kind::identifier);
    use.lead = u.keep(std::move(leads));
    u.tokens.erase(at(inner.first), at(inner.close + 1));
    u.tokens.insert(at(inner.first), use);
    std::swap(moved.front().lead, u.tokens[static_cast<std::size_t>(before)].lead);
    u.tokens.insert(at(before), moved.begin(), moved.end());
}

}  // namespace

void lift_structures(Unit& u) {
    constexpr int most = 64;  // far beyond any shader; each moves what stands behind it
    int lifted = 0;
    for (int i = 0; i + 1 < static_cast<int>(u.tokens.size()) && lifted < most; ++i) {
        if (u.at(i).text != "struct") continue;
        const Declared outer = declared_at(u, i);
        if (outer.close < 0) {
            if (u.at(outer.name >= 0 ? i + 2 : i + 1).text == "{") return;  // never closed
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

}  // namespace snell::glsl
