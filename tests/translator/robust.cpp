// Any bytes, and any mutation of a valid shader: no crash, no hang.
#include "tests/fuzz/glsl_input.h"
#include "tests/sanitized.h"
#include "tests/scratch.h"
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

const std::string sample =
    "#version 330 compatibility\n#extension GL_EXT_gpu_shader4 : enable\n#define SQ(x) ((x) * (x))\n#ifdef "
    "GL_ES\nprecision highp float;\n#endif\n"
    "struct Light { vec3 p; float k[2]; };\nuniform Light uL; uniform float uA = .5, uB; in vec3 vN; in VS { vec2 st; "
    "} vs;\n"
    "float g[2] = {uA, 1.}; const vec3 W = vec3(1., uB, SQ(2));\nlayout(location = 0) out vec4 c;\n"
    "float f(in float x, out int n) { n = int(x); for (int i = 0; i < 3; ++i) { if (i == 2) continue; x += i; } return "
    "x ? 1 : 2; }\n"
    "void main() { int n; vec4 t = texture2D(uT, vs.st).rgba * f(2, n); switch (n) { case 1: t.x = 1; break; default: "
    "discard; }\n"
    "do { n--; } while (n > 0); gl_FragColor = vec4(W * g[1] + gl_TexCoord[n].rgb, gl_LightSource[0].diffuse.a); }\n";

TEST(GlslRobust, TokenMutations) {
    std::mt19937 random(7);
    std::vector<std::string> words;
    for (std::size_t i = 0; i < sample.size();) {
        std::size_t end = i + 1;
        while (end < sample.size() && std::isalnum(static_cast<unsigned char>(sample[i])) &&
               std::isalnum(static_cast<unsigned char>(sample[end])))
            ++end;
        words.push_back(sample.substr(i, end - i));
        i = end;
    }
    for (int round = 0; round < 1500; ++round) {
        std::vector<std::string> mutated = words;
        for (unsigned k = 0; k <= random() % 4; ++k) {
            const std::size_t a = random() % mutated.size(), b = random() % mutated.size();
            switch (random() % 3) {
                case 0:
                    mutated.erase(mutated.begin() + static_cast<std::ptrdiff_t>(a));
                    break;
                case 1:
                    mutated.insert(mutated.begin() + static_cast<std::ptrdiff_t>(a), words[random() % words.size()]);
                    break;
                default:
                    std::swap(mutated[a], mutated[b]);
            }
        }
        std::string text;
        for (const std::string& w : mutated) text += w;
        const Stage stage = static_cast<Stage>(random() % stage_count);
        const Translated t = translated({{stage, text}}, round % 2 ? core330 : es320);
        EXPECT_FALSE(t.translation.stages.empty());
    }
}

TEST(GlslRobust, AnyBytes) {
    std::mt19937 random(11);
    for (int round = 0; round < 500; ++round) {
        std::string text(random() % 300, ' ');
        for (char& ch : text) ch = static_cast<char>(random());
        EXPECT_FALSE(fragment(text).translation.stages.empty());
    }
    for (const std::string& text :
         {std::string("#"), std::string("#define"), std::string("#version"), std::string("/*"), std::string("\\"),
          std::string("#include \""), std::string("#define A(\n"), std::string("layout("), std::string("\0\0", 2),
          std::string("void main() {")})
        EXPECT_FALSE(fragment(text).translation.stages.empty());
}

// What the fuzzer begins with, and what it has found: whole, and cut in several places.
TEST(GlslRobust, TheCorpusOfTheFuzzer) {
    std::size_t count = 0;
    for (const char* folder : {"fuzz/glsl_corpus", "glsl"}) {
        for (const auto& entry : std::filesystem::directory_iterator(std::string(SNELL_ROOT) + "/tests/" + folder)) {
            const std::string text = bytes_of(entry.path());
            fuzz::translate_bytes(text);
            for (std::size_t choice = 0; choice < 20; ++choice)
                fuzz::translate_bytes(text.substr(0, text.size() * (choice + 1) / 20) + static_cast<char>(choice));
            ++count;
        }
    }
    EXPECT_GE(count, 200u);
}

TEST(GlslRobust, DeepNesting) {
    const auto nested = [](const std::string& open, const std::string& close) {
        std::string text = "void main() { float x = ";
        for (int n = 0; n < 100000; ++n) text += open;
        text += "1.";
        for (int n = 0; n < 100000; ++n) text += close;
        return text + "; }";
    };
    const std::clock_t start = std::clock();
    EXPECT_FALSE(fragment(nested("(", ")")).translation.stages.empty());
    EXPECT_FALSE(fragment(nested("-", "")).translation.stages.empty());
    EXPECT_FALSE(fragment(nested("f(", ")")).translation.stages.empty());
    EXPECT_FALSE(fragment(nested("a ? ", " : b")).translation.stages.empty());
    EXPECT_FALSE(fragment(nested("a[", "]")).translation.stages.empty());
    EXPECT_FALSE(fragment("void main() " + std::string(100000, '{')).translation.stages.empty());
    EXPECT_FALSE(fragment("float a[2] = " + std::string(100000, '{')).translation.stages.empty());
    std::string ifs = "void main() {";
    for (int n = 0; n < 50000; ++n) ifs += "if (x) ";
    EXPECT_FALSE(fragment(ifs).translation.stages.empty());
    std::string structs;
    for (int n = 0; n < 20000; ++n) structs += "struct A { struct B { ";
    EXPECT_FALSE(fragment(structs).translation.stages.empty());
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 20 * patience);
}

