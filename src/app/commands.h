// The subcommands with their options. Each function returns the exit status.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/plan/files.h"

namespace snell::app {

enum Exit { exit_fine = 0, exit_input = 1, exit_usage = 2, exit_graphics = 3, exit_timeout = 4, exit_lost = 5 };

struct RenderOptions {
    std::vector<std::string> scenes;
    std::string output;       // a pattern, see src/app/shots.h
    std::string stats, json;  // file names: statistics of one scene; a list of all pictures
    std::string sheet;        // file name of a contact sheet with all pictures
    bool labels = true;       // labels below the pictures of the sheet
    std::optional<std::pair<int, int>> size;
    double time = 0;
    std::vector<std::string> over;  // the axes that vary, see src/app/shots.h
    std::string shard;              // "", or as for parse_shard
    bool skip_existing = false;
    std::vector<std::string> sets, ladders;
    std::string quality;  // "", or a measured preset, see src/app/quality.h
    int samples = 1;
    bool transparent = false;  // leaves out the background
    int tile = 0;              // maximum side in pixels of a part that is drawn at once; 0: as memory allows
    std::string view;          // see src/app/view_text.h
    bool axes = false;
    bool count_non_finite = false;  // counts pixels with NaN or infinite values, for the messages and the statistics
    int frames = 0;                 // frame k is at time + k / fps; 0: not an animation
    double fps = 25;
    std::string context;  // OpenGL version: "", "3.3", "4.1", "4.5", "es3.2" …
    bool quiet = false;
    Access access;
    bool grade = false;   // confines each scene to its folder, unless `access` sets a folder
    double timeout = 20;  // in seconds for a frame, or for reading a scene; after that the process ends
    int lose_after = 0;   // for tests: the context is lost in that frame; 0: never
};
int render(const RenderOptions& options);

struct SaveOptions {
    std::string scene, output;  // an empty output stands for the scene's own file
    std::vector<std::string> sets, ladders;
    std::string context;
    Access access;
    double timeout = 20;  // in seconds, for reading
};
int save(const SaveOptions& options);

struct CheckOptions {
    std::vector<std::string> scenes;
    bool json = false;
    std::string dump;  // "", "tokens", "statements", "scene" or "plan"
    bool lint = true;  // also reports what is valid but probably not meant
    Access access;
    bool grade = false;
    double timeout = 20;  // in seconds for each scene; after that the process ends
};
int check(const CheckOptions& options);

struct AccuracyOptions {
    std::vector<std::string> scenes;
    std::string html, svg, json, csv, markdown;
    std::vector<std::string> ladders, knobs;  // if both are empty: all
    std::string from = "reference";           // or "scene", "lattice"
    std::vector<std::string> sets, choices;   // uniform=value, ladder=rung
    std::optional<std::pair<int, int>> size;
    int rounds = 31;
    double budget = 120;  // in seconds, for all sweeps together
    double time = 0;
    bool no_time = false;                 // measures errors only
    std::optional<double> within, error;  // limits of a wanted combination: milliseconds, RMSE
    bool save_quality = false;            // writes presets to a file next to the scene
    std::string context;
    Access access;
    double timeout = 120;  // in seconds for reading a scene, or for the few frames of one step
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
    double timeout = 20;  // in seconds, for the whole command; frames are timed as long as there is time
};
int explain(const ExplainOptions& options);

int print_commands(bool json);

struct InfoOptions {
    std::string context;
    double timeout = 20;  // in seconds, for the whole command
};
int print_info(const InfoOptions& options);

}  // namespace snell::app
