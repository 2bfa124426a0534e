#include <cstdint>

#include "tests/fuzz/glsl_input.h"

// No crash, no hang, no undefined behaviour.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    snell::fuzz::translate_bytes({reinterpret_cast<const char*>(data), size});
    return 0;
}
