#include "parser/text/words.h"

#include <cstdio>

namespace snell::utf8 {
namespace {

bool within(char32_t code, char32_t first, char32_t last) { return code >= first && code <= last; }

}  // namespace

Char decode(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(at);
    if (lead < 0x80) return {lead, 1, true};
    const std::uint32_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    const Char bad{lead, 1, false};
    if (lead < 0xC2 || lead > 0xF4 || at + length > text.size()) return bad;
    char32_t code = lead & (0x7Fu >> length);
    for (std::uint32_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xC0) != 0x80) return bad;
        code = code << 6 | (byte(at + i) & 0x3Fu);
    }
    const char32_t least = length == 4 ? 0x10000 : length == 3 ? 0x800 : 0x80;
    if (code < least || code > 0x10FFFF || within(code, 0xD800, 0xDFFF)) return bad;
    return {code, length, true};
}

void append(std::string& out, char32_t code) {
    const auto put = [&](char32_t byte) { out += static_cast<char>(byte); };
    if (code < 0x80) return put(code);
    if (code < 0x800) {
        put(0xC0 | code >> 6);
    } else if (code < 0x10000) {
        put(0xE0 | code >> 12);
        put(0x80 | (code >> 6 & 0x3F));
    } else {
        put(0xF0 | code >> 18);
        put(0x80 | (code >> 12 & 0x3F));
        put(0x80 | (code >> 6 & 0x3F));
    }
    put(0x80 | (code & 0x3F));
}

int width(char32_t code) {
    if (within(code, 0x300, 0x36F) || within(code, 0x1AB0, 0x1AFF) || within(code, 0x20D0, 0x20FF) ||
        within(code, 0xFE00, 0xFE0F))
        return 0;
    const bool wide = within(code, 0x1100, 0x115F) || within(code, 0x2E80, 0x303E) || within(code, 0x3041, 0xA4CF) ||
                      within(code, 0xAC00, 0xD7A3) || within(code, 0xF900, 0xFAFF) || within(code, 0xFE30, 0xFE6F) ||
                      within(code, 0xFF00, 0xFF60) || within(code, 0xFFE0, 0xFFE6) || within(code, 0x1F300, 0x1F64F) ||
                      within(code, 0x1F900, 0x1F9FF) || within(code, 0x20000, 0x3FFFD);
    return wide ? 2 : 1;
}

bool hidden(char32_t code) {
    return code < 0x20 || within(code, 0x7F, 0x9F) || within(code, 0x200B, 0x200F) || within(code, 0x2028, 0x202E) ||
           within(code, 0x2060, 0x2069) || code == 0xFEFF || code == 0xAD;
}

std::string printable(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const Char c = decode(text, i);
        i += c.length;
        if (!hidden(c.code)) {
            append(out, c.code);
            continue;
        }
        char escape[16];
        const auto code = static_cast<unsigned>(c.code);
        std::snprintf(escape, sizeof escape, code < 0x100 ? "\\x%02X" : "\\u{%04X}", code);
        out += escape;
    }
    return out;
}

std::string code_point(char32_t code) {
    char name[16];
    std::snprintf(name, sizeof name, "U+%04X", static_cast<unsigned>(code));
    return name;
}

}  // namespace snell::utf8
