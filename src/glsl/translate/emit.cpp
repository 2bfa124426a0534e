// Writes tokens and edits as text.
#include <algorithm>

#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

// Two words stay two: `return(1.)` has no blank where something is written between them.
void put(std::string_view text, std::string& out) {
    if (!text.empty() && !out.empty() && identifier_part(text.front()) && identifier_part(out.back())) out += ' ';
    out += text;
}

void write_token(const Unit& u, const Token& t, std::string& out) {
    const Edit* edit = t.edit < 0 ? nullptr : &u.edits[static_cast<std::size_t>(t.edit)];
    if (edit) put(edit->before, out);
    put(edit && edit->replaced ? std::string_view(edit->text) : t.text, out);
    if (edit) put(edit->after, out);
}

// The tokens of one macro invocation from `i`: as written if nothing in them changed, else expanded.
std::size_t write_invocation(const Unit& u, std::size_t i, std::size_t last, std::string& out) {
    const std::int32_t id = u.tokens[i].macro;
    std::size_t end = i;
    bool changed = !u.verbatim || (i > 0 && u.tokens[i - 1].macro == id);
    while (end < u.tokens.size() && u.tokens[end].macro == id) changed = u.tokens[end++].edit >= 0 || changed;
    const std::string_view source = u.invocations[static_cast<std::size_t>(id)];
    if (!changed && end - 1 <= last) {
        out += source;
        return end;
    }
    const std::size_t stop = std::min(end, last + 1);
    for (std::size_t k = i; k < stop; ++k) {
        if (k > i) out += ' ';
        write_token(u, u.tokens[k], out);
    }
    if (stop == end) out.append(static_cast<std::size_t>(std::count(source.begin(), source.end(), '\n')), '\n');
    return stop;
}

std::string extension_line(const Program& program, const Extension& e) {
    const bool superfluous = !e.name.starts_with("GL_") || e.behaviour == "disable" || e.name == "GL_EXT_gpu_shader4" ||
                             e.name == "GL_EXT_geometry_shader4" || e.name == "GL_ARB_compatibility" ||
                             e.name == "GL_EXT_texture_array" || e.name == "GL_ARB_texture_rectangle" ||
                             e.name.starts_with("GL_NV_") || e.name.starts_with("GL_ATI_") ||
                             e.name.starts_with("GL_ARB_") == program.target().es;
    // Extensions in the core of version 4.5 need no line.
    const bool in_core = !program.target().es && program.target().version >= 450 && e.name.starts_with("GL_ARB_");
    if (superfluous || in_core) return {};
    return "#extension " + e.name + " : " + (e.behaviour == "warn" ? "warn" : "enable");
}

void write_lead(const Program& program, const Unit& u, std::string_view lead, bool keep, std::size_t& next,
                std::string& out) {
    if (u.extensions.empty()) {
        out += lead;
        return;
    }
    for (const char c : lead) {
        if (c != extension_mark) {
            out += c;
        } else if (next < u.extensions.size()) {
            if (keep) out += extension_line(program, u.extensions[next]);
            ++next;
        }
    }
}

std::string extension_lines(const Program& program, const Unit& u) {
    std::string lines;
    for (const Extension& e : u.extensions)
        if (const std::string line = extension_line(program, e); !line.empty()) lines += line + "\n";
    for (const std::string& name : u.wanted_extensions) lines += "#extension " + name + " : enable\n";
    return lines;
}

// An extension that the text enables itself needs no second line.
void drop_known_extensions(Unit& u) {
    std::erase_if(u.wanted_extensions, [&](const std::string& name) {
        return std::any_of(u.extensions.begin(), u.extensions.end(),
                           [&](const Extension& e) { return e.name == name; });
    });
}

std::string define_lines(const Program& program, const Unit& u) {
    std::string lines;
    if (!u.verbatim) return lines;
    for (const Define& d : program.options.defines) {
        if (std::find(u.defined.begin(), u.defined.end(), d.name) != u.defined.end()) continue;
        bool used = u.has_conditionals;
        for (const Token& t : u.tokens)
            used = used || (t.macro >= 0 && u.invocations[static_cast<std::size_t>(t.macro)].starts_with(d.name));
        if (used) lines += "#define " + d.name + " " + d.value + "\n";
    }
    return lines;
}

// What main is called where a new one calls it. A text that was translated before may have such functions.
std::string inner_main(const Unit& u) {
    std::string name = "snell_main";
    for (int n = 2; user_function(u, name); ++n) name = "snell_main" + std::to_string(n);
    return name;
}

bool wrap_main(Unit& u) {
    const Function* main = find_main(u);
    if (!main) return false;
    if (!u.trailer.empty()) return true;
    u.replace(main->name_token, inner_main(u));
    u.trailer = "void main() { " + inner_main(u) + "(); }\n";
    return true;
}

