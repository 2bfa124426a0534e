// Writes an image row by row, so that it never has to be in memory as a whole.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "src/content/image/image.h"

namespace snell::content {

class RowWriter {
public:
    // The format is that of the extension, as for write_image. Only size, channels and type of `shape` are used. After
    // an error, all calls return it and the file stays unchanged.
    RowWriter(const std::string& path, const Image& shape);
    ~RowWriter();
    RowWriter(const RowWriter&) = delete;
    RowWriter& operator=(const RowWriter&) = delete;

    // Appends whole rows, top first. Returns "" or the error.
    std::string add(std::span<const std::byte> rows);
    // Call it after the last row: the file appears in its place. Returns "" or the error.
    std::string finish();

private:
    struct File;
    std::unique_ptr<File> file_;
    std::string wrong_;
};

}  // namespace snell::content
