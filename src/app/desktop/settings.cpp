#include "src/app/desktop/settings.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
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

using Json = nlohmann::ordered_json;

double number(const Json& json, const char* name, double otherwise, double least, double most) {
    const auto found = json.find(name);
    if (found == json.end() || !found->is_number()) return otherwise;
    const double value = found->get<double>();
    return std::isfinite(value) && value >= least && value <= most ? value : otherwise;
}

bool flag(const Json& json, const char* name, bool otherwise) {
    const auto found = json.find(name);
    return found != json.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

// Earlier versions wrote "dark": true or false.
ui::Theme theme(const Json& json) {
    const auto found = json.find("theme");
    if (found == json.end() || !found->is_string())
        return flag(json, "dark", false) ? ui::Theme::dark : ui::Theme::light;
    const auto name = ranges::find(ui::theme_names, found->get<std::string>());
    return name == ui::theme_names.end() ? ui::Theme::light : static_cast<ui::Theme>(name - ui::theme_names.begin());
}

std::vector<std::string> texts(const Json& json, const char* name, std::size_t most) {
    std::vector<std::string> found;
    const auto list = json.find(name);
    if (list == json.end() || !list->is_array()) return found;
    for (const Json& text : *list)
        if (text.is_string() && found.size() < most) found.push_back(text.get<std::string>());
    return found;
}

}  // namespace

std::string settings_file() { return own_place("XDG_STATE_HOME", "/.local/state", "/snell/window.json"); }

Settings read_settings(const std::string& file) {
    Settings settings;
    const Json json = content::parse_json(content::whole_file(file));
    if (!json.is_object()) return settings;
    settings.theme = theme(json);
    settings.panel = flag(json, "panel", settings.panel);
    settings.always_sharp = flag(json, "always_sharp", settings.always_sharp);
    settings.tools = flag(json, "tools", settings.tools);
    settings.zoom = number(json, "zoom", settings.zoom, .5, 3);
    settings.panel_width = number(json, "panel_width", settings.panel_width, 4, 200);
    settings.width = static_cast<int>(number(json, "width", 0, 200, 16384));
    settings.height = static_cast<int>(number(json, "height", 0, 150, 16384));
    settings.open = texts(json, "open", 100);
    settings.recent = texts(json, "recent", most_recent);
    if (const auto editor = json.find("editor"); editor != json.end() && editor->is_string())
        settings.editor = editor->get<std::string>();
    return settings;
}

std::string write_settings(const std::string& file, const Settings& settings) {
    if (file.empty()) return {};
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::path(file).parent_path(), error);
    std::vector<std::string> recent = settings.recent;
    for (const std::string& scene : read_settings(file).recent)
        if (ranges::find(recent, scene) == recent.end() && recent.size() < most_recent) recent.push_back(scene);
    const Json json{{"theme", ui::theme_names[static_cast<std::size_t>(settings.theme)]},
                    {"zoom", settings.zoom},
                    {"panel", settings.panel},
                    {"panel_width", settings.panel_width},
                    {"open", settings.open},
                    {"width", settings.width},
                    {"height", settings.height},
                    {"always_sharp", settings.always_sharp},
                    {"tools", settings.tools},
                    {"recent", recent},
                    {"editor", settings.editor}};
    return content::replace_file(file, content::json_text(json) + "\n");
}

std::string whole_path(const std::string& scene) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(scene, error);
    return error ? scene : whole.lexically_normal().string();
}

void remember(std::vector<std::string>& recent, const std::string& scene) {
    const std::string path = whole_path(scene);
    for (std::size_t at = 0; at < path.size();) {
        const utf8::Char next = utf8::decode(path, at);
        if (!next.valid) return;
        at += next.length;
    }
    std::erase(recent, path);
    recent.insert(recent.begin(), path);
    if (recent.size() > most_recent) recent.resize(most_recent);
}

