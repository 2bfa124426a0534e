// What would help: hints for the mistakes that students make most.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "src/glsl/log.h"

namespace snell::glsl::log {
namespace {

bool equal_but_case(std::string_view a, std::string_view b) {
    const auto same = [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
    };
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same);
}

// Components of a float vector type or of float: 1 to 4; 0 for others.
int components(std::string_view type) {
    if (type == "float") return 1;
    if (type.size() == 4 && type.starts_with("vec") && type[3] >= '2' && type[3] <= '4') return type[3] - '0';
    return 0;
}

std::string conversion_help(std::string_view from, std::string_view to) {
    const int have = components(from), want = components(to);
    if (have > want && want >= 1) {
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

// The declaration whose name is nearest to `name`: equal but for capitals first, then uniforms that nothing uses.
const Declared* nearest_declared(std::string_view name, const std::vector<Declared>& all) {
    std::vector<std::string_view> names, unused;
    for (const Declared& d : all) {
        if (d.name == name) continue;
        if (equal_but_case(d.name, name)) return &d;
        names.push_back(d.name);
        if (d.qualifier == "uniform" && d.uses == 0) unused.push_back(d.name);
    }
    std::string_view best = nearest(name, unused);
    if (best.empty()) best = nearest(name, names);
    if (best.empty()) return nullptr;
    return &*std::find_if(all.begin(), all.end(), [&](const Declared& d) { return d.name == best; });
}

const StageOutput* stage_of(const Translation& translation, std::optional<Stage> stage) {
    for (const StageOutput& s : translation.stages)
        if (stage && s.stage == *stage) return &s;
    return nullptr;
}

// `name` as an output of another stage: the input was forgotten here.
bool hint_other_stage(std::string_view name, const Context& context, Diagnostic& diagnostic) {
    for (const StageOutput& other : context.translation.stages) {
        if (&other == context.stage || (context.stage && other.stage == context.stage->stage)) continue;
        for (const FileId file : other.files)
            for (const Declared& d : declared(context.sources.text(file))) {
                if (d.name != name || d.qualifier.empty() || d.qualifier == "const") continue;
                const bool passed = d.qualifier == "out" || d.qualifier == "varying";
                const std::string_view here = passed && d.qualifier == "out" ? "in" : d.qualifier;
                diagnostic.help = fmt::format("declare it in this shader too: {} {} {};", here, d.type, name);
                diagnostic.notes.push_back(
                    {span_of(file, d), fmt::format("the {} shader declares it here", stage_word(other.stage))});
                return true;
            }
    }
    return false;
}

void hint_undeclared(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known) return;
    const std::vector<Declared> all = declared(context.sources.text(place.file));
    for (const Declared& d : all) {
        if (d.name != name) continue;
        const bool later = d.begin > place.span.begin;
        diagnostic.help =
            later ? "declare it before its first use" : "a name holds only inside the { } where it is declared";
        diagnostic.notes.push_back({span_of(place.file, d), "declared here"});
        return;
    }
    if (const Declared* d = nearest_declared(name, all)) {
        const bool unused = d->qualifier == "uniform" && d->uses == 0;
        diagnostic.help = fmt::format("did you mean '{}'?", d->name);
        diagnostic.notes.push_back(
            {span_of(place.file, *d), unused ? "this uniform is declared but never used" : "declared here"});
        return;
    }
    if (hint_other_stage(name, context, diagnostic)) return;
    if (const std::string_view built_in = nearest(name, builtin_names()); !built_in.empty() && built_in != name)
        diagnostic.help = fmt::format("did you mean '{}'?", built_in);
}

int count_arguments(std::string_view list) {
    return list.empty() ? 0 : 1 + static_cast<int>(std::count(list.begin(), list.end(), ','));
}

void hint_call(const Entry& entry, std::string_view name, const Place& place, const Context& context,
               Diagnostic& diagnostic) {
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
    for (const Declared& d : declared(context.sources.text(place.file))) {
        if (d.name != name || !d.function) continue;
        diagnostic.notes.push_back({span_of(place.file, d), "this one is declared here"});
        known = true;
    }
    if (!known) hint_undeclared(name, place, context, diagnostic);
}

bool ends_operand(std::string_view word) {
    const char c = word.empty() ? ' ' : word.back();
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ')' || c == ']' || c == '.';
}

// Names of types that other languages have.
std::string_view foreign_type(std::string_view name) {
    for (const std::string_view base : {"float", "half", "fixed"})
        if (name.starts_with(base) && name.size() == base.size() + 1) switch (name.back()) {
                case '2':
                    return "vec2";
                case '3':
                    return "vec3";
                case '4':
                    return "vec4";
            }
    if (name == "half" || name == "fixed" || name == "real") return "float";
    if (name == "float3x3") return "mat3";
    if (name == "float4x4") return "mat4";
    return {};
}

// `vex3 a`: two names in a row, of which the first is no type.
bool hint_unknown_type(std::string_view type, const Span& span, Diagnostic& diagnostic) {
    std::string_view meant = foreign_type(type);
    if (meant.empty()) {
        meant = nearest(type, {"float",       "int",   "uint",    "bool",    "void",      "double",    "vec2",
                               "vec3",        "vec4",  "ivec2",   "ivec3",   "ivec4",     "bvec2",     "bvec3",
                               "bvec4",       "mat2",  "mat3",    "mat4",    "sampler1D", "sampler2D", "sampler3D",
                               "samplerCube", "const", "uniform", "varying", "attribute", "return"});
    }
    if (meant.empty() || meant == type) return false;
    diagnostic.message.replace(0, diagnostic.message.find(" ("), fmt::format("'{}' is not a type", type));
    diagnostic.help = fmt::format("did you mean '{}'?", meant);
    diagnostic.span = span;
    return true;
}

// The words before the place: is a semicolon missing at the end of a line, is a bracket not closed?
void hint_syntax(const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known) return;
    const std::string_view text = context.sources.text(place.file);
    const std::vector<Word> all = words(text);
    std::size_t at = 0;
    while (at < all.size() && all[at].begin < place.span.begin) ++at;
    if (at < all.size()) {
        int parens = 0;
        for (std::size_t i = at; i-- > 0;) {
            const std::string_view w = text_of(text, all[i]);
            if (all[i].directive || w == ";" || w == "{" || w == "}") break;
            parens += w == "(" ? 1 : w == ")" ? -1 : 0;
        }
        const Word* before = at > 0 ? &all[at - 1] : nullptr;
        const std::string_view here = text_of(text, all[at]);
        if (here == ";" && parens > 0) diagnostic.help = "a ')' is missing before the ';'";
        if (parens < 0 || (here == ")" && parens == 0)) diagnostic.help = "there are more ')' than '('";
        if (before && !before->directive && before->line < all[at].line && parens == 0 && here != "{" &&
            ends_operand(text_of(text, *before))) {
            diagnostic.help = fmt::format("line {} seems to lack a ';' at its end", before->line);
            diagnostic.notes.push_back({{place.file, before->end - 1, before->end}, "a ';' is missing after this"});
            return;
        }
        if (before && before->name && all[at].name && before->line == all[at].line &&
            hint_unknown_type(text_of(text, *before), {place.file, before->begin, before->end}, diagnostic))
            return;
    }
    const std::size_t brace = unclosed_brace(text);
    if (brace != std::string_view::npos && brace < place.span.begin && diagnostic.help.empty()) {
        const auto offset = static_cast<std::uint32_t>(brace);
        diagnostic.notes.push_back({{place.file, offset, offset + 1}, "this '{' is never closed"});
    } else if (at < all.size() && text_of(text, all[at]) == "}" && diagnostic.help.empty()) {
        diagnostic.help = "there are more '}' than '{'";
    }
}

void hint_end_of_file(const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known) return;
    const std::size_t brace = unclosed_brace(context.sources.text(place.file));
    if (brace == std::string_view::npos) {
        diagnostic.help = "the last statement lacks its end: a ';', a ')' or a body in { }";
        return;
    }
    const auto offset = static_cast<std::uint32_t>(brace);
    diagnostic.notes.push_back({diagnostic.span, "the text ends here"});
    diagnostic.span = {place.file, offset, offset + 1};
    diagnostic.message.replace(0, diagnostic.message.find(" ("), "this '{' is never closed");
    diagnostic.help = "close it with '}'";
}

