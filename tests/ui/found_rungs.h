// Made-up results of a search for rungs, as full as scenes make them.
#pragma once

#include <string>

#include "src/ui/panels/found.h"

namespace snell::ui {

inline FoundFacts many_found_rungs(const std::string& long_name, const std::string& long_path) {
    using Group = FoundRow::Group;
    FoundFacts facts;
    facts.shown = "3";
    facts.asked = facts.older = true;
    facts.progress = .4;
    facts.doing = "trying 12 of 80 changes: " + long_name;
    const auto add = [&](Group group, const std::string& name, const std::string& kind,
                         const std::string& file) -> FoundRow& {
        return facts.rows.emplace_back(FoundRow{.group = group,
                                                .name = name,
                                                .kind = kind,
                                                .meaning = "a loop goes round less often",
                                                .where = file + ":1234",
                                                .place = {file, 1234, 5},
                                                .before = "i < 8",
                                                .after = "i < 4"});
    };
    for (int i = 1; i <= 40; ++i) {
        FoundRow& row = add(Group::cheaper, std::to_string(i), "fewer-rounds", i == 2 ? long_path : "glass.frag");
        row.error = row.of_display = .00123 * i;
        row.flip = .000456 * i;
        row.ratio = .123 + .1 * i;
        row.low = row.ratio - .02;
        row.high = row.ratio + .03;
        row.front = i < 5;
    }
    add(Group::cheaper, "3+12+25+38", "fewer-rounds, polynomial, fewer-texels", "glass.frag").ratio = .25;
    FoundRow& lacks = add(Group::better, "51", "unit-length", "glass.vert");
    lacks.error = .0123;
    lacks.ratio = 1.02;
    lacks.before = long_name + " * gl_Normal";
    lacks.after = "normalize(" + long_name + " * gl_Normal)";
    FoundRow& unseen = add(Group::unused, "77", "no-draw", "room.glib");
    unseen.bytes = 4100;
    unseen.loading = 286;
    return facts;
}

// The search has ended, some changes were refused, and the text is another one now.
inline FoundFacts untried_rungs(const std::string& long_name, const std::string& long_path) {
    FoundFacts facts = many_found_rungs(long_name, long_path);
    facts.progress.reset();
    facts.shown.clear();
    facts.older = false;
    facts.stale = true;
    facts.remark = "The time was up before every change was tried.";
    facts.rows.resize(3);
    for (const char* name : {"90", "91"}) {
        FoundRow& row = facts.rows.emplace_back(facts.rows.front());
        row.group = FoundRow::Group::untried;
        row.name = name;
        row.error = row.flip = {};
        row.ratio = 0;
        row.front = false;
        row.remark = "'" + long_name + "' undeclared [shader-error]";
    }
    return facts;
}

}  // namespace snell::ui
