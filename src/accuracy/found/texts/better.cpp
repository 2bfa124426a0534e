// What the lints advise, where the text allows it to be written exactly.
#include <algorithm>
#include <map>

#include "parser/text/ranges.h"
#include "src/accuracy/found/texts/texts.h"
#include "src/glsl/read/words.h"
#include "src/lint/lint.h"
#include "src/plan/texts.h"

namespace snell::accuracy::texts {

namespace {

using glsl::Form;
using lint::Rule;

constexpr std::size_t most_better_changes = 200;
constexpr std::size_t most_uses = 4;  // that a variable that nothing reads is tried at

// Where a lint found something, and the shader around it.
struct Place {
    const Shader* shader = nullptr;
    int first = -1, last = -1;  // tokens
    Span span;
};

Edits around(Span span, std::string open, std::string close) {
    return {before(span, std::move(open)), after(span, std::move(close))};
}

class LintFixes {
public:
    // `eye_space` gets the places of directions that are in eye coordinates and should not be.
    LintFixes(const Reading& reading, Offers& to, std::vector<Span>& eye_space)
        : reading_(reading), to_(to), eye_space_(eye_space) {}

    void run() {
        const Diagnostics found = lint::check(reading_.plan, reading_.sources, shader_includes(reading_.files));
        for (const Diagnostic& d : found.items()) fix(d);
        for (const auto& [key, fixes] : fixes_) all_of(key.second, fixes);
    }

private:
    struct Fix {
        const lint::RuleFacts* rule;
        Span where;
        Edits edits;
    };

    static ChangeKind kind_of(Rule rule) {
        return rule == Rule::unnormalised_direction ? ChangeKind::unit_length
               : rule == Rule::lookup_in_branch     ? ChangeKind::derivatives_outside
                                                    : ChangeKind::lint_fix;
    }

    void fix(const Diagnostic& d) {
        const auto rules = lint::rules();
        const auto rule = ranges::find(rules, d.code, &lint::RuleFacts::code);
        const std::optional<Place> at = rule == rules.end() ? std::nullopt : tokens_at(d.span);
        if (!at) return;
        if (rule->rule == Rule::eye_space_lookup) eye_space_.push_back(at->span);
        if (rule->rule == Rule::never_read) return use(*at, *rule);
        Edits edits = edits_for(rule->rule, *at, d);
        if (edits.empty() || !to_.add(kind_of(rule->rule), at->span, edits, rule->code)) return;
        fixes_[{at->span.file, rule->rule}].push_back({&*rule, at->span, std::move(edits)});
    }

    Edits edits_for(Rule rule, const Place& at, const Diagnostic& d) const {
        switch (rule) {
            case Rule::unnormalised_direction:
                return around(at.span, "normalize(", ")");
            case Rule::index_as_ratio:
                return {before(at.span, "1. / ")};
            case Rule::eye_space_lookup:
                return to_world(at);
            case Rule::schlick_sign:
                return sign(at);
            case Rule::pow_of_negative:
                return not_negative(at);
            case Rule::dispersion_order:
                return exchanged(d);
            case Rule::lookup_in_branch:
                return with_derivatives(at);
            case Rule::far_from_origin:
                return relative_to_viewer(at);
            case Rule::smoothstep_without_width:
                return step(at);
            case Rule::viewer_not_at_origin:
                return from_viewer(at);
            default:
                return {};
        }
    }

    // All findings of one rule in one text.
    void all_of(Rule rule, const std::vector<Fix>& fixes) {
        if (fixes.size() < 2) return;
        Edits edits;
        std::vector<Span> places;
        for (const Fix& fix : fixes) {
            edits.insert(edits.end(), fix.edits.begin(), fix.edits.end());
            places.push_back(fix.where);
        }
        to_.add(kind_of(rule), places, std::move(edits), fixes.front().rule->code);
    }

