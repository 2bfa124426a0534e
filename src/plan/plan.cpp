#include "src/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include <fmt/format.h>
#include <sys/stat.h>

#include "parser/text/ranges.h"
#include "src/content/image/noise.h"
#include "src/plan/locate.h"

namespace snell {
namespace {

class Planner {
public:
    Planner(Plan& plan, Files& files, Sources& sources, Diagnostics& diagnostics)
        : plan_(plan), files_(files), sources_(sources), diagnostics_(diagnostics) {}

    void plan() {
        for (Index program = 0; program < plan_.scene.programs.size(); ++program) plan_program(program);
        plan_meshes();
        plan_textures();
    }

private:
    void plan_program(Index index) {
        const Program& program = plan_.scene.programs[index];
        PlannedProgram planned{index, {}, true};
        bool any = false;
        for (int stage = 0; stage < stage_count; ++stage) {
            const std::optional<FileName>& file = program.stages[static_cast<std::size_t>(stage)];
            if (!file) continue;
            any = true;
            if (const auto text = read_shader(*file, static_cast<Stage>(stage))) {
                planned.stages.push_back({static_cast<Stage>(stage), *text, file->span});
            } else {
                planned.readable = false;
            }
        }
        if (!any) {
            diagnostics_.warning(
                "program-without-shaders", program.span, fmt::format("program '{}' has no shaders", program.name),
                "add 'Vertex' and 'Fragment' statements before it; its draws have the current colour, unlit");
        }
        plan_.programs.push_back(std::move(planned));
    }

    std::optional<FileId> read_shader(const FileName& file, Stage stage) {
        const std::string path = locate(file, stage_extensions(stage), files_, diagnostics_);
        if (path.empty()) return std::nullopt;
        if (const auto known = shaders_.find(path); known != shaders_.end()) return known->second;
        std::string reason;
        std::optional<std::string> text = files_.read(path, reason);
        std::optional<FileId> id;
        if (text) {
            id = sources_.add(path, std::move(*text));
        } else {
            report_unreadable(file, reason, diagnostics_);
        }
        shaders_.emplace(path, id);
        return id;
    }

    void plan_meshes() {
        const Scene& scene = plan_.scene;
        std::unordered_map<std::string, Index> known;
        std::set<Index> missing;
        plan_.draw_mesh.reserve(scene.draws.size());
        for (const Draw& draw : scene.draws) {
            const auto [entry, added] =
                known.try_emplace(shape_key(scene, draw.shape, draw.wire), static_cast<Index>(plan_.meshes.size()));
            if (added) plan_.meshes.push_back({draw.shape, draw.wire, draw.span});
            plan_.draw_mesh.push_back(entry->second);
            // A file that is there is looked for once; one that is missing is missed at every place.
            if ((added || missing.contains(entry->second)) && !has_mesh_file(draw.shape)) missing.insert(entry->second);
        }
    }

    // Whether it needs none, or the one that it needs is there.
    bool has_mesh_file(const Shape& shape) {
        const Index file = file_of(shape);
        if (file >= plan_.scene.files.size()) return true;
        return !locate(plan_.scene.files[file], mesh_extensions(shape), files_, diagnostics_).empty();
    }

    void plan_textures() {
        const std::vector<Texture>& textures = plan_.scene.textures;
        std::map<std::string, Index> known;
        for (Index index = 0; index < textures.size(); ++index) {
            const Texture& texture = textures[index];
            if (texture.files.empty()) {
                plan_.same_pixels.push_back(index);
                continue;
            }
            std::string key(1, static_cast<char>(texture.target));
            for (const TextureFile& file : locate_texture(texture, files_, diagnostics_))
                (key += file.path.empty() ? file.name : file.path) += '\0';
            plan_.same_pixels.push_back(known.try_emplace(std::move(key), index).first->second);
        }
    }

