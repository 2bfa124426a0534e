#include "src/app/batch/shots.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <unordered_map>

#include <fmt/format.h>

#include "parser/text/diagnostic.h"
#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell::app {

namespace {

// Each of these returns "" or the error.
std::string check_distinct(const Shots& shots) {
    std::unordered_map<std::string, std::size_t> taken;
    for (std::size_t i = 0; i < shots.files.size(); ++i) {
        const auto [other, is_new] =
            taken.emplace(std::filesystem::path(shots.files[i]).lexically_normal().string(), i);
        if (is_new) continue;
        const Shot first = shots.shot(other->second), second = shots.shot(i);
        if (first.scene != second.scene && first.at == second.at)
            return fmt::format(
                "the pictures of '{}' and '{}' would both be '{}'\n   help: {{path}} in the name tells "
                "scenes apart; {{dir}} is the name of a scene's folder",
                shots.scenes[first.scene], shots.scenes[second.scene], shots.files[i]);
        const auto differs = std::mismatch(first.at.begin(), first.at.end(), second.at.begin(), second.at.end()).first -
                             first.at.begin();
        return fmt::format("pictures {} and {} would both be '{}': {{{}}} or {{index}} in the name tells them apart",
                           first.index, second.index, shots.files[i],
                           shots.axes[static_cast<std::size_t>(differs)].name);
    }
    return {};
}

std::string check_count(const Shots& shots) {
    std::size_t count = shots.scenes.size();
    for (const Axis& axis : shots.axes) {
        if (count > 0 && axis.values.size() > max_pictures / count)
            return fmt::format("these are more than {} pictures, which is the most for one command", max_pictures);
        count *= axis.values.size();
    }
    return {};
}

std::string check_names(const std::vector<Axis>& axes) {
    for (auto axis = axes.begin(); axis != axes.end(); ++axis)
        if (std::any_of(axes.begin(), axis, [&](const Axis& other) { return other.name == axis->name; }))
            return fmt::format("'{}' varies twice", axis->name);
    return {};
}

bool distinct(std::vector<std::string> names) {
    ranges::sort(names);
    return std::adjacent_find(names.begin(), names.end()) == names.end();
}

std::vector<std::string> stems_of(const std::vector<std::string>& scenes) {
    std::vector<std::string> stems;
    for (const std::string& scene : scenes) stems.push_back(std::filesystem::path(scene).stem().string());
    return stems;
}

// Stem, name of the folder, name of the folder above.
std::vector<AxisValue> names_of_scene(const std::string& scene) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::absolute(scene, error).lexically_normal();
    return {{path.stem().string(), std::nullopt},
            {path.parent_path().filename().string(), std::nullopt},
            {path.parent_path().parent_path().filename().string(), std::nullopt}};
}

// Numbers the files of frames whose pattern has no placeholder.
std::string numbered(const std::string& pattern) {
    const std::filesystem::path path(pattern);
    return (path.parent_path() / (path.stem().string() + "-{frame:04}" + path.extension().string())).string();
}

}  // namespace

std::optional<Shard> parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto index = read_whole<std::size_t>(text.substr(0, slash)),
               count = read_whole<std::size_t>(text.substr(slash + 1));
    if (!index || !count || *index >= *count) return std::nullopt;
    return Shard{*index, *count};
}

std::size_t Shots::per_scene() const {
    std::size_t count = 1;
    for (const Axis& axis : axes) count *= axis.values.size();
    return count;
}

Shot Shots::shot(std::size_t index) const {
    Shot shot{index, index / per_scene(), std::vector<std::size_t>(axes.size())};
    std::size_t rest = index % per_scene();
    for (std::size_t axis = axes.size(); axis-- > 0;) {
        shot.at[axis] = rest % axes[axis].values.size();
        rest /= axes[axis].values.size();
    }
    return shot;
}

std::string Shots::label(const Shot& shot) const {
    std::string text = labels[shot.scene];
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", axes[axis].name, value(shot, axis).shown());
    return text;
}

