#include "parser/text/report.h"

namespace snell {

Diagnostic& Report::add(Severity severity, std::string_view code, Span span, std::string message, std::string help) {
    if (!full())
        return diagnostics_.add({severity, std::string(code), span, std::move(message), std::move(help), {}, true});
    if (left_out_++ == 0) first_left_out_ = span;
    nowhere_ = {};
    return nowhere_;
}

Diagnostics Report::take() {
    diagnostics_.sort();
    if (left_out_ > 0)
        diagnostics_.error("too-many-diagnostics", first_left_out_,
                           "from here on " + std::to_string(left_out_) + " more diagnostics are left out",
                           "--limit diagnostics=N changes how many are kept");
    return std::move(diagnostics_);
}

}  // namespace snell
