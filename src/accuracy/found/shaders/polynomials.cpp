// Functions replaced by polynomials whose errors have bounds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"

namespace snell::accuracy {

namespace {

using glsl::Form;
using glsl::Node;

constexpr double far_angle = 1000;  // sin and cos: beyond, the fraction of a float turn is coarse

// NAME and TYPE are replaced. GLSL 1.10: no integers, no arrays, no overloads of mix that later versions have.
constexpr std::array<Polynomial, 7> formulas{{
    {"sin", -far_angle, far_angle, .0012,
     "// sin(x) by t = x/pi in -1..1, y = 4t(1 - |t|), .775y + .225y|y|: error below .0012 for |x| < 1000\n"
     "TYPE NAME(TYPE x) { TYPE t = 2. * fract(.15915494 * x + .5) - 1.; TYPE y = 4. * t * (1. - abs(t)); "
     "return y * (.775 + .225 * abs(y)); }\n"},
    {"cos", -far_angle, far_angle, .0012,
     "// cos(x) by t = x/pi + .5 in -1..1, y = 4t(1 - |t|), .775y + .225y|y|: error below .0012 for |x| < 1000\n"
     "TYPE NAME(TYPE x) { TYPE t = 2. * fract(.15915494 * x + .75) - 1.; TYPE y = 4. * t * (1. - abs(t)); "
     "return y * (.775 + .225 * abs(y)); }\n"},
    {"exp", -1000, 0, .0011,
     "// exp(x) by (1 + u + u^2/2)^16, u = x/16: error below .0011 for x <= 0\n"
     "TYPE NAME(TYPE x) { TYPE u = max(.0625 * x, -1.); TYPE e = 1. + u + .5 * u * u; e *= e; e *= e; e *= e; "
     "return e * e; }\n"},
    {"acos", -1, 1, .0001,
     "// acos(|x|) by sqrt(1 - |x|)(1.5707288 - .2121144|x| + .0742610|x|^2 - .0187293|x|^3): error below .0001 in "
     "-1..1\n"
     "TYPE NAME(TYPE x) { TYPE a = abs(x); TYPE r = sqrt(max(1. - a, 0.)) * (1.5707288 + a * (a * (.0742610 - "
     ".0187293 * a) - .2121144)); return r + step(x, TYPE(0.)) * (3.14159265 - 2. * r); }\n"},
    {"asin", -1, 1, .0001,
     "// asin(|x|) by pi/2 - sqrt(1 - |x|)(1.5707288 - .2121144|x| + .0742610|x|^2 - .0187293|x|^3): error below .0001 "
     "in -1..1\n"
     "TYPE NAME(TYPE x) { TYPE a = abs(x); TYPE r = 1.57079633 - sqrt(max(1. - a, 0.)) * (1.5707288 + a * (a * "
     "(.0742610 - .0187293 * a) - .2121144)); return r * sign(x); }\n"},
    {"atan", -1000, 1000, .004,
     "// atan(x) by pi/4 t + .273t(1 - t), t = min(|x|, 1/|x|): error below .004\n"
     "TYPE NAME(TYPE x) { TYPE a = abs(x); TYPE t = min(a, 1.) / max(a, 1.); TYPE r = t * (1.05839816 - .273 * t); "
     "return sign(x) * mix(r, 1.57079633 - r, step(1., a)); }\n"},
    {"atan2", -1000, 1000, .004,
     "// atan(y, x) by pi/4 t + .273t(1 - t), t the smaller of |x| and |y| over the larger: error below .004\n"
     "TYPE NAME(TYPE y, TYPE x) { TYPE a = abs(x); TYPE b = abs(y); TYPE t = min(a, b) / max(max(a, b), 1.e-30); "
     "TYPE r = t * (1.05839816 - .273 * t); r = mix(r, 1.57079633 - r, step(a, b)); "
     "r = mix(r, 3.14159265 - r, step(x, TYPE(0.))); return mix(-r, r, step(0., y)); }\n"},
}};

std::string with_names(std::string text, std::string_view name, std::string_view type) {
    for (const auto& [word, by] : {std::pair<std::string_view, std::string_view>{"NAME", name}, {"TYPE", type}})
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size()))
            text.replace(at, word.size(), by);
    return text;
}

