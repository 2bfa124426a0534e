#include "src/app/picture/non_finite.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"
#include "src/lint/lint.h"
#include "src/runtime/inspect.h"

namespace snell::app {

std::optional<NonFinite> count_non_finite(Runtime& runtime, const Frame& frame, int width, int height) {
    FloatPicture picture;
    if (!picture.resize(width, height)) return std::nullopt;
    std::vector<float> rgba;
    picture.draw(runtime, frame, rgba);
    const FlagCounts counts = count_flags(rgba);
    return NonFinite{counts[Flag::nan], counts[Flag::infinite]};
}

namespace {

using Size = std::array<int, 2>;
constexpr int small = 128, most = 1024;

// Comments may count: then a picture is drawn for nothing.
bool may_give_nan(std::string_view text) {
    constexpr std::string_view words[] = {"pow",  "sqrt", "log", "normalize",  "refract", "acos",
                                          "asin", "atan", "mod", "smoothstep", "inverse", "exp"};
    const auto names = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
    for (std::size_t at = text.find('/'); at != std::string_view::npos; at = text.find('/', at + 2))
        if (at + 1 < text.size() && text[at + 1] != '/' && text[at + 1] != '*' && (at == 0 || text[at - 1] != '*'))
            return true;
    return ranges::any_of(words, names);
}

}  // namespace

bool may_give_nan(const Plan& plan, const Sources& sources) {
    return ranges::any_of(plan.programs, [&](const PlannedProgram& program) {
        return ranges::any_of(program.stages,
                              [&](const glsl::StageInput& stage) { return may_give_nan(sources.text(stage.file)); });
    });
}

namespace {

using accuracy::Shader;
using glsl::Form;

// Of the picture that is tried. Where a shader reads gl_FragCoord, numbers depend on it: that of the scene's window.
Size tried_size(const Document& document) {
    for (FileId file = 0; file < document.sources.size(); ++file)
        if (document.sources.text(file).find("gl_FragCoord") != std::string_view::npos) {
            const Size& window = document.scene().window_size;
            return {std::min(window[0], most), std::min(window[1], most)};
        }
    return {small, small};
}

std::vector<bool> all_but(const Scene& scene, Index program) {
    std::vector<bool> hidden;
    for (const Draw& draw : scene.draws) hidden.push_back(draw.program != program);
    return hidden;
}

// Why an expression is NaN, or infinite, and none before it.
std::string cause(const glsl::Node& node, bool infinite) {
    const std::string_view text = node.text;
    const bool divides = text == "/" || text == "/=";
    if (infinite) return divides ? "a number is divided by 0" : "the number is larger than a float can be";
    static const std::map<std::string_view, std::string> causes{
        {"sqrt", "the square root of a negative number is not defined"},
        {"inversesqrt", "the square root of a negative number is not defined"},
        {"log", "the logarithm of a negative number is not defined"},
        {"log2", "the logarithm of a negative number is not defined"},
        {"pow", "it is not defined for a negative base, nor for 0 with an exponent of 0 or less"},
        {"acos", "it is defined from -1 to 1"},
        {"asin", "it is defined from -1 to 1"},
        {"atan", "it is not defined for 0 and 0"},
        {"normalize", "a vector of length 0 has no direction"},
        {"mod", "the divisor is 0"},
        {"smoothstep", "its edges are equal"},
        {"inverse", "the matrix has no inverse"},
    };
    if (divides) return "0 is divided by 0";
    const auto found = causes.find(text);
    if (found != causes.end()) return found->second;
    if (node.form == Form::built_in) return "it is not defined for these arguments";
    return node.form == Form::call ? "it is computed in this function"
                                   : "an operand is infinite, or is no number itself";
}

// Where the pixels of a program that are NaN begin to be so. Copies of its shaders write into the colour which
// expression is the first that is NaN, and the first that is infinite. An expression counts as the origin only if
// pixels are no longer NaN when it alone is a finite number.
class Origin {
public:
    struct Found {
        Span where;
        std::string text, cause;
        bool infinite = false;
    };

    Origin(const Document& document, Index program, Size size, std::vector<bool> nan)
        : document_(document), program_(program), size_(size), nan_(std::move(nan)), files_(copy_of_files({})) {
        auto parsed = parse_document(document.path, *files_, sources_, unheard_);
        if (!parsed) return;
        plan_ = make_plan(std::move(parsed->scene), *files_, sources_, unheard_);
        plan_.scene.output = Encoding::raw;
        reading_.emplace(plan_, *files_, sources_);
        stages_ = reading_->stages(program);
    }

