// A scene while it is being worked on: read again whenever a file of it is saved, and never without a picture
// once it had one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "src/app/document.h"
#include "src/app/recovery.h"
#include "src/app/watch.h"
#include "src/ui/state.h"

namespace snell {

// Changes the rungs that a scene begins with; problems with that are shown beside the scene's.
using FirstRungs = std::function<void(const Scene& scene, Rungs& rungs, Diagnostics& diagnostics)>;

class Session {
public:
    // Needs the GL context of `caps` to be current, for all of its life. `progress` is told how far loading is. With
    // `recovery` it begins with that instead of the file.
    Session(std::string path, gl::Caps caps, Access access = {}, FirstRungs first = nullptr, Watcher progress = nullptr,
            const Recovery* recovery = nullptr);

    // The shown document gave a picture, with these values.
    void drawn_well() { drawn_well_ = true; }
    // What was last drawn well, for after the loss of the context. The session shows nothing any more.
    std::shared_ptr<const Kept> salvage();
    // What the recovery's values say, until they are where they belong.
    const std::string& by_hand() const { return by_hand_; }

    // Reads the files again. A state with errors that the shown one does not have is not shown: its problems
    // are, over the last good picture. Values of controls carry over.
    void reload();
    // Shows another scene, as it is in its file. "", or why the one that is shown stays.
    std::string open(std::string path);
    // A file in use was saved: it is time to reload.
    bool saved() { return watch_.changed(); }

    // Compiles what other rungs of the shown scene's ladders need, if its controls ask for them. True: problems may
    // be others.
    bool follow_rungs();

    // What is shown; none until the scene's file could be read.
    Document* document() { return shown_.get(); }
    // Of the files as they are now.
    const std::vector<ui::Problem>& problems() const { return problems_; }
    std::size_t errors() const { return errors_; }
    bool stale() const { return stale_; }
    std::uint64_t revision() const { return revision_; }  // readings and choices of rungs so far
    std::string problems_text() const;
    // Every file in use, the scene first; of a broken edit, both what it reads and what is shown.
    const std::vector<std::string>& files() const { return files_; }
    const std::string& path() const { return path_; }

private:
    std::unique_ptr<Document> read(const std::string& path, const Document* previous, const FirstRungs& first);
    void take(std::unique_ptr<Document> read);
    void recover(const Recovery& recovery);
    void keep_shown();
    void watch(const Document& read);

    std::string path_;
    gl::Caps caps_;
    Access access_;
    FirstRungs first_;
    Watcher progress_;
    std::unique_ptr<Document> shown_;
    Plan plan_, read_plan_;  // of shown_; of what was read last
    bool drawn_well_ = false;
    std::string by_hand_;
    std::shared_ptr<const Kept> kept_;   // of what was shown before, and drawn well
    std::vector<ui::Problem> problems_;  // of the files, then of the rungs chosen since
    std::size_t file_problems_ = 0, file_errors_ = 0;
    std::size_t errors_ = 0;
    bool stale_ = false;
    bool broken_ = false;  // what was read last has errors of its own, not only of the command line
    std::uint64_t revision_ = 0;
    std::vector<std::string> files_;
    Watch watch_;
};

}  // namespace snell
