// Draws that differ only in their matrices are drawn by one call, as instances in the same order.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/runtime/impl.h"

namespace snell {

using runtime::Batch;
using runtime::hidden;
using runtime::ReadyDraw;
using runtime::ReadyPass;

namespace {

constexpr std::size_t fewest = 16;  // below, another form of the program costs more than the calls

}  // namespace

bool Runtime::Impl::alike(const ReadyDraw& a, const ReadyDraw& b) const {
    const Scene& scene = plan.scene;
    const Draw &one = scene.draws[a.draw], &other = scene.draws[b.draw];
    const auto color = [&](const Draw& draw) {
        return draw.color == none ? Vec4{1, 1, 1, 1} : scene.colors[draw.color];
    };
    return a.mesh == b.mesh && a.program == b.program && one.program == other.program && a.mode == b.mode &&
           a.patch_vertices == b.patch_vertices && a.textures == b.textures && a.harmonics == b.harmonics &&
           scene.rasters[one.raster] == scene.rasters[other.raster] &&
           scene.cameras[one.camera] == scene.cameras[other.camera] && color(one) == color(other);
}

void Runtime::Impl::find_batches(Index pass) {
    const Scene& scene = plan.scene;
    ReadyPass& ready = passes[pass];
    const auto& items = ready.items;
    for (std::size_t first = 0, end; first < items.size(); first = end) {
        end = first + 1;
        if (!items[first]) continue;
        while (end < items.size() && items[end] && alike(*items[first], *items[end])) ++end;
        if (end - first < fewest) continue;
        runtime::LinkedProgram& program = *items[first]->program;
        if (program.reads(glsl::System::face_index)) continue;  // each part has its number
        const Index named = scene.draws[items[first]->draw].program;
        const runtime::Instancing* instancing =
            make_instancing(program, named == none ? Program{} : scene.programs[named], caps, counters);
        if (!instancing) continue;
        for (std::size_t at = first; at < end; at += instancing->capacity)
            ready.batches.push_back({at,
                                     std::min(instancing->capacity, end - at),
                                     {},
                                     controls_of(named, *instancing->program),
                                     {},
                                     {},
                                     {}});
    }
}

// Returns false if some of the draws are hidden: the caller then draws them one by one.
bool Runtime::Impl::draw_batch(Index pass, Batch& batch, const Frame& frame, PassView& view) {
    const auto items = std::span(passes[pass].items).subspan(batch.first, batch.count);
    if (ranges::any_of(items, [&](const auto& item) { return hidden(frame, item->draw); })) return false;
    const ReadyDraw& ready = *items.front();
    const runtime::Instancing& instancing = *ready.program->instancing;
    std::vector<runtime::DrawContext>& contexts = batch.contexts;
    contexts.clear();
    for (std::size_t i = 0; i < items.size(); ++i)
        if (view.shows(batch.first + i)) contexts.push_back(context(items[i]->draw, frame, view));
    counters.draws_culled += items.size() - contexts.size();
    if (contexts.empty()) return true;
    set_up(ready, *instancing.program, batch.controls, contexts.front(), frame);
    instance_values(instancing, contexts, batch.values);
    if (!batch.matrices) batch.matrices = gl::Buffer(gl::make(glGenBuffers));
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, batch.matrices.get());
    if (batch.values != batch.last) {
        glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(batch.values.size() * sizeof(float)),
                     batch.values.data(), GL_DYNAMIC_DRAW);
        std::swap(batch.last, batch.values);
        ++counters.uniform_uploads;
    }
    const runtime::GpuMesh& mesh = *meshes[ready.mesh];
    glDrawElementsInstanced(ready.mode, static_cast<GLsizei>(mesh.count), GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(contexts.size()));
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, 0);  // a scene's own uniform blocks must not read the matrices
    count_draw(mesh.topology, mesh.count, contexts.size());
    return true;
}

}  // namespace snell
