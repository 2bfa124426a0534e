// The words of GLSL: types, keywords, reserved words, built-in functions.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "src/glsl/read/token.h"

namespace snell::glsl {

// A built-in type (float, vec3, sampler2D …), also those of one vendor's dialect that have an equal.
std::optional<Type> builtin_type(std::string_view name);
// vec3 of (real, 3, 1); mat3x4; empty for what has no name.
std::string_view type_name(Base base, int rows, int cols);
Type make_type(Base base, int rows = 1, int cols = 1);

// Of a selection of components, such as xyw.
bool has_alpha(std::string_view selection);
// Words that qualify a declaration, in any version.
bool is_qualifier(std::string_view word);
// Words that no version allows as a name (if, for, return …), types excepted.
bool is_statement_word(std::string_view word);
// Words that some version reserves and an older one, or a forgiving driver, lets stand as a name.
bool is_reserved_word(std::string_view word);
// A keyword, type or built-in function: a macro of this name would change what we write.
bool is_language_word(std::string_view word);

// "vertex", "tessellation control" …, for messages.
std::string_view stage_name(Stage stage);

// How tightly an operator of two operands binds, from 1 for || to 11 for *; 0 for other words.
int precedence(std::string_view op);
// = += *= and their like.
bool assigns(std::string_view op);

// The type of GLSL for one of Cg or HLSL: float3, half4, float4x4 …; empty for others.
std::string_view foreign_type(std::string_view name);

// What a legacy texture function is called now: texture2D → texture, shadow2DLod → textureLod …; empty for others.
// The functions that begin with `shadow` gave a vec4 where the new ones give a float.
std::string_view modern_texture_function(std::string_view name);

struct BuiltinFunction {
    std::string_view name;
    std::string_view signatures;  // see builtins.cpp
    std::string_view parameters;  // their names, such as "x, y, a"
    std::string_view doc;         // what it does, for editors
};
std::span<const BuiltinFunction> builtin_functions();
// Null for other names.
const BuiltinFunction* builtin_function(std::string_view name);
// The overloads of a built-in function, as text: "F:FF F:Ff" (see builtins.cpp); empty for others.
std::string_view builtin_signatures(std::string_view name);

// The zero of a type that is not a structure, as text.
std::string zero(const Type& type);
// The zero of any type, as a constructor; empty if it has none: nameless structures, samplers, arrays of unknown size,
// and types of more than 64 values.
std::string zero_of(std::span<const Struct> structs, const Type& type);

// The built-in variables of every GLSL: which stand in a core profile, and what stands for the others.

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