std::vector<std::string> distinguishing_paths(const std::vector<std::string>& paths) {
    std::vector<std::vector<std::string>> parts;
    for (const std::string& path : paths) {
        parts.emplace_back();
        const auto whole_path = std::filesystem::path(path).lexically_normal().replace_extension();
        for (const auto& part : whole_path)
            if (part != "/") parts.back().push_back(part.string());
    }
    const auto all_share = [&](auto end) {
        return ranges::all_of(parts, [&](const auto& own) { return own.size() > 1 && end(own) == end(parts[0]); });
    };
    while (parts.size() > 1 && all_share([](const auto& own) { return own.back(); }))
        for (auto& own : parts) own.pop_back();
    while (!parts.empty() && all_share([](const auto& own) { return own.front(); }))
        for (auto& own : parts) own.erase(own.begin());
    std::vector<std::string> short_paths;
    for (const auto& own : parts) short_paths.push_back(fmt::format("{}", fmt::join(own, "/")));
    return short_paths;
}

std::optional<Shots> plan_shots(std::vector<std::string> scenes, std::vector<Axis> axes, const std::string& pattern,
                                std::string& error) {
    Shots shots{std::move(scenes), std::move(axes), {}, {}, {}};
    shots.paths = distinguishing_paths(shots.scenes);
    shots.labels = stems_of(shots.scenes);
    if (!distinct(shots.labels)) shots.labels = shots.paths;
    if (shots.scenes.size() == 1) shots.labels.front().clear();
    if (error = check_names(shots.axes); error.empty()) error = check_count(shots);
    if (!error.empty()) return std::nullopt;
    const bool frames =
        ranges::any_of(shots.axes, [](const Axis& axis) { return axis.frames && axis.values.size() > 1; });
    const bool told = pattern.find("{frame") != std::string::npos || pattern.find("{index") != std::string::npos;
    std::vector<std::string> names{"stem", "dir", "parent", "path", "index"};
    for (const Axis& axis : shots.axes) names.push_back(axis.name);
    const auto parsed = Pattern::parse(frames && !told ? numbered(pattern) : pattern, names, error);
    if (!parsed) return std::nullopt;
    const std::size_t count = shots.scenes.size() * shots.per_scene();
    shots.files.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Shot shot = shots.shot(i);
        std::vector<AxisValue> values = names_of_scene(shots.scenes[shot.scene]);
        values.push_back({shots.paths[shot.scene], std::nullopt});
        values.push_back({std::to_string(i), static_cast<double>(i)});
        for (std::size_t axis = 0; axis < shots.axes.size(); ++axis) values.push_back(shots.value(shot, axis));
        auto file = parsed->expand(values, error);
        if (!file) return std::nullopt;
        shots.files.push_back(std::move(*file));
    }
    error = check_distinct(shots);
    return error.empty() ? std::optional(std::move(shots)) : std::nullopt;
}

namespace {

template <class Number>
std::optional<Number> number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // A number beyond the largest one counts as infinite.
    if (error == std::errc::result_out_of_range) return std::numeric_limits<Number>::infinity();
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

// Splits at commas outside of brackets.
std::vector<std::string_view> elements(std::string_view text) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0, depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '[') ++depth;
        if (text[i] == ']' && depth > 0) --depth;
        if (text[i] != ',' || depth > 0) continue;
        parts.push_back(trimmed(text.substr(begin, i - begin)));
        begin = i + 1;
    }
    parts.push_back(trimmed(text.substr(begin)));
    return parts;
}

// Interpolates with more digits than a double has, so that 1:2.5:16 gives 1.2 and not its neighbour.
double between(std::string_view first, std::string_view last, std::size_t k, std::size_t steps) {
    const auto a = number<long double>(first), b = number<long double>(last);
    const auto t = static_cast<long double>(k), n = static_cast<long double>(steps);
    return static_cast<double>((*a * (n - t) + *b * t) / n);
}

