#include "src/app/page/encode.h"

#include <stdlib.h>

#include <filesystem>

#include "src/content/files.h"
#include "src/content/replace.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

// OpenImageIO's writers need a file.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code error;
        std::string name = (fs::temp_directory_path(error) / "snell-page-XXXXXX").string();
        if (mkdtemp(name.data())) path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code error;
        if (!path_.empty()) fs::remove_all(path_, error);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }  // empty if there is none

private:
    std::string path_;
};

}  // namespace

EncodedPicture encoded(const content::Image& picture) {
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/picture.webp";
    if (folder.path().empty() || !content::write_image(file, picture).empty()) return {content::encode_png(picture)};
    return {content::whole_file(file), "webp"};
}

}  // namespace snell::app
