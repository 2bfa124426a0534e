// Messages over the picture: errors and warnings about the files, and message boxes of the scene.
#pragma once

#include "src/ui/kit/style.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

// Shows errors in full, because they must be seen. Warnings are one line until the user opens them.
void problems_panel(const Facts& facts, const Rect& scene, const Fonts& fonts, Memory& memory, Requests& requests,
                    Layout& layout);

// Shows each message of a MessageBox statement until the user dismisses it.
void notices(const Facts& facts, const Rect& scene, Memory& memory, Layout& layout);

}  // namespace snell::ui
