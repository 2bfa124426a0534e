#include "src/language/services.h"

#include <algorithm>
#include <optional>

#include "parser/commands/commands.h"
#include "parser/read/syntax.h"
#include "parser/text/words.h"

namespace snell::language {
namespace {

constexpr std::uint32_t block_step = 4;  // columns of a block, and of continued lines below nothing
constexpr std::uint32_t tab_stop = 8;    // columns
constexpr std::uint32_t deepest = 16;    // blocks; those inside are indented no further, so that texts stay small
constexpr std::uint32_t rightmost = 60;  // column below which lines are continued

struct LayoutRow {
    std::size_t begin = 0, content = 0, end = 0;  // after a byte-order mark, after blanks and tabs, before the line end
    bool empty() const { return content == end; }
};

// A statement, or a comment before, between or after statements.
struct LayoutPiece {
    std::size_t first = 0, last = 0;  // rows
    std::size_t token = 0, tokens = 0;
    const Command* command = nullptr;
    bool comment = false;
};

bool layout_blank(char c) { return c == ' ' || c == '\t'; }

std::vector<LayoutRow> rows_of(std::string_view text) {
    std::vector<LayoutRow> rows;
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (;;) {
        LayoutRow row{at, at, std::min(text.find_first_of("\r\n", at), text.size())};
        while (row.content < row.end && layout_blank(text[row.content])) ++row.content;
        // At the beginning of the text these bytes would be a mark of its encoding.
        if (rows.empty() && row.content < row.end && static_cast<unsigned char>(text[row.content]) >= 0x80)
            row.content = row.begin;
        rows.push_back(row);
        if (row.end == text.size()) return rows;
        at = row.end + (text.substr(row.end, 2) == "\r\n" ? 2 : 1);
    }
}

// Columns as most terminals and editors show them. `column` is that of `from`.
std::uint32_t column_after(std::string_view text, std::size_t from, std::size_t to, std::uint32_t column) {
    while (from < to) {
        const utf8::Char c = utf8::decode(text, from);
        if (c.code == '\t')
            column += tab_stop - column % tab_stop;
        else
            column += c.valid ? static_cast<std::uint32_t>(utf8::width(c.code)) : 1;
        from += c.length;
    }
    return column;
}

// The parser's own statements, and the comments around them.
struct LayoutText {
    std::string_view text;
    std::vector<LayoutRow> rows;
    std::vector<Token> tokens;  // of all statements
    std::vector<LayoutPiece> pieces;

