#include "src/glsl/read/words.h"

#include <iterator>
#include <unordered_map>
#include <unordered_set>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell::glsl {

namespace {

using Words = std::unordered_set<std::string_view>;
using Types = std::unordered_map<std::string_view, Type>;

// Names of vectors and matrices by base and size; index [rows] and [cols][rows].
constexpr std::string_view vector_names[5][5] = {
    {"", "bool", "bvec2", "bvec3", "bvec4"},   {"", "int", "ivec2", "ivec3", "ivec4"},
    {"", "uint", "uvec2", "uvec3", "uvec4"},   {"", "float", "vec2", "vec3", "vec4"},
    {"", "double", "dvec2", "dvec3", "dvec4"},
};
constexpr std::string_view matrix_names[2][5][5] = {
    {{},
     {},
     {"", "", "mat2", "mat2x3", "mat2x4"},
     {"", "", "mat3x2", "mat3", "mat3x4"},
     {"", "", "mat4x2", "mat4x3", "mat4"}},
    {{},
     {},
     {"", "", "dmat2", "dmat2x3", "dmat2x4"},
     {"", "", "dmat3x2", "dmat3", "dmat3x4"},
     {"", "", "dmat4x2", "dmat4x3", "dmat4"}},
};

Words words_of(std::string_view text) {
    const std::vector<std::string_view> all = split(text);
    return {all.begin(), all.end()};
}

constexpr std::string_view samplers =
    "sampler1D sampler2D sampler3D samplerCube sampler2DRect sampler1DShadow sampler2DShadow samplerCubeShadow "
    "sampler2DRectShadow sampler1DArray sampler2DArray sampler1DArrayShadow sampler2DArrayShadow samplerBuffer "
    "sampler2DMS sampler2DMSArray samplerCubeArray samplerCubeArrayShadow isampler1D isampler2D isampler3D "
    "isamplerCube isampler2DRect isampler1DArray isampler2DArray isamplerBuffer isampler2DMS isampler2DMSArray "
    "isamplerCubeArray usampler1D usampler2D usampler3D usamplerCube usampler2DRect usampler1DArray usampler2DArray "
    "usamplerBuffer usampler2DMS usampler2DMSArray usamplerCubeArray image1D image2D image3D imageCube image2DRect "
    "image1DArray image2DArray imageBuffer iimage1D iimage2D iimage3D uimage1D uimage2D uimage3D iimage2DArray "
    "uimage2DArray iimageBuffer uimageBuffer atomic_uint";

const Types& types() {
    static const Types table = [] {
        Types t;
        auto add = [&](std::string_view name, Base base, int rows, int cols) {
            Type type = make_type(base, rows, cols);
            if (type.name.empty()) type.name = name;
            t.emplace(name, type);
        };
        add("void", Base::none, 1, 1);
        for (int b = 0; b < 5; ++b)
            for (int r = 1; r <= 4; ++r)
                add(vector_names[b][r], static_cast<Base>(static_cast<int>(Base::boolean) + b), r, 1);
        for (int b = 0; b < 2; ++b)
            for (int c = 2; c <= 4; ++c)
                for (int r = 2; r <= 4; ++r) add(matrix_names[b][c][r], b == 0 ? Base::real : Base::dreal, r, c);
        add("mat2x2", Base::real, 2, 2);
        add("mat3x3", Base::real, 3, 3);
        add("mat4x4", Base::real, 4, 4);
        add("dmat2x2", Base::dreal, 2, 2);
        add("dmat3x3", Base::dreal, 3, 3);
        add("dmat4x4", Base::dreal, 4, 4);
        for (const std::string_view s : split(samplers)) {
            Type type;
            type.base = Base::sampler;
            type.name = s;
            t.emplace(s, type);
        }
        return t;
    }();
    return table;
}

std::string zero_within(std::span<const Struct> structs, const Type& type, int& budget) {
    if (budget <= 0 || type.dims > 1 || (type.dims == 1 && type.size <= 0)) return {};
    if (type.dims == 1) {
        Type element = type;
        element.dims = 0;
        std::string all;
        for (int i = 0; i < type.size; ++i) {
            const std::string one = zero_within(structs, element, budget);
            if (one.empty()) return {};
            all += (i ? ", " : "") + one;
        }
        const std::string_view name = type.base == Base::structure && type.structure >= 0
                                          ? structs[static_cast<std::size_t>(type.structure)].name
                                          : type_name(type.base, type.rows, type.cols);
        return std::string(name) + "[" + std::to_string(type.size) + "](" + all + ")";
    }
    --budget;
    if (type.basic()) return zero(type);
    if (type.base != Base::structure || type.structure < 0) return {};
    const Struct& s = structs[static_cast<std::size_t>(type.structure)];
    if (s.name.empty() || s.members.empty()) return {};
    std::string all;
    for (const Member& m : s.members) {
        const std::string one = zero_within(structs, m.type, budget);
        if (one.empty()) return {};
        all += (all.empty() ? "" : ", ") + one;
    }
    return std::string(s.name) + "(" + all + ")";
}

}  // namespace

