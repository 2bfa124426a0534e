#include "src/content/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "parser/text/words.h"

namespace snell::content {

namespace {

constexpr std::size_t gap = 2, narrowest = 12;

std::size_t width_of(std::string_view text) {
    std::size_t width = 0;
    for (std::size_t at = 0; at < text.size();) {
        const utf8::Char c = utf8::decode(text, at);
        width += static_cast<std::size_t>(utf8::width(c.code));
        at += c.length;
    }
    return width;
}

// As many bytes as fit into the columns, but one character at least.
std::size_t fitting(std::string_view text, std::size_t columns) {
    std::size_t end = utf8::decode(text, 0).length;
    while (end < text.size() && width_of(text.substr(0, end + utf8::decode(text, end).length)) <= columns)
        end += utf8::decode(text, end).length;
    return end;
}

std::size_t longest_word(std::string_view text) {
    std::size_t most = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        most = std::max(most, width_of(text.substr(at, end - at)));
        at = end + 1;
    }
    return most;
}

// Numbers have the width that they need; the others share what is left, the widest giving way first.
std::vector<std::size_t> widths(const Table& table, std::size_t columns) {
    std::vector<std::size_t> result, shared;
    std::size_t left = columns - std::min(columns, gap * table.columns.size());
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        std::size_t width = longest_word(table.columns[i].name);
        for (const Table::Row& row : table.rows) width = std::max(width, width_of(utf8::printable(row.cells[i].text)));
        if (table.columns[i].kind == CellKind::number)
            left -= std::min(left, width);
        else
            shared.push_back(i);
        result.push_back(width);
    }
    std::stable_sort(shared.begin(), shared.end(), [&](std::size_t a, std::size_t b) { return result[a] < result[b]; });
    for (std::size_t n = shared.size(); n > 0; --n) {
        std::size_t& width = result[shared[shared.size() - n]];
        width = std::min(width, std::max(left / n, narrowest));
        left -= std::min(left, width);
    }
    return result;
}

