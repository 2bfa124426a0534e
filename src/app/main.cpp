#include <cstdio>
#include <cstdlib>

#include "src/app/help/program.h"

int main(int argc, char** argv) {
    const int status = snell::app::run(argc, argv);
#ifndef SNELL_SANITIZED  // sanitizers look for leaks and races when the process ends as usual
    // What drivers and compilers would free at the end takes a twentieth of the time of a small picture.
    std::fflush(nullptr);
    std::quick_exit(status);
#endif
    return status;
}
