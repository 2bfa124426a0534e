#include "src/app/grade/record.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/content/text_forms.h"

namespace snell::app {

namespace {

using Json = nlohmann::ordered_json;

// A compact list, because there are thousands: the hash as text, which JSON's numbers could not hold.
Json prints_json(const std::vector<Print>& prints) {
    Json list = Json::array();
    for (const Print& print : prints)
        list.push_back(Json::array({std::to_string(print.hash), print.text, print.first, print.last}));
    return list;
}

Print read_print(const Json& json) {
    Print print{0, json.at(1), json.at(2), json.at(3)};
    const auto& text = json.at(0).get_ref<const std::string&>();
    std::from_chars(text.data(), text.data() + text.size(), print.hash);
    return print;
}

Json record_json(const Record& record) {
    Json json{{"schema", 1},
              {"key", record.key},
              {"submission", record.submission},
              {"scene", record.scene},
              {"problem", record.problem},
              {"notes", record.notes},
              {"messages", record.messages},
              {"errors", record.errors},
              {"warnings", record.warnings},
              {"milliseconds", record.milliseconds},
              {"items", Json::array()},
              {"drawn", record.drawn},
              {"covered", record.covered},
              {"shaped", record.shaped},
              {"maps", record.maps},
              {"prints", prints_json(record.prints)},
              {"texts", Json::array()}};
    for (const Judged& item : record.items)
        json["items"].push_back({{"points", item.points}, {"passed", item.passed}, {"why", item.why}});
    for (const SourceText& text : record.texts) json["texts"].push_back({{"name", text.name}, {"text", text.text}});
    return json;
}

Record from_json(const Json& json) {
    Record record;
    record.key = json.at("key");
    record.submission = json.at("submission");
    record.scene = json.at("scene");
    record.problem = json.at("problem");
    record.notes = json.at("notes").get<std::vector<std::string>>();
    record.messages = json.at("messages");
    record.errors = json.at("errors");
    record.warnings = json.at("warnings");
    record.milliseconds = json.at("milliseconds");
    record.drawn = json.at("drawn").get<std::vector<std::string>>();
    record.covered = json.at("covered").get<std::vector<double>>();
    record.shaped = json.at("shaped").get<std::vector<double>>();
    record.maps = json.at("maps").get<std::vector<std::string>>();
    for (const Json& item : json.at("items"))
        record.items.push_back({item.at("points"), item.at("passed"), item.at("why")});
    for (const Json& print : json.at("prints")) record.prints.push_back(read_print(print));
    for (const Json& text : json.at("texts")) record.texts.push_back({text.at("name"), text.at("text")});
    return record;
}

}  // namespace

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

std::string record_file(const std::string& folder) { return (std::filesystem::path(folder) / "result.json").string(); }

std::string write_record(const std::string& folder, const Record& record) {
    return content::replace_file(record_file(folder), content::json_text(record_json(record)) + '\n');
}

Record read_record(const std::string& folder, const Rubric& rubric) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(record_file(folder), error)) return {};
    try {
        Record record = from_json(content::parse_json(content::whole_file(record_file(folder))));
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

}  // namespace snell::app
