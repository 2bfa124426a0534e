// What the lints advise, where the text allows it to be written exactly.
#include <algorithm>
#include <map>

#include "parser/text/ranges.h"
#include "src/accuracy/found/texts/physics.h"
#include "src/accuracy/found/texts/texts.h"
#include "src/glsl/read/words.h"
#include "src/lint/lint.h"
#include "src/plan/texts.h"

namespace snell::accuracy::texts {

namespace {

using lint::Rule;
using Kind = Tree::Kind;

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
    LintFixes(const Plan& plan, Sources& sources, const Shaders& shaders, Collector& to, std::vector<Span>& eye_space)
        : plan_(plan), sources_(sources), shaders_(shaders), to_(to), eye_space_(eye_space) {}

    void run(Files& files) {
        const Diagnostics found = lint::check(plan_, sources_, shader_includes(files));
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
        std::vector<Span> more;
        for (const Fix& fix : fixes) {
            edits.insert(edits.end(), fix.edits.begin(), fix.edits.end());
            if (&fix != &fixes.front()) more.push_back(fix.where);
        }
        to_.add(kind_of(rule), fixes.front().where, std::move(edits), fixes.front().rule->code, more);
    }

    std::optional<Place> tokens_at(const Span& span) const {
        const Span wanted = to_.first_reading(span);
        for (const Shader& shader : shaders_)
            for (int k = 0; k < static_cast<int>(shader.unit.tokens.size()); ++k) {
                if (shader.unit.at(k).offset != wanted.begin || shader.unit.at(k).macro >= 0) continue;
                if (to_.first_reading(shader.unit.span(k)).file != wanted.file) continue;
                int last = k;
                while (shader.unit.span(last).end < wanted.end &&
                       last + 1 < static_cast<int>(shader.unit.tokens.size()))
                    ++last;
                const auto place = span_of(shader.unit, to_, k, last);
                if (place && *place == wanted) return Place{&shader, k, last, wanted};
            }
        return std::nullopt;
    }

    Edits to_world(const Place& at) const {
        const Tree tree = expression(at.shader->unit, at.first);
        const bool simple = tree.last == at.last && (tree.kind == Kind::name || tree.kind == Kind::call ||
                                                     tree.kind == Kind::select || tree.kind == Kind::group);
        Edits edits =
            around(at.span, simple ? "mat3(uViewMatrixInverse) * " : "mat3(uViewMatrixInverse) * (", simple ? "" : ")");
        if (simple) edits.pop_back();
        return declare(*at.shader, at.first, "uniform mat4 uViewMatrixInverse;", std::move(edits));
    }

    Edits declare(const Shader& shader, int token, std::string_view declaration, Edits edits) const {
        const auto edit = declared(shader, to_, token, declaration);
        if (!edit) return {};
        if (!edit->text.empty()) edits.push_back(*edit);
        return edits;
    }

    // The sums of 1 and something that begin within these tokens, and are not within one another.
    static std::vector<Tree> sums_with_one(const glsl::Unit& unit, int first, int last) {
        std::vector<Tree> found;
        for (int k = first; k <= last; ++k) {
            Tree tree = expression(unit, k);
            if (tree.last > last || !(tree.infix("+") || tree.infix("-"))) continue;
            if (number_of(tree.parts[0]) != 1. && number_of(tree.parts[1]) != 1.) continue;
            k = tree.last;
            found.push_back(std::move(tree));
        }
        return found;
    }

    // 1 - x for 1 + x, and for x + 1; 1 + x for 1 - x.
    std::optional<Edits> flipped(const glsl::Unit& unit, const Tree& sum) const {
        const Tree &left = sum.parts[0], &right = sum.parts[1];
        const auto all = span_of(unit, to_, sum.first, sum.last);
        const auto sign = span_of(unit, to_, left.last + 1, left.last + 1);
        const auto rest = span_of(unit, to_, left.last, sum.last);
        const auto first = span_of(unit, to_, left.first, left.last);
        if (!all || !sign || !rest || !first) return std::nullopt;
        if (number_of(left) == 1.) return Edits{{*sign, sum.text == "+" ? "-" : "+"}};
        if (sum.text == "-" || number_of(right) != 1.) return std::nullopt;
        return Edits{before(*all, "1. - "), {{all->file, first->end, all->end}, ""}};
    }

    Edits sign(const Place& at) const {
        const glsl::Unit& unit = at.shader->unit;
        const Tree power = expression(unit, at.first);
        const Tree* base = power.call("pow", 2) ? &power.parts[0] : nullptr;
        int first = base ? base->first : at.first, last = base ? base->last : at.last;
        if (base && bare(*base).kind == Kind::name) {
            const Piece* variable = declaration_of(*at.shader, bare(*base));
            if (!variable) return {};
            first = variable->value.first, last = variable->value.last;
        }
        const std::vector<Tree> sums = sums_with_one(unit, first, last);
        if (sums.empty() || (base && sums.size() > 1)) return {};
        Edits edits;
        // 1 minus a cosine is a little below 0, by rounding.
        const bool clamps = base && !resolved(*at.shader, *base).calls({"clamp", "max", "abs"});
        const auto span = base ? span_of(unit, to_, *base) : std::nullopt;
        if (clamps && !span) return {};
        if (clamps) edits.push_back(before(*span, "clamp("));
        for (const Tree& sum : sums) {
            const auto flip = flipped(unit, sum);
            if (!flip) return {};
            edits.insert(edits.end(), flip->begin(), flip->end());
        }
        if (clamps) edits.push_back(after(*span, ", 0., 1.)"));
        return edits;
    }