    std::optional<Found> find() {
        const Shader* fragment = stage_of(stages_, Stage::fragment);
        const bool large = ranges::any_of(
            stages_, [](const Shader* shader) { return shader->unit.tokens.size() > accuracy::most_tokens; });
        if (!fragment || large || accuracy::colour_output(*fragment).empty()) return std::nullopt;
        // What vertices have is computed before all fragments.
        const Shader* vertex = stage_of(stages_, Stage::vertex);
        if (vertex && stages_.size() == 2 && accuracy::has_own_main(*vertex))
            if (auto found = search(*vertex)) return found;
        return search(*fragment);
    }

private:
    std::unique_ptr<Files> copy_of_files(std::map<std::string, std::string> texts) const {
        return std::make_unique<Files>(document_.files->folder(), document_.files->access().with(std::move(texts)));
    }

    // How many of the pixels are NaN, and the numbers of the expressions that are the first in most of them; 0: none.
    struct Seen {
        bool drawn = false;
        std::size_t nan = 0;
        int first = 0, infinite = 0;
    };

    std::optional<Found> search(const Shader& shader) {
        list_expressions(shader);
        const std::size_t all = draw(shader, {}).nan;
        std::vector<int> finite;
        for (int round = 0; round < 3; ++round) {
            const Seen seen = draw(shader, finite);
            if (seen.first == 0) return std::nullopt;
            for (const int one : {seen.infinite, seen.first}) {
                if (one == 0) continue;
                finite.push_back(one);
                const Seen without = draw(shader, finite);
                const auto helps_alone = [&] { return finite.size() == 1 || draw(shader, {one}).nan < all; };
                if (without.drawn && without.nan < seen.nan && helps_alone())
                    return found(shader, one, one == seen.infinite);
                if (one == seen.infinite) finite.pop_back();
            }
        }
        return std::nullopt;
    }

    Found found(const Shader& shader, int number, bool infinite) const {
        const int node = expressions_[static_cast<std::size_t>(number - 1)];
        Span where = shader.span(node);
        const std::string_view name = sources_.name(where.file);
        for (FileId file = 0; file < document_.sources.size(); ++file)
            if (document_.sources.name(file) == name) {
                where.file = file;
                break;
            }
        return {where, accuracy::excerpt(shader.text(node)), cause(shader.at(node), infinite), infinite};
    }

    // Numbers, vectors and square matrices, inner ones first, which is the order in which they are computed.
    void list_expressions(const Shader& shader) {
        constexpr std::size_t most = 1000;
        expressions_.clear();
        for (int n = 0; n < shader.nodes() && expressions_.size() < most; ++n) {
            const glsl::Node& node = shader.at(n);
            const glsl::Type& type = node.type;
            if (node.first < 0 || node.constant || shader.function_of(node.first) < 0 || !shader.own(n)) continue;
            if (type.base != glsl::Base::real || type.dims > 0 || (type.cols > 1 && type.cols != type.rows)) continue;
            const bool computes = node.form == Form::built_in || node.form == Form::call ||
                                  (node.form == Form::infix && arithmetic(node.text)) || updates(shader, n);
            if (computes) expressions_.push_back(n);
        }
    }

    static bool arithmetic(std::string_view op) { return op == "/" || op == "*" || op == "+" || op == "-"; }

    // `a /= b` and its like, whose target may be written twice.
    static bool updates(const Shader& shader, int n) {
        const glsl::Node& node = shader.at(n);
        if (node.form != Form::assign || node.text.size() != 2 || !arithmetic(node.text.substr(0, 1))) return false;
        const int target = shader.parts(n).front();
        for (int k = shader.at(target).begin; k <= target; ++k) {
            const Form form = shader.at(k).form;
            if (form == Form::step || form == Form::assign || form == Form::call || form == Form::other) return false;
        }
        return true;
    }

