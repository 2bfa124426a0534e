// The members of the expression before a point, and the types of names.
#pragma once

#include <string>
#include <vector>

#include "src/language/names/texts.h"

namespace snell::language {

struct MemberOffer {
    std::string name, type;
    int rank = 1;
};
// `point`: the number of the token that is the point.
std::vector<MemberOffer> members_before(Texts& texts, FileId file, std::size_t point, Stage stage);

// The type of the variable or member that the token names, without dimensions; empty if it is not known.
std::string type_of_name(Texts& texts, FileId file, std::size_t token, Stage stage, int depth = 0);

}  // namespace snell::language
