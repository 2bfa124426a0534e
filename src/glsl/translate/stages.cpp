// Stages that a program leaves out, layouts that a geometry shader leaves to the application, and levels that each
// invocation of a tessellation control shader chooses.
#include <algorithm>
#include <tuple>

#include "parser/text/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

bool mentions(const Unit& u, std::string_view name) {
    return std::any_of(u.tokens.begin(), u.tokens.end(), [&](const Token& t) { return t.text == name; });
}

int vertices_in(const Unit& u) {
    constexpr std::pair<std::string_view, int> primitives[] = {
        {"points", 1}, {"lines", 2}, {"triangles", 3}, {"lines_adjacency", 4}, {"triangles_adjacency", 6}};
    for (const StageLayout& l : u.layouts)
        for (const LayoutItem& i : l.qualifiers.layout)
            for (const auto& [name, vertices] : primitives)
                if (l.qualifiers.storage == Storage::in && i.name == name) return vertices;
    return 3;
}

namespace {

bool any_mentions(Program& program, std::initializer_list<std::string_view> names) {
    return std::any_of(program.units.begin(), program.units.end(), [&](const Unit& u) {
        return std::any_of(names.begin(), names.end(), [&](std::string_view n) { return mentions(u, n); });
    });
}

bool layout_has(const Unit& u, Storage storage, std::initializer_list<std::string_view> names) {
    for (const StageLayout& l : u.layouts)
        for (const LayoutItem& i : l.qualifiers.layout)
            if (l.qualifiers.storage == storage && std::find(names.begin(), names.end(), i.name) != names.end())
                return true;
    return false;
}

std::string primitive(std::string_view gl_name, std::string_view otherwise) {
    if (gl_name.starts_with("gl_") || gl_name.starts_with("GL_")) gl_name.remove_prefix(3);
    return lowered(gl_name.empty() ? otherwise : gl_name);
}

std::string input_primitive(const Options& options) {
    std::string name = primitive(options.geometry_input, "triangles");
    for (const std::string_view fine : {"points", "lines", "lines_adjacency", "triangles", "triangles_adjacency"})
        if (name == fine) return name;
    return name.starts_with("line") ? "lines" : "triangles";
}

std::string output_primitive(const Options& options) {
    std::string name = primitive(options.geometry_output, "triangle_strip");
    if (name == "points" || name == "line_strip" || name == "triangle_strip") return name;
    return name.starts_with("line") ? "line_strip" : "triangle_strip";
}

// As many as the least limits of the standard allow: 256 vertices, 1024 components.
int most_vertices(const Unit& u) {
    int components = 4;
    for (const Global& g : u.globals)
        if (g.qualifiers.storage == Storage::out && !g.removed)
            components += g.type.rows * g.type.cols * (g.type.dims > 0 ? std::max(g.type.size, 1) : 1);
    for (const std::string_view name : {"gl_FrontColor", "gl_BackColor", "gl_TexCoord", "gl_FogFragCoord"})
        if (mentions(u, name)) components += name == "gl_TexCoord" ? 32 : 4;
    return std::clamp(1024 / components, 1, 256);
}

// Arrays of inputs have as many elements as the primitive has vertices, whatever was written.
void fit_inputs(Program& program, Unit& u) {
    const int vertices = vertices_in(u);
    for (Global& g : u.globals) {
        if (g.qualifiers.storage != Storage::in || g.type.dims != 1 || g.type.size < 0 || g.type.size == vertices)
            continue;
        program.warn(u, g.name_token, "input-array-size",
                     "'" + std::string(g.name) + "' has " + std::to_string(vertices) +
                         " elements: one for each vertex of the primitive");
        g.dims = "[]";
        g.dirty = true;
    }
}

// The first stream and the first viewport are the ones that are drawn, and all that OpenGL ES has.
void first_stream(const Program& program, Unit& u) {
    for (int i = 0; i + 2 < static_cast<int>(u.tokens.size()); ++i)
        if (u.at(i).text == "gl_ViewportIndex" && u.at(i + 1).text == "=" && u.at(i + 2).text == "0") u.erase(i, i + 2);
    for (const StreamCall& call : u.streams) {
        const std::string_view name = u.at(call.first).text;
        if (call.stream == 0.) {
            u.replace(call.first, name == "EmitStreamVertex" ? "EmitVertex" : "EndPrimitive");
            u.erase(call.first + 2, call.last - 1);
        } else if (program.target().es || program.options.without_stages) {
            program.diagnostics.error(
                "unsupported-stage", u.span(call.first),
                "this OpenGL has only the first stream of vertices, '" + std::string(name) + "(0)'",
                "what goes to another stream is not drawn: leave it out");
        }
    }
}

// Where the expression that begins at `i` ends: its last token.
int expression_end(const Unit& u, int i) {
    for (int depth = 0; u.at(i).kind != Kind::end; ++i) {
        const std::string_view t = u.at(i).text;
        const bool opens = t == "(" || t == "[" || t == "{", closes = t == ")" || t == "]" || t == "}";
        if (depth == 0 && (closes || t == ";" || t == ",")) break;
        depth += opens ? 1 : closes ? -1 : 0;
    }
    return i - 1;
}

// name[index] = value → set(int(index), value)
void set_level(Unit& u, int name, const std::string& set) {
    const int index = expression_end(u, name + 2), op = index + 2, value = expression_end(u, op + 1);
    const std::string level = std::string(u.at(name).text) + "[" + render(u, name + 2, index) + "]";
    const std::string_view how = u.at(op).text;
    u.replace(name, set);
    u.replace(name + 1, "(int(");
    u.replace(index + 1, ")");
    u.replace(op, how == "=" ? "," : ", " + level + " " + how[0] + " (");
    u.edit(value).after.insert(0, how == "=" ? ")" : "))");
}

}  // namespace

