// The names of glsl.h: what translated shaders call the things that the runtime provides.
#include <array>
#include <iterator>

#include "src/glsl/glsl.h"

namespace snell::glsl {

std::vector<AttributeName> attribute_names() {
    using enum Attribute;
    return {
        {"snell_Vertex", vertex},
        {"snell_Normal", normal},
        {"snell_Color", color},
        {"snell_MultiTexCoord0", texcoord},
        {"snell_Tangent", tangent},
        {"snell_SecondaryColor", secondary_color},
        {"snell_FogCoord", fog_coord},
        {"snell_VertexId", vertex_id},
        {"aVertex", vertex},
        {"aNormal", normal},
        {"aColor", color},
        {"aTexCoord0", texcoord},
        {"aTexCoord1", texcoord},
        {"aTexCoord2", texcoord},
        {"aTexCoord3", texcoord},
        {"aTexCoord4", texcoord},
        {"aTexCoord5", texcoord},
        {"aTexCoord6", texcoord},
        {"aTexCoord7", texcoord},
        {"aTangent", tangent},
        {"Tangent", tangent},
        {"position", vertex},
        {"i_position", vertex},
        {"a_position", vertex},
        {"aPosition", vertex},
        {"aPos", vertex},
        {"in_position", vertex},
        {"vertexPosition", vertex},
        {"normal", normal},
        {"i_normal", normal},
        {"a_normal", normal},
        {"in_normal", normal},
        {"vertexNormal", normal},
        {"color", color},
        {"i_color", color},
        {"a_color", color},
        {"in_color", color},
        {"vertexColor", color},
        {"texCoord", texcoord},
        {"texCoord0", texcoord},
        {"i_texcoord", texcoord},
        {"i_texCoord", texcoord},
        {"a_texcoord", texcoord},
        {"a_texCoord", texcoord},
        {"aTexCoord", texcoord},
        {"aTexCoords", texcoord},
        {"in_texcoord", texcoord},
        {"tangent", tangent},
        {"i_tangent", tangent},
        {"a_tangent", tangent},
    };
}

namespace {

// A row for every attribute, in their order.
constexpr std::array<AttributeFacts, attribute_count> attributes{{
    {Attribute::vertex, "snell_Vertex", "vec4", 4, "model", "", "Position."},
    {Attribute::normal, "snell_Normal", "vec3", 3, "model", "", "Normal. Shapes have normals of unit length."},
    {Attribute::color, "snell_Color", "vec4", 4, "", "",
     "Colour of the vertex, or of the statement `Color`: red, green, blue, alpha."},
    {Attribute::texcoord, "snell_MultiTexCoord0", "vec4", 4, "texture coordinates", "",
     "Texture coordinates s, t, p, and 1. 0, 0, 0, 1 if the mesh has none."},
    {Attribute::tangent, "snell_Tangent", "vec3", 3, "model", "", "Tangent: the direction in which s increases."},
    {Attribute::secondary_color, "snell_SecondaryColor", "vec4", 4, "", "0 0 0 1", "Constant: scenes do not set it."},
    {Attribute::fog_coord, "snell_FogCoord", "float", 1, "", "0", "Constant: scenes do not set it."},
    {Attribute::vertex_id, "snell_VertexId", "float", 1, "", "", "Number of the vertex, for the translator."},
}};

// A row for every System, in their order.
constexpr SystemFacts systems[]{
    {System::model_view, "mat4", "model to eye", "",
     "View matrix times model matrix: the `LookAt` and transformations of the scene, and the rotation of the eye in "
     "the window."},
    {System::projection, "mat4", "eye to clip", "",
     "`Perspective` or `Ortho` times the rotation of the scene in the window."},
    {System::model_view_projection, "mat4", "model to clip", "", "Projection matrix times model-view matrix."},
    {System::normal_matrix, "mat3", "model to eye", "",
     "Transpose of the inverse of the model-view matrix, for normals."},
    {System::model_view_inverse, "mat4", "eye to model", "",
     "Inverse of the model-view matrix. Zero if there is no inverse."},
    {System::projection_inverse, "mat4", "clip to eye", "",
     "Inverse of the projection matrix. Zero if there is no inverse."},
    {System::model_view_projection_inverse, "mat4", "clip to model", "",
     "Inverse of the model-view-projection matrix. Zero if there is no inverse."},
    {System::model_view_transpose, "mat4", "", "", "Transpose of the model-view matrix."},
    {System::projection_transpose, "mat4", "", "", "Transpose of the projection matrix."},
    {System::model_view_projection_transpose, "mat4", "", "", "Transpose of the model-view-projection matrix."},
    {System::model_view_inverse_transpose, "mat4", "", "", "Transpose of the inverse of the model-view matrix."},
    {System::projection_inverse_transpose, "mat4", "", "", "Transpose of the inverse of the projection matrix."},
    {System::model_view_projection_inverse_transpose, "mat4", "", "",
     "Transpose of the inverse of the model-view-projection matrix."},
    {System::texture_matrix, "mat4", "texture coordinates", "",
     "Element 0 is the texture transformation of the window, the others are the identity."},
    {System::texture_matrix_inverse, "mat4", "texture coordinates", "", "Inverses of the texture matrices."},
    {System::texture_matrix_transpose, "mat4", "", "", "Transposes of the texture matrices."},
    {System::texture_matrix_inverse_transpose, "mat4", "", "", "Transposes of the inverses of the texture matrices."},
    {System::model, "mat4", "model to world", "",
     "The transformations of the scene before the draw, and those of a picked object."},
    {System::view, "mat4", "world to eye", "",
     "`LookAt`, or the view of a face of `RenderToCube`, and the rotation of the eye in the window."},
    {System::view_projection, "mat4", "world to clip", "", "Projection matrix times view matrix."},
    {System::model_inverse, "mat4", "world to model", "", "Inverse of the model matrix. Zero if there is no inverse."},
    {System::view_inverse, "mat4", "eye to world", "", "Inverse of the view matrix. Zero if there is no inverse."},
    {System::model_normal_matrix, "mat3", "model to world", "",
     "Transpose of the inverse of the model matrix, for normals."},
    {System::model_viewer, "mat4", "model to world, relative to the viewer", "",
     "Gives the vector from the viewer to a point of the model, along the axes of the world. Exact to float rounding "
     "wherever the scene is, unlike the difference of `M * position` and `camWorldPos`, which loses digits far from "
     "the origin."},
    {System::camera_position, "vec3", "world", "",
     "Position of the viewer, with the rotation of the scene in the window."},
    {System::viewer_position_eye, "vec3", "eye", "",
     "Position of the viewer, with the rotation of the scene in the window; the origin if the scene is not rotated."},
    {System::normal_scale, "float", "", "above 0",
     "Factor that gives normals unit length again after a uniform scale."},
    {System::timer, "float", "", "0 to 1, without 1",
     "Phase of the animation: runs from 0 to 1 in the period of the statement `Timer` (default: 10 s), repeatedly."},
    {System::time, "float", "", "seconds", "Time of the animation, in seconds."},
    {System::resolution, "vec2", "pixels", "1 and above",
     "Width and height of the picture, or of the texture that is drawn to."},
    {System::mouse, "vec2", "pixels", "0 to the size of the picture",
     "Pointer position on the picture, from its lower left corner; 0, 0 before the pointer was there."},
    {System::noise2, "sampler2D", "texture coordinates", "0 to 1",
     "Four octaves of gradient noise, one in each of the channels r, g, b and a, coarse to fine. The mean is 127/255, "
     "and the texture repeats. `Noise2D` sets its size."},
    {System::noise3, "sampler3D", "texture coordinates", "0 to 1",
     "Four octaves of gradient noise, one in each of the channels r, g, b and a, coarse to fine. The mean is 127/255, "
     "and the texture repeats. `Noise3D` sets its size."},
    {System::face_index, "int", "", "0 to 31",
     "Number of the face of a `Soccerball`: 0 to 11 are pentagons, 12 to 31 hexagons. 0 for other shapes."},
    {System::point_size, "float", "pixels", "above 0", "`PointSize` of the scene."},
    {System::fixed_point_size, "float", "pixels", "0: not replaced",
     "Size that replaces the one that the shader writes."},
    {System::line_width, "float", "pixels", "above 0", "`LineWidth` of the scene."},
    {System::viewport, "vec2", "pixels", "1 and above", "Width and height of the picture, for widened lines."},
    {System::place, "vec3", "pixels", "0 and above",
     "Position of the part of the picture that is drawn, from the left, the bottom and the top."},
    {System::harmonics, "vec3", "world", "",
     "Nine spherical harmonics (r, g, b) of the light of the cube map in the last `Irradiance`, for "
     "`snellIrradianceHarmonics`: declare `uniform vec3 uHarmonics[9]`. Black without `Irradiance`."},
};

// A name without documentation does not compile.
template <typename Facts>
consteval bool documented(const Facts& facts, auto number) {
    for (std::size_t i = 0; i < std::size(facts); ++i)
        if (number(facts[i]) != i || facts[i].type.empty() || facts[i].doc.empty()) return false;
    return true;
}
static_assert(documented(attributes, [](const AttributeFacts& f) { return static_cast<std::size_t>(f.attribute); }));
static_assert(std::size(systems) == static_cast<std::size_t>(System::harmonics) + 1 &&
              documented(systems, [](const SystemFacts& f) { return static_cast<std::size_t>(f.system); }));

struct Meaning {
    std::string_view name;
    System system;
};

constexpr Meaning legacy_systems[] = {
    {"snell_ModelViewMatrix", System::model_view},
    {"snell_ProjectionMatrix", System::projection},
    {"snell_ModelViewProjectionMatrix", System::model_view_projection},
    {"snell_NormalMatrix", System::normal_matrix},
    {"snell_ModelViewMatrixInverse", System::model_view_inverse},
    {"snell_ProjectionMatrixInverse", System::projection_inverse},
    {"snell_ModelViewProjectionMatrixInverse", System::model_view_projection_inverse},
    {"snell_ModelViewMatrixTranspose", System::model_view_transpose},
    {"snell_ProjectionMatrixTranspose", System::projection_transpose},
    {"snell_ModelViewProjectionMatrixTranspose", System::model_view_projection_transpose},
    {"snell_ModelViewMatrixInverseTranspose", System::model_view_inverse_transpose},
    {"snell_ProjectionMatrixInverseTranspose", System::projection_inverse_transpose},
    {"snell_ModelViewProjectionMatrixInverseTranspose", System::model_view_projection_inverse_transpose},
    {"snell_TextureMatrix", System::texture_matrix},
    {"snell_TextureMatrixInverse", System::texture_matrix_inverse},
    {"snell_TextureMatrixTranspose", System::texture_matrix_transpose},
    {"snell_TextureMatrixInverseTranspose", System::texture_matrix_inverse_transpose},
    {"snell_NormalScale", System::normal_scale},
    {"snell_PointSize", System::point_size},
    {"snell_FixedPointSize", System::fixed_point_size},
    {"snell_LineWidth", System::line_width},
    {"snell_Viewport", System::viewport},
    {"snell_Place", System::place},
};

constexpr Meaning modern_systems[] = {
    // glman's own
    {"Timer", System::timer},
    {"Noise2", System::noise2},
    {"Noise3", System::noise3},
    {"FaceIndex", System::face_index},
    {"uTime", System::time},
    {"uResolution", System::resolution},
    {"uMouse", System::mouse},
    {"uHarmonics", System::harmonics},
    // GSTAP
    {"uModelViewMatrix", System::model_view},
    {"uProjectionMatrix", System::projection},
    {"uModelViewProjectionMatrix", System::model_view_projection},
    {"uNormalMatrix", System::normal_matrix},
    {"uModelViewMatrixInverse", System::model_view_inverse},
    {"uProjectionMatrixInverse", System::projection_inverse},
    {"uModelViewProjectionMatrixInverse", System::model_view_projection_inverse},
    // the letters of lecture notes
    {"PVM", System::model_view_projection},
    {"MVP", System::model_view_projection},
    {"VM", System::model_view},
    {"MV", System::model_view},
    {"VP", System::view_projection},
    {"PV", System::view_projection},
    {"M", System::model},
    {"V", System::view},
    {"P", System::projection},
    {"camWorldPos", System::camera_position},
    // u_snake_case
    {"u_model_mat", System::model},
    {"u_view_mat", System::view},
    {"u_proj_mat", System::projection},
    {"u_viewProj_mat", System::view_projection},
    {"u_modelView_mat", System::model_view},
    {"u_modelViewProj_mat", System::model_view_projection},
    {"u_normal_mat", System::normal_matrix},
    {"u_camera_position", System::camera_position},
    {"u_cameraPosition", System::camera_position},
    // camelCase
    {"modelMatrix", System::model},
    {"viewMatrix", System::view},
    {"projectionMatrix", System::projection},
    {"modelViewMatrix", System::model_view},
    {"modelViewProjectionMatrix", System::model_view_projection},
    {"viewProjectionMatrix", System::view_projection},
    {"normalMatrix", System::normal_matrix},
    {"cameraPosition", System::camera_position},
    {"model", System::model},
    {"view", System::view},
    {"projection", System::projection},
    {"mvp", System::model_view_projection},
    {"uModelMatrix", System::model},
    {"uViewMatrix", System::view},
    {"uViewProjectionMatrix", System::view_projection},
    {"uCameraPosition", System::camera_position},
    // snell's own
    {"uModelMatrixInverse", System::model_inverse},
    {"uViewMatrixInverse", System::view_inverse},
    {"uModelNormalMatrix", System::model_normal_matrix},
    {"uViewerPositionEye", System::viewer_position_eye},
    {"uModelViewerMatrix", System::model_viewer},
};

void add_light(std::vector<UniformDefault>& out, int n) {
    const std::string light = "snell_LightSource[" + std::to_string(n) + "].";
    const double lit = n == 0 ? 1 : 0;
    out.push_back({light + "ambient", {0, 0, 0, 1}});
    out.push_back({light + "diffuse", {lit, lit, lit, 1}});
    out.push_back({light + "specular", {lit, lit, lit, 1}});
    out.push_back({light + "position", {0, 0, 1, 0}});
    out.push_back({light + "halfVector", {0, 0, 1, 0}});
    out.push_back({light + "spotDirection", {0, 0, -1}});
    out.push_back({light + "spotExponent", {0}});
    out.push_back({light + "spotCutoff", {180}});
    out.push_back({light + "spotCosCutoff", {-1}});
    out.push_back({light + "constantAttenuation", {1}});
    out.push_back({light + "linearAttenuation", {0}});
    out.push_back({light + "quadraticAttenuation", {0}});
}

// Products of light and material, as OpenGL derives them from the defaults of both.
void add_side(std::vector<UniformDefault>& out, const std::string& side) {
    const std::string material = "snell_" + side + "Material.";
    out.push_back({material + "emission", {0, 0, 0, 1}});
    out.push_back({material + "ambient", {.2, .2, .2, 1}});
    out.push_back({material + "diffuse", {.8, .8, .8, 1}});
    out.push_back({material + "specular", {0, 0, 0, 1}});
    out.push_back({material + "shininess", {0}});
    // emission + ambient of the material x ambient of the light model
    out.push_back({"snell_" + side + "LightModelProduct.sceneColor", {.04, .04, .04, 1}});
    for (int n = 0; n < 8; ++n) {
        const std::string product = "snell_" + side + "LightProduct[" + std::to_string(n) + "].";
        const double diffuse = n == 0 ? .8 : 0;
        out.push_back({product + "ambient", {0, 0, 0, 1}});
        out.push_back({product + "diffuse", {diffuse, diffuse, diffuse, 1}});
        out.push_back({product + "specular", {0, 0, 0, 1}});
    }
}

}  // namespace

std::span<const AttributeFacts, attribute_count> attribute_facts() { return attributes; }

std::span<const SystemFacts> system_facts() { return systems; }

std::vector<SystemName> system_names() {
    std::vector<SystemName> names;
    const auto add = [&](const Meaning& m, bool legacy) {
        names.push_back({m.name, m.system, systems[static_cast<std::size_t>(m.system)].type, legacy});
    };
    for (const Meaning& m : legacy_systems) add(m, true);
    for (const Meaning& m : modern_systems) add(m, false);
    return names;
}

std::vector<UniformDefault> fixed_function_defaults() {
    std::vector<UniformDefault> out;
    for (int n = 0; n < 8; ++n) add_light(out, n);
    add_side(out, "Front");
    add_side(out, "Back");
    out.push_back({"snell_LightModel.ambient", {.2, .2, .2, 1}});
    out.push_back({"snell_Fog.color", {0, 0, 0, 0}});
    out.push_back({"snell_Fog.density", {1}});
    out.push_back({"snell_Fog.start", {0}});
    out.push_back({"snell_Fog.end", {1}});
    out.push_back({"snell_Fog.scale", {1}});
    out.push_back({"snell_Point.size", {1}});
    out.push_back({"snell_Point.sizeMin", {0}});
    out.push_back({"snell_Point.sizeMax", {1}});
    out.push_back({"snell_Point.fadeThresholdSize", {1}});
    out.push_back({"snell_Point.distanceConstantAttenuation", {1}});
    out.push_back({"snell_Point.distanceLinearAttenuation", {0}});
    out.push_back({"snell_Point.distanceQuadraticAttenuation", {0}});
    for (int n = 0; n < 8; ++n) {
        const std::string index = "[" + std::to_string(n) + "]";
        out.push_back({"snell_TextureEnvColor" + index, {0, 0, 0, 0}});
        out.push_back({"snell_ClipPlane" + index, {0, 0, 0, 0}});
        const double s = 1;
        out.push_back({"snell_ObjectPlaneS" + index, {s, 0, 0, 0}});
        out.push_back({"snell_ObjectPlaneT" + index, {0, s, 0, 0}});
        out.push_back({"snell_ObjectPlaneR" + index, {0, 0, 0, 0}});
        out.push_back({"snell_ObjectPlaneQ" + index, {0, 0, 0, 0}});
        out.push_back({"snell_EyePlaneS" + index, {s, 0, 0, 0}});
        out.push_back({"snell_EyePlaneT" + index, {0, s, 0, 0}});
        out.push_back({"snell_EyePlaneR" + index, {0, 0, 0, 0}});
        out.push_back({"snell_EyePlaneQ" + index, {0, 0, 0, 0}});
    }
    return out;
}

}  // namespace snell::glsl
