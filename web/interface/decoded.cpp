#include "web/interface/decoded.h"

#include "src/content/image/image.h"
#include "web/interface/open_scene.h"

namespace snell::web {

std::vector<std::byte> decoded(const std::string& name, std::string_view bytes, std::string& error) {
    const content::ImageResult result =
        content::decode_image(name, bytes, {.bytes = page_access({}).limits.texture_bytes});
    if (result.image) return content::decoded_file(*result.image);
    error = result.issues.empty() ? "cannot be decoded" : result.issues.front().message;
    return {};
}

}  // namespace snell::web
