#include "src/ui/kit/text.h"

#include <iterator>

namespace snell::ui {

void Text::add_all(fmt::string_view format, fmt::format_args arguments) {
    fmt::vformat_to(std::back_inserter(buffer_), format, arguments);
}

}  // namespace snell::ui
