// Draws many pictures, for `snell render` and `snell sweep`: one after the other in one context.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/app/batch/shots.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/open/progress.h"
#include "src/app/picture/non_finite.h"
#include "src/app/picture/outputs.h"
#include "src/app/picture/picture.h"
#include "src/document/document.h"
#include "src/gl/target.h"
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
    std::string context;          // OpenGL version: "", "3.3", "4.1", "4.5", "es3.2" …
    bool without_stages = false;  // as if it had no geometry and tessellation shaders
    bool quiet = false;
    bool specialise = true;  // programs are compiled for the values that all pictures have
    Access access;
    bool grade = false;   // confines each scene to its folder, unless `access` sets a folder
    double timeout = 20;  // in seconds for a frame, or for reading a scene; after that the process ends
    int lose_after = 0;   // for tests: the context is lost in that frame; 0: never
};
Exit render(const RenderOptions& options);

struct Timings {
    double context = 0, load = 0, frame = 0, write = 0;  // in milliseconds
};

struct DrawnPicture {
    Shot shot;
    bool skipped = false;  // the file existed already
    double time = 0;
    double milliseconds = 0;  // for drawing and reading back
};

// What became of a scene that was attempted.
struct SceneResult {
    std::size_t scene = 0;  // index into Shots::scenes
    bool drawn = false;     // at least one picture was drawn, or exists
    std::size_t errors = 0, warnings = 0;
};

// The pictures of one command.
class Batch {
public:
    Batch(const RenderOptions& options, const Shots& shots, Shard shard);

    // Draws all pictures and returns the exit status of the process. Records are those of the pictures that were
    // attempted.
    Exit run();

    const std::vector<DrawnPicture>& records() const { return records_; }
    // In the order of the scenes; without those of other shards.
    const std::vector<SceneResult>& results() const { return results_; }
    // In the order of records(); valid once run() has returned.
    const std::vector<Written>& written() const { return *written_; }
    // Empty until there is a context.
    const gl::Caps& caps() const { return caps_; }
    // True for a single scene that could be read: stats() then has its timings and counters.
    bool has_stats() const { return last_ != nullptr; }
    nlohmann::ordered_json stats() const;

private:
    // The meaning of an axis in a scene.
    enum class Role { frame, time, ladder, uniform };
    struct Open {
        std::unique_ptr<Document> document;
        std::vector<Role> roles;      // in the order of Shots::axes
        Rungs rungs;                  // the rungs of ladders that no axis sets
        std::optional<Plan> looping;  // set if the scene's loops must be checked
    };

    void leave_no_parts() const;
    bool ready_context();
    void scene(std::size_t scene, const std::vector<std::size_t>& indices);
    bool open(Open& open, const std::string& path);
    RuntimeOptions runtime_options() const;
    void find_roles(Open& open) const;
    bool check_values(Open& open);
    bool take_rungs(Open& open, const Shot& shot);
    std::optional<Controls> controls_of(const Open& open, const Shot& shot);
    double time_of(const Open& open, const Shot& shot) const;
    bool ready_target(const Document& document);
    PictureSize size_of(const Document& document) const;
    std::string draw_parts(Runtime& runtime, const Frame& frame, const std::string& file);
    void draw(Open& open, const Shot& shot);
    bool keeps_context(const std::string& file);
    void skip(const Shot& shot);
    void warn(std::string_view what) const;
    void say(const Diagnostics& diagnostics, const Sources& sources, const std::string& scene = {});
    void fail(Exit status = exit_input) { status_ = std::max(status_, status); }

    const RenderOptions& options_;
    const Shots& shots_;
    Shard shard_;
    Deadline deadline_;
    std::unique_ptr<HeadlessContext> context_;
    bool refused_ = false;  // no context could be made
    LossWatch loss_;
    gl::Caps caps_;
    gl::Target target_;  // empty if pictures are drawn in parts
    PictureSize size_;
    Tiling tiling_;
    Timings timings_;
    std::optional<NonFinite> non_finite_;
    ProgressLine progress_;
    std::unique_ptr<Document> last_;  // the document whose counters stats() returns
    std::vector<DrawnPicture> records_;
    std::vector<SceneResult> results_;
    std::set<std::string> said_;  // messages about the current scene that were printed
    Exit status_ = exit_fine;
    Writer writer_;
    const std::vector<Written>* written_ = nullptr;
};

// Reports a batch of pictures as JSON.

// Prints why the file cannot be written, and returns false then.
bool write_json(const std::string& path, const nlohmann::ordered_json& json);

// Lists every picture with its values, file, size, hash and time.
nlohmann::ordered_json pictures_json(const Batch& batch, const RenderOptions& options, const Shots& shots, Shard shard);

}  // namespace snell::app
