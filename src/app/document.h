// A scene that is open: everything from its text to the runtime that draws it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "parser/source.h"
#include "src/gl/caps.h"
#include "src/plan/controls.h"
#include "src/plan/files.h"
#include "src/runtime/runtime.h"

namespace snell {

struct Document {
    std::string path;
    std::unique_ptr<Files> files;
    Sources sources;
    Diagnostics diagnostics;         // of reading, planning, compiling, loading
    std::optional<Runtime> runtime;  // none: the file could not be read
    Controls controls;

    const Scene& scene() const { return runtime->scene(); }
};

// The reading alone, for what needs no graphics. Nothing when the file can't be read.
struct ParsedDocument {
    FileId file = 0;
    Scene scene;
};
std::optional<ParsedDocument> parse_document(const std::string& path, Files& files, Sources& sources,
                                             Diagnostics& diagnostics);

// `access`, confined to the scene's folder where it says nothing and `grade` is asked for.
Access access_to(const std::string& path, Access access, bool grade);

// The folder that names in the scene are relative to.
std::string scene_folder(const std::string& path);

// Changes the rungs that the programs are compiled for from those that the scene's text marks.
using RungChooser = std::function<void(const Scene& scene, Rungs& rungs)>;

// Is shown the plan before it is compiled.
using PlanReader = std::function<void(const Plan& plan, Document& document)>;

// Never throws; what is wrong is in `diagnostics`. Needs a current context.
std::unique_ptr<Document> open_document(const std::string& path, const gl::Caps& caps,
                                        const RungChooser& choose = nullptr, const PlanReader& planned = nullptr,
                                        const RuntimeOptions& options = {}, const Access& access = {});

// Compiles what the rungs of `controls` need; the controls are then those of the programs as they are now, with
// the values they had. True: they may be others.
bool follow_rungs(Document& document);

// What was read and made of it, line by line, for scenes that say Verbose.
std::string verbose_report(const Document& document);

}  // namespace snell