// x to a whole power by squares: the statements of the function.
std::string power_product(int power) {
    std::string text, result;
    std::string square = "x";
    for (int bit = 1; bit <= power; bit *= 2) {
        if (bit > 1) {
            text += fmt::format("TYPE x{} = {} * {}; ", bit, square, square);
            square = fmt::format("x{}", bit);
        }
        if (power & bit) result += (result.empty() ? "" : " * ") + square;
    }
    return text + "return " + result + "; }\n";
}

// Coefficients of s, s^2, s^3 that fit s^p in 0..1 and are exact at both ends; the error that is left, where the result
// is multiplied by s^(4 whole).
struct CubicFit {
    double a = 0, b = 0, c = 0, error = 1;
};

CubicFit cubic_fit(double power, double whole) {
    // u and v, where the error is 0, too, are those that make it smallest.
    CubicFit best;
    for (int i = 1; i < 12; ++i)
        for (int j = i + 1; j < 12; ++j) {
            const double u = i / 12., v = j / 12.;
            // a + b s + c s^2 = s^(p-1) at u, v and 1.
            const double fu = std::pow(u, power - 1), fv = std::pow(v, power - 1), uv = (fv - fu) / (v - u);
            const double vw = (1 - fv) / (1 - v), c = (vw - uv) / (1 - u), b = uv - c * (u + v);
            CubicFit fit{fu - b * u - c * u * u, b, c, 0};
            for (double s = 0; s <= 1; s += 1. / 64)
                fit.error =
                    std::max(fit.error, std::pow(s, 4 * whole) *
                                            std::abs(s * (fit.a + s * (fit.b + s * fit.c)) - std::pow(s, power)));
            if (fit.error < best.error) best = fit;
        }
    return best;
}

Power power_root(double exponent) {
    double whole = 0;
    const double part = std::modf(exponent, &whole);
    const double power = 4 * part;
    if (whole == 0 && power < .75) return {};  // too steep at 0
    const CubicFit fit = cubic_fit(power, whole);
    double error = 0;
    for (double s = 0; s <= 1; s += 1. / 1024) {
        const double x = s * s * s * s, made = std::pow(x, whole) * s * (fit.a + s * (fit.b + s * fit.c));
        error = std::max(error, std::abs(made - std::pow(x, exponent)));
    }
    const double bound = std::ceil(error * 1.1 * 1e4 + 1) / 1e4;
    std::string text = fmt::format(
        "// pow(x, {:.6g}) by {}({:.6f}s{:+.6f}s^2{:+.6f}s^3), s = sqrt(sqrt(x)): error below {:.4f} in "
        "0..1\n",
        exponent, whole > 0 ? fmt::format("x^{:.0f}", whole) : "", fit.a, fit.b, fit.c, bound);
    text += "TYPE NAME(TYPE x) { TYPE s = sqrt(sqrt(max(x, 0.))); return ";
    for (int k = 0; k < static_cast<int>(whole); ++k) text += "x * ";
    text += fmt::format("s * ({:.6f} + s * ({:.6f} + s * ({:.6f}))); }}\n", fit.a, fit.b, fit.c);
    return {text, bound};
}

Power power_template(std::optional<double> exponent) {
    if (!exponent)
        return {
            "// pow(x, y) by (1 + y(x - 1)/16)^16: error below .02 for x in 0..1 and y >= 8\n"
            "TYPE NAME(TYPE x, TYPE y) { TYPE b = max(1. + .0625 * y * (x - 1.), 0.); b *= b; b *= b; b *= b; "
            "return b * b; }\n",
            .02};
    const double y = *exponent;
    if (y == std::floor(y) && y >= 2 && y <= 256)
        return {fmt::format("// pow(x, {:.0f}) by multiplications: exact\nTYPE NAME(TYPE x) {{ {}", y,
                            power_product(static_cast<int>(y))),
                0};
    if (y == .5) return {"// pow(x, .5) is the square root\nTYPE NAME(TYPE x) { return sqrt(max(x, 0.)); }\n", 0};
    if (y == 1.5)
        return {"// pow(x, 1.5) by the square root: exact\nTYPE NAME(TYPE x) { return x * sqrt(max(x, 0.)); }\n", 0};
    if (!(y > 0) || y > 4 || y == std::floor(y)) return {};
    return power_root(y);
}

