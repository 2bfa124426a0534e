// The folder of a report: which run writes into it, and which folders of submissions an earlier run has left in it.
#pragma once

#include <memory>
#include <set>
#include <string>

namespace snell::app {

// Held while it exists, also by copies of the process.
using FolderLock = std::shared_ptr<const int>;

// Null if another run has it. Where the file system has no locks, nothing is locked.
FolderLock lock_folder(const std::string& output);

// The id (submissions.h) of the submission whose record is in the folder; "" if there is none.
std::string submission_in(const std::string& folder);

// Whether it is a report, or one that was begun, or a folder without anything in it. Files of others are left alone.
bool may_hold_report(const std::string& output);

// Removes the record and the pictures from the folder of a submission or the reference, and nothing else.
void remove_judged(const std::string& folder);

// Removes the pages of pairs that an earlier run found alike.
void remove_pairs(const std::string& output);

// Removes the folders of submissions that are not in `folders`. What grading did not make stays, with its folder.
void remove_former_students(const std::string& output, const std::set<std::string>& folders);

}  // namespace snell::app
