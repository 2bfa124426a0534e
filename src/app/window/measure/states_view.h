// The two states of the scene that the window shows side by side. It does nothing until somebody asks.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "src/app/open/states.h"
#include "src/document/document.h"
#include "src/ui/panels/accuracy.h"

namespace snell {

class StatesView {
public:
    // The GL context of `caps` must be current during the object's whole life.
    explicit StatesView(const gl::Caps& caps) : caps_(caps) {}

    // Call it before a picture is drawn: makes the documents of the states that memory.left and memory.right name, and
    // gives them the values that they have now. `revision` is that of the session. A half whose state can't be made any
    // more, as after a broken edit, keeps the one that it has, also while one picture is shown, until the files, which
    // are `stale`, are without errors.
    void follow(Document& scene, const Earlier& earlier, std::uint64_t revision, bool stale,
                const ui::AccuracyMemory& memory);
    // A snapshot was stored.
    void reread_snapshots();

    // The documents of the halves: that of the scene where the state is what it is now.
    Document& left(Document& scene) { return active_ ? of(halves_[0], scene) : scene; }
    Document& right(Document& scene) { return active_ ? of(halves_[1], scene) : scene; }
    // Whether there is a picture of that half: there is none of a state that could never be made. left() and right()
    // are the scene's document then.
    bool shows(bool right) const { return !active_ || halves_[right ? 1 : 0].shows(); }
    // What that half is called.
    std::string text(bool right) const;
    bool active() const { return active_; }
    // True if the right half is the reference and the left one the scene: what Refinement compares by itself.
    bool with_reference() const;
    // Another number for each pair of states that is shown; 0 if none is.
    std::uint64_t showing() const { return active_ ? showings_ : 0; }

    // What is said of them. `snapshots`: which of them there are. `stale`: why the scene's own picture is of an earlier
    // text; empty if it is not. `found`: a found rung, which is compared with the scene in place of the states. Valid
    // until the next call.
    const ui::StateFacts* facts(Document& scene, const Earlier& earlier, const std::array<bool, 10>& snapshots,
                                const std::string& stale, const std::string& found);

private:
    struct Half {
        std::string name;
        std::uint64_t revision = 0;  // of the session when the document was made
        NamedState state;
        Setup setup;                         // of a state that is not made of a name
        bool fixed = false;                  // it does not follow the scene's values
        std::unique_ptr<Document> document;  // null: the scene's own
        std::string error;                   // why there is no document, or only an earlier one

        bool shows() const { return document || error.empty(); }
    };
    static Document& of(Half& half, Document& scene) { return half.document ? *half.document : scene; }
    Half made(const std::string& name, Document& scene, const Earlier& earlier) const;
    // Returns why a value does not fit, or "".
    static std::string set_values(Half& half, Document& scene);
    // The files whose texts differ between the halves, as far as they are of another time.
    void compare_texts(Document& scene);

    gl::Caps caps_;
    bool active_ = false;
    std::array<Half, 2> halves_;
    std::uint64_t showings_ = 0;
    std::pair<std::uint64_t, std::uint64_t> compared_;  // the revision and the showing
    std::vector<std::string> other_texts_;              // see compare_texts()
    ui::StateFacts facts_;
};

}  // namespace snell
