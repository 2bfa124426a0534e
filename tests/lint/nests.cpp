// Loops in loops whose bounds depend on the counters around: told as often as an interpreter goes round.
#include "tests/lint/help.h"

namespace snell::lint {
namespace {

constexpr std::int64_t most = 65536;  // as src/lint/loops.cpp has it

using Values = std::vector<int>;  // of the counters around, outermost first

struct Number {
    std::string text;
    std::function<std::optional<int>(const Values&)> value;  // null: GLSL leaves it undefined
};

struct Loop {
    Number begin, bound;
    int step = 1;
    bool with_equal = false, by_while = false, named = false;
};

class Nests {
public:
    explicit Nests(unsigned seed) : random_(seed) {}

    std::vector<Loop> loops() {
        std::vector<Loop> all;
        const int depth = among(2, 4);
        for (int level = 0; level < depth; ++level) {
            Loop loop{number(level, 0, among(0, 2) == 0), number(level, 60 >> (level + depth - 2), true), among(1, 2)};
            loop.with_equal = among(0, 1) == 0;
            loop.by_while = among(0, 3) == 0;
            loop.named = among(0, 2) == 0;
            if (among(0, 3) == 0) loop.step = -loop.step, std::swap(loop.begin, loop.bound);
            all.push_back(std::move(loop));
        }
        return all;
    }

private:
    int among(int least, int greatest) { return std::uniform_int_distribution(least, greatest)(random_); }

    // Of the counters of the loops around; `near` where it is a constant.
    Number number(int level, int near, bool composed) {
        if (level == 0 || !composed) return constant(near + among(0, near));
        const Number a = counter(among(0, level - 1)),
                     b = among(0, 1) == 0 ? counter(among(0, level - 1)) : constant(near);
        switch (among(0, 7)) {
            case 0:
                return both(constant(near), a, "-", [](int x, int y) { return std::optional(x - y); });
            case 1:
                return both(a, b, "*", [](int x, int y) { return std::optional(x * y); });
            case 2:
                return both(a, b, "+", [](int x, int y) { return std::optional(x + y); });
            case 3:
                return both(a, constant(among(1, 5)), "/", [](int x, int y) { return std::optional(x / y); });
            case 4:
                return both(a, constant(among(2, 5)), "%",
                            [](int x, int y) { return x < 0 ? std::nullopt : std::optional(x % y); });
            case 5:
                return call("min", a, b, [](int x, int y) { return std::min(x, y); });
            case 6:
                return call("max", a, b, [](int x, int y) { return std::max(x, y); });
            default:
                return a;
        }
    }
    static Number constant(int v) {
        return {std::to_string(v), [v](const Values&) { return std::optional(v); }};
    }
    static Number counter(int level) {
        return {"i" + std::to_string(level),
                [level](const Values& values) { return std::optional(values[static_cast<std::size_t>(level)]); }};
    }
    template <class Do>
    static Number both(const Number& a, const Number& b, const std::string& op, Do apply) {
        return {"(" + a.text + " " + op + " " + b.text + ")", [=](const Values& values) -> std::optional<int> {
                    const auto x = a.value(values), y = b.value(values);
                    return x && y ? apply(*x, *y) : std::nullopt;
                }};
    }
    template <class Do>
    static Number call(const std::string& name, const Number& a, const Number& b, Do apply) {
        return {name + "(" + a.text + ", " + b.text + ")", [=](const Values& values) -> std::optional<int> {
                    const auto x = a.value(values), y = b.value(values);
                    return x && y ? std::optional(apply(*x, *y)) : std::nullopt;
                }};
    }

