#include "src/accuracy/report/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "src/accuracy/report/report.h"
#include "src/content/json.h"

namespace snell::accuracy {

namespace {

using Json = nlohmann::ordered_json;

struct Cost {
    bool known = false;
    Interval ratio;        // relative to the current rung
    std::string standing;  // empty if the measurement is not trusted
};

struct OnMachine {
    std::size_t machine = 0;
    bool trusted = false;
    std::vector<std::string> order;  // the rungs
    std::map<std::string, Cost> costs;
};

struct Machine {
    std::string name;
    std::map<std::pair<std::string, std::string>, OnMachine> ladders;  // by scene and ladder
};

Machine machine_of(const Json& json, const std::string& file, std::size_t index) {
    const Json &gl = json.at("gl"), &size = json.at("scene").at("size");
    Machine machine{
        fmt::format("{} ({}, {}, {} x {})", file, gl.at("renderer").get<std::string>(),
                    json.at("host").at("cpu").get<std::string>(), size.at(0).get<int>(), size.at(1).get<int>()),
        {}};
    for (const Json& ladder : json.at("ladders")) {
        OnMachine on{index, ladder.at("trusted").get<bool>(), {}, {}};
        for (const Json& rung : ladder.at("rungs")) {
            const auto name = rung.at("rung").get<std::string>();
            on.order.push_back(name);
            Cost& cost = on.costs[name];
            if (!rung.contains("ratio_to_current") || !rung["ratio_to_current"].at("median").is_number()) continue;
            const Json& ratio = rung["ratio_to_current"];
            cost = {true,
                    {ratio.at("lo95").get<double>(), ratio.at("median").get<double>(), ratio.at("hi95").get<double>()},
                    rung.at("standing").get<std::string>()};
        }
        machine.ladders[{ladder.at("scene").get<std::string>(), ladder.at("ladder").get<std::string>()}] =
            std::move(on);
    }
    return machine;
}

// The conclusions about one rung on one machine; equal ones agree.
std::pair<bool, int> conclusions(const Cost& cost) {
    return {cost.standing == "front", cost.ratio.high < 1 ? -1 : cost.ratio.low > 1 ? 1 : 0};
}

// Costs that can't be told from the current rung's contradict nothing; opposite ones, or another front, do.
bool portable(const std::vector<const Cost*>& costs) {
    for (const Cost* a : costs)
        for (const Cost* b : costs) {
            const auto [front_a, side_a] = conclusions(*a);
            const auto [front_b, side_b] = conclusions(*b);
            if (front_a != front_b || side_a * side_b < 0) return false;
        }
    return true;
}

std::string ladder_text(const std::vector<const OnMachine*>& on) {
    std::string text;
    std::size_t width = 8;
    for (const std::string& rung : on.front()->order) width = std::max(width, rung.size());
    for (const std::string& rung : on.front()->order) {
        text += fmt::format("  {:<{}}", rung, width);
        std::vector<const Cost*> trusted;
        for (const OnMachine* machine : on) {
            const auto found = machine->costs.find(rung);
            const bool known = found != machine->costs.end() && found->second.known;
            text += fmt::format("  {}: {:<20} {:<24}", static_cast<char>('A' + machine->machine % 26),
                                known ? ratio_text(found->second.ratio) : "-",
                                !known             ? "not measured"
                                : machine->trusted ? found->second.standing
                                                   : "not trusted");
            if (known && machine->trusted) trusted.push_back(&found->second);
        }
        text += trusted.size() < 2 ? "  can't say\n" : portable(trusted) ? "\n" : "  not portable\n";
    }
    return text;
}

}  // namespace

std::optional<std::string> merged_text(std::span<const NamedReport> reports, std::string& error) {
    std::vector<Machine> machines;
    for (const NamedReport& report : reports) try {
            machines.push_back(machine_of(content::parse_json(report.json), report.name, machines.size()));
        } catch (const Json::exception&) {
            error = fmt::format("'{}' is not a report that 'snell accuracy --json' wrote", report.name);
            return std::nullopt;
        }
    std::string text = "Costs relative to each scene's current rung\n";
    for (std::size_t i = 0; i < machines.size(); ++i)
        text += fmt::format("  {}: {}\n", static_cast<char>('A' + i % 26), machines[i].name);
    std::map<std::pair<std::string, std::string>, std::vector<const OnMachine*>> ladders;
    for (const Machine& machine : machines)
        for (const auto& [key, on] : machine.ladders) ladders[key].push_back(&on);
    bool any = false;
    for (const auto& [key, on] : ladders) {
        if (on.size() < 2) continue;
        any = true;
        text += fmt::format("\n{}: {}\n{}", key.first, key.second, ladder_text(on));
    }
    if (any) return text;
    error = "no ladder is in more than one of these reports";
    return std::nullopt;
}

}  // namespace snell::accuracy
