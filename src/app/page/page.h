// One scene as one file that every browser opens: the page that `./dev web` builds, filled, with all that the scene
// reads.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/plan/files.h"
#include "src/platform/headless.h"

namespace snell::app {

// A scene as a page opens it: by WebGL 2, which is OpenGL ES 3.0.

// What the page begins with, as the command line says it.
struct Start {
    std::vector<std::string> sets, ladders;
    std::string quality, view;
};

// Both contexts of a command, made when they are first needed.
class PageContexts {
public:
    // Each makes its context current and returns its capabilities, or nullopt after it printed why there is none. What
    // was made in the one must be destroyed before the other is asked for.
    std::optional<gl::Caps> web();
    std::optional<gl::Caps> native();

private:
    std::unique_ptr<HeadlessContext> web_, native_;
};

// A context of OpenGL ES 3.0 at best, whatever more the driver has.
gl::Caps web_caps(gl::Caps caps);

struct OpenedScene {
    std::unique_ptr<Document> document;  // null without graphics; with values, rungs and view of the start
    View view;
    std::string text;         // all errors and warnings
    std::string first_error;  // the message of the first one; "" if there is none
    bool fits = false;        // there are no errors
};
OpenedScene opened_scene(const std::string& scene, const Start& start, const gl::Caps& caps, const Access& access);

// The diagnostic in one line, without the folder, whose name would tell of the author's machine.
std::string short_text(const Diagnostic& diagnostic, const Sources& sources);

// Values, rungs and view that differ from the scene's own, as Engine::open of web/page/engine.ts takes them.
struct StartTexts {
    std::vector<std::string> values, rungs;
    std::string view;
};
StartTexts start_texts(const Document& document, const View& view);

// One scene as one file that every browser opens.

struct PageOptions {
    std::string scene, output;
    Start start;
    std::string title;  // "": the name of the scene's file
    std::string link;   // where the text is; "": nowhere
    Access access;
    bool grade = false;
    double timeout = 20;  // in seconds, for reading the scene
};

// Writes the page, or prints why there is none.
Exit make_page(const PageOptions& options);

// The texts of one page, for a folder of pages, too.
struct PageParts {
    std::string title, scene, archive;                       // as in PageData
    std::vector<std::pair<std::string, std::size_t>> files;  // names and sizes of what the page carries
    std::string error;
};
// Of a scene that fits.
PageParts page_parts(const std::string& scene, const std::string& title, const std::string& link,
                     const OpenedScene& opened, const Access& access);

// Errors at statements that a page cannot carry out.
Diagnostics unfit_statements(const Document& document);

// Warnings about rungs that a browser cannot draw, each tried alone; "" if there are none. Compiles programs.
std::string unfit_rungs(Document& document);

// "1.5 MB".
std::string size_text(std::uintmax_t bytes);

// Fills the page that `./dev web` builds.

// Finds a file of the browser's part: in the folder $SNELL_WEB, in ../share/snell/web of the program's folder, or in
// build/web of the tree that the program was built in. Returns an empty string and sets `error` if it is not there.
std::string web_file(const std::string& name, std::string& error);

// JSON that may stand in a script element.
std::string script_json(const nlohmann::ordered_json& json);

struct PageData {
    std::string title;
    std::string scene;    // script_json()
    std::string archive;  // base64
};

// Returns nullopt if the template has not exactly one place for each of them.
std::optional<std::string> filled_page(std::string_view page, const PageData& data);
// True for a page that shares its runtime with others, as those of a gallery do.
bool is_gallery_page(std::string_view page);

// Packs the files of a scene into a text that a page carries.

struct PackedFile {
    std::string name;  // relative, with '/'
    std::string bytes;
    bool decoded = false;  // `bytes` are content::decoded_file() of the file of this name, which stands before it
};

// The limits of a page's archive. The page itself holds to the same ones.
inline constexpr std::size_t most_page_files = 10'000;
inline constexpr std::uint64_t most_page_bytes = std::uint64_t{512} << 20;  // of all files together

// One line of JSON with the names and sizes, then the bytes of all files. Of plain BMP images it has `rows`, and of
// each byte of their pixels what its neighbours do not foretell.
std::string archive(std::span<const PackedFile> files);

// The same bytes give the same text: no time and no name is in it.
std::string gzipped(std::string_view bytes);

// Everything that a scene reads, as a page carries it.

struct SceneFiles {
    std::string scene;  // the name of the scene among the files
    std::vector<PackedFile> files;
    std::string error;  // "", or why the scene cannot be in a page
};

// Reads the scene and all files that it names, whatever its rungs and values are. Images of formats that pages do not
// decode are there twice: as they are, and decoded.
SceneFiles scene_files(const std::string& scene, const Access& access);

}  // namespace snell::app