std::string_view type_name(Base base, int rows, int cols) {
    if (base < Base::boolean || base > Base::dreal || rows < 1 || rows > 4 || cols < 1 || cols > 4) return {};
    if (cols == 1) return vector_names[static_cast<int>(base) - static_cast<int>(Base::boolean)][rows];
    if (base != Base::real && base != Base::dreal) return {};
    return matrix_names[base == Base::dreal ? 1 : 0][cols][rows];
}

Type make_type(Base base, int rows, int cols) {
    Type type;
    type.base = base;
    type.rows = static_cast<std::uint8_t>(rows);
    type.cols = static_cast<std::uint8_t>(cols);
    type.name = type_name(base, rows, cols);
    return type;
}

std::optional<Type> builtin_type(std::string_view name) {
    const auto it = types().find(name);
    if (it == types().end()) return std::nullopt;
    return it->second;
}

bool has_alpha(std::string_view selection) { return selection.find_first_of("awq") != std::string_view::npos; }

bool is_qualifier(std::string_view word) {
    static const Words words = words_of(
        "const in out inout uniform attribute varying flat smooth noperspective centroid sample patch invariant "
        "precise highp mediump lowp layout buffer shared coherent volatile restrict readonly writeonly subroutine");
    return words.contains(word);
}

bool is_statement_word(std::string_view word) {
    static const Words words =
        words_of("if else for while do switch case default return break continue discard struct true false precision");
    return words.contains(word);
}

// Keywords that an older version lacks are here too, and students' names are among them.
bool is_reserved_word(std::string_view word) {
    static const Words words = words_of(
        "uint uvec2 uvec3 uvec4 double dvec2 dvec3 dvec4 common partition active asm class union enum typedef "
        "template this packed resource goto inline noinline public static extern external interface long short half "
        "fixed unsigned superp input output hvec2 hvec3 hvec4 fvec2 fvec3 fvec4 sampler3DRect filter sizeof cast "
        "namespace using row_major sample patch subroutine precise invariant buffer shared coherent volatile "
        "restrict readonly writeonly smooth flat noperspective centroid atomic_uint demote terminateInvocation "
        "superpatch lowp mediump highp precision samplerExternalOES column_major layout image1D image2D image3D");
    return words.contains(word);
}

bool is_language_word(std::string_view word) {
    if (word.starts_with("gl_") || is_qualifier(word) || is_statement_word(word) || is_reserved_word(word)) return true;
    return builtin_type(word) || !builtin_signatures(word).empty() || !modern_texture_function(word).empty();
}

std::string_view stage_name(Stage stage) {
    constexpr std::string_view words[] = {"vertex", "tessellation control", "tessellation evaluation", "geometry",
                                          "fragment"};
    return words[static_cast<std::size_t>(stage)];
}

