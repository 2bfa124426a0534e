// The slide of a report: what it shows, and that it can be read.
#include "src/accuracy/report/slide/slide.h"
#include "src/content/image/image.h"
#include "tests/accuracy/pictures.h"
#include "tests/scratch.h"
#include "tests/screens.h"
#include "tests/std.h"

namespace snell::test {
namespace {

using namespace accuracy;
using content::Area, content::Mark, content::MarkKind, content::PlotPoint;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Rung {
    std::string name;
    double milliseconds, error;
    double spread = .01;  // of the interval, to each side
};

SweepResult sweep_of(const std::string& name, const std::vector<Rung>& rungs, bool pictures = true) {
    SweepResult sweep;
    sweep.scene = "scenes/ball.glib";
    sweep.sweep.name = name;
    sweep.clock = ClockKind::cpu;
    if (pictures) sweep.reference = flat(40, 30, .5F);
    for (const Rung& rung : rungs) {
        sweep.sweep.rungs.push_back({rung.name, {}, {}, {}});
        RungResult result{.name = rung.name, .drawn = true};
        result.whole.light.rmse = result.own.light.rmse = rung.error;
        constexpr int rounds = 31;
        for (int i = 0; rung.milliseconds > 0 && i < rounds; ++i) {
            const int step = (i * 7 + 11 * static_cast<int>(sweep.rungs.size())) % rounds - rounds / 2;
            result.cpu.push_back(rung.milliseconds * (1 + rung.spread * step / (rounds / 2)));
        }
        if (rung.milliseconds > 0) {
            result.rounds = rounds;
            result.milliseconds = rung.milliseconds;
            result.low = rung.milliseconds * (1 - rung.spread);
            result.high = rung.milliseconds * (1 + rung.spread);
        }
        if (pictures) result.picture = noise(40, 30, static_cast<unsigned>(sweep.rungs.size() + 7 * name.size()));
        sweep.rungs.push_back(std::move(result));
    }
    sweep.sweep.reference = rungs.size() - 1;
    return sweep;
}

// What a measurement concludes of the times.
void compare_times(SweepResult& sweep) {
    std::vector<Point> points;
    for (RungResult& rung : sweep.rungs) {
        rung.ratio = paired_ratio(rung.cpu, sweep.rungs[sweep.sweep.current].cpu);
        points.push_back({0, rung.cpu});
    }
    sweep.costs = costs_of(points);
}

Slide slide_with(std::vector<SweepResult> sweeps) {
    for (SweepResult& sweep : sweeps) compare_times(sweep);
    Report report;
    report.where.width = 40;
    report.where.height = 30;
    report.where.renderer = "a renderer";
    report.sweeps = std::move(sweeps);
    return slide_of(report);
}

double wide_letters(const std::string& text, double size, bool bold) {
    double letters = 0;
    for (const char c : text) letters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    return letters * size * (bold ? .6 : .5);
}

std::vector<std::string> texts_of(const Slide& slide) {
    std::vector<std::string> texts;
    for (const Mark& shape : slide_marks(slide, wide_letters))
        if (shape.kind == MarkKind::text) texts.push_back(shape.text);
    return texts;
}
std::size_t count_of(const Slide& slide, const std::string& text) {
    const std::vector<std::string> texts = texts_of(slide);
    return static_cast<std::size_t>(std::count(texts.begin(), texts.end(), text));
}

std::string place(const Mark& shape) {
    return "'" + shape.text + "' " + std::to_string(shape.at.x0) + ' ' + std::to_string(shape.at.y0) + ' ' +
           std::to_string(shape.at.x1) + ' ' + std::to_string(shape.at.y1);
}

// Text is large, on the page, and covers neither other text nor a point.
void expect_legible(const std::vector<Mark>& shapes, const Area& page, double least, double largest_point) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Mark& a = shapes[i];
        for (const double number : {a.at.x0, a.at.y0, a.at.x1, a.at.y1}) ASSERT_TRUE(std::isfinite(number)) << place(a);
        EXPECT_TRUE(page.holds(a.at) || a.kind == MarkKind::line) << place(a);
        if (a.kind != MarkKind::text) continue;
        EXPECT_GE(a.size, least) << place(a);
        for (std::size_t j = 0; j < shapes.size(); ++j) {
            const Mark& b = shapes[j];
            const bool point = b.kind == MarkKind::disc || (b.kind == MarkKind::box && b.at.width() < largest_point &&
                                                            b.at.height() < largest_point);
            if (i != j && (b.kind == MarkKind::text || b.kind == MarkKind::image || point)) {
                EXPECT_FALSE(a.at.meets(b.at)) << place(a) << " covers " << place(b);
            }
        }
    }
}

