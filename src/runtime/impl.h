// What a Runtime holds. Built once by build.cpp; runtime.cpp draws it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "src/gl/target.h"
#include "src/runtime/resources/mesh.h"
#include "src/runtime/resources/program.h"
#include "src/runtime/resources/stages.h"
#include "src/runtime/resources/state.h"
#include "src/runtime/resources/textures.h"
#include "src/runtime/resources/uniforms.h"
#include "src/runtime/runtime.h"

namespace snell {

namespace runtime {

class Picker;

// For all that follows.
inline void aim(const Surface& surface) {
    glBindFramebuffer(GL_FRAMEBUFFER, surface.framebuffer);
    const PixelRect part = surface.part.value_or(PixelRect{});
    glViewport(-part.left, -part.bottom, surface.width, surface.height);
    if (!surface.region) return;
    const auto& [left, bottom, width, height] = *surface.region;
    glEnable(GL_SCISSOR_TEST);
    glScissor(left, bottom, width, height);
}

inline void told(const Frame& frame, const Step& step) {
    if (frame.after) (*frame.after)(step);
}

inline bool hidden(const Frame& frame, Index draw) {
    return frame.hidden && draw < frame.hidden->size() && (*frame.hidden)[draw];
}

struct BoundTexture {
    int unit = 0;  // GL's
    GLenum target = GL_TEXTURE_2D;
    GLuint texture = 0, sampler = 0;
    bool operator==(const BoundTexture&) const = default;
};

// What an element of a sampler reads: a texture of the scene (else none), or noise of so many dimensions (else 0).
struct Sampled {
    const SamplerUniform* sampler = nullptr;
    int element = 0;
    int unit = 0;  // the scene's
    Index texture = none;
    int noise = 0;
};

// A draw that was found possible.
struct ReadyDraw {
    Index draw = none;
    Index mesh = none;
    LinkedProgram* program = nullptr;
    GLenum mode = GL_TRIANGLES;
    int patch_vertices = 0;  // of GL_PATCHES
    std::vector<BoundTexture> textures;
    std::vector<Index> sources;                     // cube maps that what it samples is computed from
    const content::Harmonics* harmonics = nullptr;  // where the program reads them
    std::vector<Index> controls;                    // of the program's uniforms, as LinkedProgram::user
    std::vector<std::vector<Index>> part_controls;  // of those of LinkedProgram::parts
    std::shared_ptr<StageDraw> stages;              // where vertex shaders stand for a geometry stage
    std::shared_ptr<PatchDraw> patches;             // and where they stand for tessellation
};

// An item that reads what another pass renders.
struct Reader {
    Index pass = none;
    std::size_t item = 0;
};

// Items of a pass that one of its views does not show.
struct OutOfView {
    // What it depends on.
    struct Sight {
        Transformation scene, eye;
        std::map<unsigned, Transformation> objects;
        Projection projection = Projection::scene;
        int width = 0, height = 0;
        std::optional<DepthRange> depth;
        bool operator==(const Sight&) const = default;
    };
    std::optional<Sight> sight;  // none: never drawn
    std::vector<bool> items;     // as Pass::items
};

struct ReadyPass {
    bool live = false;    // something reads what it renders
    bool wanted = false;  // or would, for other values
    std::vector<Index> textures;
    int width = 0, height = 0;                     // of off-screen targets
    std::vector<GLenum> remake_mipmaps;            // targets, as `textures`; 0: none
    std::array<std::vector<double>, 6> cube_seen;  // cube: what each face shows, as numbers; empty: never drawn
    int next_face = 0;                             // cube: whose turn it is
    std::vector<std::optional<ReadyDraw>> items;   // as Pass::items; empty where it is a Clear or impossible
    std::optional<std::vector<Reader>> readers;    // off-screen; none: not known yet
    bool needed = true;                            // something that is in view may read it
    bool stale = false;                            // not needed, and so not drawn, since its last turn
    std::array<OutOfView, 6> out_of_view;          // of each face of a cube; else of the first
};

// The value of a uniform that programs were compiled for.
struct Settled {
    Index control;  // of Impl::given
    std::vector<double> values;
};

// What is ready to be drawn with programs for some values, or for any: as the members of Impl of the same names.
struct Form {
    int settled_values = 0;
    std::vector<Settled> stand;
    std::vector<std::vector<SamplerUniform>> dormant;
    std::set<Index> dormant_textures;
    std::vector<ReadyPass> passes;
    bool animated = false, mouse = false;
};

// A form that is being made while nothing changes.
struct Making {
    enum class State : std::uint8_t { linking, drawing, done };
    int number = 0;              // Variant::settled; 0: none was made yet
    std::vector<double> values;  // of all controls, in their order
    State state = State::done;
    std::size_t drawn = 0;  // draws of the window whose programs were used
};

}  // namespace runtime

struct Runtime::Impl {
    Impl(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, Diagnostics& diagnostics,
         const RuntimeOptions& options);

