// The lessons of docs/teaching: what they hand out runs, and their rubrics give the points that their pages tell.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"
#include "tests/pattern.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> lessons() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(SNELL_ROOT "/docs/teaching"))
        if (entry.is_directory()) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

// "4.3 of 10 points" of a page, in their order.
std::vector<double> points_told(const std::string& page) {
    const std::string text = page.substr(std::min(page.find("## Submissions"), page.size()));
    std::vector<double> points;
    for (const auto& told : matches(text, R"(([0-9.]+)\s+of\s+10\s+points)")) points.push_back(std::stod(told[1]));
    return points;
}

TEST(Teaching, ThereAreEightLessonsWithTheSameParts) {
    EXPECT_EQ(lessons().size(), 8u);
    const std::string list = bytes_of(SNELL_ROOT "/docs/teaching/README.md");
    EXPECT_NE(list.find("\nsnell grade rubric.toml submissions -o out/report\n"), std::string::npos)
        << "as the tests below";
    for (const fs::path& lesson : lessons()) {
        const std::string page = bytes_of(lesson / "README.md");
        for (const char* part :
             {"**Question.** ", "\n## In class (", "\n## Exercise\n", "\n## Rubric\n", "\n## Submissions\n"})
            EXPECT_NE(page.find(part), page.npos) << lesson << part;
        const std::string question = page.substr(page.find("**Question.** ") + 14);
        EXPECT_NE(
            list.find("](" + lesson.filename().string() + "/README.md) | " + question.substr(0, question.find('\n'))),
            list.npos)
            << lesson << ": the list has another question";
        EXPECT_EQ(points_told(page).size(), 2u) << lesson;
    }
}

TEST(Teaching, WhatIsHandedOutIsCompleteAndWithoutWarnings) {
    std::string scenes;
    for (const fs::path& lesson : lessons())
        for (const char* part : {"handout", "solution", "submissions/passing"})
            for (const auto& entry : fs::directory_iterator(lesson / part))
                if (entry.path().extension() == ".glib") scenes += " " + entry.path().string();
    const Outcome outcome = snell("check --grade" + scenes);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(std::count(scenes.begin(), scenes.end(), ' '), 24);
}

// What changes a submission that passes, so that nothing of it is seen: by the end of a file's name, what becomes of
// its text.
using Damage = std::function<std::string(const std::string& text)>;
struct Emptied {
    std::string name, ending;
    Damage damage;
};

std::vector<Emptied> emptied() {
    const auto becomes = [](const std::string& now) { return [now](const std::string&) { return now; }; };
    const auto behind_lines = [](const std::string& lines, const std::string& added) {
        return [=](const std::string& text) { return replaced(text, lines, "&\n" + added); };
    };
    return {{"rubbish", ".frag", becomes("rubbish")},
            {"discard", ".frag", becomes("void main() { discard; }")},
            {"nan", ".frag", becomes("void main() { gl_FragColor = vec4(0. / 0.); }")},
            {"transparent", ".frag", becomes("void main() { gl_FragColor = vec4(0.); }")},
            {"outside", ".glib", behind_lines("(LookAt|Ortho) .*", "Translate 0. 100000. 0.")},
            {"program-only", ".glib",
             [](const std::string& text) {
                 const std::string drawing = "(Sphere|Quad|Box|Teapot|glBegin|glVertex|glEnd)";
                 return replaced(text, "\n *" + drawing + "[^\n]*", "");
             }},
            {"blank", ".glib", becomes("")}};
}

void make_emptied(const fs::path& from, const fs::path& to, const Emptied& one) {
    fs::copy(from, to / one.name, fs::copy_options::recursive);
    bool changed = false;
    for (const auto& entry : fs::recursive_directory_iterator(to / one.name)) {
        if (!entry.path().string().ends_with(one.ending)) continue;
        const std::string text = bytes_of(entry.path()), damaged = one.damage(text);
        changed = changed || damaged != text;
        std::ofstream(entry.path()) << damaged;
    }
    EXPECT_TRUE(changed) << from << " as " << one.name;
}

