// Expressions: what is known of a result, given what is known of the operands.
#include <algorithm>

#include "parser/text/number.h"
#include "src/glsl/read/words.h"
#include "src/lint/walker.h"

namespace snell::lint {

using glsl::Base;
using glsl::Kind;

namespace {

bool is_constant(const Value& v) { return v.range.lo == v.range.hi && v.range.real_lo; }

// One number, the same in every component.
std::optional<double> constant(const Value& v) { return is_constant(v) ? std::optional(v.range.lo) : std::nullopt; }

// Of one sign in the whole picture: a product with it has both signs where the other factor has.
bool keeps_sign(const Value& v) { return v.uniform >= 0 || v.range.lo > 0; }

}  // namespace

Walker::Expr Walker::expression() {
    Expr e = assignment();
    while (accept(",")) e = assignment();
    return e;
}

Walker::Expr Walker::assignment() {
    if (--budget_ < 0 || depth_ > 100) {
        Expr e;
        e.first = p_;
        p_ = matching(p_) + 1;
        e.last = p_ - 1;
        return e;
    }
    ++depth_;
    Expr target = ternary();
    if (glsl::assigns(text())) {
        const std::string_view op = text();
        ++p_;
        const Expr value = assignment();
        assign(target, value, op);
        target.last = value.last;
        target.slot = -1;
    }
    --depth_;
    return target;
}

void Walker::assign(Expr& target, const Expr& value, std::string_view op) {
    if (!target.whole && op == "=" && target.last >= 0) note_channel(value.v, u_.at(target.last).text, value.first);
    Value result = op == "=" ? value.v : combine(target.v, value.v, op.substr(0, 1));
    if (op == "-=") note_difference(result, target, value);
    if (target.slot >= 0) {
        Slot& slot = state_.slots[static_cast<std::size_t>(target.slot)];
        if (!target.whole || unstable_.contains(target.slot)) {
            forget(target.slot);
        } else if (!slot.constant) {
            const glsl::Type type = slot.value.type;
            slot.value = result;
            slot.value.type = type;
        }
    }
    target.v = result;
}

Walker::Expr Walker::ternary() {
    Expr condition = binary(1);
    if (!accept("?")) return condition;
    const std::vector<int> names = [&] {
        std::vector<int> found;
        for (int k = condition.first; k <= condition.last; ++k)
            if (u_.at(k).kind == Kind::identifier) found.push_back(k);
        return found;
    }();
    for (const int k : names) conditions_.insert(u_.at(k).text);
    Expr a = assignment();
    accept(":");
    const Expr b = assignment();
    for (const int k : names)
        if (const auto found = conditions_.find(u_.at(k).text); found != conditions_.end()) conditions_.erase(found);
    a.v = either(a.v, b.v);
    // A comparison chose the value, so it is unknown which bound is reached.
    a.v.range.real_lo = a.v.range.real_hi = false;
    a.v.varies = together(a.v.varies, condition.v.varies);
    a.slot = -1;
    a.first = condition.first;
    a.last = b.last;
    return a;
}

Walker::Expr Walker::binary(int least) {
    Expr left = unary();
    for (int level = glsl::precedence(text()); level >= least && level > 0; level = glsl::precedence(text())) {
        const std::string_view op = text();
        ++p_;
        const Expr right = binary(level + 1);
        if (op == "-") want_near(left, right);
        if (op == "*")
            note_factor(left, right);
        else
            left.factor = {};
        Value result = combine(left.v, right.v, op);
        if (op == "-") note_difference(result, left, right);
        left.v = std::move(result);
        left.last = right.last;
        left.slot = -1;
    }
    return left;
}

Walker::Expr Walker::unary() {
    const std::string_view op = text();
    if (token().kind != Kind::punct || (op != "-" && op != "+" && op != "!" && op != "~" && op != "++" && op != "--"))
        return postfix();
    const int first = p_;
    ++p_;
    if (depth_ > 100) return primary();
    ++depth_;
    Expr e = unary();
    --depth_;
    e.first = first;
    if (op == "-") e.v = negate(e.v);
    if (op == "++" || op == "--") {
        if (e.slot >= 0) forget(e.slot);
        e.v.range = {};
    }
    if (op != "+") e.slot = -1;
    return e;
}

Value Walker::negate(const Value& v) {
    Value n = v;
    n.id = v.opposite ? v.opposite : fresh();
    n.opposite = v.id;
    n.range = negative(v.range);
    if (v.difference.first >= 0) n.difference.turned = !v.difference.turned;
    n.uniform = -1;
    n.cosine.sign = -v.cosine.sign;
    n.one_plus = {};
    n.eta = {};
    std::swap(n.mirrored, n.mirrored_opposite);
    return n;
}

void Walker::note_difference(Value& v, const Expr& a, const Expr& b) {
    if (!is_constant(a.v) && !is_constant(b.v)) v.difference = {a.first, b.last};
}

Value Walker::combine(const Value& a, const Value& b, std::string_view op) {
    Value v;
    if (op == "+" || op == "-") {
        v = add(a, b, op == "-");
    } else if (op == "*") {
        v = multiply(a, b);
    } else if (op == "/") {
        v.type = a.type.rows >= b.type.rows ? a.type : b.type;
        if (const double divisor = constant(b).value_or(0); divisor != 0)
            v.range = product(a.range, exactly(1 / divisor), false);
        else if (b.range.lo > 0)
            v.range = product(a.range, {1 / b.range.hi, 1 / b.range.lo, b.range.real_hi, b.range.real_lo}, false);
        if (a.type.rows > 1) v.space = a.space;
        if (keeps_sign(b)) v.difference = a.difference;
    } else {
        v.type = glsl::make_type(Base::boolean);
    }
    v.id = fresh();
    v.refracted = a.refracted || b.refracted;
    v.varies = together(a.varies, b.varies);
    return v;
}

Value Walker::add(const Value& a, const Value& b, bool minus) {
    Value v;
    v.type = a.type.rows >= b.type.rows ? a.type : b.type;
    v.range = sum(a.range, minus ? negative(b.range) : b.range);
    v.space = a.space == b.space ? a.space : Space::unknown;
    if (a.space == Space::any) v.space = b.space;
    if (b.space == Space::any) v.space = a.space;
    v.point = (a.point && b.space == Space::any) || (b.point && a.space == Space::any && minus);
    v.plain = a.plain && b.plain;
    v.name = a.name.empty() ? b.name : a.name;
    if (v.type.rows > 1 && v.plain && (spatial(a) || spatial(b))) {
        v.length = Length::other;
        v.why = a.point || b.point ? Why::position : Why::sum;
    }
    const bool one_first = constant(a) == 1.0, one_last = !minus && constant(b) == 1.0;
    if (one_first && b.cosine.sign != 0)
        v.one_plus = {b.cosine.first, b.cosine.second, minus ? -b.cosine.sign : b.cosine.sign};
    if (one_last && a.cosine.sign != 0) v.one_plus = a.cosine;
    const auto shift = constant(b);
    if (shift && a.type.scalar() && a.id) {
        v.eta = a.eta.base ? a.eta : Bend{a.id, 0};
        v.eta.shift += minus ? -*shift : *shift;
    }
    return v;
}

Value Walker::multiply(const Value& a, const Value& b) {
    Value v;
    const bool matrix_a = a.type.cols > 1, matrix_b = b.type.cols > 1;
    if (matrix_a && matrix_b) {
        v.type = a.type;
        if (a.from == b.to || a.from == Space::unknown || b.to == Space::unknown) {
            v.from = a.to == Space::unknown ? Space::unknown : b.from;
            v.to = b.from == Space::unknown ? Space::unknown : a.to;
        }
        return v;
    }
    if (matrix_a || matrix_b) {  // a row vector times a matrix is the transpose's product: back, for a rotation
        const Value& m = matrix_a ? a : b;
        const Value& x = matrix_a ? b : a;
        const Space from = matrix_a ? m.from : m.to, to = matrix_a ? m.to : m.from;
        v.type = x.type;
        v.name = x.name;
        if (x.space == from || x.space == Space::any || x.space == Space::unknown) v.space = to;
        v.point = x.point && v.space != Space::unknown;
        v.plain = x.plain;
        if (v.point && v.space != Space::unknown) v.length = Length::other, v.why = Why::position;
        return v;
    }
    v.type = a.type.rows >= b.type.rows ? a.type : b.type;
    v.range = product(a.range, b.range, a.id != 0 && a.id == b.id);
    if (keeps_sign(a) || keeps_sign(b)) v.difference = keeps_sign(a) ? b.difference : a.difference;
    const bool scaled = a.type.rows > 1 && b.type.scalar();
    const Value& x = scaled ? a : b;
    const Value& factor = scaled ? b : a;
    if (x.type.rows > 1 && factor.type.scalar()) {
        v.space = x.space;
        v.plain = x.plain && is_constant(factor);
        v.name = x.name;
        if (const auto k = constant(factor); k && *k > 0) v.length = *k == 1 ? x.length : Length::unknown;
    }
    if (x.type.scalar() && factor.type.scalar())
        if (const auto k = constant(factor); k && *k == -1)
            v.cosine = {x.cosine.first, x.cosine.second, -x.cosine.sign};
    return v;
}

Walker::Expr Walker::postfix() {
    Expr e = primary();
    for (;;) {
        if (is("[")) {
            const int close = matching(p_);
            ++p_;
            const Expr index = expression();
            p_ = close + 1;
            Value v;
            v.varies = together(e.v.varies, index.v.varies);
            v.id = fresh();
            v.type = e.v.type;
            if (v.type.dims > 0)
                --v.type.dims;
            else if (v.type.cols > 1)
                v.type = glsl::make_type(v.type.base, v.type.rows);
            else
                v.type = glsl::make_type(v.type.base), v.range = e.v.range;
            e.v = v;
            e.whole = false;
        } else if (is(".") && token(1).kind == Kind::identifier) {
            const std::string_view member = text(1);
            p_ += 2;
            if (is("(")) p_ = matching(p_) + 1;
            select(e, member);
        } else if (is("++") || is("--")) {
            ++p_;
            if (e.slot >= 0) forget(e.slot);
            e.v.range = {};
            e.slot = -1;
        } else {
            break;
        }
        e.last = p_ - 1;
    }
    return e;
}

void Walker::select(Expr& e, std::string_view member) {
    const glsl::Type type = e.v.type;
    const bool vector = type.dims == 0 && type.cols == 1 && type.basic();
    const bool same = member == "xyz" || member == "rgb" || member == "stp";
    e.whole = false;
    if (vector && same && type.rows >= 3) {  // also xyz of a position of four components
        e.v.type = glsl::make_type(type.base, 3);
        return;
    }
    Value v;
    v.varies = e.v.varies;
    v.id = fresh();
    if (vector && member.size() <= 4) {
        v.type = glsl::make_type(type.base, static_cast<int>(member.size()));
        v.range = e.v.range;
        v.bend = e.v.bend;
        v.difference = e.v.difference;
        v.plain = e.v.plain;
        v.name = e.v.name;
        if (member.size() == 1) note_channel(e.v, member, p_ - 1);
    }
    e.v = v;
}

Walker::Expr Walker::number() {
    Expr e;
    e.first = e.last = p_;
    const std::string_view t = text();
    const bool whole = token().kind == Kind::integer;
    double v = 0;
    read_real(t.data(), t.data() + t.size(), v);
    e.v.type = glsl::make_type(whole ? Base::integer : Base::real);
    e.v.range = exactly(v);
    e.v.space = Space::any;
    e.v.plain = true;
    e.v.varies = Varies::no;
    e.v.id = fresh();
    ++p_;
    return e;
}

Walker::Expr Walker::primary() {
    Expr e;
    e.first = e.last = p_;
    const glsl::Token& t = token();
    if (t.kind == Kind::integer || t.kind == Kind::real) return number();
    if (t.text == "(") {
        const int open = p_, close = matching(p_);
        ++p_;
        e = expression();
        p_ = close + 1;
        e.first = open;
        e.last = close;
        return e;
    }
    if (t.kind != Kind::identifier) {
        if (t.kind != Kind::end && t.text != ";" && t.text != ")" && t.text != "}" && t.text != "]") ++p_;
        return e;
    }
    if (is("(", 1) || (is("[", 1) && glsl::builtin_type(t.text) && find(t.text) < 0)) return call();
    return name();
}

Walker::Expr Walker::name() {
    Expr e;
    e.first = e.last = p_;
    const std::string_view t = text();
    ++p_;
    e.slot = find(t);
    if (e.slot < 0) {
        e.v = built_in(t);
        if (!e.v.id) e.v.id = fresh();
        return e;
    }
    Slot& slot = state_.slots[static_cast<std::size_t>(e.slot)];
    if (!slot.value.id) slot.value.id = fresh();
    e.v = slot.value;
    return e;
}

}  // namespace snell::lint
