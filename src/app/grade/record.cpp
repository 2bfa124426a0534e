#include "src/app/grade/record.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <vector>

#include "parser/text/number.h"
#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/content/text_forms.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Calls `each` with the name and the value of every field, in the order of the file.
void each_field(auto& record, const auto& each) {
    each("key", record.key);
    each("submission", record.submission);
    each("scene", record.scene);
    each("problem", record.problem);
    each("notes", record.notes);
    each("messages", record.messages);
    each("errors", record.errors);
    each("warnings", record.warnings);
    each("milliseconds", record.milliseconds);
    each("items", record.items);
    each("drawn", record.drawn);
    each("covered", record.covered);
    each("shaped", record.shaped);
    each("maps", record.maps);
    each("prints", record.prints);
    each("texts", record.texts);
}

}  // namespace

void to_json(Json& json, const Judged& item) {
    json = {{"points", item.points}, {"passed", item.passed}, {"why", item.why}};
}
void from_json(const Json& json, Judged& item) { item = {json.at("points"), json.at("passed"), json.at("why")}; }

void to_json(Json& json, const SourceText& text) { json = {{"name", text.name}, {"text", text.text}}; }
void from_json(const Json& json, SourceText& text) { text = {json.at("name"), json.at("text")}; }

// A compact list, because there are thousands: the hash as text, which JSON's numbers could not hold.
void to_json(Json& json, const Print& print) {
    json = Json::array({std::to_string(print.hash), print.text, print.first, print.last});
}
void from_json(const Json& json, Print& print) {
    const auto& hash = json.at(0).get_ref<const std::string&>();
    print = {read_whole<std::uint64_t>(hash).value_or(0), json.at(1), json.at(2), json.at(3)};
}

double Record::points() const {
    double sum = 0;
    for (const Judged& item : items) sum += item.points;
    return std::max(0., sum);
}

Record unjudged(const Rubric& rubric, const std::string& why) {
    Record record;
    record.problem = why;
    record.items.assign(rubric.items.size(), {0, false, "not judged: " + why});
    record.drawn.resize(rubric.pictures.size());
    record.covered.resize(rubric.pictures.size());
    record.shaped.resize(rubric.pictures.size());
    record.maps.resize(rubric.maps);
    return record;
}

std::string record_file(const std::string& folder) { return (fs::path(folder) / "result.json").string(); }

std::string write_record(const std::string& folder, const Record& record) {
    Json json{{"schema", 1}};
    each_field(record, [&json](const char* name, const auto& value) { json[name] = value; });
    return content::replace_file(record_file(folder), content::json_text(json) + '\n');
}

namespace {

// Null if there is none.
Json record_in(const std::string& folder) {
    std::error_code error;
    const std::string file = record_file(folder);
    if (!fs::is_regular_file(file, error)) return {};
    Json json = content::parse_json(content::whole_file(file));
    return json.is_object() && json.contains("schema") && json.contains("key") ? json : Json{};
}

}  // namespace

Record read_record(const std::string& folder, const Rubric& rubric) {
    const Json json = record_in(folder);
    if (json.is_null()) return {};
    try {
        Record record;
        each_field(record, [&json](const char* name, auto& value) { json.at(name).get_to(value); });
        const bool fits = record.items.size() == rubric.items.size() && record.drawn.size() == rubric.pictures.size() &&
                          record.covered.size() == record.drawn.size() && record.shaped.size() == record.drawn.size() &&
                          record.maps.size() == rubric.maps;
        for (const Print& print : record.prints)
            if (print.text >= record.texts.size()) return {};
        return fits ? record : Record{};
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

namespace {

constexpr std::string_view lock_name = ".lock";

// The record of a submission or the reference, and its pictures.
bool is_made_by_judging(const std::string& name) {
    if (name == "result.json") return true;
    const std::size_t dash = name.find('-'), dot = name.rfind('.');
    const std::string kind = name.substr(0, dash);
    if (dash == name.npos || dot == name.npos || dot <= dash + 1 || name.substr(dot) != ".png") return false;
    return (kind == "picture" || kind == "reference" || kind == "map") &&
           std::all_of(name.begin() + static_cast<std::ptrdiff_t>(dash) + 1,
                       name.begin() + static_cast<std::ptrdiff_t>(dot), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_report_page(const fs::path& page) {
    std::error_code error;
    if (!fs::is_regular_file(page, error)) return false;
    std::string head(1024, ' ');
    std::ifstream(page, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
    return head.find("content=\"snell grade\"") != std::string::npos;
}

// A run that was killed has removed the record before it writes another, but not the page.
bool is_of_a_submission(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(folder, error))) return false;
    if (!record_in(folder.string()).is_null()) return true;
    return is_report_page(folder / "index.html");
}

std::vector<fs::path> entries(const fs::path& folder) {
    std::vector<fs::path> paths;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        paths.push_back(entry->path());
    return paths;
}

}  // namespace

FolderLock lock_folder(const std::string& output) {
    const FolderLock lock(new int(open((fs::path(output) / lock_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)),
                          [](const int* file) {
                              if (*file >= 0) close(*file);
                              delete file;
                          });
    // The processes of a run that was killed end a moment after it.
    for (int tries = 0; *lock >= 0 && flock(*lock, LOCK_EX | LOCK_NB) != 0; ++tries) {
        if (errno == EINTR) continue;
        if (errno != EWOULDBLOCK) break;
        if (tries >= 20) return nullptr;
        usleep(50'000);
    }
    return lock;
}

bool may_hold_report(const std::string& output) {
    std::error_code error;
    if (!fs::exists(output, error) || fs::is_empty(output, error)) return true;
    const fs::path page = fs::path(output) / "index.html";
    // A run that was killed has left no page, but made the lock before anything else.
    return fs::exists(page, error) ? is_report_page(page) : fs::is_regular_file(fs::path(output) / lock_name, error);
}

bool is_report(const std::string& folder) {
    std::error_code error;
    return fs::is_regular_file(fs::path(folder) / lock_name, error) && may_hold_report(folder);
}

void remove_judged(const std::string& folder) {
    std::error_code error;
    for (const fs::path& file : entries(folder))
        if (is_made_by_judging(file.filename().string())) fs::remove(file, error);
}

std::string submission_in(const std::string& folder) {
    const Json json = record_in(folder);
    return json.is_object() && json.contains("submission") && json["submission"].is_string() ? json["submission"] : "";
}

void remove_pairs(const std::string& output) {
    std::error_code error;
    const fs::path folder = fs::path(output) / "similar";
    for (const fs::path& page : entries(folder))
        if (is_report_page(page)) fs::remove(page, error);
    fs::remove(folder, error);  // if it is empty
}

void remove_former_students(const std::string& output, const std::set<std::string>& folders) {
    std::error_code error;
    for (const fs::path& folder : entries(fs::path(output) / "students")) {
        if (folders.contains(folder.filename().string()) || !is_of_a_submission(folder)) continue;
        remove_judged(folder.string());
        fs::remove(folder / "index.html", error);
        fs::remove(folder, error);  // if it is empty
    }
}

}  // namespace snell::app
