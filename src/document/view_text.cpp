#include "src/document/view_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "parser/text/real.h"

namespace snell {

namespace {

struct Part {
    std::string_view name;
    double Transformation::*value;
};
constexpr std::array<Part, 7> parts{{{"rotate_x", &Transformation::rotate_x},
                                     {"rotate_y", &Transformation::rotate_y},
                                     {"rotate_z", &Transformation::rotate_z},
                                     {"scale", &Transformation::scale},
                                     {"x", &Transformation::x},
                                     {"y", &Transformation::y},
                                     {"z", &Transformation::z}}};

void add(std::string& text, std::string_view prefix, const Transformation& t) {
    const Transformation none;
    for (const Part& part : parts)
        if (t.*part.value != none.*part.value)
            text += fmt::format("{}{}{}={}", text.empty() ? "" : ",", prefix, part.name, t.*part.value);
}

// Returns the transformation that a prefix such as "eye." means, or null.
Transformation* named(std::string_view prefix, View& view) {
    if (prefix.empty()) return &view.scene;
    if (prefix == "eye.") return &view.eye;
    if (prefix == "texture.") return &view.texture;
    constexpr std::string_view object = "object";
    unsigned draw = 0;
    const char* end = prefix.data() + prefix.size() - 1;
    if (!prefix.starts_with(object)) return nullptr;
    const auto [stop, error] = std::from_chars(prefix.data() + object.size(), end, draw);
    return error == std::errc() && stop == end ? &view.objects[draw] : nullptr;
}

std::string parse_one(std::string_view text, View& view) {
    const std::size_t equals = text.find('='), dot = text.substr(0, equals).find('.');
    if (equals == text.npos) return fmt::format("'{}' sets nothing: write rotate_x=30", text);
    if (text.substr(0, equals) == "projection") {
        const std::string_view which = text.substr(equals + 1);
        view.projection = which == "ortho" ? Projection::ortho : Projection::perspective;
        if (which == "ortho" || which == "perspective") return {};
        return fmt::format("'{}' is not a projection; use perspective or ortho", which);
    }
    const std::size_t begin = dot == text.npos ? 0 : dot + 1;
    const std::string_view name = text.substr(begin, equals - begin), number = text.substr(equals + 1);
    double value = 0;
    const auto [stop, error] = read_real(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || stop != number.data() + number.size() || !std::isfinite(value))
        return fmt::format("'{}' is no number", number);
    if (text.substr(0, equals) == "background") {
        view.background = value;
        return value >= 0 && value <= 1 ? "" : fmt::format("'{}' is not a brightness from 0 to 1", number);
    }
    Transformation* transformation = named(text.substr(0, begin), view);
    for (const Part& part : parts)
        if (transformation && part.name == name) {
            transformation->*part.value = value;
            return {};
        }
    return fmt::format(
        "there is no '{}': rotate_x, rotate_y, rotate_z, scale, x, y, z, also after 'eye.', 'texture.' and 'object0.'; "
        "projection, background",
        text.substr(0, equals));
}

}  // namespace

std::string view_text(const View& view) {
    std::string text;
    add(text, "", view.scene);
    add(text, "eye.", view.eye);
    add(text, "texture.", view.texture);
    for (const auto& [draw, transformation] : view.objects) add(text, fmt::format("object{}.", draw), transformation);
    const auto say = [&text](const std::string& what) { text += (text.empty() ? "" : ",") + what; };
    if (view.projection != Projection::scene)
        say(view.projection == Projection::ortho ? "projection=ortho" : "projection=perspective");
    if (view.background) say(fmt::format("background={}", *view.background));
    return text;
}

std::string parse_view(std::string_view text, View& view) {
    while (!text.empty()) {
        const std::string_view one = text.substr(0, text.find(','));
        if (std::string wrong = parse_one(one, view); !wrong.empty()) return wrong;
        text.remove_prefix(std::min(one.size() + 1, text.size()));
    }
    return {};
}

}  // namespace snell
