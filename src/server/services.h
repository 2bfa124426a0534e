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

// What takes longer than an editor waits: it is done in a process of its own, with the texts that are open.
struct Errand {
    enum class Kind : std::uint8_t { render, cost };
    Kind kind = Kind::render;
    std::string scene;
    int line = -1;  // from 0, of the statement whose cost is wanted; -1: of the whole scene
};
struct Outcome {
    std::string file;     // a picture to show; may be empty
    std::string message;  // a sentence, or what is wrong
    bool failed = false;
};

// A window that was opened, and outlives the server. Returns nothing while it is open, and afterwards why it failed, or
// "" if it did not.
using Window = std::function<std::optional<std::string>()>;

struct Services {
    // Returns the errors and warnings of a scene.
    using Checker = std::function<Checked(const std::string& scene, const Access& access)>;
    // A checker that asks the driver too; null if there is none. It is called in a process of its own.
    std::function<Checker()> driver = nullptr;
    // Called in a process of its own.
    std::function<Outcome(const Errand& errand, const Access& access)> run = nullptr;
    // Opens the scene in snell's window, with the texts of `access` in place of files until those are saved.
    std::function<Window(const std::string& scene, const Access& access)> open = nullptr;
    // The URI of the page that explains a diagnostic's code; empty if it is not installed.
    std::function<std::string(std::string_view code)> page_of = nullptr;
    // The path of a file in docs/, such as "images/light-glass.jpg"; empty if it is not installed.
    std::function<std::string(std::string_view name)> doc_file = nullptr;
    std::string version;
};

}  // namespace snell::server
