// OpenGL's header, which the platform provides: libepoxy's (src/platform/epoxy), or that of a browser.
#pragma once

#include <snell_opengl.h>
