// Submissions whose shaders are alike beyond what the handed-out files explain: fingerprints of sequences of tokens by
// winnowing (Schleimer, Wilkerson, Aiken, 2003). A hint for a person to look at.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "src/app/grade/record.h"

namespace snell::app {

// Adds the text and its fingerprints to the record. Names that are not GLSL's, numbers, blanks and comments do not
// matter.
void add_prints(Record& record, std::string name, std::string_view text);

struct Alike {
    std::vector<std::size_t> who;       // indices of records: a pair, or all that are equal
    double share = 0;                   // of the fingerprints of the shortest one, 0 to 1
    std::vector<std::uint64_t> hashes;  // in common, sorted
};
// All groups of equal records, the largest first, then the pairs that are most alike in parts. `known` are the
// fingerprints of what was handed out. Few fingerprints in common are not told. Parts that a third of the class has are
// taken for handed out, too, but never whole submissions.
std::vector<Alike> alike_records(const std::vector<const Record*>& records, const std::set<std::uint64_t>& known);

}  // namespace snell::app
