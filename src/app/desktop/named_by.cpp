#include "src/app/desktop/named_by.h"

#include <fmt/format.h>

#include <cstdint>

namespace snell {

std::string named_by(const std::string& folder, std::string_view path, std::string_view extension) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char byte : path) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
    return fmt::format("{}/{:016x}.{}", folder, hash, extension);
}

}  // namespace snell
