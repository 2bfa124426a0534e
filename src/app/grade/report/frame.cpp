#include "src/app/grade/report/frame.h"

#include <fmt/format.h>

#include "parser/text/utf8.h"
#include "src/app/page/html.h"
#include "src/content/table.h"

namespace snell::app {

namespace {

// The colours have a contrast of at least 4.5 to 1, dark and light.
constexpr std::string_view style =
    R"(:root { color-scheme: light dark; --page: #fff; --text: #1b1f24; --quiet: #57606a; --edge: #d0d7de; --head: #f3f5f7; --full: #d8f3dc; --part: #fff0c2; --none: #ffd9d6; --link: #0550ae; }
@media (prefers-color-scheme: dark) { :root { --page: #14171a; --text: #e8eaed; --quiet: #a9b1ba; --edge: #3d444d; --head: #20252b; --full: #143d20; --part: #4a3a08; --none: #551d1a; --link: #79b8ff; } }
body { margin: 0 auto; max-width: 90rem; padding: 1rem; background: var(--page); color: var(--text); font: 1rem/1.5 system-ui, sans-serif; }
a { color: var(--link); }
h1 { font-size: 1.5rem; margin: .5rem 0; } h2 { font-size: 1.125rem; margin: 1.5rem 0 .5rem; }
p { margin: .5rem 0; max-width: 60rem; } .quiet { color: var(--quiet); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; } th, td { border: 1px solid var(--edge); padding: .25rem .5rem; text-align: left; vertical-align: top; overflow-wrap: break-word; max-width: 40rem; }
th { background: var(--head); } td.number, th.number { text-align: right; } td.number { white-space: nowrap; } .number { min-width: 4rem; max-width: 9rem; }
th button { all: unset; cursor: pointer; font-weight: bold; } th button:focus-visible { outline: 2px solid currentColor; outline-offset: 2px; }
th[aria-sort=ascending] button::after { content: " \2191"; } th[aria-sort=descending] button::after { content: " \2193"; }
.full { background: var(--full); } .part { background: var(--part); } .none { background: var(--none); }
img { display: block; max-width: 100%; height: auto; } td img { width: 5rem; max-width: none; } td a { display: inline-block; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; margin: .5rem 0; } figure { margin: 0; } figcaption { font-size: .875rem; color: var(--quiet); }
.over { position: relative; } .over img + img { position: absolute; inset: 0; clip-path: inset(0 0 0 50%); } input[type=range] { width: 100%; margin: .25rem 0; }
pre { overflow-x: auto; border: 1px solid var(--edge); background: var(--head); padding: .5rem; font: .8125rem/1.4 ui-monospace, monospace; margin: 0; }
.sides { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; } .sides > div { min-width: 0; } mark { background: var(--part); color: inherit; display: block; }
)";

}  // namespace

std::string shown_text(std::string_view text) {
    std::string shown;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line;
        for (const char c : text.substr(at, end - at)) line += c == '\t' ? std::string(4, ' ') : std::string(1, c);
        if (line.ends_with('\r')) line.pop_back();
        shown += content::escaped(utf8::printable(line));
        if (end < text.size()) shown += '\n';
        at = end + 1;
    }
    return shown;
}

std::string page_frame(std::string_view title, std::string_view body, std::string_view script) {
    const std::string allowed = script.empty() ? "" : fmt::format("; script-src 'sha256-{}'", policy_hash(script));
    const std::string element = script.empty() ? "" : fmt::format("<script>{}</script>\n", script);
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-{}'; img-src "
        "'self' file:{}\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"generator\" content=\"snell grade\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}"
        "{}</body>\n</html>\n",
        policy_hash(style), allowed, shown_text(title), style, body, element);
}

std::string_view class_of(double points, double of) { return points >= of ? "full" : points > 0 ? "part" : "none"; }

}  // namespace snell::app
