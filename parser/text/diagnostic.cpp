#include "parser/text/diagnostic.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell {
namespace {

// No suggestion is made for longer words, which bounds the cost of hostile input.
constexpr std::size_t longest_word = 64;

// Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours, each once.
int distance(std::string_view a, std::string_view b) {
    using Row = std::array<int, longest_word + 1>;
    Row before{}, previous{}, current{};
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const char x = lower(a[i - 1]), y = lower(b[j - 1]);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (x == y ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && x == lower(b[j - 2]) && y == lower(a[i - 2]);
            if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
        }
        before = previous;
        previous = current;
    }
    return previous[b.size()];
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    return std::max(a.size(), b.size()) > longest_word ? static_cast<int>(longest_word) : distance(a, b);
}

const char* name(Severity severity) {
    constexpr const char* names[] = {"note", "warning", "error"};
    return names[static_cast<std::size_t>(severity)];
}

Diagnostic& Diagnostics::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::error) ++errors_;
    if (diagnostic.severity == Severity::warning) ++warnings_;
    if (diagnostic.message.size() > longest_) diagnostic.message.resize(longest_);
    if (diagnostic.help.size() > longest_) diagnostic.help.resize(longest_);
    if (items_.size() >= most_) {
        if (items_.size() == most_) {
            ++errors_;
            items_.push_back({Severity::error,
                              "too-many-diagnostics",
                              {},
                              "what else is wrong is left out",
                              limit_help(most_, &Limits::diagnostics),
                              {},
                              false});
        }
        return nowhere_ = std::move(diagnostic);
    }
    return items_.emplace_back(std::move(diagnostic));
}

Diagnostic& Diagnostics::error(std::string_view code, Span span, std::string message, std::string help) {
    return add({Severity::error, std::string(code), span, std::move(message), std::move(help), {}, true});
}

Diagnostic& Diagnostics::warning(std::string_view code, Span span, std::string message, std::string help) {
    return add({Severity::warning, std::string(code), span, std::move(message), std::move(help), {}, true});
}

Diagnostic& Diagnostics::error(std::string_view code, std::string message, std::string help) {
    return add({Severity::error, std::string(code), {}, std::move(message), std::move(help), {}, false});
}

Diagnostic& Diagnostics::warning(std::string_view code, std::string message, std::string help) {
    return add({Severity::warning, std::string(code), {}, std::move(message), std::move(help), {}, false});
}

void Diagnostics::add_once(Diagnostic diagnostic) {
    const auto same = ranges::find_if(items_, [&](const Diagnostic& d) {
        return d.has_span && d.span.file == diagnostic.span.file && d.code == diagnostic.code &&
               d.message == diagnostic.message && d.help == diagnostic.help;
    });
    if (same == items_.end()) {
        add(std::move(diagnostic));
    } else if (!same->is_at(diagnostic.code, diagnostic.span)) {
        if (diagnostic.span.begin < same->span.begin) std::swap(diagnostic.span, same->span);
        same->fixes.insert(same->fixes.end(), diagnostic.fixes.begin(), diagnostic.fixes.end());
        same->also.push_back(diagnostic.span);
    }
}

void Diagnostics::append(const Diagnostics& others) {
    const std::size_t count = others.items_.size();  // `others` may be this
    for (std::size_t i = 0; i < count; ++i) add(Diagnostic(others.items_[i]));
}

void Diagnostics::sort() {
    std::stable_sort(items_.begin(), items_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        if (a.has_span != b.has_span) return a.has_span;
        if (!a.has_span) return false;
        return a.span.file != b.span.file ? a.span.file < b.span.file : a.span.begin < b.span.begin;
    });
}

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
    if (word.empty() || word.size() > longest_word) return {};
    const int allowed = word.size() <= 3 ? 1 : std::min(3, static_cast<int>(word.size() + 2) / 3);
    std::string_view best;
    int best_distance = allowed + 1;
    for (const std::string_view candidate : candidates) {
        if (candidate.size() > longest_word) continue;
        if (std::abs(static_cast<int>(candidate.size()) - static_cast<int>(word.size())) >= best_distance) continue;
        const int d = distance(word, candidate);
        // A candidate that shares no letter with the word is not what the user meant.
        if (d < best_distance && d < static_cast<int>(std::max(word.size(), candidate.size()))) {
            best = candidate;
            best_distance = d;
        }
    }
    return best;
}

}  // namespace snell