// So are the plots of a report and of the window, which have less room.
void expect_legible(const Slide& slide) {
    expect_legible(slide_marks(slide, wide_letters), {0, 0, slide_width, slide_height}, 28, 40);
    for (const Area& area : {Area{0, 0, 640, 400}, Area{0, 0, 300, 160}}) {
        content::Page page(wide_letters);
        const auto places = draw_plot(page, slide.plot, area, 12);
        expect_legible(page.marks, {-.01, -.01, area.x1 + .01, area.y1 + .01}, 10, 15);
        ASSERT_EQ(places.size(), slide.plot.points.size());
        for (const auto& [x, y] : places) EXPECT_TRUE(area.holds({x, y, x, y}));
    }
}

TEST(Slide, CanBeReadWhateverWasMeasured) {
    std::vector<Rung> many, equal, spread;
    for (int i = 0; i < 60; ++i) {
        many.push_back({"rung number " + std::to_string(i), std::pow(1.1, i), std::pow(.93, i)});
        equal.push_back({"the same " + std::to_string(i), 5, .1});
        spread.push_back({"x" + std::to_string(i), 5. + i % 7, .1 + .01 * (i % 5), .5});
    }
    const std::vector<std::vector<Rung>> reports{
        many,
        equal,
        spread,
        {{"only", 3, .2}},
        {{"only", 0, .2}},
        {{"a", 3, 0}, {"b", 4, 0}},
        {{"a", 3, .1}, {"b", 4, 0}},
        {{"a", 3, infinite}, {"b", 4, .1}, {"c", 5, 0}},
        {{"a", 3, infinite}, {"b", 4, infinite}},
        {{"a", 1e-4, 1e-9}, {"b", 1e6, 1e6}},
        {{"untimed", 0, .1}, {"timed", 4, .05}},
        {{std::string(3000, 'W'), 3, .1}, {"<script>alert(\"&\")</script>", 4, .05}, {"\xff\x01\x1b[31m", 5, .02}},
    };
    for (std::size_t i = 0; i < reports.size(); ++i)
        for (const bool pictures : {true, false})
            for (const double residual : {0., 1e-4, .04}) {
                SCOPED_TRACE(i);
                SweepResult sweep = sweep_of("WAY", reports[i], pictures);
                if (residual > 0) sweep.whole_residual = residual;
                expect_legible(slide_with({std::move(sweep)}));
            }
    expect_legible(slide_with({}));
    expect_legible(slide_with({sweep_of("WAY", many), sweep_of("OTHER", many), sweep_of("samples", equal)}));
}

TEST(Slide, LabelsOfWhatIsShownAreThere) {
    const Slide slide = slide_with({sweep_of("WAY", {{"rough", 2, .3}, {"fine", 4, .1}, {"finest", 8, .02}})});
    ASSERT_EQ(slide.columns.size(), 3U);
    for (const char* name : {"rough", "fine", "finest"}) EXPECT_EQ(count_of(slide, name), 2U) << "column and point";
    EXPECT_EQ(count_of(slide, "reference"), 1U);
}

