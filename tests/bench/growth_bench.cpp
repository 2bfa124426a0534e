// What grows with a scene: objects and textures. Twice as much should take twice as long, no more.
#include <string>

#include "src/document/document.h"
#include "tests/bench/context.h"
#include "tests/bench/drawing.h"
#include "tests/scratch.h"

namespace snell::bench {
namespace {

constexpr int side = 256;  // of the picture: small, so that it is not the pixels that count

std::string number(double value) { return std::to_string(value) + ' '; }

// Cubes on a grid, each with a matrix and a colour of its own, lit by one program.
std::string many_objects(const Scratch& scratch, int count) {
    scratch.write(
        "a.vert",
        "#version 330 compatibility\nout vec3 vColor;\nvoid main() { vColor = gl_Color.rgb * (.5 + .5 * "
        "normalize(gl_NormalMatrix * gl_Normal).z); gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    scratch.write("a.frag",
                  "#version 330 compatibility\nin vec3 vColor;\nuniform float uBright;\n"
                  "void main() { gl_FragColor = vec4(uBright * vColor, 1.); }\n");
    std::string text =
        "Perspective 60\nLookAt 0 0 3  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\nProgram A uBright <0 1 1>\n";
    const int across = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 0; i < count; ++i) {
        const double x = 3. * (i % across) / across - 1.5, y = 3. * (i / across) / across - 1.5;
        text += "PushMatrix\nTranslate " + number(x) + number(y) + "0\nRotate " + number(i % 90) + "0 1 0\nColor " +
                number(i % 7 / 7.) + number(i % 5 / 5.) + "1\nBox " + number(1. / across) + number(1. / across) +
                number(1. / across) + "\nPopMatrix\n";
    }
    return scratch.write("scene.glib", text);
}

std::string bmp(int seed) {
    constexpr int texels = 256;
    std::string bytes("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\0\1\0\0\0\1\0\0\1\0\x18\0", 30);
    bytes.resize(54, '\0');
    for (int i = 0; i < texels * texels * 3; ++i) bytes += static_cast<char>(i * (seed + 1) >> 4);
    return bytes;
}

// Quads side by side, each with a picture of its own.
std::string many_textures(const Scratch& scratch, int count) {
    scratch.write("a.vert",
                  "#version 330 compatibility\nout vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; "
                  "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    scratch.write("a.frag",
                  "#version 330 compatibility\nin vec2 vST;\nuniform sampler2D uPicture;\n"
                  "void main() { gl_FragColor = texture(uPicture, vST); }\n");
    std::string text =
        "Perspective 60\nLookAt 0 0 3  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\nProgram A uPicture 5\n";
    for (int i = 0; i < count; ++i) {
        scratch.write(std::to_string(i) + ".bmp", bmp(i));
        text += "Texture2D 5 " + std::to_string(i) + ".bmp\nPushMatrix\nTranslate " + number(i % 8 / 3. - 1.2) +
                number(i / 8 / 3. - 1.2) + "0\nQuadXY 0 .15\nPopMatrix\n";
    }
    return scratch.write("scene.glib", text);
}

using Make = std::string (*)(const Scratch&, int);

void open(benchmark::State& state, Make make) {
    const gl::Caps* caps = graphics();
    if (!caps) return state.SkipWithError("no graphics");
    const Scratch scratch;
    const std::string path = make(scratch, static_cast<int>(state.range(0)));
    std::size_t bytes = 0;
    for (auto _ : state) {
        const auto document = open_document(path, *caps);
        if (document->diagnostics.has_errors()) return state.SkipWithError("the scene has errors");
        const Counters& counters = document->runtime->counters();
        bytes = counters.bytes_read + counters.bytes_decoded + counters.bytes_uploaded;
    }
    beside_copy(state, bytes);
}

void draw(benchmark::State& state, Make make) {
    const gl::Caps* caps = graphics();
    if (!caps) return state.SkipWithError("no graphics");
    const Scratch scratch;
    const auto document = open_document(make(scratch, static_cast<int>(state.range(0))), *caps);
    if (document->diagnostics.has_errors()) return state.SkipWithError("the scene has errors");
    const gl::Target target = gl::make_target(side, side, 1);
    time_frames(state, *document, target);
    beside_clear(state, side, side);
}

void objects(benchmark::internal::Benchmark* benchmark) {
    benchmark->Arg(100)->Arg(1000)->Arg(10000)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);
}
void textures(benchmark::internal::Benchmark* benchmark) {
    for (const int count : {1, 4, 16, 64}) benchmark->Arg(count);
    benchmark->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(open, objects, many_objects)->Name("growth/open, objects:")->Apply(objects);
BENCHMARK_CAPTURE(draw, objects, many_objects)->Name("growth/frame, objects:")->Apply(objects);
BENCHMARK_CAPTURE(open, textures, many_textures)->Name("growth/open, textures:")->Apply(textures);
BENCHMARK_CAPTURE(draw, textures, many_textures)->Name("growth/frame, textures:")->Apply(textures);

}  // namespace
}  // namespace snell::bench
