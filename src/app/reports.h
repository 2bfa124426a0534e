// What a batch of pictures was, as JSON.
#pragma once

#include <string>

#include "src/app/batch.h"

namespace snell::app {

// "", or why it can't be written.
std::string write_json(const std::string& path, const nlohmann::ordered_json& json);

// Every picture with its values, file, size, hash and time.
nlohmann::ordered_json pictures_json(const Batch& batch, const RenderOptions& options, const Shots& shots, Shard shard);

}  // namespace snell::app
