// Tables as they are written, and what rungs are called in them.
#include "parser/text/words.h"
#include "src/accuracy/found/search.h"
#include "src/accuracy/report/report.h"
#include "src/content/table.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::test {
namespace {

using content::CellKind;
using content::Table;

std::size_t widest_line(const std::string& text) {
    std::size_t widest = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::size_t width = 0;
        for (std::size_t at = 0; at < line.size(); at += utf8::decode(line, at).length)
            width += static_cast<std::size_t>(utf8::width(utf8::decode(line, at).code));
        widest = std::max(widest, width);
    }
    return widest;
}

TEST(Tables, WordsGiveWayAndNumbersStay) {
    Table table{{{"name of it", CellKind::words}, {"RMSE", CellKind::number}, {"remarks", CellKind::words}}, {}};
    table.rows = {{{"a name that is rather long", "0.125", "and a remark that is longer than its column"}, true},
                  {{"short", "12345.678", std::string(200, 'x')}},
                  {{"→ × …", "", ""}}};
    for (const std::size_t columns : {120, 60, 45}) {
        const std::string text = table_text(table, columns);
        EXPECT_LE(widest_line(text), columns) << text;
        EXPECT_NE(text.find("12345.678"), std::string::npos) << text;
        EXPECT_NE(text.find("\n* a name"), std::string::npos) << text;
        EXPECT_EQ(text.find(" \n"), std::string::npos) << text;
    }
    EXPECT_EQ(table_text(Table{{{"a"}, {"bb", CellKind::words}}, {{{"1", "x"}}, {{"22", "y"}, true}}}),
              "   a  bb\n   1  x\n* 22  y\n");
}

TEST(Tables, TextsStayWithinTheirCells) {
    const Table table{{{"a|b", CellKind::words}, {"n"}, {"code", CellKind::code}},
                      {{{"=1,2", "-1", "x < y || \"z\""}, true}, {{"", "3", ""}}}};
    EXPECT_EQ(table_csv(table), "a|b,n,code\n\"'=1,2\",-1,\"x < y || \"\"z\"\"\"\n,3,\n");
    EXPECT_EQ(table_markdown(table),
              "| a&#124;b | n | code |\n|---|--:|---|\n"
              "| **=1,2** | -1 | <code>x &lt; y &#124;&#124; &quot;z&quot;</code> |\n| | 3 | |\n");
    const std::string page = table_html(table);
    EXPECT_NE(page.find("<tr class=\"current\"><td class=\"words\">=1,2</td><td class=\"number\">-1</td>"
                        "<td class=\"words\"><code>x &lt; y || &quot;z&quot;</code></td></tr>"),
              std::string::npos)
        << page;
    Table some = table;
    some.rows.erase(some.rows.begin());
    EXPECT_EQ(table_csv(some.without_empty()), "n\n3\n");
}

using namespace accuracy;

std::string words_for(ChangeKind kind, const std::string& before, const std::string& after,
                      std::vector<Edit> edits = {}) {
    return words(Change{kind, {}, before, after, std::move(edits)});
}

TEST(Words, SayWhatChanges) {
    using enum ChangeKind;
    EXPECT_EQ(words_for(fewer_slices, "Sphere 1.2 24 24", "Sphere 1.2 8 8"), "8 slices");
    EXPECT_EQ(words_for(fewer_slices, "Sphere 1.2 24 12", "Sphere 1.2 18 9"), "18 × 9 slices");
    EXPECT_EQ(words_for(more_slices, "Sphere", "Sphere 1. 120 120"), "120 slices");
    EXPECT_EQ(words_for(fewer_cells, "QuadXY 0. 1. 150 150", "QuadXY 0. 1. 75 75"), "75 × 75 cells");
    EXPECT_EQ(words_for(culled, "Sphere 1.2 24 24", "CullFace back Sphere 1.2 24 24"), "Sphere culled");
    EXPECT_EQ(words_for(culled, "", "CullFace back"), "solids culled");
    EXPECT_EQ(words_for(less_filtered, "", "Filter nearest"), "nearest");
    EXPECT_EQ(words_for(fewer_texels, "CubeMap 7 128", "CubeMap 7 64"), "64 texels");
    EXPECT_EQ(words_for(smaller_noise, "Noise3D 64", "Noise3D 32"), "noise of 32");
    EXPECT_EQ(words_for(fewer_rounds, "i < 8", "i < 4"), "loop to i < 4");
    EXPECT_EQ(words_for(fewer_rounds, "#define ORDERS 24", "#define ORDERS 12"), "ORDERS 12");
    EXPECT_EQ(words_for(more_rounds, "for( int i = 0; i < 3; i++ )", "for( int i = 0; i < 6; i++ )"), "loop to i < 6");
    EXPECT_EQ(words_for(without_term, "uKa + uKd * diffuse", "uKa"), "without uKd * diffuse");
    EXPECT_EQ(words_for(without_term, "mix( VEIN, STONE, stripe )", "STONE"), "only STONE");
    EXPECT_EQ(words_for(lookup_mean, "texture( uRoom, look )", "vec4(0.4, 0.3, 0.2, 1.)"), "uRoom as its mean");
    EXPECT_EQ(words_for(expression_mean, "room( vPosition, mirrored )", "vec3(…)"), "room as its mean");
    EXPECT_EQ(words_for(expression_mean, ".5 + cos( x )", "float(…)"), ".5 + cos( x ) as its mean");
    EXPECT_EQ(words_for(per_vertex, "normalize( vNormal )", "vFound_83"), "normalize per vertex");
    EXPECT_EQ(words_for(no_uniform, "uRoom 6", ""), "without uRoom");
    EXPECT_EQ(words_for(exact_fresnel, "a", "b"), "exact fresnel");
}

