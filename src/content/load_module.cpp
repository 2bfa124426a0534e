#include "src/content/load_module.h"

#include <dlfcn.h>

#include <filesystem>

namespace snell::content {

namespace {

struct Places {
    std::filesystem::path beside, installed;
};

Places places_of(const std::string& file) {
    std::error_code error;
    const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    return {folder / file, folder.parent_path() / "lib" / "snell" / file};
}

}  // namespace

std::string module_path(const std::string& file) {
    const auto [beside, installed] = places_of(file);
    std::error_code error;
    return (std::filesystem::exists(beside, error) ? beside : installed).string();
}

LoadedModule load_module(const std::string& file, const std::string& library) {
    LoadedModule result;
    result.path = module_path(file);
    std::error_code error;
    if (!std::filesystem::exists(result.path, error)) {
        const auto [beside, installed] = places_of(file);
        result.error = "cannot find the " + library + " module at " + beside.string() + " or " + installed.string();
        return result;
    }
    result.handle = dlopen(result.path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!result.handle) result.error = "cannot load the " + library + " module: " + dlerror();
    return result;
}

void* LoadedModule::symbol(const char* name) const { return dlsym(handle, name); }

}  // namespace snell::content