    Plan& plan_;
    Files& files_;
    Sources& sources_;
    Diagnostics& diagnostics_;
    // By path; nullopt if the file cannot be read, which has been reported.
    std::map<std::string, std::optional<FileId>> shaders_;
};

}  // namespace

Plan make_plan(Scene scene, Files& files, Sources& sources, Diagnostics& diagnostics) {
    Plan plan;
    plan.scene = std::move(scene);
    plan.rungs = marked_rungs(plan.scene);
    Planner(plan, files, sources, diagnostics).plan();
    return plan;
}

// ---- what a draw reads and writes ------------------------------------------------------------------------

Index find_texture(const Scene& scene, const Draw& draw, int unit, TextureTarget target) {
    if (draw.bindings < scene.bindings.size()) {
        const auto& entries = scene.bindings[draw.bindings].entries;
        const auto found = std::find_if(entries.begin(), entries.end(), [&](const Bindings::Entry& entry) {
            return entry.unit == unit && entry.target == target;
        });
        if (found != entries.end()) return found->texture;
    }
    for (std::size_t i = scene.textures.size(); i-- > 0;) {
        if (scene.textures[i].unit == unit && scene.textures[i].target == target) return static_cast<Index>(i);
    }
    return none;
}

std::optional<TextureTarget> sampler_target(std::string_view name, std::string_view type) {
    if (ranges::count(glsl::mesh_samplers, name) > 0) return std::nullopt;
    if (type == "sampler1D" || type == "sampler1DShadow") return TextureTarget::d1;
    if (type == "sampler2D" || type == "sampler2DShadow") return TextureTarget::d2;
    if (type == "sampler3D") return TextureTarget::d3;
    if (type == "samplerCube" || type == "samplerCubeShadow") return TextureTarget::cube;
    return std::nullopt;
}

std::optional<Diagnostic> feedback_error(const Scene& scene, Index pass, Index draw, Index texture) {
    if (pass >= scene.passes.size() || draw >= scene.draws.size() || texture >= scene.textures.size())
        return std::nullopt;
    const Pass& target = scene.passes[pass];
    if (target.kind == Pass::Kind::window ||
        std::find(target.textures.begin(), target.textures.end(), texture) == target.textures.end()) {
        return std::nullopt;
    }
    Diagnostic diagnostic;
    diagnostic.code = "feedback-loop";
    diagnostic.span = scene.draws[draw].span;
    diagnostic.message = fmt::format("this draw samples the texture on unit {} while the pass renders to it",
                                     scene.textures[texture].unit);
    diagnostic.help = "render to another texture, or sample this one in a later pass";
    diagnostic.notes.push_back({target.span, "rendering to it begins here"});
    diagnostic.notes.push_back({scene.textures[texture].span, "the texture"});
    return diagnostic;
}

namespace {

int scaled(int count, double factor) {
    return std::clamp(static_cast<int>(std::lround(count * factor)), 3, std::max(count, 2000));
}

// If the shape approximates a round one, multiplies its number of parts by `factor`; returns whether it does.
bool scale(Shape& shape, double factor) {
    bool any = false;
    const auto each = [&](auto& value, bool round) {
        any = any || round;
        if constexpr (std::is_same_v<decltype(value), int&>)
            if (round) value = scaled(value, factor);
    };
    std::visit([&](auto& kind) { for_each_field(kind, each); }, shape);
    return any;
}

}  // namespace

Plan with_knobs(Plan plan, const PlanKnobs& knobs) {
    if (knobs.tessellation != 1) {
        for (MeshRequest& mesh : plan.meshes) scale(mesh.shape, knobs.tessellation);
        for (Draw& draw : plan.scene.draws) scale(draw.shape, knobs.tessellation);
    }
    for (Texture& texture : plan.scene.textures) {
        if (knobs.filter && !texture.files.empty()) texture.filter = *knobs.filter;
        if (texture.target != TextureTarget::cube || texture.computed != Computed::no) continue;
        if (knobs.cube_size > 0) texture.size[0] = knobs.cube_size;
        if (knobs.cube_bits > 0) texture.bits = knobs.cube_bits;
    }
    return plan;
}

bool has_round_shapes(const Scene& scene) {
    return ranges::any_of(scene.draws, [](const Draw& draw) {
        Shape shape = draw.shape;
        return scale(shape, 1);
    });
}

bool has_textures(const Scene& scene) {
    return ranges::any_of(scene.textures, [](const Texture& texture) { return !texture.files.empty(); });
}

bool has_cube_maps(const Scene& scene) {
    return ranges::any_of(scene.textures, [](const Texture& texture) { return texture.target == TextureTarget::cube; });
}

namespace {

// Appends the bytes of values, which must have no padding, to a key.
template <class... Values>
void put(std::string& key, Values... values) {
    (key.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
}

// Adds the file's current size and time. Returns false if it does not exist.
bool put_file(Identity& identity, const std::string& path) {
    struct stat status {};
    if (path.empty() || stat(path.c_str(), &status) != 0) return false;
    identity.key += path;
    identity.key += '\0';
    put(identity.key, status.st_size, status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
    identity.files.push_back(path);
    return true;
}

void put_list(std::string& key, const VertexListData& list) {
    put(key, list.topology, list.patch_vertices, list.has_color);
    for (const ListVertex& vertex : list.vertices)
        put(key, vertex.position, vertex.normal, vertex.texcoord, vertex.color);
}

}  // namespace

Index file_of(const Shape& shape) {
    if (const auto* obj = std::get_if<ObjFile>(&shape)) return obj->file;
    if (const auto* shp = std::get_if<ShpFile>(&shape)) return shp->file;
    return none;
}

std::string shape_key(const Scene& scene, const Shape& shape, bool wire) {
    std::string key;
    put(key, static_cast<std::uint8_t>(shape.index()), wire);
    const auto describe = [&]<class Kind>(const Kind& kind) {
        key += kind.command();
        for_each_field(kind, [&](auto value, bool) {
            if constexpr (std::is_same_v<Kind, ObjFile> || std::is_same_v<Kind, ShpFile>)
                key += value < scene.files.size() ? scene.files[value].name : "";
            else
                put(key, value);
        });
    };
    std::visit(describe, shape);
    return key;
}

Identity mesh_identity(const Plan& plan, Index mesh, const Files& files) {
    if (mesh >= plan.meshes.size()) return {};
    const MeshRequest& request = plan.meshes[mesh];
    const Scene& scene = plan.scene;
    Identity identity{"mesh " + shape_key(scene, request.shape, request.wire), {}};
    if (const auto* list = std::get_if<VertexList>(&request.shape); list && list->list < scene.vertex_lists.size())
        put_list(identity.key, scene.vertex_lists[list->list]);
    const Index file = file_of(request.shape);
    Diagnostics unheard;  // discarded: these are reported when the mesh is loaded
    if (file < scene.files.size() &&
        !put_file(identity, locate(scene.files[file], mesh_extensions(request.shape), files, unheard)))
        return {};
    return identity;
}

std::vector<Span> mesh_places(const Plan& plan, Index mesh) {
    std::vector<Span> places{plan.meshes[mesh].span};
    const Index file = file_of(plan.meshes[mesh].shape);
    if (file < plan.scene.files.size()) places.push_back(plan.scene.files[file].span);
    return places;
}

Identity texture_identity(const Scene& scene, Index index, const Files& files) {
    if (index >= scene.textures.size()) return {};
    const Texture& texture = scene.textures[index];
    Identity identity;
    if (texture.computed != Computed::no) {
        identity = texture_identity(scene, texture.source, files);
        if (identity.key.empty()) return {};
        put(identity.key, 'c', texture.computed, texture.size);
        return identity;
    }
    if (texture.files.empty()) return {};
    put(identity.key, 't', texture.target, texture.bits, texture.encoding == Encoding::srgb);
    Diagnostics unheard;
    for (const TextureFile& file : locate_texture(texture, files, unheard))
        if (file.noise > 0)
            put(identity.key, 'n', file.noise);
        else if (!put_file(identity, file.path))
            return {};
    return identity;
}

std::uint64_t file_bytes(const Scene& scene, Index texture, const Files& files) {
    Diagnostics unheard;
    std::uint64_t bytes = 0;
    for (const TextureFile& file : locate_texture(scene.textures[texture], files, unheard)) {
        struct stat status {};
        if (!file.path.empty() && stat(file.path.c_str(), &status) == 0)
            bytes += static_cast<std::uint64_t>(status.st_size);
    }
    return bytes;
}

Identity noise_identity(int dimensions, int size, const Files& files) {
    Identity identity;
    put(identity.key, 'n', dimensions, size);
    put_file(identity, files.find(content::noise_file_name(dimensions, size)).path);
    return identity;
}

}  // namespace snell
