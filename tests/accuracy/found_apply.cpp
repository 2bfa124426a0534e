// Found rungs by number, and the texts that they make.
#include "src/accuracy/found/change.h"
#include "src/document/document.h"
#include "tests/scratch.h"
#include "tests/std.h"

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
        plan = read_plan(path, *files, sources, diagnostics).value();
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
    Scratch folder;
    std::optional<Files> files;
    Sources sources;
    Plan plan;
};

TEST_F(FoundApply, NumbersNameChanges) {
    read_shader("void main() {\n  float a = 1.;\n  gl_FragColor = vec4(a);\n}\n");
    const std::vector<Change> changes{change({edit("q.frag", "1.", "2.")}),
                                      change({edit("q.frag", "vec4(a)", "vec4(1.)")}),
                                      change({edit("q.frag", "(a)", "(0.)")})};
    std::string error;
    const auto both = choose_changes("2+1", changes, sources, error);
    ASSERT_TRUE(both) << error;
    EXPECT_EQ(both->numbers, (std::vector<std::size_t>{1, 2}));
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
    EXPECT_EQ(line_end_of("a\rb"), "\r");
    EXPECT_EQ(line_end_of("a"), "\n");
}

TEST_F(FoundApply, EditsOfTheSceneAreMadeToo) {
    read_shader("void main() { gl_FragColor = vec4(1.); }\n");
    const Change cells = change({edit("s.glib", ".2 2.", ".2 3.")}, ChangeKind::fewer_cells);
    EXPECT_NE(plainly({cells}).at("s.glib").find("QuadXY .2 3.\n"), std::string::npos);
}

TEST(Change, EditsAreMadeInAnyOrderAndTheRestStays) {
    Sources sources;
    const FileId file = sources.add("a.frag", "float a = f(x) + g(y); // é\r\n");
    const Change g{ChangeKind::without_term, {file, 15, 21}, "", "", {{{file, 14, 21}, ""}}};
    const Change f{
        ChangeKind::polynomial, {file, 10, 14}, "", "", {{{file, 10, 11}, "poly"}, {{file, 0, 0}, "// p\n"}}};
    const std::array<const Change*, 2> both{&g, &f};
    const auto texts = changed_texts(both, sources);
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_EQ(texts.at("a.frag"), "// p\nfloat a = poly(x); // é\r\n");
}

TEST(Change, AnInsertionComesAheadOfWhatIsReplacedAtItsPlace) {
    Sources sources;
    const FileId file = sources.add("a.frag", "ab");
    const Change replaced{ChangeKind::without_term, {}, "", "", {{{file, 1, 2}, "B"}}};
    const Change inserted{ChangeKind::without_term, {}, "", "", {{{file, 1, 1}, "+"}}};
    const std::array<const Change*, 2> one{&replaced, &inserted}, other{&inserted, &replaced};
    EXPECT_EQ(changed_texts(one, sources).at("a.frag"), "a+B");
    EXPECT_EQ(changed_texts(other, sources).at("a.frag"), "a+B");
}

TEST(Change, AnEditThatOverlapsTheOneBeforeIsLeftOut) {
    const std::array<Edit, 3> edits{{{{0, 0, 2}, "A"}, {{0, 1, 3}, "B"}, {{0, 3, 4}, "D"}}};
    EXPECT_EQ(with_edits("abcd", 0, edits), "AcD");
    EXPECT_EQ(with_edits("ab", 0, edits), "A") << "nor is what is behind the end changed";
}

TEST(Change, ATextThatWasReadTwiceIsOneText) {
    Sources sources;
    const FileId first = sources.add("a.frag", "ab"), second = sources.add("a.frag", "ab");
    const Change a{ChangeKind::without_term, {}, "", "", {{{first, 0, 1}, "A"}}};
    const Change b{ChangeKind::without_term, {}, "", "", {{{second, 1, 2}, "B"}}};
    const std::array<const Change*, 2> both{&a, &b};
    EXPECT_EQ(changed_texts(both, sources).at("a.frag"), "AB");
}

TEST(Change, EditsThatTouchAreNotMadeTogether) {
    const auto change = [](FileId file, std::uint32_t begin, std::uint32_t end) {
        return Change{ChangeKind::polynomial, {}, "", "", {{{file, begin, end}, "x"}}};
    };
    EXPECT_TRUE(compatible(change(0, 0, 4), change(0, 5, 9)));
    EXPECT_TRUE(compatible(change(0, 0, 4), change(1, 2, 3)));
    EXPECT_FALSE(compatible(change(0, 0, 4), change(0, 2, 3)));
    EXPECT_FALSE(compatible(change(0, 0, 4), change(0, 4, 4))) << "an insertion at the edge has no order";
    EXPECT_FALSE(compatible(change(0, 4, 4), change(0, 4, 4)));
}

TEST(Change, ExcerptsAreOneLineAndWholeCharacters) {
    EXPECT_EQ(excerpt("  a\r\n\t+ b  "), "a + b");
    std::string umlauts;
    for (int i = 0; i < 50; ++i) umlauts += "ä";
    for (std::size_t pad = 0; pad < 4; ++pad) {
        const std::string cut = excerpt(std::string(pad, 'x') + umlauts);
        EXPECT_LE(cut.size(), 66u);
        EXPECT_NE(cut.find("…"), std::string::npos);
        for (std::size_t i = pad; i + 1 < cut.size();) {
            const auto lead = static_cast<unsigned char>(cut[i]);
            ASSERT_NE(lead & 0xC0, 0x80) << "a character's first byte is there: " << cut;
            i += lead < 0x80 ? 1 : lead < 0xE0 ? 2 : 3;
        }
    }
}

TEST(Change, EachKindHasARowAndAName) {
    std::set<std::string_view> names;
    for (int kind = 0; kind < static_cast<int>(ChangeKind::count); ++kind) {
        const KindFacts& row = facts(static_cast<ChangeKind>(kind));
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(row.doc.empty());
        EXPECT_EQ(static_cast<int>(row.kind), kind);
    }
}

}  // namespace
}  // namespace snell::accuracy
