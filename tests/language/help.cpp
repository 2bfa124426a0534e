#include "tests/language/help.h"

namespace snell::language {

std::string Editor::written(std::string_view name, std::string_view text) {
    std::string clean(text);
    if (const std::size_t at = clean.find('@'); at != std::string::npos) {
        clean.erase(at, 1);
        cursor_ = name;
        offset_ = static_cast<std::uint32_t>(at);
    }
    return folder_.write(name, clean);
}

Editor::Editor(std::string_view scene, const std::map<std::string, std::string>& others,
               const std::map<std::string, std::string>& links) {
    const std::string path = written("scene.glib", scene);
    for (const auto& [name, text] : others) written(name, text);
    for (const auto& [name, target] : links) std::filesystem::create_symlink(target, folder_.path(name));
    project_ = read_project(path, {}, Depth::plan);
    file_ = cursor_.empty() ? project_.scene_file : file(cursor_);
}

FileId Editor::file(std::string_view name) const { return project_.file_of(folder_.path(name)).value_or(~FileId{0}); }

std::string Editor::text(const Span& span) const {
    return std::string(project_.sources.text(span.file).substr(span.begin, span.end - span.begin));
}

std::string Editor::place(const Span& span) const {
    const std::string name = std::filesystem::path(project_.sources.name(span.file)).filename().string();
    return name + ":" + std::to_string(project_.sources.position(span.file, span.begin).line) + " " + text(span);
}

std::vector<std::string> Editor::places(const std::vector<Span>& spans) const {
    std::vector<std::string> all;
    for (const Span& span : spans) all.push_back(place(span));
    std::sort(all.begin(), all.end());
    return all;
}

std::string Editor::hover() const {
    const auto found = language::hover(project_, file_, offset_);
    return found ? found->documentation : "";
}

std::string Editor::renamed(std::string_view name, std::string_view file_name) const {
    const Rename result = rename(name);
    EXPECT_EQ(result.refused, "");
    return with_edits(text(file_name), file(file_name), result.edits);
}

std::vector<std::string> labels(const std::vector<Completion>& all) {
    std::vector<std::string> found;
    for (const Completion& one : all) found.push_back(one.label);
    return found;
}

const Completion* find(const std::vector<Completion>& all, std::string_view label) {
    for (const Completion& one : all)
        if (one.label == label) return &one;
    return nullptr;
}

std::string inserted(const std::vector<Completion>& all, std::string_view label) {
    const Completion* one = find(all, label);
    return one == nullptr ? "" : one->text;
}

std::string completed(const Editor& editor, std::string_view label) {
    const std::vector<Completion> all = editor.completions();
    const Completion* one = find(all, label);
    if (one == nullptr) return "";
    std::vector<Edit> edits = one->also;
    edits.push_back({one->replaced, one->text});
    return with_edits(editor.project().sources.text(editor.file()), editor.file(), edits);
}

}  // namespace snell::language
