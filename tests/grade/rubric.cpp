// Mistakes in rubrics: each is told at its place, before anything is judged.
#include "tests/grade/submissions.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;

class RubricMistakes : public GradeTest {
protected:
    void SetUp() override {
        GradeTest::SetUp();
        if (!IsSkipped()) scene("s/ann");
    }
    // The item begins in line 5, below the usual head.
    void says(const std::string& item, const std::string& text) const {
        folder.write("r.toml", head + item);
        const Outcome made = grade("r.toml s -o out");
        EXPECT_EQ(made.status, 1) << item;
        EXPECT_TRUE(made.says(text)) << item << made.output;
        EXPECT_TRUE(made.says(" | ")) << "the line is quoted: " << made.output;
        EXPECT_FALSE(fs::exists(at("out"))) << item;
    }
    // The mistake is in the value of the first key of an item, at this column of the item's second line.
    void item(const std::string& text, int column, const std::string& said) const {
        says("[[item]]\n" + text + "\n", "r.toml:6:" + std::to_string(column) + ": error: " + said);
    }
};

TEST_F(RubricMistakes, HavePlacesAndSuggestions) {
    says("[[item]]\npoint = 3\nno_errors = true\n", "r.toml:6:1: error: a rubric has no 'point' here");
    says("[[item]]\npoint = 3\nno_errors = true\n", "did you mean 'points'?");
    says("[[item]]\nno_lints = [\"never-red\"]\n", "did you mean 'never-read'?");
    says("[[item]]\nneeds = [\"Teepot\"]\n", "r.toml:6:10: error: there is no command 'Teepot'");
    says("[[item]]\nexpect = \"darkr\"\nset = { uKd = 0 }\n", "did you mean 'darker'?");
    says("[[item]]\nexpect = \"darker\"\n", "compared with itself");
    says("[[item]]\ncounters = { drews = 1 }\n", "did you mean 'draws'?");
    says("[[item]]\npoints = \"two\"\nno_errors = true\n", "'points' is a number, not a text in quotes");
    says("[[item]]\npoints = 2\n", "does not say what it judges");
    says("[[item]]\nno_errors = true\nneeds = [\"Sphere\"]\n", "judges two things");
    says("[[item]]\nno_errors = tru\n", "r.toml:6:");
    says("size = \"64\"\n[[item]]\nno_errors = true\n", "error");
    says("", "no items");
    folder.write("r.toml", "reference = \"nothere.glib\"\n[[item]]\nno_errors = true\n");
    EXPECT_TRUE(grade("r.toml s -o out").says("r.toml:1:13: error: there is no scene 'nothere.glib'"));
    const auto shares = [&](const std::string& path, const std::string& text) {
        folder.write("r.toml", "shared = [\"" + path + "\"]\n[[item]]\nno_errors = true\n");
        const Outcome made = grade("r.toml s -o out");
        EXPECT_TRUE(made.says("r.toml:1:11: error: 'shared' names '" + path + "', which " + text)) << made.output;
        EXPECT_EQ(made.status, 1);
    };
    shares("nothere", "is not there");
    write_too_many("many");
    shares("many", "holds more than 20000 files and folders");
    shares("/", "holds more than ");
    fs::create_directories(at("large"));
    folder.write("large/zeros", "");
    fs::resize_file(at("large/zeros"), std::uintmax_t{3} << 30);
    shares("large", "holds more than 2 GB");
    // Where a folder cannot be opened, all others count all the same.
    std::string deep = "deep";
    for (int i = 0; i < 60; ++i) deep += "/1";
    fs::create_directories(at(deep));
    fs::rename(at("large/zeros"), at(deep + "/zeros"));
    folder.write("r.toml", "shared = [\"objs\", \"deep\"]\n[[item]]\nno_errors = true\n");
    fs::create_directories(at("objs"));
    const Outcome few = run("cd '" + folder.path() + "' && ulimit -n 32 && " SNELL_BIN "/snell grade r.toml s -o out");
    EXPECT_TRUE(few.says("r.toml:1:19: error: 'shared' names 'deep', which holds more than 2 GB")) << few.output;
    EXPECT_EQ(grade("nothere.toml s -o out").status, 1);
    EXPECT_EQ(grade("r.toml -o out").status, 2);
    EXPECT_EQ(grade("r.toml s").status, 2);
}

TEST_F(RubricMistakes, UniformsHaveKnownTypesAndRangesThatRise) {
    item("uniforms = { uKd = \"floot 0..1\" }", 20, "there is no type 'floot' [rubric-value]\n    6 | uniforms");
    says("[[item]]\nuniforms = { uKd = \"floot 0..1\" }\n", "did you mean 'float'?");
    item("uniforms = { uKd = \"float 1..0\" }", 20, "the range begins at 1, above its end at 0");
    item("uniforms = { uKd = \"float nan..1\" }", 20, "'float nan..1' is not a type with a range");
    item("uniforms = { uKd = \"float 1\" }", 20, "'float 1' is not a type with a range");
    item("uniforms = { uKd = \"0..1\" }", 20, "'0..1' is not a type with a range");
    item("uniforms = { uKd = 1 }", 20, "'uKd' is a type, with or without a range");
    item("uniforms = { uImage = \"sampler2D 0..1\" }", 23, "a sampler2D has no slider");
    item("uniforms = {}", 12, "'uniforms' is empty");
    item("uniforms = 3", 12, "'uniforms' is a table in braces {}, not a number");
}

