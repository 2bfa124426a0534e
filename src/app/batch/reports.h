// Reports a batch of pictures as JSON.
#pragma once

#include <string>

#include "src/app/batch/batch.h"

namespace snell::app {

// Prints why the file cannot be written, and returns false then.
bool write_json(const std::string& path, const nlohmann::ordered_json& json);

// Lists every picture with its values, file, size, hash and time.
nlohmann::ordered_json pictures_json(const Batch& batch, const RenderOptions& options, const Shots& shots, Shard shard);

}  // namespace snell::app
