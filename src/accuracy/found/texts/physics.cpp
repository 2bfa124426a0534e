#include "src/accuracy/found/texts/physics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell::accuracy::texts {

namespace {

using Kind = Tree::Kind;

// f0 + (1 - f0) (1 - c)^power
struct Schlick {
    const Tree* f0 = nullptr;
    const Tree* base = nullptr;      // 1 - c
    const Tree* exponent = nullptr;  // null: a product
    const Tree* last = nullptr;      // of the product's factors
    int factors = 0;
};

class Fresnel {
public:
    Fresnel(const Shader& shader, Collector& to) : s_(shader), u_(shader.unit), to_(to) {}

    void run() {
        for (const Body& body : s_.bodies)
            for (const Piece& piece : body.pieces)
                for_each(piece.value, [&](const Tree& tree) {
                    look(tree);
                    look_at_weights(tree);
                });
    }

private:
    static void factors(const Tree& tree, std::vector<const Tree*>& all) {
        if (!tree.infix("*")) return all.push_back(&tree);
        factors(tree.parts[0], all);
        factors(tree.parts[1], all);
    }

    bool power(std::vector<const Tree*> of, Schlick& found) const {
        if (of.size() == 1) {
            const Tree& whole = resolved(s_, *of[0]);
            if (whole.call("pow", 2)) return found.base = &whole.parts[0], found.exponent = &whole.parts[1], true;
            if (!whole.infix("*")) return false;
            of.clear();
            factors(whole, of);
        }
        if (of.size() < 2 || ranges::any_of(of, [&](const Tree* f) { return !same(u_, *f, *of[0]); })) return false;
        found.base = of[0];
        found.last = of.back();
        found.factors = static_cast<int>(of.size());
        return true;
    }

    bool rest_of(const Tree& factor, const Tree& f0) const {
        const Tree& t = bare(factor);
        const auto a = number_of(t), b = number_of(f0);
        if (a && b) return std::abs(*a + *b - 1) < .02;
        return t.infix("-") && number_of(t.parts[0]) == 1. && same(u_, t.parts[1], f0);
    }

    std::optional<Schlick> schlick(const Tree& tree) const {
        Schlick found;
        if (tree.call("mix", 3) && number_of(tree.parts[1]) == 1.) {
            for (const int n : {0, 2}) {
                found.f0 = &tree.parts[static_cast<std::size_t>(n)];
                if (power({&tree.parts[static_cast<std::size_t>(2 - n)]}, found)) return found;
            }
            return std::nullopt;
        }
        if (!tree.infix("+")) return std::nullopt;
        for (const std::size_t n : {0u, 1u}) {
            found.f0 = &tree.parts[n];
            std::vector<const Tree*> product;
            factors(bare(tree.parts[1 - n]), product);
            const auto rest = ranges::find_if(product, [&](const Tree* f) { return rest_of(*f, *found.f0); });
            if (rest == product.end()) continue;
            product.erase(rest);
            if (!product.empty() && power(product, found)) return found;
        }
        return std::nullopt;
    }

    // The cosine of 1 - c, as text; empty if it is none.
    std::string cosine(const Tree& tree) const {
        const Tree& t = resolved(s_, tree);
        const auto text = [&](const Tree& part) {
            const auto place = span_of(u_, to_, part);
            return place ? std::string(to_.text(*place)) : std::string();
        };
        if (t.infix("-") && number_of(t.parts[0]) == 1.) return text(t.parts[1]);
        if (t.infix("+") && number_of(t.parts[0]) == 1. && bare(t.parts[1]).is(Kind::call, "dot"))
            return "-" + text(t.parts[1]);
        if (t.call("clamp", 3) || t.call("max", 2) || t.call("abs", 1))
            return cosine(number_of(t.parts[0]) ? t.parts.back() : t.parts[0]);
        return "";
    }

    bool scalar(const Tree& tree) const {
        const Tree& t = bare(tree);
        if (t.kind == Kind::number) return true;
        if (t.kind == Kind::select) return t.text.size() == 1;
        if (t.kind == Kind::infix || t.kind == Kind::prefix)
            return ranges::all_of(t.parts, [&](const Tree& p) { return scalar(p); });
        if (t.kind == Kind::call) {
            for (const glsl::Function& f : u_.functions)
                if (f.name == t.text) return f.result.floating() && f.result.scalar();
            return t.text == "dot" || t.text == "length" || (t.text == "pow" && !t.parts.empty() && scalar(t.parts[0]));
        }
        if (t.kind != Kind::name) return false;
        if (const Body* body = body_around(s_, t.first)) {
            for (const Piece& piece : body->pieces)
                if (piece.name == t.text && piece.kind == Piece::Kind::declaration) return piece.type == "float";
            for (int k = body->function->name_token; k < body->function->parameters_end; ++k)
                if (u_.at(k).text == t.text) return u_.at(k - 1).text == "float";
        }
        return ranges::any_of(u_.globals, [&](const glsl::Global& g) {
            return g.name == t.text && g.type.floating() && g.type.scalar();
        });
    }

