// Uniforms that keep their values become constants, so that the driver leaves out what they switch off.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

template <class Real>
std::string real_text(double value, std::string_view suffix) {
    std::array<char, 64> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<Real>(value)).ptr;
    std::string text(digits.data(), end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + std::string(suffix);
}

// False for what a decimal does not give on every driver: zeros of negative sign, numbers that are too small to be
// normal, and those that are not finite.
template <class Real>
bool exact(double value) {
    const Real real = static_cast<Real>(value);
    return std::isnormal(real) || (real == 0 && !std::signbit(real));
}

// The text of one component, as the uniform would hold it; empty if there is none.
std::string component_text(Base base, double value) {
    using Int = std::numeric_limits<std::int32_t>;
    using Uint = std::numeric_limits<std::uint32_t>;
    switch (base) {
        case Base::boolean:
            return std::abs(value) >= 1 ? "true" : "false";
        case Base::integer:  // the least integer is no literal
            return value > Int::min() && value <= Int::max() ? std::to_string(static_cast<std::int32_t>(value)) : "";
        case Base::uinteger:
            return value >= 0 && value <= Uint::max() ? std::to_string(static_cast<std::uint32_t>(value)) + "u" : "";
        case Base::real:
            return std::abs(value) <= std::numeric_limits<float>::max() && exact<float>(value)
                       ? real_text<float>(value, "")
                       : "";
        case Base::dreal:
            return exact<double>(value) ? real_text<double>(value, "lf") : "";
        default:
            return "";
    }
}

std::string constant_text(const Type& type, const std::vector<double>& values) {
    if (values.size() != static_cast<std::size_t>(type.rows) * type.cols) return {};
    std::string text;
    for (const double value : values) {
        const std::string component = component_text(type.base, value);
        if (component.empty()) return {};
        text += (text.empty() ? "" : ", ") + component;
    }
    return type.scalar() ? text : std::string(type_name(type.base, type.rows, type.cols)) + "(" + text + ")";
}

std::string scene_name(const Program& program, const Global& g) {
    const auto renamed = std::ranges::find(program.renamed, g.name, &RenamedUniform::shader_name);
    return renamed == program.renamed.end() ? std::string(g.name) : renamed->name;
}

bool is_uniform(const Global& g) { return g.qualifiers.storage == Storage::uniform && !g.removed; }

DeclaredUniform described(const Program& program, const Global& g, std::string name) {
    DeclaredUniform declared;
    declared.name = std::move(name);
    declared.glsl_type = std::string(g.type.basic() ? type_name(g.type.base, g.type.rows, g.type.cols) : g.type.name);
    declared.array_size = g.type.dims > 0 ? std::max(g.type.size, 1) : 0;
    declared.simple = g.type.basic() && g.type.dims == 0 && (g.type.base != Base::dreal || program.target().fp64);
    const auto initial = std::ranges::find(program.defaults, g.name, &UniformDefault::name);
    if (initial != program.defaults.end()) declared.initial = initial->values;
    return declared;
}

void note_functions(const Unit& u, const Global& g, std::vector<std::string>& functions) {
    constexpr std::array<std::string_view, 5> stages{"vertex", "tessellation control", "tessellation evaluation",
                                                     "geometry", "fragment"};  // as Stage
    for (const Function& function : u.functions) {
        const auto within = [&](int use) { return use > function.open && use < function.close; };
        if (!std::ranges::any_of(g.uses, within)) continue;
        std::string name(function.name);
        name.append(" (").append(stages[static_cast<std::size_t>(u.stage)]).append(")");
        if (std::ranges::count(functions, name) == 0) functions.push_back(std::move(name));  // overloaded
    }
}

const Global* declaration(const Program& program, std::string_view name) {
    for (const Unit& u : program.units)
        for (const Global& g : u.globals)
            if (is_uniform(g) && scene_name(program, g) == name) return &g;
    return nullptr;
}

}  // namespace

void choose_settled(Program& program) {
    std::set<std::string> mixed;  // types differ between stages, or the initial value is not known here
    for (const Unit& u : program.units)
        for (const Global& g : u.globals) {
            if (!is_uniform(g)) continue;
            std::string name = scene_name(program, g);
            const bool known = std::ranges::count(program.defaults, g.name, &UniformDefault::name) > 0;
            if (!g.new_type.empty() || (g.init_first >= 0 && !known)) mixed.insert(name);
            auto declared = std::ranges::find(program.declared, name, &DeclaredUniform::name);
            if (declared == program.declared.end())
                declared = program.declared.insert(declared, described(program, g, std::move(name)));
            note_functions(u, g, declared->functions);
        }
    for (DeclaredUniform& declared : program.declared)
        declared.simple = declared.simple && !mixed.contains(declared.name);
    if (!program.options.settle) return;
    program.settled = program.options.settle(program.declared);
    std::erase_if(program.settled, [&](const Settled& settled) {
        const auto declared = std::ranges::find(program.declared, settled.name, &DeclaredUniform::name);
        if (declared == program.declared.end() || !declared->simple) return true;
        return constant_text(declaration(program, settled.name)->type, settled.values).empty();
    });
}

void settle_uniforms(const Program& program, Unit& u) {
    for (Global& g : u.globals) {
        if (!is_uniform(g) || program.settled.empty()) continue;
        const auto settled = std::ranges::find(program.settled, scene_name(program, g), &Settled::name);
        if (settled == program.settled.end()) continue;
        // Constants that index an array out of its bounds, or divide by zero, would be errors.
        g.qualifiers.storage = g.type.integral() ? Storage::plain : Storage::constant;
        g.qualifiers.layout.clear();
        g.qualifiers.memory.clear();
        g.qualifiers.interpolation = {};
        g.qualifiers.invariant = g.qualifiers.precise = false;
        g.initial = constant_text(g.type, settled->values);
        g.drop_init = g.dirty = true;
    }
}

}  // namespace snell::glsl
