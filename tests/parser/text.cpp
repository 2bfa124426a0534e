// Sources, numbers, characters, suggestions, rendering.
#include <charconv>

#include "parser/commands/commands.h"
#include "parser/text/diagnostic.h"
#include "parser/text/number.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "tests/decimal_comma.h"
#include "tests/parser/support.h"
#include "tests/std.h"

namespace snell::test {
namespace {

TEST(Words, AreFoundInAnyCase) {
    static_assert(contains("uBrightness", "BRIGHT") && contains("uEta", "uEta") && contains("uEta", ""));
    static_assert(contains("", "") && !contains("uEta", "uEtas") && !contains("", "a") && !contains("uEta", "ea"));
    EXPECT_FALSE(contains("\xC3\xA9", "\xC3\x89")) << "ASCII only";
}

TEST(Words, AreOneOrMoreOfAKind) {
    EXPECT_EQ(counted(1, "file"), "1 file");
    EXPECT_EQ(counted(0, "file"), "0 files");
    EXPECT_EQ(counted(2, "pass"), "2 passes");
    static_assert(article("int") == "an" && article("uint") == "a" && article("").size() == 1);
}

TEST(Numbers, AreReadWholeOrNotAtAll) {
    EXPECT_EQ(read_whole<int>("-12"), -12);
    EXPECT_EQ(read_whole<double>("1e3"), 1000.);
    for (const char* text : {"", " 1", "1 ", "+1", "1x", "0x1", "99999999999"})
        EXPECT_FALSE(read_whole<int>(text)) << text;
    EXPECT_FALSE(read_whole<std::size_t>("-1"));
    EXPECT_FALSE(read_whole<double>("1e999"));
}

TEST(Sources, CountLinesAndCharacters) {
    Sources sources;
    const FileId f = sources.add("a", "one\r\ntwo\rthree\n\xC3\xA9\xE9x");
    EXPECT_EQ(sources.position(f, 0).line, 1);
    EXPECT_EQ(sources.position(f, 5).line, 2);
    EXPECT_EQ(sources.position(f, 9).line, 3);
    EXPECT_EQ(sources.position(f, 15).line, 4);
    EXPECT_EQ(sources.position(f, 18).column, 3) << "é is one character, an invalid byte another";
    EXPECT_EQ(sources.line(f, 2), "two");
    EXPECT_EQ(sources.line(f, 3), "three");
    EXPECT_EQ(sources.line(f, 5), "");
    EXPECT_EQ(sources.line(f, 0), "");
    EXPECT_EQ(sources.position(f, 1000).line, 4);
}

TEST(Sources, SpanOfALine) {
    Sources sources;
    const FileId f = sources.add("a", "x\n  vec3 c;  \n");
    EXPECT_EQ(sources.line_span(f, 2), (Span{f, 4, 11}));
    EXPECT_EQ(sources.line_span(f, 2, 8), (Span{f, 9, 10}));
    const Span beyond = sources.line_span(f, 9);
    EXPECT_EQ(beyond.begin, beyond.end);
}

TEST(Sources, EveryPositionIsInsideAndMonotone) {
    Sources sources;
    const FileId f = sources.add("a", "a\r\r\n\n\rb\xC3\xA9\n");
    Position last;
    for (std::uint32_t i = 0; i <= sources.text(f).size(); ++i) {
        const Position p = sources.position(f, i);
        EXPECT_TRUE(p.line > last.line || (p.line == last.line && p.column >= last.column)) << i;
        last = p;
    }
    EXPECT_EQ(last.line, 6);
}

TEST(Number, ReadsWhatScenesWrite) {
    const std::pair<const char*, double> good[] = {
        {"5", 5},       {"5.", 5}, {".5", .5}, {"-.5", -.5},  {"+1", 1},    {"1e-3", 1e-3}, {"-1.E+2", -100},
        {"3e38", 3e38}, {"0", 0},  {"007", 7}, {"1e-400", 0}, {"0.1", 0.1}, {"+.5", .5},    {"1.e2", 100}};
    for (const auto& [text, value] : good) {
        EXPECT_EQ(read_number(text).value, value) << text;
        EXPECT_EQ(read_number(text).fault, NumberFault::none) << text;
    }
}

TEST(Number, FindsFaults) {
    using enum NumberFault;
    const std::tuple<const char*, NumberFault, double> faulty[] = {
        {"0.1.", second_point, .1},   {"-0.6.", second_point, -.6},
        {".05.", second_point, .05},  {"0..", second_point, 0},
        {".1.5", second_point, .1},   {"1.0f", suffix, 1},
        {"1e400", too_large, 0},      {"-1e400", too_large, 0},
        {"1e39", too_large, 0},       {"3.4028236e38", too_large, 0},
        {"nan", not_finite, 0},       {"INF", not_finite, 0},
        {"-infinity", not_finite, 0}, {"0x10", hexadecimal, 0},
        {"1d3", d_exponent, 0},       {"1D+3", d_exponent, 0},
        {"−5", odd_minus, 0},         {"1/2", suffix, 1},
        {"", not_a_number, 0},        {".", not_a_number, 0},
        {"-", not_a_number, 0},       {"+-5", not_a_number, 0},
        {"--5", not_a_number, 0},     {"1e", suffix, 1},
        {"1.2.x", suffix, 1.2},       {"6O", suffix, 6},
        {"O.5", not_a_number, 0}};
    for (const auto& [text, fault, value] : faulty) {
        EXPECT_EQ(read_number(text).fault, fault) << text;
        EXPECT_EQ(read_number(text).value, value) << text;
    }
}

TEST(Number, ShortDecimalsHaveTheBitsOfTheStandardLibrary) {
    std::mt19937 random(3);
    for (int i = 0; i < 100'000; ++i) {
        std::string text = random() % 2 ? "-" : "";
        const std::size_t digits = random() % 17;
        const std::size_t point = random() % 18;
        for (std::size_t d = 0; d <= digits; ++d) {
            if (d == point) text += '.';
            text += static_cast<char>('0' + random() % 10);
        }
        double expected = 0;
        std::from_chars(text.data(), text.data() + text.size(), expected);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read_number(text).value), std::bit_cast<std::uint64_t>(expected))
            << text;
    }
    EXPECT_TRUE(std::signbit(read_number("-0.").value));
}

