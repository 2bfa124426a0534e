// What snell costs beside a program that was written for one scene alone:
//     room_pairs [--rounds N] [--json FILE] [--shader-runner FILE]   times, in rounds in which everybody takes part
//     room_pairs [--rounds N] [--json FILE] --only stages     those of geometry and tessellation stages alone
//     room_pairs --count snell|by-hand                        for callgrind: one frame without OpenGL
// Run in the repository's folder, whose build's programs it finds beside itself.
#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include "src/accuracy/costs.h"
#include "src/document/document.h"
#include "src/gl/present.h"
#include "src/gl/target.h"
#include "src/platform/headless.h"
#include "tests/bench/rooms.h"
#include "tests/scratch.h"

namespace snell::bench {
namespace {

struct Row {
    std::string what;
    accuracy::Interval cpu, wall;                                         // snell's over the other's
    double snell_cpu = 0, snell_wall = 0, other_cpu = 0, other_wall = 0;  // medians, milliseconds
    double limit = 0;                                                     // of `cpu`; 0: none
};

// Of the same rounds.
class Pairs {
public:
    void add(const Times& snell, const Times& other) {
        snell_cpu_.push_back(snell.cpu);
        snell_wall_.push_back(snell.wall);
        other_cpu_.push_back(other.cpu);
        other_wall_.push_back(other.wall);
    }
    Row row(std::string what, double limit) const {
        return {std::move(what),
                accuracy::paired_ratio(snell_cpu_, other_cpu_),
                accuracy::paired_ratio(snell_wall_, other_wall_),
                accuracy::median(snell_cpu_),
                accuracy::median(snell_wall_),
                accuracy::median(other_cpu_),
                accuracy::median(other_wall_),
                limit};
    }

private:
    std::vector<double> snell_cpu_, snell_wall_, other_cpu_, other_wall_;
};

struct Settings {
    int rounds = 25;
    std::string json, bin;
    std::string shader_runner;  // piglit's; empty: not there
    bool stages_only = false;
};

// Where Debian's package piglit has it.
std::string find_shader_runner() {
    std::error_code error;
    for (const auto& folder : std::filesystem::directory_iterator("/usr/lib", error)) {
        const std::filesystem::path path = folder.path() / "piglit/bin/shader_runner";
        if (std::filesystem::exists(path, error)) return path.string();
    }
    return {};
}

int largest_difference(Rooms& rooms) {
    const std::vector<std::byte> a = rooms.picture(Who::snell), b = rooms.picture(Who::by_hand);
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(std::to_integer<int>(a[i]) - std::to_integer<int>(b[i])));
    return most;
}

void compare_frames(Rooms& rooms, const Settings& settings, int width, int height, int count, double goal,
                    std::vector<Row>& rows) {
    Pairs sliders, constants;
    for (int round = 0; round < settings.rounds; ++round) {
        std::array<Times, everybody.size()> times;
        for (std::size_t i = 0; i < everybody.size(); ++i) {  // nobody is always the first
            const std::size_t at = (i + static_cast<std::size_t>(round)) % everybody.size();
            times[at] = rooms.frames(everybody[at], count);
        }
        sliders.add(times[0], times[1]);
        constants.add(times[0], times[2]);
    }
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    rows.push_back(sliders.row("frame " + size, goal));
    rows.push_back(constants.row("frame " + size + ", constants by hand", 1.01));
}

Row compare_processes(const Settings& settings, const std::vector<std::string>& snell,
                      const std::vector<std::string>& other, std::string what, double limit) {
    measure_process(snell);
    measure_process(other);
    Pairs pairs;
    for (int round = 0; round < settings.rounds; ++round) {
        Times first = measure_process(round % 2 ? other : snell), second = measure_process(round % 2 ? snell : other);
        if (round % 2) std::swap(first, second);
        pairs.add(first, second);
    }
    return pairs.row(std::move(what), limit);
}

// A green picture of 250 x 250. snell writes it as PNG, piglit's program reads its pixels and compares them.
Row compare_trivial(const Settings& settings) {
    const Scratch scratch;
    scratch.write("green.vert", "void main() { gl_Position = gl_Vertex; }\n");
    scratch.write("green.frag", "void main() { gl_FragColor = vec4(0., 1., 0., 1.); }\n");
    scratch.write("green.glib", "Vertex green.vert\nFragment green.frag\nProgram Green\nQuadXY\n");
    scratch.write("green.shader_test",
                  "[require]\nGLSL >= 1.10\n[vertex shader]\nvoid main() { gl_Position = gl_Vertex; }\n"
                  "[fragment shader]\nvoid main() { gl_FragColor = vec4(0., 1., 0., 1.); }\n"
                  "[test]\ndraw rect -1 -1 2 2\nprobe all rgba 0. 1. 0. 1.\n");
    setenv("PIGLIT_PLATFORM", "surfaceless_egl", 1);
    return compare_processes(settings,
                             {settings.bin + "/snell", "render", scratch.path("green.glib"), "--size", "250x250", "-o",
                              scratch.path("green.png")},
                             {settings.shader_runner, scratch.path("green.shader_test"), "-auto", "-fbo"},
                             "a trivial picture, piglit's shader_runner", 1.05);
}

// The whole process, from its start to a PNG.
Row compare_first_pictures(const Settings& settings) {
    const Scratch scratch;
    const std::vector<std::string> snell{settings.bin + "/snell",
                                         "render",
                                         "scenes/refraction-room/refraction-room.glib",
                                         "--size",
                                         "512x512",
                                         "--samples",
                                         "1",
                                         "-o",
                                         scratch.path("snell.png")};
    const std::vector<std::string> by_hand{settings.bin + "/room_by_hand", "scenes/environments/room", "512", "512",
                                           scratch.path("by-hand.png")};
    return compare_processes(settings, snell, by_hand, "first picture 512x512, whole process", 1.08);
}

// So many frames of two documents in turns; the view turns by so many degrees from one to the next.
Row compare_documents(const Settings& settings, Document& first, Document& second, const gl::Target& target, int count,
                      double turn, std::string what, double limit) {
    View view;
    const auto timed = [&](Document& document) {
        const auto draw = [&] {
            view.scene.rotate_y += turn;
            document.runtime->draw({0, view, document.controls},
                                   {target.framebuffer.get(), target.width, target.height});
            gl::finish();
        };
        draw();
        Times times = measure([&] {
            for (int i = 0; i < count; ++i) draw();
        });
        return Times{times.cpu / count, times.wall / count};
    };
    timed(first), timed(second);
    Pairs pairs;
    for (int round = 0; round < settings.rounds; ++round) {
        Times one = timed(round % 2 ? second : first), other = timed(round % 2 ? first : second);
        if (round % 2) std::swap(one, other);
        pairs.add(one, other);
    }
    return pairs.row(std::move(what), limit);
}

std::vector<std::string> scenes_below(std::initializer_list<const char*> folders) {
    std::vector<std::string> scenes;
    for (const char* folder : folders)
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".glib") scenes.push_back(entry.path().string());
    std::ranges::sort(scenes);
    return scenes;
}

