#include "src/app/page/page.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <utility>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/complain.h"
#include "src/app/open/headless.h"
#include "src/app/open/quality.h"
#include "src/app/open/warnings.h"
#include "src/app/page/scene_files.h"
#include "src/app/picture/outputs.h"
#include "src/content/files.h"
#include "src/content/table.h"
#include "src/content/text_forms.h"
#include "src/plan/identity.h"
#include "src/plan/plan.h"
#include "src/plan/setup.h"

namespace snell::app {

namespace {

std::optional<gl::Caps> current_caps(std::unique_ptr<HeadlessContext>& context, const std::string& request) {
    if (!context) context = headless_context(request);
    if (!context || !context->make_current()) return std::nullopt;
    return gl::query_caps();
}

}  // namespace

std::optional<gl::Caps> PageContexts::web() {
    const auto caps = current_caps(web_, "es3.0");
    return caps ? std::optional(web_caps(*caps)) : std::nullopt;
}

std::optional<gl::Caps> PageContexts::native() { return current_caps(native_, ""); }

gl::Caps web_caps(gl::Caps caps) {
    caps.version = "WebGL 2";
    gl::leave_stages(caps);
    caps.fp64 = caps.program_interface_query = false;
    caps.max_line_width = 1;
    return caps;
}

OpenedScene opened_scene(const std::string& scene, const Start& start, const gl::Caps& caps, const Access& access) {
    OpenedScene opened;
    Diagnostics problems;
    const auto choose = [&](const Scene& read, Rungs& rungs) {
        choose_rungs(scene, {start.quality, start.ladders, {}}, access, read, rungs, problems);
    };
    // A browser has nobody who ends a picture that takes too long.
    const auto planned = [](const Plan& plan, Document& read) { read.diagnostics.append(too_many_rounds(plan, read)); };
    opened.document = open_document(scene, caps, choose, planned, {}, access);
    Document& document = *opened.document;
    if (document.runtime) {
        document.controls.rungs = document.runtime->rungs();
        for (const std::string& set : start.sets) set_control(document.controls, document.scene(), set, problems);
    }
    parse_view(start.view, opened.view);
    problems.append(document.diagnostics);
    Diagnostics shown;
    for (const Diagnostic& diagnostic : problems.items())
        if (diagnostic.severity != Severity::note) shown.add(diagnostic);
    opened.text = snell::render(shown, document.sources);
    const Diagnostic* const error = first_error(problems);
    opened.fits = !error;
    if (error) opened.first_error = short_text(*error, document.sources);
    return opened;
}

std::string short_text(const Diagnostic& error, const Sources& sources) {
    if (!error.has_span) return utf8::printable(error.message);
    const Position at = sources.position(error.span.file, error.span.begin);
    const std::string name = std::filesystem::path(sources.name(error.span.file)).filename().string();
    return utf8::printable(fmt::format("{}:{}:{}: {}", name, at.line, at.column, error.message));
}

StartTexts start_texts(const Document& document, const View& view) {
    const Setup changed = changed_setup(document.scene(), document.controls);
    return {set_arguments(document.scene(), document.controls), arguments_of(changed, ladder_option), view_text(view)};
}

namespace {

using Json = nlohmann::ordered_json;

std::string title_for(const std::string& scene, const std::string& title) {
    return utf8::printable(title.empty() ? std::filesystem::path(scene).stem().string() : title);
}

// `texts`: what differs from the scene's text.
Json scene_json(const std::string& scene, const std::string& title, const std::string& link, const StartTexts& texts) {
    Json json{{"scene", scene}, {"title", title}, {"values", texts.values}, {"rungs", texts.rungs}};
    json["view"] = texts.view;
    json["link"] = link;
    return json;
}

std::vector<std::pair<std::string, std::size_t>> sizes_of(const std::vector<PackedFile>& files) {
    std::vector<std::pair<std::string, std::size_t>> sizes;
    for (const PackedFile& file : files)
        if (!file.decoded) sizes.emplace_back(file.name, file.bytes.size());
    return sizes;
}

// What a browser lacks is told apart from what is wrong everywhere.
Exit report_unfit(const PageOptions& options, PageContexts& contexts, const OpenedScene& in_page,
                  const Access& access) {
    const auto caps = contexts.native();
    if (!caps) return exit_graphics;
    const OpenedScene native = opened_scene(options.scene, options.start, *caps, access);
    fmt::print(stderr, "{}", native.fits ? in_page.text : native.text);
    if (!native.fits) return exit_input;
    return complain(exit_input,
                    fmt::format("a browser cannot draw '{}': it has WebGL 2, which lacks what the errors above name",
                                options.scene));
}

void list_files(const PageOptions& options, const PageParts& parts, std::size_t bytes) {
    const std::size_t all = std::accumulate(parts.files.begin(), parts.files.end(), std::size_t{0},
                                            [](std::size_t sum, const auto& file) { return sum + file.second; });
    fmt::print("{}: {}. It redistributes {} {} ({}):\n", utf8::printable(options.output), size_text(bytes),
               parts.files.size(), parts.files.size() == 1 ? "file" : "files", size_text(all));
    for (const auto& [name, size] : parts.files) fmt::print("{:>10}  {}\n", size_text(size), name);
}

// The list must not follow a page in standard output.
bool has_room_for_list(const std::string& output) {
    std::error_code error;
    return std::filesystem::is_regular_file(output, error) &&
           !std::filesystem::equivalent(output, "/dev/stdout", error);
}

// Returns nullopt after it printed why there are none; `status` is then the exit status.
std::optional<PageParts> parts_of_page(const PageOptions& options, const Access& access, Deadline& deadline,
                                       Exit& status) {
    PageContexts contexts;
    const auto caps = contexts.web();
    status = exit_graphics;
    if (!caps) return std::nullopt;
    OpenedScene opened = opened_scene(options.scene, options.start, *caps, access);
    status = exit_input;
    if (opened.document->runtime) {
        const Diagnostics unfit = unfit_statements(*opened.document);
        opened.fits = opened.fits && unfit.empty();
        opened.text += snell::render(unfit, opened.document->sources);
    }
    if (!opened.fits) {
        opened.document.reset();
        status = report_unfit(options, contexts, opened, access);
        return std::nullopt;
    }
    deadline.begin(fmt::format("compiling the rungs of '{}'", options.scene));
    opened.text += unfit_rungs(*opened.document);
    fmt::print(stderr, "{}", opened.text);
    return page_parts(options.scene, options.title, options.link, opened, access);
}

namespace fs = std::filesystem;

// Puts `text` in the place of `mark`, if it occurs once; sets `good` to false otherwise.
void put(std::string& page, std::string_view mark, std::string_view text, bool& good) {
    const std::size_t at = page.find(mark);
    if (at == page.npos || page.find(mark, at + mark.size()) != page.npos)
        good = false;
    else
        page.replace(at, mark.size(), text);
}

std::string element(std::string_view begin, std::string_view text) { return fmt::format("{}{}</script>", begin, text); }

constexpr std::string_view scene_begin = R"(<script type="application/json" id="scene">)";
constexpr std::string_view archive_begin = R"(<script type="text/plain" id="archive">)";
constexpr std::string_view runtime_begin = R"(<script type="text/plain" id="runtime">)";

}  // namespace

std::string size_text(std::uintmax_t bytes) {
    const auto number = static_cast<double>(bytes);
    if (bytes < 1000) return fmt::format("{} B", bytes);
    return number < 1e6 ? fmt::format("{:.0f} kB", number / 1e3) : fmt::format("{:.1f} MB", number / 1e6);
}

Diagnostics unfit_statements(const Document& document) {
    Diagnostics found;
    for (const Draw& draw : document.scene().draws)
        if (std::holds_alternative<ShpFile>(draw.shape))
            found.add_once({Severity::error,
                            "page-shape-file",
                            draw.span,
                            "a page cannot read ESRI shape files",
                            "an .obj file of the same lines can be in a page",
                            {},
                            true});
    return found;
}

std::string unfit_rungs(Document& document) {
    const Scene& scene = document.scene();
    const Rungs begin = document.runtime->rungs();
    std::string text;
    for (std::size_t ladder = 0; ladder < scene.ladders.size(); ++ladder)
        for (std::size_t rung = 0; rung < scene.ladders[ladder].rungs.size(); ++rung) {
            Rungs rungs = begin;
            if (std::exchange(rungs[ladder], rung) == rung) continue;
            document.runtime->choose(rungs);
            const Diagnostic* const error = first_error(document.runtime->ladder_problems());
            if (!error) continue;
            text += fmt::format("snell: warning: with {}={} a browser cannot draw the scene: {}\n",
                                scene.ladders[ladder].name, scene.ladders[ladder].rungs[rung],
                                short_text(*error, document.sources));
        }
    document.runtime->choose(begin);
    return text;
}

PageParts page_parts(const std::string& scene, const std::string& title, const std::string& link,
                     const OpenedScene& opened, const Access& access) {
    const SceneFiles files = scene_files(scene, access);
    PageParts parts{title_for(scene, title), {}, {}, sizes_of(files.files), files.error};
    if (!parts.error.empty()) return parts;
    parts.scene = script_json(scene_json(files.scene, parts.title, link, start_texts(*opened.document, opened.view)));
    parts.archive = content::base64(gzipped(archive(files.files)));
    return parts;
}

Exit make_page(const PageOptions& options) {
    std::string error;
    const std::string page = web_file("page.html", error);
    if (!error.empty()) return complain(exit_input, error);
    Deadline deadline(options.timeout);
    deadline.begin(fmt::format("reading '{}'", options.scene));
    const Access access = access_to(options.scene, options.access, options.grade);
    std::vector<std::string> read = files_read_by(options.scene, access);
    read.push_back(options.scene);
    if (const Exit wrong = check_outputs(std::vector{options.output}, read); wrong != exit_fine) return wrong;
    Exit status = exit_fine;
    const std::optional<PageParts> parts = parts_of_page(options, access, deadline, status);
    if (!parts) return status;
    if (!parts->error.empty()) return complain(exit_input, parts->error);
    deadline.begin("writing the page");
    const auto text = filled_page(page, {parts->title, parts->scene, parts->archive});
    if (!text)
        return complain(exit_input, "the browser's part of snell is of another version",
                        "'./dev web' in the folder of snell's sources builds it again");
    if (!write_output(options.output, *text)) return exit_input;
    if (has_room_for_list(options.output)) list_files(options, *parts, text->size());
    return exit_fine;
}

std::string web_file(const std::string& name, std::string& error) {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
    const bool installed = !fs::exists(program / "../CMakeCache.txt", none);
    fs::path folder = program / (installed ? "../share/snell/web" : "../../web");
    if (const char* own = std::getenv("SNELL_WEB"); own && *own) folder = own;
    const fs::path file = (folder / name).lexically_normal();
    if (fs::is_regular_file(file, none)) return content::whole_file(file.string());
    error = fmt::format(
        "the browser's part of snell is not there: there is no '{}'\n   help: './dev web' in the folder of snell's "
        "sources builds it, before snell is installed",
        utf8::printable(file.string()));
    return {};
}

std::string script_json(const nlohmann::ordered_json& json) {
    std::string safe;
    for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return safe;
}

std::optional<std::string> filled_page(std::string_view page, const PageData& data) {
    std::string text(page);
    bool good = true;
    put(text, "<title>snell</title>", fmt::format("<title>{}</title>", content::escaped(data.title)), good);
    put(text, element(scene_begin, "null"), element(scene_begin, data.scene), good);
    put(text, element(archive_begin, ""), element(archive_begin, data.archive), good);
    return good ? std::optional(std::move(text)) : std::nullopt;
}

bool is_gallery_page(std::string_view page) {
    const auto has = [page](std::string_view part) { return page.find(part) != page.npos; };
    return has(scene_begin) && has(archive_begin) && !has(runtime_begin);
}

}  // namespace snell::app
