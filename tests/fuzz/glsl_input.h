// Any bytes as the stages of a program: shared by the fuzzer and the replay of its corpus.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/glsl/glsl.h"

namespace snell::fuzz {

// The last byte chooses target and first stage; a zero byte in the text begins another stage.
inline void translate_bytes(std::string_view bytes) {
    if (bytes.empty()) return;
    constexpr glsl::Target targets[] = {{450, false, true}, {330, false, true}, {320, true, false}, {300, true, false}};
    glsl::Options options;
    options.target = targets[bytes.back() & 3];
    options.defines = {{"RUNG", "1"}};
    options.include = [](std::string_view, std::string_view name, bool) -> std::optional<glsl::IncludeText> {
        if (name == "self") return glsl::IncludeText{"self", "#include \"self\"\n"};
        return glsl::IncludeText{std::string(name), "float included(float x) { return x; }\n"};
    };
    Sources sources;
    Diagnostics diagnostics;
    std::vector<glsl::StageInput> stages;
    std::string text;
    int stage = static_cast<unsigned char>(bytes.back()) >> 2;
    for (std::size_t i = 0; i < bytes.size() && stages.size() < stage_count; ++i) {
        if (i + 1 < bytes.size() && bytes[i] != 0) {
            text += bytes[i];
            continue;
        }
        glsl::StageInput input;
        input.stage = static_cast<Stage>(stage++ % stage_count);
        input.file = sources.add("stage", text);
        stages.push_back(input);
        text.clear();
    }
    glsl::translate(stages, sources, options, diagnostics);
}

}  // namespace snell::fuzz
