#include "src/app/picture/outputs.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <unordered_map>

#include "parser/text/ranges.h"
#include "src/app/open/complain.h"
#include "src/content/replace.h"
#include "src/document/document.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

// Gives each file one name, following links as replace_file() does. Folders are cached, as many pictures share them.
class Places {
public:
    std::string of(const std::string& file) {
        std::error_code error;
        const fs::path path = content::without_links(file);
        const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
        const auto [found, is_new] = folders_.try_emplace(folder);
        if (is_new) found->second = fs::weakly_canonical(fs::absolute(folder, error), error);
        return (found->second / path.filename()).lexically_normal().string();
    }

private:
    std::unordered_map<std::string, fs::path> folders_;
};

}  // namespace

bool replace_a_file(std::span<const std::string> outputs) {
    return ranges::any_of(outputs, [](const std::string& file) {
        std::error_code error;
        return !file.empty() && !content::is_stream(file) && fs::is_regular_file(file, error);
    });
}

std::vector<std::string> read_by(std::span<const std::string> scenes, std::span<const std::string> outputs,
                                 const Access& access, bool grade) {
    std::vector<std::string> read(scenes.begin(), scenes.end());
    if (!replace_a_file(outputs)) return read;
    for (const std::string& scene : scenes)
        for (std::string& file : files_read_by(scene, access_to(scene, access, grade))) read.push_back(std::move(file));
    return read;
}

bool distinct_outputs(std::span<const std::string> outputs, std::span<const std::string> read) {
    Places places;
    std::unordered_map<std::string, const std::string*> taken;
    for (const std::string& file : read) taken.emplace(places.of(file), nullptr);
    bool distinct = true;
    for (const std::string& file : outputs) {
        if (file.empty() || content::is_stream(file)) continue;
        const auto [other, is_new] = taken.emplace(places.of(file), &file);
        if (is_new) continue;
        distinct = false;
        const std::string what = !other->second           ? "is read, and would be overwritten"
                                 : *other->second == file ? "would be two outputs"
                                                          : fmt::format("and '{}' would be one file", *other->second);
        complain(fmt::format("'{}' {}", file, what), "give each output a name of its own");
    }
    return distinct;
}

Exit check_outputs(std::span<const std::string> outputs, std::span<const std::string> read) {
    if (!distinct_outputs(outputs, read)) return exit_usage;
    Exit status = exit_fine;
    for (const std::string& file : outputs) {
        const std::string wrong = file.empty() ? "" : content::check_place(file);
        if (!wrong.empty() && !cannot_write(file, wrong)) status = exit_input;
    }
    return status;
}

}  // namespace snell::app