TEST(Words, TellRungsApart) {
    FoundResult found;
    const auto add = [&](ChangeKind kind, const std::string& before, const std::string& after, const char* place) {
        found.changes.push_back({kind, {}, before, after, {}});
        found.positions.emplace_back(place);
    };
    add(ChangeKind::fewer_slices, "Sphere 1 24 24", "Sphere 1 8 8", "a/../b/ball.glib:21:1");
    add(ChangeKind::fewer_slices, "Sphere 2 24 24", "Sphere 2 8 8", "a/../b/ball.glib:22:1");
    add(ChangeKind::less_filtered, "", "Filter nearest", "ball.glib:9:1");
    add(ChangeKind::fewer_rounds, "i < 8", "i < 4", "c.frag:3:1");
    add(ChangeKind::fewer_rounds, "i < 8", "i < 4", "c.frag:3:40");
    EXPECT_EQ(found.words(std::vector<std::size_t>{0, 2}), "8 slices at ball.glib:21, nearest");
    std::set<std::string> names;
    for (std::size_t i = 0; i < found.changes.size(); ++i) names.insert(found.words(std::vector<std::size_t>{i}));
    EXPECT_EQ(names.size(), found.changes.size());
}

// ---- reports ----------------------------------------------------------------------------------------------------

// A ladder whose rungs have long names, and found rungs of which some are plainly visible and most were not tried.
Report full_report() {
    Report report;
    SweepResult ladder;
    ladder.scene = "scenes/light/a-rather-long-name/of-a-scene.glib";
    ladder.sweep = {.kind = SweepKind::ladder, .name = "SURROUNDINGS"};
    for (const char* name : {"infinitely_far", "an_impostor_that_has_a_name_of_its_own", "box", "not_drawn"}) {
        ladder.sweep.rungs.push_back({name, {}, {}, {}});
        RungResult rung{.name = name, .drawn = name != std::string("not_drawn")};
        rung.own.light.rmse = rung.whole.light.rmse = rung.alone.rmse = 9.5e-07;
        rung.own.light.psnr = rung.own.display.psnr = rung.whole.light.psnr = 120.4;
        rung.degrees = Degrees{1.234, 2, 3, 4};
        rung.elsewhere = rung.alone;
        rung.saturated = true;
        rung.milliseconds = 1234.5;
        rung.rounds = rung.drawn ? 9 : 0;
        rung.ratio = {.9871, 1.0012, 1.0342};
        ladder.rungs.push_back(std::move(rung));
    }
    ladder.sweep.reference = 2;
    ladder.reference_note = "reference good to 48 dB (8 x 8 samples a pixel, tessellation x8)";
    report.sweeps = {ladder};
    FoundResult found;
    found.scene = ladder.scene;
    found.places.resize(2);
    found.searched = 1;
    for (std::size_t i = 0; i < 30; ++i) {
        const std::string n = std::to_string(i);
        found.changes.push_back({i % 2 == 0 ? ChangeKind::fewer_slices : ChangeKind::without_term,
                                 {},
                                 "Sphere 1.2 240 240 and more that is cut… of it " + n,
                                 "Sphere 1.2 " + n + " 240 and more that is cut… of it " + n,
                                 {}});
        found.positions.push_back("scenes/light/a-rather-long-name/../../environments/distances.glsl:" + n + ":17");
        FoundRung rung{.name = std::to_string(i + 1), .changes = {i}};
        if (i >= 10) rung.reason = "the time was up";
        found.rungs.push_back(rung);
    }
    found.rungs.push_back({.name = "1+2+3+4+5+6", .changes = {0, 1, 2, 3, 4, 5}});
    found.timed.sweep = {.kind = SweepKind::found, .name = "found rungs"};
    for (FoundRung& rung : found.rungs) {
        if (!rung.reason.empty()) continue;
        rung.outcome = Outcome::tried;
        rung.at.resize(2);
        rung.at[0].flip = rung.at[1].flip = rung.changes[0] % 3 == 2 ? .2 : .0123;
        rung.quick_ratio = .5;
        rung.saves = true;
        rung.timed = found.timed.rungs.size();
        RungResult times{.name = found.words(rung), .drawn = true};
        times.flip = *rung.flip();
        times.rounds = 20;
        times.milliseconds = 3.2;
        times.ratio = {.3312, .3451, .3561};
        times.verdict = {Standing::dominated, 0};
        found.timed.rungs.push_back(times);
    }
    found.timed.rungs.push_back({.name = "scene", .drawn = true});
    found.timed.rungs.back().rounds = 20;
    found.timed.sweep.reference = found.timed.sweep.current = found.timed.rungs.size() - 1;
    report.found = {found};
    return report;
}

