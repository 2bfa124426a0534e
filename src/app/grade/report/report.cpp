#include "src/app/grade/report/report.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "parser/text/words.h"
#include "src/content/files.h"
#include "src/content/html_page.h"
#include "src/content/replace.h"
#include "src/content/table.h"
#include "src/content/text_forms.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view style =
    R"(:root { --full: #d8f3dc; --part: #fff0c2; --none: #ffd9d6; }
@media (prefers-color-scheme: dark) { :root { --full: #143d20; --part: #4a3a08; --none: #551d1a; } }
p { margin: .5rem 0; max-width: 60rem; } small, figcaption { color: var(--weak); }
th, td { border: 1px solid var(--line); padding: .25rem .5rem; text-align: left; vertical-align: top; overflow-wrap: break-word; max-width: 40rem; }
th { background: var(--panel); } .number { min-width: 4rem; max-width: 9rem; }
th button { all: unset; cursor: pointer; font-weight: bold; } th button:focus-visible { outline: 2px solid currentColor; outline-offset: 2px; }
th[aria-sort=ascending] button::after { content: " \2191"; } th[aria-sort=descending] button::after { content: " \2193"; }
.full { background: var(--full); } .part { background: var(--part); } .none { background: var(--none); }
img { display: block; max-width: 100%; height: auto; } td img { width: 5rem; max-width: none; } td a { display: inline-block; }
.over { position: relative; } .over img + img { position: absolute; inset: 0; clip-path: inset(0 0 0 50%); } input[type=range] { width: 100%; margin: .25rem 0; }
pre { overflow-x: auto; border: 1px solid var(--line); background: var(--panel); padding: .5rem; font: .8125rem/1.4 ui-monospace, monospace; margin: 0; }
.sides { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; } .sides > div { min-width: 0; } mark { background: var(--part); color: inherit; display: block; }
)";

// Nothing is loaded but pictures next to it.
std::string page_of(const std::string& title, std::string body, std::string_view script = {}) {
    return content::html_page({title, std::move(body), style, script, "'self' file:", "snell grade"});
}

using content::CellKind, content::Table;

// A cell whose lines stay, and which may be a link.
Table::Cell cell(const std::string& text, const std::string& link = {}) {
    Table::Cell made(text);
    made.html = shown_text(text);
    if (!link.empty()) made.html = fmt::format("<a href=\"{}\">{}</a>", link, made.html);
    return made;
}

// A class of CSS for a number of points.
std::string class_of(double points, double of) { return points >= of ? "full" : points > 0 ? "part" : "none"; }

}  // namespace

std::vector<Alike> alike_submissions(const Grades& grades) {
    std::vector<const Record*> records;
    for (const GradedSubmission& graded : grades.all) records.push_back(&graded.record);
    return alike_records(records, handed_out(grades.rubric));
}

std::string write_report(const Grades& grades, const std::vector<Alike>& alike, const std::string& output) {
    const fs::path folder(output);
    std::error_code error;
    remove_pairs(output);
    std::set<std::string> students;
    for (const GradedSubmission& graded : grades.all) students.insert(graded.submission.folder);
    remove_former_students(output, students);
    if (!alike.empty()) fs::create_directories(folder / "similar", error);
    std::string wrong;
    const auto write = [&](const fs::path& file, const std::string& text) {
        if (wrong.empty()) wrong = content::replace_file(file.string(), text);
        if (!wrong.empty() && wrong.find('\'') == wrong.npos) wrong = fmt::format("'{}': {}", file.string(), wrong);
    };
    for (const GradedSubmission& graded : grades.all)
        write(fs::path(student_folder(output, graded.submission)) / "index.html", student_page(grades, graded));
    for (std::size_t i = 0; i < alike.size(); ++i)
        write(folder / "similar" / fmt::format("{}.html", i + 1), alike_page(grades, alike[i]));
    write(folder / "results.csv", results_csv(grades));
    write(folder / "results.json", results_json(grades, alike));
    write(folder / "junit.xml", results_junit(grades));
    write(folder / "index.html", index_page(grades, alike));
    return wrong;
}

std::string shown_text(std::string_view text) {
    std::string shown;
    for (const std::string_view part : split(text, '\n')) {
        std::string line;
        for (const char c : part) line += c == '\t' ? std::string(4, ' ') : std::string(1, c);
        if (line.ends_with('\r')) line.pop_back();
        shown += content::escaped(utf8::printable(line)) + '\n';
    }
    if (!text.ends_with('\n') && !shown.empty()) shown.pop_back();
    return shown;
}

// The results for programs: CSV, JSON, and JUnit's XML for CI services.

