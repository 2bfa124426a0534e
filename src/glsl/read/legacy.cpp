#include "src/glsl/read/legacy.h"

#include <iterator>
#include <unordered_map>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell::glsl {

namespace {

using enum LegacyKind;

constexpr std::string_view light_source =
    "struct snell_LightSourceParameters { vec4 ambient; vec4 diffuse; vec4 specular; vec4 position; vec4 halfVector; "
    "vec3 spotDirection; float spotExponent; float spotCutoff; float spotCosCutoff; float constantAttenuation; "
    "float linearAttenuation; float quadraticAttenuation; };";
constexpr std::string_view material =
    "struct snell_MaterialParameters { vec4 emission; vec4 ambient; vec4 diffuse; vec4 specular; float shininess; };";
constexpr std::string_view light_model = "struct snell_LightModelParameters { vec4 ambient; };";
constexpr std::string_view light_model_product = "struct snell_LightModelProducts { vec4 sceneColor; };";
constexpr std::string_view light_product = "struct snell_LightProducts { vec4 ambient; vec4 diffuse; vec4 specular; };";
constexpr std::string_view fog =
    "struct snell_FogParameters { vec4 color; float density; float start; float end; float scale; };";
constexpr std::string_view point =
    "struct snell_PointParameters { float size; float sizeMin; float sizeMax; float fadeThresholdSize; "
    "float distanceConstantAttenuation; float distanceLinearAttenuation; float distanceQuadraticAttenuation; };";

// Rows of names that have all else in common.
constexpr LegacyName names[] = {
    {"gl_Position gl_FragCoord", core, "vec4"},
    {"gl_PointSize gl_FragDepth", core, "float"},
    {"gl_ClipDistance gl_CullDistance", core, "float", -1},
    {"gl_VertexID gl_InstanceID gl_PrimitiveIDIn gl_PrimitiveID gl_InvocationID gl_Layer "
     "gl_ViewportIndex gl_PatchVerticesIn gl_SampleID gl_NumSamples gl_MaxVertexUniformComponents "
     "gl_MaxFragmentUniformComponents gl_MaxVertexAttribs gl_MaxVertexTextureImageUnits "
     "gl_MaxTextureImageUnits gl_MaxCombinedTextureImageUnits gl_MaxDrawBuffers",
     core, "int"},
    {"gl_TessCoord", core, "vec3"},
    {"gl_TessLevelOuter", core, "float", 4},
    {"gl_TessLevelInner", core, "float", 2},
    {"gl_FrontFacing gl_HelperInvocation", core, "bool"},
    {"gl_PointCoord gl_SamplePosition", core, "vec2"},
    {"gl_Vertex gl_Color gl_SecondaryColor gl_MultiTexCoord0 gl_MultiTexCoord1 gl_MultiTexCoord2 "
     "gl_MultiTexCoord3 gl_MultiTexCoord4 gl_MultiTexCoord5 gl_MultiTexCoord6 gl_MultiTexCoord7",
     attribute, "vec4"},
    {"gl_Normal", attribute, "vec3"},
    {"gl_FogCoord", attribute, "float"},
    {"gl_FrontColor gl_BackColor gl_FrontSecondaryColor gl_BackSecondaryColor", varying, "vec4"},
    {"gl_TexCoord", varying, "vec4", 8},
    {"gl_FogFragCoord", varying, "float"},
    {"gl_FragColor", color, "vec4"},
    {"gl_FragData", color, "vec4", 8},
    {"gl_PositionIn gl_ClipVertexIn gl_FrontColorIn gl_BackColorIn gl_FrontSecondaryColorIn "
     "gl_BackSecondaryColorIn",
     per_vertex_in, "vec4", -1},
    {"gl_PointSizeIn gl_FogFragCoordIn", per_vertex_in, "float", -1},
    {"gl_TexCoordIn", per_vertex_in, "vec4", -2},
    {"gl_ClipVertex", ignored, "vec4"},
    {"gl_ModelViewMatrix gl_ProjectionMatrix gl_ModelViewProjectionMatrix gl_ModelViewMatrixInverse "
     "gl_ProjectionMatrixInverse gl_ModelViewProjectionMatrixInverse gl_ModelViewMatrixTranspose "
     "gl_ProjectionMatrixTranspose gl_ModelViewProjectionMatrixTranspose "
     "gl_ModelViewMatrixInverseTranspose gl_ProjectionMatrixInverseTranspose "
     "gl_ModelViewProjectionMatrixInverseTranspose",
     uniform, "mat4"},
    {"gl_NormalMatrix", uniform, "mat3"},
    {"gl_TextureMatrix gl_TextureMatrixInverse gl_TextureMatrixTranspose "
     "gl_TextureMatrixInverseTranspose",
     uniform, "mat4", 8},
    {"gl_NormalScale", uniform, "float"},
    {"gl_ClipPlane gl_TextureEnvColor gl_EyePlaneS gl_EyePlaneT gl_EyePlaneR gl_EyePlaneQ "
     "gl_ObjectPlaneS gl_ObjectPlaneT gl_ObjectPlaneR gl_ObjectPlaneQ",
     uniform, "vec4", 8},
    {"gl_LightSource", uniform, "snell_LightSourceParameters", 8, light_source},
    {"gl_FrontMaterial gl_BackMaterial", uniform, "snell_MaterialParameters", 0, material},
    {"gl_LightModel", uniform, "snell_LightModelParameters", 0, light_model},
    {"gl_FrontLightModelProduct gl_BackLightModelProduct", uniform, "snell_LightModelProducts", 0, light_model_product},
    {"gl_FrontLightProduct gl_BackLightProduct", uniform, "snell_LightProducts", 8, light_product},
    {"gl_Fog", uniform, "snell_FogParameters", 0, fog},
    {"gl_Point", uniform, "snell_PointParameters", 0, point},
    {"gl_VerticesIn gl_MaxLights gl_MaxClipPlanes gl_MaxTextureUnits gl_MaxTextureCoords "
     "gl_MaxVaryingFloats",
     limit, "int"},
};

struct GstapName {
    std::string_view name, meaning;
};
constexpr GstapName gstap[] = {
    {"uModelViewMatrix", "gl_ModelViewMatrix"},
    {"uProjectionMatrix", "gl_ProjectionMatrix"},
    {"uModelViewProjectionMatrix", "gl_ModelViewProjectionMatrix"},
    {"uNormalMatrix", "gl_NormalMatrix"},
    {"uModelViewMatrixInverse", "gl_ModelViewMatrixInverse"},
    {"aVertex", "gl_Vertex"},
    {"aNormal", "gl_Normal"},
    {"aColor", "gl_Color"},
    {"aTexCoord0", "gl_MultiTexCoord0"},
    {"aTexCoord1", "gl_MultiTexCoord1"},
    {"aTexCoord2", "gl_MultiTexCoord2"},
    {"aTexCoord3", "gl_MultiTexCoord3"},
    {"aTexCoord4", "gl_MultiTexCoord4"},
    {"aTexCoord5", "gl_MultiTexCoord5"},
    {"aTexCoord6", "gl_MultiTexCoord6"},
    {"aTexCoord7", "gl_MultiTexCoord7"},
};

}  // namespace

