#include "src/app/desktop/given_texts.h"

#include "src/content/files.h"

namespace snell {

namespace {

std::filesystem::file_time_type written(const std::string& path) {
    std::error_code error;
    return std::filesystem::last_write_time(path, error);
}

// Editors keep the mark of UTF-8 to themselves.
bool says(const std::string& path, std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    const std::string bytes = content::whole_file(path);
    return bytes == text || (bytes.starts_with(mark) && std::string_view(bytes).substr(mark.size()) == text);
}

}  // namespace

GivenTexts::GivenTexts(const Access& access) {
    if (!access.instead) return;
    for (const auto& [path, text] : *access.instead) given_.emplace(path, written(path));
}

void GivenTexts::remove_saved(Access& access) const {
    if (!access.instead) return;
    std::map<std::string, std::string> left;
    for (const auto& [path, text] : *access.instead)
        if (const auto given = given_.find(path); given != given_.end() && given->second == written(path))
            if (!says(path, text)) left.emplace(path, text);
    access.instead = std::make_shared<const std::map<std::string, std::string>>(std::move(left));
}

}  // namespace snell
