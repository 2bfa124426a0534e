#include "src/plan/read/texts.h"

#include <filesystem>

#include "parser/read/parse.h"
#include "shaders/embedded.h"
#include "src/plan/locate.h"

namespace snell {

namespace {

IncludeReader scene_includes(Files& files) {
    return [&files](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        const Resolved resolved = files.resolve_beside(from, name, scene_extensions());
        std::string error(resolved.outside ? outside_reason : "");
        if (resolved.path.empty()) return IncludedText{{}, {}, resolved.nearest, {}, std::move(error)};
        auto text = files.read(resolved.path, error);
        if (!text) return IncludedText{{}, {}, {}, {}, std::move(error)};
        return IncludedText{
            resolved.path, std::move(*text), {}, resolved.inexact ? written_name(resolved.path, from, files) : ""};
    };
}

}  // namespace

std::optional<ParsedDocument> parse_document(const std::string& path, Files& files, Sources& sources,
                                             Diagnostics& diagnostics) {
    std::string error;
    auto text = files.read(path, error);
    if (!text) {
        diagnostics.error("scene-unreadable", "cannot read '" + path + "': " + error);
        return std::nullopt;
    }
    const FileId file = sources.add(path, std::move(*text));
    Parsed parsed = parse(file, sources, scene_includes(files), files.limits());
    diagnostics.append(parsed.diagnostics);
    return ParsedDocument{file, std::move(parsed.scene)};
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
        std::string error(resolved.outside ? outside_reason : "");
        const auto text = resolved.path.empty() ? nullptr : files.read_once(resolved.path, error);
        if (!text && error.empty()) return std::nullopt;
        if (!text) return glsl::IncludeText{{}, {}, std::move(error)};
        return glsl::IncludeText{resolved.path, *text};
    };
}

}  // namespace snell
