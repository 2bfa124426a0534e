#include "src/app/desktop/kept_scenes.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/content/text_forms.h"

namespace snell {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// The file has the whole path.
std::string kept_file(const std::string& folder, const std::string& name) { return named_by(folder, name, "json"); }

std::vector<double> numbers_of(const Json& json, const char* name) {
    std::vector<double> numbers;
    const auto list = json.find(name);
    if (list == json.end() || !list->is_array()) return numbers;
    for (const Json& number : *list) {
        if (!number.is_number() || !std::isfinite(number.get<double>())) return {};
        numbers.push_back(number.get<double>());
    }
    return numbers;
}

std::string text_at(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

const Json& object_at(const Json& json, const char* name) {
    static const Json nothing = Json::object();
    const auto found = json.find(name);
    return found != json.end() && found->is_object() ? *found : nothing;
}

std::optional<RememberedValue> value_of(const Json& json) {
    if (!json.is_object()) return std::nullopt;
    const std::vector<double> ranges = numbers_of(json, "ranges");
    RememberedValue value{numbers_of(json, "value"), numbers_of(json, "initial")};
    if (value.value.empty() || value.initial.size() != value.value.size()) return std::nullopt;
    if (ranges.size() != 4 || ranges[0] > ranges[1] || ranges[2] > ranges[3]) return std::nullopt;
    std::tie(value.min, value.max) = std::pair(ranges[0], ranges[1]);
    std::tie(value.initial_min, value.initial_max) = std::pair(ranges[2], ranges[3]);
    return value;
}

Json json_of(const std::string& name, const KeptScene& kept) {
    Json json{{"scene", utf8::printable(name)}, {"view", kept.view}};
    if (kept.axes) json["axes"] = *kept.axes;
    for (const auto& [index, object] : kept.objects) json["objects"][std::to_string(index)] = object;
    for (const auto& [ladder, rung] : kept.set.rungs)
        json["rungs"][ladder] = {{"rung", rung.rung}, {"initial", rung.initial}};
    for (const auto& [control, value] : kept.set.values)
        json["values"][control] = {{"value", value.value},
                                   {"initial", value.initial},
                                   {"ranges", {value.min, value.max, value.initial_min, value.initial_max}}};
    return json;
}

// Other windows may remove files at the same time.
void remove_oldest(const std::string& folder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code gone;
        const fs::file_time_type time = entry->last_write_time(gone);
        if (!gone && entry->path().extension() == ".json") files.emplace_back(time, entry->path());
    }
    if (files.size() <= most_kept_scenes) return;
    ranges::sort(files);
    files.resize(files.size() - most_kept_scenes);
    for (const auto& [time, path] : files) fs::remove(path, error);
}

}  // namespace

std::string kept_folder(const std::string& settings) {
    return settings.empty() ? settings : (fs::path(settings).parent_path() / "scenes").string();
}

std::string kept_name(const std::string& scene) {
    std::error_code error;
    const fs::path whole = fs::canonical(scene, error);
    return error ? fs::absolute(scene, error).lexically_normal().string() : whole.string();
}

KeptScene read_kept(const std::string& folder, const std::string& scene) {
    KeptScene kept;
    if (folder.empty()) return kept;
    const std::string name = kept_name(scene), file = kept_file(folder, name);
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > most_kept_bytes || error) return kept;
    const Json json = content::parse_json(content::whole_file(file));
    if (!json.is_object() || text_at(json, "scene") != utf8::printable(name)) return kept;
    // An error is ignored: the file may only be removed earlier than others.
    fs::last_write_time(file, fs::file_time_type::clock::now(), error);
    kept.view = text_at(json, "view");
    if (const auto axes = json.find("axes"); axes != json.end() && axes->is_boolean()) kept.axes = axes->get<bool>();
    for (const auto& [index, object] : object_at(json, "objects").items()) {
        unsigned number = 0;
        const auto [end, wrong] = std::from_chars(index.data(), index.data() + index.size(), number);
        if (wrong == std::errc() && end == index.data() + index.size() && object.is_string())
            kept.objects[number] = object.get<std::string>();
    }
    for (const auto& [ladder, rung] : object_at(json, "rungs").items())
        if (rung.is_object()) kept.set.rungs[ladder] = {text_at(rung, "rung"), text_at(rung, "initial")};
    for (const auto& [control, value] : object_at(json, "values").items())
        if (auto found = value_of(value)) kept.set.values[control] = std::move(*found);
    return kept;
}

std::string write_kept(const std::string& folder, const std::string& scene, const KeptScene& kept) {
    if (folder.empty()) return {};
    const std::string name = kept_name(scene), file = kept_file(folder, name);
    std::error_code error;
    // A pipe would wait for a reader.
    if (fs::exists(file, error) && !fs::is_regular_file(file, error)) return file + " is not a file";
    const std::string text = content::json_text(json_of(name, kept)) + "\n";
    if (kept == KeptScene{} || text.size() > most_kept_bytes) {
        fs::remove(file, error);
        return {};
    }
    fs::create_directories(folder, error);
    const bool fresh = !fs::exists(file, error);
    std::string wrong = content::replace_file(file, text);
    if (fresh && wrong.empty()) remove_oldest(folder);
    return wrong;
}

std::string named_by(const std::string& folder, std::string_view path, std::string_view extension) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char byte : path) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
    return fmt::format("{}/{:016x}.{}", folder, hash, extension);
}

}  // namespace snell
