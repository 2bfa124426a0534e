// Opening the OpenImageIO module early.
#pragma once

namespace snell::content {

// Opens the module now, if there is one: it takes a quarter of a second, which copies of this process then save. Starts
// no thread.
void open_image_module();

}  // namespace snell::content
