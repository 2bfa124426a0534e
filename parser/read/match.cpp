#include "parser/read/match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "parser/text/number.h"
#include "parser/text/words.h"
#include "parser/text_of.h"

namespace snell {
namespace {

std::string quoted(std::string_view text) { return "'" + std::string(text.substr(0, 60)) + "'"; }

std::string usage(const Command& command) {
    std::string text(command.name);
    if (!command.signature.text.empty()) text += " " + std::string(command.signature.text);
    return text;
}

}  // namespace

// Walks the tokens of one statement along the parameters of one alternative. A dry walk only tells whether it
// fits; `loose` lets a dry walk pass over brackets, as the real one does with a warning.
class Matcher {
public:
    Matcher(const Command& command, const Statement& statement, const StatementReader& reader, Collector& report,
            Arguments& out)
        : command_(command), tokens_(statement.arguments()), lexer_(reader.lexer()), report_(report), out_(out) {
        out_.lexer_ = &lexer_;
        out_.statement_ = statement;
        out_.span_ = reader.span(statement);
    }

    bool run() {
        const std::size_t alternative = command_.signature.count == 1 ? 0 : best_alternative();
        out_.alternative_ = alternative;
        out_.arguments_.clear();
        out_.numbers_.clear();
        out_.mended_ = false;
        dry_ = false;
        at_ = 0;
        for (std::size_t i = 0; i < command_.signature.parameter_count(alternative); ++i)
            convert(command_.signature.parameter(alternative, i), i > 0);
        out_.size_ = out_.arguments_.size();
        if (remaining() > 0) report_surplus();
        return ok_;
    }

private:
    struct Fit {
        bool mismatch = false;
        std::size_t missing = 0, surplus = 0;
        auto rank() const { return std::tuple(mismatch, missing + surplus); }
    };

    std::size_t best_alternative() {
        std::size_t best = 0;
        Fit best_fit = fit(0, false);
        for (const bool loose : {false, true}) {
            for (std::size_t i = 0; i < command_.signature.count; ++i) {
                const Fit candidate = fit(i, loose);
                if (candidate.rank() < best_fit.rank()) {
                    best_fit = candidate;
                    best = i;
                }
            }
            if (!best_fit.mismatch && best_fit.missing + best_fit.surplus == 0) break;
        }
        return best;
    }

    Fit fit(std::size_t alternative, bool loose) {
        Fit result;
        dry_ = true;
        loose_ = loose;
        at_ = 0;
        for (std::size_t i = 0; i < command_.signature.parameter_count(alternative); ++i) {
            const Parameter& p = command_.signature.parameter(alternative, i);
            bool taken = false;
            do {
                skip_separators();
                if (at_ == tokens_.size() || (i > 0 && lacks_keyword(p))) break;
                if (!take(p, nullptr)) {
                    // A word in the place of a number uses up that place.
                    if (p.kind != ArgumentKind::number && p.kind != ArgumentKind::integer) return {true, 0, 0};
                    result.mismatch = true;
                }
                taken = true;
            } while (p.repeated);
            if (!taken && !p.optional) ++result.missing;
        }
        result.surplus = remaining();
        // "LookAt 0 0 z" is not the LookAt that has no arguments.
        if (command_.signature.parameter_count(alternative) == 0) result.mismatch = result.surplus > 0;
        return result;
    }

    // What stands here is none of the words of an optional choice, alone: "(raw)" is a comment. It is left out then.
    bool lacks_keyword(const Parameter& p) const {
        if (!p.is_keyword() || at_ == tokens_.size()) return p.is_keyword();
        if (tokens_[at_].glued || (at_ + 1 < tokens_.size() && tokens_[at_ + 1].glued)) return true;
        return find_choice(p.choices, lexer_.text(tokens_[at_])) < 0;
    }