// The cells of a row, each broken into lines; headings stand on the last line.
std::string lines_text(const Table& table, const std::vector<Table::Cell>& cells,
                       const std::vector<std::size_t>& widths, char mark, bool heading) {
    std::vector<std::vector<std::string>> lines;
    std::size_t height = 1;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        lines.push_back(wrapped(cells[i].text, widths[i]));
        height = std::max(height, lines.back().size());
    }
    std::string text;
    for (std::size_t y = 0; y < height; ++y) {
        std::string line(1, y == 0 ? mark : ' ');
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::size_t above = heading ? height - lines[i].size() : 0;
            const std::string part = y < above || y - above >= lines[i].size() ? "" : lines[i][y - above];
            const std::string blanks(widths[i] - std::min(widths[i], width_of(part)), ' ');
            line += (i == 0 ? " " : std::string(gap, ' '));
            line += table.columns[i].kind == CellKind::number ? blanks + part : part + blanks;
        }
        line.resize(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

constexpr std::string_view class_of(CellKind kind) { return kind == CellKind::number ? "number" : "words"; }

std::string cell_html(std::string_view text, CellKind kind) {
    const std::string shown = escaped(utf8::printable(text));
    return kind == CellKind::code && !shown.empty() ? "<code>" + shown + "</code>" : shown;
}

// A bar would begin the next cell, even in code.
std::string cell_markdown(const Table::Column& column, std::string_view text) {
    std::string cell = cell_html(text, column.kind);
    for (std::size_t at = 0; (at = cell.find('|', at)) != cell.npos;) cell.replace(at, 1, "&#124;");
    return cell;
}

std::string cell_csv(std::string_view text, CellKind kind) {
    std::string safe = utf8::printable(text);
    if (kind != CellKind::number && !safe.empty() &&
        std::string_view("=+-@").find(safe.front()) != std::string_view::npos)
        safe = "'" + safe;
    if (safe.find_first_of(",;\"") == safe.npos) return safe;
    std::string quoted = "\"";
    for (const char c : safe) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace

Table& Table::without_empty() {
    for (std::size_t i = columns.size(); i-- > 0;) {
        if (std::any_of(rows.begin(), rows.end(), [i](const Row& row) { return !row.cells[i].text.empty(); })) continue;
        const auto at = static_cast<std::ptrdiff_t>(i);
        columns.erase(columns.begin() + at);
        for (Row& row : rows) row.cells.erase(row.cells.begin() + at);
    }
    return *this;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
    const std::string all = utf8::printable(text);
    std::vector<std::string> lines;
    std::string_view rest = all;
    while (true) {
        rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
        if (rest.empty()) break;
        std::size_t end = fitting(rest, std::max<std::size_t>(columns, 1));
        if (end < rest.size() && rest[end] != ' ')
            if (const std::size_t blank = rest.rfind(' ', end); blank != rest.npos) end = blank;
        std::string_view line = rest.substr(0, end);
        line.remove_suffix(line.size() - 1 - line.find_last_not_of(' '));
        lines.emplace_back(line);
        rest.remove_prefix(end);
    }
    if (lines.empty()) lines.emplace_back();
    return lines;
}

std::string paragraph(std::string_view text, std::size_t indent, std::size_t columns) {
    std::string all;
    for (const std::string& line : wrapped(text, columns - indent)) all += std::string(indent, ' ') + line + "\n";
    return all;
}

std::string table_text(const Table& table, std::size_t columns) {
    const std::vector<std::size_t> wide = widths(table, columns);
    std::vector<Table::Cell> names;
    for (const Table::Column& column : table.columns) names.emplace_back(column.name);
    std::string text = lines_text(table, names, wide, ' ', true);
    for (const Table::Row& row : table.rows) text += lines_text(table, row.cells, wide, row.marked ? '*' : ' ', false);
    return text;
}

std::string table_html(const Table& table) {
    std::string text = "<div class=\"scroll\"><table><thead><tr>";
    for (const Table::Column& column : table.columns) {
        const std::string name = cell_html(column.name, CellKind::words);
        text += fmt::format("<th class=\"{}\" scope=\"col\">{}{}</th>", class_of(column.kind),
                            table.sortable ? "<button>" + name + "</button>" : name,
                            column.note.empty() ? "" : fmt::format("<br><small>{}</small>", escaped(column.note)));
    }
    text += "</tr></thead><tbody>";
    for (const Table::Row& row : table.rows) {
        text += row.marked ? "<tr class=\"current\">" : "<tr>";
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            text += fmt::format(
                "<td class=\"{}{}{}\"{}>{}</td>", class_of(table.columns[i].kind), row.cells[i].css.empty() ? "" : " ",
                row.cells[i].css, row.cells[i].attributes,
                row.cells[i].html.empty() ? cell_html(row.cells[i].text, table.columns[i].kind) : row.cells[i].html);
        text += "</tr>";
    }
    return text + "</tbody></table></div>";
}

std::string table_markdown(const Table& table) {
    std::string text = "|", under = "|";
    for (const Table::Column& column : table.columns) {
        text += fmt::format(" {} |", cell_markdown({}, column.name));
        under += column.kind == CellKind::number ? "--:|" : "---|";
    }
    text += "\n" + under + "\n";
    for (const Table::Row& row : table.rows) {
        text += "|";
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const std::string cell = cell_markdown(table.columns[i], row.cells[i].text);
            const bool bold = row.marked && i == 0;
            text += fmt::format(" {0}{1}{0}{2}|", bold ? "**" : "", cell, cell.empty() ? "" : " ");
        }
        text += "\n";
    }
    return text;
}

std::string table_csv(const Table& table) {
    std::string text;
    const auto add = [&](const auto& cells, const auto& cell) {
        for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : ",") + cell(i);
        text += "\n";
    };
    add(table.columns, [&](std::size_t i) { return cell_csv(table.columns[i].name, CellKind::words); });
    for (const Table::Row& row : table.rows)
        add(row.cells, [&](std::size_t i) { return cell_csv(row.cells[i].text, table.columns[i].kind); });
    return text;
}

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '&')
            safe += "&amp;";
        else if (c == '"')
            safe += "&quot;";
        else if (c == '\'')
            safe += "&#39;";
        else
            safe += c;
    }
    return safe;
}

}  // namespace snell::content
