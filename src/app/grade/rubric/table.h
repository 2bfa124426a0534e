// TOML as a tree whose parts know their places, and the keys of one table of it, each asked for by its name and kind.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"

namespace snell::app {

struct TomlValue {
    enum class Kind { text, number, truth, list, table, other };
    struct Member;

    Kind kind = Kind::other;
    std::string text;
    double number = 0;
    bool truth = false;
    std::vector<TomlValue> list;
    std::vector<Member> members;  // of a table, in the order of the text
    Span span;
};
struct TomlValue::Member {
    std::string name;
    Span span;  // of the name
    TomlValue value;
};

// Returns nullopt and reports an error at its place if the text is not TOML.
std::optional<TomlValue> read_toml(FileId file, const Sources& sources, Diagnostics& diagnostics);

// Which numbers a key takes.
struct Allowed {
    std::string_view words;  // such as "a number from 0"
    bool (*fits)(double number);
};
extern const Allowed from_0, above_0, seconds_above_0, from_0_to_1, below_1, below_100, samples_of_a_pixel;

// Reports values of a wrong kind, and, at the end, keys that were not asked for.
class RubricTable {
public:
    RubricTable(const TomlValue& table, Diagnostics& diagnostics) : table_(table), diagnostics_(diagnostics) {}

    // Returns null if there is no such key, or its value is not of that kind.
    const TomlValue* find(std::string_view name, std::optional<TomlValue::Kind> kind = std::nullopt);
    // These leave what they are given as it is if there is no such key, or its value does not fit.
    void read(std::string_view name, std::string& text);
    void read(std::string_view name, std::optional<double>& number, const Allowed& allowed);
    void read(std::string_view name, double& number, const Allowed& allowed);
    // A list of texts, or one text.
    std::vector<std::string> texts(std::string_view name);
    // Reports the keys that were not asked for.
    void done();

private:
    const TomlValue& table_;
    Diagnostics& diagnostics_;
    std::vector<std::string_view> known_;
};

// Reports an error about a value of a rubric.
void wrong_value(Diagnostics& diagnostics, Span span, std::string message, std::string help = {});
// Reports a name that is none of `names`, with the nearest of them.
void wrong_name(Diagnostics& diagnostics, Span span, std::string_view what, std::string_view name,
                const std::vector<std::string_view>& names);

// A text in quotes, as a rubric has it; what is hidden in it is escaped for people.
std::string toml_text(std::string_view text);

// A number as a scene's text has it, true or false, or a list of them with commas; nullopt for anything else.
std::optional<std::string> assigned_text(const TomlValue& value);

}  // namespace snell::app
