#include "src/app/page/gallery_index.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "src/app/page/html.h"
#include "src/content/json.h"
#include "src/content/table.h"
#include "src/content/uri.h"

namespace snell::app {

namespace {

// The colours have a contrast of at least 7 to 1, dark and light.
constexpr std::string_view index_style =
    R"(:root { color-scheme: light dark; --page: #fff; --text: #1b1f24; --edge: #8a929b; --error: #8c1414; }
@media (prefers-color-scheme: dark) { :root { --page: #14171a; --text: #e8eaed; --edge: #6b747d; --error: #ffb4ab; } }
body { margin: 0 auto; max-width: 70rem; padding: 1rem; background: var(--page); color: var(--text); font: 1rem/1.5 system-ui, sans-serif; }
ul { display: grid; grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); gap: 1rem; margin: 0; padding: 0; list-style: none; }
li { border: 1px solid var(--edge); border-radius: .5rem; padding: .5rem; overflow-wrap: anywhere; }
h2 { margin: .25rem 0; font-size: 1rem; }
img { display: block; width: 100%; height: 8rem; object-fit: contain; }
a { color: inherit; display: block; }
a:focus-visible { outline: 3px solid currentColor; outline-offset: 2px; }
p { margin: .25rem 0; font-size: .875rem; color: var(--error); }
)";

constexpr std::string_view made_by = "<meta name=\"generator\" content=\"snell\">";

constexpr std::string_view runtime_mark = "// All pages of this gallery share this file. snell made it.\n";

std::string gallery_item(const GalleryRow& row) {
    const std::string title = content::escaped(row.title);
    std::string shown;
    // The heading names the picture.
    if (!row.picture.empty()) shown = fmt::format("<img alt=\"Picture of {}\" src=\"{}\">", title, row.picture);
    const std::string heading = fmt::format("<h2>{}</h2>", title);
    if (row.error.empty())
        return fmt::format("<li><a href=\"{}\">{}{}</a></li>\n", content::escaped_address(row.page), shown, heading);
    return fmt::format("<li>{}{}<p>Not in the browser: {}</p></li>\n", shown, heading, content::escaped(row.error));
}

}  // namespace

std::string row_text(const GalleryRow& row) {
    return content::json_text(
        {{"title", row.title}, {"page", row.page}, {"picture", row.picture}, {"error", row.error}});
}

GalleryRow read_row(const std::string& text) {
    const nlohmann::ordered_json json = content::parse_json(text);
    if (!json.is_object()) return {};
    const auto member = [&json](const char* name) { return json.value(name, std::string()); };
    return {member("title"), member("page"), member("picture"), member("error")};
}

bool is_gallery_index(std::string_view page) { return page.find(made_by) != page.npos; }

std::string gallery_runtime(std::string_view script) { return fmt::format("{}{}", runtime_mark, script); }

bool is_gallery_runtime(std::string_view script) { return script.starts_with(runtime_mark); }

std::string gallery_index(const std::vector<GalleryRow>& rows) {
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
        "'sha256-{}'; base-uri 'none'; form-action 'none'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n{}\n<title>Scenes</title>\n"
        "<style>{}</style>\n</head>\n<body>\n<main>\n<h1>Scenes</h1>\n<ul>\n",
        policy_hash(index_style), made_by, index_style);
    for (const GalleryRow& row : rows) page += gallery_item(row);
    return page + "</ul>\n</main>\n</body>\n</html>\n";
}

}  // namespace snell::app