// What is equal is told by intervals and errors, and nothing is made up where nothing is equal.
TEST(Slide, ColumnsAreOfEqualTimeOrEqualError) {
    SweepResult sweep = sweep_of("WAY", {{"first", 9.9, .4},
                                         {"own", 10, .1},
                                         {"as fast and better", 10.1, .05},
                                         {"as good and cheaper", 5, .1},
                                         {"as good and dear", 20, .101},
                                         {"neither", 30, .01}});
    sweep.sweep.current = 1;
    const Slide slide = slide_with({sweep});
    std::vector<std::string> names;
    for (const SlideColumn& column : slide.columns) names.push_back(column.name);
    EXPECT_EQ(names, (std::vector<std::string>{"as fast and better", "first", "own", "as good and cheaper",
                                               "as good and dear"}));
    for (const SlideColumn& column : slide.columns) {
        EXPECT_EQ(column.own, column.name == "own");
        EXPECT_EQ(column.equal_time, column.own || column.name == "first" || column.name == "as fast and better");
        EXPECT_EQ(column.equal_error, column.own || column.name.starts_with("as good"));
    }
    EXPECT_EQ(count_of(slide, "about equal time"), 1U);
    EXPECT_EQ(count_of(slide, "about equal error"), 1U);

    const Slide apart = slide_with({sweep_of("WAY", {{"own", 10, .1}, {"slow", 30, .01}})});
    ASSERT_EQ(apart.columns.size(), 2U);
    for (const SlideColumn& column : apart.columns) EXPECT_FALSE(column.equal_time || column.equal_error);
    EXPECT_EQ(count_of(apart, "about equal time") + count_of(apart, "about equal error"), 0U);
}

TEST(Slide, AnErrorBelowTheReferencesResidualIsNoNumber) {
    SweepResult sweep = sweep_of("WAY", {{"own", 10, .11}, {"good", 10.1, .004}, {"fair", 10.2, .05}});
    sweep.whole_residual = .02;
    const Slide slide = slide_with({sweep});
    EXPECT_EQ(count_of(slide, "<0.02"), 1U);
    EXPECT_EQ(count_of(slide, "0.004"), 0U);
    EXPECT_EQ(count_of(slide, "0.11"), 1U);
}

TEST(Slide, SamePictureIsShownOnce) {
    SweepResult sweep = sweep_of("WAY", {{"own", 10, .1}, {"twin", 5, .1}, {"other", 20, .02}});
    sweep.rungs[1].picture = sweep.rungs[0].picture;
    const Slide slide = slide_with({sweep});
    ASSERT_EQ(slide.columns.size(), 2U);
    EXPECT_EQ(slide.columns[1].name, "other");
}

TEST(Slide, FrontOfSeveralSweepsHasWhatNoOtherBeats) {
    const std::vector<SweepResult> sweeps{
        sweep_of("WAY", {{"aa", 10, .1}, {"bb", 20, .05}, {"cc", 40, .01}}),
        sweep_of("KNOB", {{"as it is", 10, .1}, {"dd", 15, .02}, {"ee", 41, .2}, {"ff", 9.9, .1}})};
    std::set<std::string> front;
    for (const PlotPoint& point : slide_with(sweeps).plot.points)
        if (point.front) front.insert(point.name);
    // dd beats bb; ee is worse than all; the times of aa and ff, whose errors are equal, can't be told apart.
    EXPECT_EQ(front, (std::set<std::string>{"aa", "as it is", "cc", "dd", "ff"}));

    std::vector<SweepResult> few = sweeps;
    for (SweepResult& sweep : few) sweep.few_rounds = true;
    const Slide slide = slide_with(few);
    for (const PlotPoint& point : slide.plot.points) EXPECT_FALSE(point.front) << point.name;
    EXPECT_EQ(slide.plot.stamp, "too few rounds: no front");
}

