// Operators, conversions, and what is selected from values.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/run/machine.h"

namespace snell::glsl::run {

namespace {

constexpr double most_int = 2147483647., most_uint = 4294967295.;

// A number as one of that type; nothing where GLSL does not say what it becomes.
double number_as(Base base, double x) {
    if (base == Base::boolean) return std::isnan(x) ? x : x != 0 ? 1. : 0.;
    if (base == Base::integer) return std::abs(x) <= most_int ? std::trunc(x) : nothing;
    if (base == Base::uinteger) return x > -1 && x <= most_uint ? std::trunc(x) : nothing;
    return x;
}

template <class F>
double if_known(double a, double b, F f) {
    return std::isnan(a) || std::isnan(b) ? nothing : static_cast<double>(f(a, b));
}

template <class F>
double bits(double a, double b, F f) {
    return if_known(a, b, [&](double x, double y) {
        return static_cast<double>(f(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)));
    });
}

bool shifts(std::int64_t by) { return by >= 0 && by < 31; }

Operator operator_of(std::string_view op, bool whole) {
    constexpr auto shift_left = [](double a, double b) {
        return b >= 0 && b < 31 ? number_as(Base::integer, a * std::exp2(b)) : nothing;
    };
    constexpr auto shift_right = [](double a, double b) {
        return bits(a, b,
                    [](std::int64_t x, std::int64_t y) { return shifts(y) ? static_cast<double>(x >> y) : nothing; });
    };
    struct Row {
        std::string_view op;
        Operator f;
    };
    static constexpr Row rows[] = {
        {"+", [](double a, double b) { return a + b; }},
        {"-", [](double a, double b) { return a - b; }},
        {"*", [](double a, double b) { return a * b; }},
        {"<", [](double a, double b) { return if_known(a, b, std::less<>()); }},
        {">", [](double a, double b) { return if_known(a, b, std::greater<>()); }},
        {"<=", [](double a, double b) { return if_known(a, b, std::less_equal<>()); }},
        {">=", [](double a, double b) { return if_known(a, b, std::greater_equal<>()); }},
        {"&&", [](double a, double b) { return a == 0 || b == 0 ? 0. : if_known(a, b, std::logical_and<>()); }},
        {"||", [](double a, double b) { return if_known(a, b, std::logical_or<>()); }},
        {"^^", [](double a, double b) { return if_known(a, b, std::not_equal_to<>()); }},
        {"&", [](double a, double b) { return bits(a, b, std::bit_and<>()); }},
        {"|", [](double a, double b) { return bits(a, b, std::bit_or<>()); }},
        {"^", [](double a, double b) { return bits(a, b, std::bit_xor<>()); }},
        {"%", [](double a, double b) { return a >= 0 && b > 0 ? std::fmod(a, b) : nothing; }},
        {"<<", shift_left},
        {">>", shift_right},
    };
    if (op == "/" && whole) return [](double a, double b) { return finite(std::trunc(a / b)); };
    if (op == "/") return [](double a, double b) { return finite(a / b); };
    const auto* found = ranges::find(rows, op, &Row::op);
    return found == std::end(rows) ? [](double, double) { return nothing; } : found->f;
}

bool compares(std::string_view op) {
    const bool twice = op.size() == 2 && op[0] == op[1];  // && || ^^, and << >>
    return op[0] == '<' || op[0] == '>' ? !twice : twice;
}

}  // namespace

Value Machine::converted(const Value& v, const Type& type) {
    if (!type.basic() || v.type.base == type.base || (v.type.floating() && type.floating())) return v;
    Value out = make(v.type, v.size, v.lanes);
    out.type.base = type.base;
    for (int n = 0; n < v.size * v.lanes; ++n) out.data[n] = number_as(type.base, v.data[n]);
    return out;
}

