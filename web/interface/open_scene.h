// The scene that the page shows. It is read again after every edit; once it was shown, there is always a picture.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/plan/setup.h"
#include "src/plan/view.h"

namespace snell::web {

// What takes effect before the first picture.
struct Settings {
    std::vector<std::string> values, rungs;  // such as "Glass.uEta=1.3" and "FRESNEL=exact"
    std::vector<std::string> ranges;         // such as "Glass.uEta=1,5"
    std::optional<std::string> view;         // such as "rotate_x=30"
    bool fresh = false;                      // values that were set before are forgotten
    bool lints = true;
};

// Images beyond what the browser draws, or has the memory for, are refused at their places.
Access page_access(const gl::Caps& caps);

// What a reading of the scene found.
struct Reading {
    bool shown = false;  // false: what was shown before is shown still
    std::unique_ptr<Document> refused;
    Diagnostics settings;  // what of the settings does not fit
};

class OpenScene {
public:
    Reading open(const std::string& path, const Settings& settings, const gl::Caps& caps);
    // Makes the programs and controls of the rungs that the controls have. Returns the problems of these programs.
    const Diagnostics& follow_rungs();
    // Makes everything again in another context, from the texts that are shown.
    void restore(const gl::Caps& caps);
    // Gives up all objects of OpenGL, as far as there are any.
    void release();

    // Null until a scene could be read.
    Document* document() { return shown_.get(); }
    const Document* document() const { return shown_.get(); }
    // The same scene with the reference rung of every ladder, and the current values. Null if there is nothing to
    // compare.
    Document* reference(const gl::Caps& caps);
    View view;
    // Counts what was shown, because a document may stand where an earlier one stood.
    int readings() const { return readings_; }

private:
    void take(std::unique_ptr<Document> read, Plan plan, const Settings& settings, bool again, Diagnostics& problems);
    std::unique_ptr<Document> compiled(const Plan& plan, const gl::Caps& caps, const Runtime* previous) const;
    Remembered remembered() const;

    std::unique_ptr<Document> shown_, reference_;
    int readings_ = 0;
    Plan plan_;          // of shown_
    Remembered memory_;  // values that shown_ does not have at present
};

}  // namespace snell::web
