// Draws a frame: the passes in their order, each draw with the state at its statement.
#include "src/runtime/runtime.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "parser/text/ranges.h"
#include "src/gl/driver.h"
#include "src/gl/target.h"
#include "src/runtime/impl.h"

namespace snell {

namespace {

template <class Programs, class Each>
void each_loops(const Programs& programs, const Each& each) {
    for (const auto& [key, linked] : programs)
        if (linked)
            for (const glsl::LongLoops& loops : linked->long_loops) each(key.first, loops);
}

// Calls `each` for the values that bound loops, and the largest ones for which these are short.
template <class Programs, class Values, class Each>
void each_bound(const Programs& programs, Values& values, const Each& each) {
    each_loops(programs, [&](Index program, const glsl::LongLoops& loops) {
        for (const std::string& name : loops.bounds)
            if (auto* control = values.find(program, name))
                for (auto& value : control->value) each(program, value, loops.up_to);
    });
}

// Calls `each` for the programs whose loops are not short with these values, with how many times larger these are than
// those with which they are; 1 if nobody knows.
template <class Programs, class Each>
void each_long(const Programs& programs, const Controls& values, const Each& each) {
    each_loops(programs, [&](Index program, const glsl::LongLoops& loops) {
        if (loops.up_to < 0) each(program, 1.);
    });
    each_bound(programs, values, [&](Index program, double value, double up_to) {
        if (!(std::abs(value) <= up_to)) each(program, std::isnan(value) ? 1 : std::abs(value) / up_to);
    });
}

std::optional<Runtime::Held> held_of(const runtime::GpuTexture* gpu) {
    if (!gpu) return std::nullopt;
    const int longest = *ranges::max_element(gpu->size);
    const int levels = gpu->mipmapped ? std::bit_width(static_cast<unsigned>(longest)) : gpu->levels;
    return Runtime::Held{{gpu->texture.get(), gpu->target, gpu->size}, levels, gpu->pixels};
}

glm::dmat4 matrix(const Mat4& m) {
    glm::dmat4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) result[column][row] = m[static_cast<size_t>(column * 4 + row)];
    return result;
}

// `region` is the scissor box, if one is set; it stays set.
void clear(const Vec4& color, const std::optional<PixelRect>& region) {
    if (!region) glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    const auto part = [&](size_t i) { return static_cast<float>(std::clamp(color[i], 0.0, 1.0)); };
    glClearColor(part(0), part(1), part(2), part(3));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

// Returns the view of a cube face from `center`. It is such that the first row of the face is its top row.
glm::dmat4 face_view(int face, const Vec3& center) {
    static const std::array<glm::dvec3, 6> forward{glm::dvec3(1, 0, 0),  glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0),
                                                   glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1),  glm::dvec3(0, 0, -1)};
    static const std::array<glm::dvec3, 6> up{glm::dvec3(0, -1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1),
                                              glm::dvec3(0, 0, -1), glm::dvec3(0, -1, 0), glm::dvec3(0, -1, 0)};
    const glm::dvec3 eye(center[0], center[1], center[2]);
    return glm::lookAt(eye, eye + forward[static_cast<size_t>(face)], up[static_cast<size_t>(face)]);
}

}  // namespace

Runtime::Runtime(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, Diagnostics& diagnostics,
                 const RuntimeOptions& options)
    : impl_(std::make_unique<Impl>(std::move(plan), files, sources, caps, diagnostics, options)) {}
Runtime::~Runtime() = default;
Runtime::Runtime(Runtime&&) noexcept = default;
Runtime& Runtime::operator=(Runtime&&) noexcept = default;