// The machine was twice as fast when the knob was measured: places are ratios of its own table.
TEST(Slide, TimesAreRatiosOfTheirOwnTables) {
    const SweepResult knob = sweep_of("filter", {{"nearest", 5, .1}, {"mipmap", 6.7, .05}, {"coarse", 4, .1}});
    const Slide slide = slide_with({sweep_of("WAY", {{"own", 10, .1}, {"exact", 20, .01}}), knob});
    std::map<std::string, PlotPoint> points;
    for (const PlotPoint& point : slide.plot.points) points[point.name] = point;
    EXPECT_EQ(points.at("own").milliseconds, 10);
    EXPECT_NEAR(points.at("mipmap").milliseconds, 13.4, .1);
    EXPECT_NEAR(points.at("coarse").milliseconds, 8, .1);
    EXPECT_TRUE(points.at("mipmap").low > 10 && points.at("coarse").high < 10);
    EXPECT_FALSE(points.at("own").front) << "coarse is cheaper and as good";
    for (const SlideColumn& column : slide.columns) EXPECT_EQ(column.equal_time, false) << column.name;

    // What a table does not tell apart is not told on the slide, whatever the intervals of single ratios are.
    SweepResult unsure = sweep_of("filter", {{"nearest", 5, .1}, {"coarse", 4, .1}, {"expensive", 9, .2}});
    for (std::size_t i = 6; i < 31; ++i)
        for (RungResult& rung : unsure.rungs) rung.cpu[i] = 0;
    for (const PlotPoint& point :
         slide_with({sweep_of("WAY", {{"own", 10, .1}, {"exact", 20, .01}}), unsure}).plot.points)
        EXPECT_TRUE(point.front || point.name != "own");

    // A ladder whose own rung is another combination, but which shares its last one with the first.
    SweepResult first = sweep_of("WAY", {{"own", 10, .1}, {"last", 20, .01}}), other = first;
    first.sweep.rungs[0].variant.rungs = {0, 1};
    first.sweep.rungs[1].variant.rungs = {1, 1};
    other.rungs[0].name = "other";
    other.sweep.rungs[0].variant.rungs = {1, 0};
    other.sweep.rungs[1].variant.rungs = {1, 1};
    for (double& t : other.rungs[0].cpu) t *= 1.6;  // .8 of the last one
    for (const PlotPoint& point : slide_with({first, other}).plot.points)
        EXPECT_NEAR(point.milliseconds, point.name == "own" ? 10 : point.name == "other" ? 16 : 20, .2) << point.name;
}

TEST(Slide, OnlyErrorsFromOneReferenceAreOnOneScale) {
    SweepResult other = sweep_of("OTHER", {{"x", 1, .4}, {"y", 2, .3}});
    other.reference = flat(40, 30, .25F);
    const Slide slide = slide_with({sweep_of("WAY", {{"a", 10, .5}, {"b", 20, .05}}), other});
    ASSERT_EQ(slide.plot.points.size(), 2U);
    EXPECT_EQ(slide.plot.points[0].name, "a");
    SweepResult broken = sweep_of("WAY", {{"a", 10, .5}});
    broken.cannot_say = "the reference is NaN";
    EXPECT_TRUE(slide_with({broken}).plot.points.empty());
}

TEST(Slide, NothingIsBelowTheFloor) {
    SweepResult sweep = sweep_of("WAY", {{"a", 10, .5}, {"b", 20, 1e-5}});
    sweep.whole_residual = 1e-3;
    const Slide slide = slide_with({sweep});
    EXPECT_EQ(slide.plot.floor, 1e-3);
    EXPECT_EQ(slide.plot.points[1].error, 1e-3);
    EXPECT_EQ(count_of(slide, "residual of the reference"), 1U);

    // Points stand at the floor all along, with names: it is called by its name below them.
    std::vector<Rung> exact{{"rough", 10, 2e-3}};
    for (const int time : {11, 14, 18, 23, 29, 37})
        exact.push_back({"as exact as can be " + std::to_string(time), static_cast<double>(time), 1e-5});
    SweepResult low = sweep_of("WAY", exact);
    low.whole_residual = 1e-3;
    EXPECT_EQ(count_of(slide_with({low}), "residual of the reference"), 1U);
}

