#include "src/server/state.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "parser/text/ranges.h"
#include "src/plan/locate.h"

namespace snell::server {

bool Document::is_scene() const { return language == "glib" || has_extension(path, "glib"); }

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

bool joins_halves(std::string_view text, std::size_t at) {
    return text.substr(0, at).ends_with(replacement) && text.substr(at).starts_with(replacement);
}

void reset(Scene& scene) {
    scene.project.reset();
    scene.check = scene.driver = true;
    scene.failed = false;
    scene.changed = Clock::now();
}

}  // namespace

void apply(Document& document, const std::vector<Change>& changes, Encoding encoding) {
    std::string& text = document.text;
    for (const Change& change : changes) {
        if (!change.range) {
            text = change.text;
            document.lost = false;
            document.halves = change.halves;
            continue;
        }
        document.halves = document.halves || change.halves;
        const Lines lines(text);
        const std::uint32_t begin = lines.offset(change.range->begin, encoding);
        const std::uint32_t end = std::max(begin, lines.offset(change.range->end, encoding));
        text.replace(begin, end - begin, change.text);
        document.lost =
            document.lost ||
            (document.halves && (joins_halves(text, begin) || joins_halves(text, begin + change.text.size())));
    }
}

int Documents::lose(const std::optional<std::string>& uri) {
    int count = 0;
    for (auto& [own, document] : all_)
        if (!uri || own == *uri) count += std::exchange(document.lost, true) ? 0 : 1;
    return count;
}

Document& Documents::open(Document document) {
    std::string uri = document.uri;
    return all_.insert_or_assign(std::move(uri), std::move(document)).first->second;
}

void Documents::close(std::string_view uri) {
    if (const auto found = all_.find(uri); found != all_.end()) all_.erase(found);
}

Document* Documents::find(std::string_view uri) {
    const auto found = all_.find(uri);
    return found == all_.end() ? nullptr : &found->second;
}

const Document* Documents::with_path(std::string_view path) const {
    const auto same = [&](const auto& entry) { return entry.second.path == path; };
    auto found = ranges::find_if(all_, same);
    if (found == all_.end() && !path.empty()) {
        const std::string real = real_path(std::string(path));
        found = ranges::find_if(all_, [&](const auto& entry) { return real_path(entry.second.path) == real; });
    }
    return found == all_.end() ? nullptr : &found->second;
}

Access Documents::access() const {
    std::map<std::string, std::string> texts;
    for (const auto& [uri, document] : all_)
        if (!document.lost) texts.insert_or_assign(real_path(document.path), document.text);
    return Access().with(std::move(texts));
}

std::string real_path(const std::string& path) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    return error ? path : real.string();
}

Scene& Workspace::open(const std::string& path, bool alone) {
    const auto found = ranges::find_if(scenes_, [&](const Scene& s) { return s.path == path && s.alone == alone; });
    if (found != scenes_.end()) return *found;
    return scenes_.emplace_front(Scene{path, alone});
}

const language::Project& Workspace::read(Scene& scene) {
    if (!scene.project)
        scene.project = scene.alone ? language::read_shader(scene.path, documents_.access(), language::Depth::plan)
                                    : language::read_project(scene.path, documents_.access(), language::Depth::plan);
    return *scene.project;
}

bool Workspace::has(Scene& scene, const Document& document) {
    return scene.alone ? scene.path == document.path : read(scene).file_of(document.path).has_value();
}

// By what is on disk: the texts that are open change with each key, and their own scenes come first.
const std::string& Workspace::scene_on_disk(const Document& document) {
    const auto [entry, added] = found_.try_emplace(document.path);
    if (added && document.path.starts_with('/')) entry->second = language::find_scene(document.path);
    return entry->second;
}

void Workspace::arrange() {
    if (std::exchange(arranged_, true)) return;
    std::set<const Scene*> used;
    const auto is_in_one = [&](const Document& document) {
        return ranges::any_of(scenes_, [&](Scene& s) { return !s.alone && used.contains(&s) && has(s, document); });
    };
    for (const auto& [uri, document] : documents_.all())
        if (document.is_scene()) used.insert(&open(document.path, false));
    std::vector<const Document*> others;
    for (const auto& [uri, document] : documents_.all())
        if (!document.is_scene() && !is_in_one(document)) others.push_back(&document);
    for (const Document* document : others)
        if (const std::string& path = scene_on_disk(*document); !path.empty())
            if (Scene& scene = open(path, false); has(scene, *document)) used.insert(&scene);
    for (const Document* document : others)
        if (!is_in_one(*document)) used.insert(&open(document->path, true));
    const std::size_t before = scenes_.size();
    scenes_.remove_if([&](const Scene& scene) { return !used.contains(&scene); });
    dropped_ = dropped_ || scenes_.size() < before;
}

Scene& Workspace::scene_of(const Document& document) {
    arrange();
    const auto own = [&](Scene& s) { return document.is_scene() ? s.path == document.path : has(s, document); };
    const auto last = std::find_if(scenes_.rbegin(), scenes_.rend(), own);
    scenes_.splice(scenes_.end(), scenes_, std::prev(last.base()));
    return scenes_.back();
}

const language::Project& Workspace::project_of(const Document& document) { return read(scene_of(document)); }

void Workspace::changed(const std::string& path) {
    arranged_ = false;
    if (!documents_.with_path(path)) found_.clear();
    for (Scene& scene : scenes_) {
        const bool own = scene.path == path;
        // A file that the scene lacks, or reads as data, may be this one: a name that was not found has no path.
        if (!own && scene.project && !scene.project->file_of(path) && documents_.with_path(path)) continue;
        reset(scene);
    }
}

void Workspace::rearranged() {
    arranged_ = false;
    found_.clear();
    for (Scene& scene : scenes_) reset(scene);
}

}  // namespace snell::server
