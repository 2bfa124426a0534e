// What OpenGL ES does not pass between the vertex and the fragment shader is passed as numbers, four to a vector:
// arrays of arrays, structures that contain arrays or structures, and what is interpolated on the screen
// (`noperspective`). The latter is multiplied by w, which the interpolation divides by, and then by 1 / w of the
// fragment's own place.
#include <array>

#include "parser/text/ranges.h"
#include "src/glsl/forms/fusion.h"

namespace snell::glsl {

namespace {

bool on_screen(const Global& g) { return g.qualifiers.interpolation == "noperspective"; }

bool nested(const Unit& u, const Type& type) {
    return type.structure >= 0 && ranges::any_of(u.structure(type).members, [](const Member& m) {
               return m.type.dims > 0 || m.type.structure >= 0;
           });
}

// Arrays of arrays, apart from the array of the vertices of a primitive.
bool nested(const Unit& u, const Global& g) {
    const bool in = g.qualifiers.storage == Storage::in, control = u.stage == Stage::tess_control;
    const bool each = control || (in && (u.stage == Stage::geometry || u.stage == Stage::tess_evaluation));
    return nested(u, g.type) || g.type.dims > (each && g.qualifiers.auxiliary != "patch" ? 2 : 1);
}

bool passes_nested(const Unit& u) {
    const auto passed = [](const Qualifiers& q) { return q.storage == Storage::in || q.storage == Storage::out; };
    return ranges::any_of(u.globals, [&](const Global& g) { return passed(g.qualifiers) && nested(u, g); }) ||
           ranges::any_of(u.blocks, [&](const Block& b) {
               return passed(b.qualifiers) &&
                      ranges::any_of(b.members, [&](const Member& m) { return nested(u, m.type); });
           });
}

class NumbersForm : Fusion {
public:
    NumbersForm(Program& program, Translation& translation) : Fusion(program, translation) {}

    void run() {
        reference_ = program_.units.back().reference;
        std::vector<Unit>& units = take_both();
        if (!ok_) return;
        Unit &vertex = units.front(), &fragment = units.back();
        const std::vector<Port> given = ports(vertex, Storage::out);
        for (Global& g : fragment.globals)
            if (g.qualifiers.storage == Storage::in && lacking(fragment, g)) pass(vertex, fragment, g, given);
        for (Global& g : vertex.globals)
            if (g.qualifiers.storage == Storage::out && lacking(vertex, g)) make_plain(vertex, g, 0);
        for (Unit& u : units) write_declarations(quiet_program_, u);
        put_both();
    }

private:
    static bool lacking(const Unit& u, const Global& g) { return !g.removed && (on_screen(g) || nested(u, g)); }

    void pass(Unit& vertex, Unit& fragment, Global& g, const std::vector<Port>& given) {
        const std::string name(g.name), location(g.qualifiers.layout_value("location"));
        const Port* const from = port_of(given, {name, {}, {}, location, g.type, false});
        std::string declared;
        const std::string give = from ? pass_as_numbers(fragment, g, from->name, declared) : "";
        if (give.empty()) return fail("'" + name + "' is of a type that OpenGL ES does not hand on");
        vertex.header += declared;
        at_main_end(vertex, give);
    }
};

}  // namespace

std::string Fusion::pass_as_numbers(Unit& fragment, Global& g, const std::string& from, std::string& declared) {
    const std::string name(fragment.now(g.name_token)), slots = "snell_Pass_" + name;
    std::vector<Number> numbers;
    Type element = g.type;
    std::vector<std::string> indices{""};
    if (g.type.dims > 1) {
        element.dims = 0;
        indices = indices_of(fragment, g.dims);
    }
    for (const std::string& index : indices)
        if (!add_numbers(fragment, element, from + index, name + index, numbers)) return {};
    if (numbers.empty()) return {};
    const bool flat = g.qualifiers.interpolation == "flat", screen = on_screen(g), one = numbers.size() <= 4;
    std::string give, take;
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        const auto& [gives, takes, base] = numbers[n];
        const std::string component = numbers.size() > 1 ? std::string(".") + "xyzw"[n % 4] : "";
        const std::string slot = slots + (one ? "" : "[" + std::to_string(n / 4) + "]") + component;
        const std::string to_bits = base == Base::real ? "floatBitsToUint(" : "uint(";
        const std::string from_bits = base == Base::real      ? "uintBitsToFloat("
                                      : base == Base::integer ? "int("
                                                              : "uint(";
        give += slot + " = " + (flat ? to_bits + gives + ")" : gives + (screen ? " * gl_Position.w" : "")) + "; ";
        take += takes + " = " + (flat ? from_bits + slot + ")" : slot + (screen ? " * gl_FragCoord.w" : "")) + "; ";
    }
    constexpr std::array reals{"float", "vec2", "vec3", "vec4"}, wholes{"uint", "uvec2", "uvec3", "uvec4"};
    const std::size_t size = std::min<std::size_t>(numbers.size(), 4) - 1;
    const std::string type = "highp " + std::string((flat ? wholes : reals)[size]) + " " + slots +
                             (one ? "" : "[" + std::to_string((numbers.size() + 3) / 4) + "]") + ";\n";
    const std::string how = flat ? "flat " : std::string(g.qualifiers.auxiliary) + " ";
    declared += how + "out " + type;
    fragment.header += how + "in " + type;
    at_main_start(fragment, take);
    make_plain(fragment, g, 0);
    return give;
}

bool passes_numbers(const Program& program) {
    return program.target().es && ranges::any_of(program.units, [](const Unit& u) {
               return mentions(u, "noperspective") || passes_nested(u);
           });
}

void pass_numbers(Program& program, Translation& translation) { NumbersForm(program, translation).run(); }

}  // namespace snell::glsl
