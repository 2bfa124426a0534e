// One scene as one file that every browser opens.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/app/open/exit_status.h"
#include "src/app/page/baked.h"
#include "src/app/page/opened.h"

namespace snell::app {

struct PageOptions {
    std::string scene, output;
    Start start;
    std::string title;  // "": the name of the scene's file
    std::string link;   // where the text is; "": nowhere
    std::vector<std::string> baked;
    int steps = 0;
    std::optional<std::pair<int, int>> size;  // of baked pictures; nullopt: the scene's
    int samples = 4;
    bool lossless = false;
    double time = 0;
    std::string context;  // for baked pictures, as for `snell render`
    Access access;
    bool grade = false;
    double timeout = 20;  // in seconds, for reading the scene, and for a picture
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

}  // namespace snell::app
