// File names as editors write them.
#pragma once

#include <string>
#include <string_view>

namespace snell::content {

// The path of a "file:" URI; of others, the URI itself, which no file has as its name.
std::string path_of_uri(std::string_view uri);
std::string uri_of_path(std::string_view path);
// A relative path as an address.
std::string escaped_address(std::string_view path);

}  // namespace snell::content
