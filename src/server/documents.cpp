#include "src/server/documents.h"

#include <filesystem>

#include "parser/text/ranges.h"
#include "src/plan/locate.h"

namespace snell::server {

bool Document::is_scene() const { return language == "glib" || has_extension(path, "glib"); }

void apply(std::string& text, const std::vector<Change>& changes, Encoding encoding) {
    for (const Change& change : changes) {
        if (!change.range) {
            text = change.text;
            continue;
        }
        const Lines lines(text);
        const std::uint32_t begin = lines.offset(change.range->begin, encoding);
        const std::uint32_t end = std::max(begin, lines.offset(change.range->end, encoding));
        text.replace(begin, end - begin, change.text);
    }
}

Document& Documents::open(Document document) {
    std::string uri = document.uri;
    return all_.insert_or_assign(std::move(uri), std::move(document)).first->second;
}

void Documents::close(std::string_view uri) {
    if (const auto found = all_.find(uri); found != all_.end()) all_.erase(found);
}

Document* Documents::find(std::string_view uri) {
    const auto found = all_.find(uri);
    return found == all_.end() ? nullptr : &found->second;
}

const Document* Documents::with_path(std::string_view path) const {
    const auto same = [&](const auto& entry) { return entry.second.path == path; };
    auto found = ranges::find_if(all_, same);
    if (found == all_.end() && !path.empty()) {
        const std::string real = real_path(std::string(path));
        found = ranges::find_if(all_, [&](const auto& entry) { return real_path(entry.second.path) == real; });
    }
    return found == all_.end() ? nullptr : &found->second;
}

Access Documents::access() const {
    auto texts = std::make_shared<std::map<std::string, std::string>>();
    for (const auto& [uri, document] : all_) texts->insert_or_assign(real_path(document.path), document.text);
    Access access;
    access.instead = std::move(texts);
    return access;
}

std::string real_path(const std::string& path) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    return error ? path : real.string();
}

}  // namespace snell::server
