// What editors ask of a scene and its shaders. All take any text, however broken, and any offset; files are those of
// Project::file_of, and spans lie within their texts. Nothing is read but the folder whose files are offered.
#pragma once

#include <optional>
#include <string_view>

#include "src/language/answers.h"
#include "src/language/project.h"

namespace snell::language {

std::vector<Completion> completions(const Project& project, FileId file, std::uint32_t offset);
std::optional<Hover> hover(const Project& project, FileId file, std::uint32_t offset);
std::optional<SignatureHelp> signature_help(const Project& project, FileId file, std::uint32_t offset);

// The declarations of the name at `offset`; for the name of a file in a statement, the start of that file.
std::vector<Span> definition(const Project& project, FileId file, std::uint32_t offset);
// Every place that names the same, in all files of the project, sorted.
std::vector<Span> references(const Project& project, FileId file, std::uint32_t offset, bool declarations = true);
Renaming renaming(const Project& project, FileId file, std::uint32_t offset);
// Renames what is at `offset`. Afterwards the scene draws the same picture.
Rename rename(const Project& project, FileId file, std::uint32_t offset, std::string_view name);

std::vector<Symbol> symbols(const Project& project, FileId file);
std::vector<Color> colors(const Project& project, FileId file);
// The edits that make the color at `span`, one of colors(), another one, in the author's style of numbers.
std::vector<Edit> color_edits(const Project& project, const Span& span, const std::array<double, 4>& rgba);

}  // namespace snell::language