const Scene& Runtime::scene() const { return impl_->plan.scene; }
gl::Pixels Runtime::display_pixels() const {
    return scene().output == Encoding::srgb ? gl::Pixels::srgb8 : gl::Pixels::rgba8;
}
const std::vector<std::vector<ActiveUniform>>& Runtime::active_uniforms() const { return impl_->active; }
const Controls& Runtime::controls() const { return impl_->given; }
const Diagnostics& Runtime::value_problems() const { return impl_->value_problems; }
bool Runtime::animated() const { return impl_->animated; }
bool Runtime::timed() const { return impl_->timed; }
bool Runtime::uses_mouse() const { return impl_->mouse; }
double Runtime::long_loops(const Controls& values) const {
    double most = 0;
    each_long(impl_->programs, values, [&](Index, double times) { most = std::max(most, times); });
    return most;
}
Index Runtime::long_program(const Controls& values) const {
    Index first = none;
    each_long(impl_->programs, values, [&](Index program, double) { first = std::min(first, program); });
    return first;
}
bool Runtime::may_have_long_loops() const {
    bool may = false;
    each_loops(impl_->programs, [&](Index, const glsl::LongLoops&) { may = true; });
    return may;
}
void Runtime::shorten_loops(Controls& values, double times) const {
    each_bound(impl_->programs, values,
               [&](Index, double& value, double up_to) { value = std::clamp(value, -times * up_to, times * up_to); });
}
bool Runtime::sampled(Index texture) const {
    return impl_->textures.asked(texture) || impl_->dormant_textures.contains(impl_->textures.first(texture));
}
bool Runtime::choose(const Rungs& rungs) { return impl_->choose(rungs); }
const Rungs& Runtime::rungs() const { return impl_->plan.rungs; }
const Diagnostics& Runtime::ladder_problems() const { return impl_->problems; }
void Runtime::draw(const Frame& frame, const Surface& surface) {
    impl_->take(frame.controls);
    impl_->draw(frame, surface);
}
bool Runtime::specialise(const Frame& frame, const Surface& surface) { return impl_->specialise(frame, surface); }
Diagnostics Runtime::take_costs() { return std::exchange(impl_->costs, {}); }
void Runtime::skip_frame() { ++impl_->counters.frames_skipped; }
bool Runtime::settled() const { return impl_->settled; }
double Runtime::distance(Index draw, double depth, const Frame& frame, const Surface& surface) const {
    return impl_->distance(draw, depth, frame, surface);
}
std::vector<Index> Runtime::pick(const Frame& frame, int width, int height, const PixelRect& region) {
    impl_->take(frame.controls);
    return impl_->pick(frame, width, height, region);
}
void Runtime::outline(const Frame& frame, const Surface& surface, Index draw, float line) {
    impl_->take(frame.controls);
    impl_->outline(frame, surface, draw, line);
}
std::optional<Runtime::Held> Runtime::texture(Index texture) const {
    std::optional<Held> held = held_of(impl_->textures.find(texture));
    if (!held) return held;
    const Index source = impl_->plan.scene.textures[texture].source;
    const Index drawn = source == none ? texture : source;
    held->changes = ranges::any_of(impl_->plan.scene.passes,
                                   [&](const Pass& pass) { return ranges::count(pass.textures, drawn) > 0; });
    return held;
}
std::optional<Runtime::Held> Runtime::noise(int dimensions) const {
    return held_of(impl_->textures.find_noise(dimensions));
}
Runtime::Drawn Runtime::drawn(const Frame& frame) const { return impl_->drawn(frame); }
bool Runtime::find_switched_off() { return impl_->link_alone(); }
std::vector<const Control*> Runtime::without_effect(double seconds) const { return impl_->without_effect(seconds); }
int Runtime::form() const { return impl_->settled_values; }
const Counters& Runtime::counters() const { return impl_->counters; }

using runtime::DrawContext;
using runtime::hidden;
using runtime::LinkedProgram;
using runtime::ReadyDraw;
using runtime::ReadyPass;

// All draws of a pass through one camera share these values.
DrawContext Runtime::Impl::look(Index camera, const Frame& frame, const PassView& view) const {
    const Scene& scene = plan.scene;
    DrawContext result;
    const Camera& own = scene.cameras[camera];
    result.view = view.view ? *view.view : eye_from_world(own, frame.view);
    const Lens lens = lens_of(own, frame.view.projection, result.view);
    result.scene = view.view ? glm::dmat4(1) : lens.shift * about_origin(frame.view.scene, own, result.view);
    const double aspect = static_cast<double>(view.width) / view.height;
    result.projection =
        (view.projection ? *view.projection : projection_matrix(lens.camera, aspect, view.depth)) * result.scene;
    if (view.shift != std::array<double, 2>{0, 0})
        result.projection =
            glm::translate(glm::dmat4(1), {2 * view.shift[0] / view.width, 2 * view.shift[1] / view.height, 0}) *
            result.projection;
    result.texture = frame.view.texture.matrix();
    result.time = frame.time;
    result.timer_period = scene.timer_period;
    result.width = view.width;
    result.height = view.height;
    result.place = view.place;
    result.mouse_x = frame.view.mouse_x;
    result.mouse_y = frame.view.mouse_y;
    return result;
}