namespace {

std::string xml(std::string_view text) { return content::escaped(utf8::printable(text)); }

}  // namespace

std::string results_csv(const Grades& grades) {
    constexpr auto words = CellKind::words;
    Table table{{{"submission", words}, {"points"}}, {}};
    for (const RubricItem& item : grades.rubric.items) table.columns.push_back({item.name});
    for (const char* number : {"errors", "warnings"}) table.columns.push_back({number});
    for (const char* text : {"problem", "notes", "folder"}) table.columns.push_back({text, words});
    for (const GradedSubmission& graded : grades.all) {
        const Record& record = graded.record;
        auto& cells = table.rows.emplace_back().cells;
        cells = {graded.submission.name, points_text(record.points())};
        for (const Judged& item : record.items) cells.emplace_back(points_text(item.points));
        for (const std::size_t number : {record.errors, record.warnings}) cells.emplace_back(std::to_string(number));
        cells.insert(cells.end(), {record.problem, fmt::format("{}", fmt::join(record.notes, "; ")),
                                   "students/" + graded.submission.folder});
    }
    return content::table_csv(table);
}

std::string results_json(const Grades& grades, const std::vector<Alike>& alike) {
    using Json = nlohmann::ordered_json;
    Json json{{"schema", 1},
              {"title", grades.rubric.title},
              {"points", grades.rubric.points()},
              {"items", Json::array()},
              {"submissions", Json::array()},
              {"similar", Json::array()}};
    for (const RubricItem& item : grades.rubric.items)
        json["items"].push_back({{"name", item.name}, {"points", item.most()}, {"deducts", item.points - item.most()}});
    for (const GradedSubmission& graded : grades.all) {
        const Record& record = graded.record;
        Json one{{"name", graded.submission.name}, {"folder", "students/" + graded.submission.folder},
                 {"scene", record.scene},          {"points", record.points()},
                 {"problem", record.problem},      {"notes", record.notes},
                 {"errors", record.errors},        {"warnings", record.warnings},
                 {"items", Json::array()}};
        for (const Judged& item : record.items)
            one["items"].push_back({{"points", item.points}, {"passed", item.passed}, {"why", item.why}});
        json["submissions"].push_back(std::move(one));
    }
    for (const Alike& some : alike) {
        Json folders = Json::array();
        for (const std::size_t i : some.who) folders.push_back("students/" + grades.all[i].submission.folder);
        json["similar"].push_back({{"submissions", std::move(folders)}, {"share", some.share}});
    }
    return content::json_text(json) + '\n';
}

std::string results_junit(const Grades& grades) {
    std::string text =
        fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\">\n", xml(grades.rubric.title));
    for (const GradedSubmission& graded : grades.all) {
        std::size_t failures = 0;
        for (const Judged& item : graded.record.items) failures += !item.passed;
        text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n", xml(graded.submission.name),
                            graded.record.items.size(), failures);
        for (std::size_t i = 0; i < graded.record.items.size(); ++i) {
            const Judged& item = graded.record.items[i];
            const std::string name = xml(grades.rubric.items[i].name);
            text += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml(graded.submission.name), name);
            if (item.passed)
                text += "/>\n";
            else
                text += fmt::format("><failure message=\"{}\"/></testcase>\n", xml(item.why));
        }
        text += "  </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

// The page of one submission, which can be handed back with its folder.

namespace {

constexpr std::string_view slide_script = R"(
for (const slider of document.querySelectorAll('input[type=range]')) {
  const upper = slider.previousElementSibling.children[1];
  const show = () => { upper.style.clipPath = `inset(0 0 0 ${slider.value}%)`; };
  slider.addEventListener('input', show);
  show();
}
)";

std::string items_table(const Rubric& rubric, const Record& record) {
    Table table{{{"What is judged", CellKind::words}, {"Points"}, {"Why", CellKind::words}}, {}};
    for (std::size_t i = 0; i < rubric.items.size(); ++i) {
        const RubricItem& item = rubric.items[i];
        const Judged& judged = record.items[i];
        Table::Cell points(points_text(judged.points) + (item.deducts ? "" : " of " + points_text(item.points)));
        points.css = class_of(item.left(judged.points), item.points);
        table.rows.push_back({{cell(item.name), points, cell(judged.why)}});
    }
    return content::table_html(table);
}

std::string caption(const Rubric& rubric, std::size_t picture) {
    const std::string label = rubric.pictures[picture].label();
    return label.empty() ? "as it is" : shown_text(label);
}

