// Hints for the most common mistakes.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <span>

#include "parser/text/words.h"
#include "src/glsl/log/log.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"

namespace snell::glsl::log {
namespace {

// What GLSL offers besides functions.
constexpr std::string_view others =
    "texture1D texture2D texture3D textureCube gl_Vertex gl_Normal gl_Color gl_MultiTexCoord0 gl_Position "
    "gl_PointSize gl_FragColor gl_FragData gl_FragCoord gl_FragDepth gl_FrontFacing gl_FrontColor gl_BackColor "
    "gl_TexCoord gl_ModelViewMatrix gl_ProjectionMatrix gl_ModelViewProjectionMatrix gl_NormalMatrix gl_TextureMatrix "
    "gl_ModelViewMatrixInverse gl_LightSource gl_FrontMaterial gl_Fog gl_PositionIn gl_in gl_InvocationID "
    "gl_TessCoord gl_TessLevelOuter gl_TessLevelInner gl_VertexID gl_InstanceID gl_PrimitiveID gl_PointCoord float "
    "int bool vec2 vec3 vec4 mat2 mat3 mat4 sampler2D sampler3D samplerCube";

// The parameters of a GLSL function that always takes as many ("x, y, a"); empty for others.
std::string_view builtin_parameters(std::string_view name) {
    const BuiltinFunction* function = builtin_function(name);
    if (!function || function->parameters.empty()) return {};
    const auto commas = std::count(function->parameters.begin(), function->parameters.end(), ',');
    for (const std::string_view overload : split(function->signatures))  // R:AA; a bracket makes it longer
        if (static_cast<std::ptrdiff_t>(overload.size()) != commas + 3) return {};
    return function->parameters;
}

// Names of functions and variables that GLSL itself offers.
const std::vector<std::string_view>& builtin_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all = split(others);
        for (const BuiltinFunction& f : builtin_functions()) all.push_back(f.name);
        return all;
    }();
    return names;
}

// Components of a float vector type or of float: 1 to 4; 0 for others.
int components(std::string_view type) {
    if (type == "float") return 1;
    if (type.size() == 4 && type.starts_with("vec") && type[3] >= '2' && type[3] <= '4') return type[3] - '0';
    return 0;
}

std::string conversion_help(std::string_view from, std::string_view to) {
    const int have = components(from), want = components(to);
    if (have > want && want == 1)
        return fmt::format("length(…) makes one number of a {0}; '.x' after it takes one component", from);
    if (have > want && want > 1) {
        constexpr std::string_view swizzle = "xyzw";
        return fmt::format("take {} of its components: write '.{}' after the {}", want,
                           swizzle.substr(0, static_cast<std::size_t>(want)), from);
    }
    if (have == 1 && want > 1) return fmt::format("make a vector of it: {}(…)", to);
    if (have > 1 && want == have + 1) return fmt::format("give the missing component: {}(…, 1.)", to);
    if (have > 1 && want > have) return fmt::format("give the missing components: {}(…, 0., 1.)", to);
    if ((to == "int" || to == "uint" || to == "float" || to == "bool") &&
        (from == "int" || from == "uint" || from == "float" || from == "bool" || from == "double"))
        return fmt::format("convert it: {}(…)", to);
    return {};
}

Span span_of(FileId file, const Declared& d) { return {file, d.begin, d.end}; }

// The one name that begins so; empty if there are several or none.
std::string_view only_longer(std::string_view beginning, const std::vector<std::string_view>& names) {
    std::string_view found;
    for (const std::string_view name : names) {
        if (beginning.size() < 3 || !same_word(name.substr(0, beginning.size()), beginning)) continue;
        if (!found.empty() && found != name) return {};
        found = name;
    }
    return found;
}

// The declaration whose name is nearest to `name`: equal but for capitals first, then uniforms that nothing uses, then
// what was declared last. Variables can't be called.
const Declared* nearest_declared(std::string_view name, const std::vector<Declared>& all, bool called = false) {
    std::vector<std::string_view> names, unused;
    for (const Declared& d : all) {
        if (d.name == name || (called && !d.function && !d.type.empty())) continue;
        if (same_word(d.name, name)) return &d;
        names.push_back(d.name);
        if (d.qualifier == "uniform" && d.uses == 0) unused.push_back(d.name);
    }
    std::string_view best = nearest(name, unused);
    std::reverse(names.begin(), names.end());
    if (best.empty()) best = nearest(name, names);
    if (best.empty()) best = only_longer(name, names);
    if (best.empty()) return nullptr;
    return &*std::find_if(all.begin(), all.end(), [&](const Declared& d) { return d.name == best; });
}

