#include "src/plan/texts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

#include "parser/read/parse.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "shaders/embedded.h"
#include "src/content/image/formats.h"
#include "src/glsl/read/lexer.h"
#include "src/plan/locate.h"

namespace snell {

namespace {

// Wavefront's models are text; their statements are no commands of scenes.
bool is_model(std::string_view text) {
    while (!text.empty() && (text.front() == '#' || text.front() == '\n' || text.front() == '\r'))
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    const std::string_view first = text.substr(0, text.find_first_of(" \t\r\n"));
    constexpr std::array<std::string_view, 6> statements{"mtllib", "o", "g", "s", "v", "vn"};
    return ranges::find(statements, first) != statements.end() &&
           (first == "v" || text.find("\nv ") != text.npos || text.find("\nv\t") != text.npos);
}

// Texts hold few control characters. Those of UTF-16 have an error of their own.
bool is_binary(std::string_view bytes) {
    constexpr std::size_t enough = 1024;
    bytes = bytes.substr(0, enough);
    const auto controls = ranges::count_if(bytes, [](char c) { return c >= 0 && c < ' ' && (c < '\t' || c > '\r'); });
    return !bytes.starts_with("\xFF\xFE") && !bytes.starts_with("\xFE\xFF") &&
           static_cast<std::size_t>(controls) * 10 > bytes.size();
}

// Why these bytes are no scene, by the first of them: each line of a picture would be an error. "" if they may be one.
std::string not_a_scene(std::string_view bytes) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> others{
        {{"zip", "an archive (ZIP)"},
         {"pdf", "a document (PDF)"},
         {"html", "a web page (HTML)"},
         {"svg", "a drawing or data (XML)"},
         {"git-lfs", "a pointer of Git LFS"}}};
    const std::string_view format = content::sniff(bytes);
    const auto other = ranges::find(others, format, &std::pair<std::string_view, std::string_view>::first);
    std::string what;
    if (other != others.end())
        what = other->second;
    else if (!format.empty())
        what = "a picture (" + raised(format) + ")";
    else if (is_model(bytes))
        what = "a model (OBJ)";
    else if (is_binary(bytes))
        what = "a binary file";
    return what.empty() ? what : "it is " + what + ", not a scene";
}

IncludeReader scene_includes(Files& files) {
    return [&files](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        const Resolved resolved = files.resolve_beside(from, name, scene_extensions());
        std::string error(resolved.refused);
        if (resolved.path.empty()) return IncludedText{{}, {}, resolved.nearest, {}, std::move(error)};
        auto text = files.read(resolved.path, error);
        if (text) error = not_a_scene(*text);
        if (!error.empty()) return IncludedText{{}, {}, {}, {}, std::move(error)};
        return IncludedText{
            resolved.path, std::move(*text), {}, resolved.inexact ? written_name(resolved.path, from, files) : ""};
    };
}

std::set<std::string> included_files(const Plan& plan, const Sources& sources, const Files& files) {
    Files reader(files.folder(), files.access());
    std::set<std::string> found;
    for (const PlannedProgram& program : plan.programs) {
        const std::vector<ShaderText> texts = shader_texts(program, sources, reader);
        for (std::size_t i = program.stages.size(); i < texts.size(); ++i) found.insert(texts[i].path);
    }
    return found;
}

}  // namespace

std::optional<ParsedDocument> parse_document(const std::string& path, Files& files, Sources& sources,
                                             Diagnostics& diagnostics) {
    std::string error;
    auto text = files.read(path, error);
    if (text) error = not_a_scene(*text);
    if (!error.empty()) {
        diagnostics.error("scene-unreadable", "cannot read '" + path + "': " + error);
        return std::nullopt;
    }
    const FileId file = sources.add(path, std::move(*text));
    Parsed parsed = parse(file, sources, scene_includes(files), files.limits());
    diagnostics.append(parsed.diagnostics);
    return ParsedDocument{file, std::move(parsed.scene)};
}

std::optional<Plan> read_plan(const std::string& path, Files& files, Sources& sources, Diagnostics& diagnostics) {
    auto parsed = parse_document(path, files, sources, diagnostics);
    if (!parsed) return std::nullopt;
    return make_plan(std::move(parsed->scene), files, sources, diagnostics);
}

std::string scene_folder(const std::string& path) { return std::filesystem::path(path).parent_path().string(); }

glsl::IncludeReader shader_includes(Files& files) {
    return [&files](std::string_view from, std::string_view name, bool angle) -> std::optional<glsl::IncludeText> {
        if (angle) {
            const std::string_view text = embedded_shader(name);
            if (text.empty()) return std::nullopt;
            return glsl::IncludeText{std::string(name), std::string(text)};
        }
        const Resolved resolved = files.resolve_beside(from, name, {"glsl"});
        std::string error(resolved.refused);
        const auto text = resolved.path.empty() ? nullptr : files.read_once(resolved.path, error);
        if (!text && error.empty()) return std::nullopt;
        if (!text) return glsl::IncludeText{{}, {}, std::move(error)};
        return glsl::IncludeText{resolved.path, *text, {}, resolved.inexact};
    };
}

// A list, not a recursion, because the chain of includes may be long.
std::vector<ShaderText> shader_texts(const PlannedProgram& program, const Sources& sources, Files& reader) {
    std::vector<ShaderText> texts;
    for (const glsl::StageInput& stage : program.stages)
        texts.push_back({std::string(sources.name(stage.file)), sources.text(stage.file)});
    std::set<std::string> found;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const auto [from, text] = texts[i];
        for (const auto& [name, angle] : glsl::included_names(text)) {
            const std::string path = angle ? "" : reader.resolve_beside(from, name, {"glsl"}).path;
            if (path.empty()) continue;
            if (!found.insert(std::filesystem::path(path).lexically_normal().string()).second) continue;
            std::string error;
            const auto inner = reader.read_once(path, error);
            texts.push_back({path, inner ? std::string_view(*inner) : ""});
        }
    }
    return texts;
}

std::vector<std::string> used_files(const Plan& plan, const Sources& sources, const Files& files) {
    std::vector<std::string> paths = files.read_paths();
    const auto add = [&](const std::vector<std::string>& more) { paths.insert(paths.end(), more.begin(), more.end()); };
    Diagnostics unheard;  // the plan's own diagnostics say the same
    for (const Texture& texture : plan.scene.textures)
        if (!texture.files.empty())
            for (TextureFile& file : locate_texture(texture, files, unheard))
                if (!file.path.empty()) paths.push_back(std::move(file.path));
    for (Index mesh = 0; mesh < plan.meshes.size(); ++mesh) add(mesh_identity(plan, mesh, files).files);
    add(noise_identity(2, plan.scene.noise2d, files).files);
    add(noise_identity(3, plan.scene.noise3d, files).files);
    for (const std::string& path : included_files(plan, sources, files)) paths.push_back(path);
    return paths;
}

}  // namespace snell
