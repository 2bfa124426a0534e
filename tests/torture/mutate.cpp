#include "tests/torture/mutate.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

#include "tests/words.h"

namespace snell::torture {
namespace {

constexpr std::size_t longest = 1 << 20;

const std::vector<std::string> numbers{
    "0",     "-0.",   "-1",         "1e38",       "-3.5e38", "1e39",
    "1e400", "1e-45", "nan",        "-nan",       "inf",     "-inf",
    "NaN",   "1e",    "0x7fffffff", "2147483647", ".",       "-2147483648",
    "65535", "65536", "4096",       "100000",     "1e6",     "16385",
    "255",   "256",   "1.5",        ".0000001",   "1e-320",  "4294967296",
    "-7",    "1,5",   "1.2.3",      "--1",        "+3",      "9999999999999999999999",
    "3f",    "012",   "1000",       "2"};

// Characters that mean something to terminals, to readers of text, or to the languages.
const std::vector<std::string> characters =
    words(std::string(1, '\0') +
              "|\x1b[31m|\x1b]0;x\x07|\r|\n|\t|\x7f|\xff|\x80|\302\23331m|\xe2\x80\xae|\xc0\xaf|\xed\xa0\x80|"
              "\xef\xbb\xbf|\xf4\x90\x80\x80|\\|\"|'|#|%s%n|<|>|[|]|{|}|(|)|;|,|//|/*|*/|\\\n|..|/|~|$(x)|`",
          '|');

struct Range {
    std::size_t begin = 0, end = 0;
    std::size_t size() const { return end - begin; }
};

// Some part of the text, mostly a small one.
Range some(const std::string& text, Random& random, std::size_t most) {
    const std::size_t begin = below(random, text.size() + 1);
    return {begin, begin + below(random, std::min(most, text.size() - begin) + 1)};
}

bool in_number(char c) { return std::isdigit(static_cast<unsigned char>(c)) || c == '.'; }
bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::vector<Range> ranges(const std::string& text, bool (*inside)(char), bool digit_first) {
    std::vector<Range> found;
    for (std::size_t at = 0; at < text.size();) {
        if (!inside(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && inside(text[end])) ++end;
        const bool digit = in_number(text[at]);
        if (digit == digit_first) found.push_back({at, end});
        at = end;
    }
    return found;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        lines.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return lines;
}

void join(std::string& text, const std::vector<std::string>& lines) {
    text.clear();
    for (const std::string& line : lines) text += line;
}

void flip_bits(std::string& text, Random& random) {
    for (std::size_t left = 1 + below(random, 4); left > 0 && !text.empty(); --left) {
        char& byte = text[below(random, text.size())];
        byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << below(random, 8)));
    }
}

void replace_number(std::string& text, Random& random) {
    const std::vector<Range> found = ranges(text, in_number, true);
    if (found.empty()) return;
    const Range at = choose(random, found);
    text.replace(at.begin, at.size(), choose(random, numbers));
}

void repeat(std::string& text, const Range& part, std::size_t times) {
    const std::string once = text.substr(part.begin, part.size());
    if (once.empty()) return;
    times = std::min(times, (longest - std::min(longest, text.size())) / once.size());
    std::string many;
    for (std::size_t i = 0; i < times; ++i) many += once;
    text.insert(part.end, many);
}

std::size_t times(Random& random) {
    constexpr std::array<std::size_t, 6> counts{1, 1, 2, 10, 100, 5000};
    return counts[below(random, counts.size())];
}

void move_lines(std::string& text, Random& random, std::size_t way) {
    std::vector<std::string> lines = lines_of(text);
    if (lines.empty()) return;
    const std::size_t at = below(random, lines.size());
    const std::size_t count = 1 + below(random, std::min<std::size_t>(lines.size() - at, 4));
    const auto from = lines.begin() + static_cast<std::ptrdiff_t>(at);
    if (way == 0)
        lines.erase(from, from + static_cast<std::ptrdiff_t>(count));
    else if (way == 1)
        std::swap(lines[at], lines[below(random, lines.size())]);
    else
        std::rotate(lines.begin(), from, lines.end());
    join(text, lines);
}

void duplicate_line(std::string& text, Random& random) {
    const std::vector<std::string> lines = lines_of(text);
    if (lines.empty()) return;
    const std::size_t at = below(random, lines.size());
    std::size_t begin = 0;
    for (std::size_t i = 0; i < at; ++i) begin += lines[i].size();
    repeat(text, {begin, begin + lines[at].size()}, times(random));
}

// The beginning of one with the end of the other.
void splice(std::string& text, const std::string& other, Random& random) {
    const std::size_t from = below(random, other.size() + 1);
    text.resize(below(random, text.size() + 1));
    text += other.substr(from);
}

void exchange_names(std::string& text, Random& random) {
    const std::vector<Range> names = ranges(text, in_name, false);
    if (names.empty()) return;
    const Range to = choose(random, names), from = choose(random, names);
    text.replace(to.begin, to.size(), text.substr(from.begin, from.size()));
}

void insert_word(std::string& text, const std::vector<std::string>& words, Random& random) {
    if (words.empty()) return;
    const std::string blank = below(random, 4) == 0 ? "" : below(random, 4) == 0 ? "\n" : " ";
    text.insert(below(random, text.size() + 1), blank + choose(random, words) + blank);
}

std::string wide(const std::string& text, bool low_first) {
    std::string out = low_first ? "\xff\xfe" : "\xfe\xff";
    for (const char c : text) {
        out += low_first ? c : '\0';
        out += low_first ? '\0' : c;
    }
    return out;
}

void replace_all(std::string& text, const std::string& what, const std::string& with) {
    for (std::size_t at = text.find(what); at != std::string::npos && text.size() < longest;
         at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

std::string encode(std::string& text, Random& random) {
    switch (below(random, 8)) {
        case 0:
            return text = wide(text, true), "as UTF-16";
        case 1:
            return text = wide(text, false), "as UTF-16, high bytes first";
        case 2:
            return text = wide(text, true).substr(2), "as UTF-16 without a mark";
        case 3:
            return replace_all(text, "\n", "\r"), "with the line ends of old Macs";
        case 4:
            return replace_all(text, "\n", "\r\n"), "with the line ends of Windows";
        case 5:
            return replace_all(text, " ", "\xa0"), "with blanks of Latin-1";
        case 6:
            return replace_all(text, "e", "\xe9"), "with accents of Latin-1";
        default:
            return text.insert(0, "\xef\xbb\xbf"), "with a byte order mark";
    }
}

}  // namespace

std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        if (in_name(text[at]))
            while (end < text.size() && (in_name(text[end]) || text[end] == '.')) ++end;
        if (!std::isspace(static_cast<unsigned char>(text[at]))) words.push_back(text.substr(at, end - at));
        at = end;
    }
    return words;
}