DrawContext& Runtime::Impl::context(Index index, const Frame& frame, PassView& view) const {
    const Scene& scene = plan.scene;
    const Draw& draw = scene.draws[index];
    if (!view.shared || view.camera != draw.camera) {
        view.shared = look(draw.camera, frame, view);
        view.camera = draw.camera;
    }
    DrawContext& result = *view.shared;
    result.model = draw.matrix == none ? glm::dmat4(1) : matrix(scene.matrices[draw.matrix]);
    if (!frame.view.objects.empty())
        if (const auto object = frame.view.objects.find(index); object != frame.view.objects.end())
            result.model = placed(object->second, scene.cameras[draw.camera], result.model);
    const RasterState& raster = scene.rasters[draw.raster];
    result.point_size = raster.point_size / frame.enlarged;
    result.fixed_point_size = raster.point_size_mode ? 0 : raster.point_size / frame.enlarged;
    result.line_width = raster.line_width / frame.enlarged;
    return result;
}

void Runtime::Impl::draw(const Frame& frame, const Surface& surface) {
    if (surface.width <= 0 || surface.height <= 0) return;
    take_parts(surface.part.has_value());
    state.forget();
    captured.clear();
    if (frame.view.axes) ready_axes();
    if (!caps.es) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);  // OpenGL ES 3 is always so
    const std::uint64_t before = state.changes();
    bool first_window = true;
    const bool only_window = frame.standing && !redrawn();
    if (!only_window) settled = true;
    Frame off_screen = frame;
    off_screen.unblended = false;
    off_screen.enlarged = 1;
    const PassView window = window_view(frame, surface);
    find_needed(frame, window);
    for (Index pass = 0; pass < passes.size(); ++pass) {
        if (!passes[pass].live) continue;
        const Pass::Kind kind = plan.scene.passes[pass].kind;
        if (kind != Pass::Kind::window && !due(pass, only_window)) {
            if (!only_window) runtime::told(frame, {pass});
            continue;
        }
        if (caps.software) gl::settle();
        switch (kind) {
            case Pass::Kind::window: {
                const gl::Encoded encoded(plan.scene.output == Encoding::srgb);
                draw_window(pass, frame, surface, window, first_window);
                if (surface.region) glDisable(GL_SCISSOR_TEST);
                first_window = false;
                break;
            }
            case Pass::Kind::textures:
                draw_textures(pass, off_screen);
                break;
            case Pass::Kind::cube:
                draw_cube(pass, off_screen);
                break;
        }
        runtime::told(frame, {pass});
    }
    if (frame.view.axes) draw_axes(frame, surface);
    if (surface.region) glDisable(GL_SCISSOR_TEST);
    glBindVertexArray(0);
    glUseProgram(0);
    counters.state_changes += state.changes() - before;
    ++counters.frames;
    find_costs();
}

Vec4 Runtime::Impl::behind(const Frame& frame) const {
    if (frame.background) return *frame.background;
    return frame.view.background ? background_of(*frame.view.background) : plan.scene.background;
}

Runtime::Impl::PassView Runtime::Impl::window_view(const Frame& frame, const Surface& surface) const {
    PassView view{surface.width, surface.height, behind(frame)};
    if (const auto& part = surface.part)
        view.place = {static_cast<float>(part->left), static_cast<float>(part->bottom),
                      static_cast<float>(surface.height - part->bottom - part->height)};
    view.region = surface.region;
    view.depth = fitted_depth(frame);
    view.shift = frame.shift;
    return view;
}

void Runtime::Impl::draw_window(Index pass, const Frame& frame, const Surface& surface, PassView view, bool first) {
    runtime::aim(surface);
    if (first) clear(view.background, view.region);
    if (passes[pass].items.empty()) return;
    state.forget();
    if (frame.reached != nullptr && !*frame.reached) samples.emplace().begin();
    draw_items(pass, frame, view);
    if (samples) {
        samples->end();
        *frame.reached = samples->passed();
        samples.reset();
    }
    ++counters.passes;
}

