// `snell compare`: how far pictures, or pictures of scenes, are from each other.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/metrics.h"
#include "src/accuracy/report/report.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/open/states.h"
#include "src/app/picture/outputs.h"
#include "src/app/picture/picture.h"
#include "src/content/files.h"
#include "src/content/text_forms.h"
#include "src/gl/context.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;
using accuracy::Picture;
using accuracy::PictureDifference;

struct CompareOptions {
    std::string picture;
    std::vector<std::string> references;
    std::string output, json;
    std::optional<double> max_rmse, max_flip, max_pixels;  // the last in per cent
    double threshold = accuracy::one_step;
    bool displayed = false;
    double timeout = 20;
    ScenePicture scene;
    std::optional<ScenePicture> other;  // of the reference, where two states of one scene are compared
    std::array<std::string, 2> states;  // their names
};

// A difference of displayed values, such as ".03" or "8/255".
std::optional<double> parse_threshold(std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto step = read_whole<double>(text.substr(0, slash));
    const auto of = slash == text.npos ? 1 : read_whole<double>(text.substr(slash + 1));
    return step && of && *step / *of >= 0 && *step / *of <= 1 ? std::optional(*step / *of) : std::nullopt;
}

// Reads pictures and draws scenes; the context is made for the first scene.
class Pictures {
public:
    explicit Pictures(const CompareOptions& options) : options_(options), deadline_(options.timeout) {}

    // Scenes are drawn in the size that is given, with the values of `state`. Prints why there is no picture.
    std::optional<Picture> of(const std::string& path, std::optional<std::pair<int, int>> size,
                              const ScenePicture& state) {
        deadline_.begin(fmt::format("reading '{}'", path));
        const content::ImageResult read_image = has_extension(path, "glib") ? drawn(path, size, state) : read(path);
        deadline_.rest();
        if (!read_image.image) return std::nullopt;
        const content::Image& image = *read_image.image;
        Picture picture = accuracy::displayed_picture(image, image.light && !options_.displayed);
        if (!image.light) put_over_black(picture);  // the colours of EXR are multiplied by alpha already
        for (const std::size_t index : read_image.replaced) unrepair(picture, image, index);
        return picture;
    }
    Exit status() const { return status_; }

private:
    static void put_over_black(Picture& picture) {
        for (std::size_t i = 0; i < picture.rgba.size(); ++i)
            if (i % 4 < 3) picture.rgba[i] *= picture.rgba[i - i % 4 + 3];
    }

    // What was not finite was repaired for textures; as a picture, it differs from every finite value.
    static void unrepair(Picture& picture, const content::Image& image, std::size_t index) {
        const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
        const std::size_t pixel = index / static_cast<std::size_t>(image.channels), y = pixel / width;
        const std::size_t from_top = image.bottom_first ? height - 1 - y : y;
        for (std::size_t c = 0; c < 3; ++c)
            picture.rgba[4 * (from_top * width + pixel % width) + c] = std::numeric_limits<float>::quiet_NaN();
    }

    content::ImageResult drawn(const std::string& path, std::optional<std::pair<int, int>> size, ScenePicture wanted) {
        if (!context_) context_ = headless_context("");
        if (!context_) {
            status_ = exit_graphics;
            return {};
        }
        if (!wanted.size) wanted.size = size;
        DrawnScene drawn = scene_picture(path, wanted, gl::query_caps());
        fmt::print(stderr, "{}", drawn.messages);
        if (drawn.misfit) status_ = exit_usage;  // status 1 says that pictures differ
        return std::move(drawn.picture);
    }

    static content::ImageResult read(const std::string& path) {
        std::string error;
        const auto bytes = content::read_regular_file(path, Limits{}.file_bytes, nullptr, error);
        if (!bytes) {
            complain(fmt::format("cannot read '{}': {}", path, error));
            return {};
        }
        auto decoded = content::decode_image(path, *bytes);
        for (const content::ImageIssue& issue : decoded.issues)
            fmt::print(stderr, "snell: {}: '{}': {} [{}]\n   help: {}\n", issue.error ? "error" : "warning",
                       utf8::printable(path), utf8::printable(issue.message), issue.code, issue.help);
        if (decoded.image && decoded.image->depth > 1) {
            complain(fmt::format("'{}' is a volume, not a picture", path));
            return {};
        }
        return decoded;
    }

