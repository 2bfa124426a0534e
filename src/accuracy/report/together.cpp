#include "src/accuracy/report/together.h"

#include <fmt/format.h>

#include "src/accuracy/report/report.h"

namespace snell::accuracy {

std::string wish_text(const Wish& wish) {
    std::string text;
    if (wish.error) text = fmt::format("RMSE of light at most {:.3g}", *wish.error);
    if (wish.milliseconds) text += fmt::format("{}at most {:.3g} ms", text.empty() ? "" : " and ", *wish.milliseconds);
    return text.empty() ? "whatever its error is" : text;
}

std::string residual_text(const SweepResult& sweep, const Wish& wish) {
    if (!wish.error || sweep.residual == 0) return "";
    return sweep.residual ? fmt::format(" and up to {:.2g} of the reference", *sweep.residual)
                          : " and an unknown part of the reference";
}

std::string time_text(const RungResult& rung) {
    return fmt::format("{:.3g} ms [{:.3g}, {:.3g}]", rung.milliseconds, rung.low, rung.high);
}

std::string cost_text(const RungResult& rung, const SweepResult& sweep) {
    return fmt::format("{} of {}, {} times what", time_text(rung), name(sweep.clock), ratio_text(rung.ratio));
}

std::string together_words(const Together& together) {
    const MixAdvice& advice = together.advice;
    const SweepResult& sweep = advice.sweep;
    const RungResult& rung = sweep.rungs[*advice.best];
    return fmt::format(
        "{}: of everything together {} '{}'\n  RMSE {:.3g}{}, at the worst of {} places; {} the scene takes{}",
        wish_text(together.wish),
        !advice.met                  ? "nothing that was measured is; the nearest is"
        : together.wish.milliseconds ? "the most exact is"
                                     : "the cheapest is",
        rung.name, rung.own.light.rmse, residual_text(sweep, together.wish), advice.places, cost_text(rung, sweep),
        advice.settled     ? ""
        : sweep.few_rounds ? "; there were too few rounds to be sure: more --budget or --reps tells"
                           : "; others may be better: more --budget tells");
}

}  // namespace snell::accuracy