void Runtime::Impl::draw_textures(Index pass, const Frame& frame) {
    ReadyPass& ready = passes[pass];
    const gl::TextureTarget& target = targets.at(ready.textures).front();
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glViewport(0, 0, ready.width, ready.height);
    PassView view{ready.width, ready.height, plan.scene.passes[pass].background.value_or(Vec4{0, 0, 0, 0})};
    const auto same = [&](const ReadyPass& before) { return before.live && before.textures == ready.textures; };
    if (std::none_of(passes.begin(), passes.begin() + pass, same)) clear(view.background, {});
    state.forget();
    draw_items(pass, frame, view);
    finish_pass(pass);
    ready.stale = false;
}

// Returns all numbers that decide what the faces of a cube pass show.
std::vector<double> Runtime::Impl::seen_by(Index pass, const Frame& frame) const {
    std::vector<double> seen{1};
    bool moves = false;
    const auto add = [&seen](const auto& numbers) { seen.insert(seen.end(), numbers.begin(), numbers.end()); };
    for (const auto& item : passes[pass].items) {
        if (!item) continue;
        seen.push_back(hidden(frame, item->draw) ? 1 : 0);
        if (const auto object = frame.view.objects.find(item->draw); object != frame.view.objects.end())
            add(object->second.numbers());
        const LinkedProgram& program = *item->program;
        moves = moves || program.reads(glsl::System::timer) || program.reads(glsl::System::time);
        for (const Control& control : values->items)
            if (control.program == plan.scene.draws[item->draw].program) add(control.value);
        if (program.reads(glsl::System::texture_matrix)) add(frame.view.texture.numbers());
        if (program.reads(glsl::System::mouse)) seen.insert(seen.end(), {frame.view.mouse_x, frame.view.mouse_y});
    }
    if (moves) seen.push_back(frame.time);
    return seen;
}

bool Runtime::Impl::reads(const ReadyDraw& draw, Index rendered) const {
    const auto* gpu = textures.find(rendered);
    const auto same = [&](const runtime::BoundTexture& texture) { return texture.texture == gpu->texture.get(); };
    return (gpu && ranges::any_of(draw.textures, same)) || ranges::count(draw.sources, rendered) > 0;
}

// If a pass reads other passes, seen_by() does not tell whether its picture changed.
bool Runtime::Impl::reads_other_passes(const ReadyPass& pass) const {
    for (const auto& item : pass.items)
        for (const ReadyPass& other : passes)
            for (const Index rendered : other.textures)
                if (item && reads(*item, rendered)) return true;
    return false;
}

// If a texture is drawn to more than once in a frame, passes in between need all earlier ones.
bool Runtime::Impl::redrawn() const {
    std::set<Index> drawn;
    for (const ReadyPass& pass : passes)
        for (const Index texture : pass.textures)
            if (pass.live && !drawn.insert(texture).second) return true;
    return false;
}

// Draws the faces whose content has changed. A paced frame draws only as many as the scene says, in turns.
void Runtime::Impl::draw_cube(Index pass, const Frame& frame) {
    ReadyPass& ready = passes[pass];
    const std::vector<double> seen = seen_by(pass, frame);
    const bool all = !savings || reads_other_passes(ready);
    const bool fresh = ready.cube_seen[0].empty() || ready.stale;
    int budget = frame.paced && !all && !fresh ? plan.scene.passes[pass].faces_per_frame : 6;
    const int first = ready.next_face;
    bool drawn = false;
    for (int i = 0; i < 6; ++i) {
        const int face = (first + i) % 6;
        std::vector<double>& shown = ready.cube_seen[static_cast<size_t>(face)];
        if (!all && shown == seen) continue;
        if (budget-- <= 0) {
            settled = false;
            break;
        }
        draw_face(pass, face, frame);
        shown = seen;
        ready.next_face = (face + 1) % 6;
        drawn = true;
    }
    if (drawn) finish_pass(pass);
    ready.stale = false;
}

void Runtime::Impl::draw_face(Index pass, int face, const Frame& frame) {
    const ReadyPass& ready = passes[pass];
    const Pass& declared = plan.scene.passes[pass];
    const glm::dmat4 projection = glm::perspective(glm::radians(90.0), 1.0, .1, 1000.0);
    const glm::dmat4 view_matrix = face_view(face, declared.center);
    PassView view{ready.width, ready.height, declared.background.value_or(plan.scene.background), &projection,
                  &view_matrix};
    if (caps.software) gl::settle();
    glBindFramebuffer(GL_FRAMEBUFFER, targets.at(ready.textures)[static_cast<size_t>(face)].framebuffer.get());
    glViewport(0, 0, ready.width, ready.height);
    clear(view.background, {});
    state.forget();
    view.face = static_cast<std::size_t>(face);
    draw_items(pass, frame, view);
    ++counters.cube_faces;
}

