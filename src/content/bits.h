// The bits of a value as another type. C++20 has it as bit_cast, but not every standard library that builds snell does
// yet (libc++ only since version 14).
#pragma once

#include <cstring>
#include <type_traits>

namespace snell::content {

template <class To, class From>
To bits_as(From from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
    To to;
    std::memcpy(&to, &from, sizeof to);
    return to;
}

}  // namespace snell::content
