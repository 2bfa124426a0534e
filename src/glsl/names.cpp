// The names of glsl.h: what translated shaders call the things that the runtime provides.
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

constexpr SystemName legacy_systems[] = {
    {"snell_ModelViewMatrix", System::model_view, "mat4", true},
    {"snell_ProjectionMatrix", System::projection, "mat4", true},
    {"snell_ModelViewProjectionMatrix", System::model_view_projection, "mat4", true},
    {"snell_NormalMatrix", System::normal_matrix, "mat3", true},
    {"snell_ModelViewMatrixInverse", System::model_view_inverse, "mat4", true},
    {"snell_ProjectionMatrixInverse", System::projection_inverse, "mat4", true},
    {"snell_ModelViewProjectionMatrixInverse", System::model_view_projection_inverse, "mat4", true},
    {"snell_ModelViewMatrixTranspose", System::model_view_transpose, "mat4", true},
    {"snell_ProjectionMatrixTranspose", System::projection_transpose, "mat4", true},
    {"snell_ModelViewProjectionMatrixTranspose", System::model_view_projection_transpose, "mat4", true},
    {"snell_ModelViewMatrixInverseTranspose", System::model_view_inverse_transpose, "mat4", true},
    {"snell_ProjectionMatrixInverseTranspose", System::projection_inverse_transpose, "mat4", true},
    {"snell_ModelViewProjectionMatrixInverseTranspose", System::model_view_projection_inverse_transpose, "mat4", true},
    {"snell_TextureMatrix", System::texture_matrix, "mat4", true},
    {"snell_TextureMatrixInverse", System::texture_matrix_inverse, "mat4", true},
    {"snell_TextureMatrixTranspose", System::texture_matrix_transpose, "mat4", true},
    {"snell_TextureMatrixInverseTranspose", System::texture_matrix_inverse_transpose, "mat4", true},
    {"snell_NormalScale", System::normal_scale, "float", true},
    {"snell_PointSize", System::point_size, "float", true},
    {"snell_FixedPointSize", System::fixed_point_size, "float", true},
    {"snell_LineWidth", System::line_width, "float", true},
    {"snell_Viewport", System::viewport, "vec2", true},
    {"snell_Place", System::place, "vec3", true},
};

constexpr SystemName modern_systems[] = {
    // glman's own
    {"Timer", System::timer, "float", false},
    {"Noise2", System::noise2, "sampler2D", false},
    {"Noise3", System::noise3, "sampler3D", false},
    {"FaceIndex", System::face_index, "int", false},
    {"uTime", System::time, "float", false},
    {"uResolution", System::resolution, "vec2", false},
    {"uMouse", System::mouse, "vec2", false},
    {"uHarmonics", System::harmonics, "vec3", false},
    // GSTAP
    {"uModelViewMatrix", System::model_view, "mat4", false},
    {"uProjectionMatrix", System::projection, "mat4", false},
    {"uModelViewProjectionMatrix", System::model_view_projection, "mat4", false},
    {"uNormalMatrix", System::normal_matrix, "mat3", false},
    {"uModelViewMatrixInverse", System::model_view_inverse, "mat4", false},
    {"uProjectionMatrixInverse", System::projection_inverse, "mat4", false},
    {"uModelViewProjectionMatrixInverse", System::model_view_projection_inverse, "mat4", false},
    // the letters of lecture notes
    {"PVM", System::model_view_projection, "mat4", false},
    {"MVP", System::model_view_projection, "mat4", false},
    {"VM", System::model_view, "mat4", false},
    {"MV", System::model_view, "mat4", false},
    {"VP", System::view_projection, "mat4", false},
    {"PV", System::view_projection, "mat4", false},
    {"M", System::model, "mat4", false},
    {"V", System::view, "mat4", false},
    {"P", System::projection, "mat4", false},
    {"camWorldPos", System::camera_position, "vec3", false},
    // u_snake_case
    {"u_model_mat", System::model, "mat4", false},
    {"u_view_mat", System::view, "mat4", false},
    {"u_proj_mat", System::projection, "mat4", false},
    {"u_viewProj_mat", System::view_projection, "mat4", false},
    {"u_modelView_mat", System::model_view, "mat4", false},
    {"u_modelViewProj_mat", System::model_view_projection, "mat4", false},
    {"u_normal_mat", System::normal_matrix, "mat3", false},
    {"u_camera_position", System::camera_position, "vec3", false},
    {"u_cameraPosition", System::camera_position, "vec3", false},
    // camelCase
    {"modelMatrix", System::model, "mat4", false},
    {"viewMatrix", System::view, "mat4", false},
    {"projectionMatrix", System::projection, "mat4", false},
    {"modelViewMatrix", System::model_view, "mat4", false},
    {"modelViewProjectionMatrix", System::model_view_projection, "mat4", false},
    {"viewProjectionMatrix", System::view_projection, "mat4", false},
    {"normalMatrix", System::normal_matrix, "mat3", false},
    {"cameraPosition", System::camera_position, "vec3", false},
    {"model", System::model, "mat4", false},
    {"view", System::view, "mat4", false},
    {"projection", System::projection, "mat4", false},
    {"mvp", System::model_view_projection, "mat4", false},
    {"uModelMatrix", System::model, "mat4", false},
    {"uViewMatrix", System::view, "mat4", false},
    {"uViewProjectionMatrix", System::view_projection, "mat4", false},
    {"uCameraPosition", System::camera_position, "vec3", false},
    // snell's own
    {"uModelMatrixInverse", System::model_inverse, "mat4", false},
    {"uViewMatrixInverse", System::view_inverse, "mat4", false},
    {"uModelNormalMatrix", System::model_normal_matrix, "mat3", false},
    {"uViewerPositionEye", System::viewer_position_eye, "vec3", false},
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

std::vector<SystemName> system_names() {
    std::vector<SystemName> names(std::begin(legacy_systems), std::end(legacy_systems));
    names.insert(names.end(), std::begin(modern_systems), std::end(modern_systems));
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
