#include "src/content/load_module.h"

#include <dlfcn.h>

#include <filesystem>

namespace snell::content {

LoadedModule load_module(const std::string& file, const std::string& library) {
    LoadedModule result;
    std::error_code error;
    const auto executable = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto beside = executable.parent_path() / file;
    const auto installed = executable.parent_path().parent_path() / "lib" / "snell" / file;
    result.path = (std::filesystem::exists(beside, error) ? beside : installed).string();
    if (!std::filesystem::exists(result.path, error)) {
        result.error = "cannot find the " + library + " module at " + beside.string() + " or " + installed.string();
        return result;
    }
    result.handle = dlopen(result.path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!result.handle) result.error = "cannot load the " + library + " module: " + dlerror();
    return result;
}

void* LoadedModule::symbol(const char* name) const { return dlsym(handle, name); }

}  // namespace snell::content
