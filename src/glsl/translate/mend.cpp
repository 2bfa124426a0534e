// Repairs of single words, before the parse.
#include <map>
#include <set>

#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

struct Place {
    const Unit* unit = nullptr;
    int token = 0;
};

// Some compilers ignore these words of other languages.
bool meaningless(std::string_view word) {
    return word == "static" || word == "inline" || word == "extern" || word == "public";
}

// A reserved word stands as a name: punctuation follows it, where a keyword would have another word behind it.
bool stands_as_name(const Unit& u, std::size_t i) {
    const Token& next = u.tokens[i + 1];
    const std::string_view word = u.tokens[i].text;
    if (word == "subroutine" || word == "layout") return next.text != "(" && next.kind == Kind::punct;
    if (next.kind != Kind::punct || next.text == "{") return false;
    // The name of a newer type is a variable if it is used as one.
    if (builtin_type(word)) return std::string_view("=;*+-/.").find(next.text[0]) != std::string_view::npos;
    const bool type_like =
        word.starts_with("hvec") || word.starts_with("fvec") || word == "atomic_uint" || word == "sampler3DRect";
    return !(type_like && next.text == "(");
}

// The token reads `text` from now on, for the parser too. `text` stays: a literal or the unit's.
void respell(Unit& u, std::size_t i, std::string_view text) {
    u.replace(static_cast<int>(i), text);
    u.tokens[i].text = text;
}

// The token goes; what leads it leads the next.
void drop(Unit& u, std::size_t i) {
    u.tokens[i + 1].lead = u.keep(std::string(u.tokens[i].lead) + std::string(u.tokens[i + 1].lead));
    u.tokens.erase(u.tokens.begin() + static_cast<std::ptrdiff_t>(i));
}

void drop_meaningless(Program& program, Unit& u) {
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const Token& t = u.tokens[i];
        if (t.kind != Kind::identifier || !meaningless(t.text) || u.tokens[i + 1].kind != Kind::identifier) continue;
        program.warn(u, static_cast<int>(i), "meaningless-word",
                     "'" + std::string(t.text) + "' has no meaning in GLSL: left out");
        drop(u, i--);
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
    // The text is kept by the unit, because the edit moves when their vector grows.
    if (u.at(i).edit >= 0) u.tokens[static_cast<std::size_t>(i)].text = u.keep(std::string(u.now(i)));
}

void no_doubles(Program& program, Unit& u) {
    bool told = false;
    std::set<std::string, std::less<>> names;  // in old versions
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i)
        if (builtin_type(u.tokens[i].text) && stands_as_name(u, i)) names.emplace(u.tokens[i].text);
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const std::string_view t = u.tokens[i].text;
        if (u.tokens[i].kind != Kind::identifier || (t != "double" && !t.starts_with("dvec") && !t.starts_with("dmat")))
            continue;
        const auto type = builtin_type(t);
        if (!type || names.contains(t)) continue;
        if (!told) program.warn(u, static_cast<int>(i), "no-double", "double precision is not there: float is used");
        told = true;
        respell(u, i, type_name(Base::real, type->rows, type->cols));
    }
}

// A name of `set` stands for a variable here: it neither is called nor selected, nor in a layout.
void rename_all(Unit& u, std::string_view word, bool calls_too) {
    const std::string_view name = u.keep("snell_" + std::string(word));
    bool in_layout = false;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const std::string_view t = u.tokens[i].text;
        if (t == "layout" && u.tokens[i + 1].text == "(") in_layout = true;
        if (in_layout && t == ")") in_layout = false;
        if (t != word || in_layout || u.tokens[i].kind != Kind::identifier) continue;
        if (builtin_type(word) && calls_too) {
            const Token& next = u.tokens[i + 1];
            if (next.kind != Kind::punct || next.text == "(" || next.text == "[") continue;
        } else if (calls_too ? !stands_as_name(u, i)
                             : u.tokens[i + 1].text == "(" || (i > 0 && u.tokens[i - 1].text == "."))
            continue;
        respell(u, i, name);
    }
}