std::string figure(std::string_view file, std::string_view text, const Rubric& rubric) {
    return fmt::format(
        "<figure><img alt=\"{1}\" src=\"{0}\" width=\"{2}\" height=\"{3}\"><figcaption>{1}</figcaption></figure>", file,
        text, rubric.width, rubric.height);
}

// The submission's picture at the left of the slider, the reference's at the right.
std::string beside_reference(const Rubric& rubric, const Record& record, const RubricItem& item) {
    return fmt::format(
        "<div class=\"pictures\"><figure><div class=\"over\"><img alt=\"Submission\" src=\"{}\" width=\"{}\" "
        "height=\"{}\"><img alt=\"Reference\" src=\"reference-{}.png\" width=\"{}\" height=\"{}\"></div><input "
        "type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"Where the reference begins\"><figcaption>left: "
        "submission, right: reference</figcaption></figure>{}</div>\n",
        record.drawn[item.picture], rubric.width, rubric.height, item.than, rubric.width, rubric.height,
        figure(record.maps[item.map], "difference (FLIP): black is none", rubric));
}

// The pictures that an item, or one of its alternatives, compares.
std::string compared(const Rubric& rubric, const Record& record, const RubricItem& item, std::vector<bool>& told) {
    const bool against = item.expect == Expect::reference;
    told[item.picture] = true;
    if (against && !record.maps[item.map].empty()) return beside_reference(rubric, record, item);
    std::string text =
        "<div class=\"pictures\">" + figure(record.drawn[item.picture], caption(rubric, item.picture), rubric);
    if (!against && item.than != item.picture && !record.drawn[item.than].empty()) {
        told[item.than] = true;
        text += figure(record.drawn[item.than], caption(rubric, item.than), rubric);
    }
    return text + "</div>\n";
}

std::string pictures(const Rubric& rubric, const Record& record) {
    std::string text = "<h2>Pictures</h2>\n";
    if (record.drawn.front().empty()) return text + "<p>There are none.</p>\n";
    std::vector<bool> told(rubric.pictures.size());
    for (const RubricItem& item : rubric.items)
        for (const RubricItem* part : item.parts()) {
            if (part->kind != RubricItem::Kind::picture || record.drawn[part->picture].empty()) continue;
            const std::string of_it = part == &item ? "" : " (" + part->name + ")";
            text += fmt::format("<h3>{}</h3>\n", shown_text(item.name + of_it)) + compared(rubric, record, *part, told);
        }
    if (told.front()) return text;
    return text + "<div class=\"pictures\">" + figure(record.drawn.front(), caption(rubric, 0), rubric) + "</div>\n";
}

}  // namespace

std::string student_page(const Grades& grades, const GradedSubmission& graded) {
    const Rubric& rubric = grades.rubric;
    const Record& record = graded.record;
    const std::string title = graded.submission.name + (rubric.title.empty() ? "" : " \u00b7 " + rubric.title);
    std::string body = fmt::format("<h1>{}</h1>\n<p><b>{} of {} points</b>", shown_text(title),
                                   points_text(record.points()), points_text(rubric.points()));
    if (!record.scene.empty()) body += fmt::format(", for {}", shown_text(record.scene));
    body += "</p>\n";
    if (!record.problem.empty()) body += fmt::format("<p class=\"none\">{}</p>\n", shown_text(record.problem));
    for (const std::string& note : record.notes) body += fmt::format("<p>{}</p>\n", shown_text(note));
    body += items_table(rubric, record) + pictures(rubric, record);
    body += "<h2>Errors and warnings</h2>\n";
    body += record.messages.empty() ? "<p>There are none.</p>\n"
                                    : fmt::format("<pre>{}</pre>\n", shown_text(record.messages));
    return page_of(title, body, slide_script);
}

// The table of all submissions, and those that are alike.

namespace {

// Sorts by the column whose heading is clicked: by number where all are numbers.
constexpr std::string_view sort_script = R"(
for (const button of document.querySelectorAll('th button')) button.addEventListener('click', () => {
  const head = button.closest('th'), body = head.closest('table').tBodies[0], column = head.cellIndex;
  const down = head.getAttribute('aria-sort') === 'ascending';
  for (const other of head.parentNode.children) other.removeAttribute('aria-sort');
  head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
  const key = row => row.cells[column].dataset.key ?? row.cells[column].textContent;
  const compare = (a, b) => isNaN(key(a)) || isNaN(key(b)) ? key(a).localeCompare(key(b)) : key(a) - key(b);
  body.append(...[...body.rows].sort((a, b) => down ? compare(b, a) : compare(a, b)));
});
)";

