#include "src/accuracy/report/report.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/text_forms.h"

namespace snell::accuracy {

namespace {

using Json = nlohmann::ordered_json;

struct Measured {
    bool known = false;
    Interval ratio;        // relative to the current rung
    int cost = 0;          // -1: surely cheaper than that, 1: surely dearer
    std::string standing;  // empty if the measurement is not trusted
    // 1: on the front, -1: surely not.
    int front() const {
        return standing == "front"                                                      ? 1
               : standing.starts_with("dominated") || standing.starts_with("no saving") ? -1
                                                                                        : 0;
    }
};

struct OnMachine {
    std::size_t machine = 0;
    std::string scene;  // its path
    std::array<int, 2> size{};
    bool trusted = false;
    std::vector<std::string> order;  // the rungs
    std::map<std::string, Measured> costs;
};

using Key = std::pair<std::string, std::string>;  // scene and ladder

struct Machine {
    std::string name;
    std::map<Key, OnMachine> ladders;
};

char letter(std::size_t machine) { return static_cast<char>('A' + machine % 26); }

// Reports come from anywhere, and their names go to the terminal.
std::string text_of(const Json& json) { return utf8::printable(json.get<std::string>()); }

std::string file_name(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

// Of too few rounds there is no interval.
Interval interval_of(const Json& json) {
    const Json &low = json.at("lo95"), &high = json.at("hi95");
    const double middle = json.at("median").get<double>();
    if (low.is_null() || high.is_null()) return {0, middle, std::numeric_limits<double>::infinity()};
    return {low.get<double>(), middle, high.get<double>()};
}

// `base`: what the ratio is to.
Measured cost_of(const Json& rung, const char* base) {
    if (!rung.contains(base) || rung[base].at("median").is_null()) return {};
    const std::string cost = rung.at("cost").get<std::string>();
    return {true, interval_of(rung[base]),
            cost == "cheaper"  ? -1
            : cost == "dearer" ? 1
                               : 0,
            text_of(rung.at("standing"))};
}

// What is the same on all machines, unlike the numbers of found rungs: "glass.frag:3:5: i < 8 → i < 4".
std::string changes_of(const Json& rung) {
    std::string text;
    for (const Json& change : rung.at("changes")) {
        const std::string before = text_of(change.at("before")), after = text_of(change.at("after"));
        text += fmt::format("{}{}: {} → {}", text.empty() ? "" : " + ", file_name(text_of(change.at("place"))),
                            before.empty() ? "(nothing)" : before, after.empty() ? "(nothing)" : after);
    }
    return text;
}

// Those of a ladder, or the cheaper found rungs that were timed.
OnMachine rungs_on(const Json& table, std::size_t index, std::array<int, 2> size, bool found) {
    OnMachine on{index, text_of(table.at("scene")), size, table.at("trusted").get<bool>(), {}, {}};
    for (const Json& rung : table.at("rungs")) {
        const Measured cost = cost_of(rung, found ? "ratio_to_scene" : "ratio_to_current");
        if (found && (!cost.known || text_of(rung.at("aim")) != "cheaper")) continue;
        on.order.push_back(found ? changes_of(rung) : text_of(rung.at("rung")));
        on.costs[on.order.back()] = cost;
    }
    return on;
}

Machine machine_of(const Json& json, const std::string& file, std::size_t index) {
    const Json &gl = json.at("gl"), &host = json.at("host");
    const auto size = json.at("scene").at("size").get<std::array<int, 2>>();
    Machine machine{fmt::format("{} ({}, {}, {} x {})", utf8::printable(file), text_of(gl.at("renderer")),
                                text_of(host.at("cpu")), size[0], size[1]),
                    {}};
    const auto add = [&](OnMachine on, const std::string& table) {
        Key key{on.scene, table};
        if (!on.order.empty()) machine.ladders[std::move(key)] = std::move(on);
    };
    for (const Json& ladder : json.at("ladders"))
        add(rungs_on(ladder, index, size, false), text_of(ladder.at("ladder")));
    for (const Json& found : json.value("found", Json::array()))
        add(rungs_on(found, index, found.at("timed_size").get<std::array<int, 2>>(), true), "found rungs");
    return machine;
}

// Returns nullopt and sets `error` if the text is not a report of this version.
std::optional<Machine> read_machine(const NamedReport& report, std::size_t index, std::string& error) {
    const Json json = content::parse_json(report.json);
    try {
        if (json.at("schema").get<int>() == report_schema) return machine_of(json, report.name, index);
        error = fmt::format("'{}' was written by another version of snell; measure again", report.name);
    } catch (const Json::exception&) {
        error = fmt::format("'{}' is not a report that 'snell accuracy --json' wrote", report.name);
    }
    return std::nullopt;
}

// The names of files that a single report has in several folders: only their paths tell these scenes apart.
std::set<std::string> ambiguous_names(const std::vector<Machine>& machines) {
    std::set<std::string> ambiguous;
    for (const Machine& machine : machines) {
        std::map<std::string, std::string> paths;  // by name
        for (const auto& [key, on] : machine.ladders)
            if (paths.try_emplace(file_name(on.scene), on.scene).first->second != on.scene)
                ambiguous.insert(file_name(on.scene));
    }
    return ambiguous;
}

// What can't be told contradicts nothing; opposite costs, or another front, do.
bool portable(const std::vector<const Measured*>& costs) {
    for (const Measured* a : costs)
        for (const Measured* b : costs)
            if (a->front() * b->front() < 0 || a->cost * b->cost < 0) return false;
    return true;
}

// Every rung that any machine has, in the order of the first one that has it.
std::vector<std::string> all_rungs(const std::vector<const OnMachine*>& on) {
    std::vector<std::string> rungs;
    for (const OnMachine* machine : on)
        for (const std::string& rung : machine->order)
            if (ranges::find(rungs, rung) == rungs.end()) rungs.push_back(rung);
    return rungs;
}

// What a reader must know before comparing these; `comparable` is false if the pictures differ in size.
std::string notes_text(const std::vector<const OnMachine*>& on, bool comparable) {
    std::vector<std::string> paths, sizes;
    bool one_path = true;
    for (const OnMachine* machine : on) {
        paths.push_back(fmt::format("{}: {}", letter(machine->machine), machine->scene));
        sizes.push_back(fmt::format("{}: {} x {}", letter(machine->machine), machine->size[0], machine->size[1]));
        one_path = one_path && machine->scene == on.front()->scene;
    }
    std::string text;
    if (!one_path) text += content::paragraph(fmt::format("matched by the file's name: {}", fmt::join(paths, ", ")), 2);
    if (!comparable) text += content::paragraph(fmt::format("not comparable: {}", fmt::join(sizes, ", ")), 2);
    return text;
}

std::string ladder_text(const std::vector<const OnMachine*>& on) {
    const std::vector<std::string> rungs = all_rungs(on);
    const bool comparable =
        ranges::all_of(on, [&](const OnMachine* machine) { return machine->size == on.front()->size; });
    std::string text = notes_text(on, comparable);
    using content::CellKind;
    content::Table table{{{"rung", CellKind::words},
                          {"on", CellKind::words},
                          {"relative to current", CellKind::number},
                          {"standing", CellKind::words},
                          {"remarks", CellKind::words}},
                         {}};
    for (const std::string& rung : rungs) {
        const std::size_t first = table.rows.size();
        std::vector<const Measured*> trusted;
        for (const OnMachine* machine : on) {
            const auto found = machine->costs.find(rung);
            const bool known = found != machine->costs.end() && found->second.known;
            table.rows.push_back({{table.rows.size() == first ? rung : "", std::string(1, letter(machine->machine)),
                                   known ? ratio_text(found->second.ratio) : "-",
                                   !known             ? "not measured"
                                   : machine->trusted ? found->second.standing
                                                      : "not trusted",
                                   ""}});
            if (known && machine->trusted && (found->second.cost != 0 || found->second.front() != 0))
                trusted.push_back(&found->second);
        }
        table.rows[first].cells.back() = trusted.size() < 2 || !comparable ? "can't say"
                                         : portable(trusted)               ? ""
                                                                           : "not portable";
    }
    return text + content::table_text(table.without_empty());
}

}  // namespace

std::optional<std::string> merged_text(std::span<const NamedReport> reports, std::string& error) {
    std::vector<Machine> machines;
    for (const NamedReport& report : reports) {
        auto machine = read_machine(report, machines.size(), error);
        if (!machine) return std::nullopt;
        machines.push_back(std::move(*machine));
    }
    std::string text = "Costs relative to each scene's current rung\n";
    for (std::size_t i = 0; i < machines.size(); ++i)
        text += content::paragraph(fmt::format("{}: {}", letter(i), machines[i].name), 2);
    const std::set<std::string> ambiguous = ambiguous_names(machines);
    std::map<Key, std::vector<const OnMachine*>> ladders;
    for (const Machine& machine : machines)
        for (const auto& [key, on] : machine.ladders) {
            const std::string name = file_name(on.scene);
            ladders[{ambiguous.contains(name) ? on.scene : name, key.second}].push_back(&on);
        }
    bool any = false;
    for (const auto& [key, on] : ladders) {
        if (on.size() < 2) continue;
        any = true;
        text += "\n" + content::paragraph(key.first + ": " + key.second, 0) + ladder_text(on);
    }
    if (any) return text;
    error = "no ladder and no found rung is in more than one of these reports";
    if (!ambiguous.empty())
        error += fmt::format("; a report has several scenes named '{}', so these are matched by their paths",
                             fmt::join(ambiguous, "', '"));
    return std::nullopt;
}

}  // namespace snell::accuracy
