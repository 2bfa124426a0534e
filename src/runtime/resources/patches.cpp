#include "src/runtime/resources/stages.h"

#include <cmath>
#include <map>

#include "parser/text/ranges.h"
#include "src/content/mesh/tree.h"
#include "src/gl/driver.h"

namespace snell::runtime {

namespace {

using content::TessellationLevels;

constexpr std::size_t texel_bytes = 16;
// Vertices of one piece. What has more of them than `most_kept` is divided again for each frame.
constexpr std::size_t most_vertices = 1 << 19, most_kept = 1 << 21;

content::Tessellator tessellator_of(const glsl::EmulatedTessellation& form) {
    using content::Domain;
    using content::Spacing;
    return {form.domain == "quads"      ? Domain::quads
            : form.domain == "isolines" ? Domain::isolines
                                        : Domain::triangles,
            form.spacing == "fractional_even_spacing"  ? Spacing::fractional_even
            : form.spacing == "fractional_odd_spacing" ? Spacing::fractional_odd
                                                       : Spacing::equal,
            form.clockwise, form.points};
}

Topology topology_of(const content::Tessellator& tessellator) {
    const int corners = content::corners_of(tessellator);
    return corners == 1 ? Topology::points : corners == 2 ? Topology::lines : Topology::triangles;
}

// The first texels of each patch. What is not a number discards a patch as 0 does, and can be compared.
std::vector<TessellationLevels> levels_of(const std::vector<float>& texels, std::size_t patches, std::size_t stride) {
    std::vector<TessellationLevels> levels(patches);
    const auto number = [](float level) { return std::isnan(level) ? 0 : level; };
    for (std::size_t i = 0; i < patches; ++i) {
        const float* from = texels.data() + i * stride;
        for (std::size_t k = 0; k < 4; ++k) levels[i].outer[k] = number(from[k]);
        for (std::size_t k = 0; k < 2; ++k) levels[i].inner[k] = number(from[4 + k]);
    }
    return levels;
}

}  // namespace

void PatchDraw::draw(LinkedProgram& program, const GpuMesh& mesh, std::size_t part, const Vec4& color,
                     const Capturing& with) {
    const StageMesh& stages = *mesh.stages;
    const StageMesh::Part& of = stages.parts[part];
    if (of.count == 0) return;
    State& state = with.state;
    if (parts_.size() < stages.parts.size()) parts_.resize(stages.parts.size());
    if (!parts_[part]) parts_[part] = std::make_unique<Part>();
    Part& made = *parts_[part];
    LinkedProgram& first = *program.parts.front();
    state.color(color);
    std::vector<double> depends = what_decides(first, color);
    if (reads_textures(first) || !made.captured || made.depends != depends) {
        make_room(made, *program.tessellation, of.count, static_cast<GLenum>(program.stage_unit + 2), state);
        stages.bind(first, program.stage_unit, of, mesh.has_color, state);
        control(made, program, of.count, none_.get(), with);
        made.depends = std::move(depends);
    }
    for (Piece& piece : made.pieces) {
        if (!made.kept) make(piece, made, program, state);
        state.texture(program.stage_unit + 2, GL_TEXTURE_2D, made.patches.get(), 0);
        if (program.geometry) {
            piece.emitted.draw(program, *piece.stages, 0, false, color, made.version, with);
        } else if (piece.domain.count > 0) {
            state.program(program.program.get());
            state.vertex_array(piece.domain.array.get());
            draw_elements(facts_of(piece.domain.topology).mode, piece.domain, 0, piece.domain.count);
        }
        if (!made.kept) piece = {piece.first, piece.patches, {}, {}, {}};
    }
}

// For what the control stage gives.
void PatchDraw::make_room(Part& part, const glsl::EmulatedTessellation& form, int patches, GLenum unit, State& state) {
    if (!none_) none_ = gl::VertexArray(gl::make(glGenVertexArrays));
    const auto texels = static_cast<std::size_t>(patches * form.runs * form.slots);
    const std::size_t rows = (texels + content::tree_row - 1) / content::tree_row;
    if (rows == part.rows) return;
    glActiveTexture(GL_TEXTURE0 + unit);  // the scene's textures are bound already
    part.rows = rows;
    part.captured = gl::Buffer(gl::make(glGenBuffers));
    glBindBuffer(GL_ARRAY_BUFFER, part.captured.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(rows * content::tree_row * texel_bytes), nullptr,
                 GL_DYNAMIC_COPY);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    part.patches = gl::make_words(static_cast<int>(content::tree_row), static_cast<int>(rows));
    state.forget();
}

// Captures what the control stage gives, makes a texture of it, and divides the patches if their levels have changed.
void PatchDraw::control(Part& part, LinkedProgram& program, int patches, GLuint none, const Capturing& with) {
    const glsl::EmulatedTessellation& form = *program.tessellation;
    const auto count = static_cast<std::size_t>(patches), runs = count * static_cast<std::size_t>(form.runs);
    State& state = with.state;
    state.program(program.parts.front()->program.get());
    state.vertex_array(none);
    capture(part.captured.get(), 0, static_cast<GLsizei>(runs), with.samples);

    const auto stride = static_cast<std::size_t>(form.runs * form.slots) * 4;
    std::vector<float> texels(count * stride);
    glBindBuffer(GL_ARRAY_BUFFER, part.captured.get());
    gl::read_buffer(GL_ARRAY_BUFFER, texels.size() * sizeof(float), texels.data());
    ++with.counters.stage_reads;
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    state.texture(program.stage_unit + 2, GL_TEXTURE_2D, part.patches.get(), 0);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(program.stage_unit + 2));
    gl::fill_words(part.captured.get(), static_cast<int>(content::tree_row), static_cast<int>(part.rows));
    ++part.version;
    std::vector<TessellationLevels> levels = levels_of(texels, count, stride);
    if (levels == part.levels && !part.pieces.empty()) return;
    part.levels = std::move(levels);
    divide(part, program, state);
}

