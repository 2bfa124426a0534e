#include "src/app/desktop/scene_pictures.h"

#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/desktop/folder.h"
#include "src/plan/locate.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

constexpr const char* size = "160x120";
constexpr int seconds = 20;  // of one picture

bool current(const std::string& picture, const std::string& scene) {
    std::error_code none, missing;
    const auto made = fs::last_write_time(picture, missing), written = fs::last_write_time(scene, none);
    return !missing && !none && made >= written;
}

// The scenes below the folder, by their paths; those in `only` of each folder in it, or all if it is empty.
std::vector<std::string> scenes_below(const fs::path& folder, std::string_view only) {
    std::vector<std::string> found;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        const bool wanted = only.empty() ? path.stem() == path.parent_path().filename()  // others are variants of it
                                         : path.parent_path().filename() == only;
        if (wanted && has_extension(path.string(), "glib")) found.push_back(path.string());
    }
    ranges::sort(found, [](const std::string& a, const std::string& b) { return before(a, b); });
    return found;
}

// The first error that the program tells, with its place, or else what it says first.
std::string reason(const content::Ended& ended) {
    if (ended.too_long) return fmt::format("it takes longer than {} s", seconds);
    const std::string_view all = ended.output;
    const std::size_t error = all.find("error:"), before = error == all.npos ? all.npos : all.rfind('\n', error);
    const std::string_view from = all.substr(before == all.npos ? 0 : before + 1);
    const std::string line = utf8::printable(from.substr(0, from.find('\n')));
    return line.empty() ? "it could not be drawn" : line;
}

}  // namespace

std::string own_program() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).string();
}

std::string_view ScenePictures::why(const std::string& scene) const {
    const auto found = tried_.find(scene);
    return found == tried_.end() ? std::string_view() : found->second;
}

std::string ScenePictures::look() {
    if (process_.running()) {
        const std::optional<content::Ended> ended = process_.poll();
        if (!ended) return {};
        std::string made = std::exchange(making_, {});
        if (!current(thumbnail_file(folder_, made), made)) tried_[made] = reason(*ended);
        return made;
    }
    const auto lacks = [this](const std::string& scene) {
        return !tried_.contains(scene) && !current(thumbnail_file(folder_, scene), scene);
    };
    const auto next = folder_.empty() ? wanted_.end() : ranges::find_if(wanted_, lacks);
    if (next == wanted_.end()) return {};
    making_ = *next;
    tried_[making_];
    std::error_code error;
    fs::create_directories(folder_, error);
    // In the background, behind what the user does.
    process_.start({"nice", "-n", "10", program_, "render", making_, "-o", thumbnail_file(folder_, making_), "--size",
                    size, "--samples", "4", "--timeout", std::to_string(seconds)},
                   {.seconds = 2. * seconds, .most_output = 1 << 16, .captured = true});
    return {};
}

SampleScenes sample_scenes() {
    const fs::path folder = fs::path(own_program()).parent_path();  // PREFIX/bin, or build/KIND/bin
    for (const auto& [scenes, lessons] :
         {std::pair{folder / "../share/snell/scenes", folder / "../share/doc/snell/docs/teaching"},
          std::pair{folder / "../../../scenes", folder / "../../../docs/teaching"}}) {
        if (!is_folder(scenes.string())) continue;
        return {scenes_below(scenes.lexically_normal(), ""), scenes_below(lessons.lexically_normal(), "handout")};
    }
    return {};
}

}  // namespace snell