// A built-in variable, or a slip for one.
bool of_gl(std::string_view name) { return same_word(name.substr(0, 3), "gl_"); }

const StageOutput* stage_of(const Translation& translation, std::optional<Stage> stage) {
    for (const StageOutput& s : translation.stages)
        if (stage && s.stage == *stage) return &s;
    return nullptr;
}

std::string hand_on(std::string_view attribute) {
    return fmt::format("only the vertex shader has attributes: hand '{}' on in a varying of its own", attribute);
}

// `name` as an output of another stage: the input was forgotten here.
bool hint_other_stage(std::string_view name, const Context& context, Diagnostic& diagnostic) {
    for (const StageOutput& other : context.translation.stages) {
        if (&other == context.stage || (context.stage && other.stage == context.stage->stage)) continue;
        for (const FileId file : other.files)
            for (const Declared& d : context.texts.declared(file)) {
                if (d.name != name || d.qualifier.empty() || d.qualifier == "const") continue;
                const bool given = d.qualifier == "in" || d.qualifier == "attribute";
                const std::string_view here = d.qualifier == "out" ? "in" : d.qualifier == "in" ? "out" : d.qualifier;
                diagnostic.help = given && other.stage == Stage::vertex
                                      ? hand_on(name)
                                      : fmt::format("declare it in this shader too: {} {} {};", here, d.type, name);
                diagnostic.notes.push_back(
                    {span_of(file, d), fmt::format("the {} shader declares it here", stage_name(other.stage))});
                return true;
            }
    }
    return false;
}

// A fix if the word stands once where the driver saw it: some drivers only name the line.
void suggest(Diagnostic& diagnostic, std::string_view word, std::string_view meant, const Context& context) {
    const Span& span = diagnostic.span;
    const std::string_view text = context.sources.text(span.file);
    const Word* found = nullptr;
    for (const Word& w : context.texts.words(span.file)) {
        if (w.begin < span.begin || w.end > span.end || text_of(text, w) != word) continue;
        if (found) return;
        found = &w;
    }
    if (found) diagnostic.fixes.push_back({{span.file, found->begin, found->end}, std::string(meant)});
}

// The type of a texture that snell binds where a shader declares it; empty for other names.
std::string_view bound_sampler(std::string_view name) {
    static const std::vector<SystemName> all = system_names();
    const auto found = std::find_if(all.begin(), all.end(), [&](const SystemName& s) { return s.name == name; });
    return found == all.end() || !found->type.starts_with("sampler") ? std::string_view() : found->type;
}

// A comment took the declaration with it.
bool hint_comment(std::string_view name, FileId file, const Context& context, Diagnostic& diagnostic) {
    const std::string_view text = context.sources.text(file);
    const std::vector<Word>& read = context.texts.words(file);
    for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
        const auto offset = static_cast<std::uint32_t>(at);
        if (std::binary_search(read.begin(), read.end(), Word{offset},
                               [](const Word& a, const Word& b) { return a.begin < b.begin; }))
            continue;
        std::string_view line = context.sources.line(file, context.sources.position(file, offset).line);
        const std::string_view before = line.substr(0, static_cast<std::size_t>(text.data() + at - line.data()));
        std::size_t comment = 0;
        for (const std::string_view opening : {"//", "/*"})
            if (const std::size_t begin = before.rfind(opening); begin != line.npos)
                comment = std::max(comment, begin + 2);
        line.remove_prefix(comment);
        for (const Declared& d : declared(line, words(line))) {
            if (d.name != name || !builtin_type(d.type)) continue;
            diagnostic.help = "its declaration is part of a comment";
            diagnostic.notes.push_back({{file, offset, offset + static_cast<std::uint32_t>(name.size())}, "here"});
            return true;
        }
    }
    return false;
}

