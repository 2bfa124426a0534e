// Hard cases of text: what the C library makes of it beside what is read here.
#include <glm/gtc/matrix_transform.hpp>

#include "parser/text/number.h"
#include "parser/text_of.h"
#include "tests/hard_case.h"
#include "tests/parser/support.h"
#include "tests/std.h"

namespace snell::test {
namespace {

TEST(HardText, AxesWithoutADirection) {
    int ours = 0, naive = 0;
    for (const std::array<double, 3>& axis :
         {std::array<double, 3>{0, 0, 0}, {1e-30, 0, 0}, {1e-5, 1e-5, 0}, {1e-25, 1e-25, 0}, {1e30, 0, 1e30}}) {
        const Mat4 m = read("Rotate 30 " + text_of::number(axis[0]) + " " + text_of::number(axis[1]) + " " +
                            text_of::number(axis[2]) + "\nSphere\n")
                           .matrix(0);
        const glm::mat4 theirs = glm::rotate(glm::mat4(1), .5235987755982988F, glm::vec3(axis[0], axis[1], axis[2]));
        // The trace of a rotation by 30 degrees; without an axis there is none.
        const double trace = axis == std::array<double, 3>{0, 0, 0} ? 3 : 1 + std::sqrt(3.);
        ours += !(std::abs(m[0] + m[5] + m[10] - trace) < 1e-9);
        naive += !(std::abs(static_cast<double>(theirs[0][0] + theirs[1][1] + theirs[2][2]) - trace) < 1e-5);
    }
    hard_case({"27", "Rotate about axes of length 0, 1e-30, 1e-25, 1e-5, 1e30; naive: glm::rotate in float",
               "of 5 not 30 degrees", 0, static_cast<double>(ours), static_cast<double>(naive)});
    // Mesa's glRotate leaves the matrix as it is when the axis is no longer than 1e-4.
    const Mat4 tiny = read("Rotate 30 1e-5 1e-5 0\nSphere\n").matrix(0);
    hard_case({"A34", "Rotate about 1e-5 1e-5 0; naive: Mesa's glRotate, which does not turn", "degrees off", 1e-9,
               std::abs(std::acos((tiny[0] + tiny[5] + tiny[10] - 1) / 2) * 180 / 3.14159265358979323846 - 30), 30.});
}

TEST(HardText, StacksWithoutEnd) {
    std::string deep, empty = "PopMatrix\nSphere\n";
    for (int i = 0; i < 100'000; ++i) deep += "PushMatrix\n";
    const Read r = read(deep + "Scale 2\nSphere\n"), popped = read(empty);
    int unreported = 0;
    const auto said = [](const Read& in, std::string_view code) {
        return std::ranges::any_of(in.codes(), [&](const std::string& c) { return c.ends_with(code); });
    };
    unreported += !said(r, "matrix-stack-full") || r.scene().draws.size() != 1;
    unreported += !said(popped, "unbalanced-pop") || popped.scene().draws.size() != 1;
    hard_case({"33", "PushMatrix 100,000 deep, PopMatrix of nothing: said, and the rest is drawn",
               "of 2 not said or lost", 0, static_cast<double>(unreported), std::nullopt});
}

TEST(HardText, NumbersOfEveryHand) {
    int ours = 0, naive = 0;
    struct Text {
        const char* text;
        double value;  // NaN: not a number a scene may have
    };
    const double none = std::nan("");
    const Text texts[] = {{".5", .5},    {"5.", 5},     {"-.5", -.5},   {"+1", 1},     {"1e-3", 1e-3}, {"1e400", none},
                          {"nan", none}, {"inf", none}, {"0x10", none}, {"1d3", none}, {"−5", none},   {"1e39", none}};
    for (const Text& t : texts) {
        const Number n = read_number(t.text);
        const double as_read = n.usable() ? n.value : none;
        ours += !(as_read == t.value || (std::isnan(as_read) && std::isnan(t.value)));
        char* end = nullptr;
        const double by_strtod = std::strtod(t.text, &end);
        const double theirs = *end != '\0' ? none : by_strtod;
        naive += !(theirs == t.value || (std::isnan(t.value) && std::isnan(theirs) && end != t.text + 3));
    }
    hard_case({"45", "numbers such as .5, 5., +1, 1e400, nan, 0x10, 1d3, −5, 1e39; naive: strtod", "of 12 misread", 0,
               static_cast<double>(ours), static_cast<double>(naive)});
}

TEST(HardText, ValuesComeBackBitForBit) {
    std::mt19937_64 random(5);
    int ours = 0, naive = 0;
    for (int i = 0; i < 10'000; ++i) {
        const auto value = static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
        if (!std::isfinite(value)) continue;
        ours += std::bit_cast<std::uint64_t>(read_number(text_of::number(value)).value) !=
                std::bit_cast<std::uint64_t>(value);
        char text[32];
        std::snprintf(text, sizeof text, "%g", value);
        naive += std::bit_cast<std::uint64_t>(std::strtod(text, nullptr)) != std::bit_cast<std::uint64_t>(value);
    }
    hard_case({"46", "values that are saved and read again; naive: %g", "of 10000 changed", 0,
               static_cast<double>(ours), static_cast<double>(naive)});
}

TEST(HardText, BlanksAndMinusesThatOnlyLookTheSame) {
    // Each in place of the blank or of the sign: either it is read as that, or it is said by its code point.
    struct Odd {
        const char* text;
        const char* code_point;
        double x;  // that the sphere is moved by, if it is read; NaN: it can only be named
    };
    int ours = 0, naive = 0;
    for (const Odd& odd : {Odd{"Translate\xC2\xA0"
                               "1 0 0\nSphere\n",
                               "A0", 1},
                           {"Translate 1\xE2\x80\x8B 0 0\nSphere\n", "200B", 1},
                           {"Translate \xE2\x88\x92"
                            "1 0 0\nSphere\n",
                            "2212", -1},
                           {"Obj \xE2\x80\x9Cx.obj\xE2\x80\x9D\nSphere\n", "201C", std::nan("")}}) {
        const Read r = read(odd.text);
        bool said = false;
        for (const Diagnostic& d : r.diagnostics())
            said = said || d.message.find(odd.code_point) != std::string::npos ||
                   d.help.find(odd.code_point) != std::string::npos || d.code.find("minus") != std::string::npos ||
                   d.code.find("blank") != std::string::npos || d.code.find("quote") != std::string::npos;
        ours += !said && (r.scene().draws.empty() || r.matrix(0)[12] != odd.x);
        float x = 0, y = 0, z = 0;
        naive += std::sscanf(odd.text, "Translate %f %f %f", &x, &y, &z) != 3;
    }
    hard_case({"65", "U+00A0, U+200B, U+2212, typographic quotes in a scene: read, or named; naive: sscanf",
               "of 4 lost", 0, static_cast<double>(ours), static_cast<double>(naive)});
}

}  // namespace
}  // namespace snell::test