// Each scene at 400 x 400: programs for its values beside programs for any.
std::vector<Row> compare_scenes(const Settings& settings, const gl::Caps& caps) {
    const gl::Target target = gl::make_target(400, 400, 1);
    std::vector<Row> rows;
    for (const std::string& scene : scenes_below({"scenes"})) {
        const auto values = open_document(scene, caps, nullptr, nullptr, for_values());
        const auto any = open_document(scene, caps);
        if (!values->runtime || values->runtime->counters().specialised == 0) continue;
        rows.push_back(compare_documents(settings, *values, *any, target, 1, 0,
                                         std::filesystem::path(scene).stem().string(), 1.03));
    }
    return rows;
}

bool has_stages(const std::string& scene) {
    std::ifstream file(scene);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return text.find("\nGeometry ") != text.npos || text.find("\nTessEvaluation ") != text.npos;
}

// Vertex shaders in the place of geometry and tessellation shaders beside the driver's own stages.
std::vector<Row> compare_stages(const Settings& settings, const gl::Caps& caps) {
    gl::Caps without = caps;
    gl::leave_stages(without);
    std::vector<Row> rows;
    for (const std::string& scene : scenes_below({"docs/teaching", "scenes", "templates", "tests/cases"})) {
        const bool unfinished = scene.find("submissions") != scene.npos || scene.find("handout") != scene.npos;
        if (unfinished || !has_stages(scene)) continue;
        const auto emulated = open_document(scene, without, nullptr, nullptr, for_values());
        const auto native = open_document(scene, caps, nullptr, nullptr, for_values());
        if (!native->runtime || !emulated->runtime) continue;
        for (const int side : {48, 512}) {
            const gl::Target target = gl::make_target(side, side, 1);
            for (const double turn : {0., 1.})
                rows.push_back(compare_documents(settings, *emulated, *native, target, side < 100 ? 30 : 4, turn,
                                                 scene + (turn > 0 ? ", turning, " : ", ") + std::to_string(side),
                                                 3.5));
        }
    }
    return rows;
}

