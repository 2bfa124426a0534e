#include "src/app/batch/pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"

namespace snell::app {

namespace {

std::string unknown_name(std::string_view name, const std::vector<std::string>& names) {
    const std::string_view near = nearest(name, {names.begin(), names.end()});
    return near.empty() ? fmt::format("there is no {{{}}}: there are {{{}}}", name, fmt::join(names, "}, {"))
                        : fmt::format("there is no {{{}}}: did you mean {{{}}}?", name, near);
}

// Formats the value with a format of fmt, which may be one for whole numbers.
std::optional<std::string> formatted(const std::string& format, const AxisValue& value) {
    try {
        if (!value.number) return fmt::format(fmt::runtime(format), value.shown());
        const double number = *value.number;
        const bool whole = std::floor(number) == number && std::abs(number) < 1e15;
        // A whole number is formatted as such, so that "04" of 7 gives 0007.
        if (whole && format.find_first_of(".aefgAEFG") == std::string::npos)
            return fmt::format(fmt::runtime(format), static_cast<long long>(number));
        return fmt::format(fmt::runtime(format), number);
    } catch (const fmt::format_error&) {
        return std::nullopt;
    }
}

}  // namespace

std::optional<Pattern> Pattern::parse(std::string_view text, const std::vector<std::string>& names,
                                      std::string& error) {
    Pattern pattern;
    pattern.pieces_.push_back({"", names.size(), "", ""});
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string& literal = pattern.pieces_.back().literal;
        if (text[i] != '{' && text[i] != '}') {
            literal += text[i];
            continue;
        }
        if (i + 1 < text.size() && text[i + 1] == text[i]) {
            literal += text[i++];
            continue;
        }
        const std::size_t end = text.find('}', i);
        if (text[i] == '}' || end == std::string_view::npos) {
            error = fmt::format("there is a single brace in '{}'; write a brace twice to keep it", text);
            return std::nullopt;
        }
        const std::string_view inside = text.substr(i + 1, end - i - 1);
        const std::size_t colon = std::min(inside.find(':'), inside.size());
        const auto name = ranges::find(names, inside.substr(0, colon));
        if (name == names.end()) {
            error = unknown_name(inside.substr(0, colon), names);
            return std::nullopt;
        }
        Piece& piece = pattern.pieces_.back();
        piece.name = static_cast<std::size_t>(name - names.begin());
        piece.placeholder = fmt::format("{{{}}}", inside);
        if (colon < inside.size()) piece.format = fmt::format("{{{}}}", inside.substr(colon));
        pattern.pieces_.push_back({"", names.size(), "", ""});
        i = end;
    }
    return pattern;
}

std::optional<std::string> Pattern::expand(const std::vector<AxisValue>& values, std::string& error) const {
    std::string text;
    for (const Piece& piece : pieces_) {
        text += piece.literal;
        if (piece.name >= values.size()) continue;
        const AxisValue& value = values[piece.name];
        auto shown = piece.format.empty() ? value.shown() : formatted(piece.format, value);
        if (!shown) {
            error = fmt::format("'{}' is not a format for '{}'", piece.placeholder, value.shown());
            return std::nullopt;
        }
        // A slash in a value must not name a folder.
        std::replace(shown->begin(), shown->end(), '/', '_');
        text += *shown;
    }
    return text;
}

std::string fixed_folder(const std::string& pattern) {
    return std::filesystem::path(pattern.substr(0, pattern.find('{'))).parent_path().string();
}

}  // namespace snell::app