// Adds the values of FIRST:LAST:COUNT. Returns "" or the error.
std::string fill_range(Axis& axis, std::string_view text) {
    const std::size_t one = text.find(':'), two = text.find(':', one + 1);
    if (two == std::string_view::npos || text.find(':', two + 1) != std::string_view::npos)
        return fmt::format("'{}' is not a range; write FIRST:LAST:COUNT", text);
    const std::string_view first = trimmed(text.substr(0, one)), last = trimmed(text.substr(one + 1, two - one - 1)),
                           steps = trimmed(text.substr(two + 1));
    const auto a = number<double>(first), b = number<double>(last), count = number<double>(steps);
    if (!a || !b || !count || !std::isfinite(*a) || !std::isfinite(*b))
        return fmt::format("'{}' is not a range of finite numbers; write FIRST:LAST:COUNT", text);
    if (!(*count >= 1) || *count > static_cast<double>(max_pictures) || std::floor(*count) != *count)
        return fmt::format("'{}' is not a number of values from 1 to {}", steps, max_pictures);
    const auto n = static_cast<std::size_t>(*count);
    if (n == 1 && *a != *b) return fmt::format("'{}': one value cannot be at both ends", text);
    for (std::size_t k = 0; k < n; ++k) {
        const double value = k == 0 ? *a : k == n - 1 ? *b : between(first, last, k, n - 1);
        axis.values.push_back({fmt::format("{}", value), value});
    }
    return {};
}

// Adds the values of A,B,C. Returns "" or the error.
std::string fill_list(Axis& axis, std::string_view text) {
    for (const std::string_view part : elements(text)) {
        if (part.empty()) return "a value is empty";
        const auto value = number<double>(part);
        if (value && !std::isfinite(*value)) return fmt::format("'{}' is not finite", part);
        if (axis.values.size() == max_pictures) return fmt::format("there are more than {} values", max_pictures);
        axis.values.push_back({std::string(part), value});
    }
    return {};
}

std::string unknown_name(std::string_view name, const std::vector<std::string>& names) {
    const std::string_view near = nearest(name, {names.begin(), names.end()});
    return near.empty() ? fmt::format("there is no {{{}}}: there are {{{}}}", name, fmt::join(names, "}, {"))
                        : fmt::format("there is no {{{}}}: did you mean {{{}}}?", name, near);
}

constexpr double longest_name = 255;

// The largest number in a format: memory is taken for as many characters.
double widest(std::string_view format) {
    double most = 0, number = 0;
    for (const char c : format) most = std::max(most, number = c >= '0' && c <= '9' ? 10 * number + (c - '0') : 0);
    return most;
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

std::string AxisValue::shown() const {
    if (number) return fmt::format("{}", *number);
    if (written.size() > 1 && written.front() == '[' && written.back() == ']')
        return written.substr(1, written.size() - 2);
    return written;
}

std::optional<Axis> parse_axis(std::string_view text, std::string& error) {
    const std::size_t equals = text.find('=');
    Axis axis;
    axis.name = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || axis.name.empty()) {
        error = fmt::format("'{}' varies nothing: write NAME=FIRST:LAST:COUNT or NAME=A,B,C", text);
        return std::nullopt;
    }
    const std::string_view values = trimmed(text.substr(equals + 1));
    const std::string problem =
        values.find(':') == std::string_view::npos ? fill_list(axis, values) : fill_range(axis, values);
    if (problem.empty()) return axis;
    error = fmt::format("{}: {}", axis.name, problem);
    return std::nullopt;
}

Axis frames_axis(std::size_t count) {
    Axis axis{"frame", {}, true};
    for (std::size_t k = 0; k < count; ++k) axis.values.push_back({std::to_string(k), static_cast<double>(k)});
    return axis;
}

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
        if (widest(piece.format) > longest_name) {
            error = fmt::format("'{}' asks for more than the {} characters of a file's name", piece.placeholder,
                                longest_name);
            return std::nullopt;
        }
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
