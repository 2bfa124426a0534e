#include "src/server/documents.h"

#include <filesystem>
#include <utility>

#include "parser/text/ranges.h"
#include "src/plan/locate.h"

namespace snell::server {

bool Document::is_scene() const { return language == "glib" || has_extension(path, "glib"); }

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

bool joins_halves(std::string_view text, std::size_t at) {
    return text.substr(0, at).ends_with(replacement) && text.substr(at).starts_with(replacement);
}

}  // namespace

void apply(Document& document, const std::vector<Change>& changes, Encoding encoding) {
    std::string& text = document.text;
    for (const Change& change : changes) {
        if (!change.range) {
            text = change.text;
            document.lost = false;
            document.halves = change.halves;
            continue;
        }
        document.halves = document.halves || change.halves;
        const Lines lines(text);
        const std::uint32_t begin = lines.offset(change.range->begin, encoding);
        const std::uint32_t end = std::max(begin, lines.offset(change.range->end, encoding));
        text.replace(begin, end - begin, change.text);
        document.lost =
            document.lost ||
            (document.halves && (joins_halves(text, begin) || joins_halves(text, begin + change.text.size())));
    }
}

int Documents::lose(const std::optional<std::string>& uri) {
    int count = 0;
    for (auto& [own, document] : all_)
        if (!uri || own == *uri) count += std::exchange(document.lost, true) ? 0 : 1;
    return count;
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
    for (const auto& [uri, document] : all_)
        if (!document.lost) texts->insert_or_assign(real_path(document.path), document.text);
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