int precedence(std::string_view op) {
    constexpr std::pair<std::string_view, int> table[] = {
        {"||", 1}, {"^^", 2}, {"&&", 3}, {"|", 4},  {"^", 5},  {"&", 6},  {"==", 7}, {"!=", 7}, {"<", 8}, {">", 8},
        {"<=", 8}, {">=", 8}, {"<<", 9}, {">>", 9}, {"+", 10}, {"-", 10}, {"*", 11}, {"/", 11}, {"%", 11}};
    if (op.empty() || op.size() > 2) return 0;
    for (const auto& [text, level] : table)
        if (text == op) return level;
    return 0;
}

bool assigns(std::string_view op) {
    if (!op.ends_with('=')) return false;
    op.remove_suffix(1);
    return op.empty() || op == "<<" || op == ">>" ||
           (op.size() == 1 && std::string_view("+-*/%&|^").find(op) != op.npos);
}

std::string_view foreign_type(std::string_view t) {
    struct Foreign {
        std::string_view name;
        Base base;
    };
    constexpr Foreign stems[] = {{"float", Base::real},
                                 {"half", Base::real},
                                 {"fixed", Base::real},
                                 {"int", Base::integer},
                                 {"bool", Base::boolean}};
    for (const Foreign& f : stems) {
        if (!t.starts_with(f.name)) continue;
        const std::string_view size = t.substr(f.name.size());
        const auto digit = [&](std::size_t k) { return size[k] >= '2' && size[k] <= '4' ? size[k] - '0' : 0; };
        if (size.empty()) return f.name == "half" || f.name == "fixed" ? "float" : "";
        if (size.size() == 1 && digit(0)) return type_name(f.base, digit(0), 1);
        if (size.size() == 3 && digit(0) && size[1] == 'x' && digit(2) == digit(0) && f.base == Base::real)
            return type_name(f.base, digit(0), digit(0));
    }
    return {};
}

// STEM DIMENSION [Proj] [Lod, Grad] [Offset] becomes the function without the dimension. Extensions wrote ARB or EXT
// behind the same names.
std::string_view modern_texture_function(std::string_view name) {
    if (name == "textureQueryLOD") return "textureQueryLod";
    constexpr std::string_view results[] = {"texture",        "textureProj",      "textureLod",
                                            "textureProjLod", "textureGrad",      "textureProjGrad",
                                            "textureOffset",  "textureLodOffset", "textureProjOffset"};
    constexpr std::string_view dimensions[] = {"1DArray", "2DArray", "2DRect", "1D", "2D", "3D", "Cube", "Buffer"};
    if (name.ends_with("ARB") || name.ends_with("EXT")) name.remove_suffix(3);
    for (const std::string_view stem : {"textureSize", "texelFetch", "texture", "shadow"}) {
        if (!name.starts_with(stem)) continue;
        const std::string_view rest = name.substr(stem.size());
        for (const std::string_view dimension : dimensions) {
            if (!rest.starts_with(dimension)) continue;
            const std::string_view suffix = rest.substr(dimension.size());
            if (stem.starts_with("textureS") || stem == "texelFetch") return suffix.empty() ? stem : "";
            for (const std::string_view result : results)
                if (result.substr(7) == suffix) return result;
            return {};
        }
    }
    return {};
}

std::string zero(const Type& type) {
    if (type.scalar())
        return type.base == Base::boolean ? "false"
               : type.integral()          ? (type.base == Base::uinteger ? "0u" : "0")
                                          : "0.0";
    return std::string(type_name(type.base, type.rows, type.cols)) + "(" +
           (type.base == Base::boolean ? "false" : "0") + (type.floating() ? ".0)" : ")");
}

std::string zero_of(std::span<const Struct> structs, const Type& type) {
    int budget = 65;
    return zero_within(structs, type, budget);
}

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
