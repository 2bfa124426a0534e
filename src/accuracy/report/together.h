// What reports say of everything together: rungs of ladders, samples and found rungs.
#pragma once

#include <string>
#include <vector>

#include "src/accuracy/found/together.h"

namespace snell::accuracy {

// A combination of all kinds that was wished for.
struct Together {
    std::string scene;  // as the user gave it
    Wish wish;
    MixAdvice advice;                               // has a best one
    std::vector<std::vector<std::string>> choices;  // of each of its mixes: "A=x" for each ladder
};

// Such as "RMSE of light at most 0.1 and at most 16 ms".
std::string wish_text(const Wish& wish);
// What is added to an error when it is compared with a limit, such as " and up to 0.01 of the reference".
std::string residual_text(const SweepResult& sweep, const Wish& wish);
// What a rung takes, with the interval of the median; and its ratio to the current rung's.
std::string time_text(const RungResult& rung);
std::string cost_text(const RungResult& rung, const SweepResult& sweep);
// The answer, in two sentences.
std::string together_words(const Together& together);

}  // namespace snell::accuracy
