#include "src/app/grade/similarity.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_map>

#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"

namespace snell::app {

namespace {

constexpr std::size_t gram = 16;    // tokens of a fingerprint
constexpr std::size_t window = 10;  // of so many fingerprints one is kept
constexpr std::size_t fewest = 8;   // in common, of what is told
constexpr double least_share = .4;
constexpr std::size_t most_pairs = 100;
constexpr std::size_t most_text = 200'000;  // bytes of a record's texts

struct TokenOfLine {
    std::uint64_t hash;
    std::uint32_t line;
};

std::uint64_t mixed(std::uint64_t hash, std::uint64_t next) {
    hash ^= next + 0x9e3779b97f4a7c15u + (hash << 6) + (hash >> 2);
    return hash * 0xff51afd7ed558ccdu ^ (hash >> 29);
}

std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

std::vector<TokenOfLine> tokens_of(std::string_view text) {
    using glsl::Kind;
    std::vector<TokenOfLine> tokens;
    std::uint32_t line = 1;
    std::size_t at = 0;
    const auto move_to = [&](std::size_t to) {
        line += static_cast<std::uint32_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                      text.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
        at = to;
    };
    while (at < text.size()) {
        move_to(std::max(glsl::skip_trivia(text, at).end, at));
        if (at >= text.size()) break;
        if (text[at] == '#') {
            move_to(std::max(glsl::directive_end(text, at), at + 1));
            continue;
        }
        const glsl::Lexeme token = glsl::lex(text, at);
        if (token.kind == Kind::end) break;
        std::string_view word = token.text;
        if (token.kind == Kind::integer || token.kind == Kind::real) word = "0";
        if (token.kind == Kind::identifier && !glsl::is_language_word(word) && !word.starts_with("gl_")) word = "x";
        tokens.push_back({hash_of(word), line});
        move_to(std::max(at + token.text.size(), at + 1));
    }
    return tokens;
}

}  // namespace

void add_prints(Record& record, std::string name, std::string_view text) {
    std::size_t held = text.size();
    for (const SourceText& other : record.texts) {
        if (other.text == text) return;
        held += other.text.size();
    }
    if (held > most_text) return;
    const auto index = static_cast<std::uint32_t>(record.texts.size());
    record.texts.push_back({std::move(name), std::string(text)});
    const std::vector<TokenOfLine> tokens = tokens_of(text);
    std::vector<Print> grams;
    for (std::size_t i = 0; i + gram <= tokens.size(); ++i) {
        Print print{0, index, tokens[i].line, tokens[i + gram - 1].line};
        for (std::size_t k = i; k < i + gram; ++k) print.hash = mixed(print.hash, tokens[k].hash);
        grams.push_back(print);
    }
    // The least of each window, the last of equal ones; each once.
    std::size_t last = grams.size();
    for (std::size_t i = 0; i < grams.size(); ++i) {
        const std::size_t end = std::min(i + window, grams.size());
        std::size_t least = i;
        for (std::size_t k = i; k < end; ++k)
            if (grams[k].hash <= grams[least].hash) least = k;
        if (least != last) record.prints.push_back(grams[least]);
        last = least;
        if (end == grams.size()) break;
    }
}

namespace {

using Prints = std::set<std::uint64_t>;

// Equal records, by what they have.
std::vector<Alike> equal_groups(const std::vector<Prints>& own) {
    std::map<Prints, std::vector<std::size_t>> holders;
    for (std::size_t i = 0; i < own.size(); ++i)
        if (own[i].size() >= fewest) holders[own[i]].push_back(i);
    std::vector<Alike> groups;
    for (auto& [prints, who] : holders)
        if (who.size() > 1) groups.push_back({std::move(who), 1, {prints.begin(), prints.end()}});
    std::sort(groups.begin(), groups.end(), [](const Alike& x, const Alike& y) {
        return std::pair(y.who.size(), x.who) < std::pair(x.who.size(), y.who);
    });
    return groups;
}

// Pairs that share parts and are not equal.
std::vector<Alike> similar_pairs(const std::vector<Prints>& own) {
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> holders;
    for (std::size_t i = 0; i < own.size(); ++i)
        for (const std::uint64_t hash : own[i]) holders[hash].push_back(i);
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::uint64_t>> common;
    for (const auto& [hash, which] : holders) {
        // What a third of a class has is common knowledge, and pairs of thousands would take long.
        if (which.size() > std::max<std::size_t>(8, own.size() / 3)) continue;
        for (std::size_t i = 0; i < which.size(); ++i)
            for (std::size_t k = i + 1; k < which.size(); ++k) common[{which[i], which[k]}].push_back(hash);
    }
    std::vector<Alike> pairs;
    for (auto& [who, hashes] : common) {
        const Prints &a = own[who.first], &b = own[who.second];
        const double share = static_cast<double>(hashes.size()) / static_cast<double>(std::min(a.size(), b.size()));
        if (hashes.size() < fewest || share < least_share || a == b) continue;
        std::sort(hashes.begin(), hashes.end());
        pairs.push_back({{who.first, who.second}, share, std::move(hashes)});
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Alike& x, const Alike& y) {
        return std::pair(x.share, x.hashes.size()) > std::pair(y.share, y.hashes.size());
    });
    if (pairs.size() > most_pairs) pairs.resize(most_pairs);
    return pairs;
}

}  // namespace

std::vector<Alike> alike_records(const std::vector<const Record*>& records, const Prints& known) {
    std::vector<Prints> own(records.size());
    for (std::size_t i = 0; i < records.size(); ++i)
        for (const Print& print : records[i]->prints)
            if (!known.contains(print.hash)) own[i].insert(print.hash);
    std::vector<Alike> all = equal_groups(own), pairs = similar_pairs(own);
    std::move(pairs.begin(), pairs.end(), std::back_inserter(all));
    return all;
}

}  // namespace snell::app