    void convert(const Parameter& p, bool behind) {
        if (p.repeated) {
            for (skip_separators(); at_ < tokens_.size(); skip_separators()) convert_one(p);
            return;
        }
        skip_separators();
        const bool there = at_ < tokens_.size() && !(behind && lacks_keyword(p));
        if (there || p.kind == ArgumentKind::rest || p.kind == ArgumentKind::uniforms) {
            convert_one(p);
            return;
        }
        Argument& a = out_.arguments_.emplace_back();
        a.span = out_.span_;
        a.number = p.kind == ArgumentKind::choice ? find_choice(p.choices, p.default_text) : p.default_value;
        a.text = p.default_text;
        if (p.optional) return;
        if (ok_)
            report_.error("missing-argument", lexer_.span(out_.statement_.command()),
                          quoted(command_.name) + " lacks its argument " + quoted(p.name), "usage: " + usage(command_));
        ok_ = false;
    }

    void convert_one(const Parameter& p) {
        Argument a;
        a.given = true;
        if (!take(p, &a)) ok_ = false;
        out_.arguments_.push_back(a);
    }

    // Takes one argument; `out` is null in a dry walk. Always moves on, unless it returns false in a dry walk.
    bool take(const Parameter& p, Argument* out) {
        switch (p.kind) {
            case ArgumentKind::number:
            case ArgumentKind::integer:
                return take_number(p, out);
            case ArgumentKind::vec3:
                return take_vec3(p, out);
            case ArgumentKind::path:
            case ArgumentKind::name:
                return take_name(p, out);
            case ArgumentKind::choice:
                return take_choice(p, out);
            case ArgumentKind::rest:
                return take_rest(out);
            case ArgumentKind::uniforms:
                at_ = tokens_.size();
                return true;
        }
        return false;
    }

    bool take_number(const Parameter& p, Argument* out) {
        const Token& token = tokens_[at_];
        const std::string_view text = lexer_.text(token);
        if (out == nullptr) {
            ++at_;
            return token.kind == TokenKind::word && plausible_number(text);
        }
        ++at_;
        out->span = lexer_.span(token);
        const Number number = read_number(text);
        // A word becomes the default, as in glman, or 0, so that the numbers that follow keep their places.
        // Units and sizes without a default can't be guessed.
        const bool mendable =
            number.fault == NumberFault::not_a_number && !p.repeated && (p.optional || p.kind == ArgumentKind::number);
        if (number.fault != NumberFault::none)
            report_number(report_, number, text, out->span, mendable ? p.default_text : std::string_view());
        if (!number.usable()) {
            out->number = p.default_value;
            out_.mended_ = out_.mended_ || mendable;
            return mendable;
        }
        out->number = number.value;
        if (p.kind == ArgumentKind::integer) round(*out, text);
        return true;
    }

    void round(Argument& a, std::string_view text) {
        const double whole = std::round(a.number);
        if (whole != a.number)
            report_.warning("not-an-integer", a.span,
                            quoted(text) + " is not a whole number: " +
                                std::to_string(std::llround(std::clamp(whole, -1e9, 1e9))) + " is taken");
        constexpr double most = std::numeric_limits<int>::max();
        a.number = std::clamp(whole, -most, most);
    }

    bool take_vec3(const Parameter& p, Argument* out) {
        if (out == nullptr) return fits_vec3();
        const bool bracketed = tokens_[at_].kind == TokenKind::open;
        const std::size_t open = at_;
        out->first = static_cast<std::uint32_t>(out_.numbers_.size());
        if (bracketed) {
            ++at_;
            if (lexer_.text()[tokens_[open].begin] != '[')
                warn_brackets(open, "brackets of " + quoted(p.name) + " are [ and ]");
        } else {
            warn_brackets(open, quoted(p.name) + " is written in brackets: [x y z]");
        }
        bool good = true;
        std::size_t last = open;
        while (at_ < tokens_.size()) {
            const Token& token = tokens_[at_];
            if (token.kind == TokenKind::comma) {
                ++at_;
                continue;
            }
            if (token.kind != TokenKind::word || (!bracketed && out_.numbers_.size() - out->first == 3)) break;
            Argument component;
            good = take_number(Parameter{}, &component) && good;
            out_.numbers_.push_back(component.number);
            last = at_ - 1;
        }
        if (bracketed && at_ < tokens_.size() && tokens_[at_].kind == TokenKind::close) last = at_++;
        out->count = static_cast<std::uint32_t>(out_.numbers_.size()) - out->first;
        out->span = {lexer_.file(), tokens_[open].begin, tokens_[last].end};
        if (bracketed && tokens_[last].kind != TokenKind::close)
            report_.warning("missing-bracket", out->span, quoted(p.name) + " lacks its closing ']'");
        if (out->count < 3) {
            if (good)
                report_.error("missing-argument", out->span,
                              quoted(p.name) + " has " + std::to_string(out->count) + " of its 3 numbers",
                              "usage: " + usage(command_));
            good = false;
        }
        return good;
    }

