// The built-in variables of every GLSL: which stand in a core profile, and what stands for the others.
#pragma once

#include <string_view>

#include "src/glsl/read/token.h"

namespace snell::glsl {

enum class LegacyKind : std::uint8_t {
    core,           // stays
    uniform,        // becomes `uniform TYPE snell_…`
    attribute,      // becomes `in TYPE snell_…` of the vertex shader
    varying,        // written by gl_Front…, read by the stage after
    color,          // gl_FragColor, gl_FragData
    limit,          // gl_Max…: a number
    per_vertex_in,  // gl_PositionIn and friends
    ignored,        // gl_ClipVertex: a variable that nothing reads
};

struct LegacyName {
    std::string_view name;
    LegacyKind kind;
    std::string_view type;           // of an element
    int size = 0;                    // of an array; 0: no array
    std::string_view struct_text{};  // declaration of the type, where it is a structure
};

// The structure types of the language's own variables: gl_LightSourceParameters and the like. Empty for others.
std::string_view legacy_struct_text(std::string_view gl_type);

const LegacyName* legacy_name(std::string_view name);

// glman put gstap.h ahead of every shader: uModelViewMatrix, aVertex and so on mean built-in variables where nothing
// of that name is declared, the attributes in the vertex stage alone. Empty for other names.
std::string_view gstap_meaning(std::string_view name, Stage stage);
// The name of gstap.h for a built-in variable; empty where it has none.
std::string_view gstap_name(std::string_view gl_name);

}  // namespace snell::glsl