    void look(const Tree& tree) {
        const auto found = schlick(tree);
        const auto whole = found ? span_of(u_, to_, tree) : std::nullopt;
        if (!whole) return;
        const std::string c = cosine(*found->base);
        if (c.empty()) return;
        fifth_power(*found, *whole);
        const auto f0 = span_of(u_, to_, *found->f0);
        if (!f0 || !scalar(*found->f0)) return;
        std::string index;
        if (const auto value = number_of(*found->f0)) {
            if (*value < 0 || *value >= 1) return;
            index = numeral((1 + std::sqrt(*value)) / (1 - std::sqrt(*value)), false);
        } else {
            index = fmt::format("(1. + sqrt({0})) / (1. - sqrt({0}))", to_.text(*f0));
        }
        const auto include = included(s_, to_, "snell/fresnel.glsl");
        if (!include) return;
        Edits edits{{*whole, fmt::format("snellFresnelExact({}, 1., {})", c, index)}};
        if (adds(*include)) edits.push_back(*include);
        to_.add(ChangeKind::exact_fresnel, *whole, std::move(edits));
    }

    void fifth_power(const Schlick& found, Span whole) {
        if (found.exponent) {
            const auto place = span_of(u_, to_, *found.exponent);
            if (place && number_of(*found.exponent) != 5.) to_.add(ChangeKind::lint_fix, whole, {{*place, "5."}});
            return;
        }
        const auto base = span_of(u_, to_, *found.base), last = span_of(u_, to_, *found.last);
        if (!base || !last || found.factors >= 5) return;
        std::string more;
        for (int n = found.factors; n < 5; ++n) more += " * " + std::string(to_.text(*base));
        to_.add(ChangeKind::lint_fix, whole, {after(*last, more)});
    }

    bool mirrors(const Tree& tree, int steps = 3) const {
        bool found = false;
        for_each(tree, [&](const Tree& part) {
            found = found || part.is(Kind::call, "reflect") || part.is(Kind::call, "snellReflect");
            if (steps == 0 || found || part.kind != Kind::name) return;
            const Tree& value = resolved(s_, part);
            if (&value != &part) found = mirrors(value, steps - 1);
        });
        return found;
    }

    bool is_cosine(const Tree& tree) const {
        const Tree& t = resolved(s_, tree);
        if (t.is(Kind::prefix, "-") || t.call("clamp", 3) || t.call("abs", 1)) return is_cosine(t.parts[0]);
        if (t.call("max", 2)) return is_cosine(t.parts[0]) || is_cosine(t.parts[1]);
        return t.call("dot", 2);
    }

    // A power of the cosine as the share that is mirrored: it is largest where glass mirrors least.
    void exchange(const Tree& share) {
        const Tree& power = resolved(s_, share);
        if (!power.call("pow", 2) || !is_cosine(power.parts[0])) return;
        if (const auto place = span_of(u_, to_, power))
            to_.add(ChangeKind::lint_fix, *place, {before(*place, "1. - ")});
    }

    void look_at_weights(const Tree& tree) {
        if (tree.call("mix", 3) && mirrors(tree.parts[1]) && !mirrors(tree.parts[0])) return exchange(tree.parts[2]);
        if (!tree.infix("+")) return;
        for (const std::size_t n : {0u, 1u}) {  // mirrored * k + other * (1. - k)
            const Tree &one = bare(tree.parts[n]), &other = bare(tree.parts[1 - n]);
            if (!one.infix("*") || !other.infix("*")) continue;
            for (const std::size_t m : {0u, 1u})
                if (one.parts[m].kind == Kind::name && mirrors(one.parts[1 - m]) && !mirrors(other) &&
                    (rest_of(other.parts[0], one.parts[m]) || rest_of(other.parts[1], one.parts[m])))
                    exchange(one.parts[m]);
        }
    }

    const Shader& s_;
    const glsl::Unit& u_;
    Collector& to_;
};

}  // namespace

void add_physics(const Plan& plan, const Shaders& shaders, const std::vector<Span>& eye_space, Collector& to) {
    for (const Shader& shader : shaders) Fresnel(shader, to).run();
    add_surroundings(plan.scene, shaders, eye_space, to);
}

}  // namespace snell::accuracy::texts
