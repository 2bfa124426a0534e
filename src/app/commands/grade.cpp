// `snell grade`: submissions by a rubric.
#include "src/app/grade/grade.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "parser/text/utf8.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/grade/report/report.h"
#include "src/app/open/complain.h"

namespace snell::app {

namespace {

constexpr double least_gigabytes = .3;  // measured with llvmpipe: with less, it cannot start

struct GradeCommand {
    GradeOptions grade;
    bool make_new = false;
};

void print_grades(const Grades& grades) {
    std::size_t width = 0;
    for (const GradedSubmission& graded : grades.all) width = std::max(width, graded.submission.name.size());
    for (const GradedSubmission& graded : grades.all) {
        const std::string told = remark(graded.record);
        fmt::print("{:<{}}  {:>6} of {}{}{}\n", graded.submission.name, width, points_text(graded.record.points()),
                   points_text(grades.rubric.points()), told.empty() ? "" : "  ", utf8::printable(told));
    }
}

void warn_of_reference(const Grades& grades) {
    if (!grades.reference) return;
    for (std::size_t i = 0; i < grades.reference->items.size(); ++i)
        if (!grades.reference->items[i].passed)
            fmt::print(stderr, "snell: warning: the reference itself fails '{}': {} [reference-fails]\n",
                       utf8::printable(grades.rubric.items[i].name), utf8::printable(grades.reference->items[i].why));
}

Exit run_grade(const GradeCommand& command) {
    const GradeOptions& options = command.grade;
    if (command.make_new)
        return options.submissions.empty() ? write_new_rubric(options.rubric, options.output)
                                           : complain(exit_usage, "--new takes one scene");
    if (options.submissions.empty())
        return complain(exit_usage, "there are no submissions: snell grade RUBRIC SUBMISSIONS… -o FOLDER");
    if (options.output.empty()) return complain(exit_usage, "-o FOLDER says where the report is written");
    if (!may_hold_report(options.output))
        return complain(exit_usage, fmt::format("'{}' holds other files than a report", options.output),
                        "choose a folder that does not exist");
    Grades grades;
    const Exit status = grade(options, grades);
    if (status != exit_fine) return status;
    warn_of_reference(grades);
    if (!grades.left_out.empty()) fmt::print(stderr, "snell: not submissions: {}\n", fmt::join(grades.left_out, ", "));
    if (!options.quiet) print_grades(grades);
    std::size_t kept = 0;
    for (const GradedSubmission& graded : grades.all) kept += graded.kept;
    const std::string count = fmt::format("{} submission{}", grades.all.size(), grades.all.size() == 1 ? "" : "s");
    const std::string wrong = write_report(grades, options.output);
    if (!wrong.empty()) return complain(exit_input, "cannot write " + wrong);
    fmt::print("{}: {}, {} of them judged before\n",
               utf8::printable((std::filesystem::path(options.output) / "index.html").string()), count, kept);
    return exit_fine;
}

std::string check_memory(const std::string& text) {
    const double gigabytes = std::strtod(text.c_str(), nullptr);
    return gigabytes == 0 || gigabytes >= least_gigabytes
               ? ""
               : fmt::format("'{}' is less than {}, which a graphics driver needs for itself; 0: no limit", text,
                             least_gigabytes);
}

}  // namespace

Run add_grade_command(CLI::App& command) {
    auto options = std::make_shared<GradeCommand>();
    GradeOptions& grade = options->grade;
    command.add_option("RUBRIC", grade.rubric, "the rubric (TOML); with --new, a scene")->required();
    command.add_option("SUBMISSION", grade.submissions,
                       "folders, archives or scenes, each a submission; or one folder that holds them");
    command.add_option("-o,--output", grade.output, "the folder of the report; with --new, the file of the rubric")
        ->check(check_file_name);
    command.add_flag("--new", options->make_new, "write a rubric for a scene, to start from");
    command.add_option("--jobs", grade.jobs, "processes at a time (default: one for each core)")
        ->check(CLI::Range(1, 1024));
    command
        .add_option("--memory", grade.gigabytes,
                    "GB of memory that judging a submission may take (default: 4; 0: no limit)")
        ->check(check_finite_number)
        ->check(CLI::Range(0., 1e6))
        ->check(check_memory);
    add_limits(command, grade.limits);
    command.add_flag("--again", grade.again, "judge everything again, even if nothing has changed");
    command.add_flag("-q,--quiet", grade.quiet, "print no line for each submission");
    command.footer(
        "What was judged is kept in the folder of the report, also after Ctrl-C: a second run judges only what has\n"
        "changed or was not judged.");
    return [options] { return run_grade(*options); };
}

}  // namespace snell::app
