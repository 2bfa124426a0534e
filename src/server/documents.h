// The texts that an editor has open.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/plan/files.h"
#include "src/server/wire/lines.h"

namespace snell::server {

struct Document {
    std::string uri;   // as the editor writes it
    std::string path;  // on disk; of a text that was never written, its URI
    std::string language;
    std::int64_t version = 0;
    std::string text;
    // Somewhere in the text is half a character of UTF-16, read as U+FFFD. Two halves that come together would be one.
    bool halves = false;
    bool lost = false;  // a change could not be read: the editor has another text

    bool is_scene() const;
};

struct Change {
    struct Range {
        Place begin, end;
    };
    std::optional<Range> range;  // nullopt: the whole text
    std::string text;
    bool halves = false;  // as Document::halves
};

// Applies the changes in order: each counts in the text that the one before has left. A whole text finds a document
// again that was lost.
void apply(Document& document, const std::vector<Change>& changes, Encoding encoding);

class Documents {
public:
    Document& open(Document document);
    void close(std::string_view uri);
    Document* find(std::string_view uri);
    const Document* with_path(std::string_view path) const;
    const std::map<std::string, Document, std::less<>>& all() const { return all_; }
    // A change of the text `uri` could not be read; nullopt: of any of them. Returns how many are lost that were not.
    int lose(const std::optional<std::string>& uri);
    // What is read instead of files: the texts that are not lost.
    Access access() const;

private:
    std::map<std::string, Document, std::less<>> all_;  // by URI
};

// The path without links and "..", if it exists; otherwise the path.
std::string real_path(const std::string& path);

}  // namespace snell::server