    std::optional<Place> tokens_at(const Span& span) const {
        const Span wanted = to_.first_reading(span);
        for (const Shader& shader : reading_.shaders)
            for (int k = 0; k < static_cast<int>(shader.unit.tokens.size()); ++k) {
                if (shader.unit.at(k).offset != wanted.begin || shader.unit.at(k).macro >= 0) continue;
                if (to_.first_reading(shader.unit.span(k)).file != wanted.file) continue;
                int last = k;
                while (shader.unit.span(last).end < wanted.end &&
                       last + 1 < static_cast<int>(shader.unit.tokens.size()))
                    ++last;
                const auto place = shader.place(k, last);
                if (place && *place == wanted) return Place{&shader, k, last, wanted};
            }
        return std::nullopt;
    }

    Edits to_world(const Place& at) const {
        const Expression e = Expression::at(*at.shader, at.first);
        const bool simple = e.last() == at.last && (e.name() || e.call() || e.is(Form::select) || e.is(Form::group));
        Edits edits =
            around(at.span, simple ? "mat3(uViewMatrixInverse) * " : "mat3(uViewMatrixInverse) * (", simple ? "" : ")");
        if (simple) edits.pop_back();
        return declare(*at.shader, at.first, "uniform mat4 uViewMatrixInverse;", std::move(edits));
    }

    Edits declare(const Shader& shader, int token, std::string_view declaration, Edits edits) const {
        const auto edit = declared(shader, token, declaration);
        if (!edit) return {};
        if (!edit->text.empty()) edits.push_back(*edit);
        return edits;
    }

    // The sums of 1 and something that begin within these tokens, and are not within one another.
    static std::vector<Expression> sums_with_one(const Shader& shader, int first, int last) {
        std::vector<Expression> found;
        for (int k = first; k <= last; ++k) {
            const Expression e = Expression::at(shader, k);
            if (e.last() > last || !(e.infix("+") || e.infix("-"))) continue;
            if (e[0].number() != 1. && e[1].number() != 1.) continue;
            k = e.last();
            found.push_back(e);
        }
        return found;
    }

    // 1 - x for 1 + x, and for x + 1; 1 + x for 1 - x.
    static std::optional<Edits> flipped(const Shader& shader, const Expression& sum) {
        const Expression left = sum[0], right = sum[1];
        const auto all = place_of(shader, sum), first = place_of(shader, left);
        const auto sign = shader.place(left.last() + 1, left.last() + 1), rest = shader.place(left.last(), sum.last());
        if (!all || !sign || !rest || !first) return std::nullopt;
        if (left.number() == 1.) return Edits{{*sign, sum.text() == "+" ? "-" : "+"}};
        if (sum.text() == "-" || right.number() != 1.) return std::nullopt;
        return Edits{before(*all, "1. - "), {{all->file, first->end, all->end}, ""}};
    }

    Edits sign(const Place& at) const {
        const Expression power = Expression::at(*at.shader, at.first);
        const Expression base = power.call("pow", 2) ? power[0] : Expression();
        int first = base ? base.first() : at.first, last = base ? base.last() : at.last;
        if (base.bare().name()) {
            const Expression value = base.bare().initial();
            if (!value) return {};
            first = value.first(), last = value.last();
        }
        const std::vector<Expression> sums = sums_with_one(*at.shader, first, last);
        if (sums.empty() || (base && sums.size() > 1)) return {};
        Edits edits;
        // 1 minus a cosine is a little below 0, by rounding.
        const bool clamps = base && !base.resolved().calls({"clamp", "max", "abs"});
        const auto span = base ? place_of(*at.shader, base) : std::nullopt;
        if (clamps && !span) return {};
        if (clamps) edits.push_back(before(*span, "clamp("));
        for (const Expression& sum : sums) {
            const auto flip = flipped(*at.shader, sum);
            if (!flip) return {};
            edits.insert(edits.end(), flip->begin(), flip->end());
        }
        if (clamps) edits.push_back(after(*span, ", 0., 1.)"));
        return edits;
    }

