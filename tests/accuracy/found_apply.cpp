// Found rungs by number, and the texts that they make: plain edits and ladders.
#include "src/accuracy/found/apply.h"

#include <gtest/gtest.h>

#include <map>

#include "src/accuracy/found/ladder.h"
#include "src/document/document.h"
#include "tests/scratch.h"

namespace snell::accuracy {
namespace {

constexpr std::string_view quad_vertex = "void main() { gl_Position = gl_Vertex; }\n";
constexpr std::string_view one_program = "##OpenGL GLIB\nVertex q.vert\nFragment q.frag\nProgram Q\nQuadXY .2 2.\n";

// A scene with its files, and changes of it made manually.
class FoundApply : public testing::Test {
protected:
    void read(const std::map<std::string, std::string>& texts) {
        for (const auto& [name, text] : texts) folder.write(name, text);
        const std::string path = folder.path("s.glib");
        files.emplace(scene_folder(path));
        Diagnostics diagnostics;
        auto parsed = parse_document(path, *files, sources, diagnostics);
        ASSERT_TRUE(parsed);
        plan = make_plan(std::move(parsed->scene), *files, sources, diagnostics);
        EXPECT_FALSE(diagnostics.has_errors()) << render(diagnostics, sources);
    }
    void read_shader(const std::string& text) {
        read({{"s.glib", std::string(one_program)}, {"q.vert", std::string(quad_vertex)}, {"q.frag", text}});
    }

    FileId file(const std::string& name) const {
        for (FileId file = 0; file < sources.size(); ++file)
            if (sources.name(file) == folder.path(name)) return file;
        ADD_FAILURE() << "no text " << name;
        return 0;
    }
    // `before` must be in the text once; the edit is at its first character if it is inserted in front of it.
    Edit edit(const std::string& name, std::string_view before, const std::string& after) const {
        const std::string_view text = sources.text(file(name));
        const std::size_t at = text.find(before);
        EXPECT_NE(at, std::string_view::npos) << before;
        EXPECT_EQ(text.find(before, at + 1), std::string_view::npos) << before;
        return {{file(name), static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + before.size())}, after};
    }
    Edit inserted(const std::string& name, std::string_view in_front_of, const std::string& text) const {
        Edit insertion = edit(name, in_front_of, text);
        insertion.span.end = insertion.span.begin;
        return insertion;
    }
    static Change change(std::vector<Edit> edits, ChangeKind kind = ChangeKind::fewer_rounds) {
        return {kind, edits.front().span, "before", "after", std::move(edits)};
    }

    AsLadders ladders(const std::vector<Change>& changes, const std::vector<std::string>& names = {"1"}) {
        std::vector<Chosen> chosen;
        std::string error;
        for (const std::string& name : names) {
            auto one = choose_changes(name, changes, sources, error);
            EXPECT_TRUE(one) << error;
            if (one) chosen.push_back(std::move(*one));
        }
        return as_ladders(plan, *files, sources, 0, chosen);
    }
    // The texts after the change, by their names in the folder.
    std::map<std::string, std::string> texts(const Change& made) const {
        const std::array<const Change*, 1> all{&made};
        std::map<std::string, std::string> by_name;
        for (auto& [path, text] : changed_texts(all, sources))
            by_name[path.substr(folder.path().size() + 1)] = std::move(text);
        return by_name;
    }
    std::map<std::string, std::string> plainly(const std::vector<Change>& changes, const std::string& name = "1") {
        std::string error;
        const auto chosen = choose_changes(name, changes, sources, error);
        EXPECT_TRUE(chosen) << error;
        Change all;
        for (const Change& one : chosen->changes) all.edits.insert(all.edits.end(), one.edits.begin(), one.edits.end());
        return texts(all);
    }
    // What remains of a shader for one rung, and that it is the author's text or the changed one.
    void expect_both(const std::vector<Change>& changes);

