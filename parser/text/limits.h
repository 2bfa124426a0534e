// Limits on what a scene may use. They are checked before memory is allocated. A statement that exceeds one gives an
// error that names the limit; the rest of the scene is still read.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace snell {

struct Limits {
    std::uint64_t text_bytes = 64u << 20;
    std::uint64_t statements = 4'000'000;
    std::uint64_t include_depth = 16;
    std::uint64_t includes = 1'000;
    std::uint64_t expression_depth = 2'000;
    std::uint64_t matrix_stack = 10'000;
    std::uint64_t draws = 4'000'000;
    std::uint64_t passes = 1'000;
    std::uint64_t uniforms = 4'000;
    std::uint64_t diagnostics = 1'000;
    std::uint64_t message_bytes = 10'000;
    std::uint64_t file_bytes = std::uint64_t{1} << 30;
    std::uint64_t vertices = 20'000'000;
    std::uint64_t sub_quads = 4'000'000;
    std::uint64_t texture_side = 16'384;
    std::uint64_t texture_bytes = std::uint64_t{2} << 30;
    std::uint64_t noise_2d = 4'096;
    std::uint64_t noise_3d = 512;
    std::uint64_t output_side = 16'384;
    std::uint64_t output_bytes = std::uint64_t{4} << 30;

    bool operator==(const Limits&) const = default;
};

// A limit, as `--limit NAME=VALUE` and docs/limits.md show it.
struct LimitFacts {
    std::string_view name;  // in kebab-case
    std::uint64_t Limits::*value;
    std::string_view unit;
    std::string_view doc;
    std::uint64_t most;  // the largest value to which it can be set
};
std::span<const LimitFacts> limit_table();

// Sets a limit by a text such as "vertices=1000000". If the name is unknown, or the value is not a whole number from 1
// to the limit's maximum, returns false, sets `error` and changes nothing.
bool set_limit(Limits& limits, std::string_view text, std::string& error);

// The help text of an error about an exceeded limit: its name, its meaning and how to change it.
std::string limit_help(std::uint64_t now, std::uint64_t Limits::*limit);
inline std::string limit_help(const Limits& limits, std::uint64_t Limits::*limit) {
    return limit_help(limits.*limit, limit);
}

}  // namespace snell