    const CompareOptions& options_;
    Deadline deadline_;
    std::unique_ptr<HeadlessContext> context_;
    Exit status_ = exit_input;
};

struct Compared {
    std::string picture, reference;
    int width = 0, height = 0;
    PictureDifference difference;
    bool alike = true;
};

bool within(double value, const std::optional<double>& limit) { return !limit || value <= *limit; }

bool alike(const PictureDifference& d, const CompareOptions& options) {
    return within(d.error.display.rmse, options.max_rmse) && within(d.flip, options.max_flip) &&
           within(100 * d.share, options.max_pixels);
}

// The nearest of the references; nullopt if none could be compared, which was printed.
std::optional<Compared> nearest_of(const CompareOptions& options, Pictures& pictures, const std::string& path,
                                   const std::vector<std::string>& references) {
    std::optional<Compared> best;
    std::optional<Picture> picture;
    const ScenePicture& scene = options.scene;
    const bool drawn = has_extension(path, "glib");
    if (!drawn && !(picture = pictures.of(path, std::nullopt, scene))) return best;
    for (const std::string& name : references) {
        const auto reference =
            pictures.of(name, picture ? std::optional(std::pair(picture->width, picture->height)) : std::nullopt,
                        options.other ? *options.other : scene);
        if (!reference) return std::nullopt;
        if (drawn) picture = pictures.of(path, std::pair(reference->width, reference->height), scene);
        if (!picture) return std::nullopt;
        if (picture->width != reference->width || picture->height != reference->height) {
            complain(fmt::format("'{}' has {}x{} pixels, but '{}' has {}x{}", path, picture->width, picture->height,
                                 name, reference->width, reference->height));
            continue;
        }
        const auto named = [](const std::string& file, const std::string& state) {
            return state.empty() ? file : fmt::format("{} ({})", file, state);
        };
        Compared now{named(path, options.states[0]),
                     named(name, options.states[1]),
                     picture->width,
                     picture->height,
                     accuracy::picture_difference(*picture, *reference, options.threshold),
                     true};
        if (std::isnan(now.difference.error.display.rmse)) {
            complain(fmt::format("'{}' and '{}' cannot be compared: every pixel of both is NaN or infinite",
                                 now.picture, now.reference));
            continue;
        }
        now.alike = alike(now.difference, options);
        const auto rank = [](const Compared& c) { return std::pair(!c.alike, c.difference.error.display.rmse); };
        if (!best || rank(now) < rank(*best)) best = std::move(now);
    }
    return best;
}

nlohmann::ordered_json compared_figures(const accuracy::Figures& f) {
    using accuracy::number;
    return {{"rmse", number(f.rmse)}, {"psnr", number(f.psnr)}, {"max", number(f.max)}, {"mean", number(f.mean)}};
}

nlohmann::ordered_json compared_json(const Compared& c) {
    const PictureDifference& d = c.difference;
    return {{"picture", c.picture},
            {"reference", c.reference},
            {"alike", c.alike},
            {"size", {c.width, c.height}},
            {"display", compared_figures(d.error.display)},
            {"light", compared_figures(d.error.light)},
            {"largest_at", {d.x, d.y}},
            {"flip", d.flip},
            {"pixels_percent", 100 * d.share},
            {"coverage", {d.cover[0], d.cover[1]}},
            {"non_finite_pixels", d.error.nonfinite}};
}

