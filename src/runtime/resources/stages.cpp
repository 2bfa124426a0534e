#include "src/runtime/resources/stages.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/content/mesh/tree.h"
#include "src/gl/driver.h"

namespace snell::runtime {

namespace {

// One buffer holds what so many runs capture.
constexpr std::size_t most_slots = 1 << 17;

using content::Float4;

// The neighbours of a strip are those of GL's table 10.1.
void add_strip_with_adjacency(std::vector<std::uint32_t>& corners, std::span<const std::uint32_t> indices) {
    const std::size_t all = indices.size() / 2 - 2;
    const auto at = [&](std::size_t one_based) { corners.push_back(indices[one_based - 1]); };
    for (std::size_t i = 1; i <= all; ++i) {
        const std::size_t before = i == 1 ? 2 : 2 * i - 3, beyond = i == all ? 2 * i + 4 : 2 * i + 5;
        if (i % 2 == 1)
            for (const std::size_t k : {2 * i - 1, before, 2 * i + 1, beyond, 2 * i + 3, 2 * i + 2}) at(k);
        else
            for (const std::size_t k : {2 * i + 1, before, 2 * i - 1, 2 * i + 2, 2 * i + 3, beyond}) at(k);
    }
}

template <class Vector>
Float4 padded(const std::vector<Vector>& values, std::size_t i) {
    Float4 texel{0, 0, 0, 1};
    if (i < values.size()) std::copy(values[i].begin(), values[i].end(), texel.begin());
    return texel;
}

gl::Texture texture_of(std::vector<Float4>& texels) {
    const auto [width, height] = content::fill_rows(texels);
    return gl::make_texture(GL_TEXTURE_2D,
                            {gl::Pixels::rgba32f, width, height, 1, reinterpret_cast<const std::byte*>(texels.data())},
                            {gl::Sampling::Mode::nearest, 1, true});
}

void fill(GLenum target, std::size_t bytes, const void* data) {
    glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
}

unsigned corners_of(const glsl::EmulatedGeometry& form) {
    return form.output == "points" ? 1 : form.output == "line_strip" ? 2 : 3;
}

// Of what one run captures.
std::size_t bytes_of_run(const glsl::EmulatedGeometry& form) {
    return static_cast<std::size_t>(form.vertices) * form.integral.size() * 16;
}

LinkedProgram& counting_of(LinkedProgram& program) {
    return program.geometry->listed ? *program.parts.back() : *program.parts.end()[-2];
}
// The one that runs the stages for what is drawn.
LinkedProgram& running_of(LinkedProgram& program) { return program.geometry->listed ? program : *program.parts.back(); }

GLenum list_mode(std::string_view output) {
    return output == "points" ? GL_POINTS : output == "line_strip" ? GL_LINES : GL_TRIANGLES;
}

bool is_stage_input(const std::string& name) {
    return name == glsl::stage_vertices || name == glsl::stage_primitives || name == glsl::stage_range ||
           name == glsl::stage_patches;
}

}  // namespace

// ANGLE never ends a query in which transform feedback captures without drawing (Vulkan, SwiftShader).
void capture(GLuint into, GLint first, GLsizei runs, gl::AnySamples* samples) {
    if (samples) samples->end();
    glBindBuffer(GL_ARRAY_BUFFER, 0);  // WebGL refuses to write what is bound elsewhere
    glEnable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, into);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, first, runs);
    glEndTransformFeedback();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glDisable(GL_RASTERIZER_DISCARD);
    if (samples) samples->begin();
}

std::vector<std::uint32_t> corners_of(Topology topology, std::span<const std::uint32_t> indices,
                                      std::size_t patch_vertices) {
    if (topology == Topology::patches) {
        const auto whole = static_cast<std::ptrdiff_t>(indices.size() / patch_vertices * patch_vertices);
        return {indices.begin(), indices.begin() + whole};
    }
    const TopologyFacts& facts = facts_of(topology);
    const std::size_t all = facts.primitives(static_cast<std::uint32_t>(indices.size()));
    std::vector<std::uint32_t> corners;
    corners.reserve(all * facts.least);
    if (topology == Topology::triangle_strip_adjacency) {
        if (all > 0) add_strip_with_adjacency(corners, indices);
        return corners;
    }
    for (std::size_t i = 0; i < all; ++i)
        for (std::size_t k = 0; k < facts.least; ++k) {
            std::size_t at = i * facts.step + k;
            if (topology == Topology::line_loop) at %= indices.size();
            if (topology == Topology::triangle_fan && k == 0) at = 0;
            // The last corner stays the one that flat values are taken from.
            if (topology == Topology::triangle_strip && i % 2 == 1 && k < 2) at = i + 1 - k;
            corners.push_back(indices[at]);
        }
    return corners;
}

