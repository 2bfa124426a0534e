// A picture that is written as its rows come, so that no memory need hold all of it.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "src/content/image.h"

namespace snell::content {

class RowWriter {
public:
    // By extension, as write_image does. Of `shape` only the size, the channels and the type matter. Whatever goes
    // wrong is said by all calls from then on, and the file stays as it was.
    RowWriter(const std::string& path, const Image& shape);
    ~RowWriter();
    RowWriter(const RowWriter&) = delete;
    RowWriter& operator=(const RowWriter&) = delete;

    // The next rows, top first, whole ones. "" or what went wrong.
    std::string add(std::span<const std::byte> rows);
    // When all rows are there: the file takes its place.
    std::string finish();

private:
    struct File;
    std::unique_ptr<File> file_;
    std::string wrong_;
};

}  // namespace snell::content
