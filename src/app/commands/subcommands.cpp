// The subcommands that are short: `snell info`, the window (`snell SCENE`), `commands`, `save`, `web`, `render` and
// `sweep`, `grade`.
#include "src/app/commands/subcommands.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "parser/commands/commands.h"
#include "parser/text/diagnostic.h"
#include "parser/text/words.h"
#include "src/app/batch/batch.h"
#include "src/app/batch/shots.h"
#include "src/app/commands/options.h"
#include "src/app/grade/grade.h"
#include "src/app/grade/report/report.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/open/version.h"
#include "src/app/open/write_copy.h"
#include "src/app/page/gallery.h"
#include "src/app/page/page.h"
#include "src/app/picture/outputs.h"
#include "src/app/window/window.h"
#include "src/content/replace.h"
#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/plan/locate.h"
#include "src/plan/setup.h"

namespace snell::app {

namespace {

struct InfoOptions {
    std::string context;
    double timeout = 20;  // in seconds, for the whole command
};

Exit print_info(const InfoOptions& options) {
    Deadline deadline(options.timeout);
    deadline.begin("starting OpenGL");
    auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    const gl::Caps caps = gl::query_caps();
    fmt::print("snell {}\nrenderer   {}\nvendor     {}\nOpenGL     {}\nGLSL used  {}{}\nplatform   EGL {}\n", version(),
               caps.renderer, caps.vendor, caps.version, caps.glsl, caps.es ? " es" : " core", context->platform());
    fmt::print("textures   {} (2D), {} (3D), {} (cube)\nsamples    {}\nline width {}\npoint size {}\n",
               caps.max_texture, caps.max_texture_3d, caps.max_cube, caps.max_samples, caps.max_line_width,
               caps.max_point_size);
    return exit_fine;
}

}  // namespace

Run add_info(CLI::App& command) {
    auto options = std::make_shared<InfoOptions>();
    add_timeout(command, options->timeout, "the driver to answer");
    add_context(command, options->context);
    return [options] { return print_info(*options); };
}

// `snell SCENE`: the window.

Run add_window(CLI::App& command) {
    auto window = std::make_shared<WindowOptions>();
    command.add_option("SCENE", window->scene,
                       "the scene to open in a window, or a folder: its only scene, or a list to choose from");
    add_size(command, window->size, "size of the window, WIDTHxHEIGHT");
    add_repeated(command, "--ladder", window->ladders, "ladder=rung to begin with; may be repeated");
    add_quality(command, window->quality);
    // For tests of the window, not for users.
    command.add_option("--state", window->state_file)->group("");
    command.add_option("--exit-after", window->exit_after)->group("");
    command.add_option("--lose-file", window->lose_file)->group("");
    command.add_option("--after", window->after)->group("");  // passed by a window that restarts itself
    add_specialise(command, window->specialise);
    add_timeout(command, window->timeout, "a frame; then the scene waits for another edit");
    add_access(command, window->access);
    return [window, &command] {
        if (!size_fits(window->size, window->access.limits)) return exit_usage;
        const Exit ended = static_cast<Exit>(run_window(*window));
        if (ended == exit_usage) fmt::print(stderr, "\n{}\n", command.help());
        return ended;
    };
}

// `snell commands`: the commands of the language.

namespace {

struct CommandsOptions {
    std::string name;  // empty: all
    std::string json;  // a file
};

Exit print_one(const std::string& name) {
    if (const Command* row = find_command(name)) {
        fmt::print("{}\n", described(*row));
        return exit_fine;
    }
    const std::string_view near = nearest(name, command_names());
    return complain(exit_usage, fmt::format("the language has no command '{}'", name),
                    near.empty() ? "'snell commands' lists them" : fmt::format("did you mean '{}'?", near));
}

}  // namespace

std::string described(const Command& row) {
    std::string text = fmt::format("{:<16} {:<48} {}", row.name, row.signature.text, row.doc);
    if (!row.alias.empty()) text += fmt::format("\n{:<16} the same", row.alias);
    return text;
}

Run add_commands(CLI::App& command) {
    auto options = std::make_shared<CommandsOptions>();
    CLI::Option* name = command.add_option("NAME", options->name, "one command");
    add_json(command, options->json, "print all as JSON")->excludes(name);
    return [options] {
        if (!options->name.empty()) return print_one(options->name);
        if (!options->json.empty()) return write_output(options->json, commands_json() + "\n") ? exit_fine : exit_input;
        for (const Command& row : commands()) fmt::print("{:<16} {:<48} {}\n", row.name, row.signature.text, row.doc);
        return exit_fine;
    };
}

// `snell save`: writes values into a scene's text.

namespace {

struct SaveOptions {
    std::string scene, output;  // an empty output means the scene's own file
    std::vector<std::string> sets, ladders;
    std::string context;
    Access access;
    double timeout = 20;  // in seconds, for reading
};

Exit save(const SaveOptions& options) {
    Deadline deadline(options.timeout);
    deadline.begin(fmt::format("reading '{}'", options.scene));
    std::vector<std::string> read = read_by({&options.scene, 1}, {&options.output, 1}, options.access, false);
    std::erase_if(read, [&](const std::string& file) {  // the scene's own file may be written
        std::error_code error;
        return std::filesystem::equivalent(file, options.scene, error);
    });
    if (const Exit refused = check_outputs({&options.output, 1}, read); refused != exit_fine) return refused;
    const auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    Diagnostics problems;
    const auto choose = [&](const Scene& scene, Rungs& rungs) {
        for (const std::string& ladder : options.ladders) choose_rung(rungs, scene, ladder, problems);
    };
    const auto document = open_document(options.scene, gl::query_caps(), choose, nullptr, {}, options.access);
    if (!document->runtime) {
        fmt::print(stderr, "{}", snell::render(document->diagnostics, document->sources));
        return exit_input;
    }
    for (const std::string& set : options.sets) set_control(document->controls, document->scene(), set, problems);
    // A value may be missing because of an error in the scene.
    Diagnostics said = errors_of(document->diagnostics);
    said.append(problems);
    fmt::print(stderr, "{}", snell::render(said, document->sources));
    if (said.has_errors()) return exit_input;

    std::error_code unknown;
    const bool elsewhere =
        !options.output.empty() && !std::filesystem::equivalent(options.output, options.scene, unknown);
    const auto as = elsewhere ? std::optional(saved_as(*document, std::filesystem::absolute(options.output).string()))
                              : std::nullopt;
    const Saved saved = saved_values(*document);
    if (const std::string& wrong = as ? as->error : saved.error; !wrong.empty()) return complain(exit_input, wrong);
    for (const Unwritten& value : saved.unwritten) complain(fmt::format("{}: {}", value.name, value.reason));
    if (!saved.unwritten.empty()) return exit_input;
    const std::string error = as ? content::replace_file(as->file.path, as->file.after) : write_saved(saved.files);
    return error.empty() ? exit_fine : complain(exit_input, error);
}

}  // namespace

Run add_save(CLI::App& command) {
    auto options = std::make_shared<SaveOptions>();
    command.add_option("SCENE", options->scene)->required();
    add_access(command, options->access);
    add_timeout(command, options->timeout, "reading the scene");
    add_values(command, options->sets, options->ladders);
    command.add_option("-o,--output", options->output, "write another file than the scene itself");
    add_context(command, options->context);
    return [options] { return save(*options); };
}

// `snell web`: scenes as pages.

namespace {

struct WebOptions {
    std::vector<std::string> names;  // the scene, or the folders of a gallery
    bool gallery = false;
    PageOptions page;
};

// A link is opened by a click, so it must lead to a page, and not to a script.
std::string check_link(const std::string& text) {
    for (const std::string_view begin : {"https://", "http://"})
        if (text.starts_with(begin) && text.size() > begin.size()) return "";
    return "'" + text + "' does not begin with https:// or http://";
}

// Browsers show other files as text, and `-o x.glib` is a slip. Pipes and devices have the names that they have.
std::string check_page_name(const std::string& name) {
    if (has_extension(name, "html") || has_extension(name, "htm") || content::is_stream(name)) return "";
    const std::filesystem::path path(name);
    const std::string better =
        (has_extension(name, "glib") ? (path.parent_path() / path.stem()).string() : name) + ".html";
    return fmt::format("the name of a page ends with .html or .htm, but '{}' does not\n   help: -o '{}'",
                       utf8::printable(name), utf8::printable(better));
}

Exit web(const WebOptions& options) {
    const PageOptions& page = options.page;
    if (!options.gallery && options.names.size() > 1)
        return complain(exit_usage, "a page has one scene; --gallery takes folders");
    const Start& start = page.start;
    const bool one = !start.sets.empty() || !start.ladders.empty() || !start.view.empty() || !start.quality.empty() ||
                     !page.title.empty();
    if (options.gallery && one) return complain(exit_usage, "--gallery takes scenes as they are, without values");
    if (options.gallery)
        return make_gallery({options.names, page.output, page.link, page.access, page.grade, page.timeout});
    if (const std::string wrong = check_page_name(page.output); !wrong.empty()) return complain(exit_usage, wrong);
    PageOptions single = page;
    single.scene = options.names.front();
    return make_page(single);
}

}  // namespace

Run add_web(CLI::App& command) {
    auto options = std::make_shared<WebOptions>();
    PageOptions& page = options->page;
    command.add_option("SCENE", options->names, "the scene, or with --gallery folders")->required();
    command.add_option("-o,--output", page.output, "the page, or with --gallery the folder of pages")
        ->required()
        ->check(check_file_name);
    command.add_flag("--gallery", options->gallery, "make a page of every scene in the folders, and an index of them");
    add_values(command, page.start.sets, page.start.ladders);
    add_quality(command, page.start.quality);
    add_view(command, page.start.view, "turned and moved, as for `snell render`");
    command.add_option("--title", page.title, "title of the page (default: the name of the scene)");
    command.add_option("--link", page.link, "address of the scene's text, to which the page links")->check(check_link);
    add_access(command, page.access);
    add_grade(command, page.grade);
    add_timeout(command, page.timeout, "reading a scene");
    return [options] { return web(*options); };
}

// `snell render` and `snell sweep`: pictures without a display.

namespace {

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
    add_view(command, render.view,
             "turned and moved: rotate_x=30,rotate_y=-45,scale=1.2,x=.5,eye.z=1,object0.x=.5,projection=ortho");
    command.add_flag("--axes", render.axes, "draw the axes");
    command.add_flag("--count-non-finite", render.count_non_finite,
                     "count the pixels that are NaN or infinite before they are clamped");
    command.add_flag("-q,--quiet", render.quiet, "print errors only, no warnings");
    add_context(command, render.context);
    command.add_flag("--without-stages", render.without_stages,
                     "do without the driver's geometry and tessellation shaders, as where it has none");
}

Run runner(std::shared_ptr<RenderOptions> options) {
    return [options] { return size_fits(options->size, options->access.limits) ? render(*options) : exit_usage; };
}

}  // namespace

