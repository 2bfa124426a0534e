// compare REFERENCE OTHER…: a line for each PNG that the folder REFERENCE and a folder OTHER both have, with tabs:
// OTHER, the picture's path, its pixels, those that differ by more than 2 of 255 in a channel, the largest difference
// and the mean one, of 255. Pictures of different sizes differ everywhere.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "tests/oracle/compare.h"

namespace fs = std::filesystem;
using namespace snell::content;

namespace {

std::optional<Image> read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    ImageResult result = decode_image(path.string(), bytes);
    return result.image ? std::optional(to_rgba(*result.image)) : std::nullopt;
}

void print(const std::string& folder, const std::string& name, const Image& reference, const Image& other) {
    const std::size_t pixels = reference.bytes() / reference.pixel_bytes();
    // Halfway between 2 and 3, so that rounding does not decide.
    const auto difference = compare(reference, other, 2.5 / 255);
    const std::size_t over = difference ? difference->over : pixels;
    const double max = difference ? difference->max : 1;
    std::printf("%s\t%s\t%zu\t%zu\t%.0f\t%.2f\n", folder.c_str(), name.c_str(), pixels, over, std::round(max * 255),
                (difference ? difference->mean : 1) * 255);
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) {
        std::fprintf(stderr, "usage: compare REFERENCE OTHER...\n");
        return 2;
    }
    const fs::path reference = arguments[1];
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(reference))
        if (entry.path().extension() == ".png") names.insert(fs::relative(entry.path(), reference).string());
    for (const std::string& name : names) {
        const auto expected = read(reference / name);
        for (int i = 2; expected && i < count; ++i) {
            if (!fs::exists(fs::path(arguments[i]) / name)) continue;
            if (const auto found = read(fs::path(arguments[i]) / name)) print(arguments[i], name, *expected, *found);
        }
    }
}
