// Values that a scene may begin with, by the type and the words of a uniform's name.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/language/offers/offers.h"
#include "src/plan/plan.h"

namespace snell::language {

namespace {

// uLightColor → u light color
std::vector<std::string> words_of_name(std::string_view name) {
    std::vector<std::string> words;
    bool begins = true;
    for (const char c : name) {
        const bool upper = c >= 'A' && c <= 'Z';
        if (c == '_') {
            begins = true;
            continue;
        }
        if (begins || (upper && (words.empty() || words.back().size() > 1 || words.size() == 1))) words.emplace_back();
        begins = false;
        words.back() += lower(c);
    }
    return words;
}

struct Usual {
    std::string_view words;  // one of them is in the name
    std::array<std::string_view, 3> range;
};
constexpr Usual usual[] = {
    {"ka ambient", {"0.", ".2", "1."}},
    {"kd diffuse", {"0.", ".6", "1."}},
    {"ks specular", {"0.", ".3", "1."}},
    {"shininess shine exponent", {"1.", "32.", "1000."}},
    {"eta", {".1", "1.1", "5."}},
    {"ior index", {"1.", "1.5", "2.7"}},
    {"mix alpha blend opacity weight roughness rough metalness share fraction", {"0.", ".5", "1."}},
    {"white", {"0.", "0.", "1."}},
    {"amp amplitude height depth strength", {"0.", ".1", "1."}},
    {"freq frequency", {"0.", "1.", "10."}},
    {"speed scale size zoom gain factor", {"0.", "1.", "10."}},
    {"radius rad", {"0.", "1.", "5."}},
    {"tol tolerance width thickness", {"0.", ".1", "1."}},
    {"deg degrees", {"0.", "0.", "360."}},
    {"angle theta phi rot rotation rotate twist", {"-3.14", "0.", "3.14"}},
};

bool has_word(const std::vector<std::string>& words, std::string_view wanted) {
    for (const std::string_view one : split(wanted))
        if (ranges::find(words, one) != words.end()) return true;
    return false;
}

bool color_name(std::string_view name) { return contains(name, "color") || contains(name, "colour"); }

// With its point, as scenes write reals: "1.", ".5".
std::string real_text(double value) {
    std::string text = text_of::number(value);
    if (text.starts_with("-0.")) text.erase(1, 1);
    return text.find_first_of(".en") == std::string::npos ? text + "." : text;
}

ProposedValue range(std::string_view low, std::string_view value, std::string_view high) {
    return {"<", ">", {std::string(low), std::string(value), std::string(high)}, {}};
}

ProposedValue real_range(const UniformFact& uniform) {
    const Number initial = read_number(uniform.initial);
    if (!uniform.initial.empty() && initial.usable()) {
        const double low = initial.value < 0 ? 2 * initial.value : 0;
        const double high = initial.value > 1 ? 2 * initial.value : 1;
        return range(real_text(low), real_text(initial.value), real_text(high));
    }
    const std::vector<std::string> words = words_of_name(uniform.name);
    if (has_word(words, "light") || uniform.name.starts_with("uLight"))
        for (const char axis : {'x', 'y', 'z'})
            if (lower(uniform.name.back()) == axis) return range("-20.", "5.", "20.");
    for (const Usual& one : usual)
        if (has_word(words, one.words)) return range(one.range[0], one.range[1], one.range[2]);
    return range("0.", ".5", "1.");
}

ProposedValue whole_range(const UniformFact& uniform) {
    const Number initial = read_number(uniform.initial);
    if (!uniform.initial.empty() && initial.usable()) {
        const int value = static_cast<int>(std::clamp(initial.value, -1e6, 1e6));
        return range(std::to_string(std::min(0, 2 * value)), std::to_string(value),
                     std::to_string(std::max(10, 2 * value)));
    }
    const std::vector<std::string> words = words_of_name(uniform.name);
    if (has_word(words, "count num number steps samples rounds iterations levels")) return range("1", "8", "64");
    return range("0", "1", "10");
}

ProposedValue texture_unit(const Scene& scene, const UniformFact& uniform) {
    ProposedValue value;
    const auto target = sampler_target(uniform.name, uniform.type);
    for (const Texture& texture : scene.textures) {
        const std::string unit = std::to_string(texture.unit);
        if (texture.target == target && ranges::find(value.choices, unit) == value.choices.end())
            value.choices.push_back(unit);
    }
    std::sort(value.choices.begin(), value.choices.end());
    value.numbers = {value.choices.empty() ? "0" : value.choices.front()};
    return value;
}

ProposedValue vector_value(const UniformFact& uniform, std::size_t size) {
    if (size >= 3 && color_name(uniform.name)) {
        ProposedValue value{"{", "}", {".8", ".8", ".8"}, {}};
        if (size == 4) value.numbers.emplace_back("1.");
        return value;
    }
    ProposedValue value{"[", "]", {}, {}};
    const std::vector<std::string> words = words_of_name(uniform.name);
    if (size == 3 && has_word(words, "light pos position")) {
        value.numbers = {"5.", "10.", "10."};
    } else {
        value.numbers.assign(size, "0.");
        if (size >= 3 && has_word(words, "dir direction axis normal")) value.numbers[2] = "1.";
    }
    return value;
}

}  // namespace

std::string ProposedValue::text() const { return fmt::format("{}{}{}", before, fmt::join(numbers, " "), after); }

std::string ProposedValue::snippet(int& placeholder) const {
    if (choices.size() > 1) return fmt::format("${{{}|{}|}}", placeholder++, fmt::join(choices, ","));
    std::string all = before;
    for (const std::string& number : numbers)
        all += (&number == numbers.data() ? "${" : " ${") + std::to_string(placeholder++) + ":" + number + "}";
    return all + (after == "}" ? "\\}" : after);
}

ProposedValue proposed_value(const Scene& scene, const UniformFact& uniform) {
    const std::string_view type = uniform.type.substr(0, uniform.type.find_first_of(" ["));
    if (uniform.array) return {"[", "]", {"0."}, {}};
    if (type == "bool") return {"<", ">", {"true"}, {}};
    if (type == "int" || type == "uint") return whole_range(uniform);
    if (type.find("sampler") != std::string_view::npos || type.find("image") != std::string_view::npos)
        return texture_unit(scene, uniform);
    const std::size_t vec = type.find("vec");
    if (vec != std::string_view::npos && vec + 4 == type.size())
        return vector_value(uniform, static_cast<std::size_t>(std::clamp(type.back() - '0', 2, 4)));
    if (type.starts_with("mat") && type.size() == 4) {
        const int size = std::clamp(type.back() - '0', 2, 4);
        ProposedValue value{"[", "]", {}, {}};
        for (int i = 0; i < size * size; ++i) value.numbers.emplace_back(i % (size + 1) == 0 ? "1." : "0.");
        return value;
    }
    return real_range(uniform);
}

std::string guessed_type(const Scene& scene, const UniformValue& value) {
    using Value = UniformValue::Kind;
    const std::size_t count = value.values.size();
    switch (value.kind) {
        case Value::boolean:
            return "bool";
        case Value::color:
            return count >= 4 ? "vec4" : "vec3";
        case Value::range:
            return value.integral ? "int" : "float";
        case Value::array:
            if (count >= 2 && count <= 4) return "vec" + std::to_string(count);
            return count == 9 ? "mat3" : count == 16 ? "mat4" : "float";
        case Value::scalar:
            break;
    }
    if (!value.integral) return "float";
    constexpr std::array<std::string_view, texture_target_count> samplers{"sampler1D", "sampler2D", "sampler3D",
                                                                          "samplerCube"};
    for (const Texture& texture : scene.textures)
        if (texture.unit == static_cast<int>(value.values.empty() ? -1 : value.values.front()))
            return std::string(samplers[static_cast<std::size_t>(texture.target)]);
    return "int";
}

}  // namespace snell::language
