// Texts that an editor gives in place of files, because they were not saved yet.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "src/plan/files.h"

namespace snell {

// Such a text holds until its file is saved.
class GivenTexts {
public:
    explicit GivenTexts(const Access& access);

    // Removes the texts of `access` whose files were saved, and those that say what their files say.
    void remove_saved(Access& access) const;

private:
    std::map<std::string, std::filesystem::file_time_type> given_;  // by path, when its file was written last
};

}  // namespace snell
