// How the functions of GLSL are declared.
#include "parser/text/words.h"
#include "src/glsl/read/words.h"
#include "src/language/shader/builtins.h"

namespace snell::language {

namespace {

constexpr std::string_view legacy_functions =
    "texture1D texture2D texture3D textureCube texture1DProj texture2DProj texture3DProj texture1DLod texture2DLod "
    "texture3DLod textureCubeLod texture2DProjLod texture2DRect shadow1D shadow2D shadow2DProj";

// A character of a signature, see src/glsl/read/builtins.cpp.
std::string_view type_of(char code, bool result) {
    constexpr std::pair<char, std::string_view> types[] = {
        {'F', "genType"}, {'I', "genIType"}, {'U', "genUType"}, {'B', "genBType"}, {'f', "float"},
        {'i', "int"},     {'u', "uint"},     {'b', "bool"},     {'2', "vec2"},     {'3', "vec3"},
        {'4', "vec4"},    {'n', "ivec2"},    {'m', "ivec3"},    {'M', "mat"},      {'S', "sampler"},
        {'C', "vec"},     {'J', "ivec"},     {'T', "vec4"},     {'Z', "ivec"}};
    for (const auto& [letter, name] : types)
        if (letter == code) return name;
    return result ? "void" : "value";
}

std::string declared(std::string_view name, std::string_view overload, std::string_view parameters) {
    const bool matrix = overload.starts_with("X:M") || overload.starts_with("X:C");
    std::string text(matrix ? "mat" : type_of(overload.front(), true));
    text += " " + std::string(name) + "(";
    bool first = true, optional = false;
    for (const char code : overload.substr(2)) {
        if (code == '[') {
            optional = true;
            continue;
        }
        const std::size_t comma = parameters.find(", ");
        const std::string_view parameter = parameters.substr(0, comma);
        parameters = comma == std::string_view::npos ? std::string_view() : parameters.substr(comma + 2);
        if (optional) text += first ? "[" : " [";
        text += (first ? "" : ", ") + std::string(type_of(code, false)) + " " + std::string(parameter);
        if (optional) text += "]";
        first = false;
    }
    return text + ")";
}

}  // namespace

const glsl::BuiltinFunction* function_doc(std::string_view name) {
    const glsl::BuiltinFunction* found = glsl::builtin_function(name);
    return found ? found : glsl::builtin_function(glsl::modern_texture_function(name));
}

std::vector<std::string> function_signatures(std::string_view name) {
    const glsl::BuiltinFunction* doc = function_doc(name);
    std::vector<std::string> all;
    if (doc == nullptr) return all;
    for (const std::string_view overload : split(doc->signatures)) {
        // Of atan, one overload has another first parameter.
        const bool one = name == "atan" && overload.size() == 3;
        all.push_back(declared(name, overload, one ? "y_over_x" : doc->parameters));
    }
    return all;
}

std::vector<std::string_view> function_names(bool legacy) {
    std::vector<std::string_view> names;
    for (const glsl::BuiltinFunction& function : glsl::builtin_functions()) names.push_back(function.name);
    if (legacy)
        for (const std::string_view name : split(legacy_functions)) names.push_back(name);
    return names;
}

}  // namespace snell::language