// A found rung was compared with the scene as it is; on the slide its error is from the ladders' reference.
TEST(Slide, FoundRungsAreOnTheScaleOfTheOthers) {
    SweepResult ladder = sweep_of("WAY", {{"rough", 8, .25}, {"exact", 20, 0}});
    ladder.rungs[0].picture = flat(40, 30, .75F);
    ladder.rungs[1].picture = ladder.reference;
    FoundResult found;
    found.scene = ladder.scene;
    found.timed = sweep_of("found rungs", {{"1", 5, .125}, {"scene", 10, 0}});
    found.timed.sweep.kind = SweepKind::found;
    found.timed.sweep.current = 1;
    found.timed.reference = {};
    found.timed.rungs[0].picture = flat(40, 30, 1);
    found.timed.rungs[1].picture = flat(40, 30, 0);
    compare_times(ladder);
    compare_times(found.timed);
    Report report{.sweeps = {ladder}, .found = {found}};
    const Slide slide = slide_of(report);
    ASSERT_EQ(slide.plot.points.size(), 4U);
    const double half = content::light_of_srgb(.5);
    const std::map<std::string, double> errors{{"the scene", half}, {"1", 1 - half}, {"rough", .25}, {"exact", 0}};
    for (const PlotPoint& point : slide.plot.points) {
        EXPECT_EQ(point.own, point.name == "the scene");
        EXPECT_NEAR(point.error, errors.at(point.name), 1e-6) << point.name;
    }
    // Without a ladder, the scene is the reference.
    report.sweeps.clear();
    const Slide alone = slide_of(report);
    ASSERT_EQ(alone.plot.points.size(), 2U);
    EXPECT_EQ(alone.plot.points[0].error, .125);
    EXPECT_EQ(alone.plot.points[1].error, 0);
    expect_legible(alone);
    // Pictures of another size can't be compared.
    report.sweeps = {ladder};
    for (RungResult& rung : report.found[0].timed.rungs) rung.picture = flat(20, 15, .5F);
    EXPECT_EQ(slide_of(report).plot.points.size(), 2U);
}

// A ladder, and found rungs of the same scene: the last one is the scene as it is.
Report with_found(double ladder_time, const std::vector<Rung>& rungs) {
    SweepResult ladder = sweep_of("WAY", {{"rough", ladder_time, .25}, {"exact", 2 * ladder_time, .01}});
    if (ladder_time == 0) ladder.clock = ClockKind::wall;  // it was never chosen
    FoundResult found;
    found.scene = ladder.scene;
    found.timed = sweep_of("found rungs", rungs);
    found.timed.sweep.kind = SweepKind::found;
    found.timed.sweep.current = found.timed.sweep.reference;
    found.timed.reference = {};
    compare_times(ladder);
    compare_times(found.timed);
    Report report{.sweeps = {ladder}, .found = {found}};
    return report;
}

// Of fewer rungs, if there was no time for all: which were left out is said.
TEST(Slide, HasTimesIfAnythingHas) {
    Slide slide = slide_of(with_found(0, {{"8 slices", 5, .1}, {"not timed", 0, .2}, {"scene", 10, 0}}));
    std::set<std::string> names;
    for (const PlotPoint& point : slide.plot.points) names.insert(point.name);
    EXPECT_EQ(names, (std::set<std::string>{"8 slices", "the scene"}));
    EXPECT_NE(slide.plot.stamp.find("left out: 3 not timed"), std::string::npos) << slide.plot.stamp;
    expect_legible(slide);

    Report smaller = with_found(8, {{"8 slices", 5, .1}, {"scene", 10, 0}});
    EXPECT_EQ(slide_of(smaller).plot.points.size(), 4U);
    smaller.found[0].width = 600;  // and the times are of no such pictures
    slide = slide_of(smaller);
    EXPECT_EQ(slide.plot.points.size(), 2U) << "times of other sizes don't compare";
    EXPECT_NE(slide.plot.stamp.find("left out: 1 found in smaller pictures"), std::string::npos) << slide.plot.stamp;
}