    // build.cpp
    struct Loading {  // what only the building needs
        Diagnostics& diagnostics;
        std::set<const Diagnostics*> reported;  // of `program_problems`
    };
    void prepare(Diagnostics& diagnostics);
    // Compiles the program if it is not there yet, and does not report its problems.
    std::shared_ptr<runtime::LinkedProgram>& made(Index program, const runtime::Variant& variant, Loading& loading);
    std::shared_ptr<runtime::LinkedProgram> compile(Index program, const runtime::Variant& variant,
                                                    Diagnostics& diagnostics);
    void tell(LoadProgress::Stage stage, std::string_view what, std::size_t done, std::size_t of) const {
        if (progress) progress({stage, what, done, of});
    }
    void link_programs(Loading& loading, Declared& declared);
    runtime::LinkedProgram* link(Index program, runtime::Variant variant, Loading& loading);
    // By Scene::passes: whether the window shows something of it. `dormant`: or would, for other values.
    std::vector<bool> live_passes(Loading& loading, bool dormant);
    void find_live_passes(Loading& loading);
    void ready_passes(Loading& loading);
    void load_all();
    std::optional<runtime::ReadyDraw> ready_draw(Index pass, Index draw, Loading& loading);
    runtime::Variant variant_of(Index pass, const Draw& draw) const;
    // As Variant::patch.
    int patch_of(const Draw& draw) const;
    bool match_topology(runtime::ReadyDraw& ready, const runtime::GpuMesh& mesh, Diagnostics& diagnostics);
    void ready_target(Index pass, Diagnostics& diagnostics);

    // bind.cpp
    std::vector<runtime::Sampled> sampled_by(const Draw& draw, const runtime::LinkedProgram& program) const {
        return sampled_by(draw, program.samplers);
    }
    std::vector<runtime::Sampled> sampled_by(const Draw& draw, std::span<const runtime::SamplerUniform> samplers) const;
    // Textures of the scene, and what they are computed from.
    std::vector<Index> read_by(const Draw& draw, const runtime::LinkedProgram& program) const;
    std::vector<Index> read_by(const Draw& draw, std::span<const runtime::SamplerUniform> samplers) const;
    // Null where the texture can be read in that pass, else why not.
    std::optional<Diagnostic> unreadable(const runtime::Sampled& sampled, const Draw& draw, Index pass,
                                         Index index) const;
    // The source of the harmonics that its program reads, if it does; none: there is none.
    Index light_of(const Draw& draw) const;
    // Why they can't be read, if they can't.
    std::optional<Diagnostic> no_harmonics(Index pass, Index index) const;
    // What `program`, which the draw has, would read for other values.
    std::vector<Index> spared_by(const Draw& draw, const runtime::LinkedProgram& program) const;
    bool spares_harmonics(const Draw& draw, const runtime::LinkedProgram& program) const;
    void bind_harmonics(runtime::ReadyDraw& ready, Index pass, Diagnostics& diagnostics);
    void bind_textures(runtime::ReadyDraw& ready, Index pass, Diagnostics& diagnostics);

    // geometry.cpp
    struct LoadedMesh {
        content::Mesh mesh;
        Diagnostics said;
        double milliseconds = 0;
    };
    void preload(Loading& loading);
    void preload_meshes(std::vector<runtime::Job>& jobs);
    LoadedMesh take_mesh(Index mesh, Loading& loading);
    void ready_mesh(Index mesh, std::optional<content::Mesh>& loaded, Loading& loading);
    void ready_stages(runtime::ReadyDraw& ready, const content::Mesh* mesh, Loading& loading);
    // Finds what the drawn frame captured more of than is drawn in time.
    void find_costs();
    void bind_tree(runtime::ReadyDraw& ready, const content::Mesh* mesh, Loading& loading);
    void make_tree(runtime::GpuTree& tree, const content::Mesh& mesh, const std::array<bool, runtime::tree_parts>& read,
                   Index draw, Diagnostics& diagnostics);

