#include <imgui.h>

#include "src/ui/kit/input.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

void keep_keys(const Facts& facts, Requests& requests) {
    if (!facts.scene) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && pressed(Key::s)) (io.KeyShift ? requests.save_as : requests.save) = true;
    for (int number = 1; number <= snapshot_count; ++number) {
        if (!pressed(static_cast<Key>(static_cast<int>(Key::one) + number - 1))) continue;
        (io.KeyCtrl ? requests.store_snapshot : requests.restore_snapshot) = number;
    }
}

}  // namespace snell::ui
