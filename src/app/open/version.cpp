#include "src/app/open/version.h"

namespace snell {

const char* version() { return SNELL_VERSION; }

}  // namespace snell
