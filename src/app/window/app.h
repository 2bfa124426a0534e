// The window's loop: it waits for events, hands them from part to part, and shows what changed.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/app/open/ending.h"
#include "src/app/window/display.h"
#include "src/app/window/interface.h"
#include "src/app/window/measuring.h"
#include "src/app/window/picking.h"
#include "src/app/window/survive/restart.h"
#include "src/app/window/window.h"
#include "src/app/window/workspace.h"

namespace snell {

class App {
public:
    App(const WindowOptions& options, std::unique_ptr<Window> window, Restart& restart, const Carried* carried,
        Past& past);
    // Returns when the window is closed or the context is lost. `edited`: a file was saved before the window was open.
    void run(bool edited);
    // False if the scene could not be read; a window without a scene is fine.
    bool readable() { return workspace_.document() != nullptr || workspace_.session().path().empty(); }
    // True if the driver reset the context. Once run() has returned, carried() has the state for a new window.
    bool lost() const { return display_.lost(); }
    Carried carried();

private:
    // Shows the progress of loading. A window that is still hidden is shown first.
    void loading(const LoadProgress& progress);
    // The size of the drawing area: the scene's WindowSize, or a comfortable default if it has none.
    PixelSize first_size();
    // True if the scene sets its size.
    bool own_size();
    // Stores the window's size as the one that the user chose.
    void remember_size();
    // The state of the picture that was drawn last.
    Carried carry(Recovery recovery);
    // Stores the state for a window that may have to replace this one: the last state that was drawn without problems,
    // because the current one may be their cause.
    void keep_by_hand();

    // The document whose picture the window shows: the scene's, or that of a found rung. Null: there is no scene.
    Document* shown_document();
    // True if the next frame would be another picture even without input.
    bool moving();
    // True if time or values change by themselves.
    bool running();
    bool visible();
    // Seconds to sleep if there is no input.
    double pause();
    // For tests, with a state file: takes the question from FILE.ask. Returns true if it is a new one.
    bool listen();
    // Returns true, and has the state name the question as answered, if all input and all saved files from before it
    // are handled and seen.
    bool answer();
    // Draws at least that many more frames, even without input.
    void settle(int frames);
    void step();
    // Looks for saved files and ended editors. Returns true if there is something new to show.
    bool look();
    // Draws the next part of a picture that is being saved.
    void save();
    // Compiles programs for the values as they are, if nothing was touched for a while. Returns true if there was
    // something to do.
    bool specialise();
    // Draws a picture to measure it, if nothing else is to be done. Returns true if there is something new to show.
    bool measure();
    // Keeps a picture of the open scene for the file browser.
    void keep_picture();
    void reload();
    // Shows another scene, as if the window had been opened with it; the appearance of the window stays.
    void show_scene(const std::optional<std::string>& path);
    // Passes the input to the panels, which change controls and view, and does what they ask for. Draws nothing yet.
    void interface_frame(std::span<const Event> events);
    ui::Facts facts();
    void serve(const ui::Requests& requests);
    // Draws the scene if its picture would change, and presents the window if anything in it changed.
    void show(bool repaint);
    bool draw_scene();
    void write_state();

    WindowOptions options_;
    std::unique_ptr<Window> window_;
    Restart& restart_;
    Interface interface_;
    Display display_;
    gl::Caps caps_;
    Patience patience_;
    bool shown_ = false;  // whether the window was shown
    Workspace workspace_;
    Measuring measuring_;
    Picking picking_;
    app::Deadline hang_;
    std::vector<Event> events_;
    std::uint64_t kept_frame_ = 0;              // the frame whose state Restart has
    std::array<std::uint64_t, 2> presented_{};  // the panels, and what lies over the picture, as last presented
    int unsettled_ = 3;                         // number of frames to draw even without input
    // Number of frames to present even if nothing changed: some drivers learn a new size with the next picture.
    int repaints_ = 3;
    double began_ = 0, next_look_ = 0;  // by the clock of the window
    double touched_ = 0;                // when there was input last
    std::string pictured_;              // the scene of which a picture was kept
    std::string question_, answered_;   // see listen()
    int steps_ = 0;                     // since the question, without rest
    bool specialised_ = false;          // nothing more can be compiled for the values as they are
};

}  // namespace snell
