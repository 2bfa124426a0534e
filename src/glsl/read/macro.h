// Macro definitions, their expansion, and the conditions of #if.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/glsl/read/lexer.h"

namespace snell::glsl {

struct MacroToken {
    Kind kind = Kind::other;
    std::string_view text;
    bool frozen = false;  // no longer expanded: found inside its own expansion
};

struct Macro {
    bool function = false;
    std::vector<std::string_view> parameters;
    std::vector<MacroToken> body;
};

class Macros {
public:
    using Arena = std::deque<std::string>;
    explicit Macros(Arena& arena) : arena_(arena) {}
    void set_version(int version, std::string_view profile) { version_ = version, profile_ = profile; }

    void define(std::string_view name, Macro macro) { macros_.insert_or_assign(std::string(name), std::move(macro)); }
    void undefine(std::string_view name);
    const Macro* find(std::string_view name) const;
    bool defined(std::string_view name);  // the operator of #if
    void note_uncalled() { uncalled_ = true; }

    // Replaces macros in `in` until none is left. Gives up, returning false, past a bound on size or depth, and where a
    // macro has another number of arguments than it takes: then `misused` says so.
    bool expand(const std::vector<MacroToken>& in, std::vector<MacroToken>& out);
    const std::string& misused() const { return misused_; }
    // The value of the condition; nothing where it is malformed.
    std::optional<bool> condition(std::string_view text, int line);

    // True when a condition asked for what the context would answer differently: __VERSION__, GL_….
    bool asked_context() const { return asked_context_; }
    // True when pasting with ## took place.
    bool pasted() const { return pasted_; }
    // True when a macro with parameters was named without arguments. Mesa reads a text to its end then, in search of
    // what closes them.
    bool uncalled() const { return uncalled_; }

private:
    bool expand(const std::vector<MacroToken>& in, std::vector<MacroToken>& out, std::vector<std::string_view>& active);
    bool substitute(const Macro& macro, const std::vector<std::vector<MacroToken>>& arguments,
                    std::vector<MacroToken>& out, std::vector<std::string_view>& active);
    std::optional<long long> predefined(std::string_view name);

    Arena& arena_;
    std::map<std::string, Macro, std::less<>> macros_;
    int version_ = 110;
    std::string_view profile_;
    int line_ = 1;
    std::size_t budget_ = 200'000;
    bool asked_context_ = false;
    bool pasted_ = false;
    bool uncalled_ = false;
    std::string misused_;
};

std::vector<MacroToken> macro_tokens(std::string_view text);

}  // namespace snell::glsl
