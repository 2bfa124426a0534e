// Opening the OpenImageIO module early.
#pragma once

namespace snell::content {

// Where a process starts copies of itself: opening the module takes a quarter of a second, which later copies save if
// this process opens it, too, once one of them needed it. Called before each copy is started. Starts no thread.
void open_image_module_as_copies_do();

}  // namespace snell::content
