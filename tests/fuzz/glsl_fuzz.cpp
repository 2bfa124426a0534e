// Any bytes as the stages of a program: no crash, no hang.
// The first byte chooses stage and target; a zero byte in the text begins another stage.
#include <cstddef>
#include <cstdint>
#include <string>

#include "src/glsl/glsl.h"

using namespace snell;
using namespace snell::glsl;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    constexpr Target targets[] = {{450, false, true}, {330, false, true}, {320, true, false}, {300, true, false}};
    Options options;
    options.target = targets[data[0] & 3];
    options.defines = {{"RUNG", "1"}};
    options.include = [](std::string_view, std::string_view name, bool) -> std::optional<IncludeText> {
        if (name == "self") return IncludeText{"self", "#include \"self\"\n"};
        return IncludeText{std::string(name), "float included(float x) { return x; }\n"};
    };
    Sources sources;
    Diagnostics diagnostics;
    std::vector<StageInput> stages;
    std::string text;
    int stage = data[0] >> 2;
    for (std::size_t i = 1; i <= size; ++i) {
        if (i < size && data[i] != 0) {
            text += static_cast<char>(data[i]);
            continue;
        }
        StageInput input;
        input.stage = static_cast<Stage>(stage++ % stage_count);
        input.file = sources.add("stage", text);
        stages.push_back(input);
        text.clear();
        if (stages.size() == stage_count) break;
    }
    translate(stages, sources, options, diagnostics);
    return 0;
}
