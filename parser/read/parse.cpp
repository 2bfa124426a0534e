#include "parser/read/parse.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "parser/commands/commands.h"
#include "parser/read/builder.h"
#include "parser/read/match.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"

namespace snell {
namespace {

struct OpenText {
    FileId file;
    std::string name;
    Span included_at;
};

// Lines of uniforms behind a Program that does not go on to them.
struct LostLines {
    Diagnostic diagnostic;
    Span program;  // the statement; empty: others stand between
    std::string name;
    std::uint32_t begin = 0, end = 0;  // of the last of these lines
    bool braced = false;               // braces are around them
};

class SceneParser {
public:
    SceneParser(Sources& sources, const IncludeReader& reader, const Limits& limits, std::size_t text_bytes,
                Scene& scene)
        : sources_(sources),
          reader_(reader),
          limits_(limits),
          report_(limits.diagnostics),
          builder_(scene, report_, limits, text_bytes) {
        builder_.include = [this](std::string_view name, Span span, Span name_span) { include(name, span, name_span); };
    }

    Diagnostics run(FileId file) {
        read(file, std::string(sources_.name(file)), {});
        builder_.finish();
        return report_.take();
    }

private:
    void read(FileId file, std::string name, Span included_at) {
        const std::string_view text = sources_.text(file);
        if (text.size() > limits_.text_bytes) {
            report_.error("text-too-large", {file, 0, 0},
                          "the text has " + std::to_string(text.size()) + " bytes, and at most " +
                              std::to_string(limits_.text_bytes) + " are read",
                          limit_help(limits_, &Limits::text_bytes));
            return;
        }
        if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
            report_.error("utf-16", {file, 0, 2}, "the text is UTF-16", "save it as UTF-8");
            return;
        }
        open_.push_back({file, std::move(name), included_at});
        names_are_from_here();
        StatementReader reader(text, file, report_);
        Statement statement;
        Arguments arguments;
        Span program;  // the Program that the statement before belongs to
        while (reader.next(statement)) {
            if (++statements_ > limits_.statements) {
                if (statements_ == limits_.statements + 1)
                    report_.error("too-many-statements", reader.span(statement),
                                  "only the first " + std::to_string(limits_.statements) + " statements are read",
                                  limit_help(limits_, &Limits::statements));
                break;
            }
            if (open_.size() == 1) builder_.progress(reader.lexer().position());
            read_statement(reader, statement, arguments, program);
        }
        report_lost_lines();
        reader.report_oddities();
        open_.pop_back();
        names_are_from_here();
    }

    void names_are_from_here() { builder_.from = open_.size() > 1 ? open_.back().name : std::string(); }

    void read_statement(const StatementReader& reader, const Statement& statement, Arguments& arguments,
                        Span& program) {
        const Token& word = statement.command();
        const Command* command = word.kind == TokenKind::word ? find_command(reader.lexer().text(word)) : nullptr;
        if (command == nullptr) {
            unknown(reader, statement, program);
            return;
        }
        report_lost_lines();
        if (!command->takes(ArgumentKind::rest)) report_decimal_commas(statement, reader.lexer(), report_);
        const bool is_program = command->name == "Program";
        std::optional<LostLines> block = is_program ? braces(statement, reader.lexer()) : std::nullopt;
        const Statement read = block ? Statement{unbraced_} : statement;
        const bool good = match(*command, read, reader, report_, arguments);
        if (good) command->handler(builder_, arguments);
        program = good && is_program ? reader.span(read) : Span{};
        if (!block) return;
        block->program = program;
        lost_ = std::move(block);
    }

    static bool has_surplus_brace(std::span<const Token> tokens, const Lexer& lexer) {
        const auto of = [&](TokenKind kind) { return ranges::count(tokens, kind, &Token::kind); };
        return lexer.text(tokens.back()) == "}" && of(TokenKind::close) > of(TokenKind::open);
    }