// The found rungs had few rounds; the ladder, whose first rung is the scene as it is, had enough.
TEST(Slide, FrontOfALadderStaysWhereFoundRungsHaveNone) {
    Report report = with_found(10, {{"8 slices", 5, .1}, {"scene", 10, 0}});
    SweepResult &ladder = report.sweeps[0], &timed = report.found[0].timed;
    ladder.rungs[1].verdict = {Standing::saves_none, 0};
    ladder.rungs[0].picture = timed.rungs[1].picture;
    timed.few_rounds = true;
    const Slide slide = slide_of(report);
    std::set<std::string> names, front;
    for (const PlotPoint& point : slide.plot.points) {
        names.insert(point.name);
        if (point.front) front.insert(point.name);
    }
    EXPECT_EQ(names, (std::set<std::string>{"8 slices", "the scene: rough", "exact"}));
    EXPECT_EQ(front, (std::set<std::string>{"the scene: rough"}));
    EXPECT_EQ(slide.plot.stamp.find("no front"), std::string::npos) << slide.plot.stamp;
}

TEST(Slide, WhatNobodyTakesIsLeftOut) {
    Report report = with_found(8, {{"8 slices", 5, .1}, {"ruin", 2, .3}, {"scene", 10, 0}});
    for (RungResult& rung : report.found[0].timed.rungs) rung.flip = rung.name == "ruin" ? .2 : .05;
    report.found[0].timed.rungs.back().flip = 1;  // the scene's own always stays
    const Slide slide = slide_of(report);
    std::set<std::string> names;
    for (const PlotPoint& point : slide.plot.points) names.insert(point.name);
    EXPECT_EQ(names, (std::set<std::string>{"8 slices", "the scene", "rough", "exact"}));
    EXPECT_TRUE(slide.plot.stamp.ends_with("left out: 1 plainly visible")) << slide.plot.stamp;
}

// Names in words take several lines.
TEST(Slide, LongNamesCanBeRead) {
    std::vector<Rung> rungs;
    for (const char* first : {"8", "12", "18", "24", "60"})
        rungs.push_back({std::string(first) + " slices, Sphere culled, nearest, room as its mean and more",
                         5. + static_cast<double>(rungs.size()), .1 / static_cast<double>(1 + rungs.size())});
    rungs.push_back({"scene", 20, 0});
    Report report = with_found(0, rungs);
    const Slide slide = slide_of(report);
    EXPECT_GE(slide.columns.size(), 3U);
    expect_legible(slide);
    const std::vector<std::string> texts = texts_of(slide);
    EXPECT_GT(std::count_if(texts.begin(), texts.end(), [](const std::string& t) { return t.starts_with("room as"); }),
              1);
}

// The names of sweeps are added only where they are needed.
TEST(Slide, NamesTellRungsApart) {
    const Slide slide = slide_with({sweep_of("WAY", {{"exact", 10, .5}, {"good", 11, .4}}),
                                    sweep_of("samples", {{"exact", 3, .3}, {"4x4", 5, .2}})});
    std::set<std::string> names;
    for (const PlotPoint& point : slide.plot.points) names.insert(point.name);
    EXPECT_EQ(names, (std::set<std::string>{"WAY exact", "samples exact", "good", "samples 4x4"}));
}

class SlideFiles : public testing::Test {
protected:
    Slide slide = made();
    static Slide made() {
        SweepResult sweep = sweep_of("WAY", {{"rough", 2, .3}, {"fine", 4, .1}, {"<b>&\"'\xc3\xa9", 8, .02}});
        SweepResult knob = sweep_of("samples", {{"1", 4.1, .15, .08}, {"2x2", 9, .05}, {"4x4", 30, .01, .1}});
        sweep.sweep.current = 1;
        knob.whole_residual = .004;
        return slide_with({sweep, knob});
    }
    std::string drawn(SlideFormat format) const {
        const SlideFile file = draw_slide(slide, format);
        EXPECT_EQ(file.error, "");
        return file.bytes;
    }
};

