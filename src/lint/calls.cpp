// Calls: constructors, the user's functions walked anew with what is known of their arguments, and built-in
// functions that say something about a number.
#include <algorithm>
#include <cmath>

#include "src/glsl/read/words.h"
#include "src/lint/walker.h"

namespace snell::lint {

using glsl::Base;
using glsl::Storage;

Walker::Expr Walker::call(int node) {
    const glsl::Node& n = at(node);
    std::vector<Expr> given;
    for (const int part : parts(node)) given.push_back(evaluate(part));
    Expr e;
    const std::string_view name = u_.at(n.first).text;
    if (n.form == glsl::Form::construct) {
        if (n.type.basic() && n.type.dims == 0) e.v = constructed(n.type, given);
    } else if (const glsl::Function* f = find_function(n, given.size())) {
        for (std::size_t k = 0; k < given.size(); ++k)
            if (f->parameters[k].variable >= 0) define(f->parameters[k].variable, parts(node)[k]);
        e.v = call_user(*f, given);
    } else if (u_.function_names.contains(name)) {  // it is unknown which one
        for (const Expr& a : given)
            if (a.slot >= 0) forget(a.slot);
    } else {
        const Varies before = e.v.varies;
        e.v = call_builtin(n.text, given, n.first, n.last);
        if (e.v.varies == before && !given.empty()) {
            e.v.varies = Varies::no;
            for (const Expr& a : given) e.v.varies = together(e.v.varies, a.v.varies);
        }
        if (glsl::builtin_signatures(n.text).empty()) e.v.varies = Varies::unknown;
        if (!name.starts_with("tex"))  // what is looked up is no direction
            for (const Expr& a : given) e.v.refracted = e.v.refracted || a.v.refracted;
    }
    if (!e.v.id) e.v.id = fresh();
    return e;
}

// The body that a call runs; null where that is not certain.
const glsl::Function* Walker::find_function(const glsl::Node& call, std::size_t arguments) const {
    const glsl::Function* meant = call.function < 0 ? nullptr : &u_.functions[static_cast<std::size_t>(call.function)];
    const auto like = [](const glsl::Function& a, const glsl::Function& b) {
        return std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(), b.parameters.end(),
                          [](const glsl::Parameter& x, const glsl::Parameter& y) { return x.type.same(y.type); });
    };
    const glsl::Function* found = nullptr;
    for (const glsl::Function& f : u_.functions) {
        if (f.block < 0 || f.name != u_.at(call.first).text || f.parameters.size() != arguments) continue;
        if (meant && !like(f, *meant)) continue;
        if (found) return nullptr;
        found = &f;
    }
    return found;
}

Value Walker::call_user(const glsl::Function& f, const std::vector<Expr>& given) {
    Value unknown;
    unknown.type = f.result;
    const bool recursive = std::find(calling_.begin(), calling_.end(), &f) != calling_.end();
    for (std::size_t n = 0; n < given.size(); ++n)
        if (f.parameters[n].storage != Storage::in && given[n].slot >= 0) forget(given[n].slot);
    if (f.block < 0 || recursive || calling_.size() > 12 || budget_ <= 0) return unknown;
    std::optional<Value> result = std::move(result_);
    result_.reset();
    calling_.push_back(&f);
    for (std::size_t n = 0; n < given.size(); ++n) {
        if (f.parameters[n].variable < 0) continue;
        Value v = f.parameters[n].storage == Storage::out ? Value{} : given[n].v;
        v.type = f.parameters[n].type;
        slot(f.parameters[n].variable).value = v;
    }
    statement(f.block);
    calling_.pop_back();
    if (!calling_.empty()) state_.dead = false;
    Value v = result_.value_or(unknown);
    v.type = f.result;
    result_ = std::move(result);
    return v;
}

