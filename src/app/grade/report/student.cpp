// The page of one submission, which can be handed back with its folder.
#include <fmt/format.h>

#include "src/app/grade/report/frame.h"
#include "src/app/grade/report/report.h"

namespace snell::app {

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
    std::string text =
        "<div class=\"wide\"><table><thead><tr><th scope=\"col\">What is judged</th><th scope=\"col\" "
        "class=\"number\">Points</th><th scope=\"col\">Why</th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < rubric.items.size(); ++i) {
        const RubricItem& item = rubric.items[i];
        const Judged& judged = record.items[i];
        text += fmt::format("<tr><td>{}</td><td class=\"number {}\">{}{}</td><td>{}</td></tr>\n", shown_text(item.name),
                            class_of(item.left(judged.points), item.points), points_text(judged.points),
                            item.deducts ? "" : " of " + points_text(item.points), shown_text(judged.why));
    }
    return text + "</tbody></table></div>\n";
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
    return page_frame(title, body, slide_script);
}

}  // namespace snell::app
