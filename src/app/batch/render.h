// Draws many pictures, for `snell render` and `snell sweep`.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/app/open/complain.h"
#include "src/plan/files.h"

namespace snell::app {

struct RenderOptions {
    std::vector<std::string> scenes;
    std::string output;       // a pattern, see src/app/batch/shots.h
    std::string stats, json;  // file names: statistics of one scene; a list of all pictures
    std::string sheet;        // file name of a contact sheet with all pictures
    bool labels = true;       // labels below the pictures of the sheet
    std::optional<std::pair<int, int>> size;
    double time = 0;
    std::vector<std::string> over;  // the axes that vary, see src/app/batch/shots.h
    std::string shard;              // "", or as for parse_shard
    bool skip_existing = false;
    std::vector<std::string> sets, ladders;
    std::string quality;  // "", or a measured preset, see src/app/open/quality.h
    int samples = 1;
    bool transparent = false;  // leaves out the background
    int tile = 0;              // maximum side in pixels of a part that is drawn at once; 0: as memory allows
    std::string view;          // see src/plan/setup.h
    bool axes = false;
    bool count_non_finite = false;  // counts pixels with NaN or infinite values, for the messages and the statistics
    int frames = 0;                 // frame k is at time + k / fps; 0: not an animation
    double fps = 25;
    std::string context;  // OpenGL version: "", "3.3", "4.1", "4.5", "es3.2" …
    bool quiet = false;
    bool specialise = true;  // programs are compiled for the values that all pictures have
    Access access;
    bool grade = false;   // confines each scene to its folder, unless `access` sets a folder
    double timeout = 20;  // in seconds for a frame, or for reading a scene; after that the process ends
    int lose_after = 0;   // for tests: the context is lost in that frame; 0: never
};
Exit render(const RenderOptions& options);

}  // namespace snell::app