// The type of a uniform that nothing declares: of what the function that gets it wants, or the scene gives it.
std::string type_given(std::string_view name, std::string_view scene, std::span<const Word> value,
                       std::string_view shader, std::span<const Word> read) {
    for (std::size_t i = 2; i < read.size(); ++i) {
        if (text_of(shader, read[i]) != name || text_of(shader, read[i - 1]) != "(") continue;
        const std::string_view function = text_of(shader, read[i - 2]);
        if (!function.starts_with("texture")) continue;
        return function.starts_with("textureCube") ? "samplerCube"
               : function.starts_with("texture3D") ? "sampler3D"
                                                   : "sampler2D";
    }
    if (value.empty() || std::string_view("{[").find(text_of(scene, value[0])) == std::string_view::npos)
        return "float";
    std::size_t n = 0;
    for (std::size_t i = 1; i < value.size() && std::string_view("}]").find(text_of(scene, value[i])) == scene.npos;
         ++i)
        n += text_of(scene, value[i]).find_first_of("0123456789") == std::string_view::npos ? 0 : 1;
    return n >= 2 && n <= 4 ? fmt::format("vec{}", n) : "float";
}

// The scene gives it a value: its declaration was forgotten.
bool hint_given(std::string_view name, FileId file, const Context& context, Diagnostic& diagnostic) {
    const Span& where = context.where;
    const std::string_view scene = context.sources.text(where.file).substr(where.begin, where.end - where.begin);
    const std::vector<Word> given = words(scene);
    for (std::size_t i = 2; i < given.size(); ++i) {
        if (text_of(scene, given[i]) != name) continue;
        const std::string type = type_given(name, scene, std::span(given).subspan(i + 1), context.sources.text(file),
                                            context.texts.words(file));
        diagnostic.help = fmt::format("declare it above main: uniform {} {};", type, name);
        diagnostic.notes.push_back(
            {{where.file, where.begin + given[i].begin, where.begin + given[i].end}, "the scene gives it a value"});
        return true;
    }
    return false;
}

// The built-in name that is meant: one of those that begin with gl_, if the name does; empty if there is none.
std::string_view nearest_builtin(std::string_view name) {
    std::vector<std::string_view> all = builtin_names();
    if (of_gl(name)) std::erase_if(all, [](std::string_view other) { return !of_gl(other); });
    const auto same = std::find_if(all.begin(), all.end(), [&](auto other) { return same_word(other, name); });
    const std::string_view found = same == all.end() ? nearest(name, all) : *same;
    return found == name ? std::string_view() : found;
}

// Where a variable gets its first value, without a type.
bool hint_no_type(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic) {
    const std::vector<Word>& read = context.texts.words(place.file);
    const std::string_view text = context.sources.text(place.file);
    for (std::size_t i = 1; i + 2 < read.size(); ++i) {
        if (read[i].line != place.line || text_of(text, read[i]) != name || text_of(text, read[i + 1]) != "=" ||
            text_of(text, read[i + 2]) == "=")
            continue;
        const bool loop = i > 1 && text_of(text, read[i - 2]) == "for";
        if (std::string_view(loop ? "(" : ";{}").find(text_of(text, read[i - 1])) == std::string_view::npos) continue;
        diagnostic.help = "where it first gets a value, its type comes before it";
        const Span span{place.file, read[i].begin, read[i].end};
        if (context.stage)
            for (const Misfit& m : context.stage->misfits)
                if (m.op == "=" && m.span == span) diagnostic.help += fmt::format(": {} {} = …", m.right, name);
        return true;
    }
    return false;
}

// The text declares it, but not where it is seen here.
bool hint_unseen(std::string_view name, const Place& place, const std::vector<Declared>& all, Diagnostic& diagnostic) {
    const auto d = std::find_if(all.begin(), all.end(), [&](const Declared& other) { return other.name == name; });
    if (d == all.end()) return false;
    const bool later = d->begin > place.span.begin;
    diagnostic.help = !later && d->function ? fmt::format("a function is called with its arguments: {}(…)", name)
                      : later               ? std::string("declare it before its first use")
                                            : std::string("a name holds only inside the { } where it is declared");
    diagnostic.notes.push_back({span_of(place.file, *d), "declared here"});
    return true;
}