std::string default_vertex_shader(Program& program) {
    std::string text = "void main() {\n    gl_Position = ftransform();\n";
    if (any_mentions(program, {"gl_Color", "gl_FrontColor", "gl_FrontColorIn"}))
        text += "    gl_FrontColor = gl_Color;\n";
    if (any_mentions(program, {"gl_SecondaryColor"})) text += "    gl_FrontSecondaryColor = gl_SecondaryColor;\n";
    if (any_mentions(program, {"gl_TexCoord", "gl_TexCoordIn"}))
        text += "    gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;\n";
    return text + "}\n";
}

std::string default_fragment_shader() { return "void main() {\n    gl_FragColor = gl_Color;\n}\n"; }

bool lacks_of_stages(Program& program) {
    const Unit *geometry = program.find(Stage::geometry), *evaluation = program.find(Stage::tess_evaluation);
    if (!program.target().es || (!geometry && !evaluation)) return false;
    if (evaluation && !program.find(Stage::tess_control)) return true;
    if (passes_numbers(program)) return true;
    const bool sized =
        (geometry && mentions(*geometry, "gl_PointSize")) || (evaluation && mentions(*evaluation, "gl_PointSize"));
    if (!geometry) return sized || layout_has(*evaluation, Storage::in, {"point_mode"});
    const bool chosen = layout_has(*geometry, Storage::out, {"points", "line_strip", "triangle_strip"});
    return sized ||
           (chosen ? layout_has(*geometry, Storage::out, {"points"}) : output_primitive(program.options) == "points");
}

void complete_geometry(Program& program, Unit& u) {
    const bool has_input =
        layout_has(u, Storage::in, {"points", "lines", "lines_adjacency", "triangles", "triangles_adjacency"});
    const bool has_output = layout_has(u, Storage::out, {"points", "line_strip", "triangle_strip"});
    const bool has_count = layout_has(u, Storage::out, {"max_vertices"});
    StageLayout made;
    if (!has_input) {
        const std::string name = input_primitive(program.options);
        u.header += "layout(" + name + ") in;\n";
        made.qualifiers.storage = Storage::in;
        made.qualifiers.layout.push_back({name, ""});
        u.layouts.push_back(made);
    }
    fit_inputs(program, u);
    first_stream(program, u);
    if (!has_output) u.header += "layout(" + output_primitive(program.options) + ") out;\n";
    if (!has_count) u.header += "layout(max_vertices = " + std::to_string(most_vertices(u)) + ") out;\n";
}

// llvmpipe takes the element of one invocation for all of them (Mesa 22.3).
void choose_levels(Unit& u) {
    for (const auto& [name, set, size] :
         {std::tuple("gl_TessLevelOuter", "snell_SetOuter", 4), std::tuple("gl_TessLevelInner", "snell_SetInner", 2)}) {
        bool chosen = false;
        for (int i = 0; i + 4 < static_cast<int>(u.tokens.size()); ++i) {
            if (u.at(i).text != name || u.at(i + 1).text != "[") continue;
            const int index = expression_end(u, i + 2);
            const bool constant = index == i + 2 && u.at(index).kind == Kind::integer;
            const std::string_view op = u.at(index + 2).text;
            if (constant || (op != "=" && op != "+=" && op != "-=" && op != "*=" && op != "/=")) continue;
            set_level(u, i, set);
            chosen = true;
        }
        if (!chosen) continue;
        u.header += std::string("float ") + set + "(int n, float level) {";
        for (int n = 0; n < size; ++n)
            u.header += " if (n == " + std::to_string(n) + ") " + name + "[" + std::to_string(n) + "] = level;";
        u.header += " return level; }\n";
    }
}

}  // namespace snell::glsl