TEST(ReportTables, KeepToTheColumnsOfATerminal) {
    const Report report = full_report();
    for (const std::string& text : {table_text(report.sweeps[0]), found_text(report.found[0]), header_text(report)})
        EXPECT_LE(widest_line(text), content::page_columns) << text;
}

// What is plain to see, and what was not tried, is a line that can be opened; the ladders come first.
TEST(ReportTables, WhatNobodyTakesIsFolded) {
    const Report report = full_report();
    const std::string page = html_text(report);
    EXPECT_LT(page.find("<h2>SURROUNDINGS</h2>"), page.find("<h2>Found rungs</h2>"));
    const auto folded = [&](std::string_view words) {
        const std::size_t at = page.find(words);
        EXPECT_NE(at, std::string::npos) << words;
        const std::size_t open = page.rfind("<details>", at), close = page.rfind("</details>", at);
        return open != std::string::npos && (close == std::string::npos || close < open);
    };
    EXPECT_TRUE(folded("<summary>20 rungs not tried</summary>"));
    EXPECT_TRUE(folded("<summary>3 rungs plainly visible, with a mean FLIP above 0.06</summary>"));
    EXPECT_TRUE(folded("distances.glsl:2:"));
    EXPECT_TRUE(folded("distances.glsl:22:"));
    EXPECT_FALSE(folded("distances.glsl:0:"));
    EXPECT_FALSE(folded("(1+2+3+4+5+6)"));
    const std::string text = found_text(report.found[0]);
    EXPECT_EQ(text.find("distances.glsl:22:"), std::string::npos) << text;
    EXPECT_EQ(text.find("?"), std::string::npos) << text;
}

// A number may follow in brackets, for --apply.
TEST(ReportTables, RungsAreCalledByWords) {
    const Report report = full_report();
    const std::string plot = svg_text(report.found[0].timed);
    EXPECT_NE(plot.find("slices"), std::string::npos);
    for (const std::string& text : {html_text(report), plot, found_text(report.found[0])})
        for (std::size_t at = 0; (at = text.find("1+2+3", at)) != std::string::npos; ++at)
            EXPECT_EQ(text[at - 1], '(') << text.substr(at - 40, 80);
}

// A test's script may run; the rest of the policy stays.
std::string with_scripts(std::string page) {
    const std::string_view policy = "default-src 'none';";
    return page.replace(page.find(policy), policy.size(), "default-src 'none'; script-src 'unsafe-inline';");
}

// Nothing is off the right edge, in a browser: neither folded nor unfolded. Skipped where chromium is not installed.
TEST(ReportTables, FitThePage) {
    if (std::system("command -v chromium > /dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
    const Scratch folder;
    const std::string page = folder.write("page.html", with_scripts(html_text(full_report())) + R"(<script>
for (const d of document.querySelectorAll('details')) d.open = true;
const right = [...document.querySelectorAll('table')].map(t => t.getBoundingClientRect().right);
const cells = [...document.querySelectorAll('td.number')].filter(c => c.scrollWidth > c.clientWidth);
document.title = `probe tables=${right.length} over=${Math.max(document.documentElement.scrollWidth, ...right) -
    innerWidth} broken=${cells.length} end`;
</script>)");
    for (const int width : {1100, 1300}) {
        const std::string command =
            "timeout 120 chromium --headless --no-sandbox --disable-gpu --no-first-run "
            "--user-data-dir=" +
            folder.path("profile") + " --window-size=" + std::to_string(width) + ",900 --dump-dom file://" + page +
            " 2> /dev/null > " + folder.path("dom.html");
        ASSERT_EQ(std::system(command.c_str()), 0);
        std::ifstream file(folder.path("dom.html"));
        const std::string dom{std::istreambuf_iterator<char>(file), {}};
        const std::size_t at = dom.find("<title>probe");
        ASSERT_NE(at, std::string::npos);
        const std::string probe = dom.substr(at, dom.find(" end", at) - at);
        EXPECT_NE(probe.find("tables=4"), std::string::npos) << probe;
        EXPECT_LE(std::atof(probe.c_str() + probe.find("over=") + 5), 0) << width << ": " << probe;
        EXPECT_NE(probe.find("broken=0"), std::string::npos) << probe;
    }
}

}  // namespace
}  // namespace snell::test
