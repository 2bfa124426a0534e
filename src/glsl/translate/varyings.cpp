// gl_… to snell_…: uniforms, attributes, colours, and what passes from stage to stage.
#include <algorithm>
#include <charconv>
#include <map>

#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

// Varyings by their name behind snell_.
constexpr std::string_view varying_names[] = {"FrontColor",         "BackColor", "FrontSecondaryColor",
                                              "BackSecondaryColor", "TexCoord",  "FogFragCoord"};

std::string snell(std::string_view gl_name) { return "snell_" + std::string(gl_name.substr(3)); }

// What a stage says about legacy varyings.
struct Mentions {
    std::set<std::string_view> in, out;  // of varying_names
};

struct Context {
    Program& program;
    bool blocks = false;  // geometry or tessellation: per-vertex blocks instead of single variables
    int texcoords = 0;    // size of TexCoord
    std::map<Stage, Mentions> mentions;
    bool back_color = false, back_secondary = false;  // written: two-sided
    std::set<std::string_view> handed_on;             // colours that no stage writes
};

bool arrayed_input(Stage s) { return s == Stage::tess_control || s == Stage::tess_evaluation || s == Stage::geometry; }

// The token behind the bracket that closes at or after i; i is at an opening one. -1 if there is none.
int behind_bracket(const Unit& u, int i) {
    int open = 0;
    for (; u.at(i).kind != Kind::end; ++i) {
        if (u.at(i).text == "[" || u.at(i).text == "(") ++open;
        if (u.at(i).text == "]" || u.at(i).text == ")") --open;
        if (open == 0) return i + 1;
        if (u.at(i).text == ";" || u.at(i).text == "{") return -1;
    }
    return -1;
}

bool member(const Unit& u, int i) { return i > 0 && u.at(i - 1).text == "."; }

std::string_view varying_of(std::string_view gl_name) {
    for (const std::string_view v : varying_names)
        if (gl_name.size() == v.size() + 3 && gl_name.substr(3) == v) return v;
    return {};
}

// gl_FrontColorIn → FrontColor
std::string_view varying_in_of(std::string_view gl_name) {
    if (!gl_name.ends_with("In")) return {};
    return varying_of(gl_name.substr(0, gl_name.size() - 2));
}

// gl_in[i].gl_TexCoord: the legacy member of gl_in or gl_out at i; -1 if it is none.
int block_member(const Unit& u, int i) {
    if (u.at(i + 1).text != "[") return -1;
    const int dot = behind_bracket(u, i + 1);
    if (dot < 0 || u.at(dot).text != "." || u.at(dot + 1).kind != Kind::identifier) return -1;
    return varying_of(u.at(dot + 1).text).empty() ? -1 : dot + 1;
}

void scan_texcoord(Context& c, const Unit& u, int i) {
    // gl_TexCoord[2]: the greatest constant index decides; any other index means all of them.
    int n = -1;
    int bracket = i + 1;
    if (u.at(i).text == "gl_TexCoordIn") bracket = u.at(bracket).text == "[" ? behind_bracket(u, bracket) : -1;
    if (bracket > 0 && u.at(bracket).text == "[" && u.at(bracket + 1).kind == Kind::integer &&
        u.at(bracket + 2).text == "]") {
        const std::string_view digits = u.at(bracket + 1).text;
        std::from_chars(digits.data(), digits.data() + digits.size(), n);
    }
    c.texcoords = std::max(c.texcoords, n >= 0 && n < 32 ? n + 1 : 8);
}