    // A bracket with anything in it; without brackets (loose) three numbers.
    bool fits_vec3() {
        if (tokens_[at_].kind == TokenKind::open) {
            for (++at_; at_ < tokens_.size() && tokens_[at_].kind != TokenKind::close; ++at_)
                if (tokens_[at_].kind == TokenKind::open) return true;
            at_ = std::min(at_ + 1, tokens_.size());
            return true;
        }
        if (!loose_) return false;
        for (int i = 0; i < 3; ++i) {
            while (at_ < tokens_.size() && tokens_[at_].kind == TokenKind::comma) ++at_;
            if (at_ == tokens_.size() || tokens_[at_].kind != TokenKind::word) return false;
            if (!plausible_number(lexer_.text(tokens_[at_++]))) return false;
        }
        return true;
    }

    // From the token at the cursor to the next blank: names may hold any bracket or comma.
    std::string_view take_chunk(Argument* out) {
        const std::size_t first = at_++;
        if (tokens_[first].kind != TokenKind::text)
            while (at_ < tokens_.size() && tokens_[at_].glued) ++at_;
        std::size_t last = at_ - 1;
        while (last > first && tokens_[last].kind == TokenKind::comma) --last;
        const std::uint32_t begin = tokens_[first].begin, end = tokens_[last].end;
        if (out != nullptr) out->span = {lexer_.file(), begin, end};
        std::string_view text = lexer_.text().substr(begin, end - begin);
        if (tokens_[first].kind != TokenKind::text) return text;
        if (tokens_[first].unclosed && out != nullptr)
            report_.warning("unclosed-quote", out->span, "the closing '\"' is missing");
        return without_quotes(text, !tokens_[first].unclosed);
    }

    bool take_name(const Parameter& p, Argument* out) {
        const Token& token = tokens_[at_];
        if (out == nullptr && token.kind == TokenKind::word &&
            read_number(lexer_.text(token)).fault == NumberFault::none &&
            (at_ + 1 == tokens_.size() || !tokens_[at_ + 1].glued))
            return false;
        if (out == nullptr && token.kind != TokenKind::word && token.kind != TokenKind::text) return false;
        const std::string_view text = take_chunk(out);
        if (out == nullptr) return true;
        out->text = text;
        if (!text.empty() || (p.kind == ArgumentKind::name && p.optional)) return true;
        report_.error("empty-name", out->span, quoted(p.name) + " is empty");
        return false;
    }

    bool take_choice(const Parameter& p, Argument* out) {
        const std::string_view text = take_chunk(out);
        const int place = find_choice(p.choices, text);
        if (out == nullptr) return place >= 0;
        const auto words = split(p.choices, '/');
        out->number = place;
        if (place >= 0) out->text = words[static_cast<std::size_t>(place)];
        if (place >= 0) return true;
        std::string all;
        for (const std::string_view word : words) all += (all.empty() ? "" : ", ") + std::string(word);
        const std::string_view near = nearest(text, words);
        Diagnostic& said = report_.error("unknown-choice", out->span, quoted(text) + " is not one of: " + all,
                                         near.empty() ? "" : "did you mean " + quoted(near) + "?");
        if (!near.empty()) said.fixes.push_back({out->span, std::string(near)});
        return false;
    }

