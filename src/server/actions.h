// Quick fixes: what diagnostics carry as `data`, as edits.
#pragma once

#include "src/server/wire/json.h"

namespace snell::server {

// The actions for those of `diagnostics`, as they were published, that touch the range of a textDocument/codeAction
// request.
Json code_actions(const Json& diagnostics, const Json& params);

}  // namespace snell::server
