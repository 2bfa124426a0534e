// Does what the user wants kept: values into the scene, snapshots, the command that draws the picture.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "src/app/command_text.h"
#include "src/app/document.h"
#include "src/app/save_values.h"
#include "src/app/snapshots.h"
#include "src/platform/window.h"
#include "src/ui/state.h"

namespace snell {

class Keeper {
public:
    explicit Keeper(std::string scene) : scene_(std::move(scene)) {}

    void tell(ui::Facts& facts, const Document* document);
    // Says in `notice` what became of it.
    void serve(const ui::Requests& requests, Document& document, const Picture& picture, Window& window,
               std::string& notice);

private:
    std::string save(const Document& document);
    std::string undo();
    std::string store(int number, const Document& document);

    std::string scene_;
    std::vector<std::vector<SavedFile>> saved_;  // the last one at the end
    std::array<bool, ui::snapshot_count + 1> snapshots_{};
    std::uint64_t looked_ = 0;  // the revision at which the snapshots were looked for
};

}  // namespace snell
