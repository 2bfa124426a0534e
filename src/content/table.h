// A table once: its columns and its rows as texts, written for a terminal, as HTML, Markdown and CSV.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace snell::content {

enum class CellKind : std::uint8_t {
    number,  // to the right, on one line
    words,   // to the left, broken where the table would be too wide
    code,    // the same, of a program's text
};

struct Table {
    struct Column {
        std::string name;  // with its unit
        CellKind kind = CellKind::number;
        std::string note = {};  // below its name, where HTML shows it
    };
    struct Cell {
        std::string text;
        std::string html = {};        // what HTML has in its place; empty: the text
        std::string css = {};         // a class in HTML
        std::string attributes = {};  // in HTML, such as " title=\"…\""

        Cell(std::string words) : text(std::move(words)) {}
        Cell(const char* words) : text(words) {}
    };
    struct Row {
        std::vector<Cell> cells;
        bool marked = false;
    };
    std::vector<Column> columns;
    std::vector<Row> rows;
    bool sortable = false;  // in HTML, names of columns are buttons

    // Leaves out the columns that are empty in all rows.
    Table& without_empty();
};

// A column of tables whose rows are made from such a value.
template <class Value>
struct TableColumn {
    std::string_view name;
    CellKind kind;
    std::string (*cell)(const Value&);
};

template <class Value, std::size_t count>
Table table_of(const TableColumn<Value> (&columns)[count], const std::vector<Value>& values) {
    Table table;
    for (const auto& column : columns) table.columns.push_back({std::string(column.name), column.kind});
    for (const Value& value : values) {
        table.rows.emplace_back();
        for (const auto& column : columns) table.rows.back().cells.push_back(column.cell(value));
    }
    return table;
}

// The columns of a terminal that reports keep to.
inline constexpr std::size_t page_columns = 120;

// Lines of at most so many columns of a terminal, broken at blanks if possible, with hidden characters escaped.
std::vector<std::string> wrapped(std::string_view text, std::size_t columns);
// The same as one text whose lines begin with so many blanks.
std::string paragraph(std::string_view text, std::size_t indent, std::size_t columns = page_columns);

// Lines that begin with "* " for marked rows. Numbers are never broken, so that many columns may be wider.
std::string table_text(const Table& table, std::size_t columns = page_columns);
// A <table> that scrolls where it must, whose cells have the class of their kind, and marked rows the class "current".
std::string table_html(const Table& table);
// Marked rows have their first cell in bold.
std::string table_markdown(const Table& table);
// Cells are in quotes where needed; words that spreadsheets would run as a formula begin with '.
std::string table_csv(const Table& table);

// For text and for attributes in quotes, of HTML and XML.
std::string escaped(std::string_view text);

}  // namespace snell::content