void restore(const Settings& settings, const std::string& scene, ui::Memory& memory) {
    memory.theme = settings.theme;
    memory.zoom = static_cast<float>(settings.zoom);
    memory.panel = settings.panel;
    memory.always_sharp = settings.always_sharp;
    memory.hint = settings.panel ? 0 : ui::hint_seconds;
    // Another scene begins with its sliders.
    const bool same = !settings.recent.empty() && settings.recent[0] == whole_path(scene);
    memory.tab = settings.tools && same ? ui::Tab::tools : ui::Tab::controls;
    memory.panel_width = static_cast<float>(settings.panel_width);
    memory.open = ui::Titles(settings.open.begin(), settings.open.end());
}

void gather(const ui::Memory& memory, Settings& settings) {
    settings.theme = memory.theme;
    settings.zoom = std::round(memory.zoom * 1000) / 1000;
    settings.panel = memory.panel;
    settings.always_sharp = memory.always_sharp;
    settings.tools = memory.tab == ui::Tab::tools;
    settings.panel_width = std::round(memory.panel_width * 100) / 100;
    settings.open.assign(memory.open.begin(), memory.open.end());
}

void carry_looks(const ui::Memory& before, ui::Memory& memory) {
    memory.theme = before.theme;
    memory.zoom = before.zoom;
    memory.panel = before.panel;
    memory.always_sharp = before.always_sharp;
    memory.panel_width = before.panel_width;
    memory.open = before.open;
    memory.labels = before.labels;
    memory.scene = before.scene;
}

namespace {

namespace fs = std::filesystem;

// The file has the whole path.
std::string kept_file(const std::string& folder, const std::string& name) { return named_by(folder, name, "txt"); }

// Its own first line, what was chosen, an empty line, and what the text said.
std::string text_of(const std::string& name, const Remembered& kept) {
    return fmt::format("scene {}\n{}\n{}", utf8::printable(name), setup_text(kept.chosen), setup_text(kept.written));
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

Remembered read_kept(const std::string& folder, const std::string& scene) {
    if (folder.empty()) return {};
    const std::string name = kept_name(scene), file = kept_file(folder, name);
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > most_kept_bytes || error) return {};
    const std::string text = content::whole_file(file), begin = fmt::format("scene {}\n", utf8::printable(name));
    const std::size_t middle = text.find("\n\n", begin.size() - 1);
    if (!text.starts_with(begin) || middle == text.npos) return {};
    // An error is ignored: the file may only be removed earlier than others.
    fs::last_write_time(file, fs::file_time_type::clock::now(), error);
    return {read_setup(std::string_view(text).substr(0, middle)), read_setup(std::string_view(text).substr(middle))};
}

std::string write_kept(const std::string& folder, const std::string& scene, const Remembered& kept) {
    if (folder.empty()) return {};
    const std::string name = kept_name(scene), file = kept_file(folder, name);
    std::error_code error;
    // A pipe would wait for a reader.
    if (fs::exists(file, error) && !fs::is_regular_file(file, error)) return file + " is not a file";
    const std::string text = text_of(name, kept);
    if (kept == Remembered{} || text.size() > most_kept_bytes) {
        fs::remove(file, error);
        return {};
    }
    fs::create_directories(folder, error);
    const bool fresh = !fs::exists(file, error);
    std::string wrong = content::replace_file(file, text);
    if (fresh && wrong.empty()) remove_oldest(folder, ".txt", most_kept_scenes);
    return wrong;
}

std::string own_place(const char* variable, const std::string& at_home, const std::string& name) {
    const char* folder = std::getenv(variable);
    if (folder && *folder == '/') return std::string(folder) + name;
    const char* home = std::getenv("HOME");
    return home && *home == '/' ? home + at_home + name : std::string();
}

void remove_oldest(const std::string& folder, std::string_view extension, std::size_t most) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code gone;  // other windows may remove files at the same time
        const fs::file_time_type time = entry->last_write_time(gone);
        if (!gone && entry->path().extension() == extension) files.emplace_back(time, entry->path());
    }
    if (files.size() <= most) return;
    ranges::sort(files);
    files.resize(files.size() - most);
    for (const auto& [time, path] : files) fs::remove(path, error);
}

std::string named_by(const std::string& folder, std::string_view path, std::string_view extension) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char byte : path) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
    return fmt::format("{}/{:016x}.{}", folder, hash, extension);
}

}  // namespace snell