    // `Program Name {` … `}`: in `unbraced_` the statement without its braces. They are not those of a colour.
    std::optional<LostLines> braces(const Statement& statement, const Lexer& lexer) {
        unbraced_.assign(statement.tokens.begin(), statement.tokens.end());
        const auto open = ranges::find(unbraced_, TokenKind::open, &Token::kind);
        const auto name = static_cast<std::size_t>(open - unbraced_.begin()) + 1;
        if (name < 3 || name > unbraced_.size() || lexer.text(*open) != "{") return std::nullopt;
        const std::span<const Token> rest = std::span(unbraced_).subspan(name);
        const bool closed = rest.size() == 1 && rest[0].kind == TokenKind::close;
        if (!rest.empty() && !closed && !looks_like_uniform(rest, lexer, true)) return std::nullopt;
        LostLines block = block_at(lexer.span(*open), rest.empty() ? "\\" : "");
        unbraced_.erase(open);
        if (has_surplus_brace(unbraced_, lexer)) {
            block.diagnostic.fixes.push_back({lexer.span(unbraced_.back()), ""});
            unbraced_.pop_back();
        }
        return block;
    }

    static LostLines block_at(Span brace, std::string_view instead) {
        LostLines block{{}, {}, {}, 0, 0, true};
        block.diagnostic = {
            Severity::error, "wrong-bracket", brace, "the uniforms of a program are not written in braces", {}, {}};
        block.diagnostic.fixes.push_back({brace, std::string(instead)});
        return block;
    }

    // A brace alone on its line, behind a Program or its uniforms.
    bool take_brace(const Lexer& lexer, const Statement& statement, Span program) {
        const Span span = lexer.span(statement.command());
        const std::string_view brace = lexer.text(statement.command());
        if (statement.tokens.size() > 1 || program == Span{}) return false;
        if (brace == "{" && !lost_) {
            lost_ = block_at({span.file, program.end, span.end}, " \\");
            lost_->diagnostic.span = span;
            lost_->program = program;
        } else if (brace == "}" && lost_ && lost_->braced) {
            lost_->diagnostic.fixes.push_back({span, ""});
            report_lost_lines();
        } else {
            return false;
        }
        return true;
    }

    void unknown(const StatementReader& reader, const Statement& statement, Span program) {
        const Lexer& lexer = reader.lexer();
        if (take_brace(lexer, statement, program)) return;
        const Span span = lexer.span(statement.command());
        const std::string word(lexer.text(statement.command()).substr(0, 60));
        Program* const current = builder_.program();
        const bool valued = looks_like_uniform(statement.tokens, lexer, program != Span{});
        const bool bracketed = valued && statement.tokens[1].kind == TokenKind::open;
        const std::string_view bare = std::string_view(word).substr(0, word.find('('));
        const std::string_view near = nearest(bare, command_names());
        // 'Spher 1' behind a Program is a slip for 'Sphere'; 'uScale 1' is a uniform however near 'Scale' is.
        const bool slip = !bracketed && !near.empty() && !(word.size() > 1 && word[0] == 'u' && upper(word[1]));
        if (valued && !slip && current != nullptr && (bracketed || program != Span{})) {
            take_uniforms(reader, statement, *current, program);
            return;
        }
        if (unparenthesised(reader, statement)) return;
        const bool argument = statement.tokens.size() > 1;
        std::string help = help_for_opengl(bare, argument ? lexer.text(statement.tokens[1]) : std::string_view());
        const std::string_view begun = begun_command(bare), name = begun.empty() ? near : begun;
        const bool meant = help.empty() && !name.empty();
        if (meant) help = "did you mean '" + std::string(name) + "'?";
        if (help.empty() && bare.find('.') != std::string::npos)
            help = "a file name is not a command: if it belongs to the statement before, end that line with '\\'";
        if (valued && bracketed && current == nullptr) help = "uniforms are given by a Program statement";
        if (statement.command().kind != TokenKind::word) help = "a statement begins with a command";
        Diagnostic& said = report_.error("unknown-command", span, "unknown command '" + word + "'", std::move(help));
        const auto end = span.begin + static_cast<std::uint32_t>(bare.size());
        if (meant) said.fixes.push_back({{span.file, span.begin, bare == word ? span.end : end}, std::string(name)});
    }