void print(const Row& row) {
    std::printf("%-52s %7.2f / %7.2f ms = %.3f (%.3f to %.3f)", row.what.c_str(), row.snell_cpu, row.other_cpu,
                row.cpu.middle, row.cpu.low, row.cpu.high);
    if (row.limit > 0) std::printf(", at most %.2f", row.limit);
    std::printf("; wall %.2f / %.2f ms = %.3f (%.3f to %.3f)\n", row.snell_wall, row.other_wall, row.wall.middle,
                row.wall.low, row.wall.high);
}

void write_rows(std::ofstream& out, const char* table, const std::vector<Row>& rows);

struct Tables {
    std::vector<Row> rows, scenes, stages;
};

void write_json(const std::string& path, const Tables& tables, const std::array<Rooms::OwnCost, 2>& own, int difference,
                int rounds) {
    std::ofstream out(path);
    out << "{\"rounds\": " << rounds << ", \"largest_difference\": " << difference << ",\n \"own\": {";
    for (std::size_t i = 0; i < own.size(); ++i)
        out << (i ? ", " : "") << (i ? "\"by_hand\"" : "\"snell\"") << ": {\"gl_calls\": " << own[i].calls
            << ", \"microseconds\": " << own[i].time.cpu * 1e3 << "}";
    out << "}";
    write_rows(out, "rows", tables.rows);
    write_rows(out, "scenes", tables.scenes);
    write_rows(out, "stages", tables.stages);
    out << "}\n";
}

void write_rows(std::ofstream& out, const char* table, const std::vector<Row>& rows) {
    const auto interval = [&](const char* name, const accuracy::Interval& i) {
        out << "\"" << name << "\": [" << i.low << ", " << i.middle << ", " << i.high << "], ";
    };
    out << ",\n \"" << table << "\": [";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        out << (i ? ",\n  {" : "\n  {") << "\"what\": \"" << row.what << "\", ";
        interval("cpu", row.cpu);
        interval("wall", row.wall);
        out << "\"snell_cpu_ms\": " << row.snell_cpu << ", \"other_cpu_ms\": " << row.other_cpu
            << ", \"snell_wall_ms\": " << row.snell_wall << ", \"other_wall_ms\": " << row.other_wall
            << ", \"limit\": " << row.limit << "}";
    }
    out << "\n]";
}

double median_of(const std::vector<Row>& rows) {
    std::vector<double> quotients;
    for (const Row& row : rows) quotients.push_back(row.cpu.middle);
    return accuracy::median(quotients);
}

// Not the middle alone: where the machine is too noisy to tell, nothing is said against it.
bool holds(const Row& row) {
    print(row);
    return row.limit <= 0 || row.cpu.middle <= row.limit || row.cpu.low <= row.limit;
}

bool all_hold(const std::vector<Row>& rows) {
    return std::ranges::count(rows, true, holds) == static_cast<std::ptrdiff_t>(rows.size());
}

