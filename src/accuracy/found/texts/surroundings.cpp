// Light that leaves glass again, and rooms that are near.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/found/texts/texts.h"

namespace snell::accuracy::texts {

namespace {

// The draws of the shader's programs, in all passes.
std::vector<const Draw*> draws_of(const Scene& scene, const Shader& shader) {
    std::vector<const Draw*> own;
    for (const Draw& draw : scene.draws)
        if (shader.programs.contains(draw.program)) own.push_back(&draw);
    return own;
}

bool samples_cube(const glsl::Unit& unit) {
    return ranges::any_of(unit.globals, [](const glsl::Global& g) {
        return g.type.base == glsl::Base::sampler && g.type.name == "samplerCube" && !g.uses.empty();
    });
}

// Light that is bent where it enters a ball is bent where it leaves, too.
void bend_twice(const Scene& scene, const Shader& shader, Offers& to) {
    const std::vector<const Draw*> draws = draws_of(scene, shader);
    const auto ball = [](const Draw* draw) { return std::holds_alternative<Sphere>(draw->shape); };
    if (draws.empty() || !ranges::all_of(draws, ball) || !samples_cube(shader.unit)) return;
    std::vector<Expression> bends;
    bool again = false, used = false;
    for (const int n : shader.expressions()) {
        const Expression e(shader, n);
        if (e.call("refract", 3)) bends.push_back(e);
        for (std::size_t part = 0; e.call() && part < e.size(); ++part) {
            const bool bent = e[part].resolved().call("refract", 3);
            used = used || bent;
            // By the author's own formula, or by a second refract().
            again = again || (bent && e.calls({"dot", "refract", "reflect"}));
        }
    }
    if (bends.empty() || again || !used) return;
    Edits edits;
    const auto include = included(shader, "snell/refraction.glsl");
    if (!include) return;
    std::vector<Span> places;
    for (const Expression& bend : bends) {
        if (!bend[0].same(bends[0][0])) return;
        const auto whole = place_of(shader, bend), name = shader.place(bend.first(), bend.first());
        const Expression ratio = bend[2];
        const auto eta = place_of(shader, ratio);
        if (!whole || !name || !eta) return;
        edits.push_back({*name, "snellRefractSphere"});
        // n1 / n2 as two arguments.
        const auto first = ratio.infix("/") ? place_of(shader, ratio[0]) : std::nullopt;
        const auto second = ratio.infix("/") ? place_of(shader, ratio[1]) : std::nullopt;
        edits.push_back(first && second ? Edit{{eta->file, first->end, second->begin}, ", "} : after(*eta, ", 1."));
        places.push_back(*whole);
    }
    if (adds(*include)) edits.push_back(*include);
    to.add(ChangeKind::both_interfaces, places, std::move(edits));
}

struct Room {
    Vec3 half{}, centre{};
};

bool unmoved(const Scene& scene, const Draw& draw) {
    const Mat4 identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    return draw.matrix == none || scene.matrices[draw.matrix] == identity;
}

// The scene's own room: two walls on each axis, or the largest Box if the eye is in it.
std::optional<Room> room_of(const Scene& scene) {
    Vec3 low{}, high{};
    double largest = 0;
    Room room;
    for (const Draw& draw : scene.draws) {
        if (!unmoved(scene, draw)) continue;
        if (const Quad* quad = std::get_if<Quad>(&draw.shape)) {
            const std::size_t axis = quad->plane == Plane::yz ? 0 : quad->plane == Plane::xz ? 1 : 2;
            low[axis] = std::min(low[axis], quad->offset);
            high[axis] = std::max(high[axis], quad->offset);
        }
        const Box* box = std::get_if<Box>(&draw.shape);
        if (!box || box->dx * box->dy * box->dz <= largest) continue;
        const auto& look = scene.cameras[draw.camera].look_at;
        const Vec3 eye = look ? (*look)[0] : Vec3{}, half{box->dx / 2, box->dy / 2, box->dz / 2};
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) inside = inside && std::abs(eye[i]) < half[i];
        if (!inside) continue;
        largest = box->dx * box->dy * box->dz;
        room.half = half;
    }
    if (largest > 0) return room;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(low[i] < 0) || !(high[i] > 0)) return std::nullopt;
        room.half[i] = (high[i] - low[i]) / 2;
        room.centre[i] = (high[i] + low[i]) / 2;
    }
    return room;
}