    // 'Frag' is nearer to 'Flat', but begins 'Fragment': the shortest command that the word begins. Of textures, most
    // have two dimensions.
    static std::string_view begun_command(std::string_view word) {
        if (same_word(word, "Texture")) return "Texture2D";
        std::string_view shortest;
        for (const std::string_view name : command_names())
            if (word.size() > 2 && same_word(name.substr(0, word.size()), word) &&
                (shortest.empty() || name.size() < shortest.size()))
                shortest = name;
        return shortest;
    }

    // 'Sphere(1., 20, 20);' as in C.
    bool unparenthesised(const StatementReader& reader, const Statement& statement) {
        const Span span = reader.span(statement);
        std::string text(sources_.text(span.file).substr(span.begin, span.end - span.begin));
        const std::size_t open = text.find('(');
        const Command* command = open < text.size() ? find_command(text.substr(0, open)) : nullptr;
        if (command == nullptr) return false;
        text.replace(0, open, command->name);
        const bool plain = text.find_first_of("\"\\#\n{[<") == std::string::npos && ranges::count(text, '(') == 1;
        std::string meant;
        for (const char c : text) {
            const bool blank = std::string_view("(),; \t").find(c) != std::string_view::npos;
            if (!blank)
                meant += c;
            else if (!meant.ends_with(' '))
                meant += ' ';
        }
        if (meant.ends_with(' ')) meant.pop_back();
        const Span word = reader.lexer().span(statement.command());
        Diagnostic& said = report_.error(
            "unknown-command", word,
            "unknown command '" + std::string(reader.lexer().text(statement.command()).substr(0, 60)) + "'",
            "write arguments without parentheses" + (plain ? ": " + meant : std::string()));
        if (plain) said.fixes.push_back({span, meant});
        return true;
    }

    static bool upper(char c) { return c >= 'A' && c <= 'Z'; }

    int line_of(FileId file, std::uint32_t offset) const { return sources_.position(file, offset).line; }

    // A missing '\\' makes a statement of every line after it, but is a single mistake.
    void report_lost_lines() {
        if (!lost_) return;
        const Span program = lost_->program;
        Diagnostic& d = lost_->diagnostic;
        if (program != Span{}) {
            const int begin = line_of(program.file, program.begin), end = line_of(program.file, program.end);
            const int last = line_of(program.file, lost_->begin) - 1;
            const std::string lines =
                (last <= end ? "line " + std::to_string(end)
                             : "each line from " + std::to_string(end) + " to " + std::to_string(last)) +
                " with '\\'";
            if (lost_->braced)
                d.help = lost_->end == 0 ? "remove them" : "remove them, and end " + lines;
            else
                d.help = "'Program' on line " + std::to_string(begin) + " is not continued: end " + lines;
            d.notes.push_back({program, "the values are taken for this program all the same"});
        } else {
            d.help =
                "it reads like a uniform and is taken for program '" + lost_->name + "'; write it on the Program line";
        }
        Diagnostic& reported = report_.error(d.code, d.span, std::move(d.message), std::move(d.help));
        reported.notes = std::move(d.notes);
        reported.also = std::move(d.also);
        reported.fixes = std::move(d.fixes);
        lost_.reset();
    }

    // A uniform on a line of its own: the Program before it lost its backslash.
    void take_uniforms(const StatementReader& reader, const Statement& statement, Program& current, Span program) {
        const Lexer& lexer = reader.lexer();
        const Span span = lexer.span(statement.command());
        const std::uint32_t end = statement.tokens.back().end;
        const auto goes_on = [&](std::uint32_t at) { return Fix{{span.file, at, at}, " \\"}; };
        std::span<const Token> tokens = statement.tokens;
        if (lost_ && lost_->program == program) {
            if (!lost_->braced) lost_->diagnostic.also.push_back(span);
            if (lost_->end > 0) lost_->diagnostic.fixes.push_back(goes_on(lost_->end));
            if (lost_->braced && has_surplus_brace(tokens, lexer)) {
                lost_->diagnostic.fixes.push_back({lexer.span(tokens.back()), ""});
                tokens = tokens.first(tokens.size() - 1);
            }
            lost_->begin = span.begin;
            lost_->end = tokens.back().end;
        } else {
            report_lost_lines();
            lost_ = LostLines{{}, program, current.name, span.begin, end};
            if (program != Span{}) lost_->diagnostic.fixes.push_back(goes_on(program.end));
            lost_->diagnostic.code = "unknown-command";
            lost_->diagnostic.span = span;
            lost_->diagnostic.message =
                "unknown command '" + std::string(lexer.text(statement.command()).substr(0, 60)) + "'";
        }
        UniformList list = read_uniforms(tokens, lexer, report_, limits_, false);
        for (UniformValue& u : list.uniforms) {
            const auto same = std::find_if(current.uniforms.begin(), current.uniforms.end(),
                                           [&](const UniformValue& other) { return other.name == u.name; });
            if (same == current.uniforms.end()) {
                if (current.uniforms.size() < limits_.uniforms) current.uniforms.push_back(std::move(u));
            } else {
                *same = std::move(u);
            }
        }
    }

