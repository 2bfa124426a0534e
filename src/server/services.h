// What the server is given by the program around it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/plan/files.h"

namespace snell::server {

struct Checked {
    Sources sources;
    Diagnostics diagnostics;
};

struct Services {
    // Returns the errors and warnings of a scene.
    using Checker = std::function<Checked(const std::string& scene, const Access& access)>;
    // A checker that asks the driver too; null if there is none. It is called in a process of its own.
    std::function<Checker()> driver = nullptr;
    // The URI of the page that explains a diagnostic's code; empty if it is not installed.
    std::function<std::string(std::string_view code)> page_of = nullptr;
    // The path of a file in docs/, such as "images/light-glass.jpg"; empty if it is not installed.
    std::function<std::string(std::string_view name)> doc_file = nullptr;
    std::string version;
};

}  // namespace snell::server
