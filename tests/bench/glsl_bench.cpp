// How long a translation takes: a program with a shader of 200 lines is to take less than 1 ms.
#include <benchmark/benchmark.h>

#include <string>

#include "src/glsl/glsl.h"
#include "tests/bench/bounds.h"

namespace snell::glsl {
namespace {

const std::string vertex_text =
    "#version 330 compatibility\nuniform float uAmp, uFreq;\nout vec3 vNormal, vLight, vEye, vMC;\nout vec2 vST;\n"
    "const vec3 LIGHT = vec3(5., uAmp * 10., 5.);\nvoid main()\n{\n    vMC = gl_Vertex.xyz;\n    vST = "
    "gl_MultiTexCoord0.st;\n"
    "    vec4 ec = gl_ModelViewMatrix * gl_Vertex;\n    vNormal = normalize(gl_NormalMatrix * gl_Normal);\n"
    "    vLight = LIGHT - ec.xyz;\n    vEye = -ec.xyz;\n    gl_Position = gl_ModelViewProjectionMatrix * "
    "gl_Vertex;\n}\n";

// About `lines` lines of what students write.
std::string fragment_text(int lines) {
    std::string text =
        "#version 330 compatibility\nuniform sampler2D uTex;\nuniform sampler3D Noise3;\nuniform float uKa, uKd, uKs;\n"
        "uniform vec4 uColor;\nin vec3 vNormal, vLight, vEye, vMC;\nin vec2 vST;\n#define SQ(x) ((x) * (x))\n";
    for (int n = 0; n * 9 < lines; ++n) {
        const std::string i = std::to_string(n);
        text += "vec3 shade" + i +
                "(vec3 n, float s)\n{\n    float d = max(dot(n, normalize(vLight)), 0.);\n"
                "    vec4 nv = texture3D(Noise3, vMC * s);\n    float sum = nv.r + nv.g + nv.b + nv.a - 2;\n"
                "    if (d > 0. && SQ(sum) < 1)\n        d += pow(max(dot(normalize(vEye), reflect(-vLight, n)), 0.), "
                "20);\n"
                "    return d * texture2D(uTex, vST).rgb; // layer " +
                i + "\n}\n";
    }
    return text + "void main()\n{\n    gl_FragColor = vec4(uKa * uColor.rgb + shade0(normalize(vNormal), 2), 1.);\n}\n";
}

void translate_program(benchmark::State& state, Target target) {
    const std::string fragment = fragment_text(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        Sources sources;
        Diagnostics diagnostics;
        const std::vector<StageInput> stages = {{Stage::vertex, sources.add("a.vert", vertex_text), {}},
                                                {Stage::fragment, sources.add("a.frag", fragment), {}}};
        Options options;
        options.target = target;
        const Translation t = translate(stages, sources, options, diagnostics);
        benchmark::DoNotOptimize(t.stages.back().text.data());
    }
    bench::beside_copy(state, vertex_text.size() + fragment.size());
    state.counters["lines"] = static_cast<double>(state.range(0));
}

void core(benchmark::State& state) { translate_program(state, {450, false, true}); }
void es(benchmark::State& state) { translate_program(state, {300, true, false}); }

BENCHMARK(core)->Name("translate/to GLSL 4.50, lines:")->Arg(50)->Arg(200)->Arg(2000)->Unit(benchmark::kMicrosecond);
BENCHMARK(es)->Name("translate/to GLSL ES 3.00, lines:")->Arg(200)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace snell::glsl
