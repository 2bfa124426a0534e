// The parts of completion, hover and signature help: for a scene, and for a shader.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/language/names/links.h"
#include "src/language/services.h"

namespace snell::language {

std::vector<Completion> scene_completions(Texts& texts, FileId file, std::uint32_t offset);
std::vector<Completion> shader_completions(Texts& texts, FileId file, std::uint32_t offset);
std::optional<Hover> scene_hover(Texts& texts, FileId file, std::uint32_t offset);
std::optional<Hover> shader_hover(Texts& texts, FileId file, std::uint32_t offset);
std::optional<SignatureHelp> scene_signature(Texts& texts, FileId file, std::uint32_t offset);
std::optional<SignatureHelp> shader_signature(Texts& texts, FileId file, std::uint32_t offset);

struct UniformFact {
    std::string_view name, type;
    FileId file = 0;
    std::uint32_t offset = 0;  // of its name in the declaration
    std::string_view initial;  // its initialiser
    std::string comment;       // of its author
    bool array = false;
};

// Of names with blanks: as they are, in quotes, or within quotes whose end is written already.
enum class Quotes : std::uint8_t { never, added, closed };
// An offer that is written as it is shown.
inline Completion& add_offer(std::vector<Completion>& offers, std::string_view label, Completion::Kind kind,
                             Span replaced, std::string detail, std::string documentation = {}) {
    std::string text(label);
    return offers.emplace_back(Completion{text, kind, std::move(detail), std::move(documentation), replaced, text});
}

// The files and folders next to the file `path` whose names begin with `written`; `extensions` without their points.
std::vector<Completion> file_completions(std::string_view path, std::string_view written, Span replaced,
                                         std::span<const std::string_view> extensions, Quotes quotes);

// "Rotate angle x=0 y=0 z=0": an alternative with its parameters.
Signature command_signature(const Command& command, std::size_t alternative);
// A word for the kind of the argument, and its default: "number, default 1".
std::string parameter_text(const Parameter& parameter);
// The documentation of the command as Markdown.
std::string command_text(const Command& command);

// The declaration of a uniform, and what its author says of it.
std::string uniform_text(Texts& texts, const UniformFact& fact);
// "The uniform is set by program 'Glass' (scene.glib:12): <0. .2 1.>", a line for each program.
std::string where_set(Texts& texts, std::string_view uniform, const std::vector<Index>& programs);
// A ladder with its rungs, the current one in angle brackets.
std::string ladder_text(const Ladder& ladder);
// A declaration as it is written, without its initialiser.
std::string declaration_text(const Outline& outline, const ShaderDeclaration& declaration);

// "fresnel.frag:12", for documentation.
std::string place_text(Texts& texts, FileId file, std::uint32_t offset);

// The members of the expression before a point, and the types of names.

struct MemberOffer {
    std::string name, type;
    int rank = 1;
};
// `point`: the number of the token that is the point.
std::vector<MemberOffer> members_before(Texts& texts, FileId file, std::size_t point, Stage stage);

// The type of the variable or member that the token names, without dimensions; empty if it is not known.
std::string type_of_name(Texts& texts, FileId file, std::size_t token, Stage stage, int depth = 0);

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
