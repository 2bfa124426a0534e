// What is graded: folders, archives and scenes, with names that tell them apart, and the scene in each.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
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

// Finds the scene of a submission, which may be deep in folders, or in archives.

// Which scene is meant.
struct WantedScene {
    std::string pattern;    // of the file name, with * and ?, without regard to case; "": *.glib
    std::string preferred;  // a file name
    std::string named;      // the scene's own path in the folder, or the end of it; "": not known
    // Tells which of the rubric's uniforms a scene has; may be null.
    std::function<std::set<std::string>(const std::string& folder, const std::string& path)> uniforms = nullptr;
};

struct FoundScene {
    std::string folder;  // one of those that were searched
    std::string scene;   // path relative to it; "" if there is an error
    std::string error;
    std::string reason;                 // why it is this one, if that is not plain
    std::vector<std::string> several;   // paths of scenes, if it is not clear which one is meant
    std::vector<std::string> archives;  // paths of archives in the folders
};

// If no scene is named: of several, those without any of the rubric's uniforms are left out if others have some. Then
// those with the preferred name count, then those in the fewest folders, then the one with the most of the uniforms.
// Links, hidden files and those of the system are left out.
FoundScene find_scene(const std::vector<std::string>& folders, const WantedScene& wanted);

// Whether a name is that of a hidden file, or of one that systems and programs write by themselves.
bool is_hidden(std::string_view name);

// Whether a name fits a pattern with * and ?. The case of letters counts only if it does by `exact`.
bool fits_pattern(std::string_view name, std::string_view pattern, bool exact = false);

// Unpacks an archive from a stranger into a folder of its own.

struct UnpackLimits {
    std::uint64_t bytes = std::uint64_t{256} << 20;  // of all files together, unpacked
    std::size_t files = 5'000;
    std::size_t depth = 32;  // of folders
};

struct Unpacked {
    std::string error;               // "", or why reading ended; what was unpacked before it stays
    std::vector<std::string> notes;  // what was left out: links, names that lead out of the folder
};

bool is_archive(const std::string& path);  // by the name's ending

// Writes files below `folder`, which must exist, and nothing else anywhere: names with "..", absolute names, links and
// devices are left out. Bytes of names that are not UTF-8 are read as Latin-1. Files of macOS (__MACOSX, ._*) are left
// out silently.
Unpacked unpack(const std::string& archive, const std::string& folder, const UnpackLimits& limits = {});

}  // namespace snell::app