Run add_render(CLI::App& command) {
    auto render = std::make_shared<RenderOptions>();
    command.add_option("SCENE", render->scenes)->required();
    command
        .add_option("-o,--output", render->output,
                    "the picture; its extension is the format; {stem} is the scene's name, {dir} its folder's, {path} "
                    "what distinguishes its path, {frame:04} the frame's number")
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

// `snell grade`: submissions by a rubric.

namespace {

constexpr double least_gigabytes = .3;  // measured with llvmpipe: with less, it cannot start

struct GradeCommand {
    GradeOptions grade;
    bool make_new = false;
};

void print_grades(const Grades& grades) {
    std::size_t width = 0;
    for (const GradedSubmission& graded : grades.all) width = std::max(width, graded.submission.name.size());
    for (const GradedSubmission& graded : grades.all) {
        const std::string told = remark(graded.record);
        fmt::print("{:<{}}  {:>6} of {}{}{}\n", graded.submission.name, width, points_text(graded.record.points()),
                   points_text(grades.rubric.points()), told.empty() ? "" : "  ", utf8::printable(told));
    }
}

void warn_of_reference(const Grades& grades) {
    if (!grades.reference) return;
    for (std::size_t i = 0; i < grades.reference->items.size(); ++i)
        if (!grades.reference->items[i].passed)
            fmt::print(stderr, "snell: warning: the reference itself fails '{}': {} [reference-fails]\n",
                       utf8::printable(grades.rubric.items[i].name), utf8::printable(grades.reference->items[i].why));
}

// A folder that is not there has no parent yet: `nothere/../ann` is a folder that may hold other files.
std::string without_dots(const std::string& folder) {
    namespace fs = std::filesystem;
    if (folder.find("..") == std::string::npos) return folder;
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(folder, error), error);
    return error ? folder : fs::path(folder).is_absolute() ? whole.string() : fs::proximate(whole, error).string();
}

Exit run_grade(const GradeCommand& command) {
    GradeOptions options = command.grade;
    if (!command.make_new) options.output = without_dots(options.output);
    if (command.make_new)
        return options.submissions.empty() ? write_new_rubric(options.rubric, options.output)
                                           : complain(exit_usage, "--new takes one scene");
    if (options.submissions.empty())
        return complain(exit_usage, "there are no submissions: snell grade RUBRIC SUBMISSIONS… -o FOLDER");
    if (options.output.empty()) return complain(exit_usage, "-o FOLDER says where the report is written");
    if (!may_hold_report(options.output))
        return complain(exit_usage, fmt::format("'{}' holds other files than a report", options.output),
                        "choose a folder that does not exist");
    Grades grades;
    const Exit status = grade(options, grades);
    if (status != exit_fine) return status;
    warn_of_reference(grades);
    if (!grades.left_out.empty()) fmt::print(stderr, "snell: not submissions: {}\n", fmt::join(grades.left_out, ", "));
    if (!options.quiet) print_grades(grades);
    std::size_t kept = 0;
    for (const GradedSubmission& graded : grades.all) kept += graded.kept;
    const std::vector<Alike> alike = alike_submissions(grades);
    const std::string wrong = write_report(grades, alike, options.output);
    if (!wrong.empty()) return complain(exit_input, "cannot write " + wrong);
    for (std::size_t i = 0; i < alike.size(); ++i)
        if (alike[i].who.size() > 2)
            fmt::print(stderr, "snell: note: {}: similar/{}.html\n", alike_words(grades, alike[i]), i + 1);
    fmt::print("{}: {}, {} of them judged before\n",
               utf8::printable((std::filesystem::path(options.output) / "index.html").string()),
               counted(grades.all.size(), "submission"), kept);
    return exit_fine;
}

std::string check_memory(const std::string& text) {
    const double gigabytes = std::strtod(text.c_str(), nullptr);
    return gigabytes == 0 || gigabytes >= least_gigabytes
               ? ""
               : fmt::format("'{}' is less than {}, which a graphics driver needs for itself; 0: no limit", text,
                             least_gigabytes);
}

}  // namespace

