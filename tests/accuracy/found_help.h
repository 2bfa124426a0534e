// Changes that are found in scenes on disk or from text.
#pragma once

#include "parser/read/parse.h"
#include "src/accuracy/found/texts/texts.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::accuracy {

inline constexpr std::string_view vertex = "void main() { gl_Position = ftransform(); }\n";

using Finder = void (*)(const Reading&, std::vector<Change>&);

// A scene as read, and the changes found in it.
struct Found {
    std::unique_ptr<Files> files;
    Sources sources;
    Diagnostics diagnostics;
    Plan plan;
    std::vector<Change> changes;

    // "kind: after" of each change of the kind, in order.
    std::vector<std::string> after(ChangeKind kind) const;
    // The text of a file with the n-th change of the kind; empty if there is none, or it leaves the file as it is.
    std::string text(ChangeKind kind, std::size_t n, std::string_view file) const;
    const Change* at(ChangeKind kind, std::size_t n = 0) const;
};

// `instead`: texts that are read instead of files.
Found found_in(const std::string& path, Finder finder,
               std::shared_ptr<const std::map<std::string, std::string>> instead = nullptr);

struct NamedText {
    std::string_view name, text;
};
// "scene.glib" is added from `scene`; all files are in one folder.
Found found_in_text(const Scratch& folder, std::string_view scene, const std::vector<NamedText>& others, Finder finder);

// All scenes of scenes/, tests/cases, tests/bad and tests/odd.
std::vector<std::string> all_scenes();

// Every change of every scene has an effect, is made of edits of the author's texts that do not overlap, differs from
// the others, and leads to a text with no more errors.
void expect_sound(Finder finder);

}  // namespace snell::accuracy
