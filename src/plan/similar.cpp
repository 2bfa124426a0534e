#include "src/plan/similar.h"

#include <span>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell {

namespace {

std::string_view extension_of(std::string_view file) {
    const std::size_t dot = file.rfind('.');
    return dot == std::string_view::npos || dot == 0 ? std::string_view() : file.substr(dot + 1);
}

bool among(std::string_view word, std::span<const std::string_view> words) {
    return ranges::any_of(words, [&](std::string_view other) { return same_word(word, other); });
}

// Extensions that tell what a file is.
constexpr std::string_view telling[] = {"glib", "vert", "vs",  "tcs", "tes", "geom", "gs",  "frag", "fs",
                                        "obj",  "shp",  "bmp", "png", "jpg", "tex",  "mtl", "hdr",  "exr"};

std::string_view without_extension(std::string_view file) {
    const std::string_view extension = extension_of(file);
    return extension.empty() ? file : file.substr(0, file.size() - extension.size() - 1);
}

// "light" of light.vert.glsl.
std::string_view stem_of(std::string_view file) {
    const std::string_view stem = without_extension(file);
    return among(extension_of(stem), telling) ? without_extension(stem) : stem;
}

}  // namespace

bool same_kind(std::string_view file, std::string_view asked, const std::vector<std::string_view>& extensions) {
    const std::string_view extension = extension_of(file), inner = extension_of(without_extension(file));
    if (extensions.empty()) return !same_word(extension, "glib");
    if (!among(extension, extensions)) return same_word(extension, extension_of(asked)) && !among(extension, telling);
    return !among(inner, telling) || among(inner, extensions);  // light.vert.glsl is no fragment shader
}

std::string_view nearest_file(std::string_view asked, const std::vector<std::string_view>& files) {
    const std::string_view stem = stem_of(asked);
    const auto alike = [&](std::string_view file) { return same_word(stem_of(file), stem); };
    if (const auto same = ranges::find_if(files, alike); same != files.end()) return *same;
    std::vector<std::string_view> stems(files.size());
    ranges::transform(files, stems.begin(), stem_of);
    const std::string_view near = nearest(stem, stems);
    const std::size_t most = stem.size() <= 4 ? 1 : stem.size() <= 8 ? 2 : 3;
    if (near.empty() || edit_distance(stem, near) > static_cast<int>(most)) return {};
    const auto has_extension = [&](std::string_view extension) {
        return ranges::find_if(files, [&](std::string_view file) {
            return stem_of(file) == near && (extension.empty() || same_word(extension_of(file), extension));
        });
    };
    const auto same = has_extension(extension_of(asked));
    return same != files.end() ? *same : *has_extension({});
}

}  // namespace snell
