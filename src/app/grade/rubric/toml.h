// TOML as a tree whose parts know their places.
#pragma once

#include <optional>
#include <string>
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

}  // namespace snell::app