void learn(Dictionary& dictionary, Language language, const std::string& text) {
    const bool scene = language == Language::scene;
    std::vector<std::string>& words = scene ? dictionary.scene_words : dictionary.shader_words;
    const std::vector<std::string> more = words_of(text);
    words.insert(words.end(), more.begin(), more.end());
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    (scene ? dictionary.scenes : dictionary.shaders).push_back(text);
}

std::string damage(std::string& text, Language language, const Dictionary& dictionary, Random& random) {
    // Now and then the words of the other language.
    const bool scene = (language == Language::scene) != (below(random, 12) == 0);
    const std::vector<std::string>& words = scene ? dictionary.scene_words : dictionary.shader_words;
    const std::vector<std::string>& texts = scene ? dictionary.scenes : dictionary.shaders;
    Range part;
    switch (below(random, 17)) {
        case 0:
            return flip_bits(text, random), "bits flipped";
        case 1:
            return text.insert(below(random, text.size() + 1), choose(random, characters)), "characters inserted";
        case 2:
        case 3:
            return insert_word(text, words, random), "a word inserted";
        case 4:
            return move_lines(text, random, 0), "lines deleted";
        case 5:
            return move_lines(text, random, 1), "lines exchanged";
        case 6:
            return move_lines(text, random, 2), "the end before the beginning";
        case 7:
            return duplicate_line(text, random), "a line repeated";
        case 8:
        case 9:
        case 10:
            return replace_number(text, random), "another number";
        case 11:
            return exchange_names(text, random), "another name";
        case 12:
            return text.resize(below(random, text.size() + 1)), "truncated";
        case 13:
            return texts.empty() ? "" : (splice(text, choose(random, texts), random), "spliced");
        case 14:
            part = some(text, random, 40);
            return text.erase(part.begin, part.size()), "a part deleted";
        case 15:
            part = some(text, random, 40);
            return repeat(text, part, times(random)), "a part repeated";
        default:
            return encode(text, random);
    }
}

}  // namespace snell::torture