// Sorted by the number, not by how it is written.
Table::Cell number_cell(double number, std::string text) {
    Table::Cell made(std::move(text));
    made.attributes = fmt::format(" data-key=\"{}\"", number);
    return made;
}

Table::Row row_of(const Rubric& rubric, const GradedSubmission& graded) {
    const Submission& submission = graded.submission;
    const Record& record = graded.record;
    const std::string folder = "students/" + submission.folder, page = folder + "/index.html";
    Table::Cell picture("no picture"), name = cell(submission.name, page);
    if (!record.drawn.empty() && !record.drawn.front().empty())
        picture.html = fmt::format("<a href=\"{}\"><img loading=\"lazy\" alt=\"Picture of {}\" src=\"{}/{}\"></a>",
                                   page, shown_text(submission.name), folder, record.drawn.front());
    if (const std::string told = remark(record); !told.empty()) name.html += "<br>" + shown_text(told);
    Table::Row row{{picture, name, number_cell(record.points(), points_text(record.points()))}};
    row.cells.back().html = fmt::format("<b>{}</b>", points_text(record.points()));
    for (std::size_t i = 0; i < rubric.items.size(); ++i) {
        const Judged& item = record.items[i];
        Table::Cell& points = row.cells.emplace_back(number_cell(item.points, points_text(item.points)));
        points.css = class_of(rubric.items[i].left(item.points), rubric.items[i].points);
        points.attributes += fmt::format(" title=\"{}\"", shown_text(item.why));
    }
    row.cells.insert(row.cells.end(), {std::to_string(record.errors), std::to_string(record.warnings)});
    return row;
}

std::string names_text(const Grades& grades, const Alike& alike, std::string_view between) {
    std::vector<std::string_view> names;
    for (const std::size_t i : alike.who) names.push_back(grades.all[i].submission.name);
    return fmt::format("{}", fmt::join(names, between));
}

std::string alike_table(const Grades& grades, const std::vector<Alike>& alike) {
    std::string text =
        "<h2 id=\"similar\">Similar shaders</h2>\n<p>Submissions whose shaders are equal, and pairs that have much in "
        "common beyond what was handed out and what many of the class have. Names, numbers, blanks and comments are "
        "not compared. This is a hint for a person to look at; it does not count as points.</p>\n";
    if (alike.empty()) return text + "<p>There are none.</p>\n";
    for (const Alike& some : alike)
        if (some.who.size() > 2) text += fmt::format("<p>{}.</p>\n", shown_text(alike_words(grades, some)));
    constexpr auto words = CellKind::words;
    Table table{{{"In common"}, {"Submissions", words}, {"Page", words}}, {}, true};
    for (std::size_t i = 0; i < alike.size(); ++i) {
        const double percent = 100 * alike[i].share;
        table.rows.push_back(
            {{number_cell(percent, fmt::format("{:.0f} %", percent)), cell(names_text(grades, alike[i], ", ")),
              cell("beside each other", fmt::format("similar/{}.html", i + 1))}});
    }
    return text + content::table_html(table);
}

// What the lecturer's own scene gets, which ought to be all points.
std::string about_reference(const Grades& grades) {
    if (!grades.reference) return {};
    const Record& record = *grades.reference;
    std::string text = fmt::format("<p>The reference gets {} of {} points.", points_text(record.points()),
                                   points_text(grades.rubric.points()));
    if (!record.problem.empty()) text += " " + shown_text(record.problem) + ".";
    for (std::size_t i = 0; i < record.items.size(); ++i)
        if (!record.items[i].passed)
            text += fmt::format(" <b>{}</b>: {}.", shown_text(grades.rubric.items[i].name),
                                shown_text(record.items[i].why));
    return text + "</p>\n";
}

}  // namespace

std::string remark(const Record& record) {
    constexpr std::size_t most = 2;
    std::string text = record.problem;
    for (std::size_t i = 0; i < std::min(record.notes.size(), most); ++i)
        text += (text.empty() ? "" : "; ") + record.notes[i];
    if (record.notes.size() > most) text += fmt::format("; and {} more", record.notes.size() - most);
    return text;
}