std::shared_ptr<StageMesh> stage_mesh(const content::Mesh& mesh, int most_rows) {
    auto made = std::make_shared<StageMesh>();
    std::vector<Float4> vertices;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        Float4 position = padded(mesh.positions, i);
        if (!mesh.w.empty()) position[3] = mesh.w[i];
        vertices.insert(vertices.end(), {position, padded(mesh.normals, i), padded(mesh.colors, i),
                                         padded(mesh.texcoords, i), padded(mesh.tangents, i)});
    }
    const std::span all(mesh.indices);
    const auto patch_vertices = static_cast<std::size_t>(mesh.patch_vertices);
    const int corners =
        mesh.topology == Topology::patches ? mesh.patch_vertices : static_cast<int>(facts_of(mesh.topology).least);
    std::vector<std::uint32_t> listed;
    const auto add = [&](std::span<const std::uint32_t> indices) {
        const std::vector<std::uint32_t> more = corners_of(mesh.topology, indices, patch_vertices);
        const auto number = [&](std::size_t n) { return static_cast<int>(n) / corners; };
        made->parts.push_back({number(listed.size()), number(more.size())});
        listed.insert(listed.end(), more.begin(), more.end());
    };
    for (const content::MeshPart& part : mesh.parts) add(all.subspan(part.first, part.count));
    const auto counted = static_cast<int>(listed.size()) / corners;
    if (mesh.parts.empty())
        add(all);
    else
        made->parts.push_back({0, counted});
    std::vector<Float4> primitives((listed.size() + 3) / 4);
    for (std::size_t i = 0; i < listed.size(); ++i) primitives[i / 4][i % 4] = static_cast<float>(listed[i]);
    const std::size_t limit = content::tree_row * static_cast<std::size_t>(most_rows);
    if (vertices.size() > limit || primitives.size() > limit || mesh.positions.size() >= content::tree_limit)
        return nullptr;
    made->vertices = texture_of(vertices);
    made->primitives = texture_of(primitives);
    made->bytes = (vertices.size() + primitives.size()) * sizeof(Float4);
    return made;
}

gl::Linked link_capturing(const gl::Shader& shader, const std::vector<std::string>& written, const gl::Caps& caps) {
    const gl::Compiled nothing = gl::compile(
        GL_FRAGMENT_SHADER, fmt::format("#version {} {}\nvoid main() {{}}\n", caps.glsl, caps.es ? "es" : "core"));
    return gl::link({&shader, &nothing.shader}, {}, written);
}

// What all three read is bound once, so a sampler has the same units in each of them. What the scene sees is the
// program that has all uniforms.
void join_parts(LinkedProgram& linked) {
    int next = 0;
    for (const SamplerUniform& sampler : linked.samplers) next = std::max(next, sampler.first_unit + sampler.size);
    for (const auto& part : linked.parts) {
        for (SamplerUniform& sampler : part->samplers) {
            if (is_stage_input(sampler.name)) continue;
            const auto known = ranges::find(linked.samplers, sampler.name, &SamplerUniform::name);
            sampler.first_unit = known == linked.samplers.end() ? next : known->first_unit;
            if (known != linked.samplers.end()) continue;
            next += sampler.size;
            linked.samplers.push_back(sampler);
            linked.samplers.back().location = -1;
        }
        for (const ActiveUniform& uniform : part->active)
            if (!is_stage_input(uniform.name) && ranges::count(linked.active, uniform.name, &ActiveUniform::name) == 0)
                linked.active.push_back(uniform);
    }
    linked.in_turn([&](LinkedProgram& part, std::size_t) {
        for (SamplerUniform& sampler : part.samplers)
            if (is_stage_input(sampler.name))
                sampler.first_unit = sampler.name == glsl::stage_vertices     ? next
                                     : sampler.name == glsl::stage_primitives ? next + 1
                                                                              : next + 2;
        assign_units(part);
    });
    std::erase_if(linked.samplers, [](const SamplerUniform& sampler) { return is_stage_input(sampler.name); });
    std::erase_if(linked.active, [](const ActiveUniform& uniform) { return is_stage_input(uniform.name); });
    linked.stage_unit = next;
}

