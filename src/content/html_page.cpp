#include "src/content/html_page.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>

#include "parser/text/words.h"
#include "src/content/table.h"
#include "src/content/text_forms.h"

namespace snell::content {

namespace {

using Word = std::uint32_t;

// The first 32 bits of the fractions of the cube roots of the first 64 primes.
constexpr std::array<Word, 64> rounds{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

using State = std::array<Word, 8>;

void mix(State& state, const char* block) {
    std::array<Word, 64> w{};
    for (std::size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(block[i]);
    for (std::size_t i = 16; i < 64; ++i) {
        const Word a = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
        const Word b = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
        w[i] = w[i - 16] + a + w[i - 7] + b;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
        const Word sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const Word sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const Word one = h + sum1 + ((e & f) ^ (~e & g)) + rounds[i] + w[i];
        const Word two = sum0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
    }
    const State mixed{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i) state[i] += mixed[i];
}

State digest(std::string_view bytes) {
    State state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
    for (; bytes.size() >= 64; bytes.remove_prefix(64)) mix(state, bytes.data());
    std::string last(bytes);
    last += '\x80';
    last.resize(last.size() <= 56 ? 56 : 120);
    for (int shift = 56; shift >= 0; shift -= 8) last += static_cast<char>(bits >> shift & 0xff);
    for (std::size_t i = 0; i < last.size(); i += 64) mix(state, &last[i]);
    return state;
}

// Text has a contrast of at least 4.5 to 1, dark and light.
constexpr std::string_view common_style =
    R"(:root { color-scheme: light dark; --back: #fff; --text: #1b1f24; --weak: #57606a; --line: #d0d7de; --panel: #f3f5f7; --accent: #0550ae; --current: #b93c0a; --wrong: #8c1414; }
@media (prefers-color-scheme: dark) { :root { --back: #14171a; --text: #e8eaed; --weak: #a9b1ba; --line: #3d444d; --panel: #20252b; --accent: #79b8ff; --current: #ff9a5c; --wrong: #ffb4ab; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 90rem; padding: 1rem; background: var(--back); color: var(--text); font: 1rem/1.5 system-ui, sans-serif; }
a { color: var(--accent); } h1 { font-size: 1.5rem; margin: .5rem 0; } h2 { font-size: 1.125rem; margin: 1.5rem 0 .5rem; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; } .number { text-align: right; } td.number { white-space: nowrap; }
figure { margin: 0; } figcaption { font-size: .875rem; overflow-wrap: anywhere; } .pictures { display: flex; flex-wrap: wrap; gap: 1rem; margin: .5rem 0; }
)";

}  // namespace

std::string html_page(const HtmlPage& page) {
    const std::string style = fmt::format("{}{}", common_style, page.style);
    const std::string allowed =
        page.script.empty() ? "" : fmt::format("; script-src 'sha256-{}'", policy_hash(page.script));
    const std::string element = page.script.empty() ? "" : fmt::format("<script>{}</script>\n", page.script);
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src {}; style-src "
        "'sha256-{}'{}; base-uri 'none'; form-action 'none'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"generator\" content=\"{}\">\n<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n"
        "<style>{}</style>\n</head>\n<body>\n{}{}</body>\n</html>\n",
        page.images, policy_hash(style), allowed, page.made_by, escaped(utf8::printable(page.title)), style, page.body,
        element);
}

std::string sha256(std::string_view bytes) {
    std::string text;
    for (const Word word : digest(bytes)) text += fmt::format("{:08x}", word);
    return text;
}

std::string policy_hash(std::string_view text) {
    std::string bytes;
    for (const Word word : digest(text))
        for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(word >> shift & 0xffU);
    return base64(bytes);
}

}  // namespace snell::content