void scan(Context& c, const Unit& u) {
    Mentions& m = c.mentions[u.stage];
    for (int i = 0; i + 1 < static_cast<int>(u.tokens.size()); ++i) {
        const std::string_view t = u.at(i).text;
        if (u.at(i).kind != Kind::identifier || !t.starts_with("gl_")) continue;
        if (t == "gl_TexCoord" || t == "gl_TexCoordIn") scan_texcoord(c, u, i);
        if (u.stage == Stage::fragment) {
            if (t == "gl_Color") m.in.insert("FrontColor");
            if (t == "gl_SecondaryColor") m.in.insert("FrontSecondaryColor");
            if (const std::string_view v = varying_of(t); !v.empty()) m.in.insert(v);
            continue;
        }
        if (const std::string_view v = varying_in_of(t); !v.empty()) m.in.insert(v);
        if (t == "gl_in")
            if (const int k = block_member(u, i); k >= 0) m.in.insert(varying_of(u.at(k).text));
        if (const std::string_view v = varying_of(t); !v.empty()) {
            bool of_input = false;
            if (member(u, i))  // gl_in[…].gl_X
                for (int k = i - 2, open = 0; k > 0; --k) {
                    if (u.at(k).text == "]") ++open;
                    if (u.at(k).text == "[" && --open == 0) {
                        of_input = u.at(k - 1).text == "gl_in";
                        break;
                    }
                    if (u.at(k).text == ";") break;
                }
            if (!of_input) m.out.insert(v);
        }
    }
}

std::string member_text(const Context& c, std::string_view v, std::string_view direction = "") {
    const bool flat = c.program.options.flat_color && v.ends_with("Color");
    const std::string before = (flat ? "flat " : "") + std::string(direction);
    if (v == "TexCoord") return before + "vec4 snell_TexCoord[" + std::to_string(c.texcoords) + "];";
    return before + (v == "FogFragCoord" ? "float snell_" : "vec4 snell_") + std::string(v) + ";";
}

std::set<std::string_view> all_members(const Context& c) {
    std::set<std::string_view> all;
    for (const auto& [stage, m] : c.mentions) {
        all.insert(m.in.begin(), m.in.end());
        all.insert(m.out.begin(), m.out.end());
    }
    return all;
}

void declare_block(Context& c, Unit& u, bool input) {
    std::string text = input ? "in snell_PerVertex {" : "out snell_PerVertex {";
    for (const std::string_view v : all_members(c)) text += " " + member_text(c, v);
    text += " }";
    if (input && arrayed_input(u.stage))
        text += u.stage == Stage::geometry ? " snell_in[]" : " snell_in[gl_MaxPatchVertices]";
    if (!input && u.stage == Stage::tess_control) text += " snell_out[]";
    u.header += text + ";\n";
}

// The current colour of the draw, handed on from the vertex shader, or what the stage before was given itself.
std::string color_at(Unit& u, std::string_view v) {
    std::string attribute = v == "FrontColor" ? "snell_Color" : "snell_SecondaryColor";
    if (u.stage == Stage::vertex) {
        declare_once(u, attribute, "in vec4 " + attribute + ";");
        return attribute;
    }
    const std::string_view vertex =
        u.stage == Stage::tess_control ? "min(gl_InvocationID, gl_PatchVerticesIn - 1)" : "0";
    return "snell_in[" + std::string(vertex) + "].snell_" + std::string(v);
}

