// What depends on whether the text is a scene or a shader.
#include "src/language/services.h"
#include <algorithm>

#include "src/language/offers/offers.h"

namespace snell::language {

namespace {

// Editors may ask about a text that is no longer as long.
std::uint32_t within(const Project& project, FileId file, std::uint32_t offset) {
    return std::min(offset, static_cast<std::uint32_t>(project.sources.text(file).size()));
}

}  // namespace

std::vector<Completion> completions(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    offset = within(project, file, offset);
    return texts.is_scene(file) ? scene_completions(texts, file, offset) : shader_completions(texts, file, offset);
}

std::optional<Hover> hover(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    offset = within(project, file, offset);
    return texts.is_scene(file) ? scene_hover(texts, file, offset) : shader_hover(texts, file, offset);
}

std::optional<SignatureHelp> signature_help(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    offset = within(project, file, offset);
    return texts.is_scene(file) ? scene_signature(texts, file, offset) : shader_signature(texts, file, offset);
}

}  // namespace snell::language