// Updates the mipmaps and computed maps of the textures that the pass has drawn to.
void Runtime::Impl::finish_pass(Index pass) {
    const ReadyPass& ready = passes[pass];
    glActiveTexture(GL_TEXTURE0);
    for (size_t i = 0; i < ready.textures.size(); ++i) {
        if (ready.remake_mipmaps[i])
            gl::generate_mipmaps(ready.remake_mipmaps[i], textures.find(ready.textures[i])->texture.get());
        textures.refresh(ready.textures[i]);
    }
    state.forget();
    ++counters.passes;
}

void Runtime::Impl::draw_items(Index pass, const Frame& frame, PassView& view) {
    const Pass& declared = plan.scene.passes[pass];
    view.out = out_of_view(pass, frame, view);
    for (size_t i = 0; i < declared.items.size(); ++i) {
        if (declared.items[i].kind == Item::Kind::clear) {
            clear(view.background, view.region);
            state.forget();
        } else if (passes[pass].items[i] && !hidden(frame, declared.items[i].index)) {
            if (view.shows(i))
                draw_one(*passes[pass].items[i], frame, view);
            else
                ++counters.draws_culled;
            runtime::told(frame, {pass, declared.items[i].index});
        }
    }
}

void Runtime::Impl::draw_one(const ReadyDraw& ready, const Frame& frame, PassView& view) {
    set_up(ready, frame, view);
    draw_mesh(ready);
}

Vec4 Runtime::Impl::draw_color(const ReadyDraw& ready) const {
    const Draw& draw = plan.scene.draws[ready.draw];
    return draw.color == none ? Vec4{1, 1, 1, 1} : plan.scene.colors[draw.color];
}

// Sets everything that a draw needs.
void Runtime::Impl::set_up(const ReadyDraw& ready, const Frame& frame, PassView& view) {
    const Draw& draw = plan.scene.draws[ready.draw];
    LinkedProgram& program = *ready.program;
    DrawContext& context = this->context(ready.draw, frame, view);
    if (!savings) state.forget();
    context.harmonics = ready.harmonics;
    program.in_turn([&](LinkedProgram& part, std::size_t i) {
        const std::vector<Index>& controls = i < ready.part_controls.size() ? ready.part_controls[i] : ready.controls;
        state.program(part.program.get());
        if (part.blocks) glBindBufferBase(GL_UNIFORM_BUFFER, 0, part.blocks.get());
        const int uploads = runtime::set_system(part, context, !savings) +
                            (draw.program == none ? 0 : runtime::set_user(part, controls, *values, !savings));
        counters.uniform_uploads += static_cast<std::uint64_t>(uploads);
    });
    counters.specialised_draws += program.settled.empty() ? 0 : 1;
    for (const runtime::BoundTexture& texture : ready.textures)
        state.texture(texture.unit, texture.target, texture.texture, texture.sampler);
    const Vec4 color = draw_color(ready);
    const bool opaque =
        savings && (program.opaque || (draw.program == none && color[3] >= 1 && !meshes[ready.mesh]->has_color));
    RasterState raster = plan.scene.rasters[draw.raster];
    raster.line_width /= frame.enlarged;
    raster.point_size /= frame.enlarged;
    if (frame.unblended) raster.blend = false;
    if (program.wide) {  // they are lines all the same: not outlined, and neither side is their back
        raster.wireframe = false;
        raster.cull = CullFace::none;
    }
    counters.blended_draws += state.raster(raster, opaque) ? 1 : 0;
    state.vertex_array(meshes[ready.mesh]->array.get());
    state.color(color);
}