// What a stage reads and the one before does not write: colours are the draw's, anything else is zero. From the
// last stage to the first, as what is handed on has to be given, too.
void give_missing(Context& c, const Unit& u) {
    Unit* from = c.program.before(u);
    if (!from) return;
    Mentions& given = c.mentions[from->stage];
    for (const std::string_view v : c.mentions[u.stage].in) {
        const bool is_new = given.out.insert(v).second;
        // Of texture coordinates a stage may write some only; as a whole, so that a translation is not translated
        // again.
        if (v == "TexCoord" && from->stage == Stage::vertex) {
            std::string all;
            for (int n = 0; n < c.texcoords; ++n) all += (n ? ", " : "") + std::string("vec4(0.0, 0.0, 0.0, 1.0)");
            at_main_start(*from, "snell_TexCoord = vec4[" + std::to_string(c.texcoords) + "](" + all + ");");
        }
        if (!is_new) continue;
        const bool color = v == "FrontColor" || v == "FrontSecondaryColor";
        const bool control = from->stage == Stage::tess_control;
        const std::string name = (control ? "snell_out[gl_InvocationID].snell_" : "snell_") + std::string(v);
        if (v == "TexCoord") {
            for (int n = 0; n < c.texcoords && from->stage != Stage::vertex; ++n)
                at_main_start(*from, name + "[" + std::to_string(n) + "] = vec4(0.0, 0.0, 0.0, 1.0);");
        } else if (color) {
            at_main_start(*from, name + " = " + color_at(*from, v) + ";");
            if (from->stage != Stage::vertex) c.mentions[from->stage].in.insert(v);
        } else {
            at_main_start(*from, name + (v == "FogFragCoord" ? " = 0.0;" : " = vec4(0.0, 0.0, 0.0, 1.0);"));
        }
        if (u.built_in || (color && c.handed_on.contains(v))) continue;
        if (color) c.handed_on.insert(v);
        const std::string read = "gl_" + std::string(v == "FrontColor"            ? "Color"
                                                     : v == "FrontSecondaryColor" ? "SecondaryColor"
                                                                                  : v);
        c.program.diagnostics.warning(
            "input-without-output", u.reference,
            "this shader reads a built-in input that the stage before does not write: " + read +
                (color ? ", which is the current colour then" : ", which is zero then"));
    }
}

void declare_varyings(Context& c, Unit& u) {
    const Mentions& m = c.mentions[u.stage];
    const bool last = u.stage == Stage::fragment;
    if (c.blocks) {
        if (!m.in.empty() && c.program.before(u)) declare_block(c, u, true);
        if (!m.out.empty() && !last) declare_block(c, u, false);
        return;
    }
    for (const std::string_view v : last ? m.in : m.out) u.header += member_text(c, v, last ? "in " : "out ") + "\n";
}

void declare_uniform(Unit& u, const LegacyName& name) {
    if (!name.struct_text.empty()) declare_once(u, name.type, name.struct_text);
    std::string text = "uniform " + std::string(name.type) + " " + snell(name.name);
    if (name.size > 0) text += "[" + std::to_string(name.size) + "]";
    declare_once(u, snell(name.name), text + ";");
}

std::string limit(const Unit& u, std::string_view name) {
    if (name == "gl_VerticesIn") return std::to_string(vertices_in(u));
    if (name == "gl_MaxVaryingFloats") return "64";
    return "8";
}

// Dimensions of arrays at global scope are kept as they were written.
void replace_limit(Unit& u, int i, std::string_view name) {
    const std::string value = limit(u, name);
    u.replace(i, value);
    for (Global& g : u.globals)
        for (std::size_t at = g.dims.find(name); at != std::string::npos; at = g.dims.find(name))
            g.dims.replace(at, name.size(), value);
}

void replace_per_vertex_in(Unit& u, int i, std::string_view name) {
    const std::string_view stem = name.substr(0, name.size() - 2);
    const bool core = stem == "gl_Position" || stem == "gl_PointSize";
    u.replace(i, core ? "gl_in" : "snell_in");
    if (u.at(i + 1).text != "[") return;
    const int behind = behind_bracket(u, i + 1);
    if (behind > 0) u.edit(behind - 1).after += "." + (core ? std::string(stem) : snell(stem));
}

void replace_color(Context& c, Unit& u, int i, bool secondary) {
    const bool two_sided = secondary ? c.back_secondary : c.back_color;
    const std::string front = secondary ? "snell_FrontSecondaryColor" : "snell_FrontColor";
    const std::string back = secondary ? "snell_BackSecondaryColor" : "snell_BackColor";
    u.replace(i, two_sided ? "(gl_FrontFacing ? " + front + " : " + back + ")" : front);
}

