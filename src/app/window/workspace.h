// The open scene and its files: it is read again when one of them is saved, other scenes are opened, and values and
// pictures are saved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/app/window/opener.h"
#include "src/app/window/past.h"
#include "src/app/window/saver.h"
#include "src/app/window/session.h"
#include "src/app/window/survive/recovery.h"
#include "src/app/window/window.h"

namespace snell {

std::string title_of(const std::string& scene, bool unsaved = false);

class Workspace {
public:
    // The GL context of `caps` must be current during the object's whole life. `progress` and `recovery` are those of
    // Session; `past` outlives the object, and the context.
    Workspace(const WindowOptions& options, const gl::Caps& caps, Watcher progress, const Recovery* recovery,
              Past& past);

    Session& session() { return session_; }
    // Of the scene's file, as displayed; after tell().
    const std::string& name() const { return name_; }
    // The scene's folder, as displayed.
    std::string folder();
    Document* document() { return session_.document(); }
    const Settings& settings() const { return opener_.settings(); }

    // Prints the problems of the scene, if they are others than before.
    void report();
    void reload(View& view, ui::Memory& memory);
    // Compiles the programs for other rungs if the controls ask for them. Returns true if the problems may have
    // changed.
    bool follow_rungs();
    // Records the scene as the most recent one, if it could be read.
    void remember_scene();
    // Whether the scene that is opened next is this one, which was saved under another name.
    bool is_saved_as() const { return !saved_as_.empty(); }
    // Shows another scene, as if the window had been opened with it. Returns "", or why the current scene stays. `view`
    // is that of the current scene.
    std::string open(const std::string& path, View& view);
    // Begins with the view and the folds of the scene that was just opened, as they were last. Sets the notice if
    // anything is not as the scene says.
    void begin(View& view, ui::Memory& memory);
    // The same for a window that continues another one, as it was.
    void continue_with(const View& view, ui::Memory& memory);
    // Call it before the scene is left: what is being changed becomes a step, which is kept. Files that were just saved
    // are read, unless the context is `lost`.
    void finish(View& view, bool lost = false);
    // Call it regularly: it checks for ended editors and writes settings and the state of the scene where they changed.
    // Returns true if it changed `memory.notice`.
    bool look(const View& view, ui::Memory& memory);
    // Returns the window's title if it changed.
    std::optional<std::string> new_title();
    // Remembers the size of the window; see Opener.
    void resized(int width, int height) { opener_.resized(width, height); }

    // Opens the file browser in a folder.
    void browse(const std::string& folder, ui::Memory& memory) { opener_.browse(folder, memory); }
    // Keeps a small picture of the open scene for the file browser.
    void keep_picture(const content::Image& picture) { opener_.keep_picture(session_.path(), picture); }
    Past& past() { return past_; }

    // Fills in the facts about the scene and its files.
    void tell(ui::Facts& facts, const ui::Memory& memory);
    // Executes the requests about files, values and pictures; `shown` is what the window shows. Returns the path of a
    // scene to open, if there is one.
    std::optional<std::string> serve(const ui::Requests& requests, const Picture& shown, Window& window, View& view,
                                     ui::Memory& memory);
    // The same for files that were dropped on the window.
    std::optional<std::string> serve_dropped(const std::vector<std::string>& paths, ui::Memory& memory) {
        return opener_.serve_dropped(paths, memory);
    }
    // True while a picture is being saved: step() draws its next part.
    bool saving() const { return saver_.busy(); }
    void step(ui::Memory& memory) { saver_.step(document(), session_.revision(), memory); }

private:
    // Those of the scene that was just opened.
    void take_sections(ui::Memory& memory);
    void serve_page(const ui::Requests& requests, const View& view, ui::Memory& memory);

    Past& past_;
    Session session_;
    Keeper keeper_;
    Opener opener_;
    PictureSaver saver_;
    PageMaker pages_;
    std::string name_;      // of the scene's file
    std::string saved_as_;  // what is said of the scene under another name, until it is shown
    bool unsaved_ = false;
    std::string titled_path_;  // of the title that was set last
    std::optional<bool> titled_unsaved_;
    std::string reported_;  // the problems that were printed last
    std::vector<char> linked_;
};

}  // namespace snell
