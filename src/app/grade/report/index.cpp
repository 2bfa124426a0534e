// The table of all submissions, and the pairs that are alike.
#include <fmt/format.h>

#include "src/app/grade/report/frame.h"
#include "src/app/grade/report/report.h"

namespace snell::app {

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

std::string heading(std::string_view text, std::string_view more, bool number) {
    return fmt::format("<th{} scope=\"col\"><button>{}</button>{}</th>", number ? " class=\"number\"" : "",
                       shown_text(text), more);
}

std::string row_of_table(const Rubric& rubric, const GradedSubmission& graded) {
    const Record& record = graded.record;
    const std::string folder = "students/" + graded.submission.folder;
    const bool drawn = !record.drawn.empty() && !record.drawn.front().empty();
    std::string row = fmt::format(
        "<tr><td>{}</td>",
        drawn ? fmt::format(
                    "<a href=\"{0}/index.html\"><img loading=\"lazy\" alt=\"Picture of {1}\" src=\"{0}/{2}\"></a>",
                    folder, shown_text(graded.submission.name), record.drawn.front())
              : std::string("no picture"));
    row += fmt::format("<td><a href=\"{}/index.html\">{}</a>", folder, shown_text(graded.submission.name));
    if (const std::string told = remark(record); !told.empty()) row += "<br>" + shown_text(told);
    row += fmt::format("</td><td class=\"number\" data-key=\"{0}\"><b>{1}</b></td>", record.points(),
                       points_text(record.points()));
    for (std::size_t i = 0; i < rubric.items.size(); ++i) {
        const Judged& item = record.items[i];
        row += fmt::format("<td class=\"number {}\" data-key=\"{}\" title=\"{}\">{}</td>",
                           class_of(rubric.items[i].left(item.points), rubric.items[i].points), item.points,
                           shown_text(item.why), points_text(item.points));
    }
    return row + fmt::format("<td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n", record.errors,
                             record.warnings);
}

std::string alike_table(const Grades& grades, const std::vector<AlikePair>& pairs) {
    std::string text =
        "<h2 id=\"similar\">Similar shaders</h2>\n<p>Pairs whose shaders have much in common beyond what was handed "
        "out and what many of the class have. Names, numbers, blanks and comments are not compared. This is a hint "
        "for a person to look at; it does not count as points.</p>\n";
    if (pairs.empty()) return text + "<p>There are none.</p>\n";
    text += "<div class=\"wide\"><table><thead><tr>" + heading("In common", "", true) + heading("One", "", false) +
            heading("Other", "", false) + "<th scope=\"col\">Both</th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < pairs.size(); ++i)
        text += fmt::format(
            "<tr><td class=\"number\" data-key=\"{0}\">{0:.0f} %</td><td>{1}</td><td>{2}</td><td><a "
            "href=\"similar/{3}.html\">beside each other</a></td></tr>\n",
            100 * pairs[i].share, shown_text(grades.all[pairs[i].a].submission.name),
            shown_text(grades.all[pairs[i].b].submission.name), i + 1);
    return text + "</tbody></table></div>\n";
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

std::string index_page(const Grades& grades, const std::vector<AlikePair>& pairs) {
    const Rubric& rubric = grades.rubric;
    const std::string title = rubric.title.empty() ? "Results" : rubric.title;
    double sum = 0;
    for (const GradedSubmission& graded : grades.all) sum += graded.record.points();
    std::string body = fmt::format(
        "<h1>{}</h1>\n<p>{} submissions, {} points at most, {} on average. <a href=\"results.csv\">results.csv</a>, <a "
        "href=\"results.json\">results.json</a>, <a href=\"junit.xml\">junit.xml</a>, <a href=\"#similar\">similar "
        "shaders</a></p>\n",
        shown_text(title), grades.all.size(), points_text(rubric.points()),
        points_text(grades.all.empty() ? 0 : sum / static_cast<double>(grades.all.size())));
    body += about_reference(grades);
    body += "<div class=\"wide\"><table><thead><tr><th scope=\"col\">Picture</th>" + heading("Submission", "", false) +
            heading("Points", "", true);
    for (const RubricItem& item : rubric.items)
        body += heading(item.name,
                        fmt::format("<br><span class=\"quiet\">{} {}</span>", item.deducts ? "deducts" : "of",
                                    points_text(item.points)),
                        true);
    body += heading("Errors", "", true) + heading("Warnings", "", true) + "</tr></thead><tbody>\n";
    for (const GradedSubmission& graded : grades.all) body += row_of_table(rubric, graded);
    body += "</tbody></table></div>\n";
    if (!grades.left_out.empty())
        body += fmt::format("<p>Not submissions: {}.</p>\n",
                            shown_text(fmt::format("{}", fmt::join(grades.left_out, ", "))));
    body += alike_table(grades, pairs);
    return page_frame(title, body, sort_script);
}

}  // namespace snell::app