// gl_FragColor is the colour of every render target, unless the shader has outputs of its own beside it.
void write_every_target(Unit& u, int targets) {
    const bool own = std::any_of(u.globals.begin(), u.globals.end(), [](const Global& g) {
        return g.qualifiers.storage == Storage::out && !g.removed && !g.name.starts_with("gl_");
    });
    if (own || u.header.find(" snell_FragColor1;") != std::string::npos) return;
    for (int n = 1; n < targets; ++n) {
        const std::string number = std::to_string(n), name = "snell_FragColor" + number;
        declare_once(u, name, "layout(location = " + number + ") out vec4 " + name + ";");
        at_main_end(u, name + " = snell_FragColor;");
    }
}

void declare_fragment_color(Unit& u, int i, std::string_view name, int targets) {
    const bool both =
        std::any_of(u.tokens.begin(), u.tokens.end(), [](const Token& t) { return t.text == "gl_FragData"; });
    u.replace(i, name == "gl_FragColor" && both ? "snell_FragData[0]" : snell(name));
    if (name == "gl_FragColor" && !both) {
        declare_once(u, "snell_FragColor", "layout(location = 0) out vec4 snell_FragColor;");
        write_every_target(u, targets);
        return;
    }
    int most = 0;
    for (int k = 0; k + 3 < static_cast<int>(u.tokens.size()); ++k) {
        if (u.at(k).text != "gl_FragData") continue;
        int n = 7;
        if (u.at(k + 1).text == "[" && u.at(k + 2).kind == Kind::integer && u.at(k + 3).text == "]") {
            const std::string_view digits = u.at(k + 2).text;
            std::from_chars(digits.data(), digits.data() + digits.size(), n);
        }
        most = std::max(most, n);
    }
    most = std::clamp(most, 0, 7);
    declare_once(u, "snell_FragData",
                 "layout(location = 0) out vec4 snell_FragData[" + std::to_string(most + 1) + "];");
}

void replace_attribute(Context& c, Unit& u, int i, const LegacyName& name) {
    const std::string own =
        name.name.starts_with("gl_MultiTexCoord") ? std::string("snell_MultiTexCoord0") : snell(name.name);
    declare_once(u, own, "in " + std::string(name.type) + " " + own + ";");
    if (!u.legacy_written.contains(name.name)) return u.replace(i, own);
    // Inputs can't be assigned: the assignments go to a copy.
    const std::string copy = "snell_copy_" + std::string(name.name.substr(3));
    const std::size_t size = u.header.size();
    declare_once(u, copy, std::string(name.type) + " " + copy + ";");
    if (u.header.size() > size) {
        const std::string_view spelled = u.at(i).spelled;
        c.program.warn(u, i, "assigned-input",
                       "'" + std::string(spelled.empty() ? name.name : spelled) +
                           "' comes from outside and cannot be assigned: a copy is");
        at_main_start(u, copy + " = " + own + ";");
    }
    u.replace(i, copy);
}

void replace_one(Context& c, Unit& u, int i, const LegacyName& name) {
    const bool fragment = u.stage == Stage::fragment;
    switch (name.kind) {
        case LegacyKind::core:
            return;
        case LegacyKind::uniform:
            declare_uniform(u, name);
            u.replace(i, snell(name.name));
            return;
        case LegacyKind::attribute:
            if (fragment && (name.name == "gl_Color" || name.name == "gl_SecondaryColor"))
                return replace_color(c, u, i, name.name == "gl_SecondaryColor");
            if (u.stage == Stage::vertex) replace_attribute(c, u, i, name);
            return;
        case LegacyKind::varying:
            u.replace(i, snell(name.name));
            return;
        case LegacyKind::color:
            if (fragment) declare_fragment_color(u, i, name.name, c.program.options.color_outputs);
            return;
        case LegacyKind::limit:
            replace_limit(u, i, name.name);
            return;
        case LegacyKind::per_vertex_in:
            if (u.stage != Stage::vertex && !fragment) replace_per_vertex_in(u, i, name.name);
            return;
        case LegacyKind::ignored:
            declare_once(u, snell(name.name), std::string(name.type) + " " + snell(name.name) + ";");
            u.replace(i, snell(name.name));
            return;
    }
}

