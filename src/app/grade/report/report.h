// The folder that `snell grade` writes: pages for people, tables for programs. It works from a disk, without a network.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/app/grade/grade.h"
#include "src/app/grade/similarity.h"

namespace snell::app {

// Which of the submissions are alike.
std::vector<Alike> alike_submissions(const Grades& grades);

// Writes index.html, a page next to each record, results.csv, results.json, junit.xml and pages of similar shaders.
// Returns "" or the error.
std::string write_report(const Grades& grades, const std::vector<Alike>& alike, const std::string& output);

// The parts of a report, each as text.
std::string index_page(const Grades& grades, const std::vector<Alike>& alike);
std::string student_page(const Grades& grades, const GradedSubmission& graded);
std::string alike_page(const Grades& grades, const Alike& alike);
std::string results_csv(const Grades& grades);
std::string results_json(const Grades& grades, const std::vector<Alike>& alike);
std::string results_junit(const Grades& grades);

// Why a submission was not judged to the end, and what else is to be known of it: its problem, and the first of its
// notes; "" if there is nothing.
std::string remark(const Record& record);

// "ann and bob", or what is to be known of more that are equal.
std::string alike_words(const Grades& grades, const Alike& alike);

// Points with at most two decimals.
std::string points_text(double points);

// Fingerprints of the files that were handed out.
std::set<std::uint64_t> handed_out(const Rubric& rubric);

// Text of strangers as HTML: nothing in it is an element or a hidden character. Lines stay.
std::string shown_text(std::string_view text);

}  // namespace snell::app
