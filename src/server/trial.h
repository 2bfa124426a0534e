// Fixes are tried before they are offered.
#pragma once

#include <functional>

#include "src/server/services.h"

namespace snell::server {

// Takes the fixes away that do not make their diagnostic go, or that bring a new one as severe, by what `check` says of
// the texts with the fix. Fixes for which there was no time are taken away too.
void keep_good_fixes(Checked& checked, const Access& access, const std::function<Checked(const Access&)>& check);

}  // namespace snell::server
