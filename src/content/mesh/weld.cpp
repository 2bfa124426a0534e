#include "src/content/mesh/weld.h"

#include <algorithm>
#include <bit>

#include "src/content/bits.h"

namespace snell::content {
namespace {

constexpr std::uint32_t empty = ~std::uint32_t{0};

std::uint64_t mix(std::uint64_t x) {  // the finaliser of splitmix64
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

std::uint64_t hash(const Float3& p) {
    // Adding 0 turns -0 into 0.
    const auto bits = [](float x) { return std::uint64_t{bits_as<std::uint32_t>(x + 0.f)}; };
    return mix(mix(bits(p[0]) | bits(p[1]) << 32) ^ bits(p[2]));
}

std::size_t table_size(std::size_t entries) { return std::bit_ceil(entries * 2 + 1); }

}  // namespace

Weld weld(std::span<const Float3> positions) {
    Weld result;
    result.place.resize(positions.size());
    std::vector<std::uint32_t> table(table_size(positions.size()), empty);  // index of the first vertex of each place
    const std::size_t mask = table.size() - 1;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hash(positions[i]) & mask;
        while (table[slot] != empty && positions[table[slot]] != positions[i]) slot = (slot + 1) & mask;
        if (table[slot] == empty) {
            table[slot] = i;
            result.place[i] = result.places++;
        } else {
            result.place[i] = result.place[table[slot]];
        }
    }
    return result;
}

void keep_each_edge_once(std::vector<std::uint32_t>& lines, const Weld& weld) {
    constexpr std::uint64_t none64 = ~std::uint64_t{0};
    std::vector<std::uint64_t> table(table_size(lines.size() / 2), none64);
    const std::size_t mask = table.size() - 1;
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
        const auto [low, high] = std::minmax(weld.place[lines[i]], weld.place[lines[i + 1]]);
        const std::uint64_t key = std::uint64_t{high} << 32 | low;
        std::size_t slot = mix(key) & mask;
        while (table[slot] != none64 && table[slot] != key) slot = (slot + 1) & mask;
        if (table[slot] == key) continue;
        table[slot] = key;
        const std::array pair{lines[i], lines[i + 1]};
        lines[kept++] = pair[0];
        lines[kept++] = pair[1];
    }
    lines.resize(kept);
}

}  // namespace snell::content