    std::mt19937 random_;
};

std::string written(const std::vector<Loop>& loops) {
    std::string text, behind;
    for (std::size_t level = 0; level < loops.size(); ++level) {
        const Loop& loop = loops[level];
        const std::string i = "i" + std::to_string(level), n = "n" + std::to_string(level);
        const std::string op = std::string(loop.step > 0 ? "<" : ">") + (loop.with_equal ? "=" : "");
        const std::string step = i + (loop.step > 0 ? " += " : " -= ") + std::to_string(std::abs(loop.step));
        if (loop.named) text += "int " + n + " = " + loop.bound.text + "; ";
        const std::string test = i + " " + op + " " + (loop.named ? n : loop.bound.text);
        const std::string begin = "int " + i + " = " + loop.begin.text + "; ";
        text += loop.by_while ? begin + "while (" + test + ") { " : "for (" + begin + test + "; " + step + ") { ";
        behind = (loop.by_while ? step + "; } " : std::string("} ")) + behind;
    }
    return text + "x += 1.; " + behind;
}

// Rounds, and one more for each time that a loop is left; null: undefined, or too many for a test.
std::optional<std::int64_t> counted(const std::vector<Loop>& loops, Values& values, std::int64_t left) {
    if (values.size() == loops.size()) return 0;
    const Loop& loop = loops[values.size()];
    const auto begin = loop.begin.value(values);
    std::int64_t rounds = 1;
    auto bound = loop.bound.value(values);
    if (!begin || !bound) return std::nullopt;
    for (int i = *begin;; i += loop.step, ++rounds) {
        const bool within = loop.step > 0 ? i < *bound : i > *bound;
        if (!within && !(loop.with_equal && i == *bound)) return rounds;
        values.push_back(i);
        const auto inner = counted(loops, values, left - rounds);
        values.pop_back();
        if (!inner || (rounds += *inner) > left) return std::nullopt;
    }
}

std::optional<std::int64_t> said(const std::string& text) {
    constexpr std::string_view before = "go round at least ";
    const auto at = text.find(before);
    if (at == std::string::npos) return std::nullopt;
    return std::stoll(text.substr(at + before.size()));
}

TEST(LintNests, AreCountedAsAnInterpreterDoes) {
    int many = 0, few = 0;
    for (unsigned seed = 1; many < 25 || few < 25; ++seed) {
        ASSERT_LT(seed, 3000U) << many << ' ' << few;
        const std::vector<Loop> loops = Nests(seed).loops();
        Values values;
        const auto rounds = counted(loops, values, 900'000);
        if (!rounds || *rounds < 20'000) continue;
        ++(*rounds > most ? many : few);
        const std::string text = written(loops);
        const Linted linted = looping(text);
        const auto told = said(linted.text());
        EXPECT_EQ(told.has_value(), *rounds > most) << text << *rounds << linted.text();
        EXPECT_LE(told.value_or(0), *rounds) << text;
        EXPECT_GT(told.value_or(most + 1), most) << text;
    }
}

TEST(LintNests, FourDeepAndBoundsThatShrinkOrAreSquares) {
    for (const auto& [loop, rounds] : std::vector<std::pair<std::string, std::string>>{
             {"for (int i = 0; i < 40; ++i) for (int j = 0; j < i; ++j) for (int k = 0; k < j; ++k) "
              "for (int m = 0; m < k; ++m) x += 1.;",
              "at least 112791 times"},  // C(40, 4) + 2 C(40, 3) + 2 C(40, 2) + 2 * 40 + 1
             {"for (int i = 0; i < 400; ++i) for (int j = 0; j < 400 - i; ++j) x += 1.;", "at least 81001 times"},
             {"for (int i = 0; i < 60; ++i) for (int j = 0; j < i * i; ++j) x += 1.;", "at least 70331 times"}})
        EXPECT_NE(looping(loop).text().find(rounds), std::string::npos) << loop << looping(loop).text();
    EXPECT_FALSE(
        looping("for (int i = 0; i < 57; ++i) for (int j = 0; j < i * i; ++j) x += 1.;").has(Rule::many_rounds));
}

TEST(LintNests, ThroughFunctionsFloatsAndSliders) {
    const std::string inner = "float inner(int n, float y) { for (int k = 0; k < n; ++k) y += 1.; return y; }\n";
    const auto told = [&](const std::string& loop, std::string_view values = "") {
        return looping(loop, values, inner).has(Rule::many_rounds);
    };
    EXPECT_TRUE(told("for (int i = 0; i < 400; ++i) x += inner(400 - i, x);"));
    EXPECT_FALSE(told("for (int i = 0; i < 350; ++i) x += inner(350 - i, x);"));
    EXPECT_TRUE(told("for (int i = 0; i < 400; ++i) for (float f = 0.; f < float(i); f += 1.) x += f;"));
    EXPECT_TRUE(told("for (int i = 0; i < uN; ++i) for (int j = 0; j < uN - i; ++j) x += 1.;", "uN <1 10 400>"));
    EXPECT_FALSE(told("for (int i = 0; i < uN; ++i) for (int j = 0; j < uN - i; ++j) x += 1.;", "uN <1 10 350>"));
    // No value of the slider makes both ends of the range true.
    EXPECT_FALSE(told("for (int i = 0; i < uN; ++i) for (int j = i; j < i + 400 - uN; ++j) x += 1.;", "uN <1 10 400>"));
    const std::string sliding =
        looping("for (int i = 0; i < uN; ++i) for (int j = 0; j < uN - i; ++j) x += 1.;", "uN <1 10 400>").text();
    EXPECT_NE(sliding.find("may go round at least 81001 times"), std::string::npos) << sliding;
    // What was compared is not at its end there, and is again behind.
    EXPECT_FALSE(told("if (uN < 10) for (int i = 0; i < uN; ++i) x += 1.;", "uN <1 10 100000>"));
    EXPECT_TRUE(told("if (uN < 10) x += 1.; for (int i = 0; i < uN; ++i) x += 1.;", "uN <1 10 100000>"));
}

// Only what is certain is told.
TEST(LintNests, WhatMayBeOtherwiseIsNotKnown) {
    for (const char* loop :
         {"for (int i = 0; i < 400; ++i) { int n = i; if (x > uX) n = 0; for (int j = 0; j < n; ++j) x += 1.; }",
          "for (int i = 0; i < 400; ++i) { if (x > uX) continue; for (int j = 0; j < i; ++j) x += 1.; }",
          "for (int i = 0; i < 400; ++i) if (x > uX) for (int j = 0; j < i; ++j) x += 1.;",
          "int n; for (int i = 0; i < 400; ++i) { n = 0; for (int j = 0; j < n * i; ++j) x += 1.; n = 9; }",
          "for (int i = 0; i < 400; ++i) for (int j = 0; j < min(i, uM); ++j) x += 1.;",
          "int m = uM; for (int i = 0; i < 400; ++i) { int n = m + i; for (int j = 0; j < n; ++j) x += 1.; m = 0; }",
          "int i = uM; int n = i + 1; for (i = 0; i < 400; ++i) for (int j = 0; j < n; ++j) x += 1.;"})
        EXPECT_FALSE(looping(loop).has(Rule::many_rounds)) << loop << looping(loop).text();
    // The counter is one more within.
    EXPECT_FALSE(
        looping("int i = 0; while (i < 361) { ++i; for (int j = 361; j > i; --j) x += 1.; }").has(Rule::many_rounds));
}

}  // namespace
}  // namespace snell::lint
