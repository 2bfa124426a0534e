#include "src/runtime/resources/mesh.h"

#include <cmath>
#include <limits>

#include "parser/text/ranges.h"
#include "src/glsl/glsl.h"

namespace snell::runtime {

namespace {

using glsl::Attribute;

struct Stream {
    Attribute attribute;
    int components;
    const float* data;
    size_t floats;
};

// Returns the positions with their w.
std::vector<float> homogeneous(const content::Mesh& mesh) {
    std::vector<float> positions;
    positions.reserve(mesh.positions.size() * 4);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        positions.insert(positions.end(), mesh.positions[i].begin(), mesh.positions[i].end());
        positions.push_back(mesh.w[i]);
    }
    return positions;
}

template <typename Vector>
void add(std::vector<Stream>& streams, Attribute attribute, const std::vector<Vector>& values) {
    if (!values.empty())
        streams.push_back({attribute, static_cast<int>(std::tuple_size_v<Vector>), values.front().data(),
                           values.size() * std::tuple_size_v<Vector>});
}

// One after another into the buffer that is bound. Returns how many bytes there are.
size_t fill_with(const std::vector<Stream>& streams) {
    size_t total = 0, offset = 0;
    for (const Stream& stream : streams) total += stream.floats * sizeof(float);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(total), nullptr, GL_STATIC_DRAW);
    for (const Stream& stream : streams) {
        const auto location = static_cast<GLuint>(stream.attribute);
        const size_t bytes = stream.floats * sizeof(float);
        glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), stream.data);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, stream.components, GL_FLOAT, GL_FALSE, 0,
                              reinterpret_cast<const void*>(offset));
        offset += bytes;
    }
    return total;
}

}  // namespace

GpuMesh upload(const content::Mesh& mesh) {
    GpuMesh gpu;
    gpu.topology = mesh.topology;
    gpu.patch_vertices = mesh.patch_vertices;
    gpu.count = static_cast<std::uint32_t>(mesh.indices.size());
    gpu.parts = mesh.parts;
    gpu.has_color = !mesh.colors.empty();
    gpu.has_w = !mesh.w.empty();
    gpu.min = mesh.min;
    gpu.max = mesh.max;
    gpu.bounded = ranges::all_of(mesh.positions, [](const content::Float3& p) {
        return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    });
    if (mesh.positions.empty() || mesh.indices.empty()) return gpu;

    std::vector<float> positions;
    std::vector<Stream> streams;
    if (mesh.w.empty()) {
        add(streams, Attribute::vertex, mesh.positions);
    } else {
        positions = homogeneous(mesh);
        streams.push_back({Attribute::vertex, 4, positions.data(), positions.size()});
    }
    add(streams, Attribute::normal, mesh.normals);
    add(streams, Attribute::texcoord, mesh.texcoords);
    add(streams, Attribute::tangent, mesh.tangents);
    add(streams, Attribute::color, mesh.colors);

    gpu.array = gl::VertexArray(gl::make(glGenVertexArrays));
    gpu.vertices = gl::Buffer(gl::make(glGenBuffers));
    gpu.indices = gl::Buffer(gl::make(glGenBuffers));
    glBindVertexArray(gpu.array.get());
    glBindBuffer(GL_ARRAY_BUFFER, gpu.vertices.get());
    gpu.bytes = fill_with(streams);
    const auto list = [&](const auto& indices) {
        const size_t bytes = indices.size() * sizeof(indices[0]);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.indices.get());
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), indices.data(), GL_STATIC_DRAW);
        gpu.bytes += bytes;
    };
    // OpenGL ES takes the largest number for the end of a strip.
    if (mesh.positions.size() < std::numeric_limits<std::uint16_t>::max()) {
        gpu.index_type = GL_UNSIGNED_SHORT;
        list(std::vector<std::uint16_t>(mesh.indices.begin(), mesh.indices.end()));
    } else {
        list(mesh.indices);
    }
    glBindVertexArray(0);
    return gpu;
}

void draw_elements(GLenum mode, const GpuMesh& mesh, std::uint32_t first, std::uint32_t count) {
    const std::size_t size = mesh.index_type == GL_UNSIGNED_SHORT ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
    glDrawElements(mode, static_cast<GLsizei>(count), mesh.index_type, reinterpret_cast<const void*>(first * size));
}

const TopologyFacts& facts_of(Topology topology) {
    static constexpr TopologyFacts facts[]{{GL_POINTS, GL_POINTS},
                                           {GL_LINES, GL_LINES, 2, 0, 2},
                                           {GL_LINE_STRIP, GL_LINES, 2, 1, 1},
                                           {GL_LINE_LOOP, GL_LINES, 2, 0, 1},
                                           {GL_TRIANGLES, GL_TRIANGLES, 3, 0, 3},
                                           {GL_TRIANGLE_STRIP, GL_TRIANGLES, 3, 2, 1},
                                           {GL_TRIANGLE_FAN, GL_TRIANGLES, 3, 2, 1},
                                           {GL_LINES_ADJACENCY, GL_LINES_ADJACENCY, 4, 0, 4},
                                           {GL_LINE_STRIP_ADJACENCY, GL_LINES_ADJACENCY, 4, 3, 1},
                                           {GL_TRIANGLES_ADJACENCY, GL_TRIANGLES_ADJACENCY, 6, 0, 6},
                                           {GL_TRIANGLE_STRIP_ADJACENCY, GL_TRIANGLES_ADJACENCY, 6, 4, 2},
                                           {GL_PATCHES, GL_PATCHES}};
    static_assert(std::size(facts) == static_cast<std::size_t>(Topology::patches) + 1);
    return facts[static_cast<std::size_t>(topology)];
}

std::uint64_t TopologyFacts::primitives(std::uint32_t count) const {
    return count < least ? 0 : (count - shared) / step;
}

std::uint64_t triangle_count(Topology topology, std::uint32_t count) {
    const TopologyFacts& facts = facts_of(topology);
    const bool triangles = facts.input == GL_TRIANGLES || facts.input == GL_TRIANGLES_ADJACENCY;
    return triangles ? facts.primitives(count) : 0;
}

std::uint64_t line_count(Topology topology, std::uint32_t count) {
    const TopologyFacts& facts = facts_of(topology);
    return facts.input == GL_LINES || facts.input == GL_LINES_ADJACENCY ? facts.primitives(count) : 0;
}

std::optional<TreePart> tree_part(std::string_view sampler, std::string_view type) {
    const auto* found = ranges::find(glsl::mesh_samplers, sampler);
    if (type != "sampler2D" || found == glsl::mesh_samplers.end()) return std::nullopt;
    return static_cast<TreePart>(found - glsl::mesh_samplers.begin());
}

}  // namespace snell::runtime
