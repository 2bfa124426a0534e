// The functions of the language. What is not computed here gives NaN.
#include <algorithm>
#include <numbers>
#include <unordered_map>

#include "src/glsl/run/machine.h"

namespace snell::glsl::run {

namespace {

double known(double condition, double x) { return std::isnan(condition) ? nothing : x; }
double smaller(double a, double b) { return std::isnan(a + b) ? nothing : std::min(a, b); }
double larger(double a, double b) { return std::isnan(a + b) ? nothing : std::max(a, b); }
double smoothed(double a, double b, double x) {
    if (!(a < b)) return nothing;
    const double t = smaller(larger((x - a) / (b - a), 0), 1);
    return t * t * (3 - 2 * t);
}

// Functions of each component, given as an array of what stands there in each argument.
struct Row {
    std::string_view name;
    double (*f)(const double*);
    Base result = Base::unknown;  // unknown: that of the arguments
};
constexpr double pi = std::numbers::pi;
constexpr Row rows[] = {
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
};

const Row* row_of(std::string_view name) {
    static const std::unordered_map<std::string_view, const Row*> table = [] {
        std::unordered_map<std::string_view, const Row*> t;
        for (const Row& row : rows) t.emplace(row.name, &row);
        return t;
    }();
    const auto found = table.find(name);
    return found == table.end() ? nullptr : found->second;
}

double atan_of(const double* x) { return std::atan(x[0]); }
double atan2_of(const double* x) { return x[0] == 0 && x[1] == 0 ? nothing : std::atan2(x[0], x[1]); }
double mixed(const double* x) { return x[0] * (1 - x[2]) + x[1] * x[2]; }
double chosen(const double* x) { return std::isnan(x[2]) ? nothing : x[2] != 0 ? x[1] : x[0]; }

bool samples(std::string_view name) {
    return name.starts_with("texture") || name.starts_with("texelFetch") || name.starts_with("noise");
}

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
Value Machine::derivative(const Value& v) {
    Value out = make(v.type, v.size, 1);
    const bool there = neighbour_ >= 0 && (*alive_ >> neighbour_ & 1) != 0;
    for (int k = 0; k < v.size; ++k) out.data[k] = there ? v.get(k, neighbour_) - v.get(k, 0) : nothing;
    return out;
}

// A texture or a field of noise may hold anything: here, waves.
Value Machine::texture(std::span<const Value> given, const Type& type) {
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

// Functions whose components are not computed one by one. They are few enough numbers that a loop over lanes will do.
Value Machine::vector_function(std::string_view name, std::span<const Value> given) {
    const Value& a = given[0];
    const Value& b = given.size() > 1 ? given[1] : a;
    int lanes = 1;
    for (const Value& v : given) lanes = std::max(lanes, v.lanes);
    const bool scalar = name == "length" || name == "distance" || name == "dot" || name == "any" || name == "all";
    const bool vectors = a.type.basic() && a.type.dims == 0 && a.type.cols == 1;
    if (name == "transpose" && a.type.basic() && a.type.dims == 0) {
        Value out = make(shape(a.type.base, a.type.cols, a.type.rows), a.size, lanes);
        for (int k = 0; k < a.size; ++k)
            for (int l = 0; l < lanes; ++l)
                out.data[k * lanes + l] = a.get(k % a.type.cols * a.type.rows + k / a.type.cols, l);
        return out;
    }
    if (!vectors || (b.size != a.size && name != "refract") || (name == "cross" && a.size != 3)) return unknown(a.type);
    Value out = make(scalar ? shape(a.type.base) : a.type, scalar ? 1 : a.size, lanes);
    for (int l = 0; l < lanes; ++l) {
        const auto put = [&](const auto& f) {
            for (int k = 0; k < out.size; ++k) out.data[k * lanes + l] = f(k);
        };
        if (name == "length") {
            put([&](int) { return std::sqrt(dot(a, a, l)); });
        } else if (name == "distance") {
            double sum = 0;
            for (int k = 0; k < a.size; ++k) sum += std::pow(a.get(k, l) - b.get(k, l), 2);
            put([&](int) { return std::sqrt(sum); });
        } else if (name == "dot") {
            put([&](int) { return dot(a, b, l); });
        } else if (name == "any" || name == "all") {
            int set = 0;
            bool sure = true;
            for (int k = 0; k < a.size; ++k) sure = sure && !std::isnan(a.get(k, l)), set += a.get(k, l) != 0;
            put([&](int) { return !sure ? nothing : (name == "any" ? set > 0 : set == a.size) ? 1. : 0.; });
        } else if (name == "normalize") {
            const double scale = finite(1 / std::sqrt(dot(a, a, l)));
            put([&](int k) { return a.get(k, l) * scale; });
        } else if (name == "cross") {
            put([&](int k) {
                const int i = (k + 1) % 3, j = (k + 2) % 3;
                return a.get(i, l) * b.get(j, l) - a.get(j, l) * b.get(i, l);
            });
        } else if (name == "reflect") {
            const double d = dot(a, b, l);
            put([&](int k) { return a.get(k, l) - 2 * d * b.get(k, l); });
        } else if (name == "refract" && given.size() == 3 && b.size == a.size) {
            const double d = dot(a, b, l), eta = given[2].get(0, l), rest = 1 - eta * eta * (1 - d * d);
            put([&](int k) {
                return std::isnan(rest) ? nothing
                       : rest < 0       ? 0.
                                        : eta * a.get(k, l) - (eta * d + std::sqrt(rest)) * b.get(k, l);
            });
        } else if (name == "faceforward" && given.size() == 3 && given[2].size == a.size) {
            const double d = dot(given[2], b, l);
            put([&](int k) { return known(d, d < 0 ? a.get(k, l) : -a.get(k, l)); });
        } else {
            put([&](int) { return nothing; });
        }
    }
    return out;
}

Value Machine::built_in(const Instruction& i, std::span<const Value> given) {
    const Type& type = u_.code.types[static_cast<std::size_t>(i.type)];
    const std::string_view name = i.text;
    if (name.starts_with("EmitVertex") || name == "barrier") stop(End::unknown);
    if (name == "modf" || name == "frexp" || name.starts_with("image") || name.starts_with("atomic")) {
        if (given.size() > 1) stop(End::unknown);
        return unknown(type);
    }
    if (name == "ftransform") {
        Value out = make(shape(Base::real, 4), 4, 1);
        for (int k = 0; k < 4; ++k) out.data[k] = .37 * k + .21;
        return out;
    }
    if (samples(name)) {
        const bool whole = std::ranges::all_of(given, [](const Value& v) {
            for (int n = 0; n < v.size * v.lanes; ++n)
                if (v.data[n] != std::trunc(v.data[n])) return false;
            return true;
        });
        if (name.starts_with("noise") && whole) return unknown(type);  // zero at lattice points
        return texture(given, type);
    }
    if (given.empty()) return unknown(type);
    if (name.starts_with("dF") || name.starts_with("fwidth")) return derivative(given[0]);
    Type large = given[0].type;
    Base base = Base::boolean;
    for (const Value& v : given) {
        if (!v.type.basic() || v.type.dims) return unknown(type);
        if (v.size > large.rows * large.cols) large = v.type;
        if (v.type.base != Base::boolean || given.size() == 1) base = std::max(base, v.type.base);
    }
    for (const Value& v : given)
        if (v.size != 1 && v.size != large.rows * large.cols && name != "refract") return unknown(type);
    large.base = base;
    if (name == "atan") {
        large.base = Base::real;
        return by_component(given, given.size() > 1 ? atan2_of : atan_of, large);
    }
    if (name == "mix" && given.size() == 3)
        return by_component(given, given[2].type.base == Base::boolean ? chosen : mixed, large);
    if (const Row* row = row_of(name)) {
        if (row->result != Base::unknown) large.base = row->result;
        return by_component(given, row->f, large);
    }
    return vector_function(name, given);
}

}  // namespace snell::glsl::run