// What is mirrored in a room is near: the lookup starts where the surface is.
class NearRoom {
public:
    NearRoom(const Reading& reading, Offers& to, const std::vector<Span>& eye_space)
        : shaders_(reading.shaders), to_(to), eye_space_(eye_space), room_(room_of(reading.plan.scene)) {}

    void run(const Shader& shader) {
        if (!room_ || shader.unit.stage != Stage::fragment || !samples_cube(shader.unit)) return;
        const Shader* vertex = vertex_of(shader);
        const auto outside = vertex ? position(*vertex) : std::nullopt;
        const auto include = included(shader, "snell/environment.glsl");
        if (!outside || !include) return;
        std::vector<Span> lookups;
        int first = -1;
        for (const int n : shader.expressions()) {
            const Expression e(shader, n);
            if (!e.call("texture", 2) && !e.call("textureCube", 2)) continue;
            const auto span = place_of(shader, e[1]);
            if (!e[1].resolved().calls({"reflect", "snellReflect"}) || !span) continue;
            if (ranges::find(eye_space_, *span) != eye_space_.end()) continue;
            if (first < 0) first = e.first();
            lookups.push_back(*span);
        }
        const auto input = lookups.empty() ? std::nullopt : declared(shader, first, declaration(shader, "in"));
        if (!input || !adds(*input)) return;
        Edits edits = *outside;
        edits.push_back(*input);
        if (adds(*include)) edits.push_back(*include);
        const auto vector = [](const Vec3& v) {
            return fmt::format("vec3({}, {}, {})", real_literal(v[0], 5), real_literal(v[1], 5), real_literal(v[2], 5));
        };
        for (const Span& span : lookups) {
            edits.push_back(before(span, "snellBoxDirection(snellPosition, "));
            edits.push_back(after(span, ", " + vector(room_->half) + ", " + vector(room_->centre) + ")"));
        }
        to_.add(ChangeKind::box_projection, lookups, std::move(edits));
    }

private:
    static std::string declaration(const Shader& shader, std::string_view direction) {
        return std::string(varying_word(shader, direction)) + " vec3 snellPosition;";
    }

    // The vertex shader that hands on to it; null if other stages are between, or there are several.
    const Shader* vertex_of(const Shader& fragment) const {
        const Shader* found = nullptr;
        for (const Shader& shader : shaders_) {
            const bool together =
                ranges::any_of(shader.programs, [&](Index p) { return fragment.programs.contains(p); });
            if (!together || &shader == &fragment) continue;
            if (found || shader.unit.stage != Stage::vertex) return nullptr;
            found = &shader;
        }
        return found;
    }

    static bool is_vertex(const glsl::Global& g) {
        const int location = g.qualifiers.layout_number("location");
        if (location >= 0) return location == static_cast<int>(glsl::Attribute::vertex);
        const auto names = glsl::attribute_names();
        return ranges::any_of(names, [&](const glsl::AttributeName& n) {
            return n.name == g.name && n.attribute == glsl::Attribute::vertex;
        });
    }

    // Edits of the vertex shader that hand on the position in the world.
    static std::optional<Edits> position(const Shader& shader) {
        const glsl::Unit& unit = shader.unit;
        std::string vertex = "gl_Vertex";
        for (const glsl::Global& g : unit.globals)
            if (g.qualifiers.storage == glsl::Storage::in && is_vertex(g))
                vertex = g.type.rows == 4 ? std::string(g.name) : fmt::format("vec4({}, 1.)", g.name);
        if (shader.main() < 0) return std::nullopt;
        const int brace = shader.function(shader.main()).open;
        const auto open = shader.place(brace, brace);
        const auto output = declared(shader, brace, declaration(shader, "out"));
        const auto model = declared(shader, brace, "uniform mat4 uModelMatrix;");
        if (!open || !output || !model || !adds(*output)) return std::nullopt;
        Edits edits{*output, after(*open, fmt::format(" snellPosition = vec3(uModelMatrix * {});", vertex))};
        if (adds(*model)) edits.push_back(*model);
        return edits;
    }

    const std::deque<Shader>& shaders_;
    Offers& to_;
    const std::vector<Span>& eye_space_;
    std::optional<Room> room_;
};

}  // namespace

void add_surroundings(const Reading& reading, const std::vector<Span>& eye_space, Offers& to) {
    NearRoom near(reading, to, eye_space);
    for (const Shader& shader : reading.shaders) {
        bend_twice(reading.plan.scene, shader, to);
        near.run(shader);
    }
}

}  // namespace snell::accuracy::texts
