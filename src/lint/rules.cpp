#include <array>
#include <string>

#include "src/lint/lint.h"

namespace snell::lint {
namespace {

using enum Rule;
using enum Severity;

constexpr std::array table{
    RuleFacts{unnormalised_direction, warning, "unnormalised-direction", "directions-of-unit-length",
              "`refract` with a direction or a normal, or `reflect` with a normal, that is interpolated, a position or "
              "a sum of vectors, and was not normalised afterwards",
              "write normalize(…) around it, in this shader"},
    RuleFacts{eye_space_lookup, warning, "eye-space-lookup", "the-space-of-a-cube-map",
              "a cube map looked up by a direction in eye coordinates, where the scene turns the eye by `LookAt` or "
              "`RenderToCube`",
              "work in world coordinates: with uModelViewerMatrix, or turn the direction back with "
              "mat3(uViewMatrixInverse)"},
    RuleFacts{
        index_as_ratio, warning, "index-as-ratio", "an-index-is-not-a-ratio",
        "an index of refraction above 1 as third argument of `refract`, for light that comes from the eye; what is an "
        "index is known by its name: eta, ior, index or refrac in it",
        "refract() takes n1/n2: give it 1. divided by the index, for light that enters"},
    RuleFacts{program_not_drawn, warning, "program-not-drawn", "a-program-draws-what-follows-it",
              "a `Program` that no geometry follows", "write the geometry after it"},
    RuleFacts{shadowed_uniform, warning, "shadowed-uniform", "one-name-one-thing",
              "a local variable with the name of a uniform of the same shader",
              "give the variable another name: after its declaration the uniform cannot be read"},
    RuleFacts{sampler_kind, warning, "sampler-kind", "samplers-and-units",
              "a sampler on a unit that holds only textures of another kind",
              "use the unit of the right texture, or bind one of that kind"},
    RuleFacts{samplers_share_unit, warning, "samplers-share-unit", "samplers-and-units",
              "two samplers of different kinds on one unit in one program: fine in snell, refused by OpenGL itself",
              "bind one of the textures to another unit"},
    RuleFacts{
        pow_of_negative, warning, "pow-of-negative", "pow-of-a-negative-number",
        "`pow` of a number that can be negative, if only by rounding: undefined in GLSL, and NaN with most drivers",
        "clamp it first: clamp(x, 0., 1.), max(x, 0.) or abs(x); or multiply, x*x"},
    RuleFacts{schlick_sign, warning, "schlick-sign", "the-sign-in-schlicks-formula",
              "a power of 1 plus the cosine of the angle of incidence, where 1 minus the cosine is meant: a "
              "reflectance above 1",
              "write 1. - dot(-e, n), with e the direction that reflect() and refract() were given"},
    RuleFacts{dispersion_order, warning, "dispersion-order", "blue-is-bent-most",
              "blue looked up through a larger n1/n2 than red: the colours are reversed",
              "blue has the largest index, so the smallest n1/n2: subtract for blue, add for red"},
    RuleFacts{never_read, warning, "never-read", "computed-and-not-used",
              "a variable made with `pow`, `mix`, `reflect` or `refract` that nothing reads",
              "use it, or remove it: perhaps another variable is used in its place"},
    RuleFacts{viewer_not_at_origin, note, "viewer-not-at-origin", "where-the-viewer-is",
              "a mirrored or refracted direction computed from the origin of eye coordinates: right until the "
              "scene is turned in the window, which happens after eye coordinates",
              "subtract `uniform vec3 uViewerPositionEye`, where the viewer really is, from the position"},
    RuleFacts{
        lookup_in_branch, warning, "lookup-in-branch", "lookups-in-branches",
        "a texture with mipmaps looked up in a branch that only some fragments take: the level is undefined there",
        "look up before the branch, or use textureGrad() or textureLod()"},
    RuleFacts{many_rounds, warning, "many-rounds", "loops-that-go-on-and-on",
              "loops with more than 65,535 rounds in one shader, or endless loops",
              "bound the loop, or draw in several passes"},
    RuleFacts{far_from_origin, warning, "far-from-origin", "far-from-the-origin",
              "the difference of two positions in world coordinates, where the scene's eye is so far from the origin "
              "that float rounding turns directions by more than .05 degrees",
              "write vec3(uModelViewerMatrix * position): the position relative to the viewer, exact everywhere"},
    RuleFacts{smoothstep_without_width, note, "smoothstep-without-width", "a-smoothstep-without-width",
              "`smoothstep` with two equal edges: undefined in GLSL; snell gives a step, other programs may give NaN",
              "write step(edge, x), or edges that differ"},
    RuleFacts{
        encoded_light, note, "encoded-light", "numbers-are-not-light",
        "`Irradiance` or `Prefilter` of a cube map whose files hold colours as displays show them",
        "write srgb at the end of the CubeMap statement and `Output srgb` into the scene; or raw, if it is meant"},
    RuleFacts{position_not_written, warning, "position-not-written", "a-vertex-without-a-place",
              "a vertex shader that never writes `gl_Position`: where its triangles are is undefined",
              "write gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;"},
    RuleFacts{
        point_size_unused, warning, "point-size-unused", "the-size-of-points",
        "a shader that writes `gl_PointSize` for points that the scene draws without `PointSizeMode 1`: `PointSize` "
        "decides instead",
        "write PointSizeMode 1 before the points, or PointSize if all have one size"},
    RuleFacts{
        rung_number, warning, "rung-number", "the-number-of-a-rung",
        "the name of a `Ladder` whose rungs are numbers, in arithmetic or as the bound of a loop: it is which rung "
        "it is, from 0",
        "write NAME_VALUE for the rung's own number"},
    RuleFacts{slider_without_effect, warning, "slider-without-effect", "a-slider-without-effect",
              "a slider or check box whose uniform the program reads, and yet no pixel depends on it",
              "let an output depend on the uniform, or remove it from the Program line"},
};

constexpr bool in_order() {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (static_cast<std::size_t>(table[i].rule) != i) return false;
    return true;
}
static_assert(in_order());

}  // namespace

std::span<const RuleFacts> rules() { return table; }

const RuleFacts& facts(Rule rule) { return table[static_cast<std::size_t>(rule)]; }

std::string more(const RuleFacts& rule) { return "snell help " + std::string(rule.code); }

}  // namespace snell::lint