// Words that are names here though the language reserves them; with the first place of each.
void collect_reserved(const Unit& u, std::map<std::string, Place>& found) {
    bool in_layout = false;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const Token& t = u.tokens[i];
        if (t.text == "layout" && u.tokens[i + 1].text == "(") in_layout = true;
        if (in_layout && t.text == ")") in_layout = false;
        if (t.kind != Kind::identifier || in_layout || !is_reserved_word(t.text) || !stands_as_name(u, i)) continue;
        found.try_emplace(std::string(t.text), Place{&u, static_cast<int>(i)});
    }
}

// Names of the user's own that begin as only the language's may.
void collect_own_gl(const Unit& u, std::map<std::string, Place>& found) {
    for (std::size_t i = 1; i + 1 < u.tokens.size(); ++i) {
        const Token& t = u.tokens[i];
        if (t.kind != Kind::identifier || !t.text.starts_with("gl_") || legacy_name(t.text)) continue;
        const std::string_view before = u.tokens[i - 1].text, after = u.tokens[i + 1].text;
        if (builtin_type(before) && (after == ";" || after == "=" || after == ","))
            found.try_emplace(std::string(t.text), Place{&u, static_cast<int>(i)});
    }
}

// Built-in functions that are called, and variables of the same names, which would hide them.
void collect_hiding(const Unit& u, std::set<std::string_view>& called, std::map<std::string, Place>& named) {
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const Token& t = u.tokens[i];
        if (t.kind != Kind::identifier || (i > 0 && u.tokens[i - 1].text == ".")) continue;
        if (u.tokens[i + 1].text == "(") {
            const std::string_view modern = modern_texture_function(t.text);
            const std::string_view name = modern.empty() ? t.text : modern;
            // After a type, this is the user's own function of that name, which the calls mean.
            const bool defined =
                i > 0 && u.tokens[i - 1].kind == Kind::identifier && !is_statement_word(u.tokens[i - 1].text);
            if (!defined && !builtin_signatures(name).empty()) called.insert(name);
        } else if (!builtin_signatures(t.text).empty()) {
            named.try_emplace(std::string(t.text), Place{&u, static_cast<int>(i)});
        }
    }
}

void mend_foreign_types(Program& program, Unit& u) {
    std::set<std::string_view> told;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const Token& next = u.tokens[i + 1];
        if (u.tokens[i].kind != Kind::identifier || (next.kind != Kind::identifier && next.text != "(")) continue;
        if (u.tokens[i].text == "unsigned" && (next.text == "int" || next.text == "uint")) {
            drop(u, i);
            respell(u, i, "uint");
            continue;
        }
        const std::string_view type = foreign_type(u.tokens[i].text);
        if (type.empty()) continue;
        const bool function = next.text == "(" && i > 0 && u.tokens[i - 1].kind == Kind::identifier;
        if (function) continue;
        if (told.insert(u.tokens[i].text).second)
            program.warn(
                u, static_cast<int>(i), "foreign-type",
                "'" + std::string(u.tokens[i].text) + "' is not a type of GLSL; it is read as " + std::string(type));
        respell(u, i, type);
    }
}

// Dashes from slides and text processors that mean a minus.
void mend_dashes(Program& program, Unit& u) {
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        Token& t = u.tokens[i];
        if (t.kind != Kind::other) continue;
        const std::string_view s = t.text;
        if (s != "\xE2\x80\x93" && s != "\xE2\x80\x94" && s != "\xE2\x88\x92" && s != "\x96" && s != "\x97") continue;
        program.warn(u, static_cast<int>(i), "odd-minus", "this dash is not a minus sign; it is read as one");
        respell(u, i, "-");
        t.kind = Kind::punct;
    }
}

void mend_for_es(Unit& u) {
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const std::string_view t = u.tokens[i].text;
        // The token's own text stays sampler1D, so that calls can be told apart.
        if (t == "sampler1D") u.replace(static_cast<int>(i), "sampler2D");
        // All precisions become highp, because uniforms must agree across stages.
        if (t == "mediump" || t == "lowp") u.replace(static_cast<int>(i), "highp");
    }
}

}  // namespace

