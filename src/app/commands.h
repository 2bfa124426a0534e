// What the command line can do. Each returns the exit status.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/plan/files.h"

namespace snell::app {

enum Exit { exit_fine = 0, exit_input = 1, exit_usage = 2, exit_graphics = 3, exit_timeout = 4, exit_lost = 5 };

struct RenderOptions {
    std::vector<std::string> scenes;
    std::string output;       // a pattern: src/app/shots.h
    std::string stats, json;  // of one scene; of every picture
    std::string sheet;        // all pictures on one
    bool labels = true;       // below them
    std::optional<std::pair<int, int>> size;
    double time = 0;
    std::vector<std::string> over;  // what varies: src/app/shots.h
    std::string shard;              // "", or as parse_shard takes it
    bool skip_existing = false;
    std::vector<std::string> sets, ladders;
    std::string quality;  // "", or a preset that was measured: src/app/quality.h
    int samples = 1;
    bool transparent = false;  // without the background
    int tile = 0;              // the largest part that is drawn at once, in pixels along a side; 0: as memory allows
    std::string view;          // src/app/view_text.h
    bool axes = false;
    bool count_non_finite = false;  // pixels that are no numbers: said, and in the statistics
    int frames = 0;                 // frame k is at time + k / fps; 0: no animation
    double fps = 25;
    std::string context;  // "", "3.3", "4.1", "4.5", "es3.2" …
    bool quiet = false;
    Access access;
    bool grade = false;   // where `access` says nothing else, each scene is confined to its folder
    double timeout = 20;  // seconds for a frame, or for reading a scene; then the process ends
    int lose_after = 0;   // for tests: the context is lost in that frame
};
int render(const RenderOptions& options);

struct SaveOptions {
    std::string scene, output;  // no output: the scene's own file
    std::vector<std::string> sets, ladders;
    std::string context;
    Access access;
    double timeout = 20;  // seconds for reading
};
int save(const SaveOptions& options);

struct CheckOptions {
    std::vector<std::string> scenes;
    bool json = false;
    std::string dump;  // "", tokens, statements, scene, plan
    bool lint = true;  // also what is probably not meant
    Access access;
    bool grade = false;
    double timeout = 20;  // seconds for each scene; then the process ends
};
int check(const CheckOptions& options);

struct AccuracyOptions {
    std::vector<std::string> scenes;
    std::string html, svg, json, csv, markdown;
    std::vector<std::string> ladders, knobs;  // none of both: all that there are
    std::string from = "reference";           // "scene", "lattice"
    std::vector<std::string> sets, choices;   // uniform=value, ladder=rung
    std::optional<std::pair<int, int>> size;
    int rounds = 31;
    double budget = 120;  // seconds, of all sweeps
    double time = 0;
    bool no_time = false;                 // errors only
    std::optional<double> within, error;  // what a combination is wanted for: milliseconds, RMSE
    bool save_quality = false;            // presets, beside the scene
    std::string context;
    Access access;
    double timeout = 120;  // seconds for reading a scene, or for the few frames of one step
};
int accuracy(const AccuracyOptions& options);

struct ExplainOptions {
    std::string scene;
    bool json = false, no_time = false;
    std::vector<std::string> sets, ladders;
    std::optional<std::pair<int, int>> size;
    double time = 0;
    int rounds = 31;
    std::string context;
    Access access;
    double timeout = 20;  // seconds for all of it; frames are timed for as long as there is time
};
int explain(const ExplainOptions& options);

int print_commands(bool json);

struct InfoOptions {
    std::string context;
    double timeout = 20;  // seconds for all of it
};
int print_info(const InfoOptions& options);

}  // namespace snell::app
