// Changes of many shaders: all are translated without errors, and any bytes are read to their end.
#include "src/accuracy/timing.h"
#include "tests/accuracy/shaders/help.h"
#include "tests/sanitized.h"

namespace snell::accuracy::test {
namespace {

std::vector<std::string> scenes_of(const std::string& folder) {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".glib" &&
            entry.path().string().find("/files/", folder.size()) == std::string::npos)
            found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    return found;
}

void expect_right(const Found& found, const std::string& path) {
    std::set<std::string> known;
    for (const Change& change : found.changes) {
        std::string key;
        for (const Edit& edit : change.edits)
            key += std::to_string(edit.span.file) + ":" + std::to_string(edit.span.begin) + "-" +
                   std::to_string(edit.span.end) + edit.text + "\n";
        EXPECT_TRUE(known.insert(key).second) << path << ": twice: " << change.before;
        const std::array<const Change*, 1> one{&change};
        for (const auto& [name, text] : changed_texts(one, found.sources)) {
            EXPECT_TRUE(std::filesystem::exists(name)) << name << " is not the author's";
            bool same = false;
            for (FileId file = 0; file < found.sources.size(); ++file)
                same = same || (found.sources.name(file) == name && found.sources.text(file) == text);
            EXPECT_FALSE(same) << path << ": changes nothing: " << change.before;
        }
    }
    EXPECT_LE(found.changes.size(), 200U);
}

TEST(FoundCorpus, EveryChangeIsTranslatedWithoutErrors) {
    std::map<std::string_view, int> kinds;
    for (const std::string folder : {"scenes", "tests/cases"})
        for (const std::string& path : scenes_of(SNELL_ROOT "/" + folder)) {
            const Found found(path);
            expect_right(found, path);
            const std::string before = translation_errors(found, {});
            for (const Change& change : found.changes) {
                ++kinds[facts(change.kind).name];
                if (!before.empty()) continue;
                EXPECT_EQ(translation_errors(found, {&change}), "")
                    << path << ": " << change.before << " → " << change.after;
            }
        }
    for (const auto& [kind, count] : kinds) EXPECT_GT(count, 5) << kind;
    EXPECT_GE(kinds.size(), 7U);
}

// Each fragment shader of a folder, drawn with the vertex shader of its name if there is one.
void expect_translated(const std::string& folder) {
    const Scratch scratch;
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".frag") continue;
        const std::filesystem::path vertex = std::filesystem::path(entry.path()).replace_extension(".vert");
        std::string scene = "Fragment " + entry.path().string() + "\nProgram A\nSphere 1.\n";
        if (std::filesystem::exists(vertex)) scene = "Vertex " + vertex.string() + "\n" + scene;
        const Found found(scratch.write("scene.glib", scene));
        expect_right(found, entry.path());
        if (!translation_errors(found, {}).empty()) continue;
        for (const Change& change : found.changes) {
            ++count;
            EXPECT_EQ(translation_errors(found, {&change}), "")
                << entry.path() << change.before << " → " << change.after;
        }
    }
    EXPECT_GT(count, 20) << folder;
}

TEST(FoundCorpus, ShadersOfEveryDialect) { expect_translated(SNELL_ROOT "/tests/glsl"); }

TEST(FoundCorpus, ShadersOfOthers) {
    const std::string corpus = SNELL_ROOT "/../shared/corpus";
    if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "there is no " << corpus;
    expect_translated(corpus);
}

TEST(FoundCorpus, TwiceTheSame) {
    const std::string path = SNELL_ROOT "/scenes/light/globe/globe.glib";
    const Found a(path), b(path);
    ASSERT_EQ(a.changes.size(), b.changes.size());
    for (std::size_t i = 0; i < a.changes.size(); ++i) {
        EXPECT_EQ(a.changes[i].edits, b.changes[i].edits);
        EXPECT_EQ(a.changes[i].where, b.changes[i].where);
    }
}

// Fragments that damage makes of shaders, and any bytes.
class FoundRobust : public FoundShaders {
protected:
    void read(const std::string& vertex, const std::string& fragment) {
        folder_.write("d.vert", vertex);
        folder_.write("d.frag", fragment);
        const Found found(
            folder_.write("d.glib", "Vertex d.vert\nFragment d.frag\nProgram D uA <0. 1. 2.>\nSphere 1.\n"));
        for (const Change& change : found.changes)
            for (const Edit& edit : change.edits) ASSERT_LE(edit.span.end, found.sources.text(edit.span.file).size());
        std::vector<const Change*> together;
        for (const Change& change : found.changes)
            if (std::all_of(together.begin(), together.end(), [&](const Change* c) { return compatible(*c, change); }))
                together.push_back(&change);
        EXPECT_LE(changed_texts(together, found.sources).size(), 2U);
    }
};

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    const auto letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
    for (std::size_t i = 0, end = 0; i < text.size(); i = end) {
        for (end = i + 1; end < text.size() && letter(text[i]) && letter(text[end]);) ++end;
        words.push_back(text.substr(i, end - i));
    }
    return words;
}

