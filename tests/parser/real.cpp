// Doubles as text and back, against what GCC's standard library reads and writes.
#include "parser/text/number.h"
#include "tests/std.h"
#include "tests/words.h"

namespace snell {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Real, class... Format>
std::string by_library(Real value, Format... format) {
    std::array<char, 400> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, format...).ptr};
}

void expect_same(double value) {
    EXPECT_EQ(real_text(value), by_library(value));
    EXPECT_EQ(real_text(static_cast<float>(value)), by_library(static_cast<float>(value)));
    EXPECT_EQ(fixed_text(value), by_library(value, std::chars_format::fixed));
}

template <class Real>
Real of_bits(std::uint64_t bits) {
    Real value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

TEST(Reals, AreWrittenAsTheLibraryDoes) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const std::uint64_t bits = random();
        EXPECT_EQ(real_text(of_bits<double>(bits)), by_library(of_bits<double>(bits)));
        EXPECT_EQ(real_text(of_bits<float>(bits)), by_library(of_bits<float>(bits)));
        expect_same(static_cast<double>(bits % 100'000) / std::pow(10, static_cast<int>(bits >> 40) % 9 - 3));
    }
    for (int exponent = -1074; exponent < 1024; ++exponent) {
        const double power = std::ldexp(1., exponent);
        for (const double value : {power, -power, std::nextafter(power, 0.), std::nextafter(power, infinity)})
            expect_same(value);
    }
    for (const double value : {0., -0., infinity, -infinity, std::nan(""), -std::nan(""), 1e5, 99999., 123456., 1e-4,
                               1.2e-4, 1e-5, 1e15, 1e16, 1e22, 1e23, .1, 1. / 3})
        expect_same(value);
}

void expect_read_alike(const std::string& text) {
    double ours = 7, theirs = 7;
    const char *const first = text.data(), *const last = first + text.size();
    const auto [end, error] = read_real(first, last, ours);
    const auto [library_end, library_error] = std::from_chars(first, last, theirs);
    EXPECT_EQ(end, library_end) << text;
    EXPECT_EQ(error, library_error) << text;
    EXPECT_EQ(std::memcmp(&ours, &theirs, sizeof ours), 0) << text << ": " << ours << ", not " << theirs;
}

TEST(Reals, AreReadAsTheLibraryDoes) {
    std::mt19937_64 random(2);
    constexpr std::string_view letters = "0123456789.eE+-infatyNAI x()";
    for (int i = 0; i < 100'000; ++i) {
        std::string text;
        for (std::size_t size = random() % 9; text.size() < size;)
            text += letters[random() % (i % 2 == 0 ? 15 : letters.size())];
        expect_read_alike(text);
    }
    for (int i = 0; i < 20'000; ++i) {
        std::string text = random() % 2 == 0 ? "-" : "";
        for (std::size_t digits = random() % 30; digits > 0; --digits) text += letters[random() % 10];
        text += '.';
        for (std::size_t digits = random() % 30; digits > 0; --digits) text += letters[random() % 10];
        if (random() % 2 == 0) text += "e" + std::to_string(static_cast<int>(random() % 700) - 350);
        expect_read_alike(text);
    }
    for (const std::string& text :
         words("1e400,-1e400,1e-400,0e400,0e-999,4.9e-324,2e-324,3e-324,1.7976931348623158e308,"
               "1.7976931348623159e308,nan(x),-nan,infinity,infinit,INF,1e,1e+,1.,.,,-,0.0000e9,"
               "2.2250738585072014e-308,2.2250738585072011e-308,1e99999999999999999999",
               ','))
        expect_read_alike(text);
}

}  // namespace
}  // namespace snell
