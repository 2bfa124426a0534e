// What is known of variables by their names: matrices, attributes, varyings, what the scene sets.
#include <algorithm>

#include "src/glsl/read/words.h"
#include "src/lint/walker.h"

namespace snell::lint {

using glsl::Base;
using glsl::Storage;
using glsl::System;

namespace {

struct SystemSpaces {
    System system;
    Space from, to;
};
constexpr SystemSpaces matrix_spaces[] = {
    {System::model_view, Space::object, Space::eye},
    {System::normal_matrix, Space::object, Space::eye},
    {System::model_view_inverse, Space::eye, Space::object},
    {System::model_view_inverse_transpose, Space::object, Space::eye},
    {System::model_view_transpose, Space::eye, Space::object},
    {System::model, Space::object, Space::world},
    {System::model_inverse, Space::world, Space::object},
    {System::model_normal_matrix, Space::object, Space::world},
    {System::model_viewer, Space::object, Space::world},
    {System::view, Space::world, Space::eye},
    {System::view_inverse, Space::eye, Space::world},
};

// gl_ModelViewMatrix is the translation's snell_ModelViewMatrix.
std::optional<System> system_of(std::string_view name) {
    static const std::vector<glsl::SystemName> names = glsl::system_names();
    const std::string translated = name.starts_with("gl_") ? "snell_" + std::string(name.substr(3)) : std::string(name);
    for (const glsl::SystemName& n : names)
        if (n.name == translated) return n.system;
    return std::nullopt;
}

Value of_system(System system) {
    Value v;
    v.varies = Varies::no;
    for (const SystemSpaces& m : matrix_spaces)
        if (m.system == system) v.from = m.from, v.to = m.to;
    if (system == System::camera_position || system == System::viewer_position_eye) {
        v.space = system == System::camera_position ? Space::world : Space::eye;
        v.point = v.plain = true;
        v.length = Length::other;
        v.why = Why::position;
    }
    return v;
}

Value of_attribute(glsl::Attribute attribute) {
    Value v;
    v.plain = true;
    v.varies = Varies::yes;
    if (attribute == glsl::Attribute::vertex) {
        v.space = Space::object;
        v.point = true;
        v.length = Length::other;
        v.why = Why::position;
    } else if (attribute == glsl::Attribute::normal || attribute == glsl::Attribute::tangent) {
        v.space = Space::object;
        v.length = Length::unit;
    } else if (attribute == glsl::Attribute::texcoord) {
        v.range = between(0, 1);
    }
    return v;
}

std::optional<glsl::Attribute> attribute_of(std::string_view name, const glsl::Qualifiers* qualifiers) {
    if (qualifiers)
        for (const glsl::LayoutItem& item : qualifiers->layout)
            if (item.name == "location" && (item.value == "0" || item.value == "1"))
                return static_cast<glsl::Attribute>(item.value[0] - '0');
    static const std::vector<glsl::AttributeName> names = glsl::attribute_names();
    for (const glsl::AttributeName& n : names)
        if (n.name == name) return n.attribute;
    return std::nullopt;
}

// Between the vertices a varying is a weighted mean: bounds and spaces stay, lengths don't.
Value interpolated(Value v, const glsl::Global& g) {
    v.name = g.name;
    v.id = v.opposite = v.mirrored = v.mirrored_opposite = 0;
    v.uniform = -1;
    v.cosine = v.one_plus = {};
    v.eta = v.bend = {};
    v.plain = true;
    v.varies = Varies::yes;
    if (g.qualifiers.interpolation != "flat" && g.type.rows >= 3 && g.type.cols == 1) {
        v.length = Length::other;
        v.why = Why::interpolated;
    }
    return v;
}

}  // namespace

Value Walker::seed(const glsl::Global& g) const {
    Value v;
    const bool input = g.qualifiers.storage == Storage::in;
    if (input && u_.stage == Stage::vertex) {
        if (const auto attribute = attribute_of(g.name, &g.qualifiers)) v = of_attribute(*attribute);
        v.name = g.name;
    } else if (input && u_.stage == Stage::fragment && g.type.dims == 0) {
        const auto found = given_ ? given_->find(g.name) : Varyings::const_iterator{};
        v = interpolated(given_ && found != given_->end() ? found->second : Value{}, g);
    } else if (g.qualifiers.storage == Storage::uniform && g.type.dims == 0) {
        const auto set = around_.uniforms.find(g.name);
        const auto system = set == around_.uniforms.end() ? system_of(g.name) : std::nullopt;
        if (system) v = of_system(*system);
        if (set != around_.uniforms.end()) v.range = set->second.range;
        if (set == around_.uniforms.end() && g.value.size() == 1) v.range = exactly(g.value[0]);
        v.uniform = static_cast<int>(&g - u_.globals.data());
        v.plain = true;
        v.varies = Varies::no;
    }
    v.type = g.type;
    return v;
}

Value Walker::built_in(std::string_view name) const {
    Value v;
    if (!name.starts_with("gl_")) {
        if (name == "true" || name == "false") v.varies = Varies::no;
        return v;
    }
    const auto type = [](std::string_view t) { return *glsl::builtin_type(t); };
    const std::string translated = "snell_" + std::string(name.substr(3));
    if (const auto system = system_of(name)) {
        v = of_system(*system);
        v.type = type(*system == System::normal_matrix ? "mat3" : "mat4");
    } else if (const auto attribute = attribute_of(translated, nullptr); attribute && u_.stage == Stage::vertex) {
        v = of_attribute(*attribute);
        v.type = type(name == "gl_Normal" ? "vec3" : "vec4");
        v.name = name;
    } else if (u_.stage == Stage::fragment) {
        v.varies = name.starts_with("gl_Max") ? Varies::no : Varies::yes;
        if (name == "gl_FragCoord" || name == "gl_Color") v.type = type("vec4");
    }
    return v;
}

}  // namespace snell::lint
