#include "src/plan/locate.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "parser/read/parse.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/content/cube/cubemap.h"
#include "src/content/image/noise.h"

namespace snell {
namespace {

using Extensions = std::vector<std::string_view>;

bool said(const Diagnostics& diagnostics, std::string_view code, const Span& span) {
    return ranges::any_of(diagnostics.items(), [&](const Diagnostic& d) { return d.is_at(code, span); });
}

// Scenes name one file in many statements.
// `meant`: the name to write instead; empty if it is not known.
void say(Severity severity, std::string_view code, const Span& span, std::string message, std::string help,
         Diagnostics& diagnostics, std::string_view meant = {}) {
    if (said(diagnostics, code, span)) return;
    Diagnostic diagnostic{severity, std::string(code), span, std::move(message), std::move(help), {}, true};
    if (!meant.empty()) diagnostic.fixes.push_back({span, text_of::name(meant)});
    diagnostics.add_once(std::move(diagnostic));
}

struct Missing {
    std::string name;
    Span span;
    std::string nearest = {};
};

// The missing files of one statement are one mistake; `wants`: who needs them.
void report_missing(const std::vector<Missing>& files, Diagnostics& diagnostics, std::string_view wants = {}) {
    if (files.empty() || said(diagnostics, "file-not-found", files.front().span)) return;
    Diagnostic diagnostic{Severity::error, "file-not-found", files.front().span, {}, {}, {}, true};
    for (const Missing& file : files) {
        diagnostic.message += fmt::format("{}'{}'", diagnostic.message.empty() ? "" : ", ", file.name);
        if (file.span != diagnostic.span) diagnostic.also.push_back(file.span);
        if (file.nearest.empty()) continue;
        if (diagnostic.help.empty())
            diagnostic.help = fmt::format("did you mean '{}'{}?", file.nearest, files.size() > 1 ? " and so on" : "");
        diagnostic.fixes.push_back({file.span, text_of::name(file.nearest)});
    }
    diagnostic.message =
        fmt::format("there {} {}{}", files.size() > 1 ? "are no files" : "is no file", diagnostic.message, wants);
    diagnostics.add_once(std::move(diagnostic));
}

// Names are relative to the scene that contains them, which may be an included one.
Resolved resolve(const FileName& file, std::string_view name, const Extensions& extensions, const Files& files) {
    return file.from.empty() ? files.resolve(name, extensions) : files.resolve_beside(file.from, name, extensions);
}

std::string accept(const FileName& file, const Resolved& resolved, const Files& files, Diagnostics& diagnostics) {
    if (resolved.path.empty()) {
        if (!resolved.refused.empty())
            report_unreadable(file, resolved.refused, diagnostics);
        else
            report_missing({{file.name, file.span, resolved.nearest}}, diagnostics);
    } else if (resolved.inexact) {
        say(Severity::warning, "file-inexact", file.span, inexact_name(file.name, resolved.path),
            std::string(inexact_name_help), diagnostics, written_name(resolved.path, file.from, files));
    }
    return resolved.path;
}

// The names of the six faces that one name stands for, by the naming convention for which most files exist.
std::vector<TextureFile> locate_faces(const FileName& file, const Files& files, Diagnostics& diagnostics) {
    std::vector<TextureFile> best;
    std::size_t most = 0;
    for (const auto& names : content::face_names(file.name)) {
        std::vector<TextureFile> faces;
        std::size_t found = 0;
        for (const std::string& name : names) {
            faces.push_back({name, resolve(file, name, {}, files).path, file.span});
            found += faces.back().path.empty() ? 0 : 1;
        }
        if (found > most) {
            most = found;
            best = std::move(faces);
        }
    }
    std::vector<Missing> missing;
    for (const TextureFile& face : best)
        if (face.path.empty()) missing.push_back({face.name, file.span});
    report_missing(missing, diagnostics,
                   fmt::format(" for {} of '{}'", missing.size() > 1 ? "faces" : "a face", file.name));
    return best;
}

// Whether the names are of different faces of one cube map, by a convention that has words for them.
bool other_face(std::string_view a, std::string_view b) {
    const std::string_view extension = a.substr(std::min(a.rfind('.'), a.size()));
    const auto folder_and_stem = [](std::string_view name, std::string_view face) -> std::optional<std::string_view> {
        const std::size_t rest = name.size() - std::min(name.size(), face.size());
        return same_word(name.substr(rest), face) ? std::optional(name.substr(0, rest)) : std::nullopt;
    };
    for (const auto& faces : content::face_names(extension)) {
        const char last = faces[1][faces[1].size() - extension.size() - 1];
        if (last >= '0' && last <= '9') continue;  // numbers are of other pictures, too
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (std::size_t k = 0; k < faces.size(); ++k) {
                const auto first = folder_and_stem(a, faces[i]), second = folder_and_stem(b, faces[k]);
                if (i != k && first && second && same_word(*first, *second)) return true;
            }
    }
    return false;
}

// Texels a side of the noise that a file of this name would hold; 0 for other names.
int noise_size(const Texture& texture, std::string_view name, const Files& files) {
    const bool deep = texture.target == TextureTarget::d3;
    if (!deep && texture.target != TextureTarget::d2) return 0;
    const int size = content::noise_file_size(deep ? 3 : 2, name.substr(name.find_last_of("/\\") + 1));
    const auto most = static_cast<int>(deep ? files.limits().noise_3d : files.limits().noise_2d);
    return size <= most ? size : 0;
}

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

const Extensions& stage_extensions(Stage stage) {
    static const std::array<Extensions, stage_count> all{{
        {"vert", "vs", "vsh", "vert.glsl", "vs.glsl", "glsl", "vertex"},
        {"tcs", "tesc", "tcs.glsl", "tesc.glsl", "glsl"},
        {"tes", "tese", "tes.glsl", "tese.glsl", "glsl"},
        {"geom", "gs", "gsh", "geom.glsl", "gs.glsl", "glsl"},
        {"frag", "fs", "fsh", "frag.glsl", "fs.glsl", "glsl", "fragment"},
    }};
    return all[static_cast<std::size_t>(stage)];
}

const Extensions& scene_extensions() {
    static const Extensions all{"glib", "inc"};
    return all;
}

const Extensions& mesh_extensions(const Shape& shape) {
    static const Extensions obj{"obj"}, shp{"shp"};
    return std::holds_alternative<ShpFile>(shape) ? shp : obj;
}

const Extensions& image_extensions() {
    static const Extensions all{"bmp", "tex", "png", "jpg", "jpeg", "hdr", "exr", "tif", "tiff", "tga"};
    return all;
}

bool has_extension(std::string_view path, std::string_view extension) {
    if (path.size() < extension.size() + 2) return false;
    const std::size_t dot = path.size() - extension.size() - 1;
    return path[dot] == '.' && path[dot - 1] != '/' && same_word(path.substr(dot + 1), extension);
}

bool is_shader_name(std::string_view path) {
    for (int stage = 0; stage < stage_count; ++stage)
        for (const std::string_view extension : stage_extensions(static_cast<Stage>(stage)))
            if (has_extension(path, extension)) return true;
    return false;
}

std::string written_name(const std::string& path, std::string_view from, const Files& files) {
    const std::size_t slash = from.rfind('/');
    for (std::string folder :
         {std::string(slash == std::string_view::npos ? "" : from.substr(0, slash)), files.folder()}) {
        if (folder.empty()) continue;
        if (folder.back() != '/') folder += '/';
        if (path.starts_with(folder)) return path.substr(folder.size());
    }
    return path;
}

std::string locate(const FileName& file, const Extensions& extensions, const Files& files, Diagnostics& diagnostics) {
    return accept(file, resolve(file, file.name, extensions, files), files, diagnostics);
}

void report_unreadable(const FileName& file, std::string_view reason, Diagnostics& diagnostics) {
    say(Severity::error, "file-unreadable", file.span, fmt::format("'{}' cannot be read: {}", file.name, reason), {},
        diagnostics);
}

std::vector<TextureFile> locate_texture(const Texture& texture, const Files& files, Diagnostics& diagnostics) {
    std::vector<TextureFile> result;
    if (texture.target == TextureTarget::cube && texture.files.size() == 1) {
        const FileName& file = texture.files[0];
        const Resolved whole = resolve(file, file.name, image_extensions(), files);
        if (whole.path.empty()) result = locate_faces(file, files, diagnostics);
        if (result.empty()) result.push_back({file.name, accept(file, whole, files, diagnostics), file.span});
        return result;
    }
    std::vector<Missing> missing;
    for (const FileName& file : texture.files) {
        Resolved resolved = resolve(file, file.name, image_extensions(), files);
        if (resolved.path.empty() && resolved.refused.empty())
            if (const int noise = noise_size(texture, file.name, files)) {
                result.push_back({file.name, {}, file.span, noise});
                continue;
            }
        // posx.bmp is not a slip for posy.bmp, which is one of the other five.
        const auto other = [&] {
            return ranges::find(texture.files, resolved.nearest, &FileName::name) != texture.files.end();
        };
        if (!resolved.nearest.empty() && (other() || other_face(file.name, resolved.nearest))) resolved.nearest.clear();
        if (resolved.path.empty() && resolved.refused.empty()) {
            missing.push_back({file.name, file.span, resolved.nearest});
            result.push_back({file.name, {}, file.span});
        } else {
            result.push_back({file.name, accept(file, resolved, files, diagnostics), file.span});
        }
    }
    report_missing(missing, diagnostics, missing.size() > 1 ? " for faces of the cube map" : "");
    return result;
}

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

std::string statement_text(const Span& span, const Sources& sources) {
    constexpr std::size_t most = 200;
    std::string text;
    for (const char c : sources.text(span.file).substr(span.begin, span.end - span.begin)) {
        const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\\';
        if (!blank)
            text += c;
        else if (!text.empty() && text.back() != ' ')
            text += ' ';
        if (text.size() >= most) break;
    }
    return utf8::printable(text);
}

std::string statement_place(const Span& span, const Sources& sources) {
    const std::string_view file = sources.name(span.file);
    return utf8::printable(
        fmt::format("{}:{}", file.substr(file.rfind('/') + 1), sources.position(span.file, span.begin).line));
}

}  // namespace snell
