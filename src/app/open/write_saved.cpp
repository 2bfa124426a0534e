#include "src/app/open/write_saved.h"

#include <fmt/format.h>

#include "src/content/replace.h"
#include "src/content/whole_file.h"

namespace snell {

namespace {

// Replaces `now` by `next` in all files or in none.
std::string exchange(const std::vector<SavedFile>& files, std::string SavedFile::*now, std::string SavedFile::*next) {
    for (const SavedFile& file : files)
        if (content::whole_file(file.path) != file.*now)
            return file.path + " was changed meanwhile: it is left as it is";
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::string error = content::rewrite_file(files[i].path, files[i].*next);
        if (error.empty()) continue;
        if (!error.starts_with(files[i].path)) error = files[i].path + ": " + error;
        while (i-- > 0)
            if (!content::rewrite_file(files[i].path, files[i].*now).empty())
                error += fmt::format("; {} could not get its previous text back", files[i].path);
        return error;
    }
    return {};
}

}  // namespace

std::string write_saved(const std::vector<SavedFile>& files) {
    return exchange(files, &SavedFile::before, &SavedFile::after);
}

std::string revert_saved(const std::vector<SavedFile>& files) {
    return exchange(files, &SavedFile::after, &SavedFile::before);
}

}  // namespace snell
