// What the server says of itself when a connection begins.
#pragma once

#include "src/server/wire/json.h"

namespace snell::server {

// UTF-8 if the editor offers it, which costs nothing; otherwise UTF-16, which every editor knows.
Encoding chosen_encoding(const Json& offered);
Json capabilities(Encoding encoding);
// For client/registerCapability: files whose changes the editor shall report.
Json watched_files();

}  // namespace snell::server
