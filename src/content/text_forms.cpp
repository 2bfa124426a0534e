#include "src/content/text_forms.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "parser/text/words.h"

namespace snell::content {

namespace {

int digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char low = lower(c);
    return low >= 'a' && low <= 'f' ? low - 'a' + 10 : -1;
}

bool plain(char c) {
    const char low = lower(c);
    return (low >= 'a' && low <= 'z') || (c >= '0' && c <= '9') ||
           std::string_view("-._~/").find(c) != std::string_view::npos;
}

}  // namespace

std::string path_of_uri(std::string_view uri) {
    constexpr std::string_view scheme = "file://";
    if (uri.size() < scheme.size() || !same_word(uri.substr(0, scheme.size()), scheme)) return std::string(uri);
    std::string_view rest = uri.substr(scheme.size());
    rest.remove_prefix(std::min(rest.find('/'), rest.size()));  // the host
    std::string path;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const bool coded = rest[i] == '%' && i + 2 < rest.size() && digit(rest[i + 1]) >= 0 && digit(rest[i + 2]) >= 0;
        path += coded ? static_cast<char>(digit(rest[i + 1]) * 16 + digit(rest[i + 2])) : rest[i];
        if (coded) i += 2;
    }
    return path;
}

std::string uri_of_path(std::string_view path) {
    return path.starts_with('/') ? "file://" + escaped_address(path) : std::string(path);
}

std::string escaped_address(std::string_view path) {
    std::string address;
    for (const char c : path)
        address += plain(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return address;
}

using Json = nlohmann::ordered_json;

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }
Json parse_json(std::string_view text) { return Json::parse(text, nullptr, false); }

}  // namespace snell::content
