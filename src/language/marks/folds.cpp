// What can be folded: regions of several lines.
#include "parser/text/ranges.h"
#include "src/language/marks/statement_kinds.h"
#include "src/language/names/texts.h"
#include "src/language/services.h"

namespace snell::language {

namespace {

bool several_lines(std::string_view text, const Span& span) {
    return text.substr(span.begin, span.end - span.begin).find_first_of("\r\n") != std::string_view::npos;
}

// Comments on lines of their own that follow each other are one.
void fold_comments(std::string_view text, const std::vector<Span>& comments, std::vector<Fold>& found) {
    Span run{};
    bool open = false;
    const auto close = [&] {
        if (open && several_lines(text, run)) found.push_back({Fold::Kind::comment, run});
        open = false;
    };
    for (const Span& comment : comments) {
        std::size_t start = comment.begin;
        while (start > 0 && (text[start - 1] == ' ' || text[start - 1] == '\t')) --start;
        const bool own_line = start == 0 || text[start - 1] == '\n' || text[start - 1] == '\r';
        std::size_t lines = 0;
        bool blanks = own_line && open;
        for (std::size_t i = run.end; blanks && i < comment.begin; ++i) {
            lines += text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n") ? 1u : 0u;
            blanks = text[i] == ' ' || text[i] == '\t' || text[i] == '\n' || text[i] == '\r';
        }
        if (blanks && lines <= 1) {
            run.end = comment.end;
            continue;
        }
        close();
        run = comment;
        open = own_line || several_lines(text, comment);
    }
    close();
}

class SceneFolds {
public:
    explicit SceneFolds(const Statements& s) : s_(s) {}

    std::vector<Fold> run() {
        std::vector<std::uint32_t> lists, matrices;
        for (const SceneStatement& statement : s_.items) {
            const Span span = s_.span(statement);
            add(span);
            if (statement.command != nullptr) {
                const std::string_view name = statement.command->name;
                if (begins_pass(*statement.command)) close(program_), close(pass_), pass_ = span.begin;
                if (name == "Program") close(program_), program_ = span.begin;
                match(name == "glBegin", name == "glEnd", span, lists);
                match(name == "PushMatrix", name == "PopMatrix", span, matrices);
            }
            end_ = span.end;
        }
        close(program_);
        close(pass_);
        fold_comments(s_.text, s_.comments, found_);
        return std::move(found_);
    }

private:
    void add(const Span& span) {
        if (several_lines(s_.text, span)) found_.push_back({Fold::Kind::region, span});
    }
    void close(std::optional<std::uint32_t>& begin) {
        if (!begin) return;
        const Span span{s_.file, *begin, end_};
        // A statement of several lines that nothing follows is folded already.
        if (found_.empty() || !(found_.back().span == span)) add(span);
        begin.reset();
    }
    void match(bool opens, bool closes, const Span& span, std::vector<std::uint32_t>& open) {
        if (opens) open.push_back(span.begin);
        if (!closes || open.empty()) return;
        add({s_.file, open.back(), span.end});
        open.pop_back();
    }

    const Statements& s_;
    std::vector<Fold> found_;
    std::optional<std::uint32_t> pass_, program_;
    std::uint32_t end_ = 0;  // of the statement before
};

std::vector<Fold> shader_folds(const Outline& outline) {
    std::vector<Fold> found;
    for (const Span& braces : outline.braces) found.push_back({Fold::Kind::region, braces});
    std::vector<std::uint32_t> open;
    for (const ShaderDirective& directive : outline.directives) {
        const bool begins = directive.word == "if" || directive.word == "ifdef" || directive.word == "ifndef";
        const bool goes_on = directive.word == "else" || directive.word == "elif";
        if ((goes_on || directive.word == "endif") && !open.empty()) {
            // #else stays where it is; #endif is the last line.
            const std::uint32_t end = goes_on ? directive.begin : directive.end;
            std::uint32_t last = end;
            while (goes_on && last > open.back() &&
                   std::string_view(" \t\r\n").find(outline.text[last - 1]) != std::string_view::npos)
                --last;
            const Span span{outline.file, open.back(), last};
            if (several_lines(outline.text, span)) found.push_back({Fold::Kind::region, span});
            open.pop_back();
        }
        if (begins || goes_on) open.push_back(directive.begin);
    }
    fold_comments(outline.text, outline.comments, found);
    return found;
}

}  // namespace

std::vector<Fold> folds(const Project& project, FileId file) {
    Texts texts(project);
    std::vector<Fold> found =
        texts.is_scene(file) ? SceneFolds(texts.statements(file)).run() : shader_folds(texts.outline(file));
    ranges::stable_sort(found, [](const Fold& a, const Fold& b) {  // the outer ones first
        return a.span.begin != b.span.begin ? a.span.begin < b.span.begin : a.span.end > b.span.end;
    });
    return found;
}

}  // namespace snell::language
