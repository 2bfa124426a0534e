// How much is to be done: a little in the ordinary suite, all of it by ./dev torture.
#pragma once

#include <cstdlib>
#include <string>

namespace snell::torture {

inline std::string setting(const char* name, const std::string& otherwise) {
    const char* value = std::getenv(name);
    return value && *value ? value : otherwise;
}

inline unsigned number_of(const char* name, unsigned otherwise) {
    return static_cast<unsigned>(std::stoul(setting(name, std::to_string(otherwise))));
}

}  // namespace snell::torture
