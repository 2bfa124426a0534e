// Whether pictures are related as an item of a rubric expects.
#pragma once

#include "src/accuracy/difference.h"
#include "src/app/grade/record.h"

namespace snell::app {

// `other` is the picture with other values, or the reference's, of the same size. `covered`: the share of the pixels on
// which one of them draws something.
Judged judge_relation(const RubricItem& item, const accuracy::Picture& picture, const accuracy::Picture& other,
                      const accuracy::PictureDifference& difference, double covered);

}  // namespace snell::app
