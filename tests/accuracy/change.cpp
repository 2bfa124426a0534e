#include "src/accuracy/found/change.h"
#include "tests/std.h"

namespace snell::accuracy {
namespace {

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
