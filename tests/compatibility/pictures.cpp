// The translation draws what the untouched shaders draw: through Mesa's compatibility context where that accepts
// them, else what an equivalent modern program draws.
#include "src/platform/headless.h"
#include "tests/compatibility/draw.h"
#include "tests/std.h"

namespace snell::oracle {
namespace {

namespace fs = std::filesystem;

// Pixels in a thousand that may differ; the difference must lie on a discontinuity, which the reason names.
struct Exception {
    int per_thousand;
    std::string_view reason;
};
const std::map<std::string, Exception> exceptions = {
    {"input-not-written", {1000, "what an input holds that nobody writes is undefined; the translation reads zero"}},
    {"light-spot-cutoff", {1000, "Mesa has 0 where OpenGL has cos(180°) = -1"}},
};

// Programs whose picture on OpenGL ES has to be another one.
const std::map<std::string, std::string_view> no_es_picture = {
    {"array-redeclared", "ES has no arrays without a size"},
    {"texture-1d", "ES has no such textures: what is sampled in their place is up to the runtime"},
    {"point-size-geometry", "ES has the size of points in geometry shaders only as an extension"},
};

// A context and what draws in it, which can only be deleted while the context is current.
struct Place {
    Place(const ContextRequest& request, Kind kind, std::string& error)
        : context(HeadlessContext::make(request, error)) {
        if (context) stand = std::make_unique<Stand>(kind);
    }
    ~Place() {
        if (context) context->make_current();
    }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    std::unique_ptr<HeadlessContext> context;
    std::unique_ptr<Stand> stand;  // goes before its context
};

// The contexts, made once.
class Oracle {
public:
    bool ready() const { return core_.context && compatibility_.context; }
    const std::string& error() const { return error_; }

    // In the compatibility context; null where it refuses the program.
    std::optional<Picture> untouched(const Texts& texts, const Needs& needs, const glsl::Translation& translation) {
        return drawn(compatibility_, texts, needs, translation);
    }
    std::optional<Picture> core(const Texts& texts, const Needs& needs, const glsl::Translation& translation) {
        return drawn(core_, texts, needs, translation);
    }
    std::optional<Picture> es(const Texts& texts, const Needs& needs, const glsl::Translation& translation) {
        return drawn(es_, texts, needs, translation);
    }
    bool has_es() const { return es_.context != nullptr; }
    const std::string& log() const { return log_; }

private:
    std::optional<Picture> drawn(Place& place, const Texts& texts, const Needs& needs,
                                 const glsl::Translation& translation) {
        place.context->make_current();
        const Program program = build(texts);
        log_ = program.log;
        if (!program.id) return std::nullopt;
        return place.stand->draw(program, needs, translation);
    }

    std::string error_, no_es_, log_;  // the other tests can do without ES
    Place core_{{.version = 45}, Kind::core, error_};
    Place compatibility_{{.version = 45, .compatibility = true}, Kind::compatibility, error_};
    Place es_{{.version = 32, .es = true}, Kind::es, no_es_};
};

int allowance(const std::string& name) {
    const auto exception = exceptions.find(name);
    return exception == exceptions.end() ? 1 : exception->second.per_thousand;
}

void expect_same(const Case& c, const Picture& expected, const Picture& actual, const Texts& translated,
                 int per_thousand) {
    const Difference d = difference(expected, actual);
    EXPECT_GT(d.drawn, d.pixels / 200) << "next to nothing is drawn";
    EXPECT_LE(d.differing, d.pixels * per_thousand / 1000)
        << "of " << d.pixels << " pixels, by " << d.largest << " at most; the translation is in "
        << write_texts(c.name, translated);
}

enum class Verdict { same_as_untouched, same_as_modern, refused };

// The least that can be done for a modern shader that does not say so.
Texts with_version(Texts texts) {
    for (auto& [stage, text] : texts)
        if (("\n" + text).find("\n#version") == std::string::npos) text = "#version 330 compatibility\n" + text;
    return texts;
}

// Draws one program every way there is and compares.
Verdict check(Oracle& oracle, const Case& c, bool must_have_reference) {
    SCOPED_TRACE(c.name);
    const Texts original = texts(c.files);
    const Needs needs = oracle::needs(original);
    const Translated translated = oracle::translated(c, {.version = 450, .es = false, .fp64 = true});
    EXPECT_TRUE(translated.ok) << translated.messages;
    auto untouched = oracle.untouched(original, needs, translated.translation);
    const std::string refusal = oracle.log();
    if (!untouched) untouched = oracle.untouched(with_version(original), needs, translated.translation);
    std::optional<Picture> modern;
    if (!c.modern.empty()) {
        const Texts twin = texts(c.modern);
        Needs same = needs;
        if (original.contains(Stage::geometry) && !twin.contains(Stage::geometry))
            same.primitive = oracle::needs(twin).primitive;
        modern = oracle.core(twin, same, translated.translation);
        EXPECT_TRUE(modern) << "the modern program does not link:\n" << oracle.log();
    }
    if (!translated.ok) return Verdict::refused;
    const auto picture = oracle.core(translated.texts, needs, translated.translation);
    if (!picture && !untouched && !must_have_reference) return Verdict::refused;  // a mistake, not a dialect
    EXPECT_TRUE(picture) << "the translation does not link:\n" << oracle.log() << write_texts(c.name, translated.texts);
    if (!picture) return Verdict::refused;
    if (modern) expect_same(c, *modern, *picture, translated.texts, 1);
    if (untouched) expect_same(c, *untouched, *picture, translated.texts, allowance(c.name));
    EXPECT_TRUE(modern || untouched || !must_have_reference) << "refused, and there is no modern twin:\n" << refusal;
    return untouched ? Verdict::same_as_untouched : modern ? Verdict::same_as_modern : Verdict::refused;
}

class Pictures : public testing::Test {
protected:
    static void SetUpTestSuite() { shared() = std::make_unique<Oracle>(); }
    static void TearDownTestSuite() { shared().reset(); }
    void SetUp() override {
        if (!oracle.ready()) GTEST_SKIP() << "no graphics: no compatibility context here: " << oracle.error();
    }
    static std::unique_ptr<Oracle>& shared() {
        static std::unique_ptr<Oracle> oracle;
        return oracle;
    }
    Oracle& oracle = *shared();

