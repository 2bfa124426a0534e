#include "src/runtime/explain/words.h"

#include <fmt/format.h>

#include <array>

namespace snell::runtime {

using Kind = Explanation::Kind;

namespace {

std::string_view last_part(std::string_view path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

std::string statement_of(const Texture& texture) {
    constexpr std::array<std::string_view, 4> targets{"Texture1D", "Texture2D", "Texture3D", "CubeMap"};
    constexpr std::array<std::string_view, 3> computed{"", "Irradiance", "Prefilter"};
    const bool made = texture.computed != Computed::no;
    return fmt::format(
        "{} {}",
        made ? computed[static_cast<std::size_t>(texture.computed)] : targets[static_cast<std::size_t>(texture.target)],
        texture.unit);
}

Explanation::Kind kind_of(const Texture& texture) {
    return texture.computed != Computed::no        ? Kind::computed
           : texture.files.empty()                 ? Kind::empty_texture
           : texture.target == TextureTarget::cube ? Kind::cube_map
                                                   : Kind::image;
}

std::string title_of(const Texture& texture) {
    const std::string_view file = texture.files.empty() ? "" : last_part(texture.files[0].name);
    return fmt::format("{}{}{}", statement_of(texture), file.empty() ? "" : " ", file);
}

std::string name_of(const Pass& pass) {
    return std::array{"window", "RenderToTexture", "RenderToCube"}[static_cast<std::size_t>(pass.kind)];
}

std::string plural(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : what.ends_with('s') ? "es" : "s");
}

}  // namespace snell::runtime