void hint_undeclared(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic,
                     bool called = false) {
    if (!place.known) return;
    const std::vector<Declared>& all = context.texts.declared(place.file);
    if (hint_unseen(name, place, all, diagnostic)) return;
    if (!called && hint_comment(name, place.file, context, diagnostic)) return;
    if (!called && hint_given(name, place.file, context, diagnostic)) return;
    const Declared* d = of_gl(name) ? nullptr : nearest_declared(name, all, called);
    const std::string_view sampler = called || (d && same_word(d->name, name)) ? "" : bound_sampler(name);
    if (!sampler.empty()) {
        diagnostic.help = fmt::format("declare it: uniform {} {};", sampler, name);
        return;
    }
    if (!called && (!d || !same_word(d->name, name)) && hint_other_stage(name, context, diagnostic)) return;
    const bool fragment = context.stage && context.stage->stage == Stage::fragment;
    const bool given = d && (d->qualifier == "uniform" || d->qualifier == "in" || d->qualifier == "const" ||
                             (d->qualifier == "varying" && fragment));
    if (given && !same_word(d->name, name) && hint_no_type(name, place, context, diagnostic)) return;
    if (d) {
        const bool unused = d->qualifier == "uniform" && d->uses == 0;
        diagnostic.help = fmt::format("did you mean '{}'?", d->name);
        suggest(diagnostic, name, d->name, context);
        diagnostic.notes.push_back(
            {span_of(place.file, *d), unused ? "this uniform is declared but never used" : "declared here"});
        return;
    }
    const std::string_view meaning = gstap_meaning(name, Stage::vertex);
    const LegacyName* legacy = legacy_name(meaning.empty() ? name : meaning);
    if (legacy && legacy->kind == LegacyKind::attribute && context.stage && context.stage->stage != Stage::vertex) {
        diagnostic.help = hand_on(name);
        return;
    }
    constexpr std::pair<std::string_view, std::string_view> shadertoy[] = {
        {"iTime", "float uTime"}, {"iResolution", "vec2 uResolution"}, {"iMouse", "vec2 uMouse"}};
    for (const auto& [theirs, ours] : shadertoy)
        if (name == theirs) diagnostic.help = fmt::format("Shadertoy's: declare and write 'uniform {};' here", ours);
    if (!diagnostic.help.empty()) return;
    const bool color = same_word(name, "fragColor") && fragment;
    if (!color && !of_gl(name) && hint_no_type(name, place, context, diagnostic)) return;
    // A name as uniforms have it is none of the language.
    if (!called && name.size() > 1 && name[0] == 'u' && std::isupper(static_cast<unsigned char>(name[1])) != 0) {
        const std::string type =
            type_given(name, {}, {}, context.sources.text(place.file), context.texts.words(place.file));
        diagnostic.help = fmt::format("declare it above main: uniform {} {};", type, name);
        return;
    }
    if (const std::string_view built_in = color ? "gl_FragColor" : nearest_builtin(name); !built_in.empty()) {
        diagnostic.help = fmt::format("did you mean '{}'?", built_in);
        suggest(diagnostic, name, built_in, context);
    }
}

int count_arguments(std::string_view list) {
    return list.empty() ? 0 : 1 + static_cast<int>(std::count(list.begin(), list.end(), ','));
}

bool in_main(const Place& place, const Context& context) {
    const Declared* function = nullptr;
    if (place.known)
        for (const Declared& d : context.texts.declared(place.file))
            if (d.function && d.depth == 0 && !d.type.empty() && d.begin < place.span.begin) function = &d;
    return function && function->name == "main";
}

void hint_returns(const Entry& entry, const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (in_main(place, context)) {
        diagnostic.help = "'main' returns nothing: write 'return;'";
        return;
    }
    diagnostic.help = conversion_help(entry.a, entry.b);
    if (entry.a.empty() && !entry.b.empty())
        diagnostic.help = fmt::format("the function declares that it returns '{}'", entry.b);
    if (entry.b == "void") diagnostic.help = "a function that returns a value names its type in place of 'void'";
}