    Scratch folder;
    std::optional<Files> files;
    Sources sources;
    Plan plan;
};

// The text without the groups of the ladders FOUND_…, of which those lines stay that a rung chooses.
std::string chosen_lines(const std::string& text, bool as_written) {
    std::string kept;
    bool within = false, keep = true;
    int depth = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        const std::size_t next = text.substr(end).starts_with("\r\n") ? end + 2 : std::min(end + 1, text.size());
        const std::string line = text.substr(at, end - at);
        if (!within && line.starts_with("#if FOUND_")) {
            within = true;
            keep = as_written == line.ends_with("_as_written");
        } else if (within && depth == 0 && line == "#else") {
            keep = !keep;
        } else if (within && depth == 0 && line == "#endif") {
            within = false, keep = true;
        } else {
            if (within && line.starts_with("#if")) ++depth;
            if (within && line.starts_with("#endif")) --depth;
            if (keep) kept += text.substr(at, next - at);
        }
        at = next;
    }
    return kept;
}

void FoundApply::expect_both(const std::vector<Change>& changes) {
    const AsLadders made = ladders(changes);
    ASSERT_EQ(made.error, "");
    for (const auto& [name, text] : plainly(changes)) {
        const std::string both = texts(made.change).at(name);
        EXPECT_EQ(chosen_lines(both, true), sources.text(file(name))) << both;
        EXPECT_EQ(chosen_lines(both, false), text) << both;
    }
}

