// `snell render` and `snell sweep`: pictures without a display.
#include "src/app/batch/render.h"
#include "src/app/batch/shots.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/exit_status.h"
#include "src/document/view_text.h"

namespace snell::app {

namespace {

std::string check_view(const std::string& text) {
    View view;
    return parse_view(text, view);
}

std::string check_shard(const std::string& text) {
    return parse_shard(text) ? "" : "'" + text + "' is not I/N, such as 0/8, 1/8 … 7/8";
}

// The options that render and sweep share.
void add_drawing(CLI::App& command, RenderOptions& render) {
    add_access(command, render.access);
    add_grade(command, render.grade);
    add_timeout(command, render.timeout, "a frame, or for reading a scene");
    command.add_option("--lose-after", render.lose_after)->group("");  // for tests
    add_size(command, render.size, "WIDTHxHEIGHT (default: the scene's)");
    add_time(command, render.time);
    add_values(command, render.sets, render.ladders);
    add_specialise(command, render.specialise);
    add_quality(command, render.quality);
    command.add_option("--samples", render.samples, "samples per pixel")->check(CLI::Range(1, 64));
    command.add_flag("--transparent", render.transparent, "without the background: PNG and EXR");
    command.add_option("--tile", render.tile, "draw at most so many pixels along a side at once")
        ->check(CLI::Range(64, 65536));
    command.add_option("--shard", render.shard, "I/N: draw only the pictures of part I of N, 0/N to N-1/N")
        ->check(check_shard);
    command.add_flag("--skip-existing", render.skip_existing, "draw only the pictures that do not exist yet");
    command.add_option("--json", render.json, "write each picture's name, values and hash as JSON")
        ->check(check_file_name);
    command.add_option("--sheet", render.sheet, "write all pictures on one")->check(check_file_name);
    command.add_flag("!--no-labels", render.labels, "write no values below the pictures of the sheet");
    command.add_option("--stats", render.stats, "write timings and counters of the one scene as JSON")
        ->check(check_file_name);
    command
        .add_option("--view", render.view,
                    "turned and moved: rotate_x=30,rotate_y=-45,scale=1.2,x=.5,eye.z=1,object0.x=.5,projection=ortho")
        ->check(check_view);
    command.add_flag("--axes", render.axes, "draw the axes");
    command.add_flag("--count-non-finite", render.count_non_finite,
                     "count the pixels that are NaN or infinite before they are clamped");
    command.add_flag("-q,--quiet", render.quiet, "print errors only, no warnings");
    add_context(command, render.context);
}

Run runner(std::shared_ptr<RenderOptions> options) {
    return [options] { return size_fits(options->size, options->access.limits) ? render(*options) : exit_usage; };
}

}  // namespace

Run add_render(CLI::App& command) {
    auto render = std::make_shared<RenderOptions>();
    command.add_option("SCENE", render->scenes)->required();
    command
        .add_option(
            "-o,--output", render->output,
            "the picture; its extension is the format; {stem} is the scene's name, {dir} its folder's, {path} what "
            "distinguishes its path, {frame:04} the frame's number")
        ->required();
    command.add_option("--frames", render->frames, "draw so many pictures, named NAME-0000 and so on without {frame}")
        ->check(CLI::Range(1, static_cast<int>(max_pictures)));
    command.add_option("--fps", render->fps, "pictures per second: picture k is at TIME + k / FPS")
        ->check(check_positive);
    add_drawing(command, *render);
    return runner(render);
}

Run add_sweep(CLI::App& command) {
    auto render = std::make_shared<RenderOptions>();
    command.add_option("SCENE", render->scenes)->required()->expected(1);
    add_repeated(command, "--over", render->over,
                 "NAME=FIRST:LAST:COUNT or NAME=A,B,C, of a uniform, a ladder or time; may be repeated: every "
                 "combination is drawn")
        ->required();
    command.add_option("-o,--output", render->output, "the pictures: {NAME}, {NAME:.2f}, {index:04} and {stem} in it")
        ->required();
    add_drawing(command, *render);
    return runner(render);
}

}  // namespace snell::app
