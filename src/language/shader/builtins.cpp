// How the functions of GLSL are declared.
#include "src/language/shader/builtins.h"

#include <array>
#include <unordered_map>

#include "parser/text/words.h"
#include "src/glsl/glsl.h"

namespace snell::language {

namespace {

constexpr std::string_view legacy_functions =
    "texture1D texture2D texture3D textureCube texture1DProj texture2DProj texture3DProj texture1DLod texture2DLod "
    "texture3DLod textureCubeLod texture2DProjLod texture2DRect shadow1D shadow2D shadow2DProj";

// A character of a signature, see src/glsl/read/builtins.cpp.
std::string_view type_of(char code, bool result) {
    constexpr std::pair<char, std::string_view> types[] = {
        {'F', "genType"}, {'I', "genIType"}, {'U', "genUType"}, {'B', "genBType"}, {'f', "float"},
        {'i', "int"},     {'u', "uint"},     {'b', "bool"},     {'2', "vec2"},     {'3', "vec3"},
        {'4', "vec4"},    {'n', "ivec2"},    {'m', "ivec3"},    {'M', "mat"},      {'S', "sampler"},
        {'C', "vec"},     {'J', "ivec"},     {'T', "vec4"},     {'Z', "ivec"}};
    for (const auto& [letter, name] : types)
        if (letter == code) return name;
    return result ? "void" : "value";
}

std::string declared(std::string_view name, std::string_view overload, std::string_view parameters) {
    const bool matrix = overload.starts_with("X:M") || overload.starts_with("X:C");
    std::string text(matrix ? "mat" : type_of(overload.front(), true));
    text += " " + std::string(name) + "(";
    bool first = true, optional = false;
    for (const char code : overload.substr(2)) {
        if (code == '[') {
            optional = true;
            continue;
        }
        const std::size_t comma = parameters.find(", ");
        const std::string_view parameter = parameters.substr(0, comma);
        parameters = comma == std::string_view::npos ? std::string_view() : parameters.substr(comma + 2);
        if (optional) text += first ? "[" : " [";
        text += (first ? "" : ", ") + std::string(type_of(code, false)) + " " + std::string(parameter);
        if (optional) text += "]";
        first = false;
    }
    return text + ")";
}

}  // namespace

const glsl::BuiltinFunction* function_doc(std::string_view name) {
    const glsl::BuiltinFunction* found = glsl::builtin_function(name);
    return found ? found : glsl::builtin_function(glsl::modern_texture_function(name));
}

std::vector<std::string> function_signatures(std::string_view name) {
    const glsl::BuiltinFunction* doc = function_doc(name);
    std::vector<std::string> all;
    if (doc == nullptr) return all;
    for (const std::string_view overload : split(doc->signatures)) {
        // Of atan, one overload has another first parameter.
        const bool one = name == "atan" && overload.size() == 3;
        all.push_back(declared(name, overload, one ? "y_over_x" : doc->parameters));
    }
    return all;
}

std::vector<std::string_view> function_names(bool legacy) {
    std::vector<std::string_view> names;
    for (const glsl::BuiltinFunction& function : glsl::builtin_functions()) names.push_back(function.name);
    if (legacy)
        for (const std::string_view name : split(legacy_functions)) names.push_back(name);
    return names;
}

// The variables of GLSL and of snell, from the tables of src/glsl/names.cpp and a few words on those of the core
// profile.

namespace {

struct CoreDoc {
    std::string_view name, type;
    std::string_view stages;  // v c e g f
    std::string_view doc;
    bool legacy = false;
};

// clang-format off
constexpr CoreDoc core[] = {
    {"gl_Position", "vec4", "vceg", "Position of the vertex in clip space."},
    {"gl_PointSize", "float", "vceg", "Size of the point, in pixels. Needs `PointSizeMode 1` in the scene."},
    {"gl_ClipDistance", "float[]", "vcegf", "Distances to clipping planes; what is negative is cut off."},
    {"gl_VertexID", "int", "v", "Number of the vertex."},
    {"gl_InstanceID", "int", "v", "Number of the instance."},
    {"gl_in", "gl_PerVertex[]", "ceg", "Outputs of the stage before, one for each vertex: `gl_in[i].gl_Position`."},
    {"gl_out", "gl_PerVertex[]", "c", "Outputs, one for each vertex of the patch: `gl_out[gl_InvocationID].gl_Position`."},
    {"gl_InvocationID", "int", "cg", "Number of the invocation."},
    {"gl_PatchVerticesIn", "int", "ce", "Number of vertices of the input patch."},
    {"gl_PrimitiveID", "int", "cegf", "Number of the primitive."},
    {"gl_PrimitiveIDIn", "int", "g", "Number of the input primitive."},
    {"gl_TessLevelOuter", "float[4]", "ce", "Subdivision of each edge of the patch."},
    {"gl_TessLevelInner", "float[2]", "ce", "Subdivision of the inside of the patch."},
    {"gl_TessCoord", "vec3", "e", "Coordinates of the vertex within the patch."},
    {"gl_Layer", "int", "gf", "Layer of the target."},
    {"gl_FragCoord", "vec4", "f", "Position of the fragment in pixels; z is its depth, w is 1 / w of clip space."},
    {"gl_FragDepth", "float", "f", "Depth to write, instead of gl_FragCoord.z."},
    {"gl_FrontFacing", "bool", "f", "True if the front of the triangle is seen."},
    {"gl_PointCoord", "vec2", "f", "Coordinates within a point, from 0 to 1."},
    {"gl_SampleID", "int", "f", "Number of the sample."},
    {"gl_SamplePosition", "vec2", "f", "Position of the sample within the pixel."},
    {"gl_FragColor", "vec4", "f", "Colour of the fragment.", true},
    {"gl_FragData", "vec4[8]", "f", "Colours of the fragment, one for each target.", true},
    {"gl_FrontColor", "vec4", "vceg", "Colour for the fragment shader's gl_Color.", true},
    {"gl_BackColor", "vec4", "vceg", "Colour of back faces.", true},
    {"gl_TexCoord", "vec4[8]", "vcegf", "Texture coordinates that the vertex shader hands on.", true},
    {"gl_Color", "vec4", "f", "Colour from gl_FrontColor, interpolated.", true},
    {"gl_PositionIn", "vec4[]", "g", "Positions of the input vertices.", true},
    {"gl_VerticesIn", "int", "g", "Number of the input vertices.", true},
    {"gl_TexCoordIn", "vec4[][8]", "g", "Texture coordinates of the input vertices.", true},
    {"gl_LightSource", "gl_LightSourceParameters[8]", "vcegf", "The lights of OpenGL, with their initial values: light 0 shines from +Z in white.", true},
    {"gl_FrontMaterial", "gl_MaterialParameters", "vcegf", "The material of OpenGL, with its initial values.", true},
    {"gl_BackMaterial", "gl_MaterialParameters", "vcegf", "The material of back faces.", true},
    {"gl_LightModel", "gl_LightModelParameters", "vcegf", "The ambient light of the scene.", true},
    {"gl_FrontLightModelProduct", "gl_LightModelProducts", "vcegf", "Emission plus ambient light of the material.", true},
    {"gl_FrontLightProduct", "gl_LightProducts[8]", "vcegf", "Products of light and material.", true},
    {"gl_Fog", "gl_FogParameters", "vcegf", "The fog of OpenGL, with its initial values.", true},
};
// clang-format on

constexpr std::string_view stage_letters = "vcegf";

std::string documented(std::string_view doc, std::string_view space, std::string_view range) {
    std::string text(doc);
    if (!space.empty()) text += "\n\nSpace: " + std::string(space) + ".";
    if (!range.empty()) text += "\n\nRange: " + std::string(range) + ".";
    return text;
}

// A row of one of snell's tables. What replaces a name of old dialects is listed under that name.
template <class Facts>
VariableDoc documented_name(std::string_view name, const Facts& facts, std::string_view qualifier, Stage stage) {
    VariableDoc doc{std::string(name), std::string(facts.type), documented(facts.doc, facts.space, facts.range)};
    doc.qualifier = qualifier;
    doc.legacy = name.starts_with("snell_");
    if (doc.legacy) doc.name = "gl_" + std::string(name.substr(6));
    doc.undeclared = doc.legacy || !glsl::gstap_meaning(name, stage).empty();
    return doc;
}

void add_systems(std::vector<VariableDoc>& all, Stage stage) {
    for (const glsl::SystemName& name : glsl::system_names()) {
        const glsl::SystemFacts& facts = glsl::system_facts()[static_cast<std::size_t>(name.system)];
        VariableDoc doc = documented_name(name.name, facts, "uniform", stage);
        const glsl::LegacyName* legacy = glsl::legacy_name(doc.name);
        if (doc.legacy && (legacy == nullptr || legacy->kind == glsl::LegacyKind::core)) continue;
        if (doc.legacy && legacy->size > 0) doc.type += "[" + std::to_string(legacy->size) + "]";
        if (!doc.legacy && name.system == glsl::System::harmonics) doc.type += "[9]";
        all.push_back(std::move(doc));
    }
}

void add_attributes(std::vector<VariableDoc>& all, Stage stage) {
    if (stage != Stage::vertex) return;
    for (const glsl::AttributeName& name : glsl::attribute_names()) {
        const glsl::AttributeFacts& facts = glsl::attribute_facts()[static_cast<std::size_t>(name.attribute)];
        VariableDoc doc = documented_name(name.name, facts, "in", stage);
        if (!doc.legacy || glsl::legacy_name(doc.name) != nullptr) all.push_back(std::move(doc));
    }
}

std::vector<VariableDoc> make_variables(Stage stage) {
    std::vector<VariableDoc> all;
    const char letter = stage_letters[static_cast<std::size_t>(stage)];
    for (const CoreDoc& doc : core)
        if (doc.stages.find(letter) != std::string_view::npos)
            all.push_back({std::string(doc.name), std::string(doc.type), std::string(doc.doc), doc.legacy});
    add_systems(all, stage);
    add_attributes(all, stage);
    return all;
}

struct StageVariables {
    std::vector<VariableDoc> all;
    std::unordered_map<std::string_view, const VariableDoc*> by_name;

