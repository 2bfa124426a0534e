#include "src/plan/values/programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "parser/text/words.h"
#include "parser/text_of.h"

namespace snell {

namespace {

enum class By : std::uint8_t { all, files, name };

std::array<std::string_view, 3> key_of(const ProgramId& id, By by) {
    const std::string_view none;
    return {id.name, by == By::name ? none : id.files, by == By::all ? id.line : none};
}

// Finds programs by this, where both sides have as many; `more`: or the later side has more.
void carry(const std::vector<ProgramId>& from, const std::vector<ProgramId>& to, By by, bool more,
           std::vector<Index>& found) {
    struct Group {
        std::vector<Index> before, now;
    };
    std::vector<bool> taken(to.size());
    for (const Index index : found)
        if (index != none) taken[index] = true;
    std::map<std::array<std::string_view, 3>, Group> groups;
    for (Index i = 0; i < from.size(); ++i)
        if (found[i] == none && (by == By::all || !from[i].gone)) groups[key_of(from[i], by)].before.push_back(i);
    for (Index i = 0; i < to.size(); ++i)
        if (!taken[i]) groups[key_of(to[i], by)].now.push_back(i);
    for (const auto& [key, group] : groups) {
        const auto& [before, now] = group;
        if (before.size() != now.size() && !(more && before.size() < now.size())) continue;
        for (std::size_t i = 0; i < before.size(); ++i) found[before[i]] = now[i];
    }
}

}  // namespace

std::vector<ProgramId> program_ids(const Scene& scene) {
    std::vector<ProgramId> ids;
    for (const Program& program : scene.programs) {
        ProgramId& id = ids.emplace_back();
        id.name = program.name;
        for (std::size_t stage = 0; stage < program.stages.size(); ++stage)
            if (const auto& file = program.stages[stage])
                id.files += fmt::format("{}{} {}", id.files.empty() ? "" : " ", text_of::stage_command(stage),
                                        text_of::name(file->name));
        const auto add = [&](const std::string& text) { (id.line += id.line.empty() ? "" : " ") += text; };
        for (const std::string* form : {&program.geometry_input, &program.geometry_output})
            if (!form->empty()) add(*form);
        for (const UniformValue& uniform : program.uniforms) add(text_of::uniform(uniform));
        for (std::string* text : {&id.files, &id.line}) *text = utf8::printable(*text);
    }
    return ids;
}

std::size_t earlier_of_name(const Scene& scene, Index program) {
    const auto end = scene.programs.begin() + static_cast<std::ptrdiff_t>(program);
    return static_cast<std::size_t>(std::count_if(
        scene.programs.begin(), end, [&](const Program& other) { return other.name == scene.programs[program].name; }));
}

std::string program_name(const Scene& scene, Index program) {
    const std::string& name = scene.programs[program].name;
    const std::size_t before = earlier_of_name(scene, program);
    return before == 0 ? name : fmt::format("{}#{}", name, before + 1);
}

std::vector<std::string> program_names(const std::vector<ProgramId>& programs) {
    std::map<std::string_view, int> count;
    std::vector<std::string> names;
    for (const ProgramId& program : programs) {
        const int before = count[program.name]++;
        names.push_back(before == 0 ? program.name : fmt::format("{}#{}", program.name, before + 1));
    }
    return names;
}

std::vector<Index> carried_programs(const std::vector<ProgramId>& from, const std::vector<ProgramId>& to) {
    std::vector<Index> found(from.size(), none);
    for (const By by : {By::all, By::files, By::name}) carry(from, to, by, false, found);
    carry(from, to, By::all, true, found);
    return found;
}

}  // namespace snell
