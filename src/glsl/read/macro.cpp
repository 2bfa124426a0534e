#include "src/glsl/read/macro.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "parser/text/words.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

void Macros::undefine(std::string_view name) {
    if (const auto it = macros_.find(name); it != macros_.end()) macros_.erase(it);
}

const Macro* Macros::find(std::string_view name) const {
    const auto it = macros_.find(name);
    return it == macros_.end() ? nullptr : &it->second;
}

// What the shader's own version would have defined. Extensions that the translation makes superfluous count as
// there; those of one vendor do not.
std::optional<long long> Macros::predefined(std::string_view name) {
    if (name == "__LINE__") return line_;
    if (name == "__FILE__") return 0;
    asked_context_ = asked_context_ || name == "__VERSION__" || name.starts_with("GL_");
    if (name == "__VERSION__") return version_;
    const bool there = name == "GL_ES"                      ? profile_ == "es"
                       : name == "GL_compatibility_profile" ? profile_ == "compatibility"
                       : name == "GL_core_profile"
                           ? version_ >= 150 && profile_ != "compatibility" && profile_ != "es"
                           : name.starts_with("GL_ARB_") || name == "GL_FRAGMENT_PRECISION_HIGH" ||
                                 name == "GL_EXT_gpu_shader4" || name == "GL_EXT_geometry_shader4" ||
                                 name == "GL_OES_standard_derivatives" || name == "GL_EXT_texture_array";
    return there ? std::optional(1LL) : std::nullopt;
}

bool Macros::defined(std::string_view name) { return find(name) || predefined(name); }

std::vector<MacroToken> macro_tokens(std::string_view text) {
    std::vector<MacroToken> out;
    for (std::size_t i = skip_trivia(text, 0).end; i < text.size(); i = skip_trivia(text, i).end) {
        const Lexeme lexeme = lex(text, i);
        out.push_back({lexeme.kind, lexeme.text});
        i += lexeme.text.size();
    }
    return out;
}

bool Macros::expand(const std::vector<MacroToken>& in, std::vector<MacroToken>& out) {
    std::vector<std::string_view> active;
    misused_.clear();
    return expand(in, out, active);
}

namespace {

struct MacroArguments {
    std::vector<std::vector<MacroToken>> each;
    std::size_t end = 0;  // behind the closing parenthesis
};

// The arguments whose opening parenthesis is at in[i]; nothing if none closes it. Only parentheses protect commas.
std::optional<MacroArguments> read_arguments(const std::vector<MacroToken>& in, std::size_t i) {
    MacroArguments arguments{{{}}, i};
    for (int depth = 0; i < in.size(); ++i) {
        const std::string_view t = in[i].text;
        if (t == "(") {
            if (depth++ == 0) continue;
        } else if (t == ")") {
            if (--depth == 0) {
                arguments.end = i + 1;
                return arguments;
            }
        } else if (t == "," && depth == 1) {
            arguments.each.emplace_back();
            continue;
        }
        arguments.each.back().push_back(in[i]);
    }
    return std::nullopt;
}

// "" or what is wrong. F() is a call with one argument, which is empty, or with none.
std::string misuse(std::string_view name, const Macro& macro, const MacroArguments& arguments) {
    const std::size_t takes = macro.parameters.size(), given = arguments.each.size();
    if (takes == given || (takes == 0 && given == 1 && arguments.each.front().empty())) return {};
    return fmt::format("the macro '{}' takes {}, not {}", name, counted(takes, "argument"), given);
}

}  // namespace

