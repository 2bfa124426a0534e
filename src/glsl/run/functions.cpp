// The functions of the language. What is not computed here gives NaN.
#include <algorithm>
#include <numbers>
#include <unordered_map>

#include "parser/text/ranges.h"
#include "src/glsl/run/machine.h"

namespace snell::glsl::run {

struct BuiltIn {
    enum class Kind : std::uint8_t {
        component,
        mix,
        atan,
        vector,
        scalar,
        transpose,
        derivative,
        texture,
        noise,
        none,
        stop
    };
    std::string_view name;
    double (*f)(const double*) = nullptr;  // of a component, given what stands there in each argument
    Base result = Base::unknown;           // unknown: that of the arguments
    Kind kind = Kind::component;
};

namespace {

double known(double condition, double x) { return std::isnan(condition) ? nothing : x; }
double smaller(double a, double b) { return std::isnan(a + b) ? nothing : std::min(a, b); }
double larger(double a, double b) { return std::isnan(a + b) ? nothing : std::max(a, b); }
double smoothed(double a, double b, double x) {
    if (!(a < b)) return nothing;
    const double t = smaller(larger((x - a) / (b - a), 0), 1);
    return t * t * (3 - 2 * t);
}

constexpr double pi = std::numbers::pi;
constexpr BuiltIn rows[] = {
    {"radians", [](const double* x) { return x[0] * pi / 180; }, Base::real},
    {"degrees", [](const double* x) { return x[0] * 180 / pi; }, Base::real},
    {"sin", [](const double* x) { return std::sin(x[0]); }, Base::real},
    {"cos", [](const double* x) { return std::cos(x[0]); }, Base::real},
    {"tan", [](const double* x) { return std::tan(x[0]); }, Base::real},
    {"asin", [](const double* x) { return std::asin(x[0]); }, Base::real},
    {"acos", [](const double* x) { return std::acos(x[0]); }, Base::real},
    {"sinh", [](const double* x) { return finite(std::sinh(x[0])); }, Base::real},
    {"cosh", [](const double* x) { return finite(std::cosh(x[0])); }, Base::real},
    {"tanh", [](const double* x) { return std::tanh(x[0]); }, Base::real},
    {"pow",
     [](const double* x) { return x[0] > 0                ? finite(std::pow(x[0], x[1]))
                                  : x[0] == 0 && x[1] > 0 ? 0.
                                                          : nothing; },
     Base::real},
    {"exp", [](const double* x) { return finite(std::exp(x[0])); }, Base::real},
    {"log", [](const double* x) { return finite(std::log(x[0])); }, Base::real},
    {"exp2", [](const double* x) { return finite(std::exp2(x[0])); }, Base::real},
    {"log2", [](const double* x) { return finite(std::log2(x[0])); }, Base::real},
    {"sqrt", [](const double* x) { return std::sqrt(x[0]); }, Base::real},
    {"inversesqrt", [](const double* x) { return finite(1 / std::sqrt(x[0])); }, Base::real},
    {"abs", [](const double* x) { return std::abs(x[0]); }},
    {"sign", [](const double* x) { return known(x[0], x[0] > 0   ? 1.
                                                      : x[0] < 0 ? -1.
                                                                 : 0.); }},
    {"floor", [](const double* x) { return std::floor(x[0]); }, Base::real},
    {"trunc", [](const double* x) { return std::trunc(x[0]); }, Base::real},
    {"round", [](const double* x) { return std::round(x[0]); }, Base::real},
    {"roundEven", [](const double* x) { return std::nearbyint(x[0]); }, Base::real},
    {"ceil", [](const double* x) { return std::ceil(x[0]); }, Base::real},
    {"fract", [](const double* x) { return x[0] - std::floor(x[0]); }, Base::real},
    {"mod", [](const double* x) { return finite(x[0] - x[1] * std::floor(x[0] / x[1])); }, Base::real},
    {"min", [](const double* x) { return smaller(x[0], x[1]); }},
    {"max", [](const double* x) { return larger(x[0], x[1]); }},
    {"clamp", [](const double* x) { return x[1] <= x[2] ? smaller(larger(x[0], x[1]), x[2]) : nothing; }},
    {"saturate", [](const double* x) { return smaller(larger(x[0], 0), 1); }},
    {"step", [](const double* x) { return known(x[0] + x[1], x[1] < x[0] ? 0. : 1.); }, Base::real},
    {"smoothstep", [](const double* x) { return smoothed(x[0], x[1], x[2]); }, Base::real},
    {"fma", [](const double* x) { return x[0] * x[1] + x[2]; }, Base::real},
    {"matrixCompMult", [](const double* x) { return x[0] * x[1]; }},
    {"lessThan", [](const double* x) { return known(x[0] + x[1], x[0] < x[1]); }, Base::boolean},
    {"lessThanEqual", [](const double* x) { return known(x[0] + x[1], x[0] <= x[1]); }, Base::boolean},
    {"greaterThan", [](const double* x) { return known(x[0] + x[1], x[0] > x[1]); }, Base::boolean},
    {"greaterThanEqual", [](const double* x) { return known(x[0] + x[1], x[0] >= x[1]); }, Base::boolean},
    {"equal", [](const double* x) { return known(x[0] + x[1], x[0] == x[1]); }, Base::boolean},
    {"notEqual", [](const double* x) { return known(x[0] + x[1], x[0] != x[1]); }, Base::boolean},
    {"not", [](const double* x) { return known(x[0], x[0] == 0); }, Base::boolean},
    {.name = "atan", .kind = BuiltIn::Kind::atan},
    {.name = "mix", .kind = BuiltIn::Kind::mix},
    {.name = "length", .kind = BuiltIn::Kind::scalar},
    {.name = "distance", .kind = BuiltIn::Kind::scalar},
    {.name = "dot", .kind = BuiltIn::Kind::scalar},
    {.name = "any", .kind = BuiltIn::Kind::scalar},
    {.name = "all", .kind = BuiltIn::Kind::scalar},
    {.name = "normalize", .kind = BuiltIn::Kind::vector},
    {.name = "cross", .kind = BuiltIn::Kind::vector},
    {.name = "reflect", .kind = BuiltIn::Kind::vector},
    {.name = "refract", .kind = BuiltIn::Kind::vector},
    {.name = "faceforward", .kind = BuiltIn::Kind::vector},
    {.name = "transpose", .kind = BuiltIn::Kind::transpose},
    {.name = "ftransform", .kind = BuiltIn::Kind::texture},
};
// By how the names begin.
constexpr BuiltIn families[] = {
    {.name = "texture", .kind = BuiltIn::Kind::texture},   {.name = "texelFetch", .kind = BuiltIn::Kind::texture},
    {.name = "noise", .kind = BuiltIn::Kind::noise},       {.name = "dFd", .kind = BuiltIn::Kind::derivative},
    {.name = "fwidth", .kind = BuiltIn::Kind::derivative}, {.name = "EmitVertex", .kind = BuiltIn::Kind::stop},
    {.name = "barrier", .kind = BuiltIn::Kind::stop},      {.name = "modf", .kind = BuiltIn::Kind::stop},
    {.name = "frexp", .kind = BuiltIn::Kind::stop},        {.name = "image", .kind = BuiltIn::Kind::stop},
    {.name = "atomic", .kind = BuiltIn::Kind::stop},
};
constexpr BuiltIn other = {.name = "", .kind = BuiltIn::Kind::none};

const BuiltIn& find_built_in(std::string_view name) {
    static const std::unordered_map<std::string_view, const BuiltIn*> table = [] {
        std::unordered_map<std::string_view, const BuiltIn*> t;
        for (const BuiltIn& row : rows) t.emplace(row.name, &row);
        return t;
    }();
    if (const auto found = table.find(name); found != table.end()) return *found->second;
    const auto* family = ranges::find_if(families, [&](const BuiltIn& f) { return name.starts_with(f.name); });
    return family == std::end(families) ? other : *family;
}

double atan_of(const double* x) { return std::atan(x[0]); }
double atan2_of(const double* x) { return x[0] == 0 && x[1] == 0 ? nothing : std::atan2(x[0], x[1]); }
double mixed(const double* x) { return x[0] * (1 - x[2]) + x[1] * x[2]; }
double chosen(const double* x) { return std::isnan(x[2]) ? nothing : x[2] != 0 ? x[1] : x[0]; }

double dot(const Value& a, const Value& b, int lane) {
    double sum = 0;
    for (int k = 0; k < a.size; ++k) sum += a.get(k, lane) * b.get(k, lane);
    return sum;
}

}  // namespace

Value Machine::by_component(std::span<const Value> given, double (*f)(const double*), const Type& result) {
    int lanes = 1;
    for (const Value& v : given) lanes = std::max(lanes, v.lanes);
    const int size = result.rows * result.cols;
    Value out = make(result, size, lanes);
    std::array<double, 4> x{};
    for (int k = 0; k < size; ++k)
        for (int l = 0; l < lanes; ++l) {
            for (std::size_t n = 0; n < given.size() && n < x.size(); ++n)
                x[n] = given[n].get(given[n].size > 1 ? k : 0, l);
            out.data[k * lanes + l] = f(x.data());
        }
    return out;
}

// By the lane of the neighbour. It is the same in all lanes: a dependence that goes through it is not seen.
Value Machine::differences(const Value& v) {
    Value out = make(v.type, v.size, 1);
    const bool there = neighbour_ >= 0 && (*alive_ >> neighbour_ & 1) != 0;
    for (int k = 0; k < v.size; ++k) out.data[k] = there ? v.get(k, neighbour_) - v.get(k, 0) : nothing;
    return out;
}

// A texture or a field of noise may hold anything: here, waves.
Value Machine::sampled(std::span<const Value> given, const Type& type) {
    int lanes = 1;
    for (const Value& v : given) lanes = std::max(lanes, v.lanes);
    const int size = std::max(count(u_, type), 1);
    Value out = make(type, size, lanes);
    for (int k = 0; k < size; ++k)
        for (int l = 0; l < lanes; ++l) {
            double phase = 1.7 * k + .3;
            int n = 0;
            for (const Value& v : given)
                for (int c = 0; c < v.size; ++c) phase += (1.3 + .37 * n++) * v.get(c, l);
            const double wave = .5 + .45 * std::sin(phase);
            out.data[k * lanes + l] = type.integral() ? std::isnan(wave) ? wave : std::floor(wave * 200) : wave;
        }
    return out;
}

Value Machine::transposed(const Value& m) {
    Value out = make(shape(m.type.base, m.type.cols, m.type.rows), m.size, m.lanes);
    for (int k = 0; k < m.size; ++k)
        for (int l = 0; l < m.lanes; ++l)
            out.data[k * m.lanes + l] = m.get(k % m.type.cols * m.type.rows + k / m.type.cols, l);
    return out;
}

// One number from vectors.
Value Machine::measured(std::string_view name, std::span<const Value> given) {
    const Value &a = given[0], &b = given.back();
    const bool truth = name == "any" || name == "all", difference = name == "distance", root = name != "dot";
    Value out = make(shape(a.type.base), 1, std::max(a.lanes, b.lanes));
    for (int l = 0; l < out.lanes; ++l) {
        double sum = 0;
        for (int k = 0; k < a.size; ++k) {
            const double x = a.get(k, l), y = b.get(k, l);
            sum += truth ? x : difference ? (x - y) * (x - y) : x * y;
        }
        const double result = name == "any" ? sum > 0 : name == "all" ? sum == a.size : root ? std::sqrt(sum) : sum;
        out.data[l] = known(sum, result);
    }
    return out;
}

// A vector from vectors.
Value Machine::directed(std::string_view name, std::span<const Value> given) {
    const Value &a = given[0], &b = given.size() > 1 ? given[1] : a, &c = given.back();
    int lanes = 1;
    for (const Value& v : given) lanes = std::max(lanes, v.lanes);
    Value out = make(a.type, a.size, lanes);
    const char which = name == "refract" ? 'T' : name[0];
    for (int l = 0; l < lanes; ++l) {
        const double d = which == 'n'   ? finite(1 / std::sqrt(dot(a, a, l)))
                         : which == 'f' ? dot(c, b, l)
                                        : dot(a, b, l);
        const double eta = c.get(0, l), rest = 1 - eta * eta * (1 - d * d);
        for (int k = 0; k < a.size; ++k) {
            const double x = a.get(k, l), y = b.get(k, l);
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            double& to = out.data[k * lanes + l];
            if (which == 'n') to = x * d;
            if (which == 'c') to = a.get(i, l) * b.get(j, l) - a.get(j, l) * b.get(i, l);
            if (which == 'r') to = x - 2 * d * y;
            if (which == 'T') to = known(rest, rest < 0 ? 0. : eta * x - (eta * d + std::sqrt(std::max(rest, 0.))) * y);
            if (which == 'f') to = known(d, d < 0 ? x : -x);
        }
    }
    return out;
}

// Functions of numbers: all arguments have one size, or are single numbers.
Value Machine::arithmetic(const BuiltIn& f, std::string_view name, std::span<const Value> given, const Type& type) {
    using enum BuiltIn::Kind;
    Type large = given[0].type;
    Base base = Base::boolean;
    for (const Value& v : given) {
        if (!v.type.basic() || v.type.dims) return unknown(type);
        if (v.size > large.rows * large.cols) large = v.type;
        if (v.type.base != Base::boolean || given.size() == 1) base = std::max(base, v.type.base);
    }
    const int size = large.rows * large.cols;
    const bool vectors = f.kind == vector || f.kind == scalar;
    for (std::size_t n = 0; n < given.size(); ++n) {
        const bool fits = given[n].size == size || (given[n].size == 1 && (!vectors || n == 2));
        if (!fits || (vectors && given[n].type.cols > 1)) return unknown(type);
    }
    if (name == "cross" && size != 3) return unknown(type);
    large.base = f.result != Base::unknown ? f.result : f.kind == atan ? Base::real : base;
    switch (f.kind) {
        case component:
            return by_component(given, f.f, large);
        case atan:
            return by_component(given, given.size() > 1 ? atan2_of : atan_of, large);
        case mix:
            return by_component(given, given.back().type.base == Base::boolean ? chosen : mixed, large);
        case vector:
            return directed(name, given);
        case scalar:
            return measured(name, given);
        case transpose:
            return transposed(given[0]);
        default:
            return unknown(type);
    }
}

Value Machine::built_in(const Instruction& i, std::span<const Value> given) {
    const Type& type = u_.code.types[static_cast<std::size_t>(i.type)];
    const BuiltIn*& f = functions_[static_cast<std::size_t>(&i - u_.code.steps.data())];
    if (!f) f = &find_built_in(i.text);
    const auto whole = [](const Value& v) {
        return std::all_of(v.data, v.data + v.size * v.lanes, [](double x) { return x == std::trunc(x); });
    };
    using enum BuiltIn::Kind;
    if (f->kind == texture) return sampled(given, type);
    if (f->kind == noise && !ranges::all_of(given, whole)) return sampled(given, type);  // else at a lattice point: 0
    if (f->kind == stop) return Machine::stop(End::unknown), unknown(type);
    if (f->kind == stop || f->kind == noise || f->kind == none || given.empty()) return unknown(type);
    if (f->kind == derivative) return differences(given[0]);
    return arithmetic(*f, i.text, given, type);
}

}  // namespace snell::glsl::run
