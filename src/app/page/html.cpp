#include "src/app/page/html.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "parser/text/utf8.h"
#include "src/app/picture/sha256.h"
#include "src/content/base64.h"
#include "src/content/table.h"
#include "src/content/whole_file.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

// Puts `text` in the place of `mark`, if it occurs once; sets `good` to false otherwise.
void put(std::string& page, std::string_view mark, std::string_view text, bool& good) {
    const std::size_t at = page.find(mark);
    if (at == page.npos || page.find(mark, at + mark.size()) != page.npos)
        good = false;
    else
        page.replace(at, mark.size(), text);
}

std::string element(std::string_view begin, std::string_view text) { return fmt::format("{}{}</script>", begin, text); }

constexpr std::string_view scene_begin = R"(<script type="application/json" id="scene">)";
constexpr std::string_view archive_begin = R"(<script type="text/plain" id="archive">)";
constexpr std::string_view runtime_begin = R"(<script type="text/plain" id="runtime">)";

}  // namespace

std::string web_file(const std::string& name, std::string& error) {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
    const bool installed = !fs::exists(program / "../CMakeCache.txt", none);
    fs::path folder = program / (installed ? "../share/snell/web" : "../../web");
    if (const char* own = std::getenv("SNELL_WEB"); own && *own) folder = own;
    const fs::path file = (folder / name).lexically_normal();
    if (fs::is_regular_file(file, none)) return content::whole_file(file.string());
    error = fmt::format(
        "the browser's part of snell is not there: there is no '{}'\n   help: './dev web' in the folder of snell's "
        "sources builds it, before snell is installed",
        utf8::printable(file.string()));
    return {};
}

std::string policy_hash(std::string_view text) {
    const std::string hex = sha256(text);
    std::string bytes;
    for (std::size_t at = 0; at < hex.size(); at += 2)
        bytes += static_cast<char>(std::strtol(hex.substr(at, 2).c_str(), nullptr, 16));
    return content::base64(bytes);
}

std::string script_json(const nlohmann::ordered_json& json) {
    std::string safe;
    for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return safe;
}

std::optional<std::string> filled_page(std::string_view page, const PageData& data) {
    std::string text(page);
    bool good = true;
    put(text, "<title>snell</title>", fmt::format("<title>{}</title>", content::escaped(data.title)), good);
    put(text, element(scene_begin, "null"), element(scene_begin, data.scene), good);
    put(text, element(archive_begin, ""), element(archive_begin, data.archive), good);
    if (const std::size_t at = text.find(runtime_begin); !data.runtime && at != text.npos)
        text.erase(at + runtime_begin.size(), text.find("</script>", at) - at - runtime_begin.size());
    return good ? std::optional(std::move(text)) : std::nullopt;
}

bool is_gallery_page(std::string_view page) {
    const auto has = [page](std::string_view part) { return page.find(part) != page.npos; };
    return has(scene_begin) && has(archive_begin) && !has(runtime_begin);
}

}  // namespace snell::app
