#include "src/app/batch/batch.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/quality.h"
#include "src/app/open/warnings.h"
#include "src/app/picture/sheet.h"
#include "src/content/files.h"
#include "src/content/image/module.h"
#include "src/content/replace.h"
#include "src/content/text_forms.h"
#include "src/plan/setup.h"
#include "src/runtime/resources/counters.h"
#include "src/runtime/resources/uniforms.h"

namespace snell::app {

namespace {

void print_all(const Document& document, bool quiet) {
    const bool verbose = !quiet && document.runtime && document.scene().verbose;
    if (verbose) fmt::print(stderr, "{}", verbose_report(document));
    Diagnostics shown;
    for (const Diagnostic& diagnostic : document.diagnostics.items()) {
        const bool wanted = diagnostic.severity == Severity::note ? verbose : !quiet;
        if (diagnostic.severity == Severity::error || wanted) shown.add(diagnostic);
    }
    const std::string text = snell::render(shown, document.sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
    if (!document.runtime) return;
    for (const Message& message : document.scene().messages) fmt::print(stderr, "{}\n", utf8::printable(message.text));
}

// A file that is cut off, as by a copy that ended early, does not count.
bool is_there(const std::string& file, const Limits& most) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return false;
    const std::size_t side = std::min<std::uint64_t>(most.output_side, 1 << 20);
    const content::ImageLimits limits{static_cast<int>(side), side * side * 4 * sizeof(float)};
    return content::is_whole(file, content::whole_file(file), limits);
}

std::string assignment(const Axis& axis, const AxisValue& value) { return axis.name + "=" + value.written; }

using Json = nlohmann::ordered_json;

Json value_json(const AxisValue& value) { return value.number ? Json(*value.number) : Json(value.written); }

Json axis_json(const Axis& axis) {
    Json values = Json::array();
    for (const AxisValue& value : axis.values) values.push_back(value_json(value));
    return {{"name", axis.name}, {"values", std::move(values)}};
}

}  // namespace

Batch::Batch(const RenderOptions& options, const Shots& shots, Shard shard)
    : options_(options),
      shots_(shots),
      shard_(shard),
      deadline_(options.timeout, nullptr, [this] { leave_no_parts(); }),
      loss_(options.lose_after),
      writer_({!options.json.empty(), !options.sheet.empty()}) {}

Exit Batch::run() {
    for (std::size_t i = 0; i < shots_.scenes.size() && !refused_; ++i) {
        std::vector<std::size_t> indices;
        for (std::size_t k = i * shots_.per_scene(); k < (i + 1) * shots_.per_scene(); ++k)
            if (shard_.has(k)) indices.push_back(k);
        if (!indices.empty()) scene(i, indices);
    }
    written_ = &writer_.finish();
    for (std::size_t i = 0; i < records_.size(); ++i) {
        timings_.write += written()[i].milliseconds;
        if (written()[i].error.empty()) continue;
        cannot_write(shots_.files[records_[i].shot.index], written()[i].error);
        fail();
    }
    if (non_finite_ && !options_.quiet) {
        const bool any = non_finite_->nan + non_finite_->infinite > 0;
        fmt::print(stderr, "snell: {}{} pixels are NaN and {} are infinite before they are clamped{}\n",
                   any ? "warning: " : "", non_finite_->nan, non_finite_->infinite, any ? " [non-finite]" : "");
    }
    return status_;
}

// Removes the parts of pictures that were being written when the time was up.
void Batch::leave_no_parts() const {
    for (const std::string& file : shots_.files) const content::Replacement ended(file);
}

bool Batch::ready_context() {
    if (context_) return true;
    const runtime::Stopwatch watch;
    deadline_.begin("starting OpenGL");
    context_ = headless_context(options_.context);
    if (!context_) {
        refused_ = true;
        fail(exit_graphics);
        return false;
    }
    caps_ = gl::query_caps();
    if (options_.without_stages) gl::leave_stages(caps_);
    timings_.context = watch.milliseconds();
    return true;
}

void Batch::scene(std::size_t scene, const std::vector<std::size_t>& indices) {
    said_.clear();
    results_.push_back({scene});
    const std::size_t before = records_.size();
    // A scene is not even read if all of its pictures exist.
    Open opened;
    bool tried = false, usable = false;
    for (const std::size_t index : indices) {
        if (refused_) break;
        const Shot shot = shots_.shot(index);
        if (options_.skip_existing && is_there(shots_.files[index], options_.access.limits)) {
            skip(shot);
            continue;
        }
        if (!tried) {
            tried = true;
            usable = ready_context() && open(opened, shots_.scenes[scene]) && check_values(opened) &&
                     ready_target(*opened.document);
            if (!usable) fail();
        }
        if (usable) draw(opened, shot);
    }
    SceneResult& result = results_.back();
    result.drawn = records_.size() > before;
    if (opened.document) result.errors += opened.document->diagnostics.errors();
    if (opened.document) result.warnings += opened.document->diagnostics.warnings();
    if (opened.document && opened.document->runtime) last_ = std::move(opened.document);
}

void Batch::skip(const Shot& shot) {
    records_.push_back({shot, true});
    writer_.add(shots_.files[shot.index], std::nullopt);
}

bool Batch::open(Open& open, const std::string& path) {
    const runtime::Stopwatch watch;
    Diagnostics unknown;
    const Access access = access_to(path, options_.access, options_.grade);
    RungWishes wishes{options_.quality, options_.ladders, {}};
    for (const Axis& axis : shots_.axes) wishes.swept.push_back(axis.name);
    const auto choose = [&](const Scene& scene, Rungs& rungs) {
        choose_rungs(path, wishes, access, scene, rungs, unknown);
    };
    deadline_.begin(fmt::format("reading '{}'", path));
    // Resources that the previous scene has too, such as snell's own programs, are shared.
    RuntimeOptions how = runtime_options();
    how.previous = last_ ? &*last_->runtime : nullptr;
    how.progress = progress_.watcher();
    const auto planned = [&](const Plan& plan, Document& document) {
        if (may_go_round(plan, document, caps_)) open.looping = plan;
    };
    open.document = open_document(path, caps_, choose, planned, how, access);
    print_all(*open.document, options_.quiet);
    say(unknown, open.document->sources);
    timings_.load += watch.milliseconds();
    if (open.document->diagnostics.has_errors()) fail();
    if (!open.document->runtime || unknown.has_errors()) return false;
    open.rungs = open.document->runtime->rungs();
    find_roles(open);
    return true;
}

// Programs are compiled for the values that all pictures have. What an axis changes stays a uniform: compiling another
// program takes longer than its constants save in one picture (docs/architecture.md).
RuntimeOptions Batch::runtime_options() const {
    RuntimeOptions options;
    if (!options_.specialise) return options;
    options.settle = [this](Controls& controls, const Scene& scene) {
        Diagnostics unheard;  // check_values reports these
        for (const std::string& set : options_.sets) set_control(controls, scene, set, unheard);
        for (const Axis& axis : shots_.axes) {
            if (axis.frames || axis.name == "time") continue;
            for (const AxisValue& value : axis.values) {
                const Controls before = controls;
                set_control(controls, scene, assignment(axis, value), unheard);
                for (std::size_t i = 0; axis.values.size() > 1 && i < before.items.size(); ++i)
                    if (controls.items[i].value != before.items[i].value) controls.items[i].varies = true;
            }
        }
    };
    return options;
}

void Batch::find_roles(Open& open) const {
    const std::vector<Ladder>& ladders = open.document->scene().ladders;
    for (const Axis& axis : shots_.axes)
        open.roles.push_back(axis.frames                                                        ? Role::frame
                             : axis.name == "time"                                              ? Role::time
                             : ranges::find(ladders, axis.name, &Ladder::name) != ladders.end() ? Role::ladder
                                                                                                : Role::uniform);
}

// Values are checked before the first picture, so that a wrong one does not cost a rendering.
bool Batch::check_values(Open& open) {
    Document& document = *open.document;
    Controls controls = document.controls;
    Rungs rungs = open.rungs;
    Diagnostics problems;
    for (const std::string& set : options_.sets) set_control(controls, document.scene(), set, problems);
    Reach reach(controls);
    for (std::size_t i = 0; i < shots_.axes.size(); ++i)
        for (const AxisValue& value : shots_.axes[i].values) {
            const std::string text = assignment(shots_.axes[i], value);
            bool good = true;
            if (open.roles[i] == Role::time && !value.number)
                problems.error("bad-value", fmt::format("the value '{}' of 'time' is not a number", value.written));
            if (open.roles[i] == Role::ladder) good = choose_rung(rungs, document.scene(), text, problems);
            if (open.roles[i] == Role::uniform) good = set_control(controls, document.scene(), text, problems);
            if (!good) break;
            if (open.looping) reach.add(controls);
        }
    if (open.looping) {
        reach.narrow(*open.looping);
        const Diagnostics found = too_many_rounds(*open.looping, document);
        document.diagnostics.append(found);
        problems.append(found);
    }
    results_.back().errors += problems.errors();
    say(problems, document.sources, document.path);
    return !problems.has_errors();
}

// The picture must be that of a process that opens the scene with these rungs. If a program fails, the runtime keeps
// the previous one, so the scene is read again.
bool Batch::take_rungs(Open& open, const Shot& shot) {
    Rungs rungs = open.rungs;
    Diagnostics problems;
    for (std::size_t i = 0; i < shots_.axes.size(); ++i)
        if (open.roles[i] == Role::ladder)
            choose_rung(rungs, open.document->scene(), assignment(shots_.axes[i], shots_.value(shot, i)), problems);
    if (rungs == open.document->runtime->rungs()) return true;
    if (!open.document->diagnostics.has_errors()) {
        open.document->controls.rungs = rungs;
        follow_rungs(*open.document);
        const Diagnostics& found = open.document->runtime->ladder_problems();
        if (!found.has_errors()) {
            say(found, open.document->sources);
            return true;
        }
    }
    const std::string& path = shots_.scenes[shot.scene];
    const auto choose = [&](const Scene& scene, Rungs& chosen) {
        if (scene.ladders.size() == rungs.size()) chosen = rungs;
    };
    open.document = open_document(path, caps_, choose, nullptr, runtime_options(),
                                  access_to(path, options_.access, options_.grade));
    say(open.document->diagnostics, open.document->sources);
    if (open.document->diagnostics.has_errors()) fail();
    return open.document->runtime.has_value();
}

std::optional<Controls> Batch::controls_of(const Open& open, const Shot& shot) {
    const Document& document = *open.document;
    Controls controls = document.controls;
    Diagnostics problems;
    for (const std::string& set : options_.sets) set_control(controls, document.scene(), set, problems);
    for (std::size_t i = 0; i < shots_.axes.size(); ++i)
        if (open.roles[i] == Role::uniform)
            set_control(controls, document.scene(), assignment(shots_.axes[i], shots_.value(shot, i)), problems);
    say(problems, document.sources);
    if (problems.has_errors()) return std::nullopt;
    return controls;
}

double Batch::time_of(const Open& open, const Shot& shot) const {
    double time = options_.time;
    for (std::size_t i = 0; i < shots_.axes.size(); ++i) {
        const AxisValue& value = shots_.value(shot, i);
        if (open.roles[i] == Role::frame) time = options_.time + runtime::frame_time(shot.at[i], options_.fps);
        if (open.roles[i] == Role::time) time = value.number.value_or(0);
    }
    return time;
}

PictureSize Batch::size_of(const Document& document) const {
    const auto [width, height] =
        options_.size.value_or(std::pair(document.scene().window_size[0], document.scene().window_size[1]));
    return {width, height, options_.samples, holds_floats(options_.output)};
}

// The previous target is kept if it has the right size.
bool Batch::ready_target(const Document& document) {
    const PictureSize size = size_of(document);
    if (!document.runtime) return true;  // nothing will be drawn
    const gl::Pixels pixels = size.floats ? gl::Pixels::rgba32f : document.runtime->display_pixels();
    if (target_.framebuffer && size == size_ && pixels == target_.pixels) return true;
    size_ = size;
    tiling_ = tile(size, options_.access.limits, caps_, options_.tile);
    target_ = {};
    if (!tiling_.error.empty()) return complain(tiling_.error, tiling_.help);
    if (!tiling_.whole(size)) return true;
    target_ = gl::make_target(size.width, size.height, size.samples, pixels);
    if (target_.framebuffer) return true;
    fail(exit_graphics);
    return complain(
        fmt::format("this OpenGL gives no picture of {}x{} with {} samples", size.width, size.height, size.samples));
}

// Each part has the whole time of --timeout. Returns "", or why there is no picture.
std::string Batch::draw_parts(Runtime& runtime, const Frame& frame, const std::string& file) {
    Painting painting(file, size_, tiling_, options_.transparent, runtime.display_pixels());
    if (painting.without_graphics()) fail(exit_graphics);
    while (painting.step(runtime, frame)) deadline_.begin(fmt::format("drawing '{}'", file));
    return painting.error();
}

// After a loss of the context no further picture can be drawn.
bool Batch::keeps_context(const std::string& file) {
    if (!loss_.lost()) return true;
    refused_ = true;
    fail(exit_lost);
    return complain(fmt::format("'{}' is not drawn: {} [context-lost]", file, loss_message), loss_help);
}

void Batch::draw(Open& open, const Shot& shot) {
    const std::string& file = shots_.files[shot.index];
    deadline_.begin(fmt::format("drawing '{}'", file));
    if (!open.document->runtime || !take_rungs(open, shot)) return;
    const auto controls = controls_of(open, shot);
    if (!controls) return fail();
    const runtime::Stopwatch watch;
    View view;
    parse_view(options_.view, view);
    view.axes = options_.axes;
    Runtime& runtime = *open.document->runtime;
    Frame frame{time_of(open, shot), view, *controls};
    bool reached = false;
    // A warning about an empty picture is useful for one picture; frames of a series may be empty on purpose.
    if (shots_.per_scene() == 1) frame.reached = &reached;
    std::optional<content::Image> picture;
    std::string wrong;
    if (target_.framebuffer)
        picture = draw_picture(runtime, frame, target_, {.width = size_.width, .height = size_.height},
                               {size_.floats, options_.transparent});
    else
        wrong = draw_parts(runtime, frame, file);
    if (!keeps_context(file)) return;
    records_.push_back({shot, false, frame.time, watch.milliseconds()});
    timings_.frame += records_.back().milliseconds;
    deadline_.rest();
    writer_.add(file, std::move(picture), wrong, size_.floats && runtime.display_pixels() == gl::Pixels::srgb8);
    say(runtime.take_costs(), open.document->sources);
    if (frame.reached && !reached && wrong.empty() && !options_.quiet)
        say(nothing_in_view(*open.document, {frame.time, view, *controls}, size_.width, size_.height),
            open.document->sources);
    if (!options_.count_non_finite) return;
    if (!target_.framebuffer)
        return warn("a picture that is drawn part by part is not counted: take a smaller --size [non-finite]");
    frame.reached = nullptr;
    const auto found = count_non_finite(runtime, frame, size_.width, size_.height);
    if (!found) return warn("this OpenGL has no pictures of floats: nothing is counted");
    non_finite_ = non_finite_.value_or(NonFinite{});
    non_finite_->nan += found->nan;
    non_finite_->infinite += found->infinite;
}

void Batch::warn(std::string_view what) const {
    if (!options_.quiet) fmt::print(stderr, "snell: warning: {}\n", what);
}

// Each message is printed once for a scene.
void Batch::say(const Diagnostics& diagnostics, const Sources& sources, const std::string& scene) {
    for (const Diagnostic& diagnostic : diagnostics.items()) {
        if (diagnostic.severity == Severity::note || (options_.quiet && diagnostic.severity != Severity::error))
            continue;
        std::string text = snell::render(diagnostic, sources);
        // Of many scenes, that is named which a message without a place is about.
        if (!scene.empty() && !diagnostic.has_span && shots_.scenes.size() > 1)
            text = fmt::format("{}: {}", utf8::printable(scene), text);
        if (said_.insert(text).second) std::fwrite(text.data(), 1, text.size(), stderr);
    }
}

bool write_json(const std::string& path, const Json& json) {
    return write_output(path, content::json_text(json) + '\n');
}

Json pictures_json(const Batch& batch, const RenderOptions& options, const Shots& shots, Shard shard) {
    Json json{{"schema", 1}};
    json["scenes"] = shots.scenes;
    json["results"] = Json::array();
    for (const SceneResult& result : batch.results())
        json["results"].push_back({{"scene", shots.scenes[result.scene]},
                                   {"status", result.drawn ? result.errors > 0 ? "errors" : "fine" : "not drawn"},
                                   {"errors", result.errors},
                                   {"warnings", result.warnings}});
    json["axes"] = Json::array();
    for (const Axis& axis : shots.axes) json["axes"].push_back(axis_json(axis));
    json["total"] = shots.files.size();
    json["shard"] = {{"index", shard.index}, {"count", shard.count}};
    json["samples"] = options.samples;
    json["set"] = options.sets;
    json["ladder"] = options.ladders;
    json["renderer"] = batch.caps().renderer;
    json["gl"] = batch.caps().version;
    json["pictures"] = Json::array();
    for (std::size_t i = 0; i < batch.records().size(); ++i) {
        const DrawnPicture& record = batch.records()[i];
        const Written& written = batch.written()[i];
        Json values = Json::object();
        for (std::size_t axis = 0; axis < shots.axes.size(); ++axis)
            values[shots.axes[axis].name] = value_json(shots.value(record.shot, axis));
        Json picture{{"index", record.shot.index},  {"scene", shots.scenes[record.shot.scene]},
                     {"values", std::move(values)}, {"file", shots.files[record.shot.index]},
                     {"bytes", written.bytes},      {"sha256", written.sha256}};
        if (record.skipped) picture["skipped"] = true;
        if (!record.skipped) picture["time"] = record.time;
        if (!record.skipped) picture["milliseconds"] = record.milliseconds;
        if (!written.error.empty()) picture["error"] = written.error;
        json["pictures"].push_back(std::move(picture));
    }
    return json;
}

Json Batch::stats() const {
    const Counters& c = last_->runtime->counters();
    Json json{{"schema", 1}};
    json["scene"] = shots_.scenes.front();
    json["output"] = options_.output;
    json["size"] = {target_.width, target_.height};
    json["samples"] = target_.samples;
    json["time"] = options_.time;
    json["renderer"] = caps_.renderer;
    json["gl"] = caps_.version;
    json["glsl"] = caps_.glsl;
    json["pictures"] = records_.size();
    json["milliseconds"] = {
        {"context", timings_.context}, {"load", timings_.load}, {"frame", timings_.frame}, {"write", timings_.write}};
    if (non_finite_) json["non_finite"] = {{"nan", non_finite_->nan}, {"infinite", non_finite_->infinite}};
    json["errors"] = last_->diagnostics.errors();
    json["warnings"] = last_->diagnostics.warnings();
    for (const CounterName& counter : counter_names()) json["counters"][std::string(counter.name)] = c.*counter.value;
    return json;
}

namespace {

std::optional<Shots> shots_of(const RenderOptions& options) {
    std::vector<Axis> axes;
    std::string error;
    for (const std::string& text : options.over) {
        auto axis = parse_axis(text, error);
        if (!axis) {
            complain(error);
            return std::nullopt;
        }
        axes.push_back(std::move(*axis));
    }
    if (options.frames > 0) axes.push_back(frames_axis(static_cast<std::size_t>(options.frames)));
    auto shots = plan_shots(options.scenes, std::move(axes), options.output, error);
    if (!shots) complain(error);
    return shots;
}

bool folder_exists(const std::string& folder) {
    std::error_code error;
    return folder.empty() || std::filesystem::is_directory(folder, error);
}

bool folder_is_there(const std::string& file, const std::string& folder) {
    return folder_exists(folder) || complain(fmt::format("cannot write '{}': there is no folder '{}'", file, folder));
}

// Creates the folders whose names contain values.
bool ready_folders(const RenderOptions& options, const Shots& shots, Shard shard) {
    if (!folder_is_there(options.output, fixed_folder(options.output))) return false;
    for (std::size_t i = 0; i < shots.files.size(); ++i) {
        const std::filesystem::path folder = std::filesystem::path(shots.files[i]).parent_path();
        if (!shard.has(i) || folder_exists(folder.string())) continue;
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        if (error) return complain(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
    }
    return true;
}

// Returns the scenes and, only if an output exists, the files that they read: other outputs cannot overwrite these.
std::vector<std::string> files_read(const RenderOptions& options, const Shots& shots,
                                    std::span<const std::string> outputs) {
    std::vector<std::string> read = shots.scenes;
    if (!replace_a_file(outputs)) return read;
    Deadline deadline(options.timeout);
    for (const std::string& scene : shots.scenes) {
        deadline.begin(fmt::format("reading '{}'", scene));
        const auto files = files_read_by(scene, access_to(scene, options.access, options.grade));
        read.insert(read.end(), files.begin(), files.end());
        if (!options.quality.empty()) read.push_back(quality_path(scene));
    }
    return read;
}

// Outputs are checked before anything is drawn, so that a wrong name does not cost a rendering.
Exit ready_outputs(const RenderOptions& options, const Shots& shots, Shard shard) {
    const std::vector<std::string> reports{options.sheet, options.json, options.stats};
    std::vector<std::string> all = shots.files;
    all.insert(all.end(), reports.begin(), reports.end());
    if (!distinct_outputs(all, files_read(options, shots, all))) return exit_usage;
    return ready_folders(options, shots, shard) ? check_outputs(reports, {}) : exit_input;
}

bool usable(const RenderOptions& options, const Shots& shots) {
    if (!options.stats.empty() && shots.scenes.size() > 1)
        return complain("--stats tells of one scene; --json lists the pictures of many");
    for (const std::string& file : shots.files)
        if (options.transparent && !holds_alpha(file))
            return complain(fmt::format("'{}' cannot be transparent: PNG and EXR can", file));
    if (!options.sheet.empty() && shots.files.size() > max_tiles)
        return complain(
            fmt::format("a contact sheet takes at most {} pictures, not {}", max_tiles, shots.files.size()));
    return true;
}

// A row has the values of the axis that varies fastest, if the sheet has all pictures.
std::size_t columns_of(const Shots& shots, std::size_t count) {
    constexpr std::size_t widest = 64;
    if (shots.axes.size() > 1 && count == shots.files.size() && shots.axes.back().values.size() <= widest)
        return shots.axes.back().values.size();
    return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
}

bool write_sheet(const Batch& batch, const RenderOptions& options, const Shots& shots) {
    std::vector<Tile> tiles;
    for (std::size_t i = 0; i < batch.records().size(); ++i)
        tiles.push_back({batch.written()[i].tile, shots.label(batch.records()[i].shot)});
    const std::string error =
        content::write_image(options.sheet, contact_sheet(tiles, columns_of(shots, tiles.size()), options.labels));
    return error.empty() || cannot_write(options.sheet, error);
}

bool write_reports(const Batch& batch, const RenderOptions& options, const Shots& shots, Shard shard) {
    bool good = true;
    if (!options.stats.empty() && batch.has_stats()) good = write_json(options.stats, batch.stats());
    if (!options.json.empty()) good = write_json(options.json, pictures_json(batch, options, shots, shard)) && good;
    if (!options.sheet.empty() && !batch.records().empty()) good = write_sheet(batch, options, shots) && good;
    return good;
}

}  // namespace

Exit render(const RenderOptions& options) {
    const auto shots = shots_of(options);
    if (!shots || !usable(options, *shots)) return exit_usage;
    const Shard shard = parse_shard(options.shard).value_or(Shard{});
    if (const Exit wrong = ready_outputs(options, *shots, shard); wrong != exit_fine) return wrong;
    Batch batch(options, *shots, shard);
    const Exit status = batch.run();
    if (status == exit_graphics || status == exit_lost) return status;
    return write_reports(batch, options, *shots, shard) ? status : std::max(status, exit_input);
}

}  // namespace snell::app
