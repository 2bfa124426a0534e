#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "src/app/batch/batch.h"
#include "src/app/batch/render.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/quality.h"
#include "src/app/picture/outputs.h"
#include "src/app/picture/picture.h"
#include "src/app/picture/sheet.h"
#include "src/document/document.h"

namespace snell::app {

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
