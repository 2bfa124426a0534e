// Many draws of one mesh by one call: what differs between them, their matrices, stands in a uniform block.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "src/gl/handle.h"
#include "src/glsl/glsl.h"

namespace snell::runtime {

struct DrawContext;
struct LinkedProgram;

// A matrix of each instance, as std140 lays it out: columns of four floats.
struct InstanceMatrix {
    glsl::System system;
    int columns = 4;  // 3 or 4
};

// The form of a program that draws many instances.
struct Instancing {
    std::shared_ptr<LinkedProgram> program;
    std::vector<InstanceMatrix> matrices;
    std::size_t capacity = 0;  // instances of one call
};

// The vertex shader with `capacity` of each matrix, chosen by gl_InstanceID. Empty: the program can't be drawn so, as
// it has other stages, reads matrices elsewhere or under names of its own, or counts instances itself.
struct InstancedText {
    std::string text;
    std::vector<InstanceMatrix> matrices;
    std::size_t capacity = 0;
};
InstancedText instanced_text(const glsl::Translation& translation, std::size_t block_bytes);

// The block's content, of one context for each instance.
void instance_values(const Instancing& instancing, const std::vector<DrawContext>& contexts,
                     std::vector<float>& values);

}  // namespace snell::runtime
