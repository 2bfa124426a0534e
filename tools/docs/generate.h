// What derives from the table of commands: the language reference and grammars for editors.
#pragma once

#include <string>
#include <vector>

namespace snell::docs {

struct Document {
    std::string path;  // relative to the repository
    std::string text;
};

// `intro` is the text that stands before the commands.
std::vector<Document> generate(const std::string& intro);

}  // namespace snell::docs