TEST_F(FoundApply, NumbersNameChanges) {
    read_shader("void main() {\n  float a = 1.;\n  gl_FragColor = vec4(a);\n}\n");
    const std::vector<Change> changes{change({edit("q.frag", "1.", "2.")}),
                                      change({edit("q.frag", "vec4(a)", "vec4(1.)")}),
                                      change({edit("q.frag", "(a)", "(0.)")})};
    std::string error;
    const auto both = choose_changes("2+1", changes, sources, error);
    ASSERT_TRUE(both) << error;
    EXPECT_EQ(both->numbers, (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(chosen_name(*both), "1+2");
    for (const char* name : {"4", "0", "99999999999999999999999", "1+", "-1", "", "1 +2", "1;2"}) {
        EXPECT_FALSE(choose_changes(name, changes, sources, error)) << name;
        EXPECT_NE(error.find("from 1 to 3"), std::string::npos) << name << ": " << error;
    }
    EXPECT_FALSE(choose_changes("2+3", changes, sources, error));
    EXPECT_EQ(error, "2 and 3 change the same text");
    EXPECT_FALSE(choose_changes("1", {}, sources, error));
    EXPECT_NE(error.find("finds nothing to change"), std::string::npos);
}

TEST_F(FoundApply, ATextThatSeveralIncludeIsEditedOnce) {
    read_shader("void main() { gl_FragColor = vec4(1.); }\n");
    const FileId again = sources.add(folder.path("q.frag"), std::string(sources.text(file("q.frag"))));
    Edit one = edit("q.frag", "1.", "2."), same = one;
    same.span.file = again;
    EXPECT_EQ(plainly({change({one, same})}).at("q.frag"), "void main() { gl_FragColor = vec4(2.); }\n");
    std::string error;
    const std::vector<Change> changes{change({one}), change({same}, ChangeKind::polynomial)};
    EXPECT_FALSE(choose_changes("1+2", changes, sources, error)) << "they are one text";
}

TEST_F(FoundApply, LineEndsAndBytesOfTheTextStay) {
    read_shader("// \xe9t\xe9, \xC3\xA9\r\nvoid main() {\r\n  gl_FragColor = vec4(1.);\r\n}");
    const std::vector<Change> changes{
        change({inserted("q.frag", "void main", "float f;\nfloat g;\n"), edit("q.frag", "vec4(1.)", "vec4(\r\n2.)")})};
    EXPECT_EQ(plainly(changes).at("q.frag"),
              "// \xe9t\xe9, \xC3\xA9\r\nfloat f;\r\nfloat g;\r\nvoid main() {\r\n  gl_FragColor = vec4(\r\n2.);\r\n}");
    expect_both(changes);
    const AsLadders made = ladders(changes);
    EXPECT_EQ(texts(made.change).at("q.frag"),
              "// \xe9t\xe9, \xC3\xA9\r\n#if FOUND_1 == FOUND_1_fewer_rounds\r\nfloat f;\r\nfloat g;\r\n#endif\r\n"
              "void main() {\r\n#if FOUND_1 == FOUND_1_fewer_rounds\r\n  gl_FragColor = vec4(\r\n2.);\r\n#else\r\n"
              "  gl_FragColor = vec4(1.);\r\n#endif\r\n}");
    EXPECT_EQ(line_end_of("a\rb"), "\r");
    EXPECT_EQ(line_end_of("a"), "\n");
}

TEST_F(FoundApply, ALadderHasTheAuthorsRungAsItsCurrentOne) {
    read_shader(
        "void main() {\n  float a = 0.;\n  for (int i = 0; i < 8; ++i) a += .1; // rounds\n"
        "  gl_FragColor = vec4(a);\n}\n");
    const AsLadders cheaper = ladders({change({edit("q.frag", "8", "4")})});
    EXPECT_EQ(texts(cheaper.change).at("q.frag"),
              "void main() {\n  float a = 0.;\n#if FOUND_1 == FOUND_1_fewer_rounds\n"
              "  for (int i = 0; i < 4; ++i) a += .1; // rounds\n#else\n"
              "  for (int i = 0; i < 8; ++i) a += .1; // rounds\n#endif\n  gl_FragColor = vec4(a);\n}\n");
    EXPECT_EQ(texts(cheaper.change).at("s.glib"),
              "##OpenGL GLIB\nLadder FOUND_1 fewer_rounds <as_written>\nVertex q.vert\nFragment q.frag\nProgram Q\n"
              "QuadXY .2 2.\n");
    const AsLadders better = ladders({change({edit("q.frag", "8", "80")}, ChangeKind::more_rounds)});
    EXPECT_EQ(better.statements, std::vector<std::string>{"Ladder FOUND_1 <as_written> more_rounds"});
    const Change mean = change({edit("q.frag", ".1", ".2")}, ChangeKind::lookup_mean);
    const Change more = change({edit("q.frag", "8", "80")}, ChangeKind::more_rounds);
    EXPECT_EQ(ladders({more, more}, {"1"}).error, "");
    const AsLadders mixed = ladders({mean, more}, {"1+2"});
    EXPECT_NE(mixed.error.find("both cheaper and better"), std::string::npos) << mixed.error;
    EXPECT_NE(mixed.help.find("--as-ladder 1,2"), std::string::npos) << mixed.help;
}

TEST_F(FoundApply, StatementsOfSeveralLinesAreDoubledWhole) {
    read_shader(
        "float f(float x) { return x; }\nvoid main() {\n  float a = 1. +  /* one\n  two */ f(\n    2.)\n"
        "    ; float b =\n    a;\n  if (a > 1.)\n    a = 3.;\n  const vec2 c[2] = vec2[](\n    vec2(4.),\n"
        "    vec2(5.));\n  gl_FragColor = vec4(a + b + c[1].x);\n}\n");
    for (const char* number : {"2.)", "3.", "4.", "5.", "1. +", "a + b"}) {
        SCOPED_TRACE(number);
        expect_both({change({edit("q.frag", number, "9.)" + std::string(number).substr(2))})});
    }
    EXPECT_EQ(texts(ladders({change({edit("q.frag", "2.)", "7.)")})}).change).at("q.frag"),
              "float f(float x) { return x; }\nvoid main() {\n#if FOUND_1 == FOUND_1_fewer_rounds\n"
              "  float a = 1. +  /* one\n  two */ f(\n    7.)\n    ; float b =\n    a;\n#else\n"
              "  float a = 1. +  /* one\n  two */ f(\n    2.)\n    ; float b =\n    a;\n#endif\n  if (a > 1.)\n"
              "    a = 3.;\n  const vec2 c[2] = vec2[](\n    vec2(4.),\n    vec2(5.));\n"
              "  gl_FragColor = vec4(a + b + c[1].x);\n}\n");
}

TEST_F(FoundApply, ListsOfValuesAreOneStatement) {
    read_shader(
        "#version 420\nconst float c[2] = {\n  4.,\n  5.\n};\nout vec4 color;\nvoid main() {\n  color = "
        "vec4(c[1]);\n}\n");
    const std::string text = texts(ladders({change({edit("q.frag", "5.", "7.")})}).change).at("q.frag");
    EXPECT_NE(text.find("#if FOUND_1 == FOUND_1_fewer_rounds\nconst float c[2] = {\n  4.,\n  7.\n};\n#else\n"),
              std::string::npos)
        << text;
}

TEST_F(FoundApply, LinesWithinCommentsAndContinuedLinesAreNotDivided) {
    read_shader(
        "/* a\n b */ float g = 1.; /* c\n d */\nvoid main() {\n  float a = 2.; // e \\\n  f = 7.;\n"
        "  gl_FragColor = vec4(a + g);\n}\n");
    expect_both({change({edit("q.frag", "1.", "3.")})});
    expect_both({change({edit("q.frag", "2.", "3.")})});
    const std::string text = texts(ladders({change({edit("q.frag", "2.", "3.")})}).change).at("q.frag");
    EXPECT_NE(text.find("  float a = 3.; // e \\\n  f = 7.;\n#else\n"), std::string::npos) << text;
    EXPECT_TRUE(
        texts(ladders({change({edit("q.frag", "1.", "3.")})}).change)
            .at("q.frag")
            .starts_with("#if FOUND_1 == FOUND_1_fewer_rounds\n/* a\n b */ float g = 3.; /* c\n d */\n#else\n"));
}

TEST_F(FoundApply, EditsAtAnyPlaceGiveBothTexts) {
    const std::string shader =
        "#version 120\n#ifdef A\nfloat z = 1.;\n#endif\nfloat f(float x) {\n  return x *\n    2.; }\n\n"
        "void main()\n{\n  float a = 0.;\n  for (int i = 0;\n       i < 3; ++i) {\n    a += f(a); }\n"
        "#ifdef B\n  a = 1.;\n#else\n  a = 2. +\n    3.;\n#endif\n  gl_FragColor = vec4(a);\n}";
    read_shader(shader);
    std::size_t made = 0;
    for (std::uint32_t begin = 0; begin <= shader.size(); ++begin)
        for (const std::uint32_t length : {0u, 1u, 9u, 30u}) {
            const std::uint32_t end = begin + length;
            if (end > shader.size()) continue;
            // A number, so that no directive and no comment comes or goes.
            const bool insertion = length == 0;
            const std::string old = shader.substr(begin, length);
            if (old.find('#') != std::string::npos || old.find("\n") != std::string::npos) continue;
            const Change one = change({{{file("q.frag"), begin, end}, insertion ? "7\n" : "7"}});
            const AsLadders both = ladders({one});
            if (!both.error.empty()) continue;
            ++made;
            const std::string text = texts(both.change).at("q.frag");
            // The last line has no end, but there must be one before a directive.
            const bool last = chosen_lines(text, true) != shader;
            const std::string end_of_last = last ? "\n" : "";
            ASSERT_TRUE(!last || end > shader.rfind('\n')) << begin << "+" << length << "\n" << text;
            ASSERT_EQ(chosen_lines(text, true), shader + end_of_last) << begin << "+" << length << "\n" << text;
            const std::string changed = plainly({one}).at("q.frag");
            ASSERT_EQ(chosen_lines(text, false), changed + (changed.back() == '\n' ? "" : end_of_last))
                << begin << "+" << length << "\n"
                << text;
        }
    EXPECT_GT(made, 400u);
}

TEST_F(FoundApply, EditsInDirectivesAreRefused) {
    read_shader(
        "#version 120\n#define HALF \\\n  .5\n#ifdef A\n#define B 7\n#endif\nvoid main() {\n  float a = HALF;\n"
        "#ifdef B\n  a = 1.;\n#else\n  a = 2.;\n#endif\n  gl_FragColor = vec4(a);\n}\n");
    const auto refused = [&](const Edit& one, std::string_view why) {
        const AsLadders made = ladders({change({one})});
        EXPECT_NE(made.error.find(why), std::string::npos) << made.error;
        EXPECT_NE(made.help.find("--apply 1"), std::string::npos) << made.help;
        ASSERT_TRUE(made.where);
        EXPECT_EQ(made.where->file, file("q.frag"));
    };
    refused(edit("q.frag", ".5", ".25"), "in a macro (#define)");
    refused(edit("q.frag", "#ifdef B", "#ifdef C"), "one end of a group");
    refused(edit("q.frag", "ifdef A", "ifdef C"), "in a directive (#ifdef)");
    refused(edit("q.frag", "1.;\n#else\n  a = 2.", "3."), "one end of a group");
    refused(edit("q.frag", "#endif\nvoid main() {\n  float a = HALF;\n#ifdef B", ""), "one end of a group");
    refused(inserted("q.frag", "#version", "float f;\n"), "before #version");
    expect_both({change({edit("q.frag", "  a = 1.;\n", "")})});
    expect_both({change({edit("q.frag", "#ifdef B\n  a = 1.;\n#else\n  a = 2.;\n#endif\n", "  a = 3.;\n")})});
}

TEST_F(FoundApply, EditsOfTheSceneAreNoLadders) {
    read_shader("void main() { gl_FragColor = vec4(1.); }\n");
    const Change cells = change({edit("s.glib", ".2 2.", ".2 3.")}, ChangeKind::fewer_cells);
    EXPECT_NE(plainly({cells}).at("s.glib").find("QuadXY .2 3.\n"), std::string::npos);
    const AsLadders made = ladders({cells});
    EXPECT_NE(made.error.find("1 changes the scene's text, and a ladder chooses among lines of shaders only"),
              std::string::npos)
        << made.error;
    EXPECT_NE(made.help.find("--apply 1"), std::string::npos);
}

TEST_F(FoundApply, BothStagesShareALadderAndIncludedTextsToo) {
    read({{"s.glib",
           "Vertex q.vert\nFragment other.frag\nProgram First\nQuadXY .1 1.\nLadder FOUND_1 a <b>\n"
           "Vertex q.vert \\\n\nVertex \\\n  # which one\n  q.vert\nFragment q.frag\nProgram Q\nQuadXY .2 2.\n"},
          {"q.vert", "varying float v;\nvoid main() { v = 1.; gl_Position = gl_Vertex; }\n"},
          {"other.frag", "void main() { gl_FragColor = vec4(1.); }\n"},
          {"q.frag", "#include \"sub/inner.glsl\"\nvoid main() {\n  gl_FragColor = vec4(inner());\n}\n"},
          {"sub/inner.glsl", "float inner() { return 3.; }\n"}});
    const FileId inner = sources.add(folder.path("sub/inner.glsl"), bytes_of(folder.path("sub/inner.glsl")));
    ASSERT_EQ(inner, file("sub/inner.glsl"));
    const Change include = change({edit("sub/inner.glsl", "3.", "4."), edit("q.frag", "inner())", "inner() + 1.)")});
    const auto made = ladders({include});
    ASSERT_EQ(made.error, "");
    EXPECT_EQ(made.statements, std::vector<std::string>{"Ladder FOUND_1_v2 fewer_rounds <as_written>"});
    const auto changed = texts(made.change);
    EXPECT_NE(changed.at("s.glib").find("\nLadder FOUND_1_v2 fewer_rounds <as_written>\nVertex \\\n  # which one\n"),
              std::string::npos)
        << changed.at("s.glib");
    EXPECT_TRUE(changed.at("sub/inner.glsl").starts_with("#if FOUND_1_v2 == FOUND_1_v2_fewer_rounds\n"));
    // The vertex shader is the first program's, too.
    const auto earlier = texts(ladders({change({edit("q.vert", "1.", "2."), edit("q.frag", "inner()", "2.")})}).change);
    EXPECT_TRUE(earlier.at("s.glib").starts_with("Ladder FOUND_1_v2 fewer_rounds <as_written>\nVertex q.vert\n"));
}

TEST_F(FoundApply, AnIncludedProgramIsPrecededByItsLadder) {
    read({{"s.glib", "##OpenGL GLIB\r\n# a comment\r\n\r\nPerspective 60\r\nInclude p.inc\r\nQuadXY .2 2.\r\n"},
          {"p.inc", "Vertex q.vert\nFragment q.frag\nProgram Q\n"},
          {"q.vert", std::string(quad_vertex)},
          {"q.frag", "void main() { gl_FragColor = vec4(1.); }\n"}});
    const auto made = texts(ladders({change({edit("q.frag", "1.", "2.")})}).change);
    EXPECT_TRUE(made.at("s.glib").starts_with(
        "##OpenGL GLIB\r\n# a comment\r\n\r\nLadder FOUND_1 fewer_rounds <as_written>\r\nPerspective 60\r\n"))
        << made.at("s.glib");
    EXPECT_FALSE(made.contains("p.inc"));
}

TEST_F(FoundApply, SeveralLaddersHaveLinesOfTheirOwn) {
    read_shader("void main() {\n  float a = 1., b = 2.;\n  float c = 3.;\n  gl_FragColor = vec4(a + b + c);\n}\n");
    const std::vector<Change> changes{change({edit("q.frag", "1.", "7.")}), change({edit("q.frag", "2.", "8.")}),
                                      change({edit("q.frag", "3.", "9.")}, ChangeKind::polynomial)};
    const AsLadders both = ladders(changes, {"1", "3"});
    ASSERT_EQ(both.error, "");
    EXPECT_EQ(both.statements, (std::vector<std::string>{"Ladder FOUND_1 fewer_rounds <as_written>",
                                                         "Ladder FOUND_3 polynomial <as_written>"}));
    EXPECT_EQ(texts(both.change).at("q.frag"),
              "void main() {\n#if FOUND_1 == FOUND_1_fewer_rounds\n  float a = 7., b = 2.;\n#else\n"
              "  float a = 1., b = 2.;\n#endif\n#if FOUND_3 == FOUND_3_polynomial\n  float c = 9.;\n#else\n"
              "  float c = 3.;\n#endif\n  gl_FragColor = vec4(a + b + c);\n}\n");
    const AsLadders same = ladders(changes, {"1", "2"});
    EXPECT_NE(same.error.find("1 and 2 change the same lines"), std::string::npos) << same.error;
    EXPECT_NE(same.help.find("--as-ladder 1+2"), std::string::npos) << same.help;
    for (const std::vector<std::string>& names : {std::vector<std::string>{"1", "1"}, {"1", "3", "1"}, {"1+3", "3"}}) {
        const AsLadders twice = ladders(changes, names);
        EXPECT_NE(twice.error.find(" is given twice"), std::string::npos) << twice.error;
    }
    const std::vector<Change> others{changes.front(), change({edit("q.frag", "1.", "6.")})};
    const AsLadders touching = ladders(others, {"1", "2"});
    EXPECT_NE(touching.error.find("1 and 2 change the same lines"), std::string::npos) << touching.error;
    EXPECT_EQ(touching.help, "") << "they cannot be one ladder, either";
    const AsLadders one = ladders(changes, {"1+2"});
    EXPECT_EQ(one.statements, std::vector<std::string>{"Ladder FOUND_1_2 changed <as_written>"});
    EXPECT_EQ(chosen_lines(texts(one.change).at("q.frag"), false), plainly(changes, "1+2").at("q.frag"));
}

// Whatever is found in the scenes that ship.
TEST_F(FoundApply, LaddersOfShippedScenesHoldBothTexts) {
    std::size_t shaders = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(SNELL_ROOT "/scenes")) {
        if (entry.path().extension() != ".glib") continue;
        const std::string path = entry.path().string();
        Files reader(scene_folder(path));
        Sources read;
        Diagnostics unheard;
        auto parsed = parse_document(path, reader, read, unheard);
        const Plan planned = make_plan(std::move(parsed->scene), reader, read, unheard);
        const std::vector<Change> changes = find_changes(planned, reader, read);
        for (std::size_t i = 0; i < changes.size(); ++i) {
            std::string error;
            const auto chosen = choose_changes(std::to_string(i + 1), changes, read, error);
            ASSERT_EQ(chosen.has_value(), changes[i].probes.empty()) << error;
            if (!chosen) continue;  // a number is missing that is drawn
            const AsLadders made = as_ladders(planned, reader, read, 0, std::span(&*chosen, 1));
            if (!made.error.empty()) continue;
            const std::array<const Change*, 1> ladder{&made.change}, plain{&chosen->changes.front()};
            const auto both = changed_texts(ladder, read);
            for (const auto& [name, text] : changed_texts(plain, read)) {
                ++shaders;
                ASSERT_EQ(chosen_lines(both.at(name), true), bytes_of(name)) << path << " " << i + 1;
                ASSERT_EQ(chosen_lines(both.at(name), false), text) << path << " " << i + 1;
            }
        }
    }
    RecordProperty("shaders", static_cast<int>(shaders));
}

}  // namespace
}  // namespace snell::accuracy
