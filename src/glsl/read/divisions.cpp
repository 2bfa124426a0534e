#include "src/glsl/read/divisions.h"

#include <algorithm>
#include <string>
#include <utility>

#include "src/glsl/read/lexer.h"

namespace snell::glsl {

namespace {

class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    Divisions scan() {
        for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
            const Lexeme token = lex(text_, at_);
            if (fresh_ && token.text == "#")
                directive();
            else
                add(token);
            fresh_ = false;
        }
        end_statement();
        return std::move(divisions_);
    }

private:
    void skip_blanks() {
        const std::size_t end = skip_trivia(text_, at_).end;
        while (at_ < end) {
            const char c = text_[at_];
            if (c == '/') {
                at_ = std::min(end_of_comment(), end);
            } else if (c == '\\') {
                at_ += text_.substr(at_ + 1, 2) == "\r\n" ? 3 : 2;
            } else {
                ++at_;
                if (c != '\n') continue;
                divisions_.starts.push_back(at_);
                fresh_ = true;
            }
        }
    }

    // As skip_trivia reads it. A comment of one line ends before its line end.
    std::size_t end_of_comment() const {
        std::size_t i = at_ + 2;
        if (text_[at_ + 1] == '*') {
            const std::size_t close = text_.find("*/", i);
            return close == std::string_view::npos ? text_.size() : close + 2;
        }
        while (i < text_.size() && text_[i] != '\n') i += text_[i] == '\\' ? 2 : 1;
        return i;
    }

    void directive() {
        end_statement();
        const std::size_t end = directive_end(text_, at_);
        const std::string_view word = lex(text_, skip_trivia(text_, at_ + 1).end).text;
        divisions_.directives.push_back({{at_, end}, word});
        at_ = end;
    }

    void add(const Lexeme& token) {
        const std::string_view text = token.text;
        if (statement_.begin == statement_.end) statement_.begin = at_;
        at_ += text.size();
        statement_.end = at_;
        const bool list = text == "{" && (depth_ > 0 || previous_ == "=" || previous_ == ",");
        if (text == "(" || text == "[" || list)
            ++depth_;
        else if (depth_ > 0 && (text == ")" || text == "]" || text == "}"))
            --depth_;
        else if (depth_ == 0 && (text == ";" || text == "{" || text == "}"))
            end_statement();
        previous_ = text;
    }

    void end_statement() {
        if (statement_.begin < statement_.end) divisions_.statements.push_back(statement_);
        statement_ = {at_, at_};
    }

    std::string_view text_, previous_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool fresh_ = true;  // nothing but blanks was read since the line began
    Extent statement_;
    Divisions divisions_{{0}, {}, {}};
};

}  // namespace

Divisions divisions(std::string_view text) { return Scanner(text).scan(); }

bool whole_groups(std::string_view text) {
    const std::string cleaned = clean(text).text;
    int depth = 0;
    for (const Directive& directive : divisions(cleaned).directives) {
        const std::string_view word = directive.word;
        if (word == "if" || word == "ifdef" || word == "ifndef") ++depth;
        if (word == "version" || ((word == "else" || word == "elif") && depth == 0)) return false;
        if (word == "endif" && --depth < 0) return false;
    }
    return depth == 0;
}

}  // namespace snell::glsl
