// An open scene: its text, its diagnostics, and the runtime that draws it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/gl/caps.h"
#include "src/plan/files.h"
#include "src/plan/texts.h"
#include "src/plan/values/controls.h"
#include "src/runtime/runtime.h"

namespace snell {

struct Document {
    std::string path;
    std::unique_ptr<Files> files;
    Sources sources;
    Diagnostics diagnostics;         // from reading, planning, compiling and loading
    std::optional<Runtime> runtime;  // nullopt if the file could not be read
    Controls controls;

    const Scene& scene() const { return runtime->scene(); }
};

// Returns the files that the scene may read; only the scene itself is certain to be read if it has errors.
std::vector<std::string> files_read_by(const std::string& path, const Access& access);

// Returns `access`; with `grade`, confined to the scene's folder unless `access` sets a folder.
Access access_to(const std::string& path, Access access, bool grade);

// Changes the rungs that the programs are compiled for; `rungs` is initially as the scene's text marks them.
using RungChooser = std::function<void(const Scene& scene, Rungs& rungs)>;

// Called with the plan before it is compiled.
using PlanReader = std::function<void(const Plan& plan, Document& document)>;

// Opens a scene. Never throws; problems are in the document's `diagnostics`. Needs a current context.
std::unique_ptr<Document> open_document(const std::string& path, const gl::Caps& caps,
                                        const RungChooser& choose = nullptr, const PlanReader& planned = nullptr,
                                        const RuntimeOptions& options = {}, const Access& access = {});

// Compiles the programs for the rungs in `controls`, and makes the controls of the new programs, with the values that
// they had. Returns true if the controls may have changed.
bool follow_rungs(Document& document);

// True if every error of `now` is in `before` too, so that a scene that always had an unknown command still follows the
// edits of its shaders. Places are not compared.
bool no_new_errors(const Diagnostics& before, const Diagnostics& now);

// Lists what was read and made, line by line, for scenes with Verbose.
std::string verbose_report(const Document& document);

// Problems with files of textures that nothing samples, so that the picture does not depend on them.

// Turns the errors about such missing files into notes if the scene has no other errors and no ladders: a program that
// failed, or one of another rung, may sample them.
void excuse_unsampled(Document& document);

// Reads and decodes these files nevertheless; problems with them become warnings.
void check_unsampled(Document& document);

}  // namespace snell
