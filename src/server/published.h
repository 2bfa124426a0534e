// Diagnostics as editors take them: file by file.
#pragma once

#include <string>

#include "parser/text/diagnostic.h"
#include "src/server/documents.h"
#include "src/server/state.h"
#include "src/server/wire/lines.h"

namespace snell::server {

// An array of {uri, version, diagnostics}, one for each file of the sources; texts that are open have a version. What
// has no place is said of the beginning of `scene`.
Json published(const Diagnostics& diagnostics, const Sources& sources, const std::string& scene,
               const Documents& documents, const Services& services, Encoding encoding);

}  // namespace snell::server
