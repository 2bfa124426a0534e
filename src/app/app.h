// What a window does: input, panels, files, and a picture when it would be another.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/app/accuracy_view.h"
#include "src/app/deadline.h"
#include "src/app/frame_costs.h"
#include "src/app/keeper.h"
#include "src/app/loading_screen.h"
#include "src/app/loss.h"
#include "src/app/opener.h"
#include "src/app/picking.h"
#include "src/app/picture_saver.h"
#include "src/app/pixel_view.h"
#include "src/app/recovery.h"
#include "src/app/restart.h"
#include "src/app/session.h"
#include "src/app/window.h"
#include "src/app/window_state.h"
#include "src/gl/present.h"
#include "src/platform/window.h"
#include "src/ui/gui.h"

namespace snell {

// All that the last picture of the scene was drawn from: while it stays, so does the picture.
struct Drawn {
    std::uint64_t revision = 0;
    Stand stand;
    Rungs rungs;
    Index object = none;  // that is outlined

    bool operator==(const Drawn&) const = default;
};

void gather(const Controls& controls, std::vector<double>& values);
std::string title_of(const std::string& scene);

class App {
public:
    App(const WindowOptions& options, std::unique_ptr<Window> window, Restart& restart, const Carried* carried);
    void run();
    bool readable() { return session_.document() != nullptr; }
    // The driver took the context away. carried() is for another window, once this one's run() is over.
    bool lost() const { return lost_; }
    Carried carried();

private:
    PixelSize size_without_scene();
    // The drawing area is the scene's WindowSize; who asked for none gets a comfortable one.
    PixelSize first_size();
    // The scene says how large it is.
    bool own_size();
    bool held() const { return memory_.accuracy.open && memory_.accuracy.hold_time; }
    // Another frame of the same would be another picture.
    bool moving();
    // Seconds of the scene's own time, which the user may hold and set.
    double scene_time();
    // Of the picture that was drawn last.
    Carried carry(Recovery recovery);
    // For a window that has to take this one's place: what was drawn well, not what may be why it has to.
    void keep_by_hand();
    void reload();
    // How long nothing will happen without input.
    double pause();
    bool visible();
    void step();
    // A step toward a better reference, while there is nothing else to do.
    bool refined();
    // The panels see the input and change controls and view; nothing is drawn yet.
    void interface_frame(std::span<const Event> events);
    ui::Facts facts();
    // Another scene, as if the window had been opened on it; what its looks are stays.
    void show_scene(const std::optional<std::string>& path);
    void tell_measured(ui::Facts& facts);
    // Draws the scene if its picture would be another, and presents if anything is.
    void show(bool repaint);
    // True: there is something else to show.
    bool look_at_pixels();
    // That the user gave it.
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
    std::string file_, named_, reported_;  // the file's name, of which path; what was printed of its problems
    std::vector<char> linked_;
    WindowCounters counters_;
    std::uint64_t kept_frame_ = 0;  // what Restart has is of that one
    Explanation explanation_;
    std::uint64_t explained_ = 0;  // the revision that it is of
    std::uint64_t interface_ = 0, presented_ = 0, presented_beside_ = 0;
    app::Deadline hang_;
    app::LossWatch loss_;
    bool lost_ = false;
    bool edited_ = false;  // before the window was there
    int unsettled_ = 3;
    double began_ = 0, ticked_ = 0, last_input_ = 0, last_picture_ = 0, next_look_ = 0;
};

}  // namespace snell
