#include "src/accuracy/found/texts/texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell::accuracy::texts {

namespace {

using glsl::Form;

// f0 + (1 - f0) (1 - c)^power
struct Schlick {
    Expression f0;
    Expression base;      // 1 - c
    Expression exponent;  // none: a product
    Expression last;      // of the product's factors
    int factors = 0;
};

class Fresnel {
public:
    Fresnel(const Shader& shader, Offers& to) : s_(shader), to_(to) {}

    void run() {
        for (const int n : s_.expressions()) {
            look(Expression(s_, n));
            look_at_weights(Expression(s_, n));
        }
    }

private:
    static void factors(const Expression& e, std::vector<Expression>& all) {
        if (!e.infix("*")) return all.push_back(e);
        factors(e[0], all);
        factors(e[1], all);
    }

    static bool power(std::vector<Expression> of, Schlick& found) {
        if (of.size() == 1) {
            const Expression whole = of[0].resolved();
            if (whole.call("pow", 2)) return found.base = whole[0], found.exponent = whole[1], true;
            if (!whole.infix("*")) return false;
            of.clear();
            factors(whole, of);
        }
        if (of.size() < 2 || !ranges::all_of(of, [&](const Expression& f) { return f.same(of[0]); })) return false;
        found.base = of[0];
        found.last = of.back();
        found.factors = static_cast<int>(of.size());
        return true;
    }

    static bool rest_of(const Expression& factor, const Expression& f0) {
        const Expression e = factor.bare();
        const auto a = e.number(), b = f0.number();
        if (a && b) return std::abs(*a + *b - 1) < .02;
        return e.infix("-") && e[0].number() == 1. && e[1].same(f0);
    }

    static std::optional<Schlick> schlick(const Expression& e) {
        Schlick found;
        if (e.call("mix", 3) && e[1].number() == 1.) {
            for (const std::size_t n : {0u, 2u}) {
                found.f0 = e[n];
                if (power({e[2 - n]}, found)) return found;
            }
            return std::nullopt;
        }
        if (!e.infix("+")) return std::nullopt;
        for (const std::size_t n : {0u, 1u}) {
            found.f0 = e[n];
            std::vector<Expression> product;
            factors(e[1 - n].bare(), product);
            const auto rest = ranges::find_if(product, [&](const Expression& f) { return rest_of(f, found.f0); });
            if (rest == product.end()) continue;
            product.erase(rest);
            if (!product.empty() && power(product, found)) return found;
        }
        return std::nullopt;
    }

    // The cosine of 1 - c, as text; empty if it is none.
    std::string cosine(const Expression& of) const {
        const Expression e = of.resolved();
        const auto text = [&](const Expression& part) {
            const auto place = place_of(s_, part);
            return place ? std::string(to_.text(*place)) : std::string();
        };
        if (e.infix("-") && e[0].number() == 1.) return text(e[1]);
        if (e.infix("+") && e[0].number() == 1. && e[1].bare().calls({"dot"})) return "-" + text(e[1]);
        if (e.call("clamp", 3) || e.call("max", 2) || e.call("abs", 1))
            return cosine(e[0].number() ? e[e.size() - 1] : e[0]);
        return "";
    }

    void look(const Expression& e) {
        const auto found = schlick(e);
        const auto whole = found ? place_of(s_, e) : std::nullopt;
        if (!whole) return;
        const std::string c = cosine(found->base);
        if (c.empty()) return;
        fifth_power(*found, *whole);
        const auto f0 = place_of(s_, found->f0);
        if (!f0 || !found->f0.type().scalar() || !found->f0.type().floating()) return;
        std::string index;
        if (const auto value = found->f0.number()) {
            if (*value < 0 || *value >= 1) return;
            index = real_literal((1 + std::sqrt(*value)) / (1 - std::sqrt(*value)), 5);
        } else {
            index = fmt::format("(1. + sqrt({0})) / (1. - sqrt({0}))", to_.text(*f0));
        }
        const auto include = included(s_, "snell/fresnel.glsl");
        if (!include) return;
        Edits edits{{*whole, fmt::format("snellFresnelExact({}, 1., {})", c, index)}};
        if (adds(*include)) edits.push_back(*include);
        to_.add(ChangeKind::exact_fresnel, *whole, std::move(edits));
    }

    void fifth_power(const Schlick& found, Span whole) {
        if (found.exponent) {
            const auto place = place_of(s_, found.exponent);
            if (place && found.exponent.number() != 5.) to_.add(ChangeKind::lint_fix, whole, {{*place, "5."}});
            return;
        }
        const auto base = place_of(s_, found.base), last = place_of(s_, found.last);
        if (!base || !last || found.factors >= 5) return;
        std::string more;
        for (int n = found.factors; n < 5; ++n) more += " * " + std::string(to_.text(*base));
        to_.add(ChangeKind::lint_fix, whole, {after(*last, more)});
    }

    static bool mirrors(const Expression& e, int steps = 3) {
        bool found = false;
        for_each(e, [&](const Expression& part) {
            found = found || part.calls({"reflect", "snellReflect"});
            if (steps == 0 || found || !part.name()) return;
            if (part.initial()) found = mirrors(part.resolved(), steps - 1);
        });
        return found;
    }

    static bool is_cosine(const Expression& of) {
        const Expression e = of.resolved();
        if (e.is(Form::prefix, "-") || e.call("clamp", 3) || e.call("abs", 1)) return is_cosine(e[0]);
        if (e.call("max", 2)) return is_cosine(e[0]) || is_cosine(e[1]);
        return e.call("dot", 2);
    }

    // A power of the cosine as the share that is mirrored: it is largest where glass mirrors least.
    void exchange(const Expression& share) {
        const Expression power = share.resolved();
        if (!power.call("pow", 2) || !is_cosine(power[0])) return;
        if (const auto place = place_of(s_, power)) to_.add(ChangeKind::lint_fix, *place, {before(*place, "1. - ")});
    }

    void look_at_weights(const Expression& e) {
        if (e.call("mix", 3) && mirrors(e[1]) && !mirrors(e[0])) return exchange(e[2]);
        if (!e.infix("+")) return;
        for (const std::size_t n : {0u, 1u}) {  // mirrored * k + other * (1. - k)
            const Expression one = e[n].bare(), other = e[1 - n].bare();
            if (!one.infix("*") || !other.infix("*")) continue;
            for (const std::size_t m : {0u, 1u})
                if (one[m].name() && mirrors(one[1 - m]) && !mirrors(other) &&
                    (rest_of(other[0], one[m]) || rest_of(other[1], one[m])))
                    exchange(one[m]);
        }
    }

    const Shader& s_;
    Offers& to_;
};

}  // namespace

void add_physics(const Reading& reading, const std::vector<Span>& eye_space, Offers& to) {
    for (const Shader& shader : reading.shaders) Fresnel(shader, to).run();
    add_surroundings(reading, eye_space, to);
}

}  // namespace snell::accuracy::texts
