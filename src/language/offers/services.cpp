// What depends on whether the text is a scene or a shader.
#include "src/language/services.h"
#include "src/language/offers/offers.h"

namespace snell::language {

std::vector<Completion> completions(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    return texts.is_scene(file) ? scene_completions(texts, file, offset) : shader_completions(texts, file, offset);
}

std::optional<Hover> hover(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    return texts.is_scene(file) ? scene_hover(texts, file, offset) : shader_hover(texts, file, offset);
}

std::optional<SignatureHelp> signature_help(const Project& project, FileId file, std::uint32_t offset) {
    Texts texts(project);
    return texts.is_scene(file) ? scene_signature(texts, file, offset) : shader_signature(texts, file, offset);
}

}  // namespace snell::language