std::string_view gstap_meaning(std::string_view name, Stage stage) {
    if (!name.starts_with('u') && (!name.starts_with('a') || stage != Stage::vertex)) return {};
    const auto* found = ranges::find(gstap, name, &GstapName::name);
    return found == std::end(gstap) ? std::string_view() : found->meaning;
}

std::string_view gstap_name(std::string_view gl_name) {
    const auto* found = ranges::find(gstap, gl_name, &GstapName::meaning);
    return found == std::end(gstap) ? std::string_view() : found->name;
}

std::string_view legacy_struct_text(std::string_view gl_type) {
    if (!gl_type.starts_with("gl_")) return {};
    const std::string_view name = gl_type.substr(3);
    for (const std::string_view text :
         {light_source, material, light_model, light_model_product, light_product, fog, point})
        if (text.substr(13, name.size()) == name && text.substr(13 + name.size()).starts_with(" {")) return text;
    return {};
}

const LegacyName* legacy_name(std::string_view name) {
    if (!name.starts_with("gl_")) return nullptr;
    static const std::unordered_map<std::string_view, LegacyName> table = [] {
        std::unordered_map<std::string_view, LegacyName> t;
        for (LegacyName row : names)
            for (const std::string_view one : split(row.name)) {
                row.name = one;
                t.emplace(one, row);
            }
        return t;
    }();
    const auto it = table.find(name);
    return it == table.end() ? nullptr : &it->second;
}

}  // namespace snell::glsl
