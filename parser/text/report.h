// Collects the diagnostics of the parser's stages.
#pragma once

#include <string>
#include <string_view>

#include "parser/text/diagnostic.h"

namespace snell {

// Diagnostics with a limit, so that a text full of mistakes does not exhaust the memory.
class Report {
public:
    explicit Report(std::size_t limit) : limit_(limit) {}

    // Returns a reference through which notes can be added. Past the limit it refers to a dummy.
    Diagnostic& error(std::string_view code, Span span, std::string message, std::string help = {}) {
        return add(Severity::error, code, span, std::move(message), std::move(help));
    }
    Diagnostic& warning(std::string_view code, Span span, std::string message, std::string help = {}) {
        return add(Severity::warning, code, span, std::move(message), std::move(help));
    }
    bool full() const { return diagnostics_.items().size() >= limit_; }
    // Moves the diagnostics out, with an error about those that were left out.
    Diagnostics take();

private:
    Diagnostic& add(Severity severity, std::string_view code, Span span, std::string message, std::string help);

    std::size_t limit_;
    std::size_t left_out_ = 0;
    Span first_left_out_;
    Diagnostics diagnostics_;
    Diagnostic nowhere_;
};

}  // namespace snell
