// Repairs of single words, before the parse.
#include <algorithm>
#include <set>

#include "src/glsl/program.h"
#include "src/glsl/words.h"

namespace snell::glsl {

namespace {

// Words of other languages that some compilers read past.
bool meaningless(std::string_view word) {
    return word == "static" || word == "inline" || word == "extern" || word == "public";
}

// A reserved word stands as a name: punctuation follows it, where a keyword would have another word behind it.
bool stands_as_name(const Unit& u, std::size_t i) {
    const Token& next = u.tokens[i + 1];
    const std::string_view word = u.tokens[i].text;
    if (word == "layout" || word == "precision" || word == "highp" || word == "mediump" || word == "lowp") return false;
    if (word == "subroutine") return next.text != "(" && next.kind == Kind::punct;
    if (next.kind != Kind::punct || next.text == "{") return false;
    const bool type_like =
        word.starts_with("hvec") || word.starts_with("fvec") || word == "atomic_uint" || word == "sampler3DRect";
    return !(type_like && next.text == "(");
}

void drop_meaningless(Program& program, Unit& u) {
    std::vector<Token> kept;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const Token& t = u.tokens[i];
        if (t.kind != Kind::identifier || !meaningless(t.text) || u.tokens[i + 1].kind != Kind::identifier) continue;
        program.warn(u, static_cast<int>(i), "meaningless-word",
                     "'" + std::string(t.text) + "' has no meaning in GLSL: left out");
        u.tokens[i + 1].lead = u.keep(std::string(t.lead) + std::string(u.tokens[i + 1].lead));
        u.tokens.erase(u.tokens.begin() + static_cast<std::ptrdiff_t>(i));
        --i;
    }
}

void mend_number(Program& program, Unit& u, int i) {
    const std::string_view t = u.at(i).text;
    const char last = t.back();
    if (u.at(i).kind != Kind::real) return;
    if (last == 'h' || last == 'd') {
        u.replace(i, t.substr(0, t.size() - 1));
    } else if ((last == 'f' || last == 'F') && t.find_first_of(".eE") == std::string_view::npos) {
        u.replace(i, std::string(t.substr(0, t.size() - 1)) + ".0");
        program.warn(u, i, "odd-number", "'" + std::string(t) + "' wants a point: read as " + std::string(u.now(i)));
    } else if ((t.ends_with("lf") || t.ends_with("LF")) && (program.target().es || !program.target().fp64)) {
        u.replace(i, t.substr(0, t.size() - 2));
    }
    u.tokens[static_cast<std::size_t>(i)].text = u.now(i);
    // The edits vector may grow: the token needs a text that stays.
    if (u.at(i).edit >= 0) u.tokens[static_cast<std::size_t>(i)].text = u.keep(std::string(u.now(i)));
}

void no_doubles(Program& program, Unit& u) {
    bool told = false;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const std::string_view t = u.tokens[i].text;
        if (u.tokens[i].kind != Kind::identifier || (t != "double" && !t.starts_with("dvec") && !t.starts_with("dmat")))
            continue;
        const auto type = builtin_type(t);
        if (!type) continue;
        if (!told) program.warn(u, static_cast<int>(i), "no-double", "double precision is not there: float is used");
        told = true;
        u.replace(static_cast<int>(i), type_name(Base::real, type->rows, type->cols));
        u.tokens[i].text = type_name(Base::real, type->rows, type->cols);
    }
}

}  // namespace

void mend_words(Program& program, Unit& u) {
    drop_meaningless(program, u);
    const Target& target = program.target();
    if (target.es || !target.fp64) no_doubles(program, u);
    std::set<std::string_view> renamed;
    int in_layout = 0;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const Token& t = u.tokens[i];
        if (t.kind == Kind::real) mend_number(program, u, static_cast<int>(i));
        if (t.kind == Kind::identifier && t.text == "layout") in_layout = 1;
        if (in_layout && t.text == ")") in_layout = 0;
        if (t.kind != Kind::identifier || in_layout || !is_reserved_word(t.text) || !stands_as_name(u, i)) continue;
        if (renamed.insert(t.text).second)
            program.warn(u, static_cast<int>(i), "reserved-word",
                         "'" + std::string(t.text) + "' is a word of the language: renamed");
        const std::string_view name = u.keep("snell_" + std::string(t.text));
        u.replace(static_cast<int>(i), name);
        u.tokens[i].text = name;
    }
    for (const std::string_view name : renamed) {
        const std::string shader_name = "snell_" + std::string(name);
        const bool known = std::any_of(program.renamed.begin(), program.renamed.end(),
                                       [&](const RenamedUniform& r) { return r.name == name; });
        if (!known) program.renamed.push_back({std::string(name), shader_name});
    }
}

}  // namespace snell::glsl
