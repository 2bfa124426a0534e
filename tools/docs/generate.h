// What derives from the table of commands: the language reference and grammars for editors.
#pragma once

#include <string>
#include <vector>

namespace snell::docs {

struct Document {
    std::string path;  // relative to the repository
    std::string text;
};

// docs/variables.md.
std::string variables();

// `intro` is the text before the commands.
std::vector<Document> generate(const std::string& intro);

}  // namespace snell::docs
