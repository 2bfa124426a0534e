// What submissions are graded by: a text that a lecturer writes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"

namespace snell::app {

// A picture of a scene: which values it has, when it is, and from where it is seen.
struct Shown {
    std::vector<std::string> sets;  // such as "uKd=0"
    double time = 0;                // in seconds
    std::string view;
    bool operator==(const Shown&) const = default;
    std::string label() const;
};

struct NeededUniform {
    std::string name, type;             // type: as GLSL writes it; "": any
    std::optional<double> least, most;  // the slider reaches at least from the one to the other
};

struct Bounds {
    std::string counter;
    std::optional<double> least, most;
};

enum class Expect { darker, brighter, different, same, mirrored, reference, finite };

// One row of the rubric.
struct RubricItem {
    enum class Kind { no_errors, no_lints, uniforms, needs, forbids, picture, counters, time, named, except, either };
    std::string name;
    double points = 1;
    bool deducts = false;  // these points are lost if it fails, and not won otherwise
    Kind kind = Kind::no_errors;
    std::vector<std::string> names;  // codes of lints, commands, or patterns of names
    std::optional<double> each;      // points that each lint costs; nullopt: all
    std::vector<NeededUniform> uniforms;
    std::vector<Bounds> counters;
    double ratio = 1;  // of the reference's time
    Expect expect = Expect::reference;
    std::size_t picture = 0, than = 0;                     // indices into Rubric::pictures; than: of the reference's
    std::size_t map = 0;                                   // of the differences from the reference: Record::maps
    double by = 0;                                         // threshold of the relation, a share
    std::optional<double> max_rmse, max_flip, max_pixels;  // the last in per cent
    std::vector<RubricItem> either;                        // one of these is enough; they have its points

    // Itself, or what it is one of.
    std::vector<const RubricItem*> parts() const;
    bool judges(Kind what) const;
    double most() const { return deducts ? 0 : points; }
    // Of the points that are at stake, those that are left.
    double left(double judged) const { return deducts ? points + judged : judged; }
};

struct Rubric {
    std::string path;  // its own
    std::string title;
    std::string reference;                       // path of the lecturer's scene
    std::string scene;                           // pattern of the name of the submissions' scenes; "": see find_scene
    std::vector<std::string> shared, templates;  // paths
    int width = 320, height = 320, samples = 1;
    double timeout = 10;  // in seconds, for reading a scene and for a picture
    std::map<std::string, std::vector<std::string>> aliases;
    std::map<std::string, std::string> scenes;  // by name of the submission: which of its scenes is meant
    std::vector<RubricItem> items;
    std::size_t maps = 0;
    std::vector<Shown> pictures;  // the first one has the scene's own values
    std::string text;

    double points() const;
    bool judges(RubricItem::Kind kind) const;
};

// Reports mistakes at their places. Paths in the rubric are relative to its folder.
std::optional<Rubric> read_rubric(const std::string& path, Sources& sources, Diagnostics& diagnostics);

// Why a file or folder cannot be read as a whole: it "is not there", or it holds more than 20,000 entries or 2 GB; or
// "".
std::string unusable(const std::string& path);

// The words of a relation in rubrics, in the order of Expect.
const std::vector<std::string_view>& expect_names();

}  // namespace snell::app
