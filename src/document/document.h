// An open scene: its text, its diagnostics, and the runtime that draws it.
// What saving the current values would write to the files of a scene.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/gl/context.h"
#include "src/plan/files.h"
#include "src/plan/texts.h"
#include "src/plan/values/animate.h"
#include "src/plan/values/controls.h"
#include "src/plan/values/write_back.h"
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

// Opens a scene that is open already with other texts and rungs, to be shown in its place or beside it; `texts` are
// those of Access::with. Null, with an error, if it has errors that the open one does not have.
std::unique_ptr<Document> open_beside(const Document& scene, const gl::Caps& caps, const RungChooser& choose,
                                      std::map<std::string, std::string> texts, std::string& error);
// Compiles what was read before once more, as for another context, with the values of `controls`.
std::unique_ptr<Document> compile_document(const std::string& path, const Plan& plan, const Sources& sources,
                                           const Controls& controls, const gl::Caps& caps, const Access& access,
                                           const RuntimeOptions& options = {});

// Compiles the programs for the rungs in `controls`, and makes the controls of the new programs, with the values that
// they had. Returns true if the controls may have changed.
bool follow_rungs(Document& document);

// True if every error of `now` is in `before` too, so that a scene that always had an unknown command still follows the
// edits of its shaders. Places are not compared.
bool no_new_errors(const Diagnostics& before, const Diagnostics& now);

// Null if there is no error.
const Diagnostic* first_error(const Diagnostics& diagnostics);
// The errors alone.
Diagnostics errors_of(const Diagnostics& diagnostics);

// Lists what was read and made, line by line, for scenes with Verbose.
std::string verbose_report(const Document& document);

// Problems with files of textures that nothing samples, so that the picture does not depend on them.

// Turns the errors about such missing files into notes if the scene has no other errors and no ladders: a program that
// failed, or one of another rung, may sample them.
void excuse_unsampled(Document& document);

// Reads and decodes these files nevertheless; problems with them become warnings.
void check_unsampled(Document& document);

// The new text of a file, and the text that it replaces.
struct SavedFile {
    std::string path, before, after;
};

struct Saved {
    std::vector<SavedFile> files;
    std::vector<Unwritten> unwritten;
    std::vector<std::string> moving;   // names of uniforms that move by themselves: they keep the scene's values
    std::vector<std::string> widened;  // ranges that reach to their new values: "uEta widened to 50"
    std::size_t values = 0;            // the number of values and rungs that are written
    std::string error;                 // why nothing can be written; `files` is then empty
};

// The number of uniforms and ladders that differ from the scene, without values that move by themselves.
std::size_t changed_values(const Document& document, std::span<const Animated> moving = {});

// Computes what saving the document's controls would write; writes nothing. The result has an error if a file changed
// since the document was read, or if the new texts would not read back correctly.
Saved saved_values(const Document& document, std::span<const Animated> moving = {});

// The scene with its current values, under another name.
struct SavedAs {
    SavedFile file;                        // `before` is empty
    bool exists = false;                   // a file of that name would be replaced
    std::string error;                     // why the scene can't have that name
    std::vector<std::string> moving = {};  // as in Saved
    bool missing = false;                  // the only error: its folder does not exist
    bool lacks = false;                    // the only error: from its folder the scene would not find its files
    std::map<std::string, std::string> texts = {};  // of the files that have values, as saved, for a copy of all files
};
// Computes it, whatever has become of the scene's own file; writes nothing. `name` is relative to the scene's folder.
// Refuses folders from which the scene's files would not be found, and values that belong to another file, which the
// scene includes.
SavedAs saved_as(const Document& document, const std::string& name, std::span<const Animated> moving = {});

}  // namespace snell
