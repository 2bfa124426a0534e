// OpenGL by libepoxy, for src/gl/driver.h.
#pragma once

#include <epoxy/gl.h>