// Components of any arguments in a row, as constructors take them.
Value Machine::construct(const Type& type, int n) {
    if (stack_.size() < statement_stack_ + static_cast<std::size_t>(n)) {
        stop(End::unknown);
        return unknown(type);
    }
    const std::vector<Value> given(stack_.end() - n, stack_.end());
    stack_.resize(stack_.size() - given.size());
    const int size = count(u_, type);
    if (size == 0) return unknown(type);
    int lanes = 1, have = 0;
    for (const Value& v : given) lanes = std::max(lanes, v.lanes), have += v.size;
    Value out = make(type, size, lanes);
    std::fill_n(out.data, size * lanes, nothing);
    const auto put = [&](int to, const Value& v, int k) {
        for (int l = 0; l < lanes; ++l)
            out.data[to * lanes + l] = type.basic() ? number_as(type.base, v.get(k, l)) : v.get(k, l);
    };
    const bool plain = type.dims == 0 && type.base != Base::structure, matrix = type.cols > 1;
    if (plain && n == 1 && (given[0].type.scalar() || given[0].type.cols > 1) && matrix) {
        const Value& v = given[0];
        Value zero = make(type, 1, 1), one = make(type, 1, 1);
        zero.data[0] = 0, one.data[0] = 1;
        for (int c = 0; c < type.cols; ++c)
            for (int r = 0; r < type.rows; ++r) {
                const bool inside = v.type.cols > 1 && c < v.type.cols && r < v.type.rows;
                const Value& other = c != r ? zero : v.type.cols > 1 ? one : v;
                put(c * type.rows + r, inside ? v : other, inside ? c * v.type.rows + r : 0);
            }
    } else if (plain && n == 1 && given[0].type.scalar()) {
        for (int k = 0; k < size; ++k) put(k, given[0], 0);
    } else if (have >= size) {
        int to = 0;
        for (const Value& v : given)
            for (int k = 0; k < v.size && to < size; ++k) put(to++, v, k);
    }
    return out;
}

Value Machine::choose(const Value& condition, const Value& a, const Value& b) {
    if (a.size != b.size) return unknown(a.type);
    Value out = make(a.type, a.size, std::max({condition.lanes, a.lanes, b.lanes}));
    out.type.base = std::max(a.type.base, b.type.base);
    for (int k = 0; k < a.size; ++k)
        for (int l = 0; l < out.lanes; ++l) {
            const double which = condition.get(0, l);
            out.data[k * out.lanes + l] = std::isnan(which) ? nothing : which != 0 ? a.get(k, l) : b.get(k, l);
        }
    return out;
}

Value Machine::prefix(std::string_view op, const Value& v) {
    if (op == "+") return v;
    Value out = make(v.type, v.size, v.lanes);
    for (int n = 0; n < v.size * v.lanes; ++n) {
        const double x = v.data[n];
        out.data[n] = op == "-"                      ? -x
                      : std::isnan(x)                ? x
                      : op == "!"                    ? (x == 0 ? 1. : 0.)
                      : v.type.base == Base::integer ? -x - 1
                                                     : most_uint - x;
    }
    if (op == "!") out.type.base = Base::boolean;
    return out;
}

Value Machine::equal(const Value& a, const Value& b, bool same) {
    Value out = make(shape(Base::boolean), 1, std::max(a.lanes, b.lanes));
    for (int l = 0; l < out.lanes; ++l) {
        bool equal = a.size == b.size, known = equal;
        for (int k = 0; k < a.size && known; ++k) {
            const double x = a.get(k, l), y = b.get(k, l);
            known = !std::isnan(x) && !std::isnan(y);
            equal = equal && x == y;
        }
        out.data[l] = !known ? nothing : equal == same ? 1. : 0.;
    }
    return out;
}

// Products where one operand is a matrix and the other a vector or a matrix.
Value Machine::multiply(const Value& a, const Value& b) {
    const bool row = a.type.cols == 1;  // vector * matrix
    const int rows = row ? 1 : a.type.rows, inner = row ? a.type.rows : a.type.cols, cols = b.type.cols;
    if (b.type.rows != inner) return unknown(unknown_type());
    const Type type = row ? shape(a.type.base, cols) : shape(a.type.base, rows, cols);
    Value out = make(type, rows * cols, std::max(a.lanes, b.lanes));
    for (int c = 0; c < cols; ++c)
        for (int r = 0; r < rows; ++r)
            for (int l = 0; l < out.lanes; ++l) {
                double sum = 0;
                for (int k = 0; k < inner; ++k) sum += a.get(k * rows + r, l) * b.get(c * inner + k, l);
                out.data[(c * rows + r) * out.lanes + l] = sum;
            }
    return out;
}

