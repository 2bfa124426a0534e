// Found rungs within the window: they are sought while nothing moves, and the picture of one is shown in place of the
// scene's. It does nothing until somebody asks.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "parser/text/source.h"
#include "src/accuracy/found/search.h"
#include "src/app/window/measure/accuracy_view.h"
#include "src/document/document.h"
#include "src/ui/panels/found.h"
#include "src/ui/panels/state.h"

namespace snell {

class FoundView {
public:
    // The GL context of `caps` must be current during the object's whole life.
    FoundView(std::string path, const gl::Caps& caps);
    ~FoundView();
    FoundView(FoundView&&) noexcept;
    FoundView& operator=(FoundView&&) noexcept;

    // Call it after each frame. `still`: nothing moves, by hand or by itself. Other values or another view stop the
    // search. Returns true if the panel must be shown again.
    bool follow(const Document& scene, bool stale, const Stand& stand, bool still, const ui::AccuracyMemory& memory);
    // Call it when the files were read again: what was found is of an older text, and none of it is shown any more.
    void leave();
    // True if step() has something to do.
    bool busy() const;
    // Tries one change, or times one round, which may take many frames: `alive` is called between them. Returns true:
    // there is something new to show.
    bool step(const std::function<void()>& alive);

    // Starts and stops the search, shows rungs and writes them. A closed panel stops and shows nothing. `stand` is that
    // of the picture in the window.
    void serve(const ui::Requests& requests, Document& scene, const Stand& stand, ui::Memory& memory);
    // The command that writes the rung that is shown.
    std::string command() const;
    // Valid until the next call.
    const ui::FoundFacts* facts() const { return &facts_; }

    // The document whose picture the window shows: that of the found rung, with the values of the scene, or the scene.
    Document& shown(Document& scene);
    Document* rung() const { return rung_.get(); }
    // Another number for each rung that is shown; 0: the scene is shown.
    std::uint64_t showing() const { return rung_ ? showings_ : 0; }

private:
    struct Sought;

    void begin(Document& scene, const Stand& stand);
    void end(const char* why);
    void show(const std::string& name, Document& scene, std::string& notice);
    void write(const Document& scene, ui::Memory& memory);
    std::map<std::string, std::string> texts(const std::string& name, std::string& error) const;

    std::string path_;
    gl::Caps caps_;
    std::unique_ptr<Sought> sought_;
    ui::FoundFacts facts_;
    std::unique_ptr<Document> rung_;
    std::uint64_t showings_ = 0;
};

// Found rungs as rows of the panel: by group, with the rungs of the front first. `searching`: what was not tried yet
// has no row. What may not be left out has none either, because it changes pixels as it should.
std::vector<ui::FoundRow> found_rows(const accuracy::FoundResult& result, const Sources& sources, bool searching);

}  // namespace snell
