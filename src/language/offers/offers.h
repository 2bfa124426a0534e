// The parts of completion, hover and signature help: for a scene, and for a shader.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/language/answers.h"
#include "src/language/offers/uniforms.h"

namespace snell::language {

std::vector<Completion> scene_completions(Texts& texts, FileId file, std::uint32_t offset);
std::vector<Completion> shader_completions(Texts& texts, FileId file, std::uint32_t offset);
std::optional<Hover> scene_hover(Texts& texts, FileId file, std::uint32_t offset);
std::optional<Hover> shader_hover(Texts& texts, FileId file, std::uint32_t offset);
std::optional<SignatureHelp> scene_signature(Texts& texts, FileId file, std::uint32_t offset);
std::optional<SignatureHelp> shader_signature(Texts& texts, FileId file, std::uint32_t offset);

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

}  // namespace snell::language