    Edits not_negative(const Place& at) const {
        const Tree call = expression(at.shader->unit, at.first - 2);
        if (!call.call("pow", 2) || call.parts[0].first != at.first) return {};
        const Tree& base = bare(call.parts[0]);
        const auto power = number_of(call.parts[1]);
        const bool even = power && *power == 2. * static_cast<int>(*power / 2.);
        const bool difference = base.infix("-") && !number_of(base.parts[0]) && !number_of(base.parts[1]);
        if (even && difference) return around(at.span, "abs(", ")");
        return around(at.span, "max(", ", 0.)");
    }

    Edits exchanged(const Diagnostic& d) const {
        if (d.notes.size() != 2) return {};
        const auto red = tokens_at(d.notes[0].span), blue = tokens_at(d.notes[1].span);
        if (!red || !blue || red->shader != blue->shader) return {};
        const auto function_of = [&](int token) {
            return ranges::find_if(red->shader->unit.functions,
                                   [&](const glsl::Function& f) { return f.open < token && token < f.close; });
        };
        if (function_of(red->first) != function_of(blue->first)) return {};
        return {{red->span, std::string(to_.text(blue->span))}, {blue->span, std::string(to_.text(red->span))}};
    }

    // vec3( matrix * vertex ) - eye and ( matrix * vertex ).xyz - eye.
    Edits relative_to_viewer(const Place& at) const {
        const glsl::Unit& unit = at.shader->unit;
        const Tree tree = expression(unit, at.first);
        if (!tree.infix("-") || tree.last != at.last || unit.stage != Stage::vertex) return {};
        const Tree& left = bare(tree.parts[0]);
        const bool selected = left.kind == Kind::select && (left.text == "xyz" || left.text == "rgb");
        if (!left.call("vec3", 1) && !selected) return {};
        const Tree& product = bare(left.parts[0]);
        if (!product.infix("*") || product.parts[0].kind != Kind::name || tree.parts[1].kind != Kind::name) return {};
        const auto vertex = span_of(unit, to_, product.parts[1].first, product.parts[1].last);
        if (!vertex) return {};
        return declare(*at.shader, at.first, "uniform mat4 uModelViewerMatrix;",
                       {{at.span, "vec3(uModelViewerMatrix * " + std::string(to_.text(*vertex)) + ")"}});
    }

    Edits step(const Place& at) const {
        const glsl::Unit& unit = at.shader->unit;
        const Tree call = expression(unit, at.first);
        if (!call.call("smoothstep", 3)) return {};
        const auto name = span_of(unit, to_, call.first, call.first);
        const auto edges = span_of(unit, to_, call.parts[1].first, call.parts[2].first);
        const auto x = span_of(unit, to_, call.parts[2].first, call.parts[2].first);
        if (!name || !edges || !x) return {};
        return {{*name, "step"}, {{edges->file, edges->begin, x->begin}, ""}};
    }

    // The direction that was mirrored or refracted begins at the viewer.
    Edits from_viewer(const Place& at) const {
        const glsl::Unit& unit = at.shader->unit;
        const Tree given = expression(unit, at.first);
        const Tree* looked = &resolved(*at.shader, given);
        if (looked->calls({"normalize"}) && looked->parts.size() == 1) looked = &bare(looked->parts[0]);
        if (!looked->calls({"reflect", "refract"}) || looked->parts.empty()) return {};
        const Tree* incident = &resolved(*at.shader, looked->parts[0]);
        if (incident->calls({"normalize"}) && incident->parts.size() == 1) incident = &incident->parts[0];
        if (bare(*incident).is(Kind::prefix)) return {};
        const auto span = span_of(unit, to_, *incident);
        if (!span) return {};
        return declare(*at.shader, incident->first, "uniform vec3 uViewerPositionEye;",
                       {after(*span, " - uViewerPositionEye")});
    }

