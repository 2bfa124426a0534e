// `snell web`: scenes as pages.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "parser/text/utf8.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/complain.h"
#include "src/app/open/exit_status.h"
#include "src/app/page/gallery.h"
#include "src/app/page/page.h"
#include "src/content/replace.h"
#include "src/document/view_text.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

struct WebOptions {
    std::vector<std::string> names;  // the scene, or the folders of a gallery
    bool gallery = false;
    PageOptions page;
};

std::string check_start_view(const std::string& text) {
    View view;
    return parse_view(text, view);
}

// A link is opened by a click, so it must lead to a page, and not to a script.
std::string check_link(const std::string& text) {
    for (const std::string_view begin : {"https://", "http://"})
        if (text.starts_with(begin) && text.size() > begin.size()) return "";
    return "'" + text + "' does not begin with https:// or http://";
}

// Browsers show other files as text, and `-o x.glib` is a slip. Pipes and devices have the names that they have.
std::string check_page_name(const std::string& name) {
    if (has_extension(name, "html") || has_extension(name, "htm") || content::is_stream(name)) return "";
    const std::filesystem::path path(name);
    const std::string better =
        (has_extension(name, "glib") ? (path.parent_path() / path.stem()).string() : name) + ".html";
    return fmt::format("the name of a page ends with .html or .htm, but '{}' does not\n   help: -o '{}'",
                       utf8::printable(name), utf8::printable(better));
}

Exit web(const WebOptions& options) {
    const PageOptions& page = options.page;
    if (!options.gallery && options.names.size() > 1)
        return complain(exit_usage, "a page has one scene; --gallery takes folders");
    if (page.baked.size() > 2) return complain(exit_usage, "--baked takes at most two sliders");
    const Start& start = page.start;
    const bool one = !page.baked.empty() || !start.sets.empty() || !start.ladders.empty() || !start.view.empty() ||
                     !start.quality.empty() || !page.title.empty();
    if (options.gallery && one) return complain(exit_usage, "--gallery takes scenes as they are, without values");
    if (!size_fits(page.size, page.access.limits)) return exit_usage;
    if (options.gallery)
        return make_gallery({options.names, page.output, page.link, page.access, page.grade, page.timeout});
    if (const std::string wrong = check_page_name(page.output); !wrong.empty()) return complain(exit_usage, wrong);
    PageOptions single = page;
    single.scene = options.names.front();
    return make_page(single);
}

}  // namespace

Run add_web(CLI::App& command) {
    auto options = std::make_shared<WebOptions>();
    PageOptions& page = options->page;
    command.add_option("SCENE", options->names, "the scene, or with --gallery folders")->required();
    command.add_option("-o,--output", page.output, "the page, or with --gallery the folder of pages")
        ->required()
        ->check(check_file_name);
    command.add_flag("--gallery", options->gallery, "make a page of every scene in the folders, and an index of them");
    add_values(command, page.start.sets, page.start.ladders);
    add_quality(command, page.start.quality);
    command.add_option("--view", page.start.view, "turned and moved, as for `snell render`")->check(check_start_view);
    command.add_option("--title", page.title, "title of the page (default: the name of the scene)");
    command.add_option("--link", page.link, "address of the scene's text, to which the page links")->check(check_link);
    add_repeated(command, "--baked", page.baked,
                 "make a page of pictures over this slider instead; may be given twice");
    command.add_option("--steps", page.steps, "pictures along each baked slider (default: 24, or 9 by 9)")
        ->check(CLI::Range(2, static_cast<int>(most_baked)));
    add_size(command, page.size, "WIDTHxHEIGHT of baked pictures (default: the scene's)");
    command.add_option("--samples", page.samples, "samples per pixel of baked pictures")->check(CLI::Range(1, 64));
    command.add_flag("--lossless", page.lossless, "store baked pictures exactly, which takes five times as much");
    add_time(command, page.time);
    add_context(command, page.context);
    add_access(command, page.access);
    add_grade(command, page.grade);
    add_timeout(command, page.timeout, "reading a scene, or for a picture");
    return [options] { return web(*options); };
}

}  // namespace snell::app
