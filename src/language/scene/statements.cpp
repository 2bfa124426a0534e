#include "src/language/scene/statements.h"

#include <algorithm>
#include <tuple>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/plan/values/controls.h"

namespace snell::language {

namespace {

bool line_end(char c) { return c == '\n' || c == '\r'; }

// Between tokens there are only blanks, backslashes and comments.
void find_comments(Statements& found) {
    std::uint32_t from = 0;
    const auto within = [&](std::uint32_t end) {
        const std::string_view text = found.text;
        for (std::uint32_t i = from; i < end;) {
            const bool begins = text[i] == '#' || (text[i] == '/' && text.substr(i, 2) == "//");
            std::uint32_t close = i + 1;
            if (begins) {
                while (close < end && !line_end(text[close])) ++close;
                found.comments.push_back({found.file, i, close});
            }
            i = close;
        }
    };
    for (const Token& token : found.tokens) {
        within(token.begin);
        from = token.end;
    }
    within(static_cast<std::uint32_t>(found.text.size()));
}

}  // namespace

Statements read_statements(FileId file, std::string_view text) {
    Statements found;
    found.text = text;
    found.file = file;
    Collector unheard(0);
    StatementReader reader(text, file, unheard);
    Statement statement;
    while (reader.next(statement)) {
        const auto first = static_cast<std::uint32_t>(found.tokens.size());
        found.tokens.insert(found.tokens.end(), statement.tokens.begin(), statement.tokens.end());
        const Token& command = statement.command();
        found.items.push_back({command.kind == TokenKind::word ? find_command(reader.lexer().text(command)) : nullptr,
                               first, static_cast<std::uint32_t>(statement.tokens.size())});
    }
    find_comments(found);
    return found;
}

const Token* Statements::at(std::uint32_t offset) const {
    const auto next = std::upper_bound(tokens.begin(), tokens.end(), offset,
                                       [](std::uint32_t at, const Token& token) { return at < token.begin; });
    if (next == tokens.begin()) return nullptr;
    const Token& token = *std::prev(next);
    if (token.begin == offset && token.kind != TokenKind::word && next != std::next(tokens.begin())) {
        const Token& left = *std::prev(next, 2);  // a word that ends at a bracket
        if (left.end == offset && left.kind == TokenKind::word) return &left;
    }
    return token.end >= offset ? &token : nullptr;
}

bool Statements::in_comment(std::uint32_t offset) const {
    const auto next = std::lower_bound(comments.begin(), comments.end(), offset,
                                       [](const Span& comment, std::uint32_t at) { return comment.begin < at; });
    return next != comments.begin() && std::prev(next)->end >= offset;
}

const SceneStatement* Statements::at_statement(std::uint32_t offset) const {
    const auto next = std::upper_bound(
        items.begin(), items.end(), offset,
        [&](std::uint32_t at, const SceneStatement& statement) { return at < tokens[statement.first].begin; });
    if (next == items.begin()) return nullptr;
    const SceneStatement& statement = *std::prev(next);
    const std::uint32_t end = tokens[statement.first + statement.count - 1].end;
    return offset <= end_of_lines(text, end) ? &statement : nullptr;
}

// Which argument a token is, by walking the tokens before it along the parameters of each alternative.

namespace {

bool fits(const Parameter& parameter, const Token& token, std::string_view word) {
    const bool number = token.kind == TokenKind::word && plausible_number(word);
    switch (parameter.kind) {
        case ArgumentKind::number:
        case ArgumentKind::integer:
            return number;
        case ArgumentKind::choice:
            return find_choice(parameter.choices, word) >= 0;
        case ArgumentKind::vec3:
            return token.kind == TokenKind::open;
        case ArgumentKind::path:
        case ArgumentKind::name:
            return token.kind == TokenKind::text || (token.kind == TokenKind::word && !number);
        case ArgumentKind::uniforms:
        case ArgumentKind::rest:
            return true;
    }
    return true;
}

struct Walked {
    ArgumentPlace place;
    std::size_t misfits = 0, missing = 0;
    bool surplus = false;
};

Walked walk(const Statements& statements, const SceneStatement& statement, std::size_t alternative, std::size_t until) {
    const std::span<const Token> tokens = statements.tokens_of(statement);
    const Signature& signature = statement.command->signature;
    const std::size_t count = signature.parameter_count(alternative);
    Walked walked;
    std::size_t at = 1, parameter = 0;
    const auto last = std::min(until, tokens.size());
    while (at < last) {
        if (tokens[at].kind == TokenKind::comma || tokens[at].kind == TokenKind::close) {
            ++at;
            continue;
        }
        if (parameter >= count) break;
        const Parameter& wanted = signature.parameter(alternative, parameter);
        if (wanted.kind == ArgumentKind::uniforms || wanted.kind == ArgumentKind::rest) break;
        if (!fits(wanted, tokens[at], statements.word(tokens[at]))) {
            if (wanted.is_keyword()) {
                ++parameter;
                continue;
            }
            ++walked.misfits;
        }
        if (tokens[at].kind == TokenKind::open) {
            std::size_t component = 0;
            for (++at; at < last && tokens[at].kind != TokenKind::close; ++at)
                if (tokens[at].kind == TokenKind::word) ++component;
            if (at >= last) {  // the place is within the brackets
                walked.place = {alternative, &wanted, parameter, component, true};
                return walked;
            }
        }
        ++at;
        if (!wanted.repeated) ++parameter;
    }
    walked.surplus = parameter >= count;
    for (std::size_t i = parameter; i < count; ++i)
        if (!signature.parameter(alternative, i).optional) ++walked.missing;
    walked.place = {alternative, walked.surplus ? nullptr : &signature.parameter(alternative, parameter), parameter, 0,
                    false};
    return walked;
}

}  // namespace

std::vector<ArgumentPlace> arguments_at(const Statements& statements, const SceneStatement& statement,
                                        std::size_t token) {
    struct Ranked {
        ArgumentPlace place;
        bool fits = true;  // what precedes the place
        std::tuple<std::size_t, bool, std::size_t> rank;
    };
    std::vector<Ranked> all;
    if (statement.command == nullptr) return {};
    for (std::size_t i = 0; i < statement.command->signature.count; ++i) {
        const Walked walked = walk(statements, statement, i, token);
        // What is written there, and what follows, tells alternatives apart.
        const Walked whole = walk(statements, statement, i, statement.count);
        all.push_back({walked.place,
                       walked.misfits == 0 && !walked.surplus,
                       {walked.misfits + whole.misfits, walked.surplus, whole.missing}});
    }
    ranges::stable_sort(all, [](const Ranked& a, const Ranked& b) { return a.rank < b.rank; });
    std::vector<ArgumentPlace> places{all.front().place};
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].fits) places.push_back(all[i].place);
    return places;
}

