#include "parser/read/match.h"

#include <algorithm>

#include "parser/text/number.h"
#include "parser/text/words.h"

namespace snell {
namespace {

// 1 for true, 0 for false, -1 for neither.
int truth(std::string_view text) { return same_word(text, "true") ? 1 : same_word(text, "false") ? 0 : -1; }

char closer(char open) { return open == '<' ? '>' : open == '[' ? ']' : open == '{' ? '}' : ')'; }

class UniformReader {
public:
    UniformReader(std::span<const Token> tokens, const Lexer& lexer, Collector& report)
        : tokens_(tokens), lexer_(lexer), report_(report) {}

    UniformList run(bool named) {
        if (named) program_name();
        while (at_ < tokens_.size()) {
            if (tokens_[at_].kind == TokenKind::comma) {
                ++at_;
            } else if (tokens_[at_].kind != TokenKind::close && !names_uniform(at_)) {
                stray_value();
            } else if (tokens_[at_].kind == TokenKind::close) {
                report_.warning("stray-bracket", lexer_.span(tokens_[at_]), "this bracket closes nothing");
                ++at_;
            } else {
                uniform();
            }
        }
        return std::move(list_);
    }

private:
    std::string_view text(std::size_t i) const { return lexer_.text(tokens_[i]); }
    Span span(std::size_t first, std::size_t last) const {
        return {lexer_.file(), tokens_[first].begin, tokens_[last].end};
    }
    bool is(std::size_t i, TokenKind kind) const { return i < tokens_.size() && tokens_[i].kind == kind; }

    bool begins_value(std::size_t i) const {
        if (i >= tokens_.size()) return false;
        if (tokens_[i].kind == TokenKind::open) return true;
        return tokens_[i].kind == TokenKind::word && plausible_number(text(i));
    }

    bool names_uniform(std::size_t i) const {
        return is(i, TokenKind::word) && !looks_numeric(text(i)) && !unfilled(text(i));
    }

    // After a name, the words true and false are values, and so is what was to be replaced by one.
    bool begins_value_of_name(std::size_t i) const {
        return begins_value(i) || (is(i, TokenKind::word) && (truth(text(i)) >= 0 || unfilled(text(i))));
    }

    bool is_index(std::size_t i) const {
        return is(i, TokenKind::open) && tokens_[i].glued && text(i) == "[" && is(i + 1, TokenKind::word) &&
               is(i + 2, TokenKind::close) && text(i + 2) == "]" &&
               text(i + 1).find_first_not_of("0123456789") == std::string_view::npos;
    }

    bool is_member(std::size_t i) const {
        return is(i, TokenKind::word) && text(i).size() > 1 && text(i)[0] == '.' && !plausible_number(text(i)) &&
               tokens_[i].glued;
    }

    // An element of an array of uniforms, or a member of one: name[2], name[2].member. Gives the token after it.
    std::size_t after_name(std::size_t i) const {
        std::size_t end = i + 1;
        while (is_index(end)) {
            end += 3;
            if (is_member(end)) ++end;
        }
        return begins_value_of_name(after_equals(end)) ? end : i + 1;
    }

    bool is_name(std::size_t i) const { return is(i, TokenKind::word) || is(i, TokenKind::text); }

    void program_name() {
        const auto bracket_follows = [&](std::size_t i) { return is(i + 1, TokenKind::open); };
        if (!is_name(0) || (bracket_follows(0) && begins_value_of_name(after_name(0)) && is(0, TokenKind::word))) {
            const Span where = tokens_.empty() ? Span{lexer_.file(), 0, 0} : span(0, 0);
            report_.warning("missing-name", where, "the program has no name", "usage: Program Name uniform value ...");
            return;
        }
        add_to_name(at_++);
        const std::size_t second = at_;
        std::size_t last = at_;
        while (at_ < tokens_.size() && tokens_[at_].kind != TokenKind::open) {
            const bool number = is(at_, TokenKind::word) && looks_numeric(text(at_));
            if (tokens_[at_].kind == TokenKind::word && !number && begins_value_of_name(after_equals(after_name(at_))))
                break;
            if (tokens_[at_].kind == TokenKind::comma || tokens_[at_].kind == TokenKind::close) {
                ++at_;
                continue;
            }
            last = at_;
            add_to_name(at_++);
        }
        if (last >= second && last < tokens_.size() && list_.program.find(' ') != std::string::npos && at_ > second)
            report_.warning("name-of-several-words", span(0, last),
                            "the program's name has several words: '" + list_.program + "'",
                            "a name without a value before the first value belongs to the program's name");
    }

