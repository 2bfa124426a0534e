// Pages that need nothing but themselves: one head, one style and one policy.
#pragma once

#include <string>
#include <string_view>

namespace snell::content {

struct HtmlPage {
    std::string title, body;            // as text; as HTML
    std::string_view style;             // besides that of all pages
    std::string_view script;            // no other one may run
    std::string_view images = "data:";  // where they may be from, as a policy says it
    std::string_view made_by = "snell";
};

std::string html_page(const HtmlPage& page);

// SHA-256 (FIPS 180-4), formatted as by sha256sum.
std::string sha256(std::string_view bytes);
// Of a script or style, as a Content-Security-Policy names it: SHA-256 in base64.
std::string policy_hash(std::string_view text);

}  // namespace snell::content
