// Everything that draws.
#include <algorithm>

#include "parser/commands/handlers.h"
#include "parser/read/builder.h"
#include "parser/read/match.h"
#include "parser/text/diagnostic.h"
#include "parser/text_of.h"
#include "parser/vectors.h"

namespace snell::handle {
namespace {

constexpr int most_patch_vertices = 32;  // the least that OpenGL promises

Sphere sphere_of(const Arguments& a) { return {a.number(0), a.integer(1), a.integer(2)}; }

Torus torus_of(const Arguments& a) { return {a.number(0), a.number(1), a.integer(2), a.integer(3)}; }

Cone cone_of(const Arguments& a) { return {a.number(0), a.number(1), a.integer(2), a.integer(3)}; }
Cylinder cylinder_of(const Arguments& a) { return {a.number(0), a.number(1), a.integer(2), a.integer(3)}; }
Box box_of(const Arguments& a) { return {a.number(0), a.number(1), a.number(2)}; }

void quad(Builder& b, const Arguments& a, Plane plane) {
    b.draw(Quad{plane, a.number(0), a.number(1), a.integer(2), a.integer(3)}, a.span());
}

void cloud(Builder& b, const Arguments& a, bool jitter) {
    b.draw(PointCloud{a.integer(0), a.integer(1), a.integer(2), jitter}, a.span());
}

void obj(Builder& b, const Arguments& a, ObjAs as, bool wire) {
    b.draw(ObjFile{b.file(a.text(0), a.span(0)), as}, a.span(), wire);
}

// The unit normal of a triangle; +Z when it has none.
Vec3 flat_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 u = difference(b, a), v = difference(c, a);
    const double scale = std::max(largest(u), largest(v));
    if (scale == 0) return {0, 0, 1};
    const Vec3 n = cross(divided(u, scale), divided(v, scale));
    return length(n) == 0 ? Vec3{0, 0, 1} : divided(n, length(n));
}

void list_of(Builder& b, const Arguments& a, Topology topology, const Vec3& normal) {
    VertexListData data;
    data.topology = topology;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec3 p = a.vec3(i);
        data.vertices.push_back({{p[0], p[1], p[2], 1}, normal, {}, {1, 1, 1, 1}});
    }
    b.draw(VertexList{b.add_list(std::move(data))}, a.span());
}

bool outside_list(Builder& b, const Arguments& a, std::string_view name) {
    if (b.in_list()) return false;
    b.report().error("outside-begin", a.span(),
                     "'" + std::string(name) + "' is only allowed between glBegin and glEnd");
    return true;
}

}  // namespace

void sphere(Builder& b, const Arguments& a) { b.draw(sphere_of(a), a.span()); }
void torus(Builder& b, const Arguments& a) { b.draw(torus_of(a), a.span()); }
void cone(Builder& b, const Arguments& a) { b.draw(cone_of(a), a.span()); }
void cylinder(Builder& b, const Arguments& a) { b.draw(cylinder_of(a), a.span()); }
void box(Builder& b, const Arguments& a) { b.draw(box_of(a), a.span()); }
void teapot(Builder& b, const Arguments& a) { b.draw(Teapot{}, a.span()); }
void wire_sphere(Builder& b, const Arguments& a) { b.draw(sphere_of(a), a.span(), true); }
void wire_torus(Builder& b, const Arguments& a) { b.draw(torus_of(a), a.span(), true); }
void wire_cone(Builder& b, const Arguments& a) { b.draw(cone_of(a), a.span(), true); }
void wire_cylinder(Builder& b, const Arguments& a) { b.draw(cylinder_of(a), a.span(), true); }
void wire_box(Builder& b, const Arguments& a) { b.draw(box_of(a), a.span(), true); }
void wire_teapot(Builder& b, const Arguments& a) { b.draw(Teapot{}, a.span(), true); }

void disk_xy(Builder& b, const Arguments& a) {
    b.draw(Disk{a.number(0), a.number(1), a.integer(2), a.integer(3)}, a.span());
}

void quad_xy(Builder& b, const Arguments& a) { quad(b, a, Plane::xy); }
void quad_xz(Builder& b, const Arguments& a) { quad(b, a, Plane::xz); }
void quad_yz(Builder& b, const Arguments& a) { quad(b, a, Plane::yz); }
void quad_box(Builder& b, const Arguments& a) { b.draw(QuadBox{a.integer(0)}, a.span()); }
void soccerball(Builder& b, const Arguments& a) { b.draw(Soccerball{a.number(0)}, a.span()); }
void point_cloud(Builder& b, const Arguments& a) { cloud(b, a, false); }
void jitter_cloud(Builder& b, const Arguments& a) { cloud(b, a, true); }
void xarrow(Builder& b, const Arguments& a) { b.draw(Xarrow{a.integer(0)}, a.span()); }
void obj(Builder& b, const Arguments& a) { obj(b, a, ObjAs::triangles, false); }
void obj_adj(Builder& b, const Arguments& a) { obj(b, a, ObjAs::adjacency, false); }
void obj_patch(Builder& b, const Arguments& a) { obj(b, a, ObjAs::patches, false); }
void wire_obj(Builder& b, const Arguments& a) { obj(b, a, ObjAs::triangles, true); }
void shp(Builder& b, const Arguments& a) { b.draw(ShpFile{b.file(a.text(0), a.span(0))}, a.span()); }

void lines_adjacency(Builder& b, const Arguments& a) { list_of(b, a, Topology::lines_adjacency, {0, 0, 1}); }

void triangles(Builder& b, const Arguments& a) {
    list_of(b, a, Topology::triangles, flat_normal(a.vec3(0), a.vec3(1), a.vec3(2)));
}

void gl_begin(Builder& b, const Arguments& a) {
    const std::optional<Topology> topology = topology_named(a.text(0));
    if (!topology) {
        const std::string_view near = nearest(a.text(0), topology_names());
        Diagnostic& said = b.report().error(
            "unknown-topology", a.span(0), "'" + std::string(a.text(0)) + "' is not a kind of primitive",
            near.empty() ? "gl_patches, gl_points, gl_lines, gl_triangles and others are"
                         : "did you mean '" + std::string(near) + "'?");
        if (!near.empty()) said.fixes.push_back({a.span(0), std::string(near)});
    }
    b.begin_list(topology, a.span());
}

void gl_end(Builder& b, const Arguments& a) { b.end_list(a.span()); }

void gl_vertex(Builder& b, const Arguments& a) {
    if (outside_list(b, a, "glVertex")) return;
    if (VertexListData* list = b.open_list())
        list->vertices.push_back({{a.number(0), a.number(1), a.number(2), a.number(3)},
                                  b.normal,
                                  b.texcoord,
                                  list->has_color ? b.color() : Vec4{1, 1, 1, 1}});
}

void gl_normal(Builder& b, const Arguments& a) { b.normal = {a.number(0), a.number(1), a.number(2)}; }
void gl_tex_coord(Builder& b, const Arguments& a) { b.texcoord = {a.number(0), a.number(1), a.number(2)}; }

void num_patch_vertices(Builder& b, const Arguments& a) {
    if (a.integer(0) < 1 || a.integer(0) > most_patch_vertices) {
        b.report().error(
            "size-out-of-range", a.span(0),
            "a patch has 1 to " + std::to_string(most_patch_vertices) + " vertices: the number is left as it was");
        return;
    }
    b.patch_vertices = a.integer(0);
}

}  // namespace snell::handle
