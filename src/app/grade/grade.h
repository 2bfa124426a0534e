// Grades submissions by a rubric, each in a process of its own. src/app/grade/report/ tells the results.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/app/grade/record.h"
#include "src/app/grade/rubric/rubric.h"
#include "src/app/grade/submissions.h"
#include "src/app/open/complain.h"
#include "src/content/process.h"

namespace snell::app {

// What no exercise needs is refused before it takes memory.
Limits limits_of_submissions();

struct GradeOptions {
    std::string rubric;
    std::vector<std::string> submissions;
    std::string output;    // the folder of the report
    std::size_t jobs = 0;  // processes at a time; 0: as many as there are cores
    double gigabytes = 4;  // of memory that judging a submission may take; 0: no limit
    Limits limits = limits_of_submissions();
    bool again = false;  // judges everything again, whatever is kept
    bool quiet = false;  // prints no progress if standard error is no terminal
};

struct GradedSubmission {
    Submission submission;
    Record record;
    bool kept = false;  // from an earlier run
};

struct Grades {
    FolderLock lock;  // of the folder of the report
    Rubric rubric;
    std::optional<Record> reference;
    std::vector<GradedSubmission> all;
    std::vector<std::string> left_out;  // entries of the folder that are no submissions, each with the reason
};

// The folders in that of the report.
std::string student_folder(const std::string& output, const Submission& submission);
std::string reference_folder(const std::string& output);

// Judges what is not kept, each in a process of its own, and prints what goes wrong.
Exit grade(const GradeOptions& options, Grades& grades);

// Writes a commented rubric for a scene, to standard output if `output` is empty. An existing file is not replaced.
Exit write_new_rubric(const std::string& scene, const std::string& output);

// Work on many things, each in a process of its own, as many at a time as there are cores.

struct EndedProcess : content::Ended {
    bool again = false;  // it ended by a signal once before
};

struct Apart {
    std::size_t at_once = 1;
    content::ProcessLimits limits;
    bool (*stop)() = nullptr;  // ends all of them, without a call of `done`, once it is true
};

// Calls `work(k)` for 0 ≤ k < count in copies of this process, whose return value is the copy's exit status, and `done`
// here when it has ended. One that ends by a signal of its own is tried once more. There must be neither threads nor a
// context yet, because they are not copied.
void run_apart(std::size_t count, const Apart& how, const std::function<int(std::size_t)>& work,
               const std::function<void(std::size_t, const EndedProcess&)>& done);

// Why the process of a submission ended.

// What is said of it in the report; "" if it ended by itself, with its work done. `timeout`: seconds for a picture;
// `gigabytes` of memory that it could ask for, 0: no limit.
std::string why_ended(const EndedProcess& ended, double timeout, double gigabytes);

}  // namespace snell::app