ArgumentPlace argument_at(const Statements& statements, const SceneStatement& statement, std::size_t token) {
    const std::vector<ArgumentPlace> all = arguments_at(statements, statement, token);
    return all.empty() ? ArgumentPlace() : all.front();
}

namespace {

class UniformWalk {
public:
    UniformWalk(const Statements& statements, const SceneStatement& statement)
        : s_(statements), tokens_(statements.tokens_of(statement)) {
        named_ = statement.command != nullptr && statement.command->name == "Program";
        at_ = named_ ? 1 : 0;
    }

    // Calls each(name token, first token of the value, token behind it) for every uniform.
    template <class Each>
    void run(Each each) {
        if (named_) skip_program();
        while (at_ < tokens_.size()) {
            if (!is_name(at_)) {
                ++at_;
                continue;
            }
            const std::size_t name = at_;
            const std::size_t value = begin_of_value(name);
            at_ = std::max(end_of_value(value), name + 1);
            each(name, value, at_);
        }
    }

private:
    bool is(std::size_t i, TokenKind kind) const { return i < tokens_.size() && tokens_[i].kind == kind; }
    std::string_view text(std::size_t i) const { return i < tokens_.size() ? s_.word(tokens_[i]) : std::string_view(); }
    bool truth(std::size_t i) const { return same_word(text(i), "true") || same_word(text(i), "false"); }
    bool is_name(std::size_t i) const { return is(i, TokenKind::word) && !looks_numeric(text(i)) && text(i) != "="; }
    bool begins_value(std::size_t i) const {
        return is(i, TokenKind::open) || (is(i, TokenKind::word) && (plausible_number(text(i)) || truth(i)));
    }
    // name[2] value, name = value
    std::size_t begin_of_value(std::size_t name) const {
        std::size_t i = name + 1;
        if (is(i, TokenKind::open) && tokens_[i].glued && text(i) == "[" && is(i + 1, TokenKind::word) &&
            is(i + 2, TokenKind::close) && begins_value(i + 3))
            i += 3;
        return text(i) == "=" ? i + 1 : i;
    }
    std::size_t end_of_value(std::size_t value) const {
        if (is(value, TokenKind::open)) {
            std::size_t i = value + 1;
            // A name on a new line, or with a value of its own, is the next uniform: this bracket is not closed.
            for (; i < tokens_.size() && tokens_[i].kind != TokenKind::close; ++i)
                if (tokens_[i].kind == TokenKind::open || (is_name(i) && !truth(i) && tokens_[i].line_start)) return i;
            return i + 1;
        }
        std::size_t i = value;
        while (is(i, TokenKind::comma) || (is(i, TokenKind::word) && (plausible_number(text(i)) || truth(i)))) ++i;
        return std::max(i, value);
    }
    void skip_program() {
        if (!named_ || at_ >= tokens_.size()) return;
        if (is(1, TokenKind::word) && is(2, TokenKind::open)) return;  // the program has no name
        at_ = 2;
        while (at_ < tokens_.size() && !is(at_, TokenKind::open)) {
            if (is(at_, TokenKind::word) && !looks_numeric(text(at_)) && begins_value(begin_of_value(at_))) return;
            // The last name has no value yet: it is being written.
            if (at_ + 1 == tokens_.size() && is_name(at_)) return;
            ++at_;
        }
    }

