#include "src/app/grade/report/report.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "src/content/replace.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

std::vector<AlikePair> pairs_of_all(const Grades& grades) {
    std::vector<const Record*> records;
    for (const GradedSubmission& graded : grades.all) records.push_back(&graded.record);
    return alike_pairs(records, handed_out(grades.rubric));
}

}  // namespace

std::string write_report(const Grades& grades, const std::string& output) {
    const fs::path folder(output);
    const std::vector<AlikePair> pairs = pairs_of_all(grades);
    std::error_code error;
    remove_pairs(output);
    std::set<std::string> students;
    for (const GradedSubmission& graded : grades.all) students.insert(graded.submission.folder);
    remove_former_students(output, students);
    if (!pairs.empty()) fs::create_directories(folder / "similar", error);
    std::string wrong;
    const auto write = [&](const fs::path& file, const std::string& text) {
        if (wrong.empty()) wrong = content::replace_file(file.string(), text);
        if (!wrong.empty() && wrong.find('\'') == wrong.npos) wrong = fmt::format("'{}': {}", file.string(), wrong);
    };
    for (const GradedSubmission& graded : grades.all)
        write(fs::path(student_folder(output, graded.submission)) / "index.html", student_page(grades, graded));
    for (std::size_t i = 0; i < pairs.size(); ++i)
        write(folder / "similar" / fmt::format("{}.html", i + 1), alike_page(grades, pairs[i]));
    write(folder / "results.csv", results_csv(grades));
    write(folder / "results.json", results_json(grades, pairs));
    write(folder / "junit.xml", results_junit(grades));
    write(folder / "index.html", index_page(grades, pairs));
    return wrong;
}

}  // namespace snell::app
