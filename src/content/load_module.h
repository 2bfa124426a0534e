// Modules of snell: libraries that would cost time at every start, opened when they are first needed.
#pragma once

#include <string>
#include <utility>

namespace snell::content {

struct LoadedModule {
    void* handle = nullptr;
    std::string path;
    std::string error;  // why it cannot be used; empty if it can

    // Looks up a function; returns false if the module does not have it.
    template <class Function>
    bool find(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(symbol(name));
        return function != nullptr;
    }

private:
    void* symbol(const char* name) const;
};

// Where the module is: in the executable's folder, otherwise in ../lib/snell, where it may be missing.
std::string module_path(const std::string& file);

// Opens the module at its path. `library` is its name in errors. The module
// stays open.
LoadedModule load_module(const std::string& file, const std::string& library);

// Opens it and finds its functions, by their names; `version` is what the function of the name `asked` must return.
// Returns "" or why it cannot be used.
template <class... Functions>
std::string open_functions(const std::string& file, const std::string& library, const char* asked, int version,
                           std::pair<const char*, Functions*>... functions) {
    const LoadedModule module = load_module(file, library);
    if (!module.error.empty()) return module.error;
    int (*made_for)() = nullptr;
    const bool fits = module.find(asked, made_for) && made_for() == version &&
                      (module.find(functions.first, *functions.second) && ...);
    return fits ? std::string() : module.path + " is from another version of snell";
}

}  // namespace snell::content