// ---- calls --------------------------------------------------------------------------------------------------

class PolynomialCalls {
public:
    PolynomialCalls(const Shader& shader, Offers& offers) : s_(shader), offers_(offers) {}

    void run() {
        std::map<int, std::vector<int>> by_function;
        for (int n = 0; n < s_.nodes() && !offers_.full(); ++n) {
            const Node& call = s_.at(n);
            if (call.form != Form::built_in || call.constant || !real_vector(call.type) || !s_.own(n)) continue;
            const int function = s_.function_of(call.first);
            if (!s_.ahead_of(function) || s_.in_free_loop(call.first) || helper(n).empty()) continue;
            by_function[function].push_back(n);
            offer({n});
        }
        // Two changes that add a function at one place are not made together, so all of a function are one, too.
        for (const auto& [function, calls] : by_function)
            if (calls.size() > 1 && calls.size() < 50) offer(calls);
    }

private:
    std::string name_of(int node) const {
        std::string name(s_.at(node).text);
        name[0] = static_cast<char>(name[0] - 'a' + 'A');
        return fmt::format("found{}_{}", name, s_.span(node).begin);
    }

    // The function that replaces the call's; empty if there is none.
    std::string helper(int node) const {
        const Node& call = s_.at(node);
        const std::vector<int> given = s_.parts(node);
        const auto typed = [&](int part) { return s_.at(part).type.same(call.type); };
        if (given.empty() || given.size() > 2 || !ranges::all_of(given, typed)) return {};
        const std::string_view type = call.type.name;
        if (call.text == "pow" && given.size() == 2) return power_text(exponent(given[1]), name_of(node), type).text;
        if (call.text == "atan" && given.size() == 2) return polynomial_text("atan2", name_of(node), type);
        return given.size() == 1 ? polynomial_text(call.text, name_of(node), type) : "";
    }

    // The exponent, if it is the same number in every component.
    std::optional<double> exponent(int node) const {
        const std::vector<double>& value = s_.at(node).value;
        if (value.empty() || ranges::count(value, value.front()) != static_cast<std::ptrdiff_t>(value.size()))
            return {};
        return value.front();
    }

    void offer(const std::vector<int>& calls) {
        const int function = s_.function_of(s_.at(calls.front()).first);
        const Span ahead = *s_.ahead_of(function);
        std::vector<Edit> edits;
        std::vector<Span> shown;
        for (const int n : calls) {
            const Node& call = s_.at(n);
            shown.push_back(s_.span(n));
            const std::vector<int> given = s_.parts(n);
            edits.push_back({ahead, helper(n)});
            edits.push_back({s_.span(call.first, call.first), name_of(n)});
            if (call.text != "pow" || !exponent(given[1])) continue;
            const Span base = s_.span(given[0]), power = s_.span(given[1]);
            edits.push_back({{base.file, base.end, power.end}, ""});
        }
        offers_.add(ChangeKind::polynomial, shown, std::move(edits));
    }

    const Shader& s_;
    Offers& offers_;
};

}  // namespace

std::span<const Polynomial> polynomials() { return formulas; }

std::string polynomial_text(std::string_view function, std::string_view name, std::string_view type) {
    const std::span<const Polynomial> all = polynomials();
    const auto found = ranges::find(all, function, &Polynomial::function);
    return found == all.end() ? std::string() : with_names(std::string(found->text), name, type);
}

Power power_text(std::optional<double> exponent, std::string_view name, std::string_view type) {
    Power power = power_template(exponent);
    power.text = with_names(std::move(power.text), name, type);
    return power;
}

void add_polynomials(const Shader& fragment, Offers& offers) { PolynomialCalls(fragment, offers).run(); }

}  // namespace snell::accuracy
