// Judges items of a rubric by what a scene says and counts, without its pictures.
#pragma once

#include <map>
#include <string>

#include "src/app/grade/record.h"
#include "src/document/document.h"

namespace snell::app {

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

}  // namespace snell::app
