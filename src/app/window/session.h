// A scene that is being edited. It is read again whenever one of its files is saved, and once it was shown, there is
// always a picture.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "src/app/desktop/watch.h"
#include "src/app/open/states.h"
#include "src/app/window/survive/recovery.h"
#include "src/document/document.h"
#include "src/plan/setup.h"
#include "src/ui/panels/state.h"

namespace snell {

// Changes the rungs that a scene begins with; problems are shown together with the scene's.
using FirstRungs = std::function<void(const Scene& scene, Rungs& rungs, Diagnostics& diagnostics)>;

class Session {
public:
    // Without a path there is no scene until open(). The GL context of `caps` must be current during the object's whole
    // life. `progress` is called while the scene loads. With `recovery` the session begins with that state instead of
    // the file, and with `memory` it has values of an earlier one, unless the scene has them and there is a recovery.
    Session(std::string path, gl::Caps caps, Access access = {}, FirstRungs first = nullptr, Watcher progress = nullptr,
            const Recovery* recovery = nullptr, Remembered memory = {});

    // Tells that the shown document was drawn without problems, with its current values. What the picture was found to
    // cost becomes a problem.
    void drawn_well();
    // Adds what `snell check` would find by its lints in the shown document, once its picture was drawn. Returns true
    // if that is anything; until the scene is read again, or rungs are chosen, it is looked for once.
    bool lint();
    // Returns the last state that was drawn without problems, for use after the loss of the context. The session then
    // shows nothing any more.
    std::shared_ptr<const Kept> salvage();
    // The recovery's values, until they have been restored.
    const std::string& by_hand() const { return by_hand_; }

    // Reads the files again. If the new version has errors that the shown one does not have, its problems are shown
    // over the last good picture. Values of controls carry over.
    void reload();
    // The next reload keeps values and rungs although the text changes them, if one of these files is in use.
    void hold_values(const std::vector<SavedFile>& files);
    // True if such files, and no others, have changed since the scene was read.
    bool awaits_own() const;
    // What they did in the last reload.
    Follow followed() const { return followed_; }
    // Shows another scene as it is in its file, with the values of `memory`. Returns "", or why the current scene
    // stays.
    std::string open(std::string path, Remembered memory = {});
    // True if a file in use was saved, so that the scene must be reloaded; `at_once`: even if it may still be written.
    bool saved(bool at_once = false) { return watch_.changed(at_once); }

    // Compiles the programs for other rungs if the controls ask for them. Returns true if the problems may have
    // changed.
    bool follow_rungs();

    // What differs from the scene, and what did when it was last in the scene.
    Remembered remembered(bool all = false) const;
    // The rungs of the text and the command line, without those that were remembered.
    const Rungs& first_rungs() const { return first_rungs_; }

    // The shown document; null until the scene's file could be read.
    Document* document() { return shown_.get(); }
    // The problems of the files as they are now.
    const std::vector<ui::Problem>& problems() const { return problems_; }
    std::size_t errors() const { return errors_; }
    bool stale() const { return stale_; }
    // Those of the chosen rungs with which something does not compile, such as "BEND=bounces", so that the picture is
    // of the rungs before; empty if all do.
    const std::string& failed_rungs() const { return failed_rungs_; }
    // True if errors of the last reading may be those of rungs that are not chosen any more.
    bool outdated() const;
    std::uint64_t revision() const { return revision_; }  // number of readings and of choices of rungs so far
    const Earlier& earlier() const { return earlier_; }
    std::string problems_text() const;
    // Every file in use, with the scene first. After a broken edit, both the files that it reads and those of the shown
    // picture.
    const std::vector<std::string>& files() const { return files_; }
    const std::string& path() const { return path_; }

private:
    std::unique_ptr<Document> read(const std::string& path, const FirstRungs& choose);
    void take(std::unique_ptr<Document> read);
    void tell(const Diagnostic& diagnostic, const Sources& sources);
    void recover(const Recovery& recovery);
    void choose(const Scene& scene, Rungs& rungs, Diagnostics& refused);
    void choose_first(const Scene& scene, Rungs& rungs, Diagnostics& refused);
    // The values that are held; where another program has saved since, those that were changed since.
    Remembered held() const;
    void carry_values(Document& read);
    void keep_shown();
    void watch(const Document& read);

    std::string path_;
    gl::Caps caps_;
    Access access_;
    GivenTexts given_;
    FirstRungs first_;
    Watcher progress_;
    std::unique_ptr<Document> shown_;
    Plan plan_, read_plan_;  // of shown_; of the last reading
    bool drawn_well_ = false;
    bool linted_ = false;
    std::string by_hand_;
    bool recovering_ = false;  // until the scene is read: values that are not in by_hand_ are those of the text
    Remembered memory_;        // values that shown_ does not have, and those with which it began
    bool hold_values_ = false;
    std::map<std::string, std::string> held_;  // the files for which it does, and their texts
    Setup held_since_;                         // all values as they were then
    Follow followed_ = Follow::text;
    Rungs first_rungs_;
    Rungs read_rungs_;  // chosen at the last reading; empty after a recovery
    Rungs good_rungs_;  // chosen last without errors
    std::string failed_rungs_;
    Earlier earlier_;
    std::shared_ptr<const Kept> kept_;   // of the previous document, if it was drawn without problems
    std::vector<ui::Problem> problems_;  // those of the files, then those of rungs that were chosen since
    std::vector<std::string> printed_;   // the same problems, with the names of files as the user gave them
    std::size_t file_problems_ = 0, file_errors_ = 0;
    std::size_t errors_ = 0;
    bool stale_ = false;
    bool broken_ = false;  // the last reading has errors of its own, not only from the command line
    std::uint64_t revision_ = 0;
    std::vector<std::string> files_;
    Watch watch_;
};

}  // namespace snell
