#include "tools/stability/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

namespace snell::stability {
namespace {

constexpr int cases = 70;

struct Group {
    const char* title;
    int first, last;
};
constexpr Group groups[] = {{"Optics", 1, 15},
                            {"Cube maps", 16, 22},
                            {"Matrices", 23, 34},
                            {"Meshes", 35, 42},
                            {"Values", 43, 48},
                            {"Time", 49, 54},
                            {"GPU, drivers, and what shaders meet", 55, cases}};

// "A8" comes after all plain numbers.
int order(const std::string& number) {
    const bool second = number.starts_with('A');
    return std::atoi(number.c_str() + (second ? 1 : 0)) + (second ? 1000 : 0);
}

// Two digits are what two runs, and two drivers of a kind, agree in.
std::string shown(double value) {
    if (std::isnan(value)) return "NaN";
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    if (value == std::round(value) && std::abs(value) < 1e6) return fmt::format("{:.0f}", value);
    std::string text = fmt::format("{:.2g}", value);
    if (const auto e = text.find('e'); e != std::string::npos)
        text = fmt::format("{}e{}", text.substr(0, e), std::atoi(text.c_str() + e + 1));
    return text;
}

std::string limit(const Record& r) {
    return r.tolerance == 0 ? "0 " + r.unit : fmt::format("≤ {} {}", shown(r.tolerance), r.unit);
}

std::string row(const Record& r) {
    return fmt::format("{} {} | {} | {} {}\n", row_begin(r), r.naive ? shown(*r.naive) : "–", shown(r.ours), r.context,
                       row_end(r));
}

// NaN is the worst.
double worse(double a, double b) { return std::isnan(a) || std::isnan(b) ? std::nan("") : std::max(a, b); }

std::vector<Record> merged(const std::vector<Record>& records) {
    std::map<std::tuple<int, std::string, std::string>, Record> rows;
    std::map<std::tuple<int, std::string, std::string>, std::set<std::string>> contexts;
    for (const Record& r : records) {
        const std::tuple key(order(r.number), r.test, r.what);
        contexts[key].insert(r.context);
        const auto [at, added] = rows.emplace(key, r);
        if (added) continue;
        at->second.ours = worse(at->second.ours, r.ours);
        if (r.naive) at->second.naive = at->second.naive ? worse(*at->second.naive, *r.naive) : *r.naive;
    }
    std::vector<Record> out;
    for (auto& [key, r] : rows) {
        // "GL 3.3", "GL 4.5", "ES 3.2": desktop first.
        std::vector<std::string> names(contexts[key].begin(), contexts[key].end());
        std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name[0] != 'E'; });
        r.context = fmt::format("{}", fmt::join(names, ", "));
        out.push_back(std::move(r));
    }
    return out;
}

constexpr const char* introduction =
    R"(<!-- Made by ./dev stability from what the tests measured. Do not edit. -->
# Stability

Inputs that break naive code, and what snell does with them. Every row is a test, and every number was measured by it:
*naive* is what the textbook's formula or the driver's own function gives (– where it gives nothing that could be
shown: it crashes, hangs, or loses something that has no size), *snell* is our result, the largest of all contexts
named. A test fails when ours leaves the tolerance, and when naive code stays within it. The shaders' results are
those of Mesa's llvmpipe, which gives a context of 4.5 where 3.3 is asked for: the tests then keep to GLSL 3.30 and to
what 3.3 has.

To make this page anew after adding a case: `./dev stability`. How a test declares a case: `tests/hard_case.h`.
)";

constexpr const char* head =
    "\n| no. | case | naive | snell | where | tolerance | test |\n|---|---|---|---|---|---|---|\n";

}  // namespace

std::string to_line(const Record& r) {
    return fmt::format("{}\t{}\t{}\t{}\t{}\t{:.9g}\t{:.9g}\t{}", r.number, r.what, r.unit, r.test, r.context,
                       r.tolerance, r.ours, r.naive ? fmt::format("{:.9g}", *r.naive) : "-");
}

std::optional<Record> from_line(const std::string& line) {
    std::vector<std::string> fields;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find('\t', at), line.size());
        fields.push_back(line.substr(at, end - at));
        at = end + 1;
    }
    if (fields.size() != 8) return std::nullopt;
    const auto number = [&](std::size_t i) { return std::strtod(fields[i].c_str(), nullptr); };
    Record r{fields[0], fields[1], fields[2], fields[3], fields[4], number(5), number(6), std::nullopt};
    if (fields[7] != "-") r.naive = number(7);
    return r;
}

std::string row_begin(const Record& r) { return fmt::format("| {} | {} |", r.number, r.what); }

std::string row_end(const Record& r) { return fmt::format("| {} | `{}` |", limit(r), r.test); }

std::string page(std::vector<Record> records) {
    records = merged(records);
    std::string text = introduction;
    const auto table = [&](int first, int last) {
        text += head;
        for (const Record& r : records)
            if (order(r.number) >= first && order(r.number) <= last) text += row(r);
    };
    for (const Group& group : groups) {
        text += fmt::format("\n## {}\n", group.title);
        table(group.first, group.last);
    }
    text += "\n## More cases\n";
    table(1000, 2000);
    return text;
}

std::vector<int> missing(const std::vector<Record>& records) {
    std::vector<int> out;
    for (int n = 1; n <= cases; ++n)
        if (std::none_of(records.begin(), records.end(), [&](const Record& r) { return order(r.number) == n; }))
            out.push_back(n);
    return out;
}

}  // namespace snell::stability
