// The steps of a search. Each is a task; a task may put others ahead of those that wait.
#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/accuracy/found/climb.h"
#include "src/accuracy/found/search.h"
#include "src/accuracy/found/trial.h"
#include "src/accuracy/rounds.h"

namespace snell::accuracy {

// When each part of the search must end, as parts of its time: what is left over goes to the next.
inline constexpr double singles_end = .42, combinations_end = .52, held_out_end = .62, times_end = .86,
                        unused_end = .94;

inline constexpr std::size_t few_finalists = 4;  // that are timed, if possible, whatever else there is no time for

// A rung that is drawn, a place in each step.
struct Attempt {
    Trial trial;
    std::size_t rung = 0;  // index into FoundResult::rungs
    std::size_t to = 0;    // places
    // Then `then` is called, with FoundRung::at as far as it got.
    std::function<void(Attempt&)> then;
};

struct Search::Impl {
    Impl(const Original& scene, std::vector<Change> changes, const gl::Caps& caps, const BenchSettings& how,
         SearchOptions wanted);

    // ---- search.cpp: the order of things, pictures, combinations and places that are held out -------------------
    void plan();
    bool step();
    bool advance();
    void soon(std::function<void()> task) { tasks.push_front(std::move(task)); }
    double spent() const;
    double left(double part) const { return part * options.seconds - spent(); }
    bool stopped();
    bool over(double part) { return stopped() || left(part) <= 0; }
    void say(std::string_view what, double done);
    const char* out_of_time() const { return result.interrupted ? "the search was stopped" : "the time was up"; }
    bool skipped(FoundRung& rung, double part);
    FoundRung& rung_of(const Attempt& attempt) { return result.rungs[attempt.rung]; }

    void open();
    void give_up(const std::string& reason);
    bool is_broken(std::size_t place);
    void small() { trials->resize(result.search_width, result.search_height); }
    void whole() { trials->resize(settings.width, settings.height); }
    void try_places(Trial trial, std::size_t rung, std::size_t to, std::function<void(Attempt&)> then);
    void draw_on(const std::shared_ptr<Attempt>& attempt);
    void draw_next(Attempt& attempt);
    void try_rung(std::size_t i, double part, std::function<void()> then);
    bool useful(const FoundRung& rung) const;
    void begin_combinations();
    void combine();
    void begin_hold_out();
    void hold_out(std::size_t i);
    void find_flip(Trial& trial, FoundRung& rung, std::size_t place);

    // ---- timing.cpp: times, and what may be left out -------------------------------------------------------------
    void begin_times();
    std::size_t fitting(std::size_t most, double part, std::array<int, 2>& size);
    void begin_rounds(SweepResult& sweep, const std::vector<std::size_t>& of, double part, std::array<int, 2> size);
    void start_rounds(SweepResult& sweep, const std::vector<std::size_t>& of, double part, std::array<int, 2> size);
    void end_rounds();
    void omission(std::size_t i);
    bool is_set(const Change& change) const;
    void omitted(Attempt& attempt);
    void load(std::size_t i, std::vector<Loading> with, std::vector<Loading> without);
    void begin_costs();

    Original original;
    SearchOptions options;
    BenchSettings settings;
    FoundResult result;
    std::optional<Trials> trials;
    std::optional<Climbs> climbs;
    std::map<std::size_t, Trial> kept, finalists;  // by index into result.rungs
    std::optional<Rounds> rounds;
    SweepResult* timing = nullptr;
    ClockKind clock = ClockKind::wall;
    std::string_view doing = "opening the scene";
    std::deque<std::function<void()>> tasks;
    double before = 0;  // seconds of the steps before this one
    std::chrono::steady_clock::time_point entered;
};

inline double rmse_of(const FoundRung& rung) { return rung.worst()->own.light.rmse; }
inline double flip_of(const FoundRung& rung) { return rung.flip().value_or(1); }

}  // namespace snell::accuracy
