// The handlers of the commands, which change the display list: one function for each row of the table.
#pragma once

namespace snell {
class Builder;
class Arguments;
}  // namespace snell

namespace snell::handle {

// View
void window_size(Builder&, const Arguments&);
void ortho(Builder&, const Arguments&);
void perspective(Builder&, const Arguments&);
void look_at(Builder&, const Arguments&);
void background(Builder&, const Arguments&);
void output(Builder&, const Arguments&);
void clear(Builder&, const Arguments&);

// Transformations
void translate(Builder&, const Arguments&);
void rotate(Builder&, const Arguments&);
void scale(Builder&, const Arguments&);
void push_matrix(Builder&, const Arguments&);
void pop_matrix(Builder&, const Arguments&);

// State of draws
void color(Builder&, const Arguments&);
void line_width(Builder&, const Arguments&);
void point_size(Builder&, const Arguments&);
void point_size_mode(Builder&, const Arguments&);
void flat(Builder&, const Arguments&);
void smooth(Builder&, const Arguments&);
void clamp(Builder&, const Arguments&);
void blend(Builder&, const Arguments&);
void cull_face(Builder&, const Arguments&);
void depth_test(Builder&, const Arguments&);
void depth_write(Builder&, const Arguments&);
void wireframe(Builder&, const Arguments&);

// Geometry
void sphere(Builder&, const Arguments&);
void torus(Builder&, const Arguments&);
void cone(Builder&, const Arguments&);
void cylinder(Builder&, const Arguments&);
void box(Builder&, const Arguments&);
void teapot(Builder&, const Arguments&);
void disk_xy(Builder&, const Arguments&);
void quad_xy(Builder&, const Arguments&);
void quad_xz(Builder&, const Arguments&);
void quad_yz(Builder&, const Arguments&);
void quad_box(Builder&, const Arguments&);
void soccerball(Builder&, const Arguments&);
void point_cloud(Builder&, const Arguments&);
void jitter_cloud(Builder&, const Arguments&);
void xarrow(Builder&, const Arguments&);
void wire_sphere(Builder&, const Arguments&);
void wire_torus(Builder&, const Arguments&);
void wire_cone(Builder&, const Arguments&);
void wire_cylinder(Builder&, const Arguments&);
void wire_box(Builder&, const Arguments&);
void wire_teapot(Builder&, const Arguments&);
void obj(Builder&, const Arguments&);
void obj_adj(Builder&, const Arguments&);
void obj_patch(Builder&, const Arguments&);
void wire_obj(Builder&, const Arguments&);
void shp(Builder&, const Arguments&);
void lines_adjacency(Builder&, const Arguments&);
void triangles(Builder&, const Arguments&);
void gl_begin(Builder&, const Arguments&);
void gl_end(Builder&, const Arguments&);
void gl_vertex(Builder&, const Arguments&);
void gl_normal(Builder&, const Arguments&);
void gl_tex_coord(Builder&, const Arguments&);
void num_patch_vertices(Builder&, const Arguments&);

// Textures
void texture_1d(Builder&, const Arguments&);
void texture_2d(Builder&, const Arguments&);
void texture_3d(Builder&, const Arguments&);
void cube_map(Builder&, const Arguments&);
void filter(Builder&, const Arguments&);
void noise_2d(Builder&, const Arguments&);
void noise_3d(Builder&, const Arguments&);
void render_to_texture(Builder&, const Arguments&);
void render_to_cube(Builder&, const Arguments&);
void irradiance(Builder&, const Arguments&);
void prefilter(Builder&, const Arguments&);

// Programs
void vertex(Builder&, const Arguments&);
void tess_control(Builder&, const Arguments&);
void tess_evaluation(Builder&, const Arguments&);
void geometry(Builder&, const Arguments&);
void fragment(Builder&, const Arguments&);
void geometry_input(Builder&, const Arguments&);
void geometry_output(Builder&, const Arguments&);
void program(Builder&, const Arguments&);
void gstap(Builder&, const Arguments&);
void ladder(Builder&, const Arguments&);

// Other
void timer(Builder&, const Arguments&);
void message_box(Builder&, const Arguments&);
void verbose(Builder&, const Arguments&);
void include(Builder&, const Arguments&);

}  // namespace snell::handle
