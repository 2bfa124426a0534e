// make_environments FOLDER: renders the cube maps of the example scenes into FOLDER.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "src/content/image.h"
#include "tools/environments/faces.h"
#include "tools/environments/panorama.h"
#include "tools/environments/room.h"
#include "tools/environments/sky.h"

namespace snell::environments {
namespace {

content::Image as_image(const Face& face) {
    content::Image image;
    image.width = image.height = face.size;
    image.channels = 3;
    image.pixels.reserve(face.rgb.size());
    for (const std::uint8_t byte : face.rgb) image.pixels.push_back(std::byte{byte});
    return image;
}

// False, with a message: the file could not be written.
bool write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream out(path, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (out.flush()) return true;
    std::fprintf(stderr, "make_environments: cannot write %s\n", path.c_str());
    return false;
}

bool write_png(const std::filesystem::path& path, const Face& face) {
    const std::string problem = content::write_image(path.string(), as_image(face));
    if (problem.empty()) return true;
    std::fprintf(stderr, "make_environments: %s\n", problem.c_str());
    return false;
}

int make(const std::filesystem::path& folder) {
    constexpr int size = 256, samples = 3;
    std::error_code ignored;  // a folder that can't be made shows when its files can't be written
    std::filesystem::create_directories(folder / "room", ignored);
    std::filesystem::create_directories(folder / "sky", ignored);
    const Room around;
    const Faces room = render_faces(around, size, samples), sky = render_faces(sky_radiance, size, samples);
    if (!write_bytes(folder / "room.hdr", encode_hdr(render_panorama(around, 2 * size, samples - 1)))) return 1;
    for (std::size_t i = 0; i < 6; ++i) {
        const std::string name(face_names[i]);
        if (!write_bytes(folder / "room" / (name + ".bmp"), encode_bmp(room[i]))) return 1;
        if (!write_png(folder / "sky" / (name + ".png"), sky[i])) return 1;
    }
    return 0;
}

}  // namespace
}  // namespace snell::environments

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(
            stderr,
            "usage: make_environments FOLDER   (writes FOLDER/room.hdr, FOLDER/room/*.bmp and FOLDER/sky/*.png)\n");
        return 2;
    }
    return snell::environments::make(argv[1]);
}
