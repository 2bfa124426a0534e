// What is graded: folders, archives and scenes, with names that tell them apart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/app/grade/rubric.h"

namespace snell::app {

struct Submission {
    std::string path;    // absolute
    std::string name;    // of the student, as the folder or file is called: UTF-8, for people
    std::string folder;  // the name of its folder in the report
    std::string id;      // a part of a hash of its path, which tells those of one name apart
};

// One argument that is a folder without a scene of its own holds submissions; otherwise each argument is one. Sorted by
// name. A submission whose folder is in the report `output` keeps it. Reports what is missing; nullopt if there is
// nothing to grade.
std::optional<std::vector<Submission>> find_submissions(const std::vector<std::string>& arguments,
                                                        const std::string& output);

// A hash of everything that the result depends on: all files of the submission, and `rest`.
std::string key_of(const Submission& submission, const std::string& rest);
// A hash of the rubric, the files that the reference reads, and the version of snell.
std::string common_key(const Rubric& rubric);

}  // namespace snell::app