void StageMesh::bind(const LinkedProgram& program, int first_unit, const Part& of, bool has_color, State& state) const {
    state.texture(first_unit, GL_TEXTURE_2D, vertices.get(), 0);
    state.texture(first_unit + 1, GL_TEXTURE_2D, primitives.get(), 0);
    state.program(program.program.get());
    glUniform2i(program.stage_range, of.first, has_color ? 1 : 0);
}

std::vector<double> what_decides(const LinkedProgram& part, const Vec4& color) {
    std::vector<double> numbers{color.begin(), color.end()};
    for (const SystemUniform& uniform : part.system)
        numbers.insert(numbers.end(), uniform.last.begin(), uniform.last.end());
    for (const UserUniform& uniform : part.user)
        numbers.insert(numbers.end(), uniform.last.begin(), uniform.last.end());
    return numbers;
}

bool reads_textures(const LinkedProgram& part) {
    return ranges::any_of(part.samplers, [](const SamplerUniform& sampler) { return !is_stage_input(sampler.name); });
}

void StageDraw::draw(LinkedProgram& program, const StageMesh& mesh, std::size_t part, bool has_color, const Vec4& color,
                     double version, const Capturing& with) {
    const glsl::EmulatedGeometry& form = *program.geometry;
    const StageMesh::Part& of = mesh.parts[part];
    State& state = with.state;
    LinkedProgram &counting = counting_of(program), &running = running_of(program);
    if (parts_.size() < mesh.parts.size()) parts_.resize(mesh.parts.size());
    auto& slot = parts_[part];
    if (!slot) slot = std::make_unique<Emitted>();
    Emitted& emitted = *slot;
    for (const LinkedProgram* each : {&counting, &running}) mesh.bind(*each, program.stage_unit, of, has_color, state);
    state.color(color);

    std::vector<double> depends = what_decides(counting, color);
    depends.push_back(version);
    if (reads_textures(counting) || !emitted.array || emitted.depends != depends) {
        count(emitted, form, counting, of, with);
        emitted.depends = std::move(depends);
    }
    for (const Piece& piece : emitted.pieces) {
        if (!form.listed) {
            state.program(running.program.get());
            state.vertex_array(emitted.slots_array.get());
            capture(captured_.get(), static_cast<GLint>(piece.first_slot), static_cast<GLsizei>(piece.slots),
                    with.samples);
        }
        state.program(program.program.get());
        state.vertex_array(emitted.array.get());
        glDrawElements(list_mode(form.output), static_cast<GLsizei>(piece.elements), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(piece.first_element * sizeof(std::uint32_t)));
        with.counters.captured_primitives += piece.elements / corners_of(form);
        with.counters.captured_bytes +=
            form.listed ? piece.elements * sizeof(std::uint32_t) : piece.slots * bytes_of_run(form);
    }
}

void StageDraw::count(Emitted& emitted, const glsl::EmulatedGeometry& form, const LinkedProgram& counting,
                      const StageMesh::Part& of, const Capturing& with) {
    const auto runs = static_cast<std::size_t>(of.count) * static_cast<std::size_t>(form.invocations);
    std::vector<std::uint32_t> counts(runs * form.counted.size());
    if (!none_) none_ = gl::VertexArray(gl::make(glGenVertexArrays));
    with.state.program(counting.program.get());
    with.state.vertex_array(none_.get());
    const std::size_t bytes = counts.size() * sizeof(std::uint32_t);
    if (bytes > 0) {
        const gl::Buffer counted(gl::make(glGenBuffers));
        glBindBuffer(GL_ARRAY_BUFFER, counted.get());
        fill(GL_ARRAY_BUFFER, bytes, nullptr);
        capture(counted.get(), 0, static_cast<GLsizei>(runs), with.samples);
        glBindBuffer(GL_ARRAY_BUFFER, counted.get());
        gl::read_buffer(GL_ARRAY_BUFFER, bytes, counts.data());
        ++with.counters.stage_reads;
    }
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    list(emitted, form, counts, with.state);
}

