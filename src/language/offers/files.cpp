// The files that an argument may name, as they are on disk.
#include <algorithm>
#include <filesystem>

#include "parser/text/ranges.h"
#include "src/language/offers/offers.h"
#include "src/plan/locate.h"

namespace snell::language {

namespace {

constexpr std::size_t most_entries = 5000;

// Whether a scene writes the name in quotes, so that it is not several words.
bool needs_quotes(const std::string& name) {
    return name.find_first_of(" \t#;,<>[]{}\"") != std::string::npos || name.find("//") != std::string::npos;
}

}  // namespace

std::vector<Completion> file_completions(std::string_view path, std::string_view written, Span replaced,
                                         std::span<const std::string_view> extensions, Quotes quotes) {
    namespace fs = std::filesystem;
    std::vector<Completion> found;
    const bool quoted = written.starts_with('"');
    if (quoted) written.remove_prefix(1);
    const std::size_t slash = written.find_last_of("/\\");
    const std::string_view parent = slash == std::string_view::npos ? "" : written.substr(0, slash + 1);
    std::string prefix(parent);
    std::replace(prefix.begin(), prefix.end(), '\\', '/');
    std::error_code error;
    fs::directory_iterator at("." / fs::path(path).parent_path() / prefix, error);
    if (error) return found;
    std::size_t count = 0;
    for (; at != fs::directory_iterator() && count < most_entries; at.increment(error), ++count) {
        if (error) break;
        const std::string name = at->path().filename().string();
        if (name.starts_with('.') || name.find('\n') != std::string::npos) continue;
        const bool is_folder = at->is_directory(error);
        const auto ends = [&](std::string_view extension) { return has_extension(name, extension); };
        if (!is_folder && ranges::none_of(extensions, ends)) continue;
        // The folders before it stay, so that editors compare its name with what is written of it.
        Completion& one = add_offer(found, is_folder ? name + "/" : name,
                                    is_folder ? Completion::Kind::folder : Completion::Kind::file, replaced, "");
        one.replaced.begin += static_cast<std::uint32_t>(parent.size() + (quoted ? 1 : 0));
        if (quoted && !is_folder && quotes == Quotes::added) one.text += '"';
        if (!quoted && quotes == Quotes::added && needs_quotes(one.label)) {
            one.replaced = replaced;
            one.text = "\"" + std::string(parent) + one.label + (is_folder ? "" : "\"");
        }
        one.rank = is_folder ? 2 : 1;
        one.more = is_folder;
    }
    return found;
}

}  // namespace snell::language