// The budget bounds the number of statements, because structures of structures multiply.
std::string zero_statements(const Unit& u, const std::string& variable, const Type& type, int& budget) {
    if (budget-- <= 0) return {};
    if (type.dims > 0) {
        if (type.size < 0) return {};  // it has as many elements as constants index
        Type element = type;
        --element.dims;
        element.size = 1;  // known to the driver
        const std::string index = "snell_" + std::to_string(type.dims);
        const std::string each = zero_statements(u, variable + "[" + index + "]", element, budget);
        return each.empty() ? each
                            : "for (int " + index + " = 0; " + index + " < " + variable + ".length(); ++" + index +
                                  ") { " + each + " }";
    }
    if (type.base == Base::structure && type.structure >= 0) {
        std::string all;
        for (const Member& m : u.structure(type).members)
            if (budget > 0) all += zero_statements(u, variable + "." + std::string(m.name), m.type, budget) + " ";
        return all;
    }
    if (!type.basic()) return {};
    return variable + " = " + zero(type) + ";";
}

}  // namespace

std::string render(const Unit& u, int first, int last) {
    std::string out;
    for (auto i = static_cast<std::size_t>(first); i <= static_cast<std::size_t>(last);) {
        const Token& t = u.tokens[i];
        // Comments and line ends become one blank.
        if (i > static_cast<std::size_t>(first) && !t.lead.empty()) out += ' ';
        if (t.macro >= 0) {
            const std::size_t from = out.size();
            i = write_invocation(u, i, static_cast<std::size_t>(last), out);
            std::replace(out.begin() + static_cast<std::ptrdiff_t>(from), out.end(), '\n', ' ');
        } else {
            write_token(u, t, out);
            ++i;
        }
    }
    return out;
}

std::string emit(const Program& program, Unit& u) {
    if (const Function* main = find_main(u); main && !u.main_start.empty()) u.edit(main->open).after += u.main_start;
    drop_known_extensions(u);
    const std::string defines = define_lines(program, u);
    const bool insertion = !u.header.empty() || !defines.empty() || !u.wanted_extensions.empty();
    std::string out;
    out.reserve(u.tokens.size() * 8 + u.header.size() + 256);
    // Comments may stand before #version, but OpenGL ES lets nothing stand there.
    const bool in_place = u.has_version && u.head.empty();
    const Target& target = program.target();
    out += "#version " + std::to_string(target.version) + (target.es ? " es" : " core");
    if (insertion || !in_place) {
        out += '\n';
        if (insertion) out += extension_lines(program, u);
        out += defines + u.header;
        out += "#line " + std::to_string(in_place ? u.version_line + 1 : 1) + " 0";
        // Behind a #version line its own line end follows.
        if (!in_place) out += '\n';
    }
    if (!in_place) out += u.head;
    std::size_t next_extension = 0;
    for (std::size_t i = 0; i < u.tokens.size();) {
        const Token& t = u.tokens[i];
        if (i == 0 || t.macro < 0 || u.tokens[i - 1].macro != t.macro)
            write_lead(program, u, t.lead, !insertion, next_extension, out);
        if (t.macro >= 0) {
            i = write_invocation(u, i, u.tokens.size() - 1, out);
        } else {
            write_token(u, t, out);
            ++i;
        }
    }
    if (!u.trailer.empty()) {
        if (!out.ends_with('\n')) out += '\n';
        out += u.trailer;
    }
    return out;
}

void declare_once(Unit& u, std::string_view name, std::string_view declaration) {
    for (const Global& g : u.globals)
        if (g.name == name && !g.removed) return;
    const std::string line = std::string(declaration) + "\n";
    if (u.header.find(line) == std::string::npos) u.header += line;
}

const Function* find_main(const Unit& u) {
    for (const Function& f : u.functions)
        if (f.name == "main" && f.open >= 0) return &f;
    return nullptr;
}

bool user_function(const Unit& u, std::string_view name) { return u.function_names.contains(name); }

bool at_main_start(Unit& u, std::string_view statement, int declared) {
    const Function* main = find_main(u);
    if (!main) return false;
    if (declared > main->open) {
        declare_before_main(u, {}, std::string(statement) + " ");
        return true;
    }
    u.main_start += " ";
    u.main_start += statement;
    return true;
}

void at_main_end(Unit& u, std::string_view statement) {
    if (wrap_main(u)) u.trailer.insert(u.trailer.size() - 2, std::string(statement) + " ");
}

void declare_before_main(Unit& u, std::string_view declarations, std::string_view statements) {
    if (!wrap_main(u)) return;
    u.trailer.insert(u.trailer.find(inner_main(u) + "();"), statements);
    u.trailer.insert(0, declarations);
}

std::string set_zero(const Unit& u, const std::string& variable, const Type& type) {
    int budget = 1000;  // OpenGL passes fewer components between stages
    return zero_statements(u, variable, type, budget);
}

std::string converted(std::string_view text, const Type& from, const Type& to) {
    if (from.dims || to.dims || !from.basic() || !to.basic() || (from.cols > 1) != (to.cols > 1)) return {};
    const std::string name(type_name(to.base, to.rows, to.cols));
    if (to.cols > 1 || from.rows >= to.rows) return name + "(" + std::string(text) + ")";
    if (from.rows == 1) return name + "(" + std::string(text) + ")";
    std::string out = name + "(" + std::string(text);
    for (int n = from.rows; n < to.rows; ++n) out += n == 3 ? ", 1" : ", 0";
    return out + ")";
}

}  // namespace snell::glsl
