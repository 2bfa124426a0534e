// What was measured, as text, CSV, JSON and HTML. Values in, text out; no files, no GL.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "src/accuracy/measure.h"

namespace snell::accuracy {

// Where and when.
struct Circumstances {
    std::string scene;  // as it was named
    std::string tool, date, cpu, os;
    int cores = 0;
    double load_before = 0, load_after = 0;  // processes that ran or waited, mean of a minute
    std::string renderer, vendor, gl;
    int width = 0, height = 0, rounds = 0;
    double time = 0;
    double query_over_wall = 0;  // of the GPU's timer; 0: not asked
    std::string from;            // reference, scene, lattice
    std::vector<std::string> sets;
};

struct Report {
    Circumstances where;
    std::vector<SweepResult> sweeps;
    std::vector<std::string> problems;  // of the scene: a line each
};

// One sentence or a few about a sweep, from its numbers alone.
std::string in_words(const SweepResult& sweep);
// "1.02 [.99, 1.05]", with the digits that the interval leaves.
std::string ratio_text(const Interval& ratio);
// What the front says of a rung: "front", "dominated by x", "no saving: x"; empty where times are not trusted.
std::string standing_text(const SweepResult& sweep, const RungResult& rung);

// For a terminal.
std::string table_text(const SweepResult& sweep);
std::string header_text(const Report& report);

// One row for each rung, after a row of names.
std::string csv_text(const Report& report);
std::string json_text(const Report& report);
// One file without network. Its plots stand there as SVG.
std::string html_text(const Report& report);
// A page of Markdown; `plots`: by sweep, where its plot lies.
std::string markdown_text(const Report& report, const std::vector<std::string>& plots);
// One plot for a paper: black on nothing, with its own fonts and sizes.
std::string svg_text(const SweepResult& sweep);

}  // namespace snell::accuracy
