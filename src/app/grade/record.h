// What is known of a submission once it was judged: everything that reports need, as JSON next to its pictures.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "src/app/grade/rubric/rubric.h"

namespace snell::app {

struct Judged {
    double points = 0;    // of a deduction: 0 or less
    bool passed = false;  // all points
    std::string why;      // what was deducted and why, or what was measured
};

// A shader's text, and where its fingerprints (similarity.h) are.
struct Print {
    std::uint64_t hash = 0;
    std::uint32_t text = 0, first = 0, last = 0;  // index into Record::texts, and lines, from 1
};
struct SourceText {
    std::string name, text;
};

struct Record {
    std::string key;         // tells whether it still holds
    std::string submission;  // its id, see submissions.h; "" for the reference
    std::string scene;       // the scene's path in the submission; "" if none was found
    std::string problem;     // why it could not be judged to the end; ""
    std::vector<std::string> notes;
    std::string messages;  // errors and warnings with their excerpts
    std::size_t errors = 0, warnings = 0;
    double milliseconds = 0;         // of a frame; 0: not measured
    std::vector<Judged> items;       // in the order of the rubric's
    std::vector<std::string> drawn;  // by picture of the rubric: its file next to the record; "" if it was not drawn
    std::vector<double> covered;     // likewise, the share of its pixels on which something is drawn, without NaN
    std::vector<double> shaped;     // likewise, the share of those that stand out: of which there are fewer than others
    std::vector<std::string> maps;  // by RubricItem::map: the file of the differences from the reference; ""
    std::vector<Print> prints;
    std::vector<SourceText> texts;

    double points() const;
};

// A record in which nothing is judged yet, because of `why`.
Record unjudged(const Rubric& rubric, const std::string& why);

// The file of a record in its folder.
std::string record_file(const std::string& folder);
// Return "" or the error.
std::string write_record(const std::string& folder, const Record& record);
// Returns an empty key if there is none, or it is not one of this rubric.
Record read_record(const std::string& folder, const Rubric& rubric);

// The folder of a report: which run writes into it, and which folders of submissions an earlier run has left in it.

// Held while it exists, also by copies of the process.
using FolderLock = std::shared_ptr<const int>;

// Null if another run has it. Where the file system has no locks, nothing is locked.
FolderLock lock_folder(const std::string& output);

// The id (submissions.h) of the submission whose record is in the folder; "" if there is none.
std::string submission_in(const std::string& folder);

// Whether it is a report, or one that was begun, or a folder without anything in it. Files of others are left alone.
bool may_hold_report(const std::string& output);

// Whether it is a report, or one that was begun.
bool is_report(const std::string& folder);

// Removes the record and the pictures from the folder of a submission or the reference, and nothing else.
void remove_judged(const std::string& folder);

// Removes the pages of pairs that an earlier run found alike.
void remove_pairs(const std::string& output);

// Removes the folders of submissions that are not in `folders`. What grading did not make stays, with its folder.
void remove_former_students(const std::string& output, const std::set<std::string>& folders);

}  // namespace snell::app