    // The shader with every expression noted, and with those of these numbers as finite ones.
    void note_all(const Shader& shader, const std::vector<int>& finite, std::vector<Edit>& edits) const {
        const auto kept = [&](std::size_t i) { return ranges::count(finite, static_cast<int>(i) + 1) > 0; };
        for (std::size_t i = expressions_.size(); i-- > 0;) {
            const int node = expressions_[i];
            const Span span = shader.span(node);
            const std::string open = kept(i) ? "snellNoted(snellFinite(" : "snellNoted(";
            if (shader.at(node).form != Form::assign) {
                edits.push_back(accuracy::insertion(span, span.begin, open));
                continue;
            }
            const int target = shader.parts(node).front(), sign = shader.at(target).last + 1;
            edits.push_back({shader.span(sign, sign), "= " + open + "(" + shader.text(target) + ") " +
                                                          std::string(shader.at(node).text.substr(0, 1)) + " ("});
        }
        for (std::size_t i = 0; i < expressions_.size(); ++i) {
            const int node = expressions_[i];
            const Span span = shader.span(node);
            edits.push_back(accuracy::insertion(
                span, span.end,
                fmt::format("{}{}, {})", shader.at(node).form == Form::assign ? ")" : "", kept(i) ? ")" : "", i + 1)));
        }
    }

    static std::string helpers() {
        std::string text = "int snellFirstNan = 0, snellFirstInfinite = 0;\n";
        for (const std::string type : {"float", "vec2", "vec3", "vec4", "mat2", "mat3", "mat4"}) {
            const auto is = [&](const std::string& function) {
                if (type == "float") return function + "(x)";
                if (type[0] == 'v') return "any(" + function + "(x))";
                std::string any = "any(" + function + "(x[0]))";
                for (char column = '1'; column < type.back(); ++column)
                    any += " || any(" + function + "(x[" + column + "]))";
                return any;
            };
            text += fmt::format(
                "{0} snellNoted({0} x, int number) {{\n"
                "    if (snellFirstNan == 0 && ({1})) snellFirstNan = number;\n"
                "    if (snellFirstNan == 0 && snellFirstInfinite == 0 && ({2})) snellFirstInfinite = number;\n"
                "    return x;\n}}\n"
                "{0} snellFinite({0} x) {{ return {1} || {2} ? {0}(.5) : x; }}\n",
                type, is("isnan"), is("isinf"));
        }
        return text;
    }

    // What tells the colour of `shader`: that of the fragment shader, which may be the same.
    std::vector<Edit> edits_of(const Shader& shader, const std::vector<int>& finite) const {
        std::vector<Edit> edits;
        const Shader& fragment = *stage_of(stages_, Stage::fragment);
        const auto declare = [&](const Shader& to, const std::string& text) {
            for (std::size_t f = 0; f < to.unit.functions.size(); ++f)
                if (const auto ahead = to.ahead_of(static_cast<int>(f))) {
                    edits.push_back({*ahead, text});
                    return;
                }
        };
        const std::string output = accuracy::colour_output(fragment);
        std::string noted = "float(snellFirstNan), float(snellFirstInfinite)";
        declare(shader, helpers());
        note_all(shader, finite, edits);
        if (&shader != &fragment) {
            declare(shader, shader.unit.version < 130 ? "varying vec2 snellNotes;\n" : "flat out vec2 snellNotes;\n");
            declare(fragment,
                    fragment.unit.version < 130 ? "varying vec2 snellNotes;\n" : "flat in vec2 snellNotes;\n");
            accuracy::add_behind_main(shader, "snellNotes = vec2(" + noted + ");", edits);
            noted = "snellNotes";
        }
        accuracy::add_behind_main(fragment,
                                  fmt::format("{0} = vec4({1}, any(isnan({0})) ? 1. : 0., 1.);", output, noted), edits);
        return edits;
    }