// Lists the runs that capture what was counted, and joins the emitted vertices to primitives.
void StageDraw::list(Emitted& emitted, const glsl::EmulatedGeometry& form, std::span<const std::uint32_t> counts,
                     State& state) {
    const std::size_t stride = form.counted.size();
    const auto step = static_cast<std::uint32_t>(form.vertices);
    const unsigned corners = corners_of(form);
    std::vector<std::array<std::int32_t, 2>> slots;
    std::vector<std::uint32_t> elements;
    emitted.pieces.clear();
    std::size_t most = 0;
    for (std::size_t item = 0; item * stride < counts.size(); ++item) {
        const std::span<const std::uint32_t> of = counts.subspan(item * stride, stride);
        if (emitted.pieces.empty() || slots.size() - emitted.pieces.back().first_slot >= most_slots)
            emitted.pieces.push_back({slots.size(), 0, elements.size(), 0});
        Piece& piece = emitted.pieces.back();
        const auto first = form.listed ? static_cast<std::uint32_t>(item) * static_cast<std::uint32_t>(form.most)
                                       : static_cast<std::uint32_t>(slots.size() - piece.first_slot) * step;
        for (std::uint32_t k = 0; k < of[0] && !form.listed; k += step)
            slots.push_back({static_cast<std::int32_t>(item), static_cast<std::int32_t>(k)});
        unsigned strip = 0;
        for (std::uint32_t k = 0; k < of[0]; ++k) {
            if (stride > 1 && (of[1 + k / 32] >> (k % 32) & 1) != 0) strip = 0;
            if (++strip < corners && stride > 1) continue;
            const std::uint32_t last = first + k, odd = strip % 2 == 0 ? 1 : 0;
            if (corners == 3) elements.insert(elements.end(), {last - 2 + odd, last - 1 - odd});
            if (corners == 2) elements.push_back(last - 1);
            elements.push_back(last);
        }
        piece.slots = slots.size() - piece.first_slot;
        piece.elements = elements.size() - piece.first_element;
        most = std::max(most, piece.slots);
    }
    arrange(emitted, form, most, state);
    glBindBuffer(GL_ARRAY_BUFFER, emitted.slots.get());
    fill(GL_ARRAY_BUFFER, slots.size() * sizeof(slots[0]), slots.data());
    state.vertex_array(emitted.array.get());
    fill(GL_ELEMENT_ARRAY_BUFFER, elements.size() * sizeof(elements[0]), elements.data());
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

// Makes room for so many runs.
void StageDraw::arrange(Emitted& emitted, const glsl::EmulatedGeometry& form, std::size_t slots, State& state) {
    const std::size_t vertex = form.listed ? 0 : form.integral.size() * 16, bytes = slots * bytes_of_run(form);
    if (!captured_) captured_ = gl::Buffer(gl::make(glGenBuffers));
    glBindBuffer(GL_ARRAY_BUFFER, captured_.get());
    if (bytes > captured_bytes_) fill(GL_ARRAY_BUFFER, captured_bytes_ = bytes, nullptr);
    if (emitted.array) return;
    for (gl::VertexArray* array : {&emitted.array, &emitted.slots_array})
        *array = gl::VertexArray(gl::make(glGenVertexArrays));
    for (gl::Buffer* buffer : {&emitted.slots, &emitted.elements}) *buffer = gl::Buffer(gl::make(glGenBuffers));
    state.vertex_array(emitted.array.get());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, emitted.elements.get());
    for (GLuint at = 0; at < vertex / 16; ++at) {
        const auto stride = static_cast<GLsizei>(vertex);
        const auto* offset = reinterpret_cast<const void*>(std::size_t{at} * 16);
        glEnableVertexAttribArray(at);
        if (form.integral[at])
            glVertexAttribIPointer(at, 4, GL_UNSIGNED_INT, stride, offset);
        else
            glVertexAttribPointer(at, 4, GL_FLOAT, GL_FALSE, stride, offset);
    }
    state.vertex_array(emitted.slots_array.get());
    glBindBuffer(GL_ARRAY_BUFFER, emitted.slots.get());
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(0, 2, GL_INT, 0, nullptr);
}

}  // namespace snell::runtime