    void include(std::string_view name, Span span, Span name_span) {
        if (!reader_) {
            report_.error("include-unavailable", span, "other files cannot be read here");
            return;
        }
        if (open_.size() > limits_.include_depth) {
            report_.error("include-too-deep", span,
                          "files include each other more than " + std::to_string(limits_.include_depth) + " deep",
                          limit_help(limits_, &Limits::include_depth));
            return;
        }
        // Without a limit, files that include others twice each would be read 2^depth times.
        if (++included_ > limits_.includes) {
            if (included_ == limits_.includes + 1)
                report_.error("too-many-includes", span,
                              "only the first " + std::to_string(limits_.includes) + " files are included",
                              limit_help(limits_, &Limits::includes));
            return;
        }
        std::optional<IncludedText> included = reader_(open_.back().name, file_name(name));
        if (!included || included->name.empty()) {
            const std::string near = included ? suggested(included->nearest) : std::string();
            const std::string why = included && !included->why.empty() ? ": " + included->why : std::string();
            Diagnostic& said =
                report_.error("include-not-found", span, "'" + std::string(name) + "' cannot be read" + why,
                              near.empty() ? near : "did you mean '" + near + "'?");
            if (!near.empty()) said.fixes.push_back({name_span, text_of::name(near)});
            return;
        }
        const auto same =
            std::find_if(open_.begin(), open_.end(), [&](const OpenText& text) { return text.name == included->name; });
        if (same != open_.end()) {
            report_.error("include-cycle", span, "'" + included->name + "' includes itself");
            return;
        }
        if (!included->exact.empty())
            report_
                .warning("file-inexact", name_span, inexact_name(file_name(name), included->name),
                         std::string(inexact_name_help))
                .fixes.push_back({name_span, text_of::name(included->exact)});
        const FileId file = sources_.add(included->name, std::move(included->text));
        read(file, std::move(included->name), span);
    }

    // A scene that is being read cannot be the one that was meant.
    std::string suggested(std::string_view nearest) const {
        const auto last = [](std::string_view path) { return path.substr(path.rfind('/') + 1); };
        const bool open = ranges::any_of(open_, [&](const OpenText& text) { return last(text.name) == last(nearest); });
        return open ? std::string() : std::string(nearest);
    }

    Sources& sources_;
    const IncludeReader& reader_;
    const Limits& limits_;
    Collector report_;
    Builder builder_;
    std::vector<OpenText> open_;
    std::uint64_t statements_ = 0, included_ = 0;
    std::optional<LostLines> lost_;
    std::vector<Token> unbraced_;
};

// Of a file that is included again, the same is wrong again.
Diagnostics said_once(Diagnostics all, const Sources& sources) {
    if (sources.size() < 2) return all;
    std::set<std::tuple<std::string_view, std::uint32_t, std::string_view, std::string_view>> said;
    Diagnostics once;
    for (const Diagnostic& d : all.items())
        if (said.emplace(sources.name(d.span.file), d.span.begin, d.code, d.message).second) once.add(d);
    return once;
}

}  // namespace

std::string inexact_name(std::string_view name, std::string_view path) {
    return "there is no file '" + std::string(name) + "'; '" + std::string(path) + "' is used";
}

Parsed parse(FileId file, Sources& sources, const IncludeReader& include, const Limits& limits) {
    Parsed parsed;
    parsed.diagnostics =
        said_once(SceneParser(sources, include, limits, sources.text(file).size(), parsed.scene).run(file), sources);
    return parsed;
}

}  // namespace snell
