// The pictures of one command, drawn one after the other in one context. For render.cpp and its reports.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/app/commands.h"
#include "src/app/deadline.h"
#include "src/app/document.h"
#include "src/app/headless.h"
#include "src/app/loss.h"
#include "src/app/non_finite.h"
#include "src/app/progress.h"
#include "src/app/shots.h"
#include "src/app/tiles.h"
#include "src/app/writer.h"
#include "src/gl/target.h"

namespace snell::app {

struct Timings {
    double context = 0, load = 0, frame = 0, write = 0;  // milliseconds
};

struct Record {
    Shot shot;
    bool skipped = false;  // the file was there
    double time = 0;
    double milliseconds = 0;  // drawing and reading back
};

class Batch {
public:
    Batch(const RenderOptions& options, const Shots& shots, Shard shard);

    // Draws all; the status is the process's. Records are those of the pictures that were tried.
    Exit run();

    const std::vector<Record>& records() const { return records_; }
    // By records(); there once run() is done.
    const std::vector<Written>& written() const { return *written_; }
    // "" until there is a context.
    const gl::Caps& caps() const { return caps_; }
    // Of one scene: timings and counters, where its file could be read.
    bool has_stats() const { return last_ != nullptr; }
    nlohmann::ordered_json stats() const;

private:
    // What an axis means in a scene.
    enum class Role { frame, time, ladder, uniform };
    struct Open {
        std::unique_ptr<Document> document;
        std::vector<Role> roles;      // by Shots::axes
        Rungs rungs;                  // where no axis says otherwise
        std::optional<Plan> looping;  // where there may be something to say of its loops
    };

    void leave_no_parts() const;
    bool ready_context();
    void scene(std::size_t scene, const std::vector<std::size_t>& indices);
    bool open(Open& open, const std::string& path);
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
    void say(const Diagnostics& diagnostics, const Sources& sources);
    void fail(Exit status = exit_input) { status_ = std::max(status_, status); }

    const RenderOptions& options_;
    const Shots& shots_;
    Shard shard_;
    Deadline deadline_;
    std::unique_ptr<HeadlessContext> context_;
    bool refused_ = false;  // there is no context
    LossWatch loss_;
    gl::Caps caps_;
    gl::Target target_;  // none where pictures are drawn in parts
    PictureSize size_;
    Tiling tiling_;
    Timings timings_;
    std::optional<NonFinite> non_finite_;
    ProgressLine progress_;
    std::unique_ptr<Document> last_;  // whose counters stats() tells
    std::vector<Record> records_;
    std::set<std::string> said_;  // of this scene
    Exit status_ = exit_fine;
    Writer writer_;
    const std::vector<Written>* written_ = nullptr;
};

}  // namespace snell::app
