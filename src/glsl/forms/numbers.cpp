// What OpenGL ES does not pass between the vertex and the fragment shader is passed as numbers, four to a vector:
// structures that contain arrays or structures, and what is interpolated on the screen (`noperspective`). The latter is
// multiplied by w, which the interpolation divides by, and then by 1 / w of the fragment's own place.
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

bool passes_nested(const Unit& u) {
    const auto passed = [](const Qualifiers& q) { return q.storage == Storage::in || q.storage == Storage::out; };
    return ranges::any_of(u.globals, [&](const Global& g) { return passed(g.qualifiers) && nested(u, g.type); }) ||
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
    static bool lacking(const Unit& u, const Global& g) { return !g.removed && (on_screen(g) || nested(u, g.type)); }

    // Both become variables.
    void pass(Unit& vertex, Unit& fragment, Global& g, const std::vector<Port>& given) {
        const std::string name(fragment.now(g.name_token)), slots = "snell_Pass_" + name;
        const std::string_view location = g.qualifiers.layout_value("location");
        const Port* const from = port_of(given, {name, {}, {}, std::string(location), g.type, false});
        std::vector<Number> numbers;
        if (!from || !add_numbers(fragment, g.type, from->name, name, numbers))
            return fail("'" + name + "' is of a type that OpenGL ES does not hand on");
        const bool flat = g.qualifiers.interpolation == "flat";
        const std::string type = flat ? "uvec4 " : "vec4 ";
        std::string give, take;
        for (std::size_t n = 0; n < numbers.size(); ++n) {
            const auto& [gives, takes, base] = numbers[n];
            const std::string slot = slots + "[" + std::to_string(n / 4) + "]." + "xyzw"[n % 4];
            const std::string by = on_screen(g) ? " * gl_Position.w" : "",
                              back = on_screen(g) ? " * gl_FragCoord.w" : "";
            const std::string bits = base == Base::real ? "floatBitsToUint(" : "uint(";
            const std::string from_bits = base == Base::real      ? "uintBitsToFloat("
                                          : base == Base::integer ? "int("
                                                                  : "uint(";
            give += slot + " = " + (flat ? bits + gives + ")" : gives + by) + "; ";
            take += takes + " = " + (flat ? from_bits + slot + ")" : slot + back) + "; ";
        }
        const std::string size = slots + "[" + std::to_string((numbers.size() + 3) / 4) + "];\n";
        const std::string how = flat ? "flat " : std::string(g.qualifiers.auxiliary) + " ";
        vertex.header += how + "out highp " + type + size;
        fragment.header += how + "in highp " + type + size;
        at_main_end(vertex, give);
        at_main_start(fragment, take);
        make_plain(fragment, g, 0);
    }
};

}  // namespace

bool passes_numbers(const Program& program) {
    return program.target().es && ranges::any_of(program.units, [](const Unit& u) {
               return mentions(u, "noperspective") || passes_nested(u);
           });
}

void pass_numbers(Program& program, Translation& translation) { NumbersForm(program, translation).run(); }

}  // namespace snell::glsl