    // settle.cpp
    glsl::Settler settler(Index program) const;
    // The uniforms that are active if no value is settled; `linked` may be a program for settled values.
    std::vector<ActiveUniform> general_uniforms(Index program, const runtime::LinkedProgram& linked,
                                                runtime::Variant variant, Loading& loading);
    // Finds `dormant` and `dormant_textures`.
    void find_dormant(Index program, const runtime::LinkedProgram& linked);
    void note_dormant();
    // Says of dormant samplers and harmonics what bind_textures and bind_harmonics would.
    void report_dormant(Index pass, const runtime::ReadyDraw& ready, Diagnostics& diagnostics) const;
    // The program that the draw is drawn with, or would be in a pass that is not live; null where it failed.
    runtime::LinkedProgram* program_of(Index pass, const Draw& draw) const;
    // Links a program for one value, or links none as nothing reads it, and notes LinkedProgram::alone.
    bool link_alone();
    std::shared_ptr<runtime::LinkedProgram> link_for(Index pass, const Draw& draw, std::vector<glsl::Settled> values);
    std::vector<const Control*> without_effect(double seconds) const;
    // The values are those that the programs were compiled for.
    bool stands(const Controls& controls) const;
    void find_stand();
    // Of `forms`, the one whose values these are, or that of any values, becomes the current one. False: there is none.
    bool take_form(const Controls& controls);
    void exchange(runtime::Form& other);
    bool specialise(const Frame& frame, const Surface& surface);
    bool link_next();
    void warm_next(const Frame& frame, const Surface& surface);
    void forget_forms();
    void drop_form();

    // build.cpp
    bool choose(const Rungs& rungs);
    // Chooses the rungs of a frame's controls, and makes `values` of them.
    void take(const Controls& controls);
    std::vector<Index> controls_of(Index program, const runtime::LinkedProgram& linked) const;
    // Parts of pictures need other programs, where these ask for places in the picture.
    void take_parts(bool wanted);
    Rungs rungs_of(Index program) const;
    runtime::LinkedProgram* link_chosen(Index program, runtime::Variant variant, Loading& loading);

    // runtime.cpp
    // Where a pass looks from. Off-screen cube faces replace the scene's camera.
    struct PassView {
        int width = 1, height = 1;
        Vec4 background{0, 0, 0, 1};
        const glm::dmat4* projection = nullptr;  // replaces the draw's camera, with `view`
        const glm::dmat4* view = nullptr;
        std::optional<DepthRange> depth;                 // else the usual
        std::array<double, 2> shift{0, 0};               // of the picture, in pixels
        std::optional<PixelRect> region = std::nullopt;  // see Surface
        // Of the last draw, for the next one through the same camera.
        std::optional<runtime::DrawContext> shared = std::nullopt;
        Index camera = none;
        std::array<float, 3> place{};  // as glsl::System::place
        std::size_t face = 0;          // of a cube
        // As Pass::items: those out of view. Null: all are drawn.
        const std::vector<bool>* out = nullptr;
        bool shows(std::size_t item) const { return !out || !(*out)[item]; }
    };
    void draw(const Frame& frame, const Surface& surface);
    void draw_window(Index pass, const Frame& frame, const Surface& surface, PassView view, bool first);
    void draw_textures(Index pass, const Frame& frame);
    void draw_cube(Index pass, const Frame& frame);
    void draw_face(Index pass, int face, const Frame& frame);
    void finish_pass(Index pass);
    void draw_items(Index pass, const Frame& frame, PassView& view);
    Vec4 draw_color(const runtime::ReadyDraw& ready) const;
    void set_up(const runtime::ReadyDraw& ready, const Frame& frame, PassView& view);
    void draw_one(const runtime::ReadyDraw& ready, const Frame& frame, PassView& view);
    void draw_mesh(const runtime::ReadyDraw& ready);
    PassView window_view(const Frame& frame, const Surface& surface) const;
    // Directly, or by what is computed from it.
    bool reads(const runtime::ReadyDraw& draw, Index rendered) const;
    bool reads_other_passes(const runtime::ReadyPass& pass) const;
    bool redrawn() const;
    void draw_axes(const Frame& frame, const Surface& surface);
    void ready_axes();

    // The draws of the window that were found possible, in their order.
    std::vector<const runtime::ReadyDraw*> window_draws() const;

