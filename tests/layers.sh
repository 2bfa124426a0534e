#!/usr/bin/env bash
# The architecture as a test: who may include and call what, and what the program links.
# usage: layers.sh ROOT BIN
set -u
root=$1 bin=$2
cd "$root" || exit 1
failed=0
complain() {
  [ -z "$2" ] && return
  printf '%s:\n%s\n' "$1" "$2"
  failed=1
}
code() { find parser src tools -name '*.h' -o -name '*.cpp' | sort; }

complain "OpenGL is called in src/gl and src/runtime only, and where a platform provides it" \
  "$(code | grep -vE '^src/(gl|runtime|platform/epoxy|platform/web)/' |
     xargs grep -nE '\bgl[A-Z][A-Za-z0-9]*\(|#include <(epoxy/gl.h|snell_opengl.h|GLES)')"
complain "libepoxy is one platform's: src/gl/driver.h and driver.h stand for it" \
  "$(code | grep -vE '^src/platform/' | xargs grep -nE '\bepoxy_|#include <epoxy')"
complain "calls that OpenGL ES 3.0 lacks go through src/gl/driver.h" \
  "$(code | grep -vE '^src/platform/' | xargs grep -nE '\bgl(PolygonMode|PointSize|PatchParameteri|Tex(Image|Storage)(1D|[23]DMultisample)|TexBuffer|Uniform[1-4]dv?|GetProgramResource[a-z]*|QueryCounter|GetQueryObject(i|u?i64)v|DebugMessage[A-Z][a-z]*|GetGraphicsResetStatus|MapBuffer|GetTexImage|DrawBuffer|ClearDepth)\(')"
complain "EGL and GLFW belong to src/platform" \
  "$(code | grep -vE '^src/platform/' | xargs grep -nE '#include <(epoxy/egl|EGL/|GLFW/)' | grep -vE '^src/ui/')"
complain "OpenImageIO belongs to src/content/oiio" \
  "$(code | grep -vE '^src/content/oiio/' | xargs grep -nE '#include <OpenImageIO')"
complain "Cairo belongs to src/accuracy/report/slide/cairo" \
  "$(code | grep -vE '^src/accuracy/report/slide/cairo/' | xargs grep -nE '#include <cairo')"
complain "libarchive belongs to src/content/archive" \
  "$(code | grep -vE '^src/content/archive/' | xargs grep -nE '#include <archive')"
complain "Dear ImGui belongs to src/ui" "$(code | grep -vE '^src/ui/' | xargs grep -nE '#include <imgui|#include <backends/imgui')"
# src/app/grade/record.cpp opens the file that it locks.
complain "files are written by src/content/replace.cpp only, and by OpenImageIO beside their place: whole, or not at all" \
  "$(find parser src -name '*.h' -o -name '*.cpp' | grep -vE '^src/(content/(replace.cpp|oiio/oiio.cpp)|app/grade/record.cpp)$' |
     xargs grep -nE '\b(ofstream|fopen|freopen|mkstemp|creat)\b|\bO_(WRONLY|RDWR|CREAT)\b')"
complain "no shell is called" "$(find parser src -name '*.h' -o -name '*.cpp' | xargs grep -nE '\b(system|popen|execl|execlp|execle|wordexp)\(|/bin/sh')"
complain "the parser is the C++ standard library only, but for how doubles are read and written (parser/text/number.cpp)" \
  "$(find parser -name '*.h' -o -name '*.cpp' | grep -vxF parser/text/number.cpp |
     xargs grep -nE '#include <(fmt|fast_float|glm|nlohmann|filesystem|fstream|iostream)|#include "src/|\b(printf|fprintf|puts|fopen|exit|abort)\(')"
complain "doubles are read and written by parser/text/number.h, in every locale" \
  "$(find parser src -name '*.h' -o -name '*.cpp' | grep -vE '^(parser/text/number\.|src/app/(batch|commands|window)/)' |
     xargs grep -nE '\bstd::(to_chars|strto(d|f|ld)|sto(d|f|ld)|atof|sscanf)\(|#include <fast_float')"

