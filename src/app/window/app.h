// The window's main class: it handles input, panels and files, and draws a picture only if it would differ from the
// last one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/app/open/deadline.h"
#include "src/app/open/loss.h"
#include "src/app/window/loading_screen.h"
#include "src/app/window/measure/accuracy_view.h"
#include "src/app/window/measure/frame_costs.h"
#include "src/app/window/opener.h"
#include "src/app/window/picking.h"
#include "src/app/window/picture_saver.h"
#include "src/app/window/pixel_view.h"
#include "src/app/window/session.h"
#include "src/app/window/survive/keeper.h"
#include "src/app/window/survive/recovery.h"
#include "src/app/window/survive/restart.h"
#include "src/app/window/window.h"
#include "src/app/window/window_state.h"
#include "src/gl/present.h"
#include "src/platform/window.h"
#include "src/ui/kit/gui.h"

namespace snell {

// The inputs of the last picture of the scene. While they are the same, so is the picture.
struct Drawn {
    std::uint64_t revision = 0;
    Stand stand;
    Rungs rungs;
    Index object = none;  // the object with the outline

    bool operator==(const Drawn&) const = default;
};

// Collects the values of all controls, in their order.
void gather(const Controls& controls, std::vector<double>& values);
std::string title_of(const std::string& scene);

class App {
public:
    App(const WindowOptions& options, std::unique_ptr<Window> window, Restart& restart, const Carried* carried);
    void run();
    bool readable() { return session_.document() != nullptr; }
    // True if the driver reset the context. Once run() has returned, carried() has the state for a new window.
    bool lost() const { return lost_; }
    Carried carried();

private:
    PixelSize size_without_scene();
    // The size of the drawing area: the scene's WindowSize, or a comfortable default if it has none.
    PixelSize first_size();
    // True if the scene sets its size.
    bool own_size();
    bool held() const { return memory_.accuracy.open && memory_.accuracy.hold_time; }
    // True if the next frame would be another picture even without input.
    bool moving();
    // The scene's time in seconds, which the user can pause and set.
    double scene_time();
    // The state of the picture that was drawn last.
    Carried carry(Recovery recovery);
    // Stores the state for a window that may have to replace this one: the last state that was drawn without problems,
    // because the current one may be their cause.
    void keep_by_hand();
    void reload();
    // Seconds to sleep if there is no input.
    double pause();
    bool visible();
    void step();
    // Takes a step of the accuracy panel's refinement, while there is nothing else to do.
    bool refined();
    // Passes the input to the panels, which change controls and view. Draws nothing yet.
    void interface_frame(std::span<const Event> events);
    ui::Facts facts();
    // Shows another scene, as if the window had been opened with it; the appearance of the window stays.
    void show_scene(const std::optional<std::string>& path);
    void tell_measured(ui::Facts& facts);
    // Draws the scene if its picture would change, and presents the window if anything in it changed.
    void show(bool repaint);
    // Returns true if something must be shown again.
    bool look_at_pixels();
    // Stores the window's size as the one that the user chose.
    void remember_size();
    bool draw_scene(PixelSize pixels);
    void present(PixelSize pixels);
    void report();

    WindowOptions options_;
    std::unique_ptr<Window> window_;
    Restart& restart_;
    ui::Gui gui_;
    ui::Painter painter_;
    gl::Canvas canvas_;
    Drawn drawn_, next_;
    LoadingScreen loading_;
    gl::Caps caps_;
    Session session_;
    Keeper keeper_;
    AccuracyView accuracy_;
    FrameCosts frame_costs_;
    PixelView pixels_;
    Picking picking_;
    Opener opener_;
    PictureSaver saver_;
    View view_;
    ui::Memory memory_;
    ui::Layout layout_;
    std::vector<Event> events_;
    // Name of the scene's file, the path it belongs to, and the last problems that were printed.
    std::string file_, named_, reported_;
    std::vector<char> linked_;
    WindowCounters counters_;
    std::uint64_t kept_frame_ = 0;  // the frame whose state Restart has
    Explanation explanation_;
    std::uint64_t explained_ = 0;  // the revision that explanation_ belongs to
    std::uint64_t interface_ = 0, presented_ = 0, presented_beside_ = 0;
    app::Deadline hang_;
    app::LossWatch loss_;
    bool lost_ = false;
    bool edited_ = false;  // a file was saved before the window was open
    int unsettled_ = 3;
    double began_ = 0, ticked_ = 0, last_input_ = 0, last_picture_ = 0, next_look_ = 0;
};

}  // namespace snell