void print_compared(const Compared& c, const CompareOptions& options, std::FILE* out) {
    const PictureDifference& d = c.difference;
    const accuracy::Figures &shown = d.error.display, &light = d.error.light;
    fmt::print(out, "{} against {}: {}x{}{}\n", utf8::printable(c.picture), utf8::printable(c.reference), c.width,
               c.height, c.alike ? "" : ", different");
    fmt::print(out, "  RMSE      {:.6g} of displayed values, {:.6g} of light\n", shown.rmse, light.rmse);
    fmt::print(out, "  PSNR      {:.6g} dB of displayed values, {:.6g} dB of light\n",
               accuracy::decibels(shown.psnr, 2), accuracy::decibels(light.psnr, 2));
    if (d.largest > 0)
        fmt::print(out, "  largest   {:.6g} of displayed values at {},{} from the top left\n", d.largest, d.x, d.y);
    fmt::print(out, "  FLIP      {:.6g}\n", d.flip);
    fmt::print(out, "  pixels    {:.4g} % differ by more than {:.4g}\n", 100 * d.share, options.threshold);
    if (d.error.nonfinite > 0) fmt::print(out, "  NaN       in {}, or infinite\n", counted(d.error.nonfinite, "pixel"));
    fmt::print(out, "  coverage  {:.4g} % and {:.4g} %\n", 100 * d.cover[0], 100 * d.cover[1]);
}

// The pictures and scenes below a folder, by their paths in it.
std::optional<std::vector<std::string>> names_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
    for (; !error && entry != end; entry.increment(error)) {
        constexpr std::array endings{"png", "exr", "hdr", "jpg", "jpeg", "bmp", "tif", "tiff", "tga", "glib"};
        if (ranges::any_of(endings, [&](const char* e) { return has_extension(entry->path().native(), e); }) &&
            entry->is_regular_file(error))
            names.push_back(entry->path().lexically_relative(folder).string());
    }
    if (error) {
        complain(fmt::format("cannot read the folder '{}': {}", folder, error.message()));
        return std::nullopt;
    }
    ranges::sort(names);
    return names;
}

struct Pair {
    std::string picture;
    std::vector<std::string> references;
    std::string map;  // where the map of the differences is written; "": nowhere
};

// What is compared with what.
struct Pairing {
    std::vector<Pair> pairs;
    std::vector<std::pair<std::string, std::string>> unpaired;  // folder and name of files that only one folder has
};

std::optional<Pairing> pairs_of(const CompareOptions& options) {
    if (!fs::is_directory(options.picture))
        return Pairing{{Pair{options.picture, options.references, options.output}}, {}};
    const std::string& other = options.references.front();
    const auto own = names_in(options.picture), others = names_in(other);
    if (!own || !others) return std::nullopt;
    Pairing pairing;
    const auto same_map = [](const std::string& name) {
        return [map = fs::path(name).replace_extension(".png")](const std::string& another) {
            return fs::path(another).replace_extension(".png") == map;
        };
    };
    for (const std::string& name : *own) {
        if (ranges::find(*others, name) == others->end()) {
            pairing.unpaired.emplace_back(options.picture, name);
            continue;
        }
        // a.png, or a.exr.png and a.png.png if there are both.
        fs::path map = fs::path(options.output) / name;
        map.replace_extension(ranges::count_if(*own, same_map(name)) > 1 ? map.extension().string() + ".png" : ".png");
        pairing.pairs.push_back({(fs::path(options.picture) / name).string(),
                                 {(fs::path(other) / name).string()},
                                 options.output.empty() ? "" : map.string()});
    }
    for (const std::string& name : *others)
        if (ranges::find(*own, name) == own->end()) pairing.unpaired.emplace_back(other, name);
    return pairing;
}

bool write_map(const Compared& compared, const std::string& file) {
    if (file.empty()) return true;
    std::error_code ignored;
    if (const fs::path folder = fs::path(file).parent_path(); !folder.empty()) fs::create_directories(folder, ignored);
    const std::string wrong =
        content::write_image(file, accuracy::map_image(compared.difference.map, compared.width, compared.height));
    return wrong.empty() || cannot_write(file, wrong);
}

