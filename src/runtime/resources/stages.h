// Geometry stages where the context has none: vertex shaders stand for them (src/glsl/forms/geometry.cpp), and
// transform feedback captures what they emit.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "src/content/mesh/tessellate.h"
#include "src/gl/target.h"
#include "src/runtime/resources/counters.h"
#include "src/runtime/resources/mesh.h"
#include "src/runtime/resources/program.h"

namespace snell::runtime {

// The vertices of each primitive of so many indices, in the order in which a stage behind the vertex stage gets them.
std::vector<std::uint32_t> corners_of(Topology topology, std::span<const std::uint32_t> indices,
                                      std::size_t patch_vertices = 3);

// A mesh as these shaders read it.
struct StageMesh {
    struct Part {
        int first = 0, count = 0;  // primitives
    };
    gl::Texture vertices, primitives;
    std::vector<Part> parts;  // as GpuMesh::parts; the last one is the whole mesh
    std::size_t bytes = 0;

    // For one of the programs that read it.
    void bind(const LinkedProgram& program, int first_unit, const Part& of, bool has_color, State& state) const;
};
// Null if a texture of at most so many rows cannot hold it.
std::shared_ptr<StageMesh> stage_mesh(const content::Mesh& mesh, int most_rows);

// Shows the uniforms of LinkedProgram::parts in the program itself, and gives the samplers of all three their units:
// one that several of them read has the same unit in each.
void join_parts(LinkedProgram& linked);
// Links one of the parts.
gl::Linked link_capturing(const gl::Shader& shader, const std::vector<std::string>& written, const gl::Caps& caps);

// What captures need, and change.
struct Capturing {
    State& state;
    gl::AnySamples* samples;  // a query that is active, or null: it does not see captures
    Counters& counters;
};
// Writes what so many runs of the program in use output.
void capture(GLuint into, GLint first, GLsizei runs, gl::AnySamples* samples);
// All numbers that decide what one of the parts writes, unless it reads textures.
std::vector<double> what_decides(const LinkedProgram& part, const Vec4& color);
bool reads_textures(const LinkedProgram& part);

// What one draw emits. Counts are kept as long as nothing that they depend on changes.
class StageDraw {
public:
    // Draws that part of the mesh. All uniforms and textures of the programs are set. `version`: of what the vertex
    // stage reads besides.
    void draw(LinkedProgram& program, const StageMesh& mesh, std::size_t part, bool has_color, const Vec4& color,
              double version, const Capturing& with);

private:
    // As much as one buffer holds; the rest waits for its turn.
    struct Piece {
        std::size_t first_slot = 0, slots = 0, first_element = 0, elements = 0;
    };
    struct Emitted {
        std::vector<double> depends;  // what the counts were made from
        std::vector<Piece> pieces;
        gl::Buffer slots, elements;
        gl::VertexArray slots_array, array;
    };
    void count(Emitted& emitted, const glsl::EmulatedGeometry& form, const LinkedProgram& counting,
               const StageMesh::Part& of, const Capturing& with);
    void list(Emitted& emitted, const glsl::EmulatedGeometry& form, std::span<const std::uint32_t> counts,
              State& state);
    void arrange(Emitted& emitted, const glsl::EmulatedGeometry& form, std::size_t slots, State& state);

    std::vector<std::unique_ptr<Emitted>> parts_;  // as StageMesh::parts
    gl::Buffer captured_;
    std::size_t captured_bytes_ = 0;
    gl::VertexArray none_;  // of the counting, which has no attributes
};

// Tessellation where the context has none: vertex shaders stand for its stages (src/glsl/forms/tessellation.cpp), and
// the domain of each patch is divided here.

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