// Redeclarations of legacy variables go; those of core ones stay where the core allows them.
void drop_redeclarations(Unit& u) {
    for (Global& g : u.globals) {
        const LegacyName* name = legacy_name(g.name);
        if (!name) continue;
        const bool stays = name->kind == LegacyKind::core && g.name != "gl_Position" && g.name != "gl_PointSize" &&
                           (g.name != "gl_FragCoord" || !g.qualifiers.layout.empty()) && !g.qualifiers.varying;
        if (stays) continue;
        g.removed = true;
        g.dirty = true;
    }
}

void functions(Unit& u, int i) {
    const std::string_view t = u.at(i).text;
    if (u.at(i + 1).text != "(" || member(u, i) || user_function(u, t)) return;
    if (t == "ftransform") {
        declare_uniform(u, *legacy_name("gl_ModelViewProjectionMatrix"));
        declare_once(u, "snell_Vertex", "in vec4 snell_Vertex;");
        u.replace(i, "(snell_ModelViewProjectionMatrix * snell_Vertex)");
        if (u.at(i + 2).text == ")") {
            u.replace(i + 1, "");
            u.replace(i + 2, "");
        }
        return;
    }
    if (const std::string_view modern = modern_texture_function(t); !modern.empty()) u.replace(i, modern);
}

}  // namespace

void replace_legacy(Program& program) {
    Context c{program, false, 0, {}, false, false, {}};
    const bool wide = widens_lines(program);
    c.blocks = wide;
    for (Unit& u : program.units) {
        c.blocks = c.blocks || arrayed_input(u.stage);
        drop_redeclarations(u);
        scan(c, u);
        c.back_color = c.back_color || u.legacy_written.contains("gl_BackColor");
        c.back_secondary = c.back_secondary || u.legacy_written.contains("gl_BackSecondaryColor");
    }
    if (Mentions& m = c.mentions[Stage::fragment]; c.back_color && m.in.contains("FrontColor"))
        m.in.insert("BackColor");
    if (Mentions& m = c.mentions[Stage::fragment]; c.back_secondary && m.in.contains("FrontSecondaryColor"))
        m.in.insert("BackSecondaryColor");
    for (std::size_t n = program.units.size(); n-- > 0;) give_missing(c, program.units[n]);
    for (Unit& u : program.units) {
        for (int i = 0; i + 1 < static_cast<int>(u.tokens.size()); ++i) {
            if (u.at(i).kind != Kind::identifier) continue;
            functions(u, i);
            const LegacyName* name = legacy_name(u.at(i).text);
            if (const std::string_view type = legacy_struct_text(u.at(i).text); !type.empty()) {
                declare_once(u, type.substr(7, type.find(' ', 7) - 7), type);
                u.replace(i, snell(u.at(i).text));
            } else if (u.at(i).text == "gl_in" || u.at(i).text == "gl_out") {
                if (block_member(u, i) >= 0) u.replace(i, u.at(i).text == "gl_in" ? "snell_in" : "snell_out");
            } else if (name) {
                replace_one(c, u, i, *name);
            }
        }
        declare_varyings(c, u);
        if (u.stage == Stage::vertex && (!c.blocks || wide))
            for (const std::string_view v :
                 {"gl_FrontColor", "gl_BackColor", "gl_FrontSecondaryColor", "gl_BackSecondaryColor"})
                if (u.legacy_written.contains(v)) at_main_end(u, snell(v) + " = clamp(" + snell(v) + ", 0.0, 1.0);");
    }
    if (wide && !c.mentions[Stage::fragment].in.empty())
        for (const std::string_view v : all_members(c))
            program.legacy_varyings.push_back(
                {"snell_" + std::string(v), member_text(c, v), v == "TexCoord" ? c.texcoords : 0});
}

}  // namespace snell::glsl
