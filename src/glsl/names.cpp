// The names of glsl.h: what translated shaders call the things that the runtime provides.
#include <array>
#include <iterator>

#include "parser/text/words.h"
#include "src/glsl/glsl.h"

namespace snell::glsl {

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

// What each is called in shaders: by the translator (snell_…), by glman and GSTAP, in lecture notes, in snake_case and
// in camelCase.
template <typename Meaning>
struct Named {
    Meaning meaning;
    std::string_view names;
};

constexpr Named<Attribute> attribute_words[] = {
    {Attribute::vertex,
     "snell_Vertex aVertex position i_position a_position aPosition aPos in_position vertexPosition"},
    {Attribute::normal, "snell_Normal aNormal normal i_normal a_normal in_normal vertexNormal"},
    {Attribute::color, "snell_Color aColor color i_color a_color in_color vertexColor"},
    {Attribute::texcoord,
     "snell_MultiTexCoord0 aTexCoord0 aTexCoord1 aTexCoord2 aTexCoord3 aTexCoord4 aTexCoord5 aTexCoord6 aTexCoord7 "
     "texCoord texCoord0 i_texcoord i_texCoord a_texcoord a_texCoord aTexCoord aTexCoords in_texcoord"},
    {Attribute::tangent, "snell_Tangent aTangent Tangent tangent i_tangent a_tangent"},
    {Attribute::secondary_color, "snell_SecondaryColor"},
    {Attribute::fog_coord, "snell_FogCoord"},
    {Attribute::vertex_id, "snell_VertexId"},
};

constexpr Named<System> system_words[] = {
    {System::model_view, "snell_ModelViewMatrix uModelViewMatrix VM MV u_modelView_mat modelViewMatrix"},
    {System::projection, "snell_ProjectionMatrix uProjectionMatrix P u_proj_mat projectionMatrix projection"},
    {System::model_view_projection,
     "snell_ModelViewProjectionMatrix uModelViewProjectionMatrix PVM MVP u_modelViewProj_mat modelViewProjectionMatrix "
     "mvp"},
    {System::normal_matrix, "snell_NormalMatrix uNormalMatrix u_normal_mat normalMatrix"},
    {System::model_view_inverse, "snell_ModelViewMatrixInverse uModelViewMatrixInverse"},
    {System::projection_inverse, "snell_ProjectionMatrixInverse uProjectionMatrixInverse"},
    {System::model_view_projection_inverse, "snell_ModelViewProjectionMatrixInverse uModelViewProjectionMatrixInverse"},
    {System::model_view_transpose, "snell_ModelViewMatrixTranspose"},
    {System::projection_transpose, "snell_ProjectionMatrixTranspose"},
    {System::model_view_projection_transpose, "snell_ModelViewProjectionMatrixTranspose"},
    {System::model_view_inverse_transpose, "snell_ModelViewMatrixInverseTranspose"},
    {System::projection_inverse_transpose, "snell_ProjectionMatrixInverseTranspose"},
    {System::model_view_projection_inverse_transpose, "snell_ModelViewProjectionMatrixInverseTranspose"},
    {System::texture_matrix, "snell_TextureMatrix"},
    {System::texture_matrix_inverse, "snell_TextureMatrixInverse"},
    {System::texture_matrix_transpose, "snell_TextureMatrixTranspose"},
    {System::texture_matrix_inverse_transpose, "snell_TextureMatrixInverseTranspose"},
    {System::model, "M u_model_mat modelMatrix model uModelMatrix"},
    {System::view, "V u_view_mat viewMatrix view uViewMatrix"},
    {System::view_projection, "VP PV u_viewProj_mat viewProjectionMatrix uViewProjectionMatrix"},
    {System::model_inverse, "uModelMatrixInverse"},
    {System::view_inverse, "uViewMatrixInverse"},
    {System::model_normal_matrix, "uModelNormalMatrix"},
    {System::model_viewer, "uModelViewerMatrix"},
    {System::camera_position, "camWorldPos u_camera_position u_cameraPosition cameraPosition uCameraPosition"},
    {System::viewer_position_eye, "uViewerPositionEye"},
    {System::normal_scale, "snell_NormalScale"},
    {System::timer, "Timer"},
    {System::time, "uTime"},
    {System::resolution, "uResolution"},
    {System::mouse, "uMouse"},
    {System::noise2, "Noise2"},
    {System::noise3, "Noise3"},
    {System::face_index, "FaceIndex"},
    {System::point_size, "snell_PointSize"},
    {System::fixed_point_size, "snell_FixedPointSize"},
    {System::line_width, "snell_LineWidth"},
    {System::viewport, "snell_Viewport"},
    {System::place, "snell_Place"},
    {System::harmonics, "uHarmonics"},
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

std::vector<AttributeName> attribute_names() {
    std::vector<AttributeName> names;
    for (const auto& [attribute, words] : attribute_words)
        for (const std::string_view name : split(words)) names.push_back({name, attribute});
    return names;
}

std::vector<SystemName> system_names() {
    std::vector<SystemName> names;
    for (const auto& [system, words] : system_words)
        for (const std::string_view name : split(words))
            names.push_back({name, system, systems[static_cast<std::size_t>(system)].type, name.starts_with("snell_")});
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
        for (const std::string plane : {"snell_ObjectPlane", "snell_EyePlane"}) {
            out.push_back({plane + "S" + index, {1, 0, 0, 0}});
            out.push_back({plane + "T" + index, {0, 1, 0, 0}});
            out.push_back({plane + "R" + index, {0, 0, 0, 0}});
            out.push_back({plane + "Q" + index, {0, 0, 0, 0}});
        }
    }
    return out;
}

}  // namespace snell::glsl
