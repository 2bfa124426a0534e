// Ctrl-C in long runs that keep what they have done.
#pragma once

namespace snell::app {

// While it exists, the first Ctrl-C is noted, and a second one ends the process.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    // Whether it came since the last one of these objects was made.
    static bool came();
    // Ends this process as Ctrl-C would have.
    [[noreturn]] static void end();

private:
    void (*before_)(int);
};

}  // namespace snell::app