    explicit LayoutText(std::string_view of) : text(of), rows(rows_of(of)) {
        Collector report(0);
        StatementReader reader(text, 0, report);
        Statement statement;
        std::size_t next = 0;  // row
        while (reader.next(statement)) {
            LayoutPiece piece;
            piece.first = row_of(statement.command().begin, next);
            comments(next, piece.first);
            const std::size_t after = reader.lexer().position();
            next = row_of(after, piece.first);
            if (after > rows[next].begin || next == piece.first) ++next;  // the text ends in this row
            piece.last = next - 1;
            piece.token = tokens.size();
            piece.tokens = statement.tokens.size();
            const Token& word = statement.command();
            if (word.kind == TokenKind::word) piece.command = find_command(reader.lexer().text(word));
            tokens.insert(tokens.end(), statement.tokens.begin(), statement.tokens.end());
            pieces.push_back(piece);
        }
        comments(next, rows.size());
    }

private:
    // The row of an offset that is not before the row `from`.
    std::size_t row_of(std::size_t offset, std::size_t from) const {
        while (from + 1 < rows.size() && rows[from + 1].begin <= offset) ++from;
        return from;
    }
    void comments(std::size_t from, std::size_t to) {
        for (std::size_t row = from; row < to; ++row)
            if (!rows[row].empty()) pieces.push_back({row, row, tokens.size(), 0, nullptr, true});
    }
};

// ---- blocks -----------------------------------------------------------------------------------------

// How deep each piece is. A block that has no end in the text indents nothing: scenes may end it in another file, or
// not at all.
class Blocks {
public:
    explicit Blocks(const LayoutText& text) : depths_(text.pieces.size() + 1) {
        for (std::size_t i = 0; i < text.pieces.size(); ++i) read(text, i);
        int depth = 0;
        for (int& d : depths_) d = depth += d;
        raise_comments(text);
    }
    std::uint32_t column(std::size_t piece) const {
        return block_step * std::min(static_cast<std::uint32_t>(depths_[piece]), deepest);
    }

private:
    void block(std::size_t begin, std::size_t end) {
        ++depths_[begin + 1];
        --depths_[end];
    }
    void read(const LayoutText& text, std::size_t i) {
        const LayoutPiece& piece = text.pieces[i];
        if (piece.command == nullptr) return;
        const std::string_view name = piece.command->name;
        if (name == "RenderToTexture" || name == "RenderToCube") {
            if (pass_) {
                block(*pass_, i);
                pushes_.resize(outside_);
            }
            pass_.reset();
            list_.reset();
            if (name == "RenderToCube" || piece.tokens > 1) pass_ = i;
            // A PopMatrix of this pass ends no block that was begun outside of it.
            outside_ = pass_ ? pushes_.size() : 0;
        } else if (name == "PushMatrix") {
            pushes_.push_back(i);
        } else if (name == "PopMatrix" && pushes_.size() > outside_) {
            block(pushes_.back(), i);
            pushes_.pop_back();
            list_.reset();
        } else if (name == "glBegin") {
            list_ = i;
        } else if (name == "glEnd" && list_) {
            block(*list_, i);
            list_.reset();
        }
    }
    // Comments right above the statement that begins or ends a pass belong to it.
    void raise_comments(const LayoutText& text) {
        for (std::size_t i = text.pieces.size(); i-- > 1;) {
            const LayoutPiece &above = text.pieces[i - 1], &piece = text.pieces[i];
            const bool belongs = piece.comment ? raised_ : piece.command != nullptr && begins_pass(*piece.command);
            raised_ = belongs && above.comment && above.last + 1 == piece.first;
            if (raised_) depths_[i - 1] = depths_[i];
        }
    }
    static bool begins_pass(const Command& command) { return command.name.starts_with("RenderTo"); }

    std::vector<int> depths_;
    std::optional<std::size_t> pass_, list_;  // the open ones
    std::vector<std::size_t> pushes_;
    std::size_t outside_ = 0;  // how many of them were pushed before the pass
    bool raised_ = false;
};

// ---- lines of a statement -----------------------------------------------------------------------------

// One line of a statement: where it begins now, and where its backslash was and is.
struct LayoutLine {
    std::size_t row = 0;
    std::uint32_t column = 0;  // of its content
    std::size_t backslash = std::string_view::npos, content_end = 0;
    std::uint32_t was = 0, is = 0, end = 0;  // columns of the backslash, and of the end of what stands before it
};

class StatementLayout {
public:
    StatementLayout(const LayoutText& text, const LayoutPiece& piece, std::uint32_t column)
        : text_(text), piece_(piece) {
        std::size_t token = piece.token;
        for (std::size_t row = piece.first; row <= piece.last; ++row) {
            if (text.rows[row].empty()) continue;
            LayoutLine line;
            line.row = row;
            line.column = row == piece.first ? column : continued(column);
            read(line, token);
            lines_.push_back(line);
        }
    }