Value Walker::constructed(const glsl::Type& type, const std::vector<Expr>& given) {
    Value v;
    v.varies = Varies::no;
    for (const Expr& a : given) v.varies = together(v.varies, a.v.varies);
    if (given.size() == 1 && given[0].v.type.base != Base::unknown && given[0].v.type.dims == 0) {
        const Value& x = given[0].v;
        const bool same = x.type.rows == type.rows && x.type.cols == type.cols;
        const bool shortened = type.cols == 1 ? type.rows == 3 && x.type.rows >= 3 : x.type.cols > 1 && type.rows >= 3;
        v = same || shortened ? x : Value{};
        if (same && type.base != x.type.base) v.id = 0, v.uniform = -1;
        v.varies = x.varies;
        if (x.type.scalar()) v.range = x.range, v.space = x.space == Space::any ? Space::any : Space::unknown;
        v.plain = x.plain;
    } else if (!given.empty()) {
        // vec4(position, 1.) keeps what is known of the position; other parts make a range.
        v = type.rows == 4 && given.size() == 2 && given[0].v.type.rows == 3 ? given[0].v : Value{};
        v.varies = given[0].v.varies;
        bool constant = true;
        for (std::size_t n = 1; n < given.size(); ++n) v.varies = together(v.varies, given[n].v.varies);
        Range range = given[0].v.range;
        for (const Expr& a : given) {
            range = either(range, a.v.range);
            constant = constant && a.v.space == Space::any;
        }
        v.range = range;
        if (given.size() == 2 && type.rows == 4 && given[1].v.range == exactly(1) && v.space != Space::unknown)
            v.point = true;
        if (given.size() == 2 && type.rows == 4 && given[1].v.range == exactly(0)) v.point = false;
        if (constant) v.space = Space::any, v.plain = true;
        v.id = v.opposite = 0;
    }
    v.type = type;
    return v;
}

Value Walker::call_builtin(std::string_view name, const std::vector<Expr>& given, int first, int last) {
    Value v;
    if (name == "ftransform") return v;
    if (name.starts_with("tex") && !given.empty() && given[0].v.type.base == Base::sampler)
        return call_texture(name, given, first, last);
    if (name == "reflect" && given.size() == 2) return call_reflect(given);
    if (name == "refract" && given.size() == 3) return call_refract(given);
    if (name == "dot" && given.size() == 2) return call_dot(given);
    if (name == "pow" && given.size() == 2) call_pow(given, first, last);
    if (name == "smoothstep" && given.size() == 3) want_width(given, first, last);
    if (name == "normalize" && given.size() == 1) {
        v = given[0].v;
        v.id = v.opposite = 0;
        v.length = Length::unit;
        v.why = Why::none;
        v.range = {};
        v.uniform = -1;
        return v;
    }
    if ((name == "inverse" || name == "transpose") && given.size() == 1) {
        v = given[0].v;
        std::swap(v.from, v.to);
        v.id = 0;
        return v;
    }
    if (name == "mix" && given.size() == 3) {
        v = either(given[0].v, given[1].v);
        if (v.length == Length::unit) v.length = Length::unknown;
        v.range.real_lo = v.range.real_hi = false;
        v.id = v.opposite = 0;
        v.varies = Varies::unknown;
        return v;
    }
    if (name == "faceforward" && given.size() == 3) {
        v = given[0].v;
        v.id = v.opposite = 0;
        return v;
    }
    if (auto number = call_number(name, given)) return *number;
    return v;
}

// Bounds of numbers.
std::optional<Value> Walker::call_number(std::string_view name, const std::vector<Expr>& given) {
    if (given.empty()) return std::nullopt;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Value v;
    const Range& x = given[0].v.range;
    const auto range = [&](std::size_t n) { return n < given.size() ? given[n].v.range : Range{}; };
    if (name == "length" || name == "distance") {
        v.range = {0, infinity, false, false};
    } else if (name == "abs") {
        v.range = {0, std::max(std::abs(x.lo), std::abs(x.hi)), false, x.real_lo && x.real_hi};
    } else if (name == "sqrt" || name == "exp" || name == "exp2" || name == "inversesqrt") {
        v.range = {0, infinity, false, false};
    } else if (name == "pow") {
        v.range = {0, x.lo >= 0 && x.hi <= 1 && range(1).lo >= 0 ? 1 : infinity, false, false};
    } else if (name == "max") {
        v.range = larger(x, range(1));
    } else if (name == "min") {
        v.range = smaller(x, range(1));
    } else if (name == "clamp") {
        v.range = smaller(larger(x, range(1)), range(2));
    } else if (name == "saturate" || name == "smoothstep" || name == "step" || name == "fract") {
        const bool all = name == "fract" && x.real_lo && x.real_hi && x.hi - x.lo >= 1;
        v.range = {0, 1, all, all};
        v.name = given[0].v.name;
    } else if (name == "sin" || name == "cos") {
        v.range = between(-1, 1);
        if (given[0].v.varies == Varies::no && x.lo == x.hi) v.range = {-1, 1, false, false};
    } else if (name == "mod" && range(1).lo > 0) {
        v.range = {0, range(1).hi, false, false};
    } else {
        return std::nullopt;
    }
    if (name == "max" || name == "min" || name == "clamp") {
        v.cosine = given[0].v.cosine;  // of the same sign, as far as it goes
        v.one_plus = given[0].v.one_plus;
    }
    return v;
}

}  // namespace snell::lint
