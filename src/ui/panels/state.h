// The data of the panels: facts that they show, requests that they make, and what they remember from frame to frame.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/plan/setup.h"
#include "src/plan/values/animate.h"
#include "src/plan/values/controls.h"
#include "src/plan/view.h"
#include "src/runtime/explain.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/accuracy.h"
#include "src/ui/panels/browser.h"
#include "src/ui/panels/found.h"
#include "src/ui/panels/pixels.h"
#include "src/ui/panels/save_as.h"
#include "src/ui/panels/textures.h"

namespace snell::ui {

// The tabs of the panel: what a scene puts on sliders, and what is measured and set beside it.
enum class Tab : std::uint8_t { controls, tools };

// A diagnostic, with files named as the user reads them, and the place that it refers to if that is in a file on disk.
struct Problem {
    Finding finding;
    Place place;
};

// A file in use.
struct FileRow {
    std::string name;  // relative to the scene's folder if it is near, with unprintable characters replaced
    std::string path;  // path on disk
};

// The number of snapshots, which are sets of values stored next to the scene, numbered from 1.
inline constexpr int snapshot_count = 9;

// The time of a pass; rows of its draws follow it.
struct CostRow {
    std::string name, place;
    double milliseconds = 0;  // median
    bool draw = false;
};

struct FrameCostFacts {
    std::span<const float> frames;    // of the last sharp pictures, in milliseconds as Facts::frame_ms, oldest first
    float median = 0, high = 0;       // `high` is the 95th percentile
    std::span<const CostRow> passes;  // of the frames that were drawn, by the GPU's clock; empty if it has none
    std::span<const CostRow> apart;   // measured on request, in additional frames
    std::string_view apart_clock;
    double apart_plain = 0;           // a whole one of these frames, without waits or queries between its draws
    std::optional<double> measuring;  // progress 0..1 while the additional frames are drawn
    int coarse = 0;                   // number of coarse pictures, which are not among `frames`
    std::string reduced;              // as in AccuracyFacts, of `apart`
    bool older = false;               // `apart` is of other values or another view than the picture's
};

struct SampleCards {
    std::span<const SceneCard> scenes, lessons;
};

// A point in window coordinates from the scene's top left.
struct Point {
    double x = 0, y = 0;
};

// What the panels show; filled in anew for every frame.
struct Facts {
    std::string_view file;                 // name of the scene's file without its folder; empty: no scene is open
    const Scene* scene = nullptr;          // null if the scene could not be read
    std::span<const char> linked;          // by Scene::programs: not 0 if the program can draw
    std::span<const Problem> problems;     // of the files as they are now
    bool stale = false;                    // the picture shows an earlier version of the files
    bool incomplete = false;               // that version has errors, too
    std::string_view failed_rungs;         // chosen, but the picture is of the rungs before, see Session
    bool first_picture = false;            // it is drawn next: no picture of the scene is there yet
    double longest_picture = 0;            // seconds after which one is given up; 0: never
    std::uint64_t revision = 0;            // increases each time the files are read
    bool animated = false, mouse = false;  // whether the picture depends on time, and on the mouse's position
    bool timed = false;                    // whether it depends on time with some values of the uniforms
    double time = 0;                       // seconds since the scene began
    double frame_ms = 0;                   // time to draw the last picture, in milliseconds
    int samples = 1;                       // per pixel, of a sharp picture
    std::string grain;  // how much coarser the last picture is, because something is dragged; empty if sharp
    std::string_view renderer;
    bool changed = false;                              // whether any value or rung differs from the scene's
    std::array<bool, snapshot_count + 1> snapshots{};  // by number: whether the snapshot exists
    const StateFacts* states = nullptr;                // set while two states are shown
    const AccuracyFacts* accuracy = nullptr;           // set while its panel is open, if there is a reference
    const FoundFacts* found = nullptr;                 // set while the panel of accuracy is open
    const Explanation* explanation = nullptr;          // set while Memory::costs
    const Sources* sources = nullptr;                  // the sources that the explanation's spans refer to
    const FrameCostFacts* frame_cost = nullptr;        // set while Memory::frame_cost
    const PixelFacts* pixels = nullptr;                // set while PixelMemory needs them
    const TextureFacts* textures = nullptr;            // set while its panel is open
    std::string_view nan;                              // how much of the picture is NaN; empty if nothing is known
    std::uint64_t nan_looks = 0;                       // how often that was looked for
    std::string_view object;                           // name of the picked object
    std::span<const FileRow> files;                    // the files in use, in the order of reading
    std::string_view editor;                           // name of the editor that opens them
    std::span<const SceneCard> recent;                 // the latest first
    SampleCards examples;                              // scenes that come with the program
    std::span<const NewKind> kinds;                    // of new scenes
    std::string_view new_folder;                       // where new scenes are made, as displayed
    const Listing* listing = nullptr;                  // of the folder in the browser
    bool full_screen = false;
};

// The scene's time as the user controls it.
struct Clock {
    bool paused = false;
    bool used = false;  // by a slider that moved by itself
    double speed = 1;
    double time = 0;  // in seconds
};

inline constexpr double hint_seconds = 4;

// What the user asked for and did not get: it stays until it is dismissed, or its cause is gone.
struct Failure {
    // What is offered beside OK. reload: the files have changed, until they are read. save: nothing was written, until
    // it is, or nothing differs from the files any more. save_as: the same, and only another file can be. add: nothing;
    // the same of values that have no place in the text, until it has. editor: none
    // opens, until one does. store: the same snapshot again, with the values of then; recall: the same; both until that
    // succeeds. absent: there is no such snapshot, until one is stored. page: nothing, until a page is saved. open:
    // another scene, with the name that was refused in the field. sharp: nothing; the picture stays coarse, until
    // another one is begun.
    enum class Remedy : std::uint8_t {
        none,
        reload,
        save,
        save_as,
        add,
        editor,
        store,
        recall,
        absent,
        page,
        open,
        sharp
    };
    std::string text;
    Remedy remedy = Remedy::none;
    Place place = {};   // where the editor was to open; the file that could not be opened
    int snapshot = 0;   // its number
    Setup values = {};  // that were not stored
};

// The failures that are open, the latest last.
struct Failures {
    std::vector<Failure> open;
    std::string scene;                                 // that is shown, by its path
    std::map<std::string, std::vector<Failure>> left;  // of other scenes that were shown, by theirs