void hint_call(const Entry& entry, std::string_view name, const Place& place, const Context& context,
               Diagnostic& diagnostic) {
    if (name.empty() && entry.kind == Kind::no_function) diagnostic.help = "is an operator missing before the '('?";
    const std::string_view parameters = builtin_parameters(name);
    if (!parameters.empty()) {
        const int wants = count_arguments(parameters);
        const std::string_view noun = wants == 1 ? "argument" : "arguments";
        diagnostic.help = fmt::format("{}({}) takes {} {}", name, parameters, wants, noun);
        if (!entry.b.empty() && count_arguments(entry.b) == wants)
            diagnostic.help = fmt::format("{}({}) wants arguments of matching sizes", name, parameters);
        return;
    }
    if (!place.known) return;
    bool known = false;
    for (const Declared& d : context.texts.declared(place.file)) {
        if (d.name != name || !d.function) continue;
        diagnostic.notes.push_back({span_of(place.file, d), "this one is declared here"});
        known = true;
    }
    if (!known) hint_undeclared(name, place, context, diagnostic, true);
    if (diagnostic.help.starts_with("a name holds"))
        diagnostic.help = fmt::format("'{}' is a variable, not a function", name);
}

void hint_no_main(const Entry& entry, const Context& context, Diagnostic& diagnostic) {
    const StageOutput* stage = context.stage ? context.stage : stage_of(context.translation, entry.stage);
    if (!stage || stage->files.empty()) return;
    diagnostic.help = "every shader starts at 'void main()'";
    for (const FileId file : stage->files)
        for (const Declared& d : context.texts.declared(file)) {
            if (!d.function || nearest("main", {d.name}).empty()) continue;
            diagnostic.span = span_of(file, d);
            diagnostic.help = fmt::format("did you mean 'main' instead of '{}'?", d.name);
            suggest(diagnostic, d.name, "main", context);
            return;
        }
    diagnostic.span = context.sources.line_span(stage->files.front(), 1);
}

// The output that an input was meant for: nearly the same name in an earlier stage.
void hint_not_written(const Entry& entry, const Context& context, Diagnostic& diagnostic) {
    for (const StageOutput& s : context.translation.stages) {
        if (entry.stage && s.stage >= *entry.stage) continue;
        for (const FileId file : s.files) {
            const std::string_view text = context.sources.text(file);
            std::vector<Declared> outputs;
            for (const Declared& d : context.texts.declared(file))
                if (d.qualifier == "out" || d.qualifier == "varying") outputs.push_back(d);
            const Declared* d = nearest_declared(user_name(entry.a, text), outputs);
            if (!d) continue;
            diagnostic.help = fmt::format("the {} shader calls it '{}': the names must agree, capitals included",
                                          stage_name(s.stage), d->name);
            diagnostic.notes.push_back({span_of(file, *d), "the output is declared here"});
            return;
        }
    }
}

// Where else the same variable is declared.
void hint_types_differ(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic) {
    for (const StageOutput& s : context.translation.stages)
        for (const FileId file : s.files)
            for (const Declared& d : context.texts.declared(file)) {
                if (d.name != name || d.qualifier.empty() || span_of(file, d) == place.span) continue;
                diagnostic.notes.push_back(
                    {span_of(file, d), fmt::format("the {} shader declares '{}' here", stage_name(s.stage), d.type)});
            }
    diagnostic.help = "declare it with the same type in every shader of the program";
}

// `if (x = 1.)` and `if (x)`.
void hint_condition(const Place& place, const Context& context, Diagnostic& diagnostic) {
    diagnostic.help = "compare it with something, as in 'x > 0.' or 'n != 0'";
    if (!place.known) return;
    const std::string_view line = context.sources.line(place.file, place.line);
    const std::size_t open = line.find("if");
    const std::size_t assigned = open == std::string_view::npos ? open : line.find('=', open);
    if (assigned == std::string_view::npos || assigned + 1 >= line.size() || line.find(')', open) < assigned) return;
    const bool comparison =
        line[assigned + 1] == '=' || std::string_view("<>!=").find(line[assigned - 1]) != std::string_view::npos;
    if (!comparison) diagnostic.help = "'=' assigns; '==' compares";
}

void hint_redeclared(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known) return;
    for (const Declared& d : context.texts.declared(place.file))
        if (d.name == name && d.begin < place.span.begin) {
            diagnostic.notes.push_back({span_of(place.file, d), "first declared here"});
            return;
        }
    if (context.twice(place.file)) {
        diagnostic.help = included_twice(context.sources.name(place.file));
        return;
    }
    for (const FileId file : context.stage ? context.stage->files : std::vector<FileId>())
        for (const Declared& d : context.texts.declared(file))
            if (file != place.file && d.name == name && d.depth == 0)
                diagnostic.notes.push_back({span_of(file, d), "declared here, too"});
}