Run add_grade_command(CLI::App& command) {
    auto options = std::make_shared<GradeCommand>();
    GradeOptions& grade = options->grade;
    command.add_option("RUBRIC", grade.rubric, "the rubric (TOML); with --new, a scene")->required();
    command.add_option("SUBMISSION", grade.submissions,
                       "folders, archives or scenes, each a submission; or one folder that holds them");
    command.add_option("-o,--output", grade.output, "the folder of the report; with --new, the file of the rubric")
        ->check(check_file_name);
    command.add_flag("--new", options->make_new, "write a rubric for a scene, to start from");
    command.add_option("--jobs", grade.jobs, "processes at a time (default: one for each core)")
        ->check(CLI::Range(1, 1024));
    command
        .add_option("--memory", grade.gigabytes,
                    "GB of memory that judging a submission may take (default: 4; 0: no limit)")
        ->check(check_finite_number)
        ->check(CLI::Range(0., 1e6))
        ->check(check_memory);
    add_limits(command, grade.limits);
    command.add_flag("--again", grade.again, "judge everything again, even if nothing has changed");
    command.add_flag("-q,--quiet", grade.quiet, "print no line for each submission");
    command.footer(
        "What was judged is kept in the folder of the report, also after Ctrl-C: a second run judges only what has\n"
        "changed or was not judged.");
    return [options] { return run_grade(*options); };
}

}  // namespace snell::app