complain "libc++ lacks std::ranges and std::bit_cast where the browser's program is built: parser/text/ranges.h, src/content/bits.h" \
  "$(find parser src -name '*.h' -o -name '*.cpp' | xargs grep -nE 'std::(ranges::|views::|bit_cast\b)|#include <ranges>')"

complain "the files of a scene are opened by src/content/regular_file.cpp, which a browser replaces" \
  "$(find parser src/content src/glsl src/plan src/lint src/gl src/runtime src/document -name '*.h' -o -name '*.cpp' |
     grep -vE '^src/content/(regular_file.cpp|replace.cpp|process.cpp|load_module.cpp|image/module.cpp|oiio/)' |
     xargs grep -nE '\bO_(PATH|RDONLY)\b|/proc/self|#include <(fcntl|unistd|sys/mman)')"
complain "libraries that a browser lacks have units of their own, which src/platform/web replaces or does without" \
  "$(find src -name '*.h' -o -name '*.cpp' | grep -vE '^src/(app/|platform/(headless|press_times|window)\.|content/(load_module|image/(png_write|module)|mesh/shp)\.)' |
     xargs grep -nE '#include <(png|zlib|shapefil|dlfcn)')"
complain "no #ifdef in what every platform builds" \
  "$(find parser src/content src/glsl src/plan src/lint src/gl src/runtime src/document -name '*.h' -o -name '*.cpp' |
     grep -vE '^src/content/(oiio|archive)/' | xargs grep -nE '^ *# *(if|ifdef|ifndef|elif|else)\b')"
complain "threads are started by src/content/workers.cpp, which a platform without any replaces, and by the program" \
  "$(find parser src -name '*.h' -o -name '*.cpp' | grep -vE '^src/(content/workers.cpp|app/)' |
     xargs grep -nE 'std::(j?thread|async)\b|#include <(thread|future|stop_token)>')"

# folder: the folders that it may include
allow() {
  local folder=$1 pattern=$2
  complain "$folder includes more than it may" \
    "$(find "$folder" -name '*.h' -o -name '*.cpp' | xargs grep -nE '#include "(parser|src|shaders|tools|tests)/' |
       grep -vE "#include \"($pattern)/")"
}
allow src/content 'parser|src/content'
allow src/glsl 'parser|src/glsl'
allow tests/oracle/optics 'tests/oracle/optics'
allow src/plan 'parser|shaders|src/content|src/glsl|src/plan'
allow src/lint 'parser|src/content|src/glsl|src/plan|src/lint'
allow src/language 'parser|src/content|src/glsl|src/plan|src/lint|src/language'
allow src/server 'parser|src/content|src/plan|src/lint|src/language|src/server'
allow src/gl 'src/gl'
allow src/runtime 'parser|shaders|src/content|src/glsl|src/plan|src/gl|src/runtime'
allow src/document 'parser|src/content|src/glsl|src/plan|src/gl|src/runtime|src/document'
allow src/accuracy 'parser|src/content|src/glsl|src/plan|src/lint|src/gl|src/runtime|src/document|src/accuracy'
allow src/platform 'src/gl|src/platform|src/content'
allow src/ui 'parser|src/content|src/glsl|src/plan|src/gl|src/runtime|src/platform|src/ui'

complain "the program must not link OpenImageIO: it costs start-up" "$(ldd "$bin/snell" | grep -i openimageio)"
complain "the program must not link GLFW: it costs start-up" "$(ldd "$bin/snell" | grep -iE 'libglfw|libX11')"
complain "the program must not link Cairo: it costs start-up" "$(ldd "$bin/snell" | grep -i cairo)"
complain "the program must not link libarchive or tomlplusplus: they cost start-up" "$(ldd "$bin/snell" | grep -iE 'libarchive|tomlplusplus')"
complain "no target, namespace or header is called glib" "$(code | grep -iE '/glib\.' ; code | xargs grep -nE 'namespace glib')"
exit $failed