    Edits not_negative(const Place& at) const {
        const Expression call = Expression::at(*at.shader, at.first - 2);
        if (!call.call("pow", 2) || call[0].first() != at.first) return {};
        const Expression base = call[0].bare();
        const auto power = call[1].number();
        const bool even = power && *power == 2. * static_cast<int>(*power / 2.);
        const bool difference = base.infix("-") && !base[0].number() && !base[1].number();
        if (even && difference) return around(at.span, "abs(", ")");
        return around(at.span, "max(", ", 0.)");
    }

    Edits exchanged(const Diagnostic& d) const {
        if (d.notes.size() != 2) return {};
        const auto red = tokens_at(d.notes[0].span), blue = tokens_at(d.notes[1].span);
        if (!red || !blue || red->shader != blue->shader) return {};
        if (red->shader->function_of(red->first) != red->shader->function_of(blue->first)) return {};
        return {{red->span, std::string(to_.text(blue->span))}, {blue->span, std::string(to_.text(red->span))}};
    }

    // vec3( matrix * vertex ) - eye and ( matrix * vertex ).xyz - eye.
    Edits relative_to_viewer(const Place& at) const {
        const Expression e = Expression::at(*at.shader, at.first);
        if (!e.infix("-") || e.last() != at.last || at.shader->unit.stage != Stage::vertex) return {};
        const Expression left = e[0].bare();
        if (!left.call("vec3", 1) && !left.is(Form::select, "xyz") && !left.is(Form::select, "rgb")) return {};
        const Expression product = left[0].bare();
        if (!product.infix("*") || !product[0].name() || !e[1].name()) return {};
        const auto vertex = place_of(*at.shader, product[1]);
        if (!vertex) return {};
        return declare(*at.shader, at.first, "uniform mat4 uModelViewerMatrix;",
                       {{at.span, "vec3(uModelViewerMatrix * " + std::string(to_.text(*vertex)) + ")"}});
    }

    static Edits step(const Place& at) {
        const Expression call = Expression::at(*at.shader, at.first);
        if (!call.call("smoothstep", 3)) return {};
        const auto name = at.shader->place(call.first(), call.first());
        const auto edges = at.shader->place(call[1].first(), call[2].first());
        const auto x = at.shader->place(call[2].first(), call[2].first());
        if (!name || !edges || !x) return {};
        return {{*name, "step"}, {{edges->file, edges->begin, x->begin}, ""}};
    }

    // The direction that was mirrored or refracted begins at the viewer.
    Edits from_viewer(const Place& at) const {
        Expression looked = Expression::at(*at.shader, at.first).resolved();
        if (looked.call("normalize", 1)) looked = looked[0].bare();
        if (!looked.calls({"reflect", "refract"})) return {};
        Expression incident = looked[0].resolved();
        if (incident.call("normalize", 1)) incident = incident[0];
        const auto span = place_of(*at.shader, incident);
        if (!span || incident.bare().is(Form::prefix)) return {};
        return declare(*at.shader, incident.first(), "uniform vec3 uViewerPositionEye;",
                       {after(*span, " - uViewerPositionEye")});
    }

    // What is computed and not read is used where another value of its kind is.
    void use(const Place& at, const lint::RuleFacts& rule) {
        const Shader& s = *at.shader;
        const auto declares = [&](const glsl::Node& n) { return n.form == Form::declarator && n.first == at.first; };
        const auto made = ranges::find_if(s.tree, declares);
        if (made == s.tree.end()) return;
        std::vector<std::string_view> read;
        for (int k = made->first + 1; k <= made->last; ++k)
            if (s.token(k).kind == glsl::Kind::identifier) read.push_back(s.token(k).text);
        std::size_t left = most_uses;
        for (const int n : s.expressions()) {
            const Expression e(s, n);
            if (e.first() <= made->last || s.function_of(e.first()) != s.function_of(made->first)) continue;
            const Expression instead = in_its_place(e, made->type);
            if (left == 0 || ranges::find(read, instead.text()) == read.end()) continue;
            const auto place = place_of(s, instead), whole = place_of(s, e);
            if (place && whole && to_.add(ChangeKind::lint_fix, *whole, {{*place, std::string(made->text)}}, rule.code))
                --left;
        }
    }

