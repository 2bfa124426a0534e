// What the current context is. Each platform has its own answers.
#pragma once

namespace snell::gl {

bool is_desktop();  // OpenGL, and not OpenGL ES
int version();      // 45 for 4.5
bool has_extension(const char* name);

}  // namespace snell::gl
