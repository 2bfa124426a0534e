// Scenes and the changes that are found in their shaders.
#pragma once

#include "src/accuracy/found/change.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::accuracy::test {

struct File {
    std::string name, text;
};

// A scene that was read, without GL.
struct Found {
    explicit Found(const std::string& path);
    Found(const Found&) = delete;
    Found& operator=(const Found&) = delete;

    std::unique_ptr<Files> files;
    Sources sources;
    Diagnostics diagnostics;
    Plan plan;
    std::vector<Change> changes;

    std::vector<const Change*> of(ChangeKind kind) const;
    // "before → after" of each change of the kind.
    std::vector<std::string> lines(ChangeKind kind) const;
    // The text of a file, by the end of its path, with the change made.
    std::string changed(const Change& change, std::string_view file) const;
    // The first change of the kind whose excerpts contain the words; null if there is none.
    const Change* find(ChangeKind kind, std::string_view before, std::string_view after = "") const;
};

// `fragment` behind a vertex shader of vN (normal), vP (position) and vST, drawn by a sphere; `values` go on the
// Program line, `state` ahead of it.
class FoundShaders : public testing::Test {
protected:
    Found& shaders(std::string_view fragment, std::string_view values = "", std::string_view state = "",
                   const std::vector<File>& more = {});
    Found& scene(std::string_view text, const std::vector<File>& files);
    Scratch folder_;
    std::unique_ptr<Found> found_;
};

// The translator's errors for all programs of the scene with the changes made.
std::string translation_errors(const Found& found, const std::vector<const Change*>& changes);

}  // namespace snell::accuracy::test