bool Macros::expand(const std::vector<MacroToken>& in, std::vector<MacroToken>& out,
                    std::vector<std::string_view>& active) {
    if (active.size() > 64) return false;
    for (std::size_t i = 0; i < in.size();) {
        if (budget_ == 0) return false;
        --budget_;
        const MacroToken& t = in[i];
        const Macro* macro = t.kind == Kind::identifier && !t.frozen ? find(t.text) : nullptr;
        if (macro && std::find(active.begin(), active.end(), t.text) != active.end()) {
            out.push_back({t.kind, t.text, true});
            ++i;
            continue;
        }
        const bool called = macro && macro->function && i + 1 < in.size() && in[i + 1].text == "(";
        const auto arguments = called ? read_arguments(in, i + 1) : std::nullopt;
        if (!macro || (macro->function && !arguments)) {
            uncalled_ = uncalled_ || (macro && !called);
            out.push_back(t);
            ++i;
            continue;
        }
        if (arguments) misused_ = misuse(t.text, *macro, *arguments);
        if (!misused_.empty()) return false;
        std::size_t next = arguments ? arguments->end : i + 1;
        std::vector<MacroToken> replaced;
        if (!substitute(*macro, arguments ? arguments->each : decltype(arguments->each){}, replaced, active))
            return false;
        active.push_back(t.text);
        // A function-like macro's name at the end takes its arguments from what follows.
        const Macro* last = replaced.empty() ? nullptr : find(replaced.back().text);
        if (last && last->function && next < in.size() && in[next].text == "(")
            if (const auto following = read_arguments(in, next)) {
                replaced.insert(replaced.end(), in.begin() + static_cast<std::ptrdiff_t>(next),
                                in.begin() + static_cast<std::ptrdiff_t>(following->end));
                next = following->end;
            }
        const bool fine = expand(replaced, out, active);
        active.pop_back();
        if (!fine) return false;
        i = next;
    }
    return true;
}

bool Macros::substitute(const Macro& macro, const std::vector<std::vector<MacroToken>>& arguments,
                        std::vector<MacroToken>& out, std::vector<std::string_view>& active) {
    std::vector<std::vector<MacroToken>> expanded(arguments.size());
    std::vector<bool> done(arguments.size(), false);
    auto parameter = [&](const MacroToken& t) -> std::ptrdiff_t {
        if (t.kind != Kind::identifier) return -1;
        const auto it = std::find(macro.parameters.begin(), macro.parameters.end(), t.text);
        const auto n = it - macro.parameters.begin();
        return it == macro.parameters.end() || static_cast<std::size_t>(n) >= arguments.size() ? -1 : n;
    };
    for (std::size_t k = 0; k < macro.body.size(); ++k) {
        if (out.size() > budget_) return false;
        const bool pastes = k + 1 < macro.body.size() && macro.body[k + 1].text == "##";
        const bool after_paste = k > 0 && macro.body[k - 1].text == "##";
        if (macro.body[k].text == "##" && !out.empty() && k + 1 < macro.body.size()) {
            pasted_ = true;
            const std::ptrdiff_t n = parameter(macro.body[k + 1]);
            const MacroToken* right = &macro.body[k + 1];
            if (n >= 0)
                right = arguments[static_cast<std::size_t>(n)].empty()
                            ? nullptr
                            : &arguments[static_cast<std::size_t>(n)].front();
            if (right) {
                const std::string& glued = arena_.emplace_back(std::string(out.back().text) + std::string(right->text));
                const Lexeme lexeme = lex(glued, 0);
                out.back() = {lexeme.kind, lexeme.text};
            }
            if (n >= 0 && arguments[static_cast<std::size_t>(n)].size() > 1) {
                const auto& argument = arguments[static_cast<std::size_t>(n)];
                out.insert(out.end(), argument.begin() + 1, argument.end());
            }
            continue;
        }
        if (after_paste) continue;
        const std::ptrdiff_t n = parameter(macro.body[k]);
        if (n < 0) {
            out.push_back(macro.body[k]);
            continue;
        }
        const auto a = static_cast<std::size_t>(n);
        if (pastes) {
            out.insert(out.end(), arguments[a].begin(), arguments[a].end());
            continue;
        }
        if (!done[a] && !expand(arguments[a], expanded[a], active)) return false;
        done[a] = true;
        out.insert(out.end(), expanded[a].begin(), expanded[a].end());
    }
    return true;
}

namespace {

// Evaluates by precedence climbing, as the preprocessor of C does.
struct Condition {
    const std::vector<MacroToken>& tokens;
    std::size_t at = 0;
    bool failed = false;
    int depth = 0;