TEST_F(SlideFiles, HaveTheSizeOfAScreen) {
    const auto header = content::read_header(drawn(SlideFormat::png), 1);
    ASSERT_TRUE(header);
    EXPECT_EQ(header->format, "png");
    EXPECT_EQ(header->width, 1920);
    EXPECT_EQ(header->height, 1080);
    EXPECT_NE(drawn(SlideFormat::svg).find("viewBox=\"0 0 1920 1080\""), std::string::npos);
    const std::string pdf = drawn(SlideFormat::pdf);
    EXPECT_TRUE(pdf.starts_with("%PDF-"));
    EXPECT_NE(pdf.find("/MediaBox [ 0 0 1920 1080 ]"), std::string::npos);
    if (std::system("command -v pdfinfo > /dev/null") != 0) return;
    const Scratch folder;
    const std::string command = "pdfinfo " + folder.write("s.pdf", pdf) + " | grep -q 'Page size: *1920 x 1080'";
    EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST_F(SlideFiles, AreTheSameEachTime) {
    for (const SlideFormat format : {SlideFormat::png, SlideFormat::svg, SlideFormat::pdf}) {
        const std::string first = drawn(format), second = drawn(format);
        EXPECT_GT(first.size(), 1000U);
        EXPECT_TRUE(first == second);
        if (const std::string folder = screens_folder(); !folder.empty() && format == SlideFormat::png)
            std::ofstream(folder + "/slide.png", std::ios::binary) << first;
    }
    EXPECT_EQ(drawn(SlideFormat::pdf).find("CreationDate"), std::string::npos);
}

// The picture itself: dark on white, with the colours of its columns, and each of the pictures in its own colour.
TEST_F(SlideFiles, ShowMarksOnWhite) {
    std::map<unsigned, std::size_t> least{{0xffffff, 1920 * 1080 / 3}, {0xd55e00, 1000}};
    unsigned color = 0x1040a0;
    const auto paint = [&](content::Image& image) {
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = static_cast<std::byte>(color >> (16 - 8 * (i % 3)) & 255U);
        least[color] = 10000;
        color += 0x100804;
    };
    for (SlideColumn& column : slide.columns) paint(column.picture);
    paint(slide.reference);
    paint(slide.whole);
    const auto decoded = content::decode_image("s.png", drawn(SlideFormat::png));
    ASSERT_TRUE(decoded.image);
    const content::Image& image = *decoded.image;
    std::map<unsigned, std::size_t> counts;
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += static_cast<std::size_t>(image.channels))
        ++counts[std::to_integer<unsigned>(image.pixels[i]) << 16 |
                 std::to_integer<unsigned>(image.pixels[i + 1]) << 8 | std::to_integer<unsigned>(image.pixels[i + 2])];
    for (const auto& [of, count] : least) EXPECT_GT(counts[of], count) << std::hex << of;
}

TEST_F(SlideFiles, SurviveHostileNames) {
    for (const std::string& name :
         {std::string(100000, 'n'), std::string("\xff\xfe\xc3"), std::string("\xe2\x80\xae\x1b[2J\n"),
          std::string("</svg><script>x</script>"), std::string("\xe6\xbc\xa2\xe5\xad\x97")}) {
        slide.title = slide.note = slide.columns[0].name = slide.plot.points[0].name = name;
        for (const SlideFormat format : {SlideFormat::png, SlideFormat::svg, SlideFormat::pdf})
            EXPECT_GT(drawn(format).size(), 1000U) << name.substr(0, 40);
        EXPECT_EQ(drawn(SlideFormat::svg).find("<script"), std::string::npos);
    }
}

TEST_F(SlideFiles, GoIntoAPageWithoutTheNetwork) {
    const std::string element = slide_element(slide);
    EXPECT_TRUE(element.starts_with("<svg "));
    std::size_t pictures = 0;
    for (std::size_t at = 0; (at = element.find("href=", at)) != std::string::npos; ++pictures, ++at)
        EXPECT_EQ(element.compare(at, 28, "href=\"data:image/png;base64,"), 0) << element.substr(at, 60);
    EXPECT_EQ(pictures, 2 * slide.columns.size() + 3) << "crops, maps, the reference, the scale and the whole picture";
    const std::string page = html_text({}, element);
    EXPECT_LT(page.find(element.substr(0, 100)), page.find("<p class=\"facts\">"));
    EXPECT_EQ(slide_element({}), "") << "nothing was measured";
}

