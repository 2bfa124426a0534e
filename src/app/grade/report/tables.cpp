// The results for programs: CSV, JSON, and JUnit's XML for CI services.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "parser/text/utf8.h"
#include "src/app/grade/report/report.h"
#include "src/app/page/html.h"
#include "src/content/json.h"
#include "src/content/table.h"

namespace snell::app {

namespace {

// In quotes where needed. Spreadsheets would run what begins like a formula.
std::string field(const std::string& text) {
    std::string safe = utf8::printable(text);
    if (!safe.empty() && std::string_view("=+-@").find(safe.front()) != std::string_view::npos) safe = "'" + safe;
    if (safe.find_first_of(",;\"") == safe.npos) return safe;
    std::string quoted = "\"";
    for (const char c : safe) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string xml(std::string_view text) { return content::escaped(utf8::printable(text)); }

}  // namespace

std::string results_csv(const Grades& grades) {
    std::string text = "submission,points";
    for (const RubricItem& item : grades.rubric.items) text += "," + field(item.name);
    text += ",errors,warnings,problem,notes,folder\n";
    for (const GradedSubmission& graded : grades.all) {
        text += fmt::format("{},{}", field(graded.submission.name), points_text(graded.record.points()));
        for (const Judged& item : graded.record.items) text += "," + points_text(item.points);
        text +=
            fmt::format(",{},{},{},{},{}\n", graded.record.errors, graded.record.warnings, field(graded.record.problem),
                        field(fmt::format("{}", fmt::join(graded.record.notes, "; "))),
                        field("students/" + graded.submission.folder));
    }
    return text;
}

std::string results_json(const Grades& grades, const std::vector<AlikePair>& pairs) {
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
    for (const AlikePair& pair : pairs)
        json["similar"].push_back({{"a", "students/" + grades.all[pair.a].submission.folder},
                                   {"b", "students/" + grades.all[pair.b].submission.folder},
                                   {"share", pair.share}});
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

}  // namespace snell::app