    Seen draw(const Shader& shader, const std::vector<int>& finite) const {
        Seen seen;
        accuracy::Change change;
        change.edits = edits_of(shader, finite);
        const std::array<const accuracy::Change*, 1> changes{&change};
        const auto files = copy_of_files(accuracy::changed_texts(changes, sources_));
        Sources sources;
        Diagnostics wrong;
        auto parsed = parse_document(document_.path, *files, sources, wrong);
        if (!parsed) return seen;
        Plan plan = make_plan(std::move(parsed->scene), *files, sources, wrong);
        plan.scene.output = Encoding::raw;
        Runtime runtime(std::move(plan), *files, sources, gl::query_caps(), wrong, {.previous = &*document_.runtime});
        FloatPicture picture;
        if (wrong.has_errors() || !picture.resize(size_[0], size_[1])) return seen;
        const View view;
        const std::vector<bool> hidden = all_but(runtime.scene(), program_);
        std::vector<float> rgba;
        picture.draw(runtime, {.view = view, .controls = runtime.controls(), .hidden = &hidden, .unblended = true},
                     rgba);
        seen.drawn = true;
        std::map<int, std::size_t> first;
        std::map<int, std::map<int, std::size_t>> infinite;  // by the first that is NaN
        for (std::size_t i = 0; i < nan_.size() && 4 * i < rgba.size(); ++i) {
            if (!nan_[i] || !(rgba[4 * i + 2] > .5F)) continue;
            const auto a = static_cast<int>(rgba[4 * i]), b = static_cast<int>(rgba[4 * i + 1]);
            ++seen.nan;
            ++first[a];
            ++infinite[a][b];
        }
        const auto most = [](const std::map<int, std::size_t>& counts) {
            const auto found = ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
            return found == counts.end() ? 0 : found->first;
        };
        first.erase(0);
        seen.first = in_range(most(first));
        seen.infinite = in_range(most(infinite[seen.first]));
        return seen;
    }

    int in_range(int number) const {
        return number > 0 && static_cast<std::size_t>(number) <= expressions_.size() ? number : 0;
    }

    const Document& document_;
    Index program_;
    Size size_;
    std::vector<bool> nan_;  // pixels
    std::unique_ptr<Files> files_;
    Sources sources_;
    Diagnostics unheard_;  // the scene is known to be without errors
    Plan plan_;
    std::optional<accuracy::Reading> reading_;
    std::vector<const Shader*> stages_;
    std::vector<int> expressions_;  // nodes; their numbers begin with 1
};

std::string pixels_text(std::size_t nan, Size size) {
    return fmt::format("{} of the {} pixels of a picture of {} x {}", nan, size[0] * size[1], size[0], size[1]);
}

void warn(Document& document, Index index, Size size, std::size_t nan, const std::optional<Origin::Found>& origin) {
    const Program& program = document.scene().programs[index];
    const char* const shows = "these pixels have no colour, and most drivers show nothing there";
    if (!origin) {
        document.diagnostics.warning(
            "non-finite", program.span,
            fmt::format("program '{}' computes NaN (not a number) in {}, with the scene's values: {}", program.name,
                        pixels_text(nan, size), shows),
            "look for 0. / 0., and for pow, sqrt, log, acos or normalize of numbers for which they are not defined; in "
            "the window, N marks these pixels");
        return;
    }
    document.diagnostics
        .warning("non-finite", origin->where,
                 fmt::format("'{}' {}: {}; program '{}' has NaN in {}, with the scene's values", origin->text,
                             origin->infinite ? "is infinite, and NaN (not a number) is computed from it"
                                              : "is NaN (not a number)",
                             origin->cause, program.name, pixels_text(nan, size)),
                 fmt::format("{}; in the window, N marks them", shows))
        .notes.push_back({program.span, "the program"});
}

}  // namespace

void warn_of_nan(Document& document) {
    if (!document.runtime || document.diagnostics.has_errors() || lint::may_not_end(document.diagnostics)) return;
    const View view;
    Frame frame{0, view, document.controls};
    FloatPicture picture;
    const Size size = tried_size(document);
    if (!picture.resize(size[0], size[1])) return;
    std::vector<float> rgba;
    picture.draw(*document.runtime, frame, rgba);
    if (count_flags(rgba)[Flag::nan] == 0) return;
    for (Index program = 0; program < document.scene().programs.size(); ++program) {
        const std::vector<bool> hidden = all_but(document.scene(), program);
        frame.hidden = &hidden;
        picture.draw(*document.runtime, frame, rgba);
        const std::size_t count = count_flags(rgba)[Flag::nan];
        if (count == 0) continue;
        std::vector<bool> nan;
        for (std::size_t i = 0; i < rgba.size(); i += 4)
            nan.push_back(flag_of(std::span<const float, 4>(&rgba[i], 4)) == Flag::nan);
        warn(document, program, size, count, Origin(document, program, size, std::move(nan)).find());
    }
}

}  // namespace snell::app