TEST(SlideFormats, AreToldByTheEnding) {
    EXPECT_EQ(slide_format("a/b.png"), SlideFormat::png);
    EXPECT_EQ(slide_format("B.SVG"), SlideFormat::svg);
    EXPECT_EQ(slide_format("x.y.pdf"), SlideFormat::pdf);
    for (const char* other : {"", "png", ".png", "a.png/b", "a.jpg", "a.pdf "})
        EXPECT_FALSE(slide_format(other)) << other;
}

// ---- The parts of pictures that a slide shows.

TEST(SlideCrops, WindowIsWhereTheDifferenceIs) {
    const Picture reference = noise(200, 150, 3);
    Picture a = reference, b = reference;
    for (int y = 77; y < 77 + 64; ++y)
        for (int x = 31; x < 31 + 96; ++x) b.rgba[4 * static_cast<std::size_t>(y * 200 + x) + 1] = 2;
    for (float& value : a.rgba) value += .1F;  // all pictures have it: no difference between them
    for (std::size_t i = 0; i < b.rgba.size(); ++i)
        if (b.rgba[i] != 2) b.rgba[i] = a.rgba[i];
    for (const auto& pictures : {std::vector<const Picture*>{&a, &b}, {&b, &a}}) {
        const Window window = largest_window(disagreement(pictures, reference), 200, 150, 96, 64);
        EXPECT_EQ(window.x, 31);
        EXPECT_EQ(window.y, 77);
        EXPECT_EQ(window.width, 96);
        EXPECT_EQ(window.height, 64);
    }
    const Window all = largest_window(std::vector<float>(12, 1), 4, 3, 96, 64);
    EXPECT_EQ(all.width, 4);
    EXPECT_EQ(all.height, 3);
}

TEST(SlideCrops, PixelsThatAreNotFiniteDiffer) {
    const Picture reference = flat(30, 20, .5F);
    Picture odd = reference;
    odd.rgba[4 * (7 * 30 + 11)] = std::nanf("");
    const Picture* pictures[]{&odd};
    const Window window = largest_window(disagreement(pictures, reference), 30, 20, 1, 1);
    EXPECT_EQ(window.x, 11);
    EXPECT_EQ(window.y, 7);
}

// The colours of a window are those of the whole map.
TEST(SlideCrops, MapIsThatOfTheWholePicture) {
    const Picture a = noise(90, 70, 5), b = noise(90, 70, 6);
    const std::vector<float> whole = flip_map(a, b);
    for (const Window window : {Window{0, 0, 20, 10}, Window{41, 33, 30, 20}, Window{60, 50, 30, 20}}) {
        const std::vector<float> part = flip_in(a, b, window);
        for (int y = 0; y < window.height; ++y)
            for (int x = 0; x < window.width; ++x)
                ASSERT_NEAR(part[static_cast<std::size_t>(y * window.width + x)],
                            whole[static_cast<std::size_t>((window.y + y) * 90 + window.x + x)], 1e-5)
                    << x << ' ' << y;
    }
}

TEST(SlideCrops, AreTheirPixels) {
    Picture picture = flat(5, 4, .25F);
    picture.rgba[4 * (2 * 5 + 3) + 1] = 7;
    picture.rgba[4 * (2 * 5 + 3) + 2] = std::nanf("");
    const content::Image image = crop(picture, {2, 1, 3, 2});
    ASSERT_EQ(image.pixels.size(), 3U * 6U);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(std::to_integer<int>(image.pixels[i]), i == 3 * 4 + 1 ? 255 : i == 3 * 4 + 2 ? 0 : 64) << i;
}

TEST(SlideCrops, SmallerPicturesAreMeans) {
    const auto checks = [](int x, int y, std::size_t) { return (x + y) % 2; };
    const content::Image small = content::reduced(100, 50, 20, 20, checks);
    EXPECT_EQ(small.width, 20);
    EXPECT_EQ(small.height, 10);
    for (const std::byte value : small.pixels) EXPECT_NEAR(std::to_integer<int>(value), 128, 6);
    EXPECT_EQ(content::reduced(7, 3, 20, 20, checks).width, 7) << "nothing is made larger";
}

}  // namespace
}  // namespace snell::test
