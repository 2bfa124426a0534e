#include "src/content/image/rows.h"

#include <array>
#include <optional>
#include <utility>

#include "src/content/image/formats.h"
#include "src/content/image/module.h"
#include "src/content/image/png_write.h"
#include "src/content/replace.h"

namespace snell::content {

namespace {

using Message = std::array<char, 1024>;

std::string said(const Message& message) {
    return message[0] ? message.data() : "cannot write the picture in this format";
}

}  // namespace

struct RowWriter::File {
    File(const std::string& path_, const Image& shape_) : path(path_), shape(shape_), place(path_) {}
    ~File() {
        Message message{};
        if (other) oiio_module().end(other, 0, message.data(), message.size());
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    // Both return "" or the whole error message.
    std::string begin();
    std::string begin_png();
    std::string add(std::span<const std::byte> rows);
    std::string end();

    std::string about(const std::string& why) const { return path + ": " + why; }
    // An error of the file system is more useful than libpng's message about it.
    std::string png_failed() {
        const std::string why = part->close();
        return about(why.empty() ? png->error() : why);
    }

    std::string path;
    Image shape;
    Replacement place;
    std::optional<PartFile> part;
    std::optional<PngEncoder> png;
    void* other = nullptr;  // the writer of the OpenImageIO module
    int rows = 0;           // number of rows written
};

std::string RowWriter::File::begin_png() {
    part.emplace(place.path());
    png.emplace([this](std::string_view bytes) { return part->write(bytes).empty(); });
    Image bytes = shape;
    bytes.type = PixelType::u8;
    return png->begin(bytes) ? "" : png_failed();
}

std::string RowWriter::File::begin() {
    if (std::string wrong = place.check(); !wrong.empty()) return wrong;
    if (writes_without_module(path)) return begin_png();
    const OiioModule& module = oiio_module();
    if (!module.error.empty()) return module.error + "; without it only PNG can be written";
    const SnellOiioShape what = module_shape(shape);
    Message message{};
    other = module.begin(place.path().c_str(), extension_of(path).c_str(), &what, message.data(), message.size());
    return other ? "" : about(said(message));
}

std::string RowWriter::File::add(std::span<const std::byte> pixels) {
    const auto count = static_cast<int>(pixels.size() / shape.row_bytes());
    if (count > shape.height - rows || static_cast<std::size_t>(count) * shape.row_bytes() != pixels.size())
        return about("wrong number of rows");
    rows += count;
    if (other) {
        Message message{};
        const int status = oiio_module().rows(other, pixels.data(), count, message.data(), message.size());
        return status == 0 ? "" : about(said(message));
    }
    bool good = false;
    if (shape.type == PixelType::u8) {
        good = png->rows(pixels.data(), static_cast<std::size_t>(count));
    } else {
        Image floats = shape;
        floats.height = count;
        floats.pixels.assign(pixels.begin(), pixels.end());
        good = png->rows(to_bytes(floats).pixels.data(), static_cast<std::size_t>(count));
    }
    return good ? "" : png_failed();
}

std::string RowWriter::File::end() {
    if (rows < shape.height) return about("some rows of the picture are missing");
    if (other) {
        Message message{};
        const int status = oiio_module().end(std::exchange(other, nullptr), 1, message.data(), message.size());
        if (status != 0) return about(said(message));
        // Some of OpenImageIO's writers (among them JPEG 2000's) may write nothing without reporting an error.
        std::error_code error;
        if (std::filesystem::file_size(place.path(), error) == 0) return about(said({}));
        return place.take_place();
    }
    if (!png->end()) return png_failed();
    const std::string why = part->close();
    return why.empty() ? place.take_place() : about(why);
}

RowWriter::RowWriter(const std::string& path, const Image& shape) {
    Image header;
    header.width = shape.width;
    header.height = shape.height;
    header.channels = shape.channels;
    header.type = shape.type;
    if (extension_of(path).empty())
        wrong_ = path + " has no extension; add one that sets the format, such as .png or .exr";
    else if (shape.width <= 0 || shape.height <= 0 || shape.channels < 1 || shape.channels > 4)
        wrong_ = "the picture is empty";
    if (!wrong_.empty()) return;
    file_ = std::make_unique<File>(path, header);
    wrong_ = file_->begin();
}

RowWriter::~RowWriter() = default;

std::string RowWriter::add(std::span<const std::byte> rows) {
    if (wrong_.empty()) wrong_ = file_->add(rows);
    return wrong_;
}

std::string RowWriter::finish() {
    if (wrong_.empty()) wrong_ = file_->end();
    file_.reset();
    return wrong_;
}

}  // namespace snell::content
