// Messages in the user's words, one wording for all drivers.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/log/log.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"

namespace snell::glsl::log {
namespace {

constexpr std::string_view prefix = "snell_";
constexpr std::string_view count_components = "count the components: a vec4 takes four floats, or a vec3 and a float";

// "an 'int'"; nothing for nothing.
std::string with_article(std::string_view type) {
    return type.empty() ? std::string() : fmt::format("{} '{}'", article(type), type);
}

// "unexpected NEW_IDENTIFIER, expecting ',' or ';'": what is expected, unless it is in the driver's own words.
std::string expecting(std::string_view text) {
    const std::size_t at = text.find(", expecting ");
    if (at == std::string_view::npos) return {};
    std::string_view rest = text.substr(at);
    rest = rest.substr(0, rest.find(" at token"));
    const auto capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (std::count_if(rest.begin(), rest.end(), capital) > 1) return {};
    return std::string(rest);
}

std::string syntax_message(const Entry& entry, const Place& place, const Context& context) {
    std::string_view token = entry.a;
    if (token.empty() && place.known) {
        const std::string_view text = context.sources.text(place.file);
        token = text.substr(place.span.begin, place.span.end - place.span.begin);
        if (token.find_first_of(" \t") != std::string_view::npos) token = {};  // a whole line
    }
    if (token.empty()) return "syntax error";
    return fmt::format("unexpected '{}'{}", token, expecting(entry.text));
}

// The driver's own words: no capital, no full stop, the translation's names turned back.
std::string driver_message(const Entry& entry, std::string_view user) {
    std::string text = user_words(entry.text, user);
    if (text.starts_with("Error: ")) text.erase(0, 7);
    if (text.size() > 1 && std::isupper(static_cast<unsigned char>(text[0])) != 0 &&
        std::islower(static_cast<unsigned char>(text[1])) != 0)
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    return text;
}

// In each row, the first message counts whose words the driver gave: the user's name for `a`, a and b themselves, and
// both with their articles.
constexpr KindWords kind_words[]{
    {Kind::undeclared, "glsl-undeclared", {"'{name}' is not declared"}},
    {Kind::no_function, "glsl-call", {"there is no function '{name}'", "this is not a function"}},
    {Kind::no_overload,
     "glsl-call",
     {"no function '{name}' takes ({b})", "no function '{name}' takes these arguments"}},
    {Kind::few_arguments, "glsl-call", {"too few arguments for this function"}},
    {Kind::many_arguments, "glsl-call", {"too many arguments for this function"}},
    {Kind::convert,
     "glsl-type",
     {"{an_a} cannot be assigned to {an_b}", "the value has another type than what it is assigned to"}},
    {Kind::returns,
     "glsl-type",
     {"this returns a '{a}' from a function of type '{b}'", "the value returned is no '{b}'",
      "the value returned has another type than the function"}},
    {Kind::operands,
     "glsl-type",
     {"a '{a}' and a '{b}' do not fit each other here", "the types of the two operands do not fit each other"},
     "both sides need the same number of components: '.xyz' of a vec4 goes with a vec3"},
    {Kind::condition, "glsl-type", {"a condition must be true or false"}},
    {Kind::constructor_few, "glsl-type", {"too few components for a '{name}'", "too few components"}, count_components},
    {Kind::constructor_many,
     "glsl-type",
     {"too many components for a '{name}'", "too many components"},
     count_components},
    {Kind::swizzle,
     "glsl-type",
     {"'.{name}' asks for components that the value does not have"},
     "take letters of one of xyzw, rgba and stpq, and no more of them than the value has"},
    {Kind::redeclared, "glsl-redeclared", {"'{name}' is declared twice"}},
    {Kind::read_only, "glsl-read-only", {"'{name}' cannot be assigned to", "this cannot be assigned to"}},
    {Kind::not_constant, "glsl-not-constant", {"the initial value must be a constant expression"}},
    {Kind::not_global, "glsl-syntax", {"'{name}' cannot be declared within a function"}},
    {Kind::syntax, "glsl-syntax"},
    {Kind::end_of_file, "glsl-syntax", {"the text ends in the middle of a block or statement"}},
    {Kind::if_unfinished, "glsl-syntax", {"an #if, #ifdef or #ifndef has no #endif"}},
    {Kind::no_return, "glsl-no-return", {"function '{name}' returns no value"}, "end it with 'return …;'"},
    {Kind::needs_version,
     "glsl-version",
     {"'{name}' needs a newer version of GLSL"},
     "write '#version 330 compatibility' as the first line"},
    {Kind::no_main, "glsl-no-main", {"there is no function 'main'"}},
    {Kind::no_body, "glsl-no-body", {"function '{name}' is declared but has no body"}},
    {Kind::not_written, "glsl-interface", {"input '{name}' is not written by the stage before"}},
    {Kind::types_differ, "glsl-interface"},
    {Kind::other, "glsl-driver"},
};

// Empty if the driver's words are all there is.
std::string kind_message(const Entry& entry, std::string_view name) {
    const std::string an_a = with_article(entry.a), an_b = with_article(entry.b);
    const std::pair<std::string_view, std::string_view> words[]{
        {"{name}", name}, {"{a}", entry.a}, {"{b}", entry.b}, {"{an_a}", an_a}, {"{an_b}", an_b}};
    for (const std::string_view form : words_of(entry.kind).messages) {
        const bool known = ranges::none_of(
            words, [&](const auto& word) { return word.second.empty() && form.find(word.first) != form.npos; });
        if (!form.empty() && known)
            return fmt::format(fmt::runtime(form), fmt::arg("name", name), fmt::arg("a", entry.a),
                               fmt::arg("b", entry.b), fmt::arg("an_a", an_a), fmt::arg("an_b", an_b));
    }
    return {};
}

}  // namespace

const KindWords& words_of(Kind kind) {
    const auto* found = ranges::find(kind_words, kind, &KindWords::kind);
    return found == std::end(kind_words) ? std::end(kind_words)[-1] : *found;
}

std::optional<Stage> stage_in(std::string_view text) {
    const std::string lower = lowered(text);
    std::optional<Stage> found;
    std::size_t first = std::string::npos;
    for (int i = 0; i < stage_count; ++i) {
        const auto stage = static_cast<Stage>(i);
        for (const std::string_view after : {" shader", " info"}) {
            const std::size_t at = lower.find(std::string(stage_name(stage)) + std::string(after));
            if (at >= first) continue;
            first = at;
            found = stage;
        }
    }
    return found;
}

std::string user_name(std::string_view translated, std::string_view user) {
    if (translated.starts_with(prefix)) {
        const std::string_view rest = translated.substr(prefix.size());
        if (has_word(user, translated)) return std::string(translated);
        std::string legacy = "gl_" + std::string(rest);
        if (has_word(user, legacy)) return legacy;
        const std::string_view gstap = gstap_name(legacy);
        if (!gstap.empty() && has_word(user, gstap)) return std::string(gstap);
        if (has_word(user, rest)) return std::string(rest);
        const bool built_in = !rest.empty() && std::isupper(static_cast<unsigned char>(rest[0])) != 0;
        return built_in ? legacy : std::string(rest);
    }
    // The translation writes `texture` for texture2D and the like.
    if (translated.starts_with("te") && !has_word(user, translated))
        for (const Word& word : words(user))
            if (modern_texture_function(text_of(user, word)) == translated) return std::string(text_of(user, word));
    return std::string(translated);
}

std::string user_words(std::string_view message, std::string_view user) {
    std::string result;
    for (std::size_t at = 0; at < message.size();) {
        std::size_t end = at;
        while (end < message.size() && identifier_part(message[end])) ++end;
        if (end == at) {
            result += message[at++];
            continue;
        }
        const std::string_view word = message.substr(at, end - at);
        const bool quoted_word = at > 0 && (message[at - 1] == '\'' || message[at - 1] == '(');
        result += word.starts_with(prefix) || quoted_word ? user_name(word, user) : std::string(word);
        at = end;
    }
    return result;
}

std::string message(const Misfit& misfit) {
    if (misfit.right.empty()) return fmt::format("'{}' does not take {}", misfit.op, with_article(misfit.left));
    if (misfit.op == ":=")
        return fmt::format("{} cannot be assigned to {}", with_article(misfit.right), with_article(misfit.left));
    if (misfit.op == "?:")
        return fmt::format("'? :' chooses between {} and {}", with_article(misfit.left), with_article(misfit.right));
    return fmt::format("'{}' does not take {} and {}", misfit.op, with_article(misfit.left),
                       misfit.left == misfit.right ? "another" : with_article(misfit.right));
}

std::string message(const Entry& entry, const Place& place, const Context& context) {
    const std::string_view line = place.known ? context.sources.line(place.file, place.line) : std::string_view();
    const std::string name = user_name(entry.a, line);
    if (entry.kind == Kind::syntax) return syntax_message(entry, place, context);
    if (std::string text = kind_message(entry, name); !text.empty()) return text;
    return driver_message(entry, place.known ? context.sources.text(place.file) : std::string_view());
}

}  // namespace snell::glsl::log
