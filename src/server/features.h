// Requests about texts.
// Quick fixes: what diagnostics carry as `data`, as edits.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "src/server/state.h"
#include "src/server/wire/messages.h"

namespace snell::server {

// Returns the result as JSON, nullopt if there is no such method. Throws a Failure, or nlohmann's exceptions for params
// of a wrong shape.
std::optional<std::string> feature(State& state, const std::string& method, const Json& params);

// Notifications: the texts that are open, and what changes on disk.

// What may have changed the text `uri`, or any text, could not be read: the user is told, and nothing is said of such a
// text, or answered about it, until the editor sends it whole.
void lose(State& state, const std::optional<std::string>& uri, const std::string& why);
// Unknown ones are passed over.
void notice(State& state, const std::string& method, const Json& params);

// The actions for those of `diagnostics`, as they were published, that touch the range of a textDocument/codeAction
// request.
Json code_actions(const Json& diagnostics, const Json& params);

// Fixes are tried before they are offered.

// Takes the fixes away that do not make their diagnostic go, or that bring a new one as severe, by what `check` says of
// the texts with the fix. Fixes for which there was no time are taken away too.
void keep_good_fixes(Checked& checked, const Access& access, const std::function<Checked(const Access&)>& check);

}  // namespace snell::server