    // The argument that a number or a direction may be meant for: the share of a mix, or where a texture is looked up.
    static Expression in_its_place(const Expression& e, const glsl::Type& type) {
        const bool share = type.base == glsl::Base::real && type.scalar() && e.call("mix", 3);
        const bool lookup = real_vector(type) && (type.rows == 2 || type.rows == 3) &&
                            e.calls({"texture", "textureCube", "texture2D", "texture3D", "textureLod"});
        const Expression argument = share ? e[2] : lookup ? e[1] : Expression();
        return argument.name() ? argument : Expression();
    }

    // Before the branch the derivatives are defined.
    Edits with_derivatives(const Place& at) const {
        const Shader& s = *at.shader;
        const Expression call = Expression::at(s, at.first);
        if (!call.calls({"texture", "texture2D", "textureCube", "texture3D"}) || call.size() != 2) return {};
        const std::string_view sampler = call[0].type().name, type = sampler == "sampler2D" ? "vec2" : "vec3";
        const auto name = s.place(call.first(), call.first()), coordinate = place_of(s, call[1]);
        if (sampler != "sampler2D" && sampler != "samplerCube" && sampler != "sampler3D") return {};
        if (!name || !coordinate || s.main() < 0 || s.function_of(at.first) != s.main()) return {};
        const auto token = defined_from(s, call[1]);
        const auto start = token ? s.place(*token, *token) : std::nullopt;
        if (!start) return {};
        const std::string number = std::to_string(reading_.sources.position(at.span.file, at.span.begin).line);
        const std::string dx = "snellDx" + number, dy = "snellDy" + number, of(to_.text(*coordinate));
        const std::string line = std::string(type) + " " + dx + " = dFdx(" + of + "), " + dy + " = dFdy(" + of + ");";
        return {after(*start, " " + line), {*name, "textureGrad"}, after(*coordinate, ", " + dx + ", " + dy)};
    }

    // The token behind which everything in the coordinate has its value, outside of all branches; nothing if
    // there is none before the first branch. The coordinate is in main.
    static std::optional<int> defined_from(const Shader& s, const Expression& coordinate) {
        const glsl::Function& main = s.function(s.main());
        int from = main.open, branch = coordinate.first();
        std::vector<int> writes;  // nodes of main
        for (int n = 0; n < s.nodes(); ++n) {
            const glsl::Node& node = s.at(n);
            if (s.function_of(node.first) != s.main()) continue;
            if (node.form == Form::branch || node.form == Form::choice || node.form == Form::loop)
                branch = std::min(branch, node.first);
            if (node.form == Form::declarator || (node.form == Form::name && s.written(n))) writes.push_back(n);
        }
        bool known = true;
        for_each(coordinate, [&](const Expression& part) {
            if (part.is(Form::assign) || part.is(Form::step)) known = false;
            for (const int write : writes) {
                if (!part.name() || s.at(write).text != part.text()) continue;
                const int statement = s.statement(write);
                if (s.at(statement).last > branch || s.parent(statement) != main.block) known = false;
                from = std::max(from, s.at(statement).last);
            }
        });
        return known ? std::optional(from) : std::nullopt;
    }

    const Reading& reading_;
    Offers& to_;
    std::vector<Span>& eye_space_;
    std::map<std::pair<FileId, Rule>, std::vector<Fix>> fixes_;
};

}  // namespace

}  // namespace snell::accuracy::texts

namespace snell::accuracy {

void add_better_changes(const Reading& reading, std::vector<Change>& changes) {
    Offers to(reading.files, reading.sources, changes, texts::most_better_changes);
    std::vector<Span> eye_space;
    texts::LintFixes(reading, to, eye_space).run();
    texts::add_physics(reading, eye_space, to);
}

}  // namespace snell::accuracy