    void add_to_name(std::size_t i) {
        std::string_view word = text(i);
        if (tokens_[i].kind == TokenKind::text) word = without_quotes(word, !tokens_[i].unclosed);
        if (!list_.program.empty()) list_.program += ' ';
        // A quote inside a word becomes an apostrophe: then the whole name can be written in quotes again.
        for (std::size_t at = 0; at < word.size();) {
            const utf8::Char c = utf8::decode(word, at);
            const bool quote = c.valid && (c.code == '"' || (c.code >= 0x201C && c.code <= 0x201E));
            list_.program += quote ? std::string_view("'") : word.substr(at, c.length);
            at += c.length;
        }
    }

    // "uEta = 1.5": skips the sign, which the language does not have.
    std::size_t after_equals(std::size_t i) const { return is(i, TokenKind::word) && text(i) == "=" ? i + 1 : i; }

    void uniform() {
        const std::size_t name = at_;
        const std::size_t name_end = after_name(name);
        at_ = after_equals(name_end);
        UniformValue u;
        u.name_span = span(name, name_end - 1);
        u.name = std::string(lexer_.text().substr(u.name_span.begin, u.name_span.end - u.name_span.begin));
        if (!begins_value_of_name(at_)) {
            at_ = name_end;
            report_.error("missing-value", u.name_span, "uniform '" + u.name + "' has no value",
                          "write a number, or a range <min current max>, behind it");
            return;
        }
        if (at_ != name_end)
            report_.warning("stray-equals", span(name_end, name_end),
                            "there must be no '=' between a uniform and its value");
        const bool good = tokens_[at_].kind == TokenKind::open ? bracketed(u) : bare(u);
        u.span = span(name, at_ - 1);
        if (good) add(std::move(u));
    }

    void add(UniformValue&& u) {
        const auto same = std::find_if(list_.uniforms.begin(), list_.uniforms.end(),
                                       [&](const UniformValue& other) { return other.name == u.name; });
        if (same == list_.uniforms.end()) {
            list_.uniforms.push_back(std::move(u));
            return;
        }
        report_
            .warning("repeated-uniform", u.name_span, "uniform '" + u.name + "' is given twice: the last value holds")
            .notes.push_back({same->name_span, "first given here"});
        *same = std::move(u);
    }

    void stray_value() {
        const std::size_t first = at_;
        UniformValue ignored;
        if (tokens_[at_].kind == TokenKind::open) {
            skip_group();
        } else {
            ++at_;
        }
        report_.warning("stray-value", span(first, at_ - 1), "this value has no name before it: it is ignored");
    }

    void skip_group() {
        for (++at_; at_ < tokens_.size(); ++at_) {
            if (tokens_[at_].kind == TokenKind::open) return;
            if (tokens_[at_].kind == TokenKind::close) {
                ++at_;
                return;
            }
        }
    }

    // Reads one number; returns false if it cannot be used.
    bool number(UniformValue& u) {
        const Span where = lexer_.span(tokens_[at_]);
        const std::string_view word = text(at_++);
        const Number n = read_number(word);
        if (n.fault != NumberFault::none) report_number(report_, n, word, where);
        if (!n.usable()) return false;
        u.integral = u.integral && written_integral(word);
        u.values.push_back(n.value);
        u.value_spans.push_back(where);
        return true;
    }

    void boolean(UniformValue& u) {
        u.kind = UniformValue::Kind::boolean;
        u.integral = true;
        u.values = {static_cast<double>(truth(text(at_)))};
        u.value_spans = {lexer_.span(tokens_[at_++])};
    }

