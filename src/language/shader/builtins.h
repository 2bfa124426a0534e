// What GLSL and snell provide, with their documentation, for editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "src/glsl/read/words.h"

namespace snell::language {

// ---- functions

// Null for other names. Of texture2D and the like: that of `texture`.
const glsl::BuiltinFunction* function_doc(std::string_view name);
// The overloads as they are declared, such as "genType refract(genType I, genType N, float eta)"; empty for others.
std::vector<std::string> function_signatures(std::string_view name);
// All that are offered in a dialect; `legacy`: also texture2D and the like.
std::vector<std::string_view> function_names(bool legacy);
// What genType means, for documentation that names it.
inline constexpr std::string_view generic_types =
    "`genType` is `float` or a vector of them; `genIType`, `genUType` and `genBType` are the same of `int`, `uint` and "
    "`bool`. All of one call have the same size.";

// ---- variables

struct VariableDoc {
    std::string name, type;
    std::string doc;         // Markdown
    bool legacy = false;     // not in core profiles
    bool undeclared = true;  // needs no declaration; otherwise `qualifier` and type must be declared
    std::string_view qualifier = {};
};
// The variables of GLSL and the names that snell sets, as far as the stage has them. Made once for each stage.
const std::vector<VariableDoc>& variable_docs(Stage stage);
const VariableDoc* variable_doc(Stage stage, std::string_view name);

// The files of snell's library, such as "snell/fresnel.glsl".
const std::vector<std::string_view>& library_headers();

// Keywords and types.
const std::vector<std::string_view>& keywords();
const std::vector<std::string_view>& type_names();

}  // namespace snell::language