    // Adds a failure, in place of an earlier one of the same request.
    void add(Failure failure);
    // Removes those of a request that has succeeded since: of the same kind, and of the same snapshot. Of values that
    // were not saved there is one at most.
    void done(Failure::Remedy remedy, int snapshot = 0);
    // Removes those that say that a save was not undone, or redone, whose file has been exchanged since: `said` is what
    // undo or redo did, such as "undo: save to a.glib".
    void exchanged(std::string_view said);
    // Says the same in other words. What says the same then is said once.
    void rewrite(const std::function<std::string(const std::string& text)>& words);
    // Puts those of the scene away that is left for another one, which was opened, and takes out that one's.
    void enter(const std::string& other);
};

// The notices over the picture, so that a press that was meant for another one, which stood there before, is not taken.
struct NoticeMemory {
    struct Stood {
        std::string text;
        Rect box;
        double since = 0;  // when it came there, by ImGui::GetTime()
        Point mouse;       // was there then
        bool drawn = false;
    };
    std::vector<Stood> stood;
    bool early = false;      // whether the last press of the mouse came too early
    bool early_key = false;  // the same of a key that is pressed in this frame, for the notice that is being drawn
};

// Of the toolbar: whether a menu was open in the last frame, and whether it is to be closed, because one of the keys
// that it shows was pressed.
enum class Menu : std::uint8_t { none, open, closing };

inline constexpr float usual_problems = .3F;

// Sections of the scene's programs that the user has opened (true) or folded, by program_names().
using Folds = std::map<std::string, bool, std::less<>>;

// A number for each of the scene's programs, which it keeps in another text: a control in use follows its program, and
// is closed where that is gone.
struct ProgramNumbers {
    std::vector<int> now;
    int next = 0;