// Distributes the patches among pieces, and makes these unless they are too large to be kept.
void PatchDraw::divide(Part& part, const LinkedProgram& program, State& state) {
    const content::Tessellator how = tessellator_of(*program.tessellation);
    std::map<TessellationLevels, std::size_t> known;
    part.pieces.clear();
    part.pieces.emplace_back();
    std::size_t all = 0, within = 0;
    for (std::size_t i = 0; i < part.levels.size(); ++i) {
        const auto [size, fresh] = known.try_emplace(part.levels[i], 0);
        if (fresh) size->second = content::divide(how, part.levels[i]).vertices.size();
        if (within + size->second > most_vertices && within > 0) {
            part.pieces.push_back({i, 0, {}, {}, {}});
            within = 0;
        }
        ++part.pieces.back().patches;
        within += size->second;
        all += size->second;
    }
    part.kept = all <= most_kept;
    for (Piece& piece : part.pieces)
        if (part.kept) make(piece, part, program, state);
}

void PatchDraw::make(Piece& piece, const Part& part, const LinkedProgram& program, State& state) {
    const content::Tessellator how = tessellator_of(*program.tessellation);
    std::map<TessellationLevels, content::DividedDomain> known;
    content::Mesh mesh;
    mesh.topology = topology_of(how);
    for (std::size_t i = piece.first; i < piece.first + piece.patches; ++i) {
        const auto [domain, fresh] = known.try_emplace(part.levels[i]);
        if (fresh) domain->second = content::divide(how, part.levels[i]);
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        for (const auto& [u, v] : domain->second.vertices) mesh.positions.push_back({u, v, static_cast<float>(i)});
        for (const std::uint32_t index : domain->second.indices) mesh.indices.push_back(base + index);
    }
    if (program.geometry)
        piece.stages = stage_mesh(mesh, 1 << 16);
    else
        piece.domain = upload(mesh);
    state.forget();
}

}  // namespace snell::runtime