// Of the room alone.
std::vector<Row> compare_rooms(const Settings& settings, Rooms& rooms) {
    std::vector<Row> rows;
    compare_frames(rooms, settings, 512, 512, 4, .98, rows);
    rooms.resize(1920, 1080);
    compare_frames(rooms, settings, 1920, 1080, 1, .98, rows);
    rows.push_back(compare_first_pictures(settings));
    if (!settings.shader_runner.empty()) rows.push_back(compare_trivial(settings));
    return rows;
}

// Those with documents, in a context of their own.
bool compare_documents(const Settings& settings, Tables& tables) {
    std::string error;
    const auto context = HeadlessContext::make({}, error);
    if (!context) throw NoGraphics(error);
    const gl::Caps caps = gl::query_caps();
    tables.stages = compare_stages(settings, caps);
    const double stages = median_of(tables.stages);
    std::printf("without geometry and tessellation stages beside with them, median %.3f:\n", stages);
    bool good = all_hold(tables.stages) && stages <= 2;
    if (settings.stages_only) return good;
    tables.scenes = compare_scenes(settings, caps);
    const double scenes = median_of(tables.scenes);
    std::printf("programs for the values beside programs for any, median %.3f:\n", scenes);
    return all_hold(tables.scenes) && good && scenes <= .9;
}

int compare(const Settings& settings) {
    Tables tables;
    std::unique_ptr<Rooms> rooms;
    int difference = 0;
    bool good = true;
    if (!settings.stages_only) {
        rooms = std::make_unique<Rooms>(".");
        rooms->resize(512, 512);
        difference = largest_difference(*rooms);
        tables.rows = compare_rooms(settings, *rooms);
        std::printf("the pictures differ by %d of 255 at most\n", difference);
        good = all_hold(tables.rows) && difference <= 1;
    }
    good = compare_documents(settings, tables) && good;
    std::array<Rooms::OwnCost, 2> own;
    if (rooms) {
        own = {rooms->own_cost(Who::snell, 20000), rooms->own_cost(Who::by_hand, 20000)};
        std::printf("without OpenGL: %.2f µs and %.0f calls a frame; by hand %.2f µs and %.0f\n", own[0].time.cpu * 1e3,
                    own[0].calls, own[1].time.cpu * 1e3, own[1].calls);
    }
    if (!settings.json.empty()) write_json(settings.json, tables, own, difference, settings.rounds);
    return good ? 0 : 1;
}

}  // namespace

// Callgrind counts what happens in here.
extern "C" [[gnu::noinline]] void snell_counted_frame(Rooms& rooms, Who who) { rooms.draw(who); }

int run(std::span<char*> arguments) {
    Settings settings;
    settings.bin = std::filesystem::path(arguments[0]).parent_path().string();
    settings.shader_runner = find_shader_runner();
    for (std::size_t i = 1; i + 1 < arguments.size(); i += 2) {
        const std::string_view name = arguments[i], value = arguments[i + 1];
        if (name == "--rounds") settings.rounds = std::max(1, std::atoi(value.data()));
        if (name == "--json") settings.json = value;
        if (name == "--shader-runner") settings.shader_runner = value;
        if (name == "--only") settings.stages_only = value == "stages";
        if (name == "--count") {
            Rooms rooms(".");
            rooms.resize(16, 16);
            const Who who = value == "snell" ? Who::snell : Who::by_hand;
            rooms.own_cost(who, 1);
            snell_counted_frame(rooms, who);
            return 0;
        }
    }
    return compare(settings);
}

}  // namespace snell::bench

int main(int argc, char** argv) {
    // Drivers that draw on the CPU take and free megabytes in every frame. Whether the C library gives them back to the
    // system each time, for a fifth of a frame's time, depends on what lies above them: luck, the same for everybody
    // so.
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 1 << 25);
    try {
        return snell::bench::run({argv, static_cast<std::size_t>(argc)});
    } catch (const snell::bench::NoGraphics& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 77;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