Value Machine::infix(const Instruction& i, std::string_view op, const Value& a, const Value& b) {
    if (op.size() == 2 && op[1] == '=' && (op[0] == '=' || op[0] == '!')) return equal(a, b, op[0] == '=');
    if (!a.type.basic() || !b.type.basic() || a.type.dims || b.type.dims) return unknown(unknown_type());
    const bool matrix = a.type.cols > 1 || b.type.cols > 1;
    if (op[0] == '*' && matrix && a.size > 1 && b.size > 1) return multiply(a, b);
    if (a.size != b.size && a.size != 1 && b.size != 1) return unknown(unknown_type());
    const Value& large = a.size >= b.size ? a : b;
    Value out = make(large.type, large.size, std::max(a.lanes, b.lanes));
    out.variable = -1;
    out.type.base = compares(op) ? Base::boolean : std::max(a.type.base, b.type.base);
    const bool whole = out.type.integral();
    Operator& f = operators_[static_cast<std::size_t>(&i - u_.code.steps.data())];
    if (!f) f = operator_of(op, whole);
    for (int k = 0; k < out.size; ++k) {
        const double *x = a.data + (a.size > 1 ? k : 0) * a.lanes, *y = b.data + (b.size > 1 ? k : 0) * b.lanes;
        double* to = out.data + k * out.lanes;
        for (int l = 0; l < out.lanes; ++l) {
            const double result = f(x[a.lanes > 1 ? l : 0], y[b.lanes > 1 ? l : 0]);
            to[l] = whole ? number_as(out.type.base, result) : result;
        }
    }
    return out;
}

// A contiguous part: an element, a column or a member.
Value Machine::part(const Value& v, const Type& type, int first, int size) {
    Value out = v;
    out.type = type;
    out.size = size;
    out.data = v.data + first * v.lanes;
    out.lost = v.lost || v.swizzled;
    out.first = v.first + first;
    return out;
}

Value Machine::component(const Value& v, std::string_view swizzle) {
    if (swizzle.size() > 4 || v.type.dims || v.type.cols > 1 || !v.type.basic()) return unknown(unknown_type());
    Value out = make(shape(v.type.base, static_cast<int>(swizzle.size())), static_cast<int>(swizzle.size()), v.lanes);
    for (std::size_t k = 0; k < swizzle.size(); ++k) {
        constexpr std::string_view sets = "xyzwrgbastpq";
        const std::size_t found = sets.find(swizzle[k]);
        const int n = static_cast<int>(found % 4);
        if (found == sets.npos || n >= v.size) return unknown(out.type);
        std::copy_n(v.data + n * v.lanes, v.lanes, out.data + static_cast<int>(k) * v.lanes);
        out.at[k] = v.swizzled ? v.at[static_cast<std::size_t>(n)] : static_cast<std::uint8_t>(n);
    }
    out.variable = v.variable;
    out.first = v.first;
    out.lost = v.lost;
    out.swizzled = true;
    return out;
}

Value Machine::select(const Value& v, std::string_view member) {
    if (v.type.base != Base::structure || v.type.dims || v.type.structure < 0) return component(v, member);
    int first = count(u_, v.type) == v.size ? 0 : v.size;  // or its members are not known
    for (const Member& m : u_.structure(v.type).members) {
        const int size = count(u_, m.type);
        if (size == 0 || first + size > v.size) break;
        if (m.name == member) return part(v, m.type, first, size);
        first += size;
    }
    Value out = unknown(unknown_type());
    out.variable = v.variable;
    out.lost = true;
    return out;
}

Value Machine::element(const Value& v, const Value& index) {
    Type type = v.type;
    int elements = 1;
    if (type.dims > 0) {
        elements = type.size;
        --type.dims, type.size = -1;
    } else if (type.cols > 1) {
        elements = type.cols;
        type = shape(type.base, type.rows);
    } else {
        elements = type.rows;
        type = shape(type.base);
    }
    const int size = count(u_, type);
    if (size == 0 || elements <= 0 || size * elements != v.size || index.size != 1) {
        Value out = unknown(type);
        out.variable = v.variable;
        out.lost = true;
        return out;
    }
    const double n = index.get(0, 0);
    bool same = n >= 0 && n < elements;
    for (int l = 1; l < index.lanes; ++l) same = same && index.get(0, l) == n;
    if (!same) return gather(v, index, type, size, elements);
    if (!v.swizzled) return part(v, type, static_cast<int>(n) * size, size);
    Value out = component(v, std::string_view("xyzw").substr(static_cast<std::size_t>(n), 1));
    return out;
}

// Lanes read different elements.
Value Machine::gather(const Value& v, const Value& index, const Type& type, int size, int elements) {
    Value out = make(type, size, lanes_);
    for (int k = 0; k < size; ++k)
        for (int l = 0; l < lanes_; ++l) {
            const double n = index.get(0, l);
            out.data[k * lanes_ + l] = n >= 0 && n < elements ? v.get(static_cast<int>(n) * size + k, l) : nothing;
        }
    out.variable = v.variable;
    out.lost = true;
    return out;
}

}  // namespace snell::glsl::run