void hint_read_only(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known || name.empty()) return;
    for (const Declared& d : context.texts.declared(place.file)) {
        if (d.name != name || d.qualifier.empty()) continue;
        diagnostic.help =
            fmt::format("'{}' is declared as '{}': copy it to a variable of its own first", name, d.qualifier);
        diagnostic.notes.push_back({span_of(place.file, d), "declared here"});
        return;
    }
}

}  // namespace

std::string help(const Misfit& misfit) {
    const std::string_view op = misfit.op, left = misfit.left, right = misfit.right;
    if (op == ":=") return conversion_help(right, left);
    const auto scalar = [](std::string_view type) {
        return type == "float" || type == "int" || type == "uint" || type == "bool" || type == "double";
    };
    const bool numbers = left.find("bool") == left.npos && left.find("bvec") == left.npos;
    if (right.empty() && op == "!")
        return left.starts_with("bvec") ? "not(…) turns every component; any(…) and all(…) make one bool of them"
                                        : "compare it with something, as in 'x > 0.' or 'n != 0'";
    if (right.empty()) return op == "~" ? "it takes whole numbers" : "it takes numbers: float(…) makes one of a bool";
    if (op == "==" || op == "!=") {
        const std::string_view vector = scalar(left) ? right : left;
        const bool matrix = left.starts_with("mat") || right.starts_with("mat");
        if (scalar(left) == scalar(right) && !matrix)
            return "both sides need the same number of components: '.xyz' of a vec4 goes with a vec3";
        if (matrix) return "both sides need the same type";
        return fmt::format("compare one component, as in 'v.x', or the whole: {}(…)", vector);
    }
    if (op == "<" || op == ">" || op == "<=" || op == ">=")
        return "it compares two numbers: one component, as in 'v.x', or length(v); lessThan(…) and its like compare "
               "all";
    if (op == "&&" || op == "||" || op == "^^") return "both sides must be true or false: compare with something";
    if (op == "%") return numbers ? "it takes whole numbers; mod(x, y) takes floats" : "it takes whole numbers";
    if (op == "&" || op == "|" || op == "^")
        return fmt::format("it takes whole numbers{}",
                           op == "^" ? "; pow(x, y) is a power" : "; '&&' and '||' join conditions");
    if (op == "<<" || op == ">>") return "it takes whole numbers";
    if (op == "?:") return "both must have the same type";
    if (!numbers) return "it takes numbers: float(…) makes one of a bool";
    if (left.starts_with("mat") || right.starts_with("mat"))
        return "a mat3 goes with a vec3, a mat4 with a vec4: vec4(v, 1.) and v.xyz turn one into the other";
    return "both sides need the same number of components: '.xyz' of a vec4 goes with a vec3";
}

void hint(const Entry& entry, const Place& place, const Context& context, Diagnostic& diagnostic) {
    const std::string_view line = place.known ? context.sources.line(place.file, place.line) : std::string_view();
    const std::string name = user_name(entry.a, line);
    switch (entry.kind) {
        case Kind::undeclared:
            return hint_undeclared(name, place, context, diagnostic);
        case Kind::no_function:
        case Kind::no_overload:
            return hint_call(entry, name, place, context, diagnostic);
        case Kind::returns:
            return hint_returns(entry, place, context, diagnostic);
        case Kind::convert:
            diagnostic.help = conversion_help(entry.a, entry.b);
            return;
        case Kind::condition:
            return hint_condition(place, context, diagnostic);
        case Kind::redeclared:
            return hint_redeclared(name, place, context, diagnostic);
        case Kind::read_only:
            return hint_read_only(name, place, context, diagnostic);
        case Kind::not_global:
            return hint_not_global(place, context, diagnostic);
        case Kind::syntax:
            return hint_syntax(place, context, diagnostic);
        case Kind::end_of_file:
            return hint_end_of_file(place, context, diagnostic);
        case Kind::no_main:
            return hint_no_main(entry, context, diagnostic);
        case Kind::not_written:
            return hint_not_written(entry, context, diagnostic);
        case Kind::types_differ:
            return hint_types_differ(name, place, context, diagnostic);
        default:
            diagnostic.help = words_of(entry.kind).help;
    }
}

}  // namespace snell::glsl::log
