// Saves pictures and pages of the window's scene, while the window stays responsive.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/app/open/command_text.h"
#include "src/app/picture/picture.h"
#include "src/content/process.h"
#include "src/document/document.h"
#include "src/platform/window.h"
#include "src/ui/panels/state.h"

namespace snell {

// Draws the pictures part by part.
class PictureSaver {
public:
    // The GL context of `caps` must be current during the object's whole life.
    PictureSaver(gl::Caps caps, Limits limits) : caps_(std::move(caps)), limits_(limits) {}

    // Executes requests of the picture window; `shown` is what the window shows now.
    void serve(const ui::Requests& requests, const Document& document, const Picture& shown, Window& window,
               ui::Memory& memory);
    bool busy() const { return work_ != nullptr; }
    // Draws the next part; call it while busy() is true. Gives up if `document` was read again: `revision` is its
    // current revision.
    void step(Document* document, std::uint64_t revision, ui::Memory& memory);

private:
    // A copy of everything the pictures depend on, so that changes in the window do not affect them.
    struct Work {
        const Document* document = nullptr;
        std::uint64_t revision = 0;
        std::vector<std::string> files;
        std::size_t done = 0;
        double from = 0, rate = 25;
        View view;
        Controls controls;
        std::vector<Animated> animated;
        app::PictureSize size;
        app::Tiling tiling;
        bool transparent = false;
        std::unique_ptr<app::Painting> painting;
    };

    void fill(const Document& document, const Picture& shown, ui::PictureMemory& picture);
    static void name(const Document& document, ui::PictureMemory& picture);
    std::string begin(const Document& document, const Picture& shown, ui::Memory& memory);
    void end(ui::Memory& memory, const std::string& error);

    gl::Caps caps_;
    Limits limits_;
    std::unique_ptr<Work> work_;
    std::uint64_t revision_ = 0;
};

// Makes pages by `snell web` in a process of its own, because a browser's OpenGL needs another context than the window.

// The name of a page's file: with .html at the end unless it ends with .html or .htm.
std::string page_file(const std::string& name);

class PageMaker {
public:
    bool busy() const { return process_.running(); }
    // Starts it for page_file(page), with these arguments after those of the page. Returns "" or the error: a file is
    // replaced only if it is named in full.
    std::string start(const std::string& page, const std::vector<std::string>& arguments);
    // Call it regularly while busy(). Returns what the status line says once the process has ended, otherwise "".
    std::string look();

private:
    content::Process process_;  // ends with the object; a page that was there stays as it was
    std::string page_;
};

}  // namespace snell
