// The handlers of the commands, which change the display list: one function for each row of the table.
#pragma once

namespace snell {
class Builder;
class Arguments;
}  // namespace snell

namespace snell::handle {

using Function = void(Builder&, const Arguments&);

// View
Function window_size, ortho, perspective, look_at, background, output, clear;

// Transformations
Function translate, rotate, scale, push_matrix, pop_matrix;

// State of draws
Function color, line_width, point_size, point_size_mode, flat, smooth, clamp, blend, cull_face, depth_test, depth_write,
    wireframe;

// Geometry
Function sphere, torus, cone, cylinder, box, teapot, disk_xy, quad_xy, quad_xz, quad_yz, quad_box, soccerball,
    point_cloud, jitter_cloud, xarrow, wire_sphere, wire_torus, wire_cone, wire_cylinder, wire_box, wire_teapot, obj,
    obj_adj, obj_patch, wire_obj, shp, lines_adjacency, triangles, gl_begin, gl_end, gl_vertex, gl_normal, gl_tex_coord,
    num_patch_vertices;

// Textures
Function texture_1d, texture_2d, texture_3d, cube_map, filter, noise_2d, noise_3d, render_to_texture, render_to_cube,
    irradiance, prefilter;

// Programs
Function vertex, tess_control, tess_evaluation, geometry, fragment, geometry_input, geometry_output, program, gstap,
    ladder;

// Other
Function timer, message_box, verbose, include;

}  // namespace snell::handle
