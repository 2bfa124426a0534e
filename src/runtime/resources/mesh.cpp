#include "src/runtime/resources/mesh.h"

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

// Positions with w where the mesh has it.
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
    size_t total = 0;
    for (const Stream& stream : streams) total += stream.floats * sizeof(float);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(total), nullptr, GL_STATIC_DRAW);
    size_t offset = 0;
    for (const Stream& stream : streams) {
        const auto location = static_cast<GLuint>(stream.attribute);
        const size_t bytes = stream.floats * sizeof(float);
        glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), stream.data);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, stream.components, GL_FLOAT, GL_FALSE, 0,
                              reinterpret_cast<const void*>(offset));
        offset += bytes;
    }
    const size_t index_bytes = mesh.indices.size() * sizeof(mesh.indices[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.indices.get());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(index_bytes), mesh.indices.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
    gpu.bytes = total + index_bytes;
    return gpu;
}

GLenum gl_mode(Topology topology) {
    switch (topology) {
        case Topology::points:
            return GL_POINTS;
        case Topology::lines:
            return GL_LINES;
        case Topology::line_strip:
            return GL_LINE_STRIP;
        case Topology::line_loop:
            return GL_LINE_LOOP;
        case Topology::triangles:
            return GL_TRIANGLES;
        case Topology::triangle_strip:
            return GL_TRIANGLE_STRIP;
        case Topology::triangle_fan:
            return GL_TRIANGLE_FAN;
        case Topology::lines_adjacency:
            return GL_LINES_ADJACENCY;
        case Topology::line_strip_adjacency:
            return GL_LINE_STRIP_ADJACENCY;
        case Topology::triangles_adjacency:
            return GL_TRIANGLES_ADJACENCY;
        case Topology::triangle_strip_adjacency:
            return GL_TRIANGLE_STRIP_ADJACENCY;
        case Topology::patches:
            return GL_PATCHES;
    }
    return GL_TRIANGLES;
}

std::uint64_t triangle_count(Topology topology, std::uint32_t count) {
    switch (topology) {
        case Topology::triangles:
            return count / 3;
        case Topology::triangle_strip:
        case Topology::triangle_fan:
            return count > 2 ? count - 2 : 0;
        case Topology::triangles_adjacency:
            return count / 6;
        case Topology::triangle_strip_adjacency:
            return count > 5 ? (count - 4) / 2 : 0;
        default:
            return 0;
    }
}

std::uint64_t line_count(Topology topology, std::uint32_t count) {
    switch (topology) {
        case Topology::lines:
            return count / 2;
        case Topology::line_strip:
            return count > 1 ? count - 1 : 0;
        case Topology::line_loop:
            return count > 1 ? count : 0;
        case Topology::lines_adjacency:
            return count / 4;
        case Topology::line_strip_adjacency:
            return count > 3 ? count - 3 : 0;
        default:
            return 0;
    }
}

}  // namespace snell::runtime