bool write_compared(const CompareOptions& options, const nlohmann::ordered_json& all, const Pairing& pairing,
                    bool same) {
    nlohmann::ordered_json json{{"schema", 1}, {"alike", same}, {"pairs", all}};
    json["unpaired"] = nlohmann::ordered_json::array();
    for (const auto& [folder, name] : pairing.unpaired) json["unpaired"].push_back((fs::path(folder) / name).string());
    return write_output(options.json, content::json_text(json) + '\n');
}

// Two folders, or one picture with any number of references.
Exit usable(const CompareOptions& options) {
    std::error_code error;
    const bool folders = fs::is_directory(options.picture, error);
    std::vector<std::string> read = options.references;
    read.push_back(options.picture);
    for (const std::string& path : read) {
        if (!fs::exists(path, error)) return complain(exit_usage, fmt::format("there is no '{}'", path));
        if (fs::is_directory(path, error) == folders && (!folders || options.references.size() == 1)) continue;
        return complain(exit_usage,
                        "a folder is compared with one other folder, and a picture or a scene with pictures or scenes");
    }
    if (options.output == "/dev/stdout" && options.json == options.output)
        return complain(exit_usage, "the map and the figures would both be written to standard output");
    return exit_fine;
}

// Neither what is compared is overwritten nor what its scenes read.
Exit outputs_fit(const CompareOptions& options, const Pairing& pairing) {
    std::vector<std::string> outputs{options.json}, read, scenes;
    const auto add = [&](const std::string& path) { (has_extension(path, "glib") ? scenes : read).push_back(path); };
    for (const Pair& pair : pairing.pairs) {
        outputs.push_back(pair.map);
        add(pair.picture);
        for (const std::string& reference : pair.references) add(reference);
    }
    for (const auto& [folder, name] : pairing.unpaired) add((fs::path(folder) / name).string());
    Deadline deadline(options.timeout);
    deadline.begin("reading the scenes");
    const auto files = read_by(scenes, outputs, options.scene.access, options.scene.grade);
    read.insert(read.end(), files.begin(), files.end());
    if (!distinct_outputs(outputs, read)) return exit_usage;
    if (fs::is_directory(options.picture)) outputs.resize(1);  // folders for the maps are made
    return check_outputs(outputs, {});
}

// Two states of one scene, which two --set name, see src/app/open/states.h.
Exit two_states(CompareOptions& options) {
    if (!has_extension(options.picture, "glib") || options.scene.sets.size() != 2)
        return complain(exit_usage,
                        "without a REFERENCE, two states of a scene are compared: give a scene and --set twice",
                        "snell compare room.glib --set uIndex=1.33 --set uIndex=2.4");
    const Access access = access_to(options.picture, options.scene.access, options.scene.grade);
    Files files(scene_folder(options.picture), access);
    Sources sources;
    Diagnostics diagnostics;
    const auto plan = read_plan(options.picture, files, sources, diagnostics);
    if (!plan) return complain(exit_input, fmt::format("cannot read '{}'", options.picture));
    options.other = options.scene;
    ranges::copy(options.scene.sets, options.states.begin());
    for (ScenePicture* side : {&options.scene, &*options.other}) {
        NamedState state = named_state(options.states[side != &options.scene], options.picture, plan->scene);
        if (!state.error.empty()) return complain(exit_usage, state.error);
        side->sets = std::move(state.sets);
        if (state.written) side->ladders.clear();
        side->ladders.insert(side->ladders.end(), state.ladders.begin(), state.ladders.end());
    }
    options.references = {options.picture};
    return exit_fine;
}

