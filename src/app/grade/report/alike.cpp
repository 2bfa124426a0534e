// Two submissions side by side, with what they have in common.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "parser/text/words.h"
#include "src/app/grade/report/frame.h"
#include "src/app/grade/report/report.h"
#include "src/content/walk.h"
#include "src/content/whole_file.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

// The text with the lines marked that fingerprints in common cover.
std::string marked(const Record& record, std::size_t text, const AlikePair& pair) {
    std::vector<bool> common;
    for (const Print& print : record.prints) {
        if (print.text != text || !std::binary_search(pair.hashes.begin(), pair.hashes.end(), print.hash)) continue;
        if (common.size() <= print.last) common.resize(print.last + 1);
        std::fill(common.begin() + print.first, common.begin() + print.last + 1, true);
    }
    std::string shown;
    std::size_t line = 1;
    for (const std::string_view part : split(record.texts[text].text, '\n')) {
        const std::string safe = shown_text(part);
        // Elements that begin lines of their own need no line ends.
        if (line < common.size() && common[line])
            shown += fmt::format("<mark>{}</mark>", safe.empty() ? " " : safe);
        else
            shown += safe + '\n';
        ++line;
    }
    return shown;
}

std::string side(const GradedSubmission& graded, const AlikePair& pair) {
    std::string text = fmt::format("<div><h2>{}</h2>\n", shown_text(graded.submission.name));
    for (std::size_t i = 0; i < graded.record.texts.size(); ++i)
        text += fmt::format("<h3>{}</h3>\n<pre>{}</pre>\n", shown_text(graded.record.texts[i].name),
                            marked(graded.record, i, pair));
    return text + "</div>\n";
}

}  // namespace

std::string alike_page(const Grades& grades, const AlikePair& pair) {
    const std::string title =
        fmt::format("{} and {}", grades.all[pair.a].submission.name, grades.all[pair.b].submission.name);
    return page_frame(
        title, fmt::format("<h1>{}</h1>\n<p>{:.0f} % of the shorter one's fingerprints are in the other one, too. "
                           "Marked lines hold them. This is a hint for a person to look at. <a "
                           "href=\"../index.html\">Results</a></p>\n<div class=\"sides\">{}{}</div>\n",
                           shown_text(title), 100 * pair.share, side(grades.all[pair.a], pair),
                           side(grades.all[pair.b], pair)));
}

std::set<std::uint64_t> handed_out(const Rubric& rubric) {
    std::set<std::uint64_t> hashes;
    std::error_code error;
    std::vector<fs::path> files;
    for (const std::string& path : rubric.templates) {
        if (fs::is_regular_file(path, error)) files.emplace_back(path);
        content::walk(path, [&files](const fs::path& entry, fs::file_status status, int) {
            if (fs::is_regular_file(status)) files.push_back(entry);
            return content::Walk::on;
        });
    }
    for (const fs::path& file : files) {
        if (!is_shader_name(file.native())) continue;
        Record record;
        add_prints(record, file.string(), content::whole_file(file.string()));
        for (const Print& print : record.prints) hashes.insert(print.hash);
    }
    return hashes;
}

}  // namespace snell::app