    void edit(FileId file, std::vector<Edit>& edits) const {
        const std::optional<std::uint32_t> aligned = backslashes();
        for (const LayoutLine& line : lines_) {
            const LayoutRow& row = text_.rows[line.row];
            // A backslash alone in its line has no content that would be indented.
            if (line.backslash != row.content) change(file, edits, row.begin, row.content, line.column);
            if (aligned && line.backslash != std::string_view::npos && line.is != *aligned)
                change(file, edits, line.content_end, line.backslash, *aligned - line.end);
        }
    }

private:
    std::uint32_t continued(std::uint32_t column) const {
        const std::optional<std::uint32_t> below = brackets_.empty() ? argument_ : std::optional(brackets_.back());
        return below && *below <= rightmost ? *below : column + block_step;
    }

    // Follows the tokens of the line, for what the lines after it stand below.
    void read(LayoutLine& line, std::size_t& token) {
        const LayoutRow& row = text_.rows[line.row];
        std::size_t at = row.content;
        std::uint32_t column = line.column;
        for (; token < piece_.token + piece_.tokens && text_.tokens[token].begin < row.end; ++token) {
            const Token& t = text_.tokens[token];
            column = column_after(text_.text, at, t.begin, column);
            if (token == piece_.token + 1 && line.row == piece_.first) argument_ = column;
            column = column_after(text_.text, t.begin, t.end, column);
            at = t.end;
            if (t.kind == TokenKind::open) brackets_.push_back(column);
            if (t.kind == TokenKind::close && !brackets_.empty()) brackets_.pop_back();
        }
        line.content_end = at == row.content ? row.begin : at;
        line.end = at == row.content ? 0 : column;
        while (at < row.end && layout_blank(text_.text[at])) ++at;
        if (at == row.end || text_.text[at] != '\\') return;
        line.backslash = at;
        line.was = column_after(text_.text, row.begin, at, 0);
        line.is = column_after(text_.text, line.content_end, at, line.end);
    }

    // The column of all backslashes, if they stand below each other and should stay so.
    std::optional<std::uint32_t> backslashes() const {
        std::size_t count = 0;
        std::uint32_t was = 0, column = 0;
        bool apart = false;  // otherwise one blank before each, which lines of equal length have, too
        for (const LayoutLine& line : lines_) {
            if (line.backslash == std::string_view::npos) continue;
            if (count++ > 0 && line.was != was) return std::nullopt;
            was = line.was;
            const std::string_view before = text_.text.substr(line.content_end, line.backslash - line.content_end);
            apart = apart || before.size() > 1 || before == "\t";
            column = std::max(column, line.end + (before.empty() ? 0 : 1));
        }
        return count > 1 && apart ? std::optional(std::max(was, column)) : std::nullopt;
    }

    void change(FileId file, std::vector<Edit>& edits, std::size_t begin, std::size_t end, std::uint32_t blanks) const {
        std::string text(blanks, ' ');
        if (text_.text.substr(begin, end - begin) != text)
            edits.push_back(
                {{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}, std::move(text)});
    }

    const LayoutText& text_;
    const LayoutPiece& piece_;
    std::vector<LayoutLine> lines_;
    std::optional<std::uint32_t> argument_;
    std::vector<std::uint32_t> brackets_;  // columns after those that are open
};

bool readable_scene(std::string_view text) {
    return text.size() <= Limits{}.text_bytes && !text.starts_with("\xFF\xFE") && !text.starts_with("\xFE\xFF");
}

}  // namespace

std::vector<Edit> layout_edits(std::string_view text, FileId file, std::uint32_t begin, std::uint32_t end) {
    std::vector<Edit> edits;
    if (!readable_scene(text)) return edits;
    const LayoutText read(text);
    const Blocks blocks(read);
    for (std::size_t i = 0; i < read.pieces.size(); ++i) {
        const LayoutPiece& piece = read.pieces[i];
        if (!piece.comment && piece.command == nullptr) continue;
        if (read.rows[piece.last].end < begin || read.rows[piece.first].begin > end) continue;
        StatementLayout(read, piece, blocks.column(i)).edit(file, edits);
    }
    return edits;
}

std::string formatted(std::string_view text) { return with_edits(text, 0, layout_edits(text)); }

}  // namespace snell::language
