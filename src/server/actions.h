// Quick fixes: what diagnostics carry as `data`, as edits.
#pragma once

#include <functional>

#include "src/server/state.h"
#include "src/server/wire/lines.h"

namespace snell::server {

// The actions for those of `diagnostics`, as they were published, that touch the range of a textDocument/codeAction
// request.
Json code_actions(const Json& diagnostics, const Json& params);

// Fixes are tried before they are offered.

// Takes the fixes away that do not make their diagnostic go, or that bring a new one as severe, by what `check` says of
// the texts with the fix. Fixes for which there was no time are taken away too.
void keep_good_fixes(Checked& checked, const Access& access, const std::function<Checked(const Access&)>& check);

}  // namespace snell::server
