// Lints of the calls that compute light: reflect, refract, pow, lookups.
#include <fmt/format.h>

#include <algorithm>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/read/words.h"
#include "src/lint/walker.h"

namespace snell::lint {

using glsl::Kind;

namespace {

// A dot product of unit vectors exceeds 1 by roundings of float.
constexpr double rounding = 4e-7;

// A unit vector such as a normal. The direction to a position is none here: from the eye, all that is seen lies ahead.
bool turns(const Value& v) { return v.length == Length::unit && v.space > Space::any && !v.point; }

// Constant, and the largest of its components is known.
bool fixed_axis(const Value& v) {
    return v.space == Space::any && v.plain && v.type.rows >= 2 && v.range.real_lo && v.range.real_hi &&
           v.range != exactly(0);
}

bool names_index(std::string_view name) {
    const std::string n = lowered(name);
    return n.find("eta") != std::string::npos || n.find("ior") != std::string::npos ||
           n.find("index") != std::string::npos || n.find("refrac") != std::string::npos;
}

std::string_view space_words(Why why) {
    switch (why) {
        case Why::interpolated:
            return "is interpolated, so it has not unit length";
        case Why::position:
            return "goes from point to point, so it has not unit length";
        default:
            return "is a sum, so it has not unit length";
    }
}

}  // namespace

void Walker::report(Rule rule, int first, int last, std::string message, std::vector<Note> notes) {
    report_(rule, first, last, std::move(message), std::move(notes));
}

std::string Walker::words(int first, int last) const {
    std::string out;
    for (int k = first; k <= last && k >= 0; ++k) {
        const glsl::Token& t = u_.at(k);
        if (k > first && !t.lead.empty()) out += ' ';
        out += t.text;
    }
    return out.size() > 40 ? out.substr(0, 37) + "…" : out;
}

Span Walker::span(int first, int last) const {
    Span span = u_.span(first);
    const Span end = u_.span(last);
    if (end.file == span.file && end.end > span.end) span.end = end.end;
    return span;
}

void Walker::want_unit(const Expr& e, std::string_view function, std::string_view role) {
    if (e.v.length != Length::other || e.first < 0) return;
    std::string what = "'" + words(e.first, e.last) + "'";
    if (!e.v.name.empty() && what != "'" + std::string(e.v.name) + "'" && e.v.why == Why::interpolated)
        what += fmt::format(", which is '{}',", e.v.name);
    report(Rule::unnormalised_direction, e.first, e.last,
           fmt::format("{} {}: {}() wants a {} of length 1", what, space_words(e.v.why), function, role));
}

Value Walker::call_reflect(const std::vector<Expr>& given) {
    want_unit(given[1], "reflect", "normal");
    const Value &i = given[0].v, &n = given[1].v;
    Value v;
    v.space = i.space == n.space || n.space == Space::any ? i.space : Space::unknown;
    if (i.length == Length::unit && n.length == Length::unit) v.length = Length::unit;
    v.mirrored = i.id;
    v.mirrored_opposite = i.opposite;
    v.from_eye = i.space == Space::eye && i.point;
    v.name = i.name;
    return v;
}

Value Walker::call_refract(const std::vector<Expr>& given) {
    want_unit(given[0], "refract", "direction");
    want_unit(given[1], "refract", "normal");
    want_ratio(given);
    const Value &i = given[0].v, &n = given[1].v, &eta = given[2].v;
    Value v;
    v.space = i.space == n.space || n.space == Space::any ? i.space : Space::unknown;
    v.refracted = true;
    v.from_eye = i.space == Space::eye && i.point;
    v.name = i.name;
    if (i.id) incident_[i.id] = 1;
    if (i.opposite) incident_[i.opposite] = -1;
    if (!i.refracted) {
        v.bend = eta.eta.base ? eta.eta : Bend{eta.id, 0};
        v.bend.first = given[2].first;
        v.bend.last = given[2].last;
    }
    return v;
}

// An index, where n1/n2 is due, for light that has not been refracted yet.
void Walker::want_ratio(const std::vector<Expr>& given) {
    const Expr& e = given[2];
    if (given[0].v.refracted || !spatial(given[0].v) || e.first != e.last || e.first < 0) return;
    const std::string_view name = u_.at(e.first).text;
    if (u_.at(e.first).kind != Kind::identifier || nonuniform_ > 0) return;
    const Surroundings::Uniform* at = nullptr;
    std::string_view called = name;
    std::optional<double> value;
    if (e.v.range.lo == e.v.range.hi && e.v.range.real_lo) value = e.v.range.lo;
    if (e.v.uniform >= 0) {
        called = u_.globals[static_cast<std::size_t>(e.v.uniform)].name;
        if (const auto found = around_.uniforms.find(called); found != around_.uniforms.end()) {
            at = &found->second;
            value = at->current;
        }
    }
    if (!value || *value <= 1 || (!names_index(name) && !names_index(called))) return;
    // An author who divides by the name elsewhere knows the difference.
    for (std::size_t k = 1; k < u_.tokens.size(); ++k) {
        if (u_.tokens[k].text != "/") continue;
        for (std::size_t j = k + 1; j < std::min(k + 4, u_.tokens.size()); ++j)
            if (u_.tokens[j].text == name || u_.tokens[j].text == called) return;
    }
    report(Rule::index_as_ratio, e.first, e.last,
           fmt::format("'{}' is {}: as n1/n2 that is light that leaves something denser, not light that enters it",
                       called, *value),
           at ? std::vector<Note>{{at->span, "its value"}} : std::vector<Note>{});
}

Value Walker::call_dot(const std::vector<Expr>& given) {
    const Value &a = given[0].v, &b = given[1].v;
    Value v;
    if (a.id && a.id == b.id) {
        v.range.lo = 0;
    } else if ((turns(a) && fixed_axis(b)) || (turns(b) && fixed_axis(a))) {
        const Range& axis = (turns(a) ? b : a).range;
        const double end = std::max(std::abs(axis.lo), std::abs(axis.hi)) * (1 + rounding);
        v.range = between(-end, end);
    } else if (spatial(a) && spatial(b)) {
        const double end = 1 + rounding;
        v.range = a.length == Length::unit && b.length == Length::unit ? between(-end, end) : Range{};
        v.range.real_lo = v.range.real_hi = true;
    }
    const int sign = (a.opposite ? -1 : 1) * (b.opposite ? -1 : 1);
    v.cosine = {a.opposite ? a.opposite : a.id, b.opposite ? b.opposite : b.id, sign};
    return v;
}

// Whether a condition around, or behind which some path ended, is about one of the variables.
bool Walker::compared(int first, int last) const {
    for (int k = first; k <= last; ++k)
        if (u_.at(k).kind == Kind::identifier && conditions_.contains(u_.at(k).text) && u_.at(k - 1).text != "." &&
            u_.at(k + 1).text != "(")
            return true;
    return false;
}

void Walker::call_pow(const std::vector<Expr>& given, int first, int last) {
    const Expr& base = given[0];
    if (base.v.one_plus.sign != 0) schlicks_.push_back({first, last, base.v.one_plus});
    const bool even = given[1].v.range.real_lo && given[1].v.range.lo == given[1].v.range.hi;
    const Difference& difference = base.v.difference;
    const bool squared_difference = difference.first >= 0 && !base.v.range.real_lo && base.v.range.lo < 0 && even;
    if (!(base.v.range.lo < 0 && base.v.range.real_lo) && !squared_difference) return;
    if (compared(base.first, base.last) || conditions_.contains(base.v.name) ||
        (squared_difference && compared(difference.first, difference.last)))
        return;
    const bool by_rounding = base.v.range.lo > -1e-5;
    report(Rule::pow_of_negative, base.first, base.last,
           fmt::format("'{}' can be {}: pow() is undefined there", words(base.first, base.last),
                       by_rounding ? "a little below 0, by rounding" : "negative"));
}

// A power by multiplication: (1 + c) * (1 + c).
void Walker::note_factor(Expr& left, const Expr& right) {
    const Cosine& factor = right.v.one_plus;
    if (left.v.one_plus.sign != 0) left.factor = left.v.one_plus, left.factor_first = left.first;
    if (factor.sign != 0 && factor == left.factor) {
        if (!schlicks_.empty() && schlicks_.back().first == left.factor_first)
            schlicks_.back().last = right.last;
        else
            schlicks_.push_back({left.factor_first, right.last, factor});
    }
    if (factor.sign == 0 || factor != left.factor) left.factor_first = right.first;
    left.factor = factor;
}

void Walker::want_width(const std::vector<Expr>& given, int first, int last) {
    const Range &a = given[0].v.range, &b = given[1].v.range;
    if (a.lo != a.hi || !a.real_lo || a != b) return;
    report(Rule::smoothstep_without_width, first, last, fmt::format("both edges of this smoothstep() are {}", a.lo));
}

// Positions far from the origin have few digits left for what is between them.
void Walker::want_near(const Expr& left, const Expr& right) {
    constexpr double visible = .05;
    const auto position = [](const Value& v) { return v.space == Space::world && v.point && v.type.rows >= 3; };
    if (around_.far_turn < visible || !position(left.v) || !position(right.v)) return;
    report(Rule::far_from_origin, left.first, right.last,
           fmt::format("the eye is far from the origin: rounding turns this direction by up to {:.2g} degrees",
                       around_.far_turn));
}

Value Walker::call_texture(std::string_view name, const std::vector<Expr>& given, int first, int last) {
    Value v;
    if (given.size() < 2) return v;
    const Value &sampler = given[0].v, &at = given[1].v;
    const std::string_view kind = sampler.type.name;
    v.bend = at.bend;
    v.varies = at.varies == Varies::yes ? Varies::yes : Varies::unknown;
    if (kind.find("Cube") != std::string_view::npos) {
        if (at.mirrored) incident_[at.mirrored] = 1;
        if (at.mirrored_opposite) incident_[at.mirrored_opposite] = -1;
        const bool turned = around_.eye_turn > .5 || around_.cube_faces;
        if (at.space == Space::eye && turned)
            report(
                Rule::eye_space_lookup, given[1].first, given[1].last,
                around_.cube_faces
                    ? std::string("this direction is in eye coordinates, but RenderToCube turns the eye to six sides")
                    : fmt::format("this direction is in eye coordinates, but LookAt turns the eye by {:.0f} degrees",
                                  around_.eye_turn));
        else if (at.space == Space::eye && at.from_eye)
            report(Rule::viewer_not_at_origin, given[1].first, given[1].last,
                   "this is what an eye at the origin of eye coordinates sees: dragging in the window moves the viewer "
                   "away from there");
    }
    const bool implicit =
        name == "texture" || name == "textureProj" || name == "textureOffset" || name == "textureProjOffset";
    if (implicit && u_.stage == Stage::fragment && nonuniform_ > 0 && given[0].slot >= 0 && sampler.uniform >= 0 &&
        around_.mipmapped.contains(u_.globals[static_cast<std::size_t>(sampler.uniform)].name))
        report(Rule::lookup_in_branch, first, last,
               fmt::format("only some fragments get here, so the level of '{}' is undefined",
                           u_.globals[static_cast<std::size_t>(sampler.uniform)].name));
    return v;
}

void Walker::note_channel(const Value& v, std::string_view channel, int token) {
    constexpr std::string_view letters = "rgbxyz";
    if (!v.bend.base || v.refracted || channel.size() != 1 || letters.find(channel[0]) == std::string_view::npos)
        return;
    channels_[v.bend.base].insert_or_assign(
        "rgb" [letters.find(channel[0]) % 3], Channel { v.bend, token });
}

bool Walker::of_interest(int first, int last) const {
    constexpr std::string_view functions[] = {"pow", "mix", "reflect", "refract"};
    for (int k = first; k < last; ++k)
        if (u_.at(k + 1).text == "(" &&
            std::find(std::begin(functions), std::end(functions), u_.at(k).text) != std::end(functions))
            return true;
    return false;
}

// These lints need all of main.
void Walker::finish() {
    for (const Schlick& s : schlicks_)
        for (const int vector : {s.cosine.first, s.cosine.second}) {
            const auto found = incident_.find(vector);
            if (found == incident_.end() || found->second * s.cosine.sign > 0) continue;
            report(Rule::schlick_sign, s.first, s.last,
                   "this grows where the surface is seen straight on: 1 plus the cosine of the angle of incidence");
        }
    for (const auto& [base, channels] : channels_) {
        const auto red = channels.find('r'), blue = channels.find('b');
        if (red == channels.end() || blue == channels.end()) continue;
        if (blue->second.bend.shift <= red->second.bend.shift) continue;
        std::vector<Note> notes;
        for (const auto& [channel, name] : {std::pair(red, "red's n1/n2"), std::pair(blue, "blue's n1/n2")})
            if (const Bend& bend = channel->second.bend; bend.first >= 0)
                notes.push_back({span(bend.first, bend.last), name});
        report(Rule::dispersion_order, blue->second.token, blue->second.token,
               fmt::format("blue's n1/n2 is larger than red's by {:.3g}: blue is bent least",
                           blue->second.bend.shift - red->second.bend.shift),
               std::move(notes));
    }
    // With conditionals, another rung or macro may read the variable.
    if (u_.has_conditionals) return;
    for (const auto& [name, made] : made_) {
        const std::string_view text = u_.at(name).text;
        if (ranges::count(u_.tokens, text, &glsl::Token::text) == 1)
            report(Rule::never_read, name, name,
                   fmt::format("nothing reads '{}', made of '{}'", text, words(made.first, made.last)));
    }
}

}  // namespace snell::lint