Exit compare(CompareOptions options) {
    if (options.references.empty())
        if (const Exit refused = two_states(options); refused != exit_fine) return refused;
    if (const Exit refused = usable(options); refused != exit_fine) return refused;
    const auto pairing = pairs_of(options);
    if (!pairing) return exit_input;
    if (const Exit refused = outputs_fit(options, *pairing); refused != exit_fine) return refused;
    const bool prints = options.json != "/dev/stdout";
    std::FILE* const out = options.output == "/dev/stdout" ? stderr : stdout;  // a picture is not mixed with text
    if (prints)
        for (const auto& [folder, name] : pairing->unpaired)
            fmt::print(out, "only in {}: {}\n", utf8::printable(folder), utf8::printable(name));
    bool different = !pairing->unpaired.empty();
    if (pairing->pairs.empty() && !different)
        different = !complain("there are neither pictures nor scenes in these folders");
    Pictures pictures(options);
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    Exit status = exit_fine;
    for (const Pair& pair : pairing->pairs) {
        const auto compared = nearest_of(options, pictures, pair.picture, pair.references);
        if (!compared) {
            status = std::max(status, pictures.status());
            continue;
        }
        different = different || !compared->alike;
        if (prints) print_compared(*compared, options, out);
        all.push_back(compared_json(*compared));
        if (!write_map(*compared, pair.map)) status = std::max(status, exit_input);
    }
    if (different) status = std::max(status, exit_input);
    if (!options.json.empty() && !write_compared(options, all, *pairing, status == exit_fine)) return exit_input;
    return status;
}

}  // namespace

Run add_compare(CLI::App& command) {
    auto options = std::make_shared<CompareOptions>();
    command.add_option("PICTURE", options->picture, "a picture, a scene, or a folder of them")->required();
    command.add_option("REFERENCE", options->references,
                       "picture, scene or folder to compare with; of several, the nearest counts. Names pair the files "
                       "of folders. Without it, two --set are two states of the scene");
    command
        .add_option("-o,--output", options->output,
                    "write FLIP's map of the differences; for folders, a folder of maps")
        ->check(check_file_name);
    add_json(command, options->json, "print the figures as JSON");
    command.add_option("--max-rmse", options->max_rmse, "fail if the RMSE of displayed values (0 to 1) is larger")
        ->check(check_finite_number)
        ->check(CLI::Range(0., 1e9));
    command.add_option("--max-flip", options->max_flip, "fail if the mean of FLIP (0 to 1) is larger")
        ->check(check_finite_number)
        ->check(CLI::Range(0., 1.));
    command.add_option("--max-pixels", options->max_pixels, "fail if more per cent of the pixels differ")
        ->check(check_finite_number)
        ->check(CLI::Range(0., 100.));
    command
        .add_option_function<std::string>(
            "--threshold",
            [options](const std::string& text) { options->threshold = parse_threshold(text).value_or(0); },
            "pixels differ if a channel differs by more: 0 to 1, or N/255 (default: 1.5/255)")
        ->check([](const std::string& text) {
            return parse_threshold(text)
                       ? ""
                       : "'" + text + "' is neither a number from 0 to 1 nor one of bytes, such as 8/255";
        });
    command.add_flag("--displayed", options->displayed,
                     "numbers of EXR and HDR files are displayed values, as scenes without 'Output srgb' write them");
    add_values(command, options->scene.sets, options->scene.ladders);
    add_size(command, options->scene.size, "WIDTHxHEIGHT of scenes (default: the reference's)");
    add_time(command, options->scene.time);
    command.add_option("--samples", options->scene.samples, "samples per pixel of scenes")->check(CLI::Range(1, 64));
    add_access(command, options->scene.access);
    add_grade(command, options->scene.grade);
    add_timeout(command, options->timeout, "each scene");
    command.footer(
        "Without a limit, the status is 0 when the pictures could be compared, otherwise 1. With --max-rmse,\n"
        "--max-flip or --max-pixels it is 0 for pictures that are alike, 1 for different ones and those that cannot "
        "be\n"
        "compared, and 2 for wrong usage.\n\n"
        "snell compare room.glib --set 'uIndex=1.33 BEND=single' --set uIndex=2.4 compares two states of one scene. "
        "Each\n"
        "is named as in the window: 'saved', 'reference' (the last rung of every ladder), 'snapshot 3', or settings "
        "of\n"
        "uniforms and ladders between blanks.");
    return [options] {
        return size_fits(options->scene.size, options->scene.access.limits) ? compare(*options) : exit_usage;
    };
}

}  // namespace snell::app
