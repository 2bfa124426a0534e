// Bytes and values as text: base64, URIs, and JSON, whose slow templates are instantiated only here.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace snell::content {

// Bytes as text (RFC 4648).

inline std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? letters[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

// File names as editors write them.

// The path of a "file:" URI; of others, the URI itself, which no file has as its name.
std::string path_of_uri(std::string_view uri);
std::string uri_of_path(std::string_view path);
// A relative path as an address.
std::string escaped_address(std::string_view path);

// JSON to and from text. nlohmann's templates are slow to compile, so they are instantiated only here.

// Formats with an indent of two blanks. Bytes that are not UTF-8 are replaced by U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);
// Returns a discarded value if the text is not JSON.
nlohmann::ordered_json parse_json(std::string_view text);

}  // namespace snell::content
