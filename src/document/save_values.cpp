#include "src/document/save_values.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "parser/read/parse.h"
#include "parser/text/ranges.h"
#include "src/content/files.h"
#include "src/plan/locate.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

// Returns the scene as it would be read after saving.
Scene read_again(const Document& document, const std::vector<SavedFile>& files) {
    std::map<std::string, std::string_view, std::less<>> texts;
    for (FileId file = 0; file < document.sources.size(); ++file)
        texts.emplace(document.sources.name(file), document.sources.text(file));
    for (const SavedFile& file : files) texts[file.path] = file.after;
    const auto include = [&](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        const std::string path = document.files->resolve_beside(from, name, scene_extensions()).path;
        const auto text = texts.find(path);
        if (text == texts.end()) return std::nullopt;
        return IncludedText{path, std::string(text->second)};
    };
    Sources sources;
    const FileId file = sources.add(document.path, std::string(texts[document.path]));
    return parse(file, sources, include).scene;
}

// Returns the files of the scene that it would not find from another folder.
std::string not_found_from(const fs::path& folder, const Document& document) {
    const fs::path old = fs::path(document.path).parent_path().lexically_normal();
    std::string lost;
    std::error_code error;
    for (const std::string& path : document.files->read_paths()) {
        const fs::path relative = fs::path(path).lexically_normal().lexically_relative(old);
        const bool whole = document.sources.text(0).find(path) != std::string_view::npos;  // it is named by its path
        if (path == document.path || whole || (!relative.empty() && fs::exists(folder / relative, error))) continue;
        lost += (lost.empty() ? "" : ", ") + fs::path(path).filename().string();
    }
    return lost;
}

}  // namespace

std::size_t changed_values(const Document& document) {
    const auto& rungs = document.controls.rungs;
    std::size_t count = 0;
    for (const Control& control : document.controls.items) count += control.value != control.initial;
    for (std::size_t i = 0; i < rungs.size() && i < document.scene().ladders.size(); ++i)
        count += rungs[i] != document.scene().ladders[i].current;
    return count;
}

Saved saved_values(const Document& document) {
    Saved saved;
    if (!document.runtime) {
        saved.error = "the scene cannot be read";
        return saved;
    }
    WriteBack back = write_back(document.scene(), document.controls, document.sources);
    saved.unwritten = std::move(back.unwritten);
    const std::size_t changed = changed_values(document);
    saved.values = changed - std::min(changed, saved.unwritten.size());
    for (FileId file = 0; file < document.sources.size(); ++file) {
        const auto edits = ranges::count(back.edits, file, [](const Edit& edit) { return edit.span.file; });
        if (edits == 0) continue;
        const std::string_view before = document.sources.text(file);
        saved.files.push_back(
            {std::string(document.sources.name(file)), std::string(before), with_edits(before, file, back.edits)});
    }
    for (const SavedFile& file : saved.files)
        if (content::whole_file(file.path) != file.before)
            saved.error = file.path + " has changed since it was read: reload it, or correct its errors, first";
    if (saved.error.empty() && !reads_back(back, read_again(document, saved.files)))
        saved.error = "the new text would not say these values: nothing is written";
    if (!saved.error.empty()) saved.files.clear();
    return saved;
}

SavedAs saved_as(const Document& document, const std::string& name) {
    const Saved saved = saved_values(document);
    SavedAs as{{{}, {}, std::string(document.sources.text(0))}, false, saved.error};
    const fs::path given = fs::path(name).filename();
    if (as.error.empty() && (given.empty() || given == "." || given == "..")) as.error = "the scene needs a name";
    if (!as.error.empty()) return as;
    fs::path path = fs::path(document.path).parent_path() / name;
    if (path.extension() != ".glib") path += ".glib";
    as.file.path = path.lexically_normal().string();
    std::error_code error;
    as.exists = fs::exists(path, error);
    if (fs::equivalent(path, document.path, error)) as.error = "this is the scene itself: Ctrl+S saves to it";
    for (const SavedFile& file : saved.files) {
        if (file.path == document.path)
            as.file.after = file.after;
        else
            as.error = fs::path(file.path).filename().string() + " has some of these values: Ctrl+S saves to it first";
    }
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (as.error.empty() && !fs::is_directory(folder, error)) as.error = "there is no folder " + folder.string();
    const std::string lost = as.error.empty() ? not_found_from(folder, document) : "";
    if (!lost.empty()) as.error = "the scene would not find " + lost + " from there";
    return as;
}

}  // namespace snell
