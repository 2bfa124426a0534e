#include "src/glsl/read/lexer.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "parser/read/parse.h"
#include "src/glsl/read/macro.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

namespace {

constexpr std::size_t token_limit = 2'000'000;

// ---- what C compilers let pass, and what hides more of a shader than its author saw
std::string_view past_blanks(std::string_view line) {
    return line.substr(std::min(line.find_first_not_of(" \t\v\f\r"), line.size()));
}

// Nothing is lost with a line that is empty, or a comment too.
bool harmless(std::string_view next) {
    next = past_blanks(next);
    return next.empty() || next.starts_with("//");
}

void check_continued(std::string_view text, Span comment, Diagnostics& diagnostics) {
    const std::string_view whole = text.substr(comment.begin, comment.end - comment.begin);
    // An author who turns `#define F(x) \` into a comment means its next lines, too.
    const std::size_t slashes = whole.find_first_not_of('/');
    if (slashes == std::string_view::npos || past_blanks(whole.substr(slashes)).starts_with('#')) return;
    for (std::size_t end = whole.find('\n'); end != std::string_view::npos; end = whole.find('\n', end + 1)) {
        const std::string_view rest = whole.substr(end + 1);
        if (harmless(rest.substr(0, rest.find('\n')))) continue;
        const auto at = comment.begin + static_cast<std::uint32_t>(whole.rfind('\\', end));
        diagnostics.warning("comment-continued", {comment.file, at, at + 1},
                            "this '\\' makes the next line a part of the comment",
                            "remove it, or put another character after it");
        return;
    }
}

// Reports a comment `/*` that nothing closes, and a backslash that makes the next line a part of a comment `//`.
void check_comments(std::string_view text, FileId file, Diagnostics& diagnostics) {
    for (std::size_t i = text.find('/'); i != std::string_view::npos; i = text.find('/', i)) {
        const std::size_t begin = i;
        const auto span_to = [&](std::size_t end) {
            return Span{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        };
        const std::string_view opening = text.substr(begin, 2);
        if (opening == "//") {
            i = line_comment_end(text, begin);
            check_continued(text, span_to(i), diagnostics);
        } else if (opening == "/*") {
            const std::size_t close = text.find("*/", begin + 2);
            if (close == std::string_view::npos) {
                diagnostics.error("unclosed-comment", span_to(begin + 2), "this comment is never closed",
                                  "write '*/' where it ends");
                return;
            }
            i = close + 2;
        } else {
            ++i;
        }
    }
}

// Reports words behind `#else` or `#endif`, and returns how many bytes of `rest`, which follows the directive's name in
// the text, come before them: all if there are none.
std::size_t before_surplus(std::string_view name, std::string_view rest, Span place, Diagnostics& diagnostics) {
    const std::vector<MacroToken> tokens = macro_tokens(rest);
    // `#else if` means more than `#else`: that is for the driver to refuse.
    if ((name != "else" && name != "endif") || tokens.empty() || tokens.front().text == "if") return rest.size();
    const std::string_view first = tokens.front().text, last = tokens.back().text;
    const auto begin = static_cast<std::size_t>(first.data() - rest.data());
    const auto end = static_cast<std::size_t>(last.data() + last.size() - rest.data());
    const auto at = static_cast<std::uint32_t>(place.end - rest.size());
    const Span words{place.file, static_cast<std::uint32_t>(at + begin), static_cast<std::uint32_t>(at + end)};
    Diagnostic& said = diagnostics.warning(
        "surplus-words", words, "nothing may follow #" + std::string(name) + ": the rest of the line is ignored",
        "make it a comment: //");
    if (rest.find('\n', begin) == rest.npos) said.fixes = {{{words.file, words.begin, words.begin}, "// "}};
    return begin;
}

// ----
class Preprocessor {
public:
    Preprocessor(Unit& unit, Sources& sources, const Options& options, Diagnostics& diagnostics)
        : unit_(unit), sources_(sources), options_(options), diagnostics_(diagnostics), macros_(unit.arena) {}

    void run(FileId file) {
        // Tokens refer to their texts, and the unit outlives the options.
        for (const Define& d : options_.defines) macros_.define(d.name, {false, {}, macro_tokens(unit_.keep(d.value))});
        file_name_.push_back(std::string(sources_.name(file)));
        read(file);
        broken_ = broken_ || !conditionals_.empty();
        for (const Conditional& c : conditionals_)
            diagnostics_.warning("unterminated-conditional", c.span, "this conditional has no #endif");
        Token end;
        end.file = 0;
        end.offset = static_cast<std::uint32_t>(sources_.text(file).size());
        end.lead = take_lead(text_.size());
        unit_.tokens.push_back(end);
    }
    // True if only the expanded form has the meaning of the text.
    bool must_expand() const {
        return macros_.asked_context() || macros_.pasted() || macros_.uncalled() || shadows_language_ || broken_;
    }

private:
    struct Conditional {
        Span span;
        bool active, taken, outer, had_else;
    };

    void read(FileId file);
    void token();
    void directive(std::size_t start);
    void perform(std::string_view name, std::string_view rest, std::size_t start, std::size_t end);
    void conditional(std::string_view name, std::string_view rest, std::size_t start, std::size_t end);
    void define(std::string_view rest);
    void include(std::string_view rest, std::size_t start, std::size_t end);
    bool guarded(std::string_view text) const;
    void version(std::string_view rest, std::size_t start, std::size_t end);
    void extension(std::string_view rest, std::size_t start, std::size_t end);
    bool invocation(const Lexeme& name);
    std::optional<std::size_t> arguments_end(std::size_t from) const;

    bool active() const { return conditionals_.empty() || conditionals_.back().active; }
    int line_of(std::size_t offset) const {
        return sources_.position(unit_.files[file_index_], static_cast<std::uint32_t>(offset)).line;
    }
    Span span(std::size_t begin, std::size_t end) const {
        return {unit_.files[file_index_], static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    }
    // Leaves [from, to) out of the text, but for its line ends, and puts `instead` there.
    void blank_out(std::size_t from, std::size_t to, std::string_view instead = {}) {
        pending_ += text_.substr(lead_start_, from - lead_start_);
        pending_ += instead;
        pending_.append(static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(from),
                                                            text_.begin() + static_cast<std::ptrdiff_t>(to), '\n')),
                        '\n');
        lead_start_ = to;
    }
    std::string_view take_lead(std::size_t end) {
        const std::string_view rest = text_.substr(lead_start_, end - lead_start_);
        if (pending_.empty()) return rest;
        pending_ += rest;
        std::string_view kept = unit_.keep(std::move(pending_));
        pending_.clear();
        return kept;
    }

    Unit& unit_;
    Sources& sources_;
    const Options& options_;
    Diagnostics& diagnostics_;
    Macros macros_;
    std::vector<Conditional> conditionals_;
    std::vector<std::string> file_name_;  // of the files being read, for cycles and relative names
    std::set<std::string> once_;          // files that are read only once
    bool shadows_language_ = false;
    bool broken_ = false;  // conditionals that a driver would refuse

    // of the file being read
    std::string_view text_;
    std::size_t at_ = 0, lead_start_ = 0;
    std::uint16_t file_index_ = 0;
    std::string pending_;
};

void Preprocessor::read(FileId file) {
    unit_.files.push_back(file);
    file_index_ = static_cast<std::uint16_t>(unit_.files.size() - 1);
    Cleaned cleaned = clean(sources_.text(file));
    if (cleaned.odd_blanks)
        diagnostics_.warning("odd-blank", span(cleaned.first_odd, cleaned.first_odd + 1),
                             "a no-break space or the like is read as a blank");
    text_ = unit_.keep(std::move(cleaned.text));
    check_comments(text_, file, diagnostics_);
    at_ = lead_start_ = 0;
    bool line_start = true;
    while (true) {
        const Trivia trivia = skip_trivia(text_, at_);
        at_ = trivia.end;
        line_start = line_start || trivia.line_end;
        if (at_ >= text_.size() || unit_.tokens.size() > token_limit) break;
        if (line_start && text_[at_] == '#') {
            directive(at_);
        } else {
            token();
            line_start = false;
        }
    }
}

void Preprocessor::token() {
    const Lexeme lexeme = lex(text_, at_);
    if (!active()) {
        at_ += lexeme.text.size();
        return;
    }
    if (lexeme.kind == Kind::identifier && macros_.find(lexeme.text) && invocation(lexeme)) return;
    Token t;
    t.kind = lexeme.kind;
    t.file = file_index_;
    t.offset = static_cast<std::uint32_t>(at_);
    t.text = lexeme.text;
    t.lead = take_lead(at_);
    unit_.tokens.push_back(t);
    at_ += lexeme.text.size();
    lead_start_ = at_;
}

// Behind the parenthesis that closes the arguments which start at or after `from`, if there are any.
std::optional<std::size_t> Preprocessor::arguments_end(std::size_t from) const {
    std::size_t i = skip_trivia(text_, from).end;
    if (i >= text_.size() || text_[i] != '(') return std::nullopt;
    int depth = 0;
    while (i < text_.size()) {
        const Lexeme lexeme = lex(text_, i);
        i += lexeme.text.size();
        if (lexeme.text == "(") ++depth;
        if (lexeme.text == ")" && --depth == 0) return i;
        i = skip_trivia(text_, i).end;
    }
    return std::nullopt;
}

bool Preprocessor::invocation(const Lexeme& name) {
    const Macro* macro = macros_.find(name.text);
    std::size_t end = at_ + name.text.size();
    if (macro->function) {
        const auto close = arguments_end(end);
        if (!close) {
            const std::size_t next = skip_trivia(text_, end).end;
            if (next >= text_.size() || text_[next] != '(') macros_.note_uncalled();
            return false;
        }
        end = *close;
    }
    std::vector<MacroToken> out;
    while (true) {
        out.clear();
        if (!macros_.expand(macro_tokens(text_.substr(at_, end - at_)), out)) {
            const Span where = span(at_, at_ + name.text.size());
            if (macros_.misused().empty())
                diagnostics_.error("macro-too-large", where, "the expansion of this macro is too large or too deep");
            else
                diagnostics_.error("macro-arguments", where, macros_.misused(),
                                   "every comma separates two arguments, unless it is within parentheses");
            return false;
        }
        // The expansion may end in the name of a function-like macro whose arguments follow.
        const Macro* last = out.empty() || out.back().frozen ? nullptr : macros_.find(out.back().text);
        if (!last || !last->function) break;
        const auto close = arguments_end(end);
        if (!close) break;
        end = *close;
    }
    const auto id = static_cast<std::int32_t>(unit_.invocations.size());
    const std::string_view source = text_.substr(at_, end - at_);
    if (out.empty()) {
        if (!unit_.verbatim) blank_out(at_, end);
        at_ = end;
        return true;
    }
    unit_.invocations.push_back(source);
    for (std::size_t k = 0; k < out.size(); ++k) {
        Token t;
        t.kind = out[k].kind;
        t.file = file_index_;
        t.offset = static_cast<std::uint32_t>(at_);
        t.text = out[k].text;
        t.lead = k == 0 ? take_lead(at_) : std::string_view(" ");
        t.macro = id;
        unit_.tokens.push_back(t);
    }
    at_ = lead_start_ = end;
    return true;
}

void Preprocessor::directive(std::size_t start) {
    const std::size_t end = directive_end(text_, start);
    std::size_t i = start + 1;
    while (i < end && blank(text_[i])) ++i;
    std::size_t name_end = i;
    while (name_end < end && identifier_part(text_[name_end])) ++name_end;
    const std::string_view name = text_.substr(i, name_end - i);
    const std::string_view rest = text_.substr(name_end, end - name_end);
    at_ = end;
    if (name == "if" || name == "ifdef" || name == "ifndef" || name == "elif" || name == "else" || name == "endif") {
        unit_.has_conditionals = true;
        conditional(name, rest, start, end);
    } else if (active()) {
        perform(name, rest, start, end);
    }
}

void Preprocessor::conditional(std::string_view name, std::string_view rest, std::size_t start, std::size_t end) {
    const bool before = active();
    const auto evaluate = [&] {
        if (name == "ifdef" || name == "ifndef") {
            const std::vector<MacroToken> tokens = macro_tokens(rest);
            return !tokens.empty() && macros_.defined(tokens.front().text) == (name == "ifdef");
        }
        const std::optional<bool> value = macros_.condition(rest, line_of(start));
        broken_ = broken_ || !value;
        if (!value)
            diagnostics_.warning("bad-condition", span(start, end),
                                 "this condition cannot be understood: read as false");
        return value.value_or(false);
    };
    if (name.starts_with("if")) {
        const bool taken = before && evaluate();
        conditionals_.push_back({span(start, end), taken, taken, before, false});
    } else if (conditionals_.empty()) {
        diagnostics_.warning("stray-conditional", span(start, end), "this directive belongs to no #if");
        blank_out(start, end);
        return;
    } else if (name == "endif") {
        conditionals_.pop_back();
    } else {
        Conditional& c = conditionals_.back();
        c.active = c.outer && !c.taken && !c.had_else && (name == "else" || evaluate());
        c.taken = c.taken || c.active;
        c.had_else = c.had_else || name == "else";
    }
    const std::size_t surplus = end - rest.size() + before_surplus(name, rest, span(start, end), diagnostics_);
    if (!unit_.verbatim) return blank_out(before ? start : lead_start_, end);
    if (surplus < end) blank_out(surplus, end);
}

void Preprocessor::perform(std::string_view name, std::string_view rest, std::size_t start, std::size_t end) {
    if (name == "version") return version(rest, start, end);
    if (name == "extension") return extension(rest, start, end);
    if (name == "include") return include(rest, start, end);
    if (name == "define") {
        // Versions before 4.20 have no line continuation.
        broken_ = broken_ || (!options_.target.es && options_.target.version < 420 && rest.find('\\') != rest.npos);
        define(rest);
    } else if (name == "undef") {
        const std::vector<MacroToken> tokens = macro_tokens(rest);
        if (!tokens.empty()) macros_.undefine(tokens.front().text);
    } else if (const std::vector<MacroToken> words = name == "pragma" ? macro_tokens(rest) : std::vector<MacroToken>();
               words.size() == 1 && words.front().text == "once") {
        once_.insert(file_name_.back());
        return blank_out(start, end);
    } else if (name == "pragma" && unit_.stage == Stage::fragment && rest.find("STDGL") != rest.npos) {
        return blank_out(start, end);  // `invariant(all)`, which newer versions refuse where nothing is passed on
    } else if (name != "pragma" && name != "line" && name != "error" && !name.empty()) {
        diagnostics_.warning("unknown-directive", span(start, end), "unknown directive: it is left out",
                             "a comment begins with '//'");
        return blank_out(start, end);
    } else {
        return;
    }
    if (!unit_.verbatim) blank_out(start, end);
}

void Preprocessor::define(std::string_view rest) {
    const std::size_t i = skip_trivia(rest, 0).end;
    std::size_t name_end = i;
    while (name_end < rest.size() && identifier_part(rest[name_end])) ++name_end;
    const std::string_view name = rest.substr(i, name_end - i);
    if (name.empty() || !identifier_start(name.front())) return;
    Macro macro;
    std::size_t body = name_end;
    if (name_end < rest.size() && rest[name_end] == '(') {
        macro.function = true;
        const std::size_t close = rest.find(')', name_end);
        if (close == std::string_view::npos) return;
        for (const MacroToken& t : macro_tokens(rest.substr(name_end + 1, close - name_end - 1)))
            if (t.kind == Kind::identifier) macro.parameters.push_back(t.text);
        body = close + 1;
    }
    macro.body = macro_tokens(rest.substr(body));
    shadows_language_ = shadows_language_ || is_language_word(name) || name.starts_with("snell_");
    for (const MacroToken& t : macro.body) shadows_language_ = shadows_language_ || t.text == name || t.text == "##";
    unit_.defined.emplace_back(name);
    // A macro from outside overrides the shader's own.
    for (const Define& d : options_.defines)
        if (d.name == name) return;
    macros_.define(name, std::move(macro));
}

void Preprocessor::version(std::string_view rest, std::size_t start, std::size_t end) {
    const std::vector<MacroToken> tokens = macro_tokens(rest);
    if (!tokens.empty()) {
        const std::string_view digits = tokens.front().text;
        std::from_chars(digits.data(), digits.data() + digits.size(), unit_.version);
        if (tokens.size() > 1) unit_.profile = tokens[1].text;
    }
    macros_.set_version(unit_.version, unit_.profile);
    if (unit_.has_version || !unit_.tokens.empty() || file_index_ != 0) return blank_out(start, end);
    unit_.has_version = true;
    unit_.version_line = line_of(start);
    unit_.head = take_lead(start);
    lead_start_ = end;
}

void Preprocessor::extension(std::string_view rest, std::size_t start, std::size_t end) {
    const std::vector<MacroToken> tokens = macro_tokens(rest);
    Extension e;
    if (!tokens.empty()) e.name = tokens.front().text;
    e.behaviour = tokens.size() > 2 ? std::string(tokens[2].text) : std::string("enable");
    unit_.extensions.push_back(std::move(e));
    blank_out(start, end, std::string_view(&extension_mark, 1));
}

// Whether the text begins with `#ifndef NAME` of a name that is defined, so that reading it again gives nothing.
bool Preprocessor::guarded(std::string_view text) const {
    const std::size_t start = skip_trivia(text, 0).end;
    if (start >= text.size() || text[start] != '#') return false;
    const std::vector<MacroToken> words = macro_tokens(text.substr(start + 1, directive_end(text, start) - start - 1));
    return words.size() == 2 && words[0].text == "ifndef" && macros_.find(words[1].text);
}

void Preprocessor::include(std::string_view rest, std::size_t start, std::size_t end) {
    const std::size_t i = skip_trivia(rest, 0).end;
    const bool angle = i < rest.size() && rest[i] == '<';
    const char closer = angle ? '>' : '"';
    const std::size_t close = i + 1 < rest.size() ? rest.find(closer, i + 1) : std::string_view::npos;
    const Span where = span(start, end);
    if (i >= rest.size() || (rest[i] != '"' && !angle) || close == std::string_view::npos) {
        diagnostics_.error("bad-include", where, "#include wants \"file\" or <file>");
        return blank_out(start, end);
    }
    const std::string_view name = rest.substr(i + 1, close - i - 1);
    std::optional<IncludeText> got;
    if (options_.include) got = options_.include(file_name_.back(), name, angle);
    // The names of gstap.h are always known.
    if ((!got || got->name.empty()) && name == "gstap.h") got = IncludeText{"gstap.h", ""};
    if (!got || got->name.empty()) {
        diagnostics_.error("missing-include", where,
                           "cannot read the included file '" + std::string(name) + "'" + (got ? ": " + got->why : ""));
        return blank_out(start, end);
    }
    if (got->inexact)
        diagnostics_.warning("file-inexact", where, inexact_name(name, got->name), std::string(inexact_name_help));
    if (once_.contains(got->name)) return blank_out(start, end);
    if (std::find(file_name_.begin(), file_name_.end(), got->name) != file_name_.end()) {
        if (!guarded(got->text)) diagnostics_.error("include-cycle", where, "'" + got->name + "' includes itself");
        return blank_out(start, end);
    }
    const bool deep = file_name_.size() > options_.limits.include_depth;
    if (deep || unit_.files.size() > options_.limits.includes) {
        diagnostics_.error(deep ? "include-too-deep" : "too-many-includes", where,
                           deep ? "includes are nested too deeply" : "too many files are included",
                           limit_help(options_.limits, deep ? &Limits::include_depth : &Limits::includes));
        return blank_out(start, end);
    }
    const int line = line_of(start) + static_cast<int>(std::count(rest.begin(), rest.end(), '\n'));
    pending_ += text_.substr(lead_start_, start - lead_start_);
    pending_ += "#line 1 " + std::to_string(unit_.files.size()) + "\n";
    const std::string_view text = text_;
    const std::uint16_t index = file_index_;
    file_name_.push_back(got->name);
    const FileId file = sources_.add(got->name, std::move(got->text));
    const std::size_t open = conditionals_.size();
    read(file);
    if (conditionals_.size() > open) conditionals_.resize(open);
    pending_ += text_.substr(lead_start_);
    if (pending_.empty() || pending_.back() != '\n') pending_ += '\n';
    pending_ += "#line " + std::to_string(line + 1) + " " + std::to_string(index);
    file_name_.pop_back();
    text_ = text;
    file_index_ = index;
    at_ = lead_start_ = end;
}

}  // namespace

std::string included_twice(std::string_view name) {
    return "'" + std::string(name.substr(name.rfind('/') + 1)) +
           "' is included twice: write '#pragma once' as its first line";
}

void preprocess(Unit& unit, FileId file, Sources& sources, const Options& options, Diagnostics& diagnostics) {
    if (unit.verbatim) {
        Diagnostics first;
        Preprocessor verbatim(unit, sources, options, first);
        verbatim.run(file);
        if (!verbatim.must_expand()) return diagnostics.append(first);
    }
    Unit again;
    again.stage = unit.stage;
    again.reference = unit.reference;
    again.verbatim = false;
    Preprocessor expanded(again, sources, options, diagnostics);
    expanded.run(file);
    unit = std::move(again);
}

}  // namespace snell::glsl