std::string points_text(double points) {
    std::string text = fmt::format("{:.2f}", points);
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string alike_words(const Grades& grades, const Alike& alike) {
    if (alike.who.size() == 2) return names_text(grades, alike, " and ");
    const bool handout = !grades.rubric.templates.empty();
    return fmt::format("{} of {} submissions are alike in {}", alike.who.size(), grades.all.size(),
                       handout ? "what the handout does not have"
                               : "all of their shaders; if these were handed out, name them in the rubric's template");
}

std::string index_page(const Grades& grades, const std::vector<Alike>& alike) {
    const Rubric& rubric = grades.rubric;
    const std::string title = rubric.title.empty() ? "Results" : rubric.title;
    double sum = 0;
    for (const GradedSubmission& graded : grades.all) sum += graded.record.points();
    std::string body = fmt::format(
        "<h1>{}</h1>\n<p>{}, {} points at most, {} on average. <a href=\"results.csv\">results.csv</a>, <a "
        "href=\"results.json\">results.json</a>, <a href=\"junit.xml\">junit.xml</a>, <a href=\"#similar\">similar "
        "shaders</a></p>\n",
        shown_text(title), counted(grades.all.size(), "submission"), points_text(rubric.points()),
        points_text(grades.all.empty() ? 0 : sum / static_cast<double>(grades.all.size())));
    body += about_reference(grades);
    Table table{{{"Picture", CellKind::words}, {"Submission", CellKind::words}, {"Points"}}, {}, true};
    for (const RubricItem& item : rubric.items)
        table.columns.push_back({item.name, CellKind::number,
                                 fmt::format("{} {}", item.deducts ? "deducts" : "of", points_text(item.points))});
    for (const char* number : {"Errors", "Warnings"}) table.columns.push_back({number});
    for (const GradedSubmission& graded : grades.all) table.rows.push_back(row_of(rubric, graded));
    body += content::table_html(table);
    if (!grades.left_out.empty())
        body += fmt::format("<p>Not submissions: {}.</p>\n",
                            shown_text(fmt::format("{}", fmt::join(grades.left_out, ", "))));
    body += alike_table(grades, alike);
    return page_of(title, body, sort_script);
}

// Two submissions side by side, with what they have in common.

namespace {

// The text with the lines marked that fingerprints in common cover.
std::string marked(const Record& record, std::size_t text, const Alike& alike) {
    std::vector<bool> common;
    for (const Print& print : record.prints) {
        if (print.text != text || !std::binary_search(alike.hashes.begin(), alike.hashes.end(), print.hash)) continue;
        if (common.size() <= print.last) common.resize(print.last + 1);
        std::fill(common.begin() + print.first, common.begin() + print.last + 1, true);
    }
    std::string shown;
    std::size_t line = 1;
    for (const std::string_view part : split(record.texts[text].text, '\n')) {
        const std::string safe = shown_text(part);
        // Elements that begin lines of their own need no line ends.
        if (line < common.size() && common[line])
            shown += fmt::format("<mark>{}</mark>", safe.empty() ? " " : safe);
        else
            shown += safe + '\n';
        ++line;
    }
    return shown;
}

std::string side(const GradedSubmission& graded, const Alike& alike) {
    std::string text = fmt::format("<div><h2>{}</h2>\n", shown_text(graded.submission.name));
    for (std::size_t i = 0; i < graded.record.texts.size(); ++i)
        text += fmt::format("<h3>{}</h3>\n<pre>{}</pre>\n", shown_text(graded.record.texts[i].name),
                            marked(graded.record, i, alike));
    return text + "</div>\n";
}

}  // namespace

std::string alike_page(const Grades& grades, const Alike& alike) {
    const std::string title = alike_words(grades, alike);
    const bool equal = alike.who.size() > 2;
    const std::string about =
        equal ? fmt::format("{}. The first two are shown.", shown_text(names_text(grades, alike, ", ")))
              : fmt::format("{:.0f} % of the shorter one's fingerprints are in the other one, too.", 100 * alike.share);
    return page_of(
        title, fmt::format("<h1>{}</h1>\n<p>{} Marked lines hold what they have in common. This is a hint for a person "
                           "to look at. <a href=\"../index.html\">Results</a></p>\n<div class=\"sides\">{}{}</div>\n",
                           shown_text(title), about, side(grades.all[alike.who[0]], alike),
                           side(grades.all[alike.who[1]], alike)));
}

std::set<std::uint64_t> handed_out(const Rubric& rubric) {
    std::set<std::uint64_t> hashes;
    std::error_code error;
    std::vector<fs::path> files;
    for (const std::string& path : rubric.templates) {
        if (fs::is_regular_file(path, error)) files.emplace_back(path);
        content::walk(path, [&files](const fs::path& entry, fs::file_status status, int) {
            if (fs::is_regular_file(status)) files.push_back(entry);
            return content::Walk::on;
        });
    }
    for (const fs::path& file : files) {
        if (!is_shader_name(file.native())) continue;
        Record record;
        add_prints(record, file.string(), content::whole_file(file.string()));
        for (const Print& print : record.prints) hashes.insert(print.hash);
    }
    return hashes;
}

}  // namespace snell::app