    // Everything up to the end of the statement, as written; a line end becomes one blank.
    bool take_rest(Argument* out) {
        const std::size_t first = at_;
        at_ = tokens_.size();
        if (out == nullptr || first == tokens_.size()) {
            if (out != nullptr) out->span = out_.span_;
            return true;
        }
        const std::string_view text = lexer_.text();
        out->span = {lexer_.file(), tokens_[first].begin, tokens_.back().end};
        out->text = text.substr(out->span.begin, out->span.end - out->span.begin);
        bool several = false;
        out_.joined_ = lexer_.text(tokens_[first]);
        for (std::size_t i = first + 1; i < tokens_.size(); ++i) {
            const Token &token = tokens_[i], &before = tokens_[i - 1];
            several = several || token.line_start;
            out_.joined_ += token.line_start ? " " : text.substr(before.end, token.begin - before.end);
            out_.joined_ += lexer_.text(token);
        }
        if (several) out->text = out_.joined_;
        return true;
    }

    // Commas between arguments; brackets where numbers are due.
    void skip_separators() {
        while (at_ < tokens_.size()) {
            const TokenKind kind = tokens_[at_].kind;
            if (kind == TokenKind::open && (expects_vec3() || (dry_ && !loose_))) return;
            if (kind == TokenKind::close && dry_ && !loose_) return;
            if (kind == TokenKind::word || kind == TokenKind::text) return;
            if (kind != TokenKind::comma && !dry_ && numbers_due())
                warn_brackets(at_, quoted(command_.name) + " takes its numbers without brackets");
            if (kind != TokenKind::comma && !dry_ && !numbers_due()) return;
            ++at_;
        }
    }

    bool expects_vec3() const {
        return (dry_ ? command_.takes(ArgumentKind::vec3) : alternative_takes(ArgumentKind::vec3));
    }
    bool numbers_due() const {
        return alternative_takes(ArgumentKind::number) || alternative_takes(ArgumentKind::integer);
    }
    bool alternative_takes(ArgumentKind kind) const {
        const std::size_t count = command_.signature.parameter_count(out_.alternative_);
        for (std::size_t i = 0; i < count; ++i)
            if (command_.signature.parameter(out_.alternative_, i).kind == kind) return true;
        return false;
    }

    void warn_brackets(std::size_t at, std::string message) {
        if (!std::exchange(warned_, true)) report_.warning("brackets", lexer_.span(tokens_[at]), std::move(message));
    }

    std::size_t remaining() {
        skip_separators();
        return tokens_.size() - at_;
    }

    void report_surplus() {
        const Span span{lexer_.file(), tokens_[at_].begin, tokens_.back().end};
        std::string help = "usage: " + usage(command_);
        std::vector<Fix> fixes;
        if (alternative_takes(ArgumentKind::path)) help = "a file name with blanks is written in double quotes";
        for (const Parameter& p : command_.signature.parameters)
            if (const auto word = nearest(lexer_.text(tokens_[at_]), split(p.choices, '/'));
                !word.empty() && find_choice(p.choices, lexer_.text(tokens_[at_])) < 0) {
                help = "did you mean " + quoted(word) + "?";
                fixes = {{lexer_.span(tokens_[at_]), std::string(word)}};
            }
        if (find_command(lexer_.text(tokens_[at_])) != nullptr) help = "every statement begins a line of its own";
        Diagnostic& said =
            report_.warning("surplus-arguments", span,
                            quoted(command_.name) + " takes no more arguments: the rest is ignored", std::move(help));
        said.fixes = std::move(fixes);
    }

    const Command& command_;
    std::span<const Token> tokens_;
    const Lexer& lexer_;
    Collector& report_;
    Arguments& out_;
    std::size_t at_ = 0;
    bool dry_ = false, loose_ = false, ok_ = true, warned_ = false;
};

bool match(const Command& command, const Statement& statement, const StatementReader& reader, Collector& report,
           Arguments& arguments) {
    return Matcher(command, statement, reader, report, arguments).run();
}

}  // namespace snell
