// Judges one submission, in a process of its own.
#pragma once

#include <string>

#include "parser/text/limits.h"
#include "src/accuracy/difference.h"
#include "src/app/grade/record.h"
#include "src/app/grade/rubric/rubric.h"
#include "src/app/open/complain.h"

namespace snell::app {

struct ToJudge {
    const Rubric* rubric = nullptr;
    std::string key;
    std::string name;       // of the submission; "" for the reference
    std::string scene;      // the scene that is meant, as the rubric's [scenes] names it; "": it is looked for
    std::string path;       // the submission's folder, archive or scene: absolute
    std::string output;     // an existing folder, for record and pictures: absolute
    std::string unpacked;   // where archives are unpacked: absolute; made if it is needed
    std::string reference;  // the folder of the reference's record and pictures; "": there is none, or this is it
    double reference_milliseconds = 0;  // of the reference's frame
    Limits limits;
};

// Writes a record into `output`, more than once: what is known so far, as if judging ended there. Ends the process if
// a picture takes too long. Changes the working directory, so that messages name files as the submission does.
Exit judge(const ToJudge& work);

// Whether pictures are related as an item of a rubric expects.

// `other` is the picture with other values, or the reference's, of the same size. `covered`: the share of the pixels on
// which one of them draws something.
Judged judge_relation(const RubricItem& item, const accuracy::Picture& picture, const accuracy::Picture& other,
                      const accuracy::PictureDifference& difference, double covered);

}  // namespace snell::app