    std::string_view peek() const { return at < tokens.size() ? tokens[at].text : std::string_view(); }

    static int level_of(std::string_view op) { return op == "^^" ? 0 : precedence(op); }

    long long apply(std::string_view op, long long a, long long b) {
        const auto ua = static_cast<unsigned long long>(a), ub = static_cast<unsigned long long>(b);
        if (op == "||") return a || b;
        if (op == "&&") return a && b;
        if (op == "|") return a | b;
        if (op == "^") return a ^ b;
        if (op == "&") return a & b;
        if (op == "==") return a == b;
        if (op == "!=") return a != b;
        if (op == "<") return a < b;
        if (op == ">") return a > b;
        if (op == "<=") return a <= b;
        if (op == ">=") return a >= b;
        if (op == "<<") return static_cast<long long>(ub < 64 ? ua << ub : 0);
        if (op == ">>") return static_cast<long long>(ub < 64 ? ua >> ub : 0);
        if (op == "+") return static_cast<long long>(ua + ub);
        if (op == "-") return static_cast<long long>(ua - ub);
        if (op == "*") return static_cast<long long>(ua * ub);
        if (b == 0 || b == -1) {
            failed = failed || b == 0;
            return op == "/" ? static_cast<long long>(0 - ua) : 0;
        }
        return op == "/" ? a / b : a % b;
    }

    long long unary() {
        if (++depth > 200) failed = true;
        if (failed) return 0;
        const std::string_view t = peek();
        long long value = 0;
        if (t == "!" || t == "-" || t == "~" || t == "+") {
            ++at;
            value = unary();
            const auto u = static_cast<unsigned long long>(value);
            if (t == "!") value = !value;
            if (t == "-") value = static_cast<long long>(0 - u);
            if (t == "~") value = ~value;
        } else if (t == "(") {
            ++at;
            value = binary(1);
            if (peek() == ")") {
                ++at;
            } else {
                failed = true;
            }
        } else if (at < tokens.size() && tokens[at].kind == Kind::integer) {
            std::string_view digits = t;
            int base = 10;
            if (digits.starts_with("0x") || digits.starts_with("0X")) {
                base = 16;
                digits.remove_prefix(2);
            } else if (digits.size() > 1 && digits.front() == '0') {
                base = 8;
            }
            std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
            ++at;
        } else if (at < tokens.size() && tokens[at].kind == Kind::identifier) {
            ++at;  // not defined: 0
        } else {
            failed = true;
        }
        --depth;
        return value;
    }

    long long binary(int least) {
        long long left = unary();
        for (int level = level_of(peek()); level >= least && level > 0 && !failed; level = level_of(peek())) {
            const std::string_view op = tokens[at++].text;
            left = apply(op, left, binary(level + 1));
        }
        return left;
    }
};

}  // namespace

std::optional<bool> Macros::condition(std::string_view text, int line) {
    line_ = line;
    static constexpr std::string_view yes = "1", no = "0";
    const std::vector<MacroToken> raw = macro_tokens(text);
    std::vector<MacroToken> in;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i].text != "defined") {
            in.push_back(raw[i]);
            continue;
        }
        const bool bracketed = i + 1 < raw.size() && raw[i + 1].text == "(";
        const std::size_t name = i + (bracketed ? 2 : 1);
        if (name >= raw.size()) return std::nullopt;
        in.push_back({Kind::integer, defined(raw[name].text) ? yes : no});
        i = name + (bracketed ? 1 : 0);
    }
    std::vector<MacroToken> out;
    if (!expand(in, out)) return std::nullopt;
    for (MacroToken& t : out) {
        if (t.kind != Kind::identifier) continue;
        if (const auto value = predefined(t.text)) t = {Kind::integer, arena_.emplace_back(std::to_string(*value))};
    }
    Condition condition{out};
    const long long value = condition.binary(1);
    if (condition.failed || condition.at < out.size()) return std::nullopt;
    return value != 0;
}

}  // namespace snell::glsl
