#include "src/app/grade/idle_sliders.h"

#include <fmt/format.h>

#include "src/lint/lint.h"

namespace snell::app {

namespace {

bool tries_every_value(const snell::Control& slider) {
    return slider.type == ValueType::bool_ || slider.type == ValueType::int_ || slider.type == ValueType::uint_;
}

std::string tried_values(const snell::Control& slider) {
    if (slider.type == ValueType::bool_) return "for false and true";
    return fmt::format("for {} from {} to {}", tries_every_value(slider) ? "every value" : "all tried values",
                       slider.min, slider.max);
}

}  // namespace

void add_idle_sliders(Document& document, double seconds) {
    if (!document.runtime || document.diagnostics.has_errors()) return;
    const lint::RuleFacts& rule = lint::facts(lint::Rule::slider_without_effect);
    for (const snell::Control* slider : document.runtime->without_effect(seconds)) {
        const Program& program = document.scene().programs[slider->program];
        const std::string_view where = program.ladders > 0 ? "with these rungs, " : "";
        document.diagnostics.warning(rule.code, slider->span,
                                     fmt::format("'{}' {} no effect: {}program '{}' computes the same {}", slider->name,
                                                 tries_every_value(*slider) ? "has" : "seems to have", where,
                                                 program.name, tried_values(*slider)),
                                     fmt::format("{} ({})", rule.instead, lint::more(rule)));
    }
}

}  // namespace snell::app