// What `snell grade` says of the folder's submissions by its rubric, with small pictures: what it compares does not
// depend on their size. Pictures of the size that the rubric has are drawn by the examples of README.md.
nlohmann::json grades(const Scratch& folder) {
    const std::string rubric = bytes_of(folder.path("rubric.toml")),
                      small = replaced(rubric, "\nsize = \"[0-9x]+\"", "\nsize = \"64x64\"");
    EXPECT_NE(small, rubric);
    folder.write("rubric.toml", small);
    const Outcome outcome = snell("grade " + folder.path("rubric.toml") + " " + folder.path("submissions") + " -o " +
                                  folder.path("report"));
    EXPECT_EQ(outcome.status, 0) << rubric << '\n' << outcome.output;
    EXPECT_FALSE(outcome.says("reference-fails")) << rubric << ": the solution itself\n" << outcome.output;
    return nlohmann::json::parse(bytes_of(folder.path("report/results.json")), nullptr, false);
}

// A rubric that rewards what was handed out, or what shows nothing, teaches nothing. What is seen is judged before any
// rubric is, so one lesson has all of the damages, and the others have one each.
TEST(Teaching, RubricsGiveThePointsThatThePagesTell) {
    const std::vector<Emptied> damages = emptied();
    std::size_t next = 0;
    for (const fs::path& lesson : lessons()) {
        const Scratch folder;
        const fs::path handed_in = folder.path("submissions");
        fs::copy(lesson, folder.path(), fs::copy_options::recursive);
        fs::copy(lesson / "handout", handed_in / "handout", fs::copy_options::recursive);
        const bool all = lesson.filename() == "07-glass";  // two programs and six images
        for (const Emptied& one : damages)
            if (all || &one == &damages[next % damages.size()])
                make_emptied(lesson / "submissions/passing", handed_in, one);
        ++next;
        const nlohmann::json results = grades(folder);
        EXPECT_EQ(results["points"], 10) << lesson;
        const std::vector<double> told = points_told(bytes_of(lesson / "README.md"));
        ASSERT_EQ(told.size(), 2u) << lesson;
        EXPECT_EQ(told[0], 10) << lesson;
        EXPECT_LE(told[1], 5) << lesson;
        EXPECT_EQ(results["submissions"].size(), all ? 3 + damages.size() : 4u);
        for (const auto& one : results["submissions"]) {
            const std::string name = one["name"];
            const double points = one["points"];
            if (name == "handout")
                EXPECT_LE(points, 5) << lesson << '\n' << one.dump(1);
            else
                EXPECT_NEAR(points,
                            name == "passing"   ? told[0]
                            : name == "failing" ? told[1]
                                                : 0,
                            .05)
                    << lesson << '\n'
                    << one.dump(1);
        }
    }
}

TEST(Teaching, NothingEarnsNothingByRubricsOfTemplates) {
    const std::vector<Emptied> damages = emptied();
    std::size_t next = 0;
    for (const auto& kind : fs::directory_iterator(SNELL_ROOT "/templates")) {
        const Scratch folder;
        const std::string name = kind.path().filename().string(), own = folder.path(name),
                          rubric = folder.path("rubric.toml");
        const Outcome made = snell("new " + own + " --kind " + name);
        ASSERT_EQ(made.status, 0) << made.output;
        ASSERT_EQ(snell("grade --new " + own + "/" + name + ".glib -o " + rubric).status, 0);
        const fs::path handed_in = folder.path("submissions");
        fs::create_directory(handed_in);
        fs::copy(own, handed_in / "whole", fs::copy_options::recursive);
        make_emptied(own, handed_in, damages[next++ % damages.size()]);
        const nlohmann::json results = grades(folder);
        ASSERT_EQ(results["submissions"].size(), 2u);
        for (const auto& one : results["submissions"])
            EXPECT_EQ(one["points"], one["name"] == "whole" ? results["points"] : nlohmann::json(0)) << rubric << '\n'
                                                                                                     << one.dump(1);
    }
}

}  // namespace
}  // namespace snell::test
