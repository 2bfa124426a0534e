// Messages in the user's words, one wording for all drivers.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "parser/text/article.h"
#include "src/glsl/log/log.h"
#include "src/glsl/read/legacy.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"

namespace snell::glsl::log {
namespace {

constexpr std::string_view prefix = "snell_";

std::string pair_message(std::string_view a, std::string_view b, std::string_view with, std::string_view without) {
    if (a.empty() || b.empty()) return std::string(without);
    return fmt::format(fmt::runtime(with), a, b);
}

// "an 'int'"; nothing for nothing.
std::string with_article(std::string_view type) {
    return type.empty() ? std::string() : fmt::format("{} '{}'", article(type), type);
}

std::string named_message(std::string_view name, std::string_view with, std::string_view without) {
    if (name.empty()) return std::string(without);
    return fmt::format(fmt::runtime(with), name);
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

std::string type_message(const Entry& entry, std::string_view name) {
    switch (entry.kind) {
        case Kind::convert:
            return pair_message(with_article(entry.a), with_article(entry.b), "{} cannot be assigned to {}",
                                "the value has another type than what it is assigned to");
        case Kind::returns:
            if (entry.a.empty() && !entry.b.empty()) return fmt::format("the value returned is no '{}'", entry.b);
            return pair_message(entry.a, entry.b, "this returns a '{}' from a function of type '{}'",
                                "the value returned has another type than the function");
        case Kind::condition:
            return "a condition must be true or false";
        case Kind::operands:
            return pair_message(entry.a, entry.b, "a '{}' and a '{}' do not fit each other here",
                                "the types of the two operands do not fit each other");
        case Kind::no_overload:
            if (entry.b.empty()) return named_message(name, "no function '{}' takes these arguments", "");
            return fmt::format("no function '{}' takes ({})", name, entry.b);
        case Kind::few_arguments:
            return "too few arguments for this function";
        case Kind::many_arguments:
            return "too many arguments for this function";
        case Kind::constructor_few:
            return named_message(name, "too few components for a '{}'", "too few components");
        case Kind::constructor_many:
            return named_message(name, "too many components for a '{}'", "too many components");
        default:
            return {};
    }
}

std::string name_message(const Entry& entry, std::string_view name) {
    switch (entry.kind) {
        case Kind::undeclared:
            return fmt::format("'{}' is not declared", name);
        case Kind::no_function:
            return named_message(name, "there is no function '{}'", "this is not a function");
        case Kind::swizzle:
            return fmt::format("'.{}' asks for components that the value does not have", name);
        case Kind::redeclared:
            return fmt::format("'{}' is declared twice", name);
        case Kind::read_only:
            return named_message(name, "'{}' cannot be assigned to", "this cannot be assigned to");
        case Kind::not_constant:
            return "the initial value must be a constant expression";
        case Kind::no_return:
            return fmt::format("function '{}' returns no value", name);
        case Kind::needs_version:
            return fmt::format("'{}' needs a newer version of GLSL", name);
        case Kind::end_of_file:
            return "the text ends in the middle of a block or statement";
        case Kind::if_unfinished:
            return "an #if, #ifdef or #ifndef has no #endif";
        case Kind::no_main:
            return "there is no function 'main'";
        case Kind::no_body:
            return fmt::format("function '{}' is declared but has no body", name);
        case Kind::not_written:
            return fmt::format("input '{}' is not written by the stage before", name);
        default:
            return {};
    }
}

}  // namespace

std::optional<Stage> stage_in(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
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
    if (entry.kind != Kind::other && entry.kind != Kind::types_differ) {
        std::string text = type_message(entry, name);
        if (text.empty()) text = name_message(entry, name);
        if (!text.empty()) return text;
    }
    return driver_message(entry, place.known ? context.sources.text(place.file) : std::string_view());
}

}  // namespace snell::glsl::log
