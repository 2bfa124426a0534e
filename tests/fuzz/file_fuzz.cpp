// One fuzzer for each kind of file: SNELL_FUZZ_CHECK is one of the functions of file_input.h.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/file_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    bool made = false;
    const std::string wrong = snell::fuzz::SNELL_FUZZ_CHECK({reinterpret_cast<const char*>(data), size}, made);
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