void Runtime::Impl::draw_mesh(const ReadyDraw& ready) {
    LinkedProgram& program = *ready.program;
    const runtime::GpuMesh& mesh = *meshes[ready.mesh];
    if (ready.mode == GL_PATCHES && !ready.patches) gl::beyond::patch_vertices(ready.patch_vertices);
    const auto face = [&](int index) {
        program.in_turn([&](LinkedProgram& part, std::size_t) {
            state.program(part.program.get());
            counters.uniform_uploads += static_cast<std::uint64_t>(runtime::set_face_index(part, index));
        });
    };
    const auto elements = [&](std::uint32_t first, std::uint32_t count, std::size_t part) {
        const std::uint64_t primitives = counters.captured_primitives, bytes = counters.captured_bytes;
        const runtime::Capturing with{state, samples ? &*samples : nullptr, counters};
        if (ready.patches)
            ready.patches->draw(program, mesh, part, draw_color(ready), with);
        else if (ready.stages)
            ready.stages->draw(program, *mesh.stages, part, mesh.has_color, draw_color(ready), 0, with);
        else
            runtime::draw_elements(ready.mode, mesh, first, count);
        if (counters.captured_primitives > primitives) {
            Captured& sum = captured[plan.scene.draws[ready.draw].program];
            sum.primitives += counters.captured_primitives - primitives;
            sum.bytes += counters.captured_bytes - bytes;
        }
        ++counters.draws;
        counters.triangles += runtime::triangle_count(mesh.topology, count);
        counters.lines += runtime::line_count(mesh.topology, count);
        counters.points += mesh.topology == Topology::points ? count : 0;
    };
    const std::size_t whole = mesh.parts.size();
    if (!program.reads(glsl::System::face_index)) return elements(0, mesh.count, whole);
    if (mesh.parts.empty()) {  // face 0, whatever the last mesh ended with
        face(0);
        return elements(0, mesh.count, whole);
    }
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        face(mesh.parts[i].face_index);
        elements(mesh.parts[i].first, mesh.parts[i].count, i);
    }
}

// White axes of length 1.5 with their letters, about three pixels wide, turning with the scene. A dark edge of a pixel
// makes them readable on white, too.

namespace {

using Point = std::array<float, 3>;

content::Mesh axes_mesh() {
    content::Mesh mesh;
    mesh.topology = Topology::lines;
    const auto line = [&mesh](Point a, Point b) {
        for (const Point& p : {a, b}) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(p);
        }
    };
    constexpr float length = 1.5F, gap = 1.6F, half = .05F, high = .1F;
    line({0, 0, 0}, {length, 0, 0});
    line({0, 0, 0}, {0, length, 0});
    line({0, 0, 0}, {0, 0, length});
    line({gap - half, -high, 0}, {gap + half, high, 0});  // X
    line({gap - half, high, 0}, {gap + half, -high, 0});
    line({-half, gap + 2 * high, 0}, {0, gap + high, 0});  // Y
    line({half, gap + 2 * high, 0}, {0, gap + high, 0});
    line({0, gap + high, 0}, {0, gap, 0});
    line({-half, high, gap}, {half, high, gap});  // Z
    line({half, high, gap}, {-half, -high, gap});
    line({-half, -high, gap}, {half, -high, gap});
    mesh.compute_bounds();
    return mesh;
}

}  // namespace

void Runtime::Impl::ready_axes() {
    if (!axes) axes = runtime::upload(axes_mesh());
}

void Runtime::Impl::draw_axes(const Frame& frame, const Surface& surface) {
    runtime::aim(surface);
    const Camera camera = window_camera(plan.scene);
    runtime::DrawContext context;
    context.view = eye_from_world(camera, frame.view);
    const Lens lens = lens_of(camera, frame.view.projection, context.view);
    context.scene = lens.shift * about_origin(frame.view.scene, camera, context.view);
    context.width = surface.width;
    context.height = surface.height;
    const double aspect = static_cast<double>(surface.width) / surface.height;
    context.projection = projection_matrix(lens.camera, aspect, fitted_depth(frame)) * context.scene;
    state.forget();
    const double width = std::max(1., 3. / frame.enlarged), edge = std::max(.5, 1. / frame.enlarged);
    const runtime::Variant variant{false, caps.max_line_width < 5};
    auto& slot = programs[{none, variant}];
    if (!slot) slot = runtime::link_builtin(variant, caps, store.get(), counters);
    runtime::LinkedProgram& builtin = *slot;
    state.program(builtin.program.get());
    state.vertex_array(axes->array.get());
    // The edges of all come first, and hide no line.
    for (const bool line : {false, true}) {
        RasterState raster;
        raster.depth_write = line;
        raster.line_width = context.line_width = line ? width : width + 2 * edge;
        state.raster(raster, true);
        counters.uniform_uploads += static_cast<std::uint64_t>(runtime::set_system(builtin, context));
        const float white = line ? 1 : 0;
        state.color({white, white, white, 1});
        runtime::draw_elements(GL_LINES, *axes, 0, axes->count);
        ++counters.draws;
    }
}

}  // namespace snell
