// The end of a process for want of memory.
#pragma once

#include <cstddef>

namespace snell::app {

// Makes the process end by out_of_memory() where an allocation fails, and where the driver or one of its libraries ends
// it by a signal while hardly any address space is left: they do not survive that.
void watch_memory();

// Returns true if the limit of address space (`ulimit -v`) leaves less than that. The default is what drivers take at
// once: stacks of threads, and code that LLVM compiles; to be loaded they need more.
bool short_of_memory(std::size_t bytes = std::size_t{64} << 20);
constexpr std::size_t whole_driver = std::size_t{400} << 20;

// Says so, and ends the process on whatever thread this happens, because exceptions would have to pass through drivers
// and libraries. No file is left incomplete: files are written whole or not at all.
[[noreturn]] void out_of_memory();

}  // namespace snell::app
