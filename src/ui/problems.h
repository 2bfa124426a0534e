// Over the picture: what is wrong with the files, and what the scene has to say.
#pragma once

#include "src/ui/state.h"
#include "src/ui/style.h"

namespace snell::ui {

// Errors are open and in the way, as they should be; warnings are one line until asked for.
void problems_panel(const Facts& facts, const Rect& scene, const Fonts& fonts, Memory& memory, Requests& requests,
                    Layout& layout);

// MessageBox, each until dismissed.
void notices(const Facts& facts, const Rect& scene, Memory& memory, Layout& layout);

}  // namespace snell::ui