TEST(Number, SomeWordsOnlyBeginLikeNumbers) {
    for (const char* word : {"3D", "1.bmp", "2nd", "4x4"}) EXPECT_FALSE(plausible_number(word)) << word;
    for (const char* word : {"3", "1.f", "0.1.", "nan", "0x10", "1d3", "1e400"})
        EXPECT_TRUE(plausible_number(word)) << word;
}

TEST(Number, TheLargestFloatFits) {
    EXPECT_TRUE(read_number("3.4028235e38").usable());
    EXPECT_TRUE(read_number("-3.4028234663852886e38").usable());
}

TEST(Number, ShortestTextGivesTheSameBits) {
    for (const double value : {.1, 1. / 3, 1e-300, 12345.678, 3e38, -0.7, 1e22, 5., 4096.}) {
        EXPECT_EQ(read_number(text_of::number(value)).value, value);
        EXPECT_FALSE(written_integral(text_of::number(value)));
    }
    EXPECT_EQ(text_of::number(5, true), "5");
    EXPECT_EQ(text_of::number(1e20, true), "100000000000000000000");
}

TEST(Number, TheLocaleChangesNothing) {
    const DecimalComma locale;
    if (!locale.holds()) GTEST_SKIP() << "no locale with a decimal comma can be made here";
    ASSERT_EQ(std::strtod("1,5", nullptr), 1.5) << "or else this test could not fail";
    const Read r = read("Translate 1.5 2,5 0\nProgram P uA <.5 1.5 2.5>\nSphere .25\n");
    EXPECT_EQ(r.matrix(0)[12], 1.5);
    EXPECT_EQ(r.scene().programs[0].uniforms[0].values, (std::vector{.5, 1.5, 2.5}));
    EXPECT_EQ(text_of::number(.5), "0.5");
}

