// What derives from the table of commands: the language reference and grammars for editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snell::docs {

struct Document {
    std::string path;  // relative to the repository
    std::string text;
};

// docs/variables.md.
std::string variables();

// The name of a variable as authors write it; empty for names that only the translator writes.
std::string written(std::string_view name);

// web/page/editor/words.json.
std::string page_words();

// editors/vscode/snippets.json.
std::string snippets();

// A string of JSON. The text has no control characters.
std::string json_text(std::string_view text);

// `intro` is the text before the commands.
std::vector<Document> generate(const std::string& intro);

}  // namespace snell::docs