void mend_words(Program& program, Unit& u) {
    drop_meaningless(program, u);
    lift_structures(u);
    mend_dashes(program, u);
    mend_foreign_types(program, u);
    const Target& target = program.target();
    if (target.es || !target.fp64) no_doubles(program, u);
    if (target.es) mend_for_es(u);
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i)
        if (u.tokens[i].kind == Kind::real) mend_number(program, u, static_cast<int>(i));
}

// Across all stages, so that what passes between them keeps one name.
void rename_words(Program& program) {
    std::map<std::string, Place> reserved, hiding, own_gl;
    for (const Unit& u : program.units) {
        collect_own_gl(u, own_gl);
        collect_reserved(u, reserved);
        std::set<std::string_view> called;
        std::map<std::string, Place> here;
        collect_hiding(u, called, here);
        for (const auto& [name, place] : here)
            if (called.contains(name)) hiding.try_emplace(name, place);
    }
    const auto rename = [&](const std::string& word, const Place& place, bool calls_too, std::string_view why) {
        program.warn(*place.unit, place.token, "reserved-word", "'" + word + "' " + std::string(why) + ": renamed");
        for (Unit& u : program.units) rename_all(u, word, calls_too);
        program.renamed.push_back({word, "snell_" + word});
    };
    for (const auto& [word, place] : reserved) rename(word, place, true, "is a word of the language");
    for (const auto& [word, place] : own_gl) rename(word, place, false, "begins as only names of the language may");
    for (const auto& [word, place] : hiding) rename(word, place, false, "hides the built-in function of that name");
}

// Mistakes whose meaning is clear, and which some compilers accept.

// Prototypes within a function move ahead of it. They follow it in the list.
static void lift_prototypes(Unit& u) {
    std::string lifted;
    int around = -1;
    const auto put = [&] {
        if (around >= 0 && !lifted.empty()) u.edit(around).before.insert(0, lifted);
        lifted.clear();
    };
    for (const Function& f : u.functions) {
        if (f.open >= 0) {
            put();
            around = f.first;
        } else if (f.local) {
            lifted += render(u, f.first, f.parameters_end) + "; ";
            u.erase(f.first, f.parameters_end + 1);
        }
    }
    put();
}

// In old versions, functions and variables had separate namespaces.
void separate_functions(Unit& u) {
    for (int i = 0; i + 1 < static_cast<int>(u.tokens.size()); ++i) {
        const std::string_view t = u.at(i).text;
        if (u.at(i).kind != Kind::identifier || u.at(i + 1).text != "(" || !u.shared_by_kinds.contains(t)) continue;
        if (u.now(i) == t && (i == 0 || u.at(i - 1).text != ".")) u.replace(i, "snell_" + std::string(t));
    }
}

// Functions called above their definition get a prototype.
void declare_functions(Program& program, Unit& u) {
    lift_prototypes(u);
    std::string prototypes;
    const Function* first = nullptr;
    for (const Function& f : u.functions) {
        if (f.open < 0) continue;
        if (!first) first = &f;
        const auto call = u.unknown_calls.find(f.name);
        if (call == u.unknown_calls.end() || call->second > f.name_token || f.name == "main") continue;
        program.warn(u, call->second, "used-before-definition",
                     "'" + std::string(f.name) + "' is called before it is declared");
        prototypes += render(u, f.first, f.parameters_end) + "; ";
    }
    if (first && !prototypes.empty()) {
        Edit& e = u.edit(first->first);
        e.before = prototypes + e.before;
    }
}

// Inputs and uniforms can't be assigned: the assignments go to a copy.
void copy_assigned(Program& program, Unit& u) {
    for (const Global& g : u.globals) {
        const Storage s = g.qualifiers.storage;
        const bool constant = s == Storage::in || s == Storage::uniform;
        if (!constant || !g.written || g.removed || g.type.dims || !g.new_type.empty() || g.name.starts_with("gl_"))
            continue;
        if (!g.type.basic()) continue;
        const std::string name(u.now(g.name_token)), copy = "snell_copy_" + name;
        program.warn(u, g.name_token, "assigned-input",
                     "'" + name + "' comes from outside and cannot be assigned: a copy is");
        u.header += std::string(g.type.name) + " " + copy + ";\n";
        for (const int token : g.uses) u.replace(token, copy);
        at_main_start(u, copy + " = " + name + ";");
    }
}

}  // namespace snell::glsl