TEST_F(FoundRobust, DamagedShaders) {
    const std::string vertex =
        "varying vec3 vN;\nuniform float uA;\nvoid main() { vN = gl_Normal; gl_Position = ftransform(); }\n";
    const std::vector<std::string> words = words_of(
        "#version 330 compatibility\n#define N 16\n#define SQ(x) ((x)*(x))\nvarying vec3 vN;\nuniform float uA, uB;\n"
        "uniform int uN;\nconst int M = 8;\nfloat f(float x, out float y, int n) { y = 0.; for (int i = 0; i < n; i++) "
        "y "
        "+= x; return y + sin(x) * 2.; }\nvoid main() {\nvec3 c = mix(vN, vec3(uA), uB) + normalize(vN) - pow(vN, "
        "vec3(2.));\nfor (int i = 0; i < N; ++i) { if (i >= uN) break; c += vN / float(N); }\nfloat t = 0., q;\n"
        "while (t < 9.) t += exp(-uA);\nc.x += f(atan(vN.y, vN.x), q, M) * SQ(uA);\nif (q > 1.) c -= cos(c); else c[1] "
        "= "
        "acos(q);\ngl_FragColor = vec4(c * (sin(uA) + 1.), 1.);\n}\n");
    std::mt19937 random(5);
    for (int round = 0; round < 400; ++round) {
        std::vector<std::string> damaged = words;
        for (unsigned k = 0; k <= random() % 4; ++k) {
            const std::size_t a = random() % damaged.size(), b = random() % damaged.size();
            if (random() % 3 == 0)
                damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(a));
            else if (random() % 2 == 0)
                damaged.insert(damaged.begin() + static_cast<std::ptrdiff_t>(a), words[random() % words.size()]);
            else
                std::swap(damaged[a], damaged[b]);
        }
        std::string text;
        for (const std::string& word : damaged) text += word;
        read(round % 2 ? vertex : text, text);
    }
}

TEST_F(FoundRobust, WhatTheFuzzerFound) {
    int count = 0;
    for (const char* folder : {"fuzz/glsl_corpus", "glsl", "odd"})
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(SNELL_ROOT "/tests/" + std::string(folder))) {
            if (!entry.is_regular_file() || entry.file_size() > 200'000) continue;
            const std::string text = bytes_of(entry.path());
            read("void main() { gl_Position = ftransform(); }\n", text);
            if (++count % 4 == 0) read(text.substr(0, text.size() / 2), text.substr(text.size() / 3));
        }
}

// Long and deep texts take time in proportion to their length.
TEST_F(FoundRobust, LargeTexts) {
    const auto many = [](int n, const std::string& text) {
        std::string all;
        for (int i = 0; i < n; ++i) all += text;
        return all;
    };
    const std::string ahead = "varying vec3 vN;\nuniform float uA;\n",
                      vertex = ahead + "void main() { vN = gl_Normal; gl_Position = ftransform(); }\n";
    const auto in_main = [&](const std::string& body) {
        return ahead + "void main() {\nfloat x = 0.;\n" + body + "gl_FragColor = vec4(x);\n}\n";
    };
    for (const std::string& text :
         {in_main("x = vN.x" + many(8'000, " + sin(vN.x)") + ";\n"), in_main("x = " + many(8'000, "(") + "uA;\n"),
          in_main(many(2'000, "for (int i = 0; i < 8; i++) x += sin(uA);\n")),
          in_main(many(1'500, "{ float y = sin(vN.x); x += y; }\n")),
          in_main("x = f(" + many(8'000, "uA, ") + "uA);\n"), in_main(many(1'500, "if (x < 1.) { ")),
          ahead + many(1'000, "float f(float x) { return pow(x, 2.2) + f(x * vN.x); }\n") + in_main("")}) {
        const double begin = cpu_milliseconds();
        read(vertex, text);
        EXPECT_LT(cpu_milliseconds() - begin, 5e3 * patience) << text.substr(0, 120);
    }
}

}  // namespace
}  // namespace snell::accuracy::test