std::string repeated(int count, const std::string& text) {
    std::string all;
    for (int n = 0; n < count; ++n) all += text;
    return all;
}

// Mesa walks a tree of expressions and statements by recursion: one that is too deep would end the process.
TEST(GlslRobust, DeepTreesAreRefused) {
    const auto refused = [](const std::string& body) {
        const Translated t = fragment("uniform float u;\nvoid main() {\n" + body + " gl_FragColor = vec4(u); }\n");
        if (t.translation.ok) return 0;
        EXPECT_EQ(t.count("too-deep"), 1);
        return t.sources.position(0, t.diagnostics.items().front().span.begin).line;
    };
    constexpr int many = 17000, few = 600;
    const auto with = [&](int count, const std::string& open, const std::string& inside, const std::string& close) {
        return refused("float a = 0.;\na = " + repeated(count, open) + inside + repeated(count, close) + ";");
    };
    for (const auto& [open, inside, close] : std::vector<std::array<std::string, 3>>{{"u + ", "u", ""},
                                                                                     {"sin(", "u", ")"},
                                                                                     {"(", "u", ")"},
                                                                                     {"- ", "u", ""},
                                                                                     {"a = ", "u", ""},
                                                                                     {"u > 1. ? u : ", "u", ""},
                                                                                     {"", "vec2(u)", ".xx"}}) {
        SCOPED_TRACE(open + close);
        EXPECT_EQ(with(many, open, inside, close), 4);
        EXPECT_EQ(with(few, open, inside, close), 0);
    }
    const auto statements = [&](const std::string& each, int count, const std::string& after = "") {
        return refused("float a = 0.;\n" + repeated(count, each) + "a = 1.;" + repeated(count, after));
    };
    for (const std::string each : {"if (u > 1.) ", "if (u > 1.) a = 2.; else ", "if (u > 1.) { a = 2.; } else "}) {
        EXPECT_EQ(statements(each, many), 4) << each;
        EXPECT_EQ(statements(each, few), 0) << each;
    }
    EXPECT_EQ(statements("{", many, "}"), 4);
    // Length alone is harmless.
    EXPECT_EQ(statements("a += u * 2.;", many), 0);
    EXPECT_EQ(refused("float a[" + std::to_string(many) + "] = float[](" + repeated(many - 1, "-1., ") + "1.);"), 0);
}

TEST(GlslRobust, EmptyShaders) {
    for (const char* text : {"", "// nothing\n", "#version 330\n", "#if 0\nvoid main() {}\n#endif\n"}) {
        const Translated t = fragment(text);
        EXPECT_FALSE(t.translation.ok) << text;
        EXPECT_EQ(t.count("glsl-no-main"), 1) << text;
    }
}

// What is moved or written out member by member: each may be many, or multiply.
TEST(GlslRobust, ManyOfWhatIsMoved) {
    const auto start = std::chrono::steady_clock::now();
    std::string structs, prototypes = "void main() {", members, deep, doubled = "struct S0 { float x; };";
    for (int n = 0; n < 20000; ++n) {
        structs += "struct A { struct B { int x; } b; };\n";
        prototypes += "float f(float x);";
        members += "struct { int x; } b" + std::to_string(n) + "; ";
    }
    for (int n = 0; n < 50; ++n) deep += "struct A" + std::to_string(n) + " { ";
    for (int n = 0; n < 50; ++n) deep += " } b;";
    for (int n = 1; n < 40; ++n) {
        const std::string before = "S" + std::to_string(n - 1);
        doubled += "struct S" + std::to_string(n) + " { " + before + " a, b; };";
    }
    const std::string main = "void main() { gl_FragColor = vec4(1.); }";
    EXPECT_FALSE(fragment(structs + main).translation.stages.empty());
    EXPECT_FALSE(fragment("struct A { " + members + "};" + main).translation.stages.empty());
    EXPECT_FALSE(fragment(deep + main).translation.stages.empty());
    EXPECT_FALSE(fragment(prototypes + "}").translation.stages.empty());
    EXPECT_LT(fragment(doubled + "in S39 a; in B { S39 a; A n; };" + main).text(Stage::fragment).size(), 1U << 20U);
    EXPECT_FALSE(fragment("struct A { A a; }; in A a;" + main).translation.stages.empty());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10) * patience);
}

}  // namespace
}  // namespace snell::glsl::test
