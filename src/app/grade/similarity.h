// Pairs of submissions whose shaders are alike beyond what the handed-out files explain: fingerprints of sequences of
// tokens by winnowing (Schleimer, Wilkerson, Aiken, 2003). A hint for a person to look at.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "src/app/grade/record.h"

namespace snell::app {

// Adds the text and its fingerprints to the record. Names that are not GLSL's, numbers, blanks and comments do not
// matter.
void add_prints(Record& record, std::string name, std::string_view text);

struct AlikePair {
    std::size_t a = 0, b = 0;  // indices of records
    double share = 0;          // of the fingerprints of the shorter one, 0 to 1
    std::size_t common = 0;
    std::vector<std::uint64_t> hashes;  // in common, sorted
};
// The most alike pairs first; `known` are the fingerprints of what was handed out. Pairs with few fingerprints in
// common are left out.
std::vector<AlikePair> alike_pairs(const std::vector<const Record*>& records, const std::set<std::uint64_t>& known);

}  // namespace snell::app
