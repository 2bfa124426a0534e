// What shaders declare and scenes set: the uniforms of a program, and the values that a scene may begin with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/language/names/links.h"

namespace snell::language {

struct UniformFact {
    std::string_view name, type;
    FileId file = 0;
    std::uint32_t offset = 0;  // of its name in the declaration
    std::string_view initial;  // its initialiser
    std::string comment;       // of its author
    bool array = false;
};
// The uniforms that the shaders of a program declare and snell does not set, each once.
std::vector<UniformFact> declared_uniforms(Texts& texts, Index program);

// The comment on the line of a declaration, or on the lines above it; empty if there is none.
std::string comment_of(const Outline& outline, std::uint32_t begin, std::uint32_t end);

// A value for a Program statement. `numbers` are the parts that an author wants to change.
struct ProposedValue {
    std::string before, after;         // brackets
    std::vector<std::string> numbers;  // between them
    std::vector<std::string> choices;  // of a value of one number, such as texture units; empty: no choice

    std::string text() const;
    std::string snippet(int& placeholder) const;
};
// Goes by the type, the initialiser and the words of the name: uKa <0. .2 1.>, uEta <.1 1.1 5.>, {.8 .8 .8 1.}.
ProposedValue proposed_value(const Scene& scene, const UniformFact& uniform);

// The type that a shader would probably declare for the value.
std::string guessed_type(const Scene& scene, const UniformValue& value);

// Set by snell if it is declared with this type.
bool set_by_system(std::string_view name, std::string_view type);

}  // namespace snell::language