    // sight.cpp
    // The planes that all draws in the window lie between; none where some program might see the difference, or
    // place its vertices itself.
    std::optional<DepthRange> fitted_depth(const Frame& frame) const;
    std::optional<DepthRange> fit(const Frame& frame) const;
    Drawn drawn(const Frame& frame) const;
    double distance(Index draw, double depth, const Frame& frame, const Surface& surface) const;
    std::vector<double> seen_by(Index pass, const Frame& frame) const;
    Vec4 behind(const Frame& frame) const;
    runtime::DrawContext look(Index camera, const Frame& frame, const PassView& view) const;
    // Stands in `view` until the next call.
    runtime::DrawContext& context(Index draw, const Frame& frame, PassView& view) const;

    const std::vector<bool>* out_of_view(Index pass, const Frame& frame, const PassView& view);
    bool out_of_view(const runtime::ReadyDraw& ready, const Frame& frame, PassView& view) const;
    std::vector<runtime::Reader> readers_of(Index pass) const;
    // Sets ReadyPass::needed of all passes.
    void find_needed(const Frame& frame, const PassView& window);
    // Returns true if an off-screen pass must be drawn. `standing`: it need not be if the last frame drew it.
    bool due(Index pass, bool standing);

    // inspect.cpp
    bool ready_picker(int width, int height);
    void draw_cover(const runtime::ReadyDraw& ready, const Frame& frame, PassView& view, bool depth);
    void pick_window(Index pass, const Frame& frame, PassView& view);
    std::vector<Index> pick(const Frame& frame, int width, int height, PixelRect region);
    void outline(const Frame& frame, const Surface& surface, Index draw, float line);

    Plan plan;
    gl::Caps caps;
    Files* files;
    Sources* sources;
    // By Scene::programs (none: the built-in one) and variant; null where it failed.
    std::map<std::pair<Index, runtime::Variant>, std::shared_ptr<runtime::LinkedProgram>> programs;
    std::map<std::pair<Index, runtime::Variant>, Diagnostics> program_problems;
    std::vector<std::optional<Rungs>> working;            // by Scene::programs: the last rungs that linked
    std::vector<Diagnostic> said;                         // when the runtime was made
    Diagnostics problems;                                 // of the rungs chosen since
    std::vector<std::vector<ActiveUniform>> active;       // by Scene::programs
    Controls given;                                       // the values of the scene's text
    Diagnostics value_problems;                           // of `given`
    std::function<void(Controls&, const Scene&)> settle;  // RuntimeOptions::settle, as long as frames have its values
    int settled_values = 0;                               // Variant::settled of the programs that are drawn
    std::vector<runtime::Settled> stand;                  // the values that the programs were compiled for
    // By Scene::programs: samplers that only programs for other values read.
    std::vector<std::vector<runtime::SamplerUniform>> dormant;
    std::set<Index> dormant_textures;  // which only these read
    std::vector<runtime::Form> forms;  // of other values, the one used last first; exchange() makes one of them current
    runtime::Making making;
    const Controls* values = nullptr;  // of the frame that is drawn, at the places of `given`
    Controls moved;                    // a frame's controls, if they had to be moved to these places
    std::vector<std::shared_ptr<runtime::GpuMesh>> meshes;
    std::map<Index, LoadedMesh> loaded_meshes;             // that were read and not asked for yet
    std::vector<std::shared_ptr<runtime::GpuTree>> trees;  // as `meshes`; what no program reads is not there
    std::optional<runtime::GpuMesh> axes;
    Counters counters;
    // What vertex shaders that stand for other stages capture in the frame that is drawn, by Scene::programs.
    struct Captured {
        std::uint64_t primitives = 0, bytes = 0;
    };
    std::map<Index, Captured> captured;
    std::set<Index> costly;  // programs whose costs were found
    Diagnostics costs;       // that were not told yet
    bool savings = true;
    Watcher progress;
    std::shared_ptr<runtime::Store> store;  // shared with the runtimes that this one took over from
    runtime::Textures textures;
    std::vector<runtime::ReadyPass> passes;
    std::map<std::vector<Index>, std::vector<gl::TextureTarget>> targets;  // by the textures rendered to
    struct Fitted {
        View view;  // what it depends on
        std::optional<DepthRange> planes;
    };
    mutable std::optional<Fitted> fitted;     // none: what is drawn is another
    std::shared_ptr<runtime::Picker> picker;  // from the first pick on
    runtime::State state;
    std::optional<gl::AnySamples> samples;  // while draws of the window are watched
    bool animated = false, mouse = false;
    bool timed = false;   // as animated, with any values
    bool settled = true;  // as of the last frame
    bool parts = false;   // programs are those for parts of pictures
};

}  // namespace snell
