#include "src/app/grade/relations.h"

#include <fmt/format.h>

#include <algorithm>

namespace snell::app {

namespace {

using accuracy::Picture;
using accuracy::PictureDifference;

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

Judged light(const RubricItem& item, const Picture& picture, const Picture& other) {
    const double now = accuracy::mean_light(picture), before = accuracy::mean_light(other);
    const bool darker = item.expect == Expect::darker;
    Judged judged;
    judged.passed =
        darker ? now <= before * (1 - item.by) && now < before : now >= before * (1 + item.by) && now > before;
    const double change = before > 0 ? now / before - 1 : 0;
    judged.why = fmt::format("its mean light is {:.4g}, against {:.4g}", now, before);
    if (before > 0 && now != before)
        judged.why += fmt::format(": {} {}", percent(std::abs(change)), change < 0 ? "less" : "more");
    if (!judged.passed)
        judged.why += fmt::format("; expected: at least {} {}", percent(item.by), darker ? "less" : "more");
    return judged;
}

Judged changed(const RubricItem& item, double share, double covered) {
    Judged judged;
    const bool same = item.expect != Expect::different;
    if (!same && covered > 0) share = std::min(1., share / covered);
    judged.passed = same ? share <= item.by : share >= item.by && share > 0;
    judged.why = fmt::format("{} of the pixels{} differ", percent(share), same ? "" : " that are drawn on");
    if (!judged.passed) judged.why += fmt::format("; expected: at {} {}", same ? "most" : "least", percent(item.by));
    return judged;
}

void hold(Judged& judged, std::string_view what, double value, const std::optional<double>& limit,
          std::string_view unit) {
    if (!limit) return;
    const bool good = value <= *limit;
    judged.passed = judged.passed && good;
    judged.why += fmt::format("{}{} {:.4g}{}, at most {:.4g}{}{}", judged.why.empty() ? "" : "; ", what, value, unit,
                              *limit, unit, good ? "" : " allowed");
}

Judged near_reference(const RubricItem& item, const PictureDifference& difference) {
    Judged judged{0, true, {}};
    hold(judged, "RMSE", difference.error.display.rmse, item.max_rmse, "");
    hold(judged, "FLIP", difference.flip, item.max_flip, "");
    hold(judged, "different pixels", 100 * difference.share, item.max_pixels, " %");
    judged.why = "distance to the reference: " + judged.why;
    return judged;
}

}  // namespace

Judged judge_relation(const RubricItem& item, const Picture& picture, const Picture& other,
                      const PictureDifference& difference, double covered) {
    if (item.expect == Expect::reference) return near_reference(item, difference);
    const bool alike = item.expect == Expect::same || item.expect == Expect::mirrored;
    if (alike && accuracy::uniform(picture) && accuracy::uniform(other))
        return {0, false, "all pixels of both pictures have one colour, so that nothing is the same"};
    if (item.expect == Expect::darker || item.expect == Expect::brighter) return light(item, picture, other);
    return changed(item, difference.share, covered);
}

}  // namespace snell::app
