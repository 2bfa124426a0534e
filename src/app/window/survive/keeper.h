// Executes the requests to keep values: it saves them to the scene, stores and restores snapshots, and copies the
// command that draws the picture.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "src/app/open/command_text.h"
#include "src/app/open/snapshots.h"
#include "src/document/document.h"
#include "src/document/save_values.h"
#include "src/platform/window.h"
#include "src/ui/panels/state.h"

namespace snell {

class Keeper {
public:
    explicit Keeper(std::string scene) : scene_(std::move(scene)) {}

    // Fills in what the panels show: whether values changed, whether a save can be reverted, and the snapshots.
    void tell(ui::Facts& facts, const Document* document);
    // Looks for the snapshots again, after their file may have changed.
    void look_again() { snapshots_ = snapshots_there(scene_); }
    // Results that Workspace and Past need.
    struct Served {
        bool reverted = false;  // the file is as it was before a save
        int snapshot = 0;       // number of the one that was stored, in this file; 0 for none
        SavedFile file;
        std::string saved_as;  // path of the scene that was saved under another name
    };
    // Executes the requests and sets `memory.notice` to their outcome.
    Served serve(const ui::Requests& requests, Document& document, const Picture& picture, Window& window,
                 ui::Memory& memory);

private:
    std::string save(const Document& document);
    std::string revert(Served& served);
    std::string store(int number, const Document& document, Served& served);

    std::string scene_;
    std::vector<std::vector<SavedFile>> saved_;  // the latest is last
    std::array<bool, ui::snapshot_count + 1> snapshots_{};
    std::uint64_t looked_ = 0;  // the revision at which the snapshots were last looked for
};

}  // namespace snell
