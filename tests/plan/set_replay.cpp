// The corpus of the fuzzer of --set, what small changes make of it, and every kind of value.
#include "tests/fuzz/set_input.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

TEST(SetCorpus, HoldsAndSoDoItsMutations) {
    std::size_t count = 0;
    std::mt19937 random(1);
    constexpr std::string_view letters = "=,.<>[]+-e019nai \nuE";
    for (const auto& entry : std::filesystem::directory_iterator("tests/fuzz/set_corpus")) {
        const std::string bytes = bytes_of(entry.path());
        ASSERT_FALSE(bytes.empty()) << entry.path();
        ASSERT_EQ(fuzz::check_settings(bytes), "") << entry.path();
        for (int i = 0; i < 300; ++i) {
            std::string changed = bytes;
            for (int k = 0; k <= i % 4; ++k) changed[random() % changed.size()] = letters[random() % letters.size()];
            if (i % 5 == 0) changed.erase(random() % changed.size(), 1 + random() % 8);
            ASSERT_EQ(fuzz::check_settings(changed), "") << entry.path() << " changed to\n" << changed;
        }
        ++count;
    }
    EXPECT_GE(count, 4U);
}

TEST(SetNotFinite, NoUniformOfAnyKindTakesIt) {
    const fuzz::Settable all;
    for (const Control& control : all.controls.items)
        for (const char* value :
             {"nan", "NaN", "-nan", "inf", "-inf", "+inf", "infinity", "1e400", "-1e400", "1e999999"}) {
            for (std::size_t at = 0; at < control.value.size(); ++at) {
                fuzz::Settable fresh;
                std::string text = all.scene.programs[control.program].name + "." + control.name + "=";
                for (std::size_t i = 0; i < control.value.size(); ++i)
                    text += (i ? "," : "") + std::string(i == at ? value : "1");
                Diagnostics diagnostics;
                EXPECT_FALSE(set_control(fresh.controls, fresh.scene, text, diagnostics)) << text;
                EXPECT_TRUE(diagnostics.has_errors()) << text;
                EXPECT_EQ(values_of(fresh.controls), values_of(all.controls)) << text;
            }
        }
    // What is finite as a double and not as a float is refused where it would become infinite.
    for (const char* name : {"uEta", "uDouble"}) {
        fuzz::Settable fresh;
        Diagnostics diagnostics;
        EXPECT_EQ(set_control(fresh.controls, fresh.scene, std::string(name) + "=1e39", diagnostics),
                  name == std::string("uDouble"));
    }
}

// The oracle is one: what it is to find, it finds.
TEST(SetCorpus, TheOracleFindsWhatIsWrong) {
    fuzz::Settable settable;
    Control control = settable.controls.items.front();
    EXPECT_EQ(fuzz::check_control(control), "");
    control.value[0] = std::nan("");
    EXPECT_NE(fuzz::check_control(control), "");
    control.value[0] = 1e39;
    EXPECT_NE(fuzz::check_control(control), "");
    control.value[0] = 1;
    control.min = 2;
    EXPECT_NE(fuzz::check_control(control), "");
}

}  // namespace
}  // namespace snell
