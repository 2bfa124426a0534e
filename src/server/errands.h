// Commands that take their time, one after the other in the background.
#pragma once

#include "src/server/state.h"
#include "src/server/wire/background.h"

namespace snell::server {

class Errands {
public:
    explicit Errands(State& state) : state_(state) {}

    void go_on();
    int descriptor() const { return background_.descriptor(); }
    Background::Clock::time_point due() const {
        return background_.busy() ? background_.deadline() : Background::Clock::time_point::max();
    }

private:
    void report(const std::string& result);

    State& state_;
    Background background_;
};

}  // namespace snell::server