    // Values that lack their brackets. One number is a scalar; several were meant as an array.
    bool bare(UniformValue& u) {
        const std::size_t first = at_;
        if (truth(text(at_)) >= 0) {
            boolean(u);
            report_.warning("missing-bracket", span(first, first),
                            "a truth value is written in brackets: <" + std::string(text(first)) + ">");
            return true;
        }
        u.integral = true;
        bool good = true, template_value = false;
        for (std::size_t next = at_; is(next, TokenKind::word) || is(next, TokenKind::comma); ++next) {
            if (is(next, TokenKind::comma)) continue;
            const bool blank = unfilled(text(next));
            if (!blank && !plausible_number(text(next))) break;
            template_value = template_value || blank;
            at_ = next;
            if (blank)
                ++at_;
            else
                good = number(u) && good;
        }
        if (template_value) return report_template(u, span(first, at_ - 1), '<');
        if (at_ - first == 1) return good;
        u.kind = UniformValue::Kind::array;
        report_.warning("missing-bracket", span(first, at_ - 1), "several numbers are written in brackets: [x y z]",
                        "for a slider write <min current max>");
        return good;
    }

    bool bracketed(UniformValue& u) {
        const std::size_t open = at_++;
        const char bracket = text(open)[0];
        u.integral = true;
        bool good = true, template_value = false;
        const std::vector<std::size_t> commas = decimal_commas(open);
        std::vector<Fix> points;
        for (; at_ < tokens_.size();) {
            const Token& token = tokens_[at_];
            if (std::find(commas.begin(), commas.end(), at_) != commas.end()) {
                decimal(u, points);
            } else if (token.kind == TokenKind::comma) {
                ++at_;
            } else if (token.kind == TokenKind::word && truth(text(at_)) >= 0) {
                boolean(u);
            } else if (token.kind == TokenKind::word && looks_numeric(text(at_))) {
                good = number(u) && good;
            } else if (token.kind == TokenKind::word && !ends_group(at_)) {
                template_value = template_value || text(at_).find('?') != std::string_view::npos;
                if (!template_value)
                    report_.error("not-a-number", span(at_, at_), "'" + std::string(text(at_)) + "' is not a number");
                good = false;
                ++at_;
            } else {
                break;
            }
        }
        close(u, open, bracket);
        const Span where = span(open, at_ - 1);
        if (!points.empty()) {
            const Span first = points.front().span;
            report_
                .warning("decimal-comma", where,
                         "'" + std::string(lexer_.text().substr(first.begin, first.end - first.begin)) +
                             "' is read as " + points.front().text,
                         "write numbers with a point: a comma separates them")
                .fixes = std::move(points);
        }
        if (template_value) return report_template(u, where, bracket);
        return good && finish(u, bracket, where);
    }

    bool report_template(const UniformValue& u, Span where, char bracket) {
        report_.error("unfilled-template", where, "the values of '" + u.name + "' were never filled in",
                      bracket == '{'   ? "write numbers: {r g b}"
                      : bracket == '<' ? "write numbers: <min current max>"
                                       : "write numbers: [x y z]");
        return false;
    }

    // Commas between two digits of a group, where as decimal points they leave as many numbers as are due: the tokens
    // before them. Nothing where the numbers are fine as they are.
    std::vector<std::size_t> decimal_commas(std::size_t open) const {
        const bool range = text(open)[0] == '<';
        if (!range && text(open)[0] != '{') return {};
        std::vector<std::size_t> found;
        std::size_t numbers = 0;
        for (std::size_t i = open + 1; i < tokens_.size(); ++i) {
            if (tokens_[i].kind == TokenKind::close) break;
            if (tokens_[i].kind == TokenKind::open || tokens_[i].line_start) return {};
            numbers += tokens_[i].kind == TokenKind::word ? 1 : 0;
            if (is_decimal_comma(tokens_, i, lexer_)) found.push_back(i - 1);
        }
        const std::size_t most = range ? 3 : 4, meant = numbers - found.size();
        return numbers > most && meant <= most && meant >= 3 ? found : std::vector<std::size_t>{};
    }

    // The number of two words with a comma between them.
    void decimal(UniformValue& u, std::vector<Fix>& points) {
        const Span where = span(at_, at_ + 2);
        const std::string point = std::string(text(at_)) + "." + std::string(text(at_ + 2));
        u.integral = false;
        u.values.push_back(read_number(point).value);
        u.value_spans.push_back(where);
        points.push_back({where, point});
        at_ += 3;
    }

    // A word inside a group that is no number: it belongs to the group if the closing bracket still comes
    // before another group begins.
    bool ends_group(std::size_t i) const {
        if (tokens_[i].line_start) return true;
        for (std::size_t j = i + 1; j < tokens_.size(); ++j) {
            if (tokens_[j].kind == TokenKind::close) return false;
            if (tokens_[j].kind == TokenKind::open) return true;
        }
        return true;
    }

