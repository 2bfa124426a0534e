// What tests need to know of the sanitizer that they are built with.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace snell {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

// Everything takes so many times as long; under valgrind, who starts it says how many.
inline const double patience = [] {
    const char* told = std::getenv("SNELL_PATIENCE");
    return told ? std::max(std::atof(told), 1.) : sanitized ? 5. : 1.;
}();
// The exit status of a program with a finding: none of snell's own. The presets ask for it.
inline constexpr int finding_status = 66;

}  // namespace snell
