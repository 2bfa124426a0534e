// The arguments that a command takes, written as a line of text and parsed at compile time: an invalid signature does
// not compile.
//   signature   = alternative { "|" alternative }          the first that fits is taken
//   alternative = { parameter }
//   parameter   = name [ ":" kind ] [ "=" number-or-word | "?" | "..." ]
//   kind        = number (the default) | int | path | name | vec3 | uniforms | rest | word/word/…
// "=" gives the value of an argument that is left out, "?" makes it optional, and "..." accepts any number of further
// arguments, including none. A vec3 is in brackets: [x y z]. A kind of several words is a choice; an optional one
// behind other parameters is there only if one of its words is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace snell {

enum class ArgumentKind : std::uint8_t { number, integer, path, name, choice, vec3, uniforms, rest };

struct Parameter {
    std::string_view name;
    std::string_view choices;       // of a choice, such as "on/off"
    std::string_view default_text;  // as written; empty if there is none
    double default_value = 0;
    ArgumentKind kind = ArgumentKind::number;
    bool optional = false;  // has a default, "?" or "..."
    bool repeated = false;

    constexpr bool is_keyword() const { return kind == ArgumentKind::choice && optional && default_text.empty(); }
};

inline constexpr std::size_t most_parameters = 16;
inline constexpr std::size_t most_alternatives = 3;

struct Signature {
    struct Range {
        std::uint8_t begin = 0, end = 0;
    };

    std::string_view text;
    std::array<Parameter, most_parameters> parameters{};  // of all alternatives, consecutively
    std::array<Range, most_alternatives> alternatives{};
    std::uint8_t count = 0;  // number of alternatives, at least one

    // NOLINTNEXTLINE(google-explicit-constructor): rows of the table are written as text.
    consteval Signature(const char* signature = "");

    constexpr std::size_t parameter_count(std::size_t alternative) const {
        return alternatives[alternative].end - std::size_t{alternatives[alternative].begin};
    }
    constexpr const Parameter& parameter(std::size_t alternative, std::size_t i) const {
        return parameters[alternatives[alternative].begin + i];
    }
};

namespace signature_detail {

constexpr bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
constexpr bool digit(char c) { return c >= '0' && c <= '9'; }

// Only an invalid signature calls this function. It is not constexpr, so the call stops the compilation.
inline void malformed_signature(const char*) {}

consteval double read_number(std::string_view text) {
    double value = 0, place = 1;
    bool negative = false, point = false, any = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i == 0 && text[i] == '-') {
            negative = true;
        } else if (text[i] == '.' && !point) {
            point = true;
        } else if (digit(text[i])) {
            any = true;
            value = value * 10 + (text[i] - '0');
            if (point) place *= 10;
        } else {
            malformed_signature("a default is a decimal number");
        }
    }
    if (!any) malformed_signature("a default has no digits");
    return (negative ? -value : value) / place;
}

consteval ArgumentKind read_kind(std::string_view text) {
    if (text.find('/') != std::string_view::npos) return ArgumentKind::choice;
    if (text == "number") return ArgumentKind::number;
    if (text == "int") return ArgumentKind::integer;
    if (text == "path") return ArgumentKind::path;
    if (text == "name") return ArgumentKind::name;
    if (text == "vec3") return ArgumentKind::vec3;
    if (text == "uniforms") return ArgumentKind::uniforms;
    if (text == "rest") return ArgumentKind::rest;
    malformed_signature("unknown kind of argument");
    return ArgumentKind::rest;
}

consteval void read_choices(std::string_view text) {
    bool word = false;
    for (const char c : text) {
        if (c == '/' && !word) malformed_signature("a choice without a name");
        if (c != '/' && !letter(c) && !digit(c)) malformed_signature("a choice is a word");
        word = c != '/';
    }
    if (!word) malformed_signature("a choice without a name");
}

consteval bool is_choice(std::string_view choices, std::string_view word) {
    while (!choices.empty()) {
        const std::size_t end = choices.find('/');
        if (choices.substr(0, end) == word) return true;
        choices = end == std::string_view::npos ? std::string_view{} : choices.substr(end + 1);
    }
    return false;
}

