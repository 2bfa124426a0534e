// Expressions: what is known of a result, given what is known of the operands.
#include <algorithm>

#include "src/glsl/read/words.h"
#include "src/lint/walker.h"

namespace snell::lint {

using glsl::Base;
using glsl::Form;
using glsl::Node;

namespace {

bool is_constant(const Value& v) { return v.range.lo == v.range.hi && v.range.real_lo; }

// One number, the same in every component.
std::optional<double> constant(const Value& v) { return is_constant(v) ? std::optional(v.range.lo) : std::nullopt; }

// Of one sign in the whole picture: a product with it has both signs where the other factor has.
bool keeps_sign(const Value& v) { return v.uniform >= 0 || v.range.lo > 0; }

}  // namespace

// What is known of a node, and its type.
Walker::Expr Walker::evaluate(int node) {
    const Node& n = at(node);
    Expr e;
    if (--budget_ >= 0 && depth_ <= 200) {
        ++depth_;
        e = result(node);
        --depth_;
    }
    e.first = n.first;
    e.last = n.last;
    if (n.type.base != Base::unknown) e.v.type = n.type;
    return e;
}

Walker::Expr Walker::result(int node) {
    const Node& n = at(node);
    const std::vector<int> inside = parts(node);
    Expr e;
    switch (n.form) {
        case Form::name:
            return name(n);
        case Form::number:
            return number(n);
        case Form::construct:
        case Form::call:
        case Form::built_in:
            return call(node);
        case Form::group:
        case Form::comma:
            for (const int part : inside) e = evaluate(part);
            return e;
        case Form::select:
        case Form::length:
            e = evaluate(inside[0]);
            select(e, n);
            return e;
        case Form::index:
            return index(inside);
        case Form::choose:
            return choose(inside);
        case Form::prefix:
            e = evaluate(inside[0]);
            if (n.text == "-") e.v = negate(e.v);
            if (n.text != "+") e.slot = -1;
            return e;
        case Form::step:
            e = evaluate(inside[0]);
            if (e.slot >= 0) forget(e.slot);
            e.v.range = {};
            e.slot = -1;
            return e;
        case Form::assign: {
            e = evaluate(inside[0]);
            assign(e, evaluate(inside[1]), n.text);
            note_reasons(e.slot, inside[1]);
            e.slot = -1;
            return e;
        }
        case Form::infix: {
            e = evaluate(inside[0]);
            const Expr right = evaluate(inside[1]);
            if (n.text == "-") want_near(e, right);
            if (n.text == "*")
                note_factor(e, right);
            else
                e.factor = {};
            Value v = combine(n.type, e.v, right.v, n.text);
            if (n.text == "-") note_difference(v, e, right);
            e.v = std::move(v);
            e.slot = -1;
            return e;
        }
        default:
            return e;
    }
}

void Walker::assign(Expr& target, const Expr& value, std::string_view op) {
    if (!target.whole && op == "=" && target.last >= 0) note_channel(value.v, u_.at(target.last).text, value.first);
    Value result = op == "=" ? value.v : combine(target.v.type, target.v, value.v, op.substr(0, 1));
    if (op == "-=") note_difference(result, target, value);
    if (target.slot >= 0) {
        Slot& known = slot(target.slot);
        if (!target.whole || unstable_.contains(target.slot)) {
            forget(target.slot);
        } else if (!known.constant) {
            forget(target.slot);
            const glsl::Type type = known.value.type;
            known.value = result;
            known.value.type = type;
        }
    }
    target.v = result;
}

Walker::Expr Walker::choose(const std::vector<int>& parts) {
    const Expr condition = evaluate(parts[0]);
    for (const Node* name : conditioned(at(parts[0]).begin, parts[0])) conditions_.insert(name->text);
    Expr a, b;
    apart([&] { a = evaluate(parts[1]); });
    apart([&] { b = evaluate(parts[2]); });
    conditions_end(parts[0]);
    a.v = either(a.v, b.v);
    a.v.varies = together(a.v.varies, condition.v.varies);
    a.slot = -1;
    return a;
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

Value Walker::combine(const glsl::Type& type, const Value& a, const Value& b, std::string_view op) {
    Value v;
    if (op == "+" || op == "-") {
        v = add(type, a, b, op == "-");
    } else if (op == "*") {
        v = multiply(a, b);
    } else if (op == "/") {
        if (const double divisor = constant(b).value_or(0); divisor != 0)
            v.range = product(a.range, exactly(1 / divisor), false);
        else if (b.range.lo > 0)
            v.range = product(a.range, {1 / b.range.hi, 1 / b.range.lo, b.range.real_hi, b.range.real_lo}, false);
        if (a.type.rows > 1) v.space = a.space;
        if (keeps_sign(b)) v.difference = a.difference;
    }
    v.type = type;
    v.id = fresh();
    v.refracted = a.refracted || b.refracted;
    v.varies = together(a.varies, b.varies);
    if (v.name.empty()) v.name = a.name.empty() ? b.name : a.name;
    return v;
}

Value Walker::add(const glsl::Type& type, const Value& a, const Value& b, bool minus) {
    Value v;
    v.range = sum(a.range, minus ? negative(b.range) : b.range);
    v.space = a.space == b.space ? a.space : Space::unknown;
    if (a.space == Space::any) v.space = b.space;
    if (b.space == Space::any) v.space = a.space;
    v.point = (a.point && b.space == Space::any) || (b.point && a.space == Space::any && minus);
    v.plain = a.plain && b.plain;
    v.name = a.name.empty() ? b.name : a.name;
    if (type.rows > 1 && v.plain && (spatial(a) || spatial(b))) {
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
        v.name = x.name;
        if (x.space == from || x.space == Space::any || x.space == Space::unknown) v.space = to;
        v.point = x.point && v.space != Space::unknown;
        v.plain = x.plain;
        if (v.point && v.space != Space::unknown) v.length = Length::other, v.why = Why::position;
        return v;
    }
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

Walker::Expr Walker::index(const std::vector<int>& parts) {
    Expr e = evaluate(parts[0]);
    Value v;
    v.varies = together(e.v.varies, evaluate(parts[1]).v.varies);
    v.id = fresh();
    if (e.v.type.dims == 0 && e.v.type.cols == 1) v.range = e.v.range;
    e.v = v;
    e.whole = false;
    return e;
}

void Walker::select(Expr& e, const Node& node) {
    const glsl::Type type = e.v.type;
    const std::string_view member = node.text;
    const bool vector = type.dims == 0 && type.cols == 1 && type.basic() && node.form == Form::select;
    const bool same = member == "xyz" || member == "rgb" || member == "stp";
    e.whole = false;
    if (vector && same && type.rows >= 3) return;  // also xyz of a position of four components
    Value v;
    v.varies = e.v.varies;
    v.id = fresh();
    if (vector && member.size() <= 4) {
        v.range = e.v.range;
        v.bend = e.v.bend;
        v.difference = e.v.difference;
        v.plain = e.v.plain;
        v.name = e.v.name;
        if (member.size() == 1) note_channel(e.v, member, node.last);
    }
    e.v = v;
}

Walker::Expr Walker::number(const Node& node) {
    Expr e;
    e.v.varies = Varies::no;
    e.v.id = fresh();
    e.v.range = exactly(node.value.front());
    if (node.type.base == Base::boolean) return e;
    e.v.space = Space::any;
    e.v.plain = true;
    return e;
}

Walker::Expr Walker::name(const Node& node) {
    Expr e;
    e.slot = node.variable;
    if (e.slot < 0) {
        e.v = built_in(node.text);
        if (!e.v.id) e.v.id = fresh();
        return e;
    }
    Value& known = slot(e.slot).value;
    if (!known.id) known.id = fresh();
    e.v = known;
    return e;
}

}  // namespace snell::lint
