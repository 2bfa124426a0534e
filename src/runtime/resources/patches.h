// Tessellation where the context has none: vertex shaders stand for its stages (src/glsl/forms/tessellation.cpp), and
// the domain of each patch is divided here.
#pragma once

#include <memory>
#include <vector>

#include "src/content/mesh/tessellate.h"
#include "src/runtime/resources/stages.h"

namespace snell::runtime {

// What one draw divides. It is kept as long as nothing that it depends on changes.
class PatchDraw {
public:
    // As StageDraw::draw.
    void draw(LinkedProgram& program, const GpuMesh& mesh, std::size_t part, const Vec4& color, const Capturing& with);

private:
    // The divided domains of some of the patches.
    struct Piece {
        std::size_t first = 0, patches = 0;
        GpuMesh domain;                     // drawn by the evaluation stage,
        std::shared_ptr<StageMesh> stages;  // or read by what stands for a geometry stage
        StageDraw emitted;
    };
    struct Part {
        std::vector<double> depends;  // what the levels were made from
        double version = 0;           // of what the control stage gave
        gl::Buffer captured;
        gl::Texture patches;
        std::size_t rows = 0;  // of the texture
        std::vector<content::TessellationLevels> levels;
        std::vector<Piece> pieces;
        bool kept = true;
    };
    void make_room(Part& part, const glsl::EmulatedTessellation& form, int patches, GLenum unit, State& state);
    static void control(Part& part, LinkedProgram& program, int patches, GLuint none, const Capturing& with);
    static void divide(Part& part, const LinkedProgram& program, State& state);
    static void make(Piece& piece, const Part& part, const LinkedProgram& program, State& state);

    std::vector<std::unique_ptr<Part>> parts_;  // as StageMesh::parts
    gl::VertexArray none_;                      // of the control stage, which has no attributes
};

}  // namespace snell::runtime
