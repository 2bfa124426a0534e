#include "src/app/open/save_values.h"

#include <algorithm>
#include <map>
#include <utility>

#include "parser/read/parse.h"
#include "src/content/replace.h"

namespace snell {

namespace {

// Returns the scene as it would be read after saving.
Scene read_again(const Document& document, const std::vector<SavedFile>& files) {
    std::map<std::string, std::string_view, std::less<>> texts;
    for (FileId file = 0; file < document.sources.size(); ++file)
        texts.emplace(document.sources.name(file), document.sources.text(file));
    for (const SavedFile& file : files) texts[file.path] = file.after;
    const auto include = [&](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        const std::string path = document.files->resolve_beside(from, name, {"glib"}).path;
        const auto text = texts.find(path);
        if (text == texts.end()) return std::nullopt;
        return IncludedText{path, std::string(text->second)};
    };
    Sources sources;
    const FileId file = sources.add(document.path, std::string(texts[document.path]));
    return parse(file, sources, include).scene;
}

// Replaces `now` by `next` in all files or in none.
std::string exchange(const std::vector<SavedFile>& files, std::string SavedFile::*now, std::string SavedFile::*next) {
    for (const SavedFile& file : files)
        if (content::whole_file(file.path) != file.*now)
            return file.path + " was changed meanwhile: it is left as it is";
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::string error = content::replace_file(files[i].path, files[i].*next);
        if (error.empty()) continue;
        if (!error.starts_with(files[i].path)) error = files[i].path + ": " + error;
        while (i-- > 0) content::replace_file(files[i].path, files[i].*now);
        return error;
    }
    return {};
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
        const auto edits = std::ranges::count(back.edits, file, [](const Edit& edit) { return edit.span.file; });
        if (edits == 0) continue;
        const std::string_view before = document.sources.text(file);
        saved.files.push_back(
            {std::string(document.sources.name(file)), std::string(before), with_edits(before, file, back.edits)});
    }
    for (const SavedFile& file : saved.files)
        if (content::whole_file(file.path) != file.before)
            saved.error = file.path + " is not what was read: reload first";
    if (saved.error.empty() && !reads_back(back, read_again(document, saved.files)))
        saved.error = "the new text would not say these values: nothing is written";
    if (!saved.error.empty()) saved.files.clear();
    return saved;
}

std::string write_saved(const std::vector<SavedFile>& files) {
    return exchange(files, &SavedFile::before, &SavedFile::after);
}

std::string revert_saved(const std::vector<SavedFile>& files) {
    return exchange(files, &SavedFile::after, &SavedFile::before);
}

}  // namespace snell