    // `programs` is what carried_programs() found; `count` programs are there now.
    void carry(const std::vector<Index>& programs, std::size_t count);
};

struct Memory {
    bool panel = true;  // false: only the picture is shown
    double hint = 0;    // seconds that the hint is shown that tells how to show the panel
    Tab tab = Tab::controls;
    float panel_width = 22;  // in multiples of the text height
    Theme theme = Theme::light;
    bool always_sharp = false;  // pictures are not drawn coarser while something is dragged
    float zoom = 1;             // factor for text and widgets, in addition to the screen's
    Titles open;                // titles of the open sections
    Folds folds;
    ProgramNumbers numbers;
    bool warnings_open = false;
    bool problems_hidden = false;
    float problems_height = usual_problems;  // of the list, as a part of the picture's height
    Menu menu = Menu::none;
    std::uint64_t revision = 0;       // the revision whose problems are hidden
    std::set<std::string> dismissed;  // messages of MessageBox that the user dismissed
    SliderMemory slider;
    std::set<std::pair<Index, std::string>> logarithmic;  // the sliders that are, by program and name
    std::vector<Animated> animated;                       // the sliders that move by themselves
    bool animating() const { return !animated.empty(); }
    bool accuracy_in_sight() const { return accuracy.open && tab == Tab::tools && panel; }
    std::array<char, 64> filter{};  // shows only sliders with this text in their names; empty: all
    std::string notice;             // the outcome of the last request
    Failures failures;
    // Adds a failure, beside which an earlier outcome no longer is that of the last request.
    void failed(Failure failure) {
        notice.clear();
        failures.add(std::move(failure));
    }
    NoticeMemory notices;
    bool labels = false;  // shows the values over the picture
    Clock clock;
    AccuracyMemory accuracy;
    bool costs = false;       // whether the costs panel is open
    bool frame_cost = false;  // whether the frame cost panel is open
    PixelMemory pixels;
    TextureMemory textures;
    HoldMemory hold;
    bool keys = false;  // whether the list of keys is open
    Browser browser;
    PictureMemory picture;
    SaveAs save_as, save_page, write_rung, set_editor, new_scene;
    Rect scene;                  // the scene's area in this frame
    float above = 0, below = 0;  // how much lower, and higher, the panel begins and ends, for what needs its width
};

// What the user requested in this frame, other than changes of Controls or View.
struct Requests {
    bool reload = false;
    bool save = false;
    bool save_as = false, save_as_now = false;  // opens the dialog; saves under the name in SaveAs
    bool save_page = false, save_page_now = false;
    bool set_editor = false, set_editor_now = false;
    bool new_scene_now = false;  // of the kind in Browser, under the name in SaveAs
    bool undo = false, redo = false;
    bool take_back = false;  // the slider is as before it was pressed last: that press is no step of undo
    bool copy_command = false;
    std::optional<Point> pick;                                          // picks the object at this point
    int store_snapshot = 0, restore_snapshot = 0, delete_snapshot = 0;  // numbers of snapshots; 0 for none
    std::optional<Setup> values;                                        // that are stored, in place of those of now
    bool measure = false;                  // measures all rungs of the plotted ladder, or stops measuring
    bool measure_frame = false;            // measures passes and draws of a frame, or stops measuring
    bool find_rungs = false;               // seeks rungs, or stops seeking
    std::optional<std::string> show_rung;  // shows the picture of a found rung; "": of the scene
    // Of the found rung that is shown: opens the dialog; writes it into the folder in SaveAs; copies the command.
    bool write_rung = false, write_rung_now = false, copy_rung = false;
    bool browse = false;       // lists the folder in Browser
    std::string open;          // path of a scene to open
    bool full_screen = false;  // fills the screen with the window, or ends that
    Place edit;
    PictureRequest picture = PictureRequest::none;
};

}  // namespace snell::ui
