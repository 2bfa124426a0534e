#include "src/app/open/loss.h"

#include <filesystem>

#include "src/gl/health.h"

namespace snell::app {

bool LossWatch::lost() {
    std::error_code error;
    if (!file_.empty() && std::filesystem::remove(file_, error)) return true;
    if (left_ == 0) return gl::lost();
    if (left_ == 1) return true;
    --left_;
    return false;
}

}  // namespace snell::app
