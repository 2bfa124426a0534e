// Programs of a scene that are told apart, and found again in another text of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "parser/scene.h"

namespace snell {

// What tells programs of one name apart.
struct ProgramId {
    std::string name;
    std::string files;  // of its stages
    std::string line;   // what else its statement has
    bool gone = false;  // the scene does not have it any more
    bool operator==(const ProgramId&) const = default;
};
std::vector<ProgramId> program_ids(const Scene& scene);

// The number of programs before it that have its name.
std::size_t earlier_of_name(const Scene& scene, Index program);
// "Glass", or "Glass#2" for the second program of that name, as in `--set`.
std::string program_name(const Scene& scene, Index program);
std::vector<std::string> program_names(const std::vector<ProgramId>& programs);

// For each program of `from`, which one of `to` it has become, or none. Of one name, those whose files and line are the
// same are found first, then those with the same files, then the others, each time in their order, and only where `to`
// has as many: otherwise nobody knows which is which. Of what is left, one that several have become is the first of
// these. What was gone comes back only as it was.
std::vector<Index> carried_programs(const std::vector<ProgramId>& from, const std::vector<ProgramId>& to);

}  // namespace snell