void hint_no_main(const Entry& entry, const Context& context, Diagnostic& diagnostic) {
    const StageOutput* stage = context.stage ? context.stage : stage_of(context.translation, entry.stage);
    if (!stage || stage->files.empty()) return;
    diagnostic.help = "every shader starts at 'void main()'";
    for (const FileId file : stage->files)
        for (const Declared& d : declared(context.sources.text(file))) {
            if (!d.function || nearest("main", {d.name}).empty()) continue;
            diagnostic.span = span_of(file, d);
            diagnostic.help = fmt::format("did you mean 'main' instead of '{}'?", d.name);
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
            for (const Declared& d : declared(text))
                if (d.qualifier == "out" || d.qualifier == "varying") outputs.push_back(d);
            const Declared* d = nearest_declared(user_name(entry.a, text), outputs);
            if (!d) continue;
            diagnostic.help = fmt::format("the {} shader calls it '{}': the names must agree, capitals included",
                                          stage_word(s.stage), d->name);
            diagnostic.notes.push_back({span_of(file, *d), "the output is declared here"});
            return;
        }
    }
}

// Where else the same variable is declared.
void hint_types_differ(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic) {
    for (const StageOutput& s : context.translation.stages)
        for (const FileId file : s.files)
            for (const Declared& d : declared(context.sources.text(file))) {
                if (d.name != name || d.qualifier.empty() || span_of(file, d) == place.span) continue;
                diagnostic.notes.push_back(
                    {span_of(file, d), fmt::format("the {} shader says '{}' here", stage_word(s.stage), d.type)});
            }
    diagnostic.help = "declare it with the same type in every shader of the program";
}