TEST(Utf8, RefusesWhatIsNotUtf8) {
    EXPECT_EQ(utf8::decode("\xC3\xA9", 0).code, 0xE9u);
    EXPECT_EQ(utf8::decode("\xF0\x9F\x98\x80", 0).length, 4u);
    for (const char* bad :
         {"\xE9", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80", "\xE2\x88"}) {
        EXPECT_FALSE(utf8::decode(bad, 0).valid) << utf8::printable(bad);
        EXPECT_EQ(utf8::decode(bad, 0).length, 1u);
    }
}

TEST(Utf8, PrintableHidesNothing) {
    EXPECT_EQ(utf8::printable("a\x1B[0m\x7F"), "a\\x1B[0m\\x7F");
    EXPECT_EQ(utf8::printable("\xE2\x80\xAE"), "\\u{202E}") << "text that turns direction";
    EXPECT_EQ(utf8::printable("\xE9"), "\xC3\xA9") << "Latin-1";
}

TEST(Nearest, SuggestsWhatWasMeant) {
    EXPECT_EQ(nearest("sphear", command_names()), "Sphere");
    EXPECT_EQ(nearest("Perpsective", command_names()), "Perspective");
    EXPECT_EQ(nearest("QuadXV", command_names()), "QuadXY");
    EXPECT_EQ(nearest("uMxi", {"uEta", "uMix"}), "uMix");
    EXPECT_EQ(nearest("Frobnicate", command_names()), "");
    EXPECT_EQ(nearest("", command_names()), "");
    EXPECT_EQ(nearest(std::string(100'000, 'x'), command_names()), "");
    EXPECT_EQ(nearest("a", {"b"}), "");
}

TEST(Diagnostics, AreSortedBySourceAndKeepTheirOrderElse) {
    Diagnostics d;
    d.warning("w", "without place");
    d.error("b", Span{0, 5, 6}, "");
    d.error("c", Span{0, 5, 7}, "");
    d.error("a", Span{0, 1, 2}, "");
    d.error("other", Span{1, 0, 0}, "");
    d.sort();
    std::string order;
    for (const Diagnostic& item : d.items()) order += item.code + " ";
    EXPECT_EQ(order, "a b c other w ");
    EXPECT_EQ(d.errors(), 4u);
    EXPECT_EQ(d.warnings(), 1u);
    d.append(d);
    EXPECT_EQ(d.items().size(), 10u);
    EXPECT_EQ(d.errors(), 8u);
}

TEST(Render, PutsTheCaretUnderTheSpan) {
    Sources sources;
    const FileId f = sources.add("a.glib", "\tx \xE6\xBC\xA2 yy\n");
    Diagnostics d;
    d.error("code", Span{f, 7, 9}, "wrong", "do better");
    EXPECT_EQ(
        render(d, sources),
        "a.glib:1:6: error: wrong [code]\n    1 |     x \xE6\xBC\xA2 yy\n      |          ^~\n   help: do better\n");
}

TEST(Render, HasNoPlaceToShowForWhatHasNone) {
    Diagnostics d;
    d.error("no-graphics", "no graphics here", "install some");
    EXPECT_EQ(render(d, Sources{}), "error: no graphics here [no-graphics]\n   help: install some\n");
}

// What a message says, and how a file is named, does not change where it is.
TEST(Describe, KeepsThePartsApart) {
    Sources sources;
    const FileId f = sources.add("a:3:4: b|c.frag", "one\n  7 | two\n");
    Diagnostics d;
    d.error("code", Span{f, 6, 7}, "x:3:4: error: y | z", "q:5:6: | r").notes.push_back({Span{f, 0, 3}, "w:8:9: |"});
    const Finding finding = describe(d.items()[0], sources);
    EXPECT_EQ(finding.file, "a:3:4: b|c.frag");
    ASSERT_TRUE(finding.at && finding.source);
    EXPECT_EQ(finding.at->line, 2);
    EXPECT_EQ(finding.at->column, 3);
    EXPECT_EQ(finding.message, "x:3:4: error: y | z [code]");
    EXPECT_EQ(finding.source->text, "  7 | two");
    EXPECT_EQ(carets(*finding.source), "  ^");
    EXPECT_EQ(finding.help, "q:5:6: | r");
    ASSERT_EQ(finding.notes.size(), 1u);
    EXPECT_EQ(finding.notes[0].at->line, 1);
    EXPECT_EQ(finding.notes[0].message, "w:8:9: |");
    EXPECT_EQ(carets(*finding.notes[0].source), "^~~");
}

TEST(Render, SpansBeyondTheTextAreHarmless) {
    Sources sources;
    const FileId f = sources.add("a", "abc");
    for (const Span span : {Span{f, 3, 3}, Span{f, 2, 900}, Span{f, 900, 1000}, Span{f, 2, 1}, Span{77, 0, 1}}) {
        Diagnostics d;
        d.error("x", span, "m");
        EXPECT_FALSE(render(d, sources).empty());
    }
}

TEST(Render, CutsLongLinesAroundTheSpan) {
    Sources sources;
    const FileId f = sources.add("a", std::string(100'000, 'a') + "HERE" + std::string(100'000, 'b'));
    Diagnostics d;
    d.error("x", Span{f, 100'000, 100'004}, "m");
    const std::string text = render(d, sources);
    EXPECT_LT(text.size(), 500u);
    const std::size_t line = text.find('\n') + 1, next = text.find('\n', line) + 1;
    EXPECT_EQ(text.find("HERE", line) - line, text.find("^~~~", next) - next);
}

}  // namespace
}  // namespace snell::test
