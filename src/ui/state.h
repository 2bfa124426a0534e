// What the panels show, what they change, and what they remember from frame to frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "parser/source.h"
#include "src/plan/controls.h"
#include "src/plan/view.h"
#include "src/runtime/explain.h"
#include "src/ui/accuracy.h"
#include "src/ui/browser.h"
#include "src/ui/frame_cost.h"
#include "src/ui/hold.h"
#include "src/ui/layout.h"
#include "src/ui/picture_out.h"
#include "src/ui/pixels.h"
#include "src/ui/theme.h"
#include "src/ui/widgets.h"

namespace snell::ui {

// Where an editor is to open a file; 1-based.
struct Place {
    std::string file;  // on disk; empty: nowhere
    int line = 1, column = 1;
};

// A diagnostic as it is printed, and what it speaks of.
struct Problem {
    Severity severity = Severity::error;
    std::string text;
    Place place;
};

// A file in use. Names are fit to be shown.
struct FileRow {
    std::string name;  // from the scene's folder, if it is not far from there
    std::string path;  // on disk
};

// Sets of values that are kept beside the scene, by number from 1.
inline constexpr int snapshot_count = 9;

// In window coordinates, from the scene's top left.
struct Point {
    double x = 0, y = 0;
};

struct Facts {
    std::string_view file;                 // the scene's name, without its folder
    const Scene* scene = nullptr;          // none: it could not be read
    std::span<const char> linked;          // by Scene::programs: not 0 where it can draw
    std::span<const Problem> problems;     // of the files as they are now
    bool stale = false;                    // the picture is that of an earlier, working state of the files
    std::uint64_t revision = 0;            // counts readings of the files
    bool animated = false, mouse = false;  // the picture depends on time, on where the mouse is
    double time = 0;                       // seconds since the scene began
    double frame_ms = 0;                   // to draw the last picture
    int samples = 1;
    std::string_view renderer;
    bool changed = false;                              // some value or rung is not the scene's
    bool undoable = false;                             // values were saved to the scene
    std::array<bool, snapshot_count + 1> snapshots{};  // by number: whether there is one
    const AccuracyFacts* accuracy = nullptr;           // while its panel is open
    const Explanation* explanation = nullptr;          // while Memory::costs
    const Sources* sources = nullptr;                  // that the spans of it are of
    const FrameCostFacts* frame_cost = nullptr;        // while Memory::frame_cost
    const PixelFacts* pixels = nullptr;                // while PixelMemory asks for something
    std::string_view object;                           // what the picked one is
    std::span<const FileRow> files;                    // in use, in the order of reading
    std::string_view editor;                           // what opens them
    std::span<const std::string> recent;               // scenes, the last one first
    const Listing* listing = nullptr;                  // of the folder in the browser
};

// The scene's time, as the user lets it go.
struct Clock {
    bool paused = false;
    double speed = 1;
    double time = 0;  // seconds
};

struct Memory {
    bool panel = true;
    float panel_width = 22;  // in heights of the letters
    Theme theme = Theme::light;
    float zoom = 1;  // of letters and widgets, on top of the screen's
    Titles open;     // sections
    bool warnings_open = false;
    bool problems_hidden = false;
    std::uint64_t revision = 0;       // that `problems_hidden` speaks of
    std::set<std::string> dismissed;  // messages
    SliderMemory slider;
    std::set<std::string> logarithmic;  // sliders, as "program.name" with the program's index
    std::string notice;                 // what became of the last request
    bool labels = false;                // the values over the picture
    Clock clock;
    AccuracyMemory accuracy;
    bool costs = false;       // that panel is open
    bool frame_cost = false;  // so is that
    PixelMemory pixels;
    HoldMemory hold;
    bool keys = false;  // the list of them is open
    Browser browser;
    PictureMemory picture;
    Rect scene;  // where the scene is, of this frame
};

// What a user asked for in this frame that is not a change of Controls or View.
struct Requests {
    bool reload = false;
    bool save = false, undo_save = false;
    bool copy_command = false;
    std::optional<Point> pick;                     // the object there
    int store_snapshot = 0, restore_snapshot = 0;  // its number
    bool measure = false;        // all rungs of the plotted ladder; while they are measured: no longer
    bool measure_frame = false;  // its passes and draws; or no longer
    bool browse = false;         // the folder of Browser is to be listed
    std::string open;            // a scene
    Place edit;
    PictureRequest picture = PictureRequest::none;
};

}  // namespace snell::ui