    void close(const UniformValue& u, std::size_t open, char bracket) {
        if (!is(at_, TokenKind::close)) {
            const std::uint32_t end = tokens_[at_ - 1].end;
            report_.warning("missing-bracket", {lexer_.file(), tokens_[open].begin, end},
                            "the value of '" + u.name + "' lacks its closing '" + closer(bracket) + "'");
            return;
        }
        if (text(at_)[0] != closer(bracket))
            report_.warning("wrong-bracket", span(at_, at_),
                            "'" + std::string(text(at_)) + "' closes what '" + bracket + "' opened: '" +
                                closer(bracket) + "' is due");
        ++at_;
    }

    bool finish(UniformValue& u, char bracket, Span where) {
        if (u.values.empty()) {
            report_.error("missing-value", where, "uniform '" + u.name + "' has no value between its brackets");
            return false;
        }
        if (u.kind == UniformValue::Kind::boolean) return true;
        switch (bracket) {
            case '<':
                finish_range(u, where);
                break;
            case '{':
                finish_color(u, where);
                break;
            case '(':
                report_.warning("wrong-bracket", where, "an array is written in square brackets: [x y z]");
                [[fallthrough]];
            default:
                u.kind = UniformValue::Kind::array;
        }
        return true;
    }

    void finish_range(UniformValue& u, Span where) {
        const std::size_t count = u.values.size();
        u.kind = UniformValue::Kind::range;
        if (count == 1) {
            const bool truth_value = u.values[0] == 0 || u.values[0] == 1;
            u.kind = truth_value ? UniformValue::Kind::boolean : UniformValue::Kind::scalar;
        } else if (count == 2) {
            report_.warning("range-of-two", where, "a range has three numbers, <min current max>: one is missing",
                            "the first is taken as minimum and current value, the second as maximum");
            u.values.insert(u.values.begin() + 1, u.values[0]);
            u.value_spans.insert(u.value_spans.begin() + 1,
                                 {lexer_.file(), u.value_spans[0].end, u.value_spans[0].end});
        } else if (count > 3) {
            report_.warning("range-too-long", where,
                            "a range has three numbers, <min current max>: the rest is ignored");
            trim(u, 3);
        }
    }

    void finish_color(UniformValue& u, Span where) {
        u.kind = UniformValue::Kind::color;
        if (u.values.size() > 4) {
            report_.warning("color-too-long", where,
                            "a colour has three numbers or four, {r g b a}: the rest is ignored");
            trim(u, 4);
        } else if (u.values.size() < 3) {
            report_.warning("color-too-short", where, "a colour has three numbers, {r g b}: the missing ones are 0");
            while (u.values.size() < 3) {
                u.values.push_back(0);
                u.value_spans.push_back({lexer_.file(), u.value_spans.back().end, u.value_spans.back().end});
            }
        }
    }

    static void trim(UniformValue& u, std::size_t count) {
        u.values.resize(count);
        u.value_spans.resize(count);
    }

    std::span<const Token> tokens_;
    const Lexer& lexer_;
    Collector& report_;
    UniformList list_;
    std::size_t at_ = 0;
};

}  // namespace

UniformList read_uniforms(std::span<const Token> tokens, const Lexer& lexer, Collector& report, const Limits& limits,
                          bool named) {
    UniformList list = UniformReader(tokens, lexer, report).run(named);
    if (list.uniforms.size() > limits.uniforms) {
        report.error("too-many-uniforms", list.uniforms[limits.uniforms].span,
                     "only the first " + std::to_string(limits.uniforms) + " uniforms are kept",
                     limit_help(limits, &Limits::uniforms));
        list.uniforms.resize(limits.uniforms);
    }
    return list;
}

bool looks_like_uniform(std::span<const Token> tokens, const Lexer& lexer, bool several) {
    while (tokens.size() >= 2 && tokens[0].kind == TokenKind::word && !looks_numeric(lexer.text(tokens[0]))) {
        const Token& value = tokens[1];
        if (value.kind == TokenKind::open) return true;
        if (value.kind != TokenKind::word || !plausible_number(lexer.text(value))) return false;
        if (tokens.size() == 2) return true;
        if (!several) return false;
        tokens = tokens.subspan(2);
    }
    return false;
}

}  // namespace snell
