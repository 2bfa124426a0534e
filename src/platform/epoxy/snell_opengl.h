// OpenGL by libepoxy, for src/gl/api.h.
#pragma once

#include <epoxy/gl.h>