    explicit StageVariables(Stage stage) : all(make_variables(stage)) {
        for (const VariableDoc& doc : all) by_name.emplace(doc.name, &doc);
    }
};

const StageVariables& stage_variables(Stage stage) {
    static const std::array<StageVariables, stage_count> tables{
        StageVariables(Stage::vertex), StageVariables(Stage::tess_control), StageVariables(Stage::tess_evaluation),
        StageVariables(Stage::geometry), StageVariables(Stage::fragment)};
    return tables[static_cast<std::size_t>(stage)];
}

constexpr std::string_view keyword_text =
    "attribute break case centroid const continue default discard do else flat for highp if in inout invariant layout "
    "lowp mediump noperspective out patch precise precision return sample smooth struct switch uniform varying void "
    "while buffer true false";
constexpr std::string_view type_text =
    "bool int uint float double vec2 vec3 vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 bvec4 dvec2 dvec3 dvec4 "
    "mat2 mat3 mat4 mat2x3 mat2x4 mat3x2 mat3x4 mat4x2 mat4x3 sampler1D sampler2D sampler3D samplerCube "
    "sampler2DShadow "
    "samplerCubeShadow sampler2DArray sampler2DRect samplerBuffer isampler2D usampler2D image2D";

constexpr std::string_view header_text =
    "snell/bands.glsl snell/color.glsl snell/core.glsl snell/dispersion.glsl snell/environment.glsl snell/fresnel.glsl "
    "snell/irradiance.glsl snell/mesh.glsl snell/noise.glsl snell/ray.glsl snell/refraction.glsl";

}  // namespace

const std::vector<std::string_view>& library_headers() {
    static const std::vector<std::string_view> all = split(header_text);
    return all;
}

const std::vector<VariableDoc>& variable_docs(Stage stage) { return stage_variables(stage).all; }

const VariableDoc* variable_doc(Stage stage, std::string_view name) {
    const auto& table = stage_variables(stage).by_name;
    const auto found = table.find(name);
    return found == table.end() ? nullptr : found->second;
}

const std::vector<std::string_view>& keywords() {
    static const std::vector<std::string_view> all = split(keyword_text);
    return all;
}

const std::vector<std::string_view>& type_names() {
    static const std::vector<std::string_view> all = split(type_text);
    return all;
}

}  // namespace snell::language