TEST_F(RubricMistakes, ItemsThatCanNeitherGiveNorCostPoints) {
    item("needs = []", 9, "'needs' is empty, so that the item never costs points");
    item("forbids = []", 11, "'forbids' is empty");
    item("no_lints = []", 12, "'no_lints' is empty");
    item("counters = {}", 12, "'counters' is empty");
    item("points = 0\nno_errors = true", 10, "'points' is a number more than 0");
    item("points = 1.5e308\nno_errors = true", 10, "'points' is a number more than 0 and at most 1000000");
    item("slower = 0", 10, "'slower' is a number more than 0");
    item("each = 1\nno_errors = true", 1, "a rubric has no 'each' here");
    item("each = 0\nno_lints = [\"never-read\"]", 8, "'each' is a number more than 0");
    item("counters = { draws = \"8..1\" }", 22, "the range begins at 8, above its end at 1");
    for (const std::string never : {"nan", "-1", "true", "\"x\""})
        item("counters = { draws = " + never + " }", 22, "'draws' is a maximum from 0, or a range");
    const std::string set = "\nset = { uKd = 0 }\nexpect = ";
    item("by = 1.5" + set + "\"darker\"", 6, "'by' is a number from 0 to 1");
    item("by = 2" + set + "\"different\"", 6, "'by' is a number from 0 to 1");
    item("by = 1" + set + "\"same\"", 6, "'by' is a number from 0 that is less than 1");
    item("by = 1" + set + "\"mirrored\"", 6, "'by' is a number from 0 that is less than 1");
    item("max_rmse = 0.1" + set + "\"darker\"", 1, "a rubric has no 'max_rmse' here");
    item("by = 0.1" + set + "\"reference\"", 1, "a rubric has no 'by' here");
    item("than = { uKd = 1 }" + set + "\"finite\"", 1, "a rubric has no 'than' here");
    item("by = 0.1" + set + "\"finite\"", 1, "a rubric has no 'by' here");
    item("deduct = 0\nno_errors = true", 10, "'deduct' is a number more than 0");
    item("deduct = 1\npoints = 1\nno_errors = true", 10, "the item has both 'points' and 'deduct'");
    item("named = \"a/b.glib\"", 9, "'named' is the name of a file, without folders");
    item("named = \"\"", 9, "'named' is the name of a file, without folders");
    item("except = []", 10, "'except' is empty");
    const std::string two = "'either' is a list of at least two tables";
    item("either = []", 10, two);
    item("either = [{ no_errors = true }]", 10, two);
    item("either = [{ no_errors = true }, 3]", 10, two);
    item("either = [{ no_errors = true }, {}]", 33, "the item does not say what it judges");
    item("either = [{ no_errors = true }, { needs = \"Sphere\", points = 2 }]", 53, "a rubric has no 'points' here");
    item("either = [{ no_errors = true }, { needs = \"Sphere\", no_errors = true }]", 33, "the item judges two things");
    says("[[item]]\neither = [{ no_errors = true }, { needs = \"Sphere\" }]\nno_errors = true\n",
         "r.toml:5:1: error: the item judges two things");
    item("max_rmse = 1" + set + "\"reference\"", 12, "'max_rmse' is a number from 0 that is less than 1");
    item("max_flip = 1" + set + "\"reference\"", 12, "'max_flip' is a number from 0 that is less than 1");
    item("max_pixels = 100" + set + "\"reference\"", 14, "'max_pixels' is a number from 0 that is less than 100");
}

TEST_F(RubricMistakes, HiddenValuesAreFiniteNumbers) {
    for (const std::string value : {"nan", "-inf", "[1, nan]", "[1, \"a\"]", "\"red\"", "[]", "{ a = 1 }", "[[1, 2]]"})
        item("set = { uKd = " + value + " }\nexpect = \"darker\"", 15, "'uKd' has no value: a finite number");
    says("[[item]]\nset = { Ball.uKd = 1 }\nexpect = \"darker\"\n", "a name with a dot is written in quotes");
}

TEST_F(RubricMistakes, NumbersOfTheWholeRubricHaveBounds) {
    const auto whole = [&](const std::string& line, const std::string& said) {
        folder.write("r.toml", line + "\n[[item]]\nno_errors = true\n");
        const Outcome made = grade("r.toml s -o out");
        EXPECT_EQ(made.status, 1) << line;
        EXPECT_TRUE(made.says(said)) << made.output;
    };
    for (const std::string samples : {"0", "2.5", "65", "-1", "nan"})
        whole("samples = " + samples, "r.toml:1:11: error: 'samples' is a whole number from 1 to 64");
    for (const std::string seconds : {"0", "-1", "inf", "nan", "1e7"})
        whole("timeout = " + seconds, "r.toml:1:11: error: 'timeout' is a number of seconds, more than 0");
    whole("scene = \"a/b.glib\"", "r.toml:1:9: error: 'scene' is the name of a file, without folders");
}

}  // namespace

}  // namespace snell::test
