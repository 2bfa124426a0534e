// The answers of src/language as the protocol has them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/language/answers.h"
#include "src/language/project.h"
#include "src/server/state.h"

namespace snell::server {

// Encodes what is said of the texts of one project.
class Encoder {
public:
    Encoder(const State& state, const language::Project& project) : state_(state), project_(project) {}

    const Lines& lines(FileId file) const;
    Json range(const Span& span) const { return range_json(lines(span.file), span, state_.encoding); }
    // Empty: the text is not the user's, and there is nothing to open.
    std::string uri(FileId file) const;

    Json locations(const std::vector<Span>& spans) const;
    Json edits(const std::vector<Edit>& edits) const;           // of one text
    Json workspace_edit(const std::vector<Edit>& edits) const;  // of several
    Json completions(const std::vector<language::Completion>& items) const;
    Json hover(const language::Hover& hover) const;
    Json signatures(const language::SignatureHelp& help) const;
    // As texts, because there may be many.
    std::string symbols(const std::vector<language::Symbol>& symbols) const;
    std::string colors(const std::vector<language::Color>& colors) const;

private:
    void add_range(std::string& text, const Span& span) const;
    void add_symbols(std::string& text, const std::vector<language::Symbol>& symbols) const;

    const State& state_;
    const language::Project& project_;
    mutable std::map<FileId, Lines> lines_;
};

}  // namespace snell::server