consteval Parameter read_parameter(std::string_view text) {
    Parameter p;
    std::size_t i = 0;
    while (i < text.size() && (letter(text[i]) || (i > 0 && digit(text[i])))) ++i;
    p.name = text.substr(0, i);
    if (p.name.empty()) malformed_signature("a parameter without a name");
    if (i < text.size() && text[i] == ':') {
        const std::size_t begin = ++i;
        while (i < text.size() && (letter(text[i]) || digit(text[i]) || text[i] == '/')) ++i;
        p.kind = read_kind(text.substr(begin, i - begin));
        if (p.kind == ArgumentKind::choice) {
            p.choices = text.substr(begin, i - begin);
            read_choices(p.choices);
        }
    }
    const std::string_view rest = text.substr(i);
    const bool numeric = p.kind == ArgumentKind::number || p.kind == ArgumentKind::integer;
    if (rest == "?") {
        p.optional = true;
    } else if (rest == "...") {
        p.optional = p.repeated = true;
    } else if (rest.starts_with("=")) {
        p.default_text = rest.substr(1);
        p.optional = true;
        if (numeric) {
            p.default_value = read_number(p.default_text);
        } else if (p.kind != ArgumentKind::choice || !is_choice(p.choices, p.default_text)) {
            malformed_signature("only numbers and choices have defaults");
        }
    } else if (!rest.empty()) {
        malformed_signature("a parameter may only be followed by =, ? or ...");
    }
    if (p.kind == ArgumentKind::rest || p.kind == ArgumentKind::uniforms) p.optional = true;
    return p;
}

}  // namespace signature_detail

consteval Signature::Signature(const char* signature) : text(signature) {
    using signature_detail::malformed_signature;
    std::size_t used = 0, i = 0;
    bool open_ended = false, optional = false;
    const auto end_alternative = [&](std::size_t begin) {
        if (count == most_alternatives) malformed_signature("too many alternatives");
        alternatives[count++] = {static_cast<std::uint8_t>(begin), static_cast<std::uint8_t>(used)};
    };
    std::size_t begin = 0;
    while (i < text.size()) {
        if (text[i] == ' ') {
            ++i;
            continue;
        }
        if (text[i] == '|') {
            end_alternative(begin);
            begin = used;
            open_ended = optional = false;
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && text[end] != ' ' && text[end] != '|') ++end;
        if (used == most_parameters) malformed_signature("too many parameters");
        if (open_ended) malformed_signature("nothing can follow ..., uniforms or rest");
        const Parameter p = signature_detail::read_parameter(text.substr(i, end - i));
        if (optional && !p.optional) malformed_signature("required parameters must precede optional ones");
        open_ended = p.repeated || p.kind == ArgumentKind::rest || p.kind == ArgumentKind::uniforms;
        optional = p.optional;
        for (std::size_t j = begin; j < used; ++j)
            if (parameters[j].name == p.name) malformed_signature("two parameters have the same name");
        parameters[used++] = p;
        i = end;
    }
    end_alternative(begin);
}

// The table of commands, with one row for each. The matcher, the documentation, the editors' grammars, suggestions and
// the fuzzer's dictionary are derived from it.
// Commands of OpenGL and its helpers that the language lacks, and what does their work in a scene.

class Builder;
class Arguments;

using Handler = void (*)(Builder&, const Arguments&);

struct Command {
    std::string_view name;
    Signature signature;
    std::string_view doc;  // one or more sentences
    Handler handler;
    std::string_view alias = {};
    bool addition = false;        // not a command of glman
    std::string_view group = {};  // heading in docs/language.md

    constexpr bool takes(ArgumentKind kind) const {
        for (const Parameter& p : signature.parameters)
            if (!p.name.empty() && p.kind == kind) return true;
        return false;
    }
};

std::span<const Command> commands();

// Finds a command by name or alias, without regard to case; returns nullptr if there is none.
const Command* find_command(std::string_view word);

// Every name and alias, for suggestions.
const std::vector<std::string_view>& command_names();

// Returns the table as JSON: names, aliases, signatures, arguments with kinds and defaults, documentation.
std::string commands_json();

// What to write for a statement of OpenGL ("glEnable GL_BLEND", "ShadeModel GL_FLAT"), or why there is nothing to
// write; empty for other words.
std::string help_for_opengl(std::string_view word, std::string_view argument);

}  // namespace snell