    // What is computed and not read is used where another value of its kind is.
    void use(const Place& at, const lint::RuleFacts& rule) {
        const glsl::Unit& unit = at.shader->unit;
        const std::string_view name = unit.at(at.first).text;
        for (const Body& body : at.shader->bodies) {
            const auto made = ranges::find_if(body.pieces, [&](const Piece& p) { return p.name_token == at.first; });
            if (made == body.pieces.end()) continue;
            std::vector<std::string_view> read;
            for (int k = made->value.first; k >= 0 && k <= made->value.last; ++k)
                if (unit.at(k).kind == glsl::Kind::identifier) read.push_back(unit.at(k).text);
            std::size_t left = most_uses;
            for (auto later = made + 1; later != body.pieces.end(); ++later)
                for_each(later->value, [&](const Tree& tree) {
                    const Tree* instead = in_its_place(tree, made->type);
                    if (!instead || left == 0 || ranges::find(read, instead->text) == read.end()) return;
                    const auto place = span_of(unit, to_, instead->first, instead->last);
                    const auto whole = span_of(unit, to_, tree.first, tree.last);
                    if (place && whole &&
                        to_.add(ChangeKind::lint_fix, *whole, {{*place, std::string(name)}}, rule.code))
                        --left;
                });
        }
    }

    // The argument that a number or a direction may be meant for: the share of a mix, or where a texture is looked up.
    static const Tree* in_its_place(const Tree& tree, std::string_view type) {
        const bool share = type == "float" && tree.call("mix", 3);
        const bool lookup = (type == "vec3" || type == "vec2") && tree.parts.size() >= 2 &&
                            (tree.calls({"texture", "textureCube", "texture2D", "texture3D", "textureLod"}));
        if (!share && !lookup) return nullptr;
        const Tree& argument = tree.parts[share ? 2 : 1];
        return argument.kind == Kind::name ? &argument : nullptr;
    }

    // Before the branch the derivatives are defined.
    Edits with_derivatives(const Place& at) const {
        const glsl::Unit& unit = at.shader->unit;
        const Tree call = expression(unit, at.first);
        if (!call.calls({"texture", "texture2D", "textureCube", "texture3D"}) || call.parts.size() != 2) return {};
        const std::string_view type = coordinate_type(unit, call);
        const auto name = span_of(unit, to_, call.first, call.first);
        const auto coordinate = span_of(unit, to_, call.parts[1].first, call.parts[1].last);
        if (type.empty() || !name || !coordinate) return {};
        const Body* body = body_around(*at.shader, at.first);
        if (!body || body->function->name != "main") return {};
        const auto token = defined_from(unit, *body, call.parts[1]);
        const auto start = token ? span_of(unit, to_, *token, *token) : std::nullopt;
        if (!start) return {};
        const std::string number = std::to_string(sources_.position(at.span.file, at.span.begin).line);
        const std::string dx = "snellDx" + number, dy = "snellDy" + number, of(to_.text(*coordinate));
        const std::string line = std::string(type) + " " + dx + " = dFdx(" + of + "), " + dy + " = dFdy(" + of + ");";
        return {after(*start, " " + line), {*name, "textureGrad"}, after(*coordinate, ", " + dx + ", " + dy)};
    }

    static std::string_view coordinate_type(const glsl::Unit& unit, const Tree& call) {
        for (const glsl::Global& g : unit.globals) {
            if (g.name != bare(call.parts[0]).text || g.type.base != glsl::Base::sampler) continue;
            if (g.type.name == "sampler2D") return "vec2";
            if (g.type.name == "samplerCube" || g.type.name == "sampler3D") return "vec3";
        }
        return {};
    }

    // The token behind which everything in the coordinate has its value, outside of all branches; nothing if
    // there is none before the first branch.
    static std::optional<int> defined_from(const glsl::Unit& unit, const Body& body, const Tree& coordinate) {
        int from = body.function->open;
        int branch = coordinate.first;
        for (const Piece& piece : body.pieces)
            if (piece.kind == Piece::Kind::condition) branch = std::min(branch, piece.first);
        for (const Loop& loop : body.loops) branch = std::min(branch, loop.word);
        bool known = true;
        for_each(coordinate, [&](const Tree& part) {
            if (part.kind == Kind::assign || part.kind == Kind::postfix) known = false;
            if (part.kind != Kind::name) return;
            for (const Piece& piece : body.pieces) {
                const bool declares = piece.kind == Piece::Kind::declaration && piece.name == part.text;
                const bool assigns = piece.kind == Piece::Kind::expression && !piece.value.parts.empty() &&
                                     unit.at(piece.value.first).text == part.text;
                if (!declares && !assigns) continue;
                if (piece.last > branch || piece.depth > 0) known = false;
                from = std::max(from, piece.last);
            }
        });
        return known ? std::optional(from) : std::nullopt;
    }

    const Plan& plan_;
    Sources& sources_;
    const Shaders& shaders_;
    Collector& to_;
    std::vector<Span>& eye_space_;
    std::map<std::pair<FileId, Rule>, std::vector<Fix>> fixes_;
};

}  // namespace

}  // namespace snell::accuracy::texts

namespace snell::accuracy {

void add_better_changes(const texts::Reading& reading, std::vector<Change>& changes) {
    texts::Collector to(reading.files, reading.sources, changes, texts::most_better_changes);
    std::vector<Span> eye_space;
    texts::LintFixes(reading.plan, reading.sources, reading.shaders, to, eye_space).run(reading.files);
    texts::add_physics(reading.plan, reading.shaders, eye_space, to);
}

}  // namespace snell::accuracy
