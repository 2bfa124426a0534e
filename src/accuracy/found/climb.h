// Which combinations of changes are tried, and which rungs are worth more time. No GL.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "src/accuracy/found/search.h"

namespace snell::accuracy {

// Adds one change after the other while the error of the picture stays below a limit. Each climb has another limit, or
// another order: by error first, then by time, then as a generator with that seed shuffles.
class Climbs {
public:
    struct Single {
        std::size_t change = 0;
        double error = 0;  // mean FLIP
        double ratio = 1;  // of its time to the scene's
    };
    // `singles` are those that save time.
    Climbs(std::vector<Single> singles, std::span<const Change> changes, std::uint64_t seed);

    // The next combination whose error is wanted, of at least two changes, ascending; nullopt: there is none left.
    std::optional<std::vector<std::size_t>> next();
    // What next() added a change to.
    const std::vector<std::size_t>& before() const { return chosen_; }
    // Tells the error of the last one; infinite: it is of no use.
    void tell(double error);

private:
    struct Climb {
        double limit = 0;
        std::vector<Single> order;
    };
    bool fits(std::size_t change) const;

    std::span<const Change> changes_;
    std::vector<Climb> climbs_;
    std::size_t climb_ = 0, step_ = 0;
    std::vector<std::size_t> chosen_;
    std::vector<std::pair<std::vector<std::size_t>, double>> known_;
};

// At most so many of these rungs, which save time: first those that save at least 5 % of the quick time of whatever is
// more exact, then those that only these surpass, and so on. Those whose error is plain to see only if there is little
// else.
std::vector<std::size_t> in_layers(const FoundResult& found, std::vector<std::size_t> rungs, std::size_t most);
// At most so many of these, evenly spaced.
std::vector<std::size_t> spread(const std::vector<std::size_t>& all, std::size_t most);

}  // namespace snell::accuracy
