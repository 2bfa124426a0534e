// Judges one submission, in a process of its own.
#pragma once

#include <map>
#include <string>

#include "parser/text/limits.h"
#include "src/accuracy/metrics.h"
#include "src/app/grade/record.h"
#include "src/app/grade/rubric/rubric.h"
#include "src/app/open/complain.h"
#include "src/document/document.h"

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

// Judges items of a rubric by what a scene says and counts, without its pictures.

// The commands that the scene and the scenes that it includes use, by their own names, and where each is first used.
using UsedCommands = std::map<std::string, std::string>;
UsedCommands used_commands(const std::string& scene, const Access& access);

// Judges an item of the kinds no_errors, no_lints, uniforms, needs and forbids.
Judged judge_text(const RubricItem& item, const Rubric& rubric, const Document& document, const UsedCommands& commands);
Judged judge_counters(const RubricItem& item, const Counters& counters);

// The uniforms that the rubric's items name, and that the scene's text sets.
std::set<std::string> uniforms_of(const Scene& scene, const Rubric& rubric);

// The type of a uniform, as GLSL writes it; "" if no shader uses it.
std::string type_of(const Document& document, const snell::Control& control);

// The assignment with the names that the scene has in place of the rubric's, where the rubric lists them as aliases.
std::string with_aliases(const std::string& assignment, const Rubric& rubric, const Document& document);

// Sliders that change nothing, found by the driver's code of the programs.

// Adds a warning for each such slider of a scene without errors; takes about so many seconds.
void add_idle_sliders(Document& document, double seconds);

// Whether pictures are related as an item of a rubric expects.

// `other` is the picture with other values, or the reference's, of the same size. `covered`: the share of the pixels on
// which one of them draws something.
Judged judge_relation(const RubricItem& item, const accuracy::Picture& picture, const accuracy::Picture& other,
                      const accuracy::PictureDifference& difference, double covered);

}  // namespace snell::app
