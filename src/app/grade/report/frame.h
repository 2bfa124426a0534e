// What all pages of a report share: style, policy, and how text of strangers is shown.
#pragma once

#include <string>
#include <string_view>

namespace snell::app {

// Text of strangers as HTML: nothing in it is an element or a hidden character. Lines stay.
std::string shown_text(std::string_view text);

// A whole page. Only its own style and `script` may run; nothing is loaded but pictures next to it.
std::string page_frame(std::string_view title, std::string_view body, std::string_view script = {});

// A class of CSS for a number of points: "full", "part" or "none".
std::string_view class_of(double points, double of);

}  // namespace snell::app