    void check_all(const std::vector<Case>& cases, bool must_have_reference) {
        std::map<Verdict, int> verdicts;
        for (const Case& c : cases) {
            const Verdict verdict = check(oracle, c, must_have_reference);
            ++verdicts[verdict];
            if (verdict == Verdict::refused) std::printf("%s is refused and has no modern twin\n", c.name.c_str());
        }
        std::printf("%zu programs: %d as untouched, %d as their modern twin, %d without a reference\n", cases.size(),
                    verdicts[Verdict::same_as_untouched], verdicts[Verdict::same_as_modern],
                    verdicts[Verdict::refused]);
    }
};

TEST_F(Pictures, OfSmallProgramsAreTheSame) {
    const std::vector<Case> cases = cases_of_folder("tests/glsl");
    ASSERT_GE(cases.size(), 80u);
    check_all(cases, true);
}

// The driver's own compiler knows no #include, so programs that have one can't be drawn untouched.
bool includes(const Case& c) {
    const Texts all = texts(c.files);
    return std::any_of(all.begin(), all.end(),
                       [](const auto& stage) { return ("\n" + stage.second).find("\n#include") != std::string::npos; });
}

TEST_F(Pictures, OfScenesAreTheSame) {
    std::vector<Case> cases;
    for (const auto& entry : fs::recursive_directory_iterator("scenes"))
        if (entry.path().extension() == ".glib")
            for (Case& c : cases_of_scene(entry.path()))
                if (!includes(c)) cases.push_back(std::move(c));
    ASSERT_GE(cases.size(), 4u);
    check_all(cases, false);
}

TEST_F(Pictures, OfTheCorpusAreTheSame) {
    const fs::path corpus = "../shared/corpus";
    if (!fs::exists(corpus)) GTEST_SKIP() << "no ../shared/corpus";
    std::vector<Case> cases;
    for (const auto& entry : fs::directory_iterator(corpus))
        if (entry.is_directory())
            for (Case& c : pairs_of_folder(entry.path())) cases.push_back(std::move(c));
    check_all(cases, false);
}

// Initialised uniforms get their values from the translation here, and there are no implicit conversions.
TEST_F(Pictures, OnOpenGlEsAreThoseOfTheCoreProfile) {
    if (!oracle.has_es()) GTEST_SKIP() << "no graphics: no OpenGL ES 3.2 here";
    for (const Case& c : cases_of_folder("tests/glsl")) {
        if (no_es_picture.contains(c.name)) continue;
        SCOPED_TRACE(c.name);
        const Needs needs = oracle::needs(texts(c.files));
        const Translated core = translated(c, {.version = 450, .es = false, .fp64 = true});
        const Translated es = translated(c, {.version = 320, .es = true, .fp64 = false});
        const auto expected = oracle.core(core.texts, needs, core.translation);
        const auto actual = oracle.es(es.texts, needs, es.translation);
        EXPECT_TRUE(expected && actual) << es.messages << oracle.log();
        if (expected && actual) expect_same(c, *expected, *actual, es.texts, 1);
    }
}

TEST_F(Pictures, OfDifferentProgramsDiffer) {
    const auto picture = [&](const char* name) {
        const Texts t = texts({{Stage::vertex, "tests/glsl/plain.modern.vert"},
                               {Stage::fragment, std::string("tests/glsl/") + name + ".modern.frag"}});
        return oracle.core(t, needs(t), {});
    };
    const auto a = picture("plain"), b = picture("float-suffix");
    ASSERT_TRUE(a && b);
    EXPECT_GT(difference(*a, *b).differing, 1000);
    EXPECT_EQ(difference(*a, *a).differing, 0);
}

}  // namespace
}  // namespace snell::oracle
