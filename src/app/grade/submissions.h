// What is graded: folders, archives and scenes, with names that tell them apart.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/app/grade/rubric/rubric.h"

namespace snell::app {

struct Submission {
    std::string path;     // absolute
    std::string name;     // of the student, as the folder or file is called: UTF-8, for people
    std::string folder;   // the name of its folder in the report
    std::string id;       // a part of a hash of its path, which tells those of one name apart
    std::string problem;  // why there is nothing to judge, such as a link that leads nowhere; ""
};

struct Submissions {
    std::vector<Submission> all;        // sorted by name
    std::vector<std::string> left_out;  // entries of the folder that are nobody's, each with the reason
};

// Several arguments are a submission each, and so is one that is no folder, or a folder that holds one scene and
// nothing that could be somebody else's. Every entry of another folder is a submission, whatever it is, except hidden
// files, files that scenes next to them name, and what the rubric names. A submission whose folder is in the report
// `output` keeps it. Reports what is missing; nullopt if there is nothing to grade.
std::optional<Submissions> find_submissions(const std::vector<std::string>& arguments, const std::string& output,
                                            const Rubric& rubric);

// Hashes of all files in folders, by their paths: several scenes may be in one.
using FolderHashes = std::map<std::string, std::string>;
// A hash of everything that the result depends on: all files of the submission, and `rest`. "": it is a scene in a
// folder that holds too much to be read as a whole.
std::string key_of(const Submission& submission, const std::string& rest, FolderHashes& known);
// A hash of the rubric, the files that the reference reads, what else limits judging, and this build of snell.
std::string common_key(const Rubric& rubric, const std::string& limits);

}  // namespace snell::app