void hint_redeclared(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known) return;
    for (const Declared& d : declared(context.sources.text(place.file)))
        if (d.name == name && d.begin < place.span.begin) {
            diagnostic.notes.push_back({span_of(place.file, d), "first declared here"});
            return;
        }
}

void hint_read_only(std::string_view name, const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known || name.empty()) return;
    for (const Declared& d : declared(context.sources.text(place.file))) {
        if (d.name != name || d.qualifier.empty()) continue;
        diagnostic.help =
            fmt::format("'{}' is declared as '{}': copy it to a variable of its own first", name, d.qualifier);
        diagnostic.notes.push_back({span_of(place.file, d), "declared here"});
        return;
    }
}

}  // namespace

void hint(const Entry& entry, const Place& place, const Context& context, Diagnostic& diagnostic) {
    const std::string_view line = place.known ? context.sources.line(place.file, place.line) : std::string_view();
    const std::string name = user_name(entry.a, line);
    switch (entry.kind) {
        case Kind::undeclared:
            return hint_undeclared(name, place, context, diagnostic);
        case Kind::no_function:
        case Kind::no_overload:
            return hint_call(entry, name, place, context, diagnostic);
        case Kind::convert:
        case Kind::returns:
            diagnostic.help = conversion_help(entry.a, entry.b);
            return;
        case Kind::operands:
            diagnostic.help = "both sides need the same number of components: '.xyz' of a vec4 goes with a vec3";
            return;
        case Kind::redeclared:
            return hint_redeclared(name, place, context, diagnostic);
        case Kind::read_only:
            return hint_read_only(name, place, context, diagnostic);
        case Kind::syntax:
            return hint_syntax(place, context, diagnostic);
        case Kind::end_of_file:
            return hint_end_of_file(place, context, diagnostic);
        case Kind::needs_version:
            diagnostic.help = "write '#version 330 compatibility' as the first line";
            return;
        case Kind::no_main:
            return hint_no_main(entry, context, diagnostic);
        case Kind::not_written:
            return hint_not_written(entry, context, diagnostic);
        case Kind::types_differ:
            return hint_types_differ(name, place, context, diagnostic);
        case Kind::constructor_few:
        case Kind::constructor_many:
            diagnostic.help = "count the components: a vec4 takes four floats, or a vec3 and a float";
            return;
        case Kind::no_return:
            diagnostic.help = "end it with 'return …;'";
            return;
        case Kind::few_arguments:
        case Kind::many_arguments:
        case Kind::swizzle:
        case Kind::not_constant:
        case Kind::if_unfinished:
        case Kind::no_body:
        case Kind::other:
        case Kind::noise:
            return;
    }
}

}  // namespace snell::glsl::log