    const Statements& s_;
    std::span<const Token> tokens_;
    bool named_ = true;
    std::size_t at_ = 1;
};

}  // namespace

UniformPlace uniform_at(const Statements& statements, const SceneStatement& statement, std::size_t token) {
    const std::span<const Token> tokens = statements.tokens_of(statement);
    UniformPlace place;
    if (token <= 1) return place;
    place.part = UniformPlace::Part::name;
    UniformWalk(statements, statement).run([&](std::size_t name, std::size_t value, std::size_t end) {
        const bool unfinished =
            end > tokens.size() ||
            (value < end && tokens[value].kind == TokenKind::open &&
             tokens[std::min(end, tokens.size()) - 1].kind != TokenKind::close && end >= tokens.size());
        const bool none = value >= end;
        if (token <= name || (token >= end && !unfinished && !(none && token == name + 1))) return;
        place.part = UniformPlace::Part::value;
        place.name = base_name(statements.word(tokens[name]));
        place.number = 0;
        place.bracket = value < token && value < tokens.size() && tokens[value].kind == TokenKind::open
                            ? statements.word(tokens[value])[0]
                            : '\0';
        for (std::size_t i = value; i < std::min(token, tokens.size()); ++i)
            if (tokens[i].kind == TokenKind::word) ++place.number;
    });
    return place;
}

std::vector<WrittenUniform> written_uniforms(const Statements& statements, const SceneStatement& statement) {
    const std::span<const Token> tokens = statements.tokens_of(statement);
    std::vector<WrittenUniform> found;
    UniformWalk(statements, statement).run([&](std::size_t name, std::size_t value, std::size_t end) {
        WrittenUniform one;
        one.name = base_name(statements.word(tokens[name]));
        one.name_span = {statements.file, tokens[name].begin,
                         tokens[name].begin + static_cast<std::uint32_t>(one.name.size())};
        end = std::min(end, tokens.size());
        if (value < end) {
            one.value_begin = tokens[value].begin;
            one.value_end = tokens[end - 1].end;
        }
        found.push_back(one);
    });
    return found;
}

}  // namespace snell::language
