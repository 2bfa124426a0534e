// Scenes and linked programs from values, and the codes of what is said of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/plan/values/controls.h"

namespace snell {

inline UniformValue value_of(std::string name, UniformValue::Kind kind, std::vector<double> values) {
    UniformValue value;
    value.name = std::move(name);
    value.kind = kind;
    value.values = std::move(values);
    value.span = {0, 10, 20};
    value.name_span = {0, 10, 14};
    return value;
}

struct ProgramLine {
    std::string name;
    std::vector<UniformValue> uniforms;
};

inline Scene scene_with(std::vector<ProgramLine> lines) {
    Scene scene;
    for (ProgramLine& line : lines) {
        Program program;
        program.name = std::move(line.name);
        program.uniforms = std::move(line.uniforms);
        scene.programs.push_back(std::move(program));
    }
    return scene;
}

// A uniform of a GLSL type, as linking reports it.
inline ActiveUniform active(std::string_view type, int array = 1) {
    ActiveUniform uniform;
    uniform.glsl_type = type;
    uniform.array_size = array;
    const auto digit = [&](std::size_t from_end) { return type[type.size() - from_end] - '0'; };
    if (type.starts_with("sampler")) {
        uniform.type = ValueType::sampler;
    } else if (type.find("mat") != std::string_view::npos) {
        uniform.type = ValueType::matrix;
        uniform.components = type.find('x') == std::string_view::npos ? digit(1) * digit(1) : digit(1) * digit(3);
    } else {
        if (type.find("vec") != std::string_view::npos) uniform.components = digit(1);
        uniform.type = type == "int" || type[0] == 'i'      ? ValueType::int_
                       : type == "uint" || type[0] == 'u'   ? ValueType::uint_
                       : type == "bool" || type[0] == 'b'   ? ValueType::bool_
                       : type == "double" || type[0] == 'd' ? ValueType::double_
                                                            : ValueType::float_;
    }
    return uniform;
}

using Codes = std::vector<std::string>;

inline Codes codes_of(const Diagnostics& diagnostics) {
    Codes codes;
    for (const Diagnostic& diagnostic : diagnostics.items()) codes.push_back(diagnostic.code);
    return codes;
}

}  // namespace snell
