#include "src/app/page/gallery.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <locale.h>
#include <stdlib.h>
#include <wctype.h>
#include <nlohmann/json.hpp>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/ending.h"
#include "src/app/page/page.h"
#include "src/app/picture/outputs.h"
#include "src/app/picture/picture.h"
#include "src/app/picture/sheet.h"
#include "src/content/files.h"
#include "src/content/html_page.h"
#include "src/content/image/module.h"
#include "src/content/process.h"
#include "src/content/replace.h"
#include "src/content/table.h"
#include "src/content/text_forms.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

struct EncodedPicture {
    std::string bytes;
    const char* extension = "png";  // "png" or "webp"
};

// OpenImageIO's writers need a file.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code error;
        std::string name = (fs::temp_directory_path(error) / "snell-page-XXXXXX").string();
        if (mkdtemp(name.data())) path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code error;
        if (!path_.empty()) fs::remove_all(path_, error);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }  // empty if there is none

private:
    std::string path_;
};

// Encodes as WebP, which takes a fifth of a PNG, or as PNG without OpenImageIO.
EncodedPicture encoded(const content::Image& picture) {
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/picture.webp";
    if (folder.path().empty() || !content::write_image(file, picture).empty()) return {content::encode_png(picture)};
    return {content::whole_file(file), "webp"};
}

// Sorted by name, so that the index does not depend on the file system.
bool find_scenes(const std::vector<std::string>& folders, std::vector<Exhibit>& exhibits) {
    std::set<fs::path> known;  // folders may be within each other
    for (const std::string& folder : folders) {
        std::error_code error;
        const std::size_t first = exhibits.size();
        fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
        if (error) return complain(fmt::format("cannot read the folder '{}': {}", folder, error.message()));
        for (; !error && entry != end; entry.increment(error)) {
            const fs::path& path = entry->path();
            if (!has_extension(path.native(), "glib") || !entry->is_regular_file(error)) continue;
            if (!known.insert(fs::weakly_canonical(path, error)).second) continue;
            exhibits.push_back({path.lexically_normal().string(), folder, {}, {}});
        }
        std::sort(exhibits.begin() + static_cast<std::ptrdiff_t>(first), exhibits.end(),
                  [](const Exhibit& a, const Exhibit& b) { return a.scene < b.scene; });
    }
    if (exhibits.empty()) return complain("there are no scenes in these folders");
    if (exhibits.size() > most_gallery_scenes)
        return complain(
            fmt::format("{} scenes are too many: a gallery takes {}", exhibits.size(), most_gallery_scenes));
    return true;
}

std::string small_picture(const OpenedScene& opened) {
    constexpr int side = 320;  // twice that of the thumbnail, which averages
    const auto [width, height] =
        std::pair(opened.document->scene().window_size[0], opened.document->scene().window_size[1]);
    const double scale = static_cast<double>(side) / std::max({width, height, 1});
    const int w = std::max(1, static_cast<int>(width * scale)), h = std::max(1, static_cast<int>(height * scale));
    Runtime& runtime = *opened.document->runtime;
    const gl::Target target = gl::make_target(w, h, 1, runtime.display_pixels());
    if (!target.framebuffer) return {};
    const Frame frame{0, opened.view, opened.document->controls};
    const content::Image picture =
        thumbnail(draw_picture(runtime, frame, target, {.width = w, .height = h}, {}), false);
    const EncodedPicture made = encoded(picture);
    return fmt::format("data:image/{};base64,{}", made.extension, content::base64(made.bytes));
}

// Makes the page of one scene and its row of the index, in a process of its own: scenes of a class may take forever,
// and some end the driver.
class PageOfGallery {
public:
    PageOfGallery(const GalleryOptions& options, const Exhibit& exhibit, const std::string& page)
        : options_(options),
          exhibit_(exhibit),
          page_(page),
          access_(access_to(exhibit.scene, options.access, options.grade)),
          row_{exhibit.title, {}, {}, {}} {}

    // Returns the exit status; the row is good with exit_fine.
    Exit make() {
        Deadline deadline(options_.timeout);
        deadline.begin(fmt::format("making the page of '{}'", exhibit_.scene));
        const auto caps = contexts_.web();
        if (!caps) return exit_graphics;
        const Exit status = make_live(*caps);
        return row_.error.empty() || status != exit_fine ? status : show_natively();
    }
    const GalleryRow& row() const { return row_; }

private:
    Exit make_live(const gl::Caps& caps) {
        const OpenedScene opened = opened_scene(exhibit_.scene, {}, caps, access_);
        row_.error = opened.first_error;
        if (!row_.error.empty()) return exit_fine;
        const Diagnostics unfit = unfit_statements(*opened.document);
        if (!unfit.empty()) row_.error = short_text(unfit.items().front(), opened.document->sources);
        return row_.error.empty() ? write_page(opened) : exit_fine;
    }

    Exit write_page(const OpenedScene& opened) {
        const PageParts parts = page_parts(exhibit_.scene, exhibit_.title, options_.link, opened, access_);
        row_.error = parts.error;
        if (!row_.error.empty()) return exit_fine;
        row_.picture = small_picture(opened);
        row_.page = exhibit_.page;
        const auto text = filled_page(page_, {parts.title, parts.scene, parts.archive});
        const std::string file = (fs::path(options_.output) / exhibit_.page).string();
        const std::string failed =
            text ? content::replace_file(file, *text) : "the browser's part of snell is of another version";
        return failed.empty() || cannot_write(file, failed) ? exit_fine : exit_input;
    }

    // A scene that only browsers cannot draw has a picture all the same; the errors of another one are these.
    Exit show_natively() {
        const auto caps = contexts_.native();
        if (!caps) return exit_graphics;
        const OpenedScene opened = opened_scene(exhibit_.scene, {}, *caps, access_);
        if (opened.fits)
            row_.picture = small_picture(opened);
        else
            row_.error = opened.first_error;
        return exit_fine;
    }

    const GalleryOptions& options_;
    const Exhibit& exhibit_;
    const std::string& page_;
    Access access_;
    PageContexts contexts_;
    GalleryRow row_;
};

// Returns the row of the scene; `status` is an error that ends the gallery.
GalleryRow row_of(const GalleryOptions& options, const Exhibit& exhibit, const std::string& page, Exit& status) {
    // In a process of its own, because a scene may never end, or end the program.
    content::open_image_module_as_copies_do();
    content::Process apart;
    apart.start(
        [&](std::string& result) {
            return status_of([&] {
                PageOfGallery made(options, exhibit, page);
                const Exit exit = made.make();
                result = row_text(made.row());
                return exit;
            });
        },
        {});
    const content::Ended ended = apart.wait();
    GalleryRow row = read_row(ended.output);
    if (ended.status == exit_graphics || ended.status == exit_input) status = static_cast<Exit>(ended.status);
    if (ended.status != exit_fine)
        row = {exhibit.title,
               {},
               {},
               ended.status == exit_timeout ? fmt::format("it takes longer than {} seconds", options.timeout)
                                            : std::string("it ends the program that draws it")};
    if (status == exit_fine && !row.error.empty())
        fmt::print(stderr, "snell: warning: no page of '{}': {}\n", utf8::printable(exhibit.scene), row.error);
    return row;
}

// Whether a gallery has made the file of this name.
bool made_by_gallery(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return false;
    const std::string text = content::whole_file(file.string());
    if (file.filename() == "index.html") return is_gallery_index(text);
    return file.filename() == "runtime.js" ? is_gallery_runtime(text) : is_gallery_page(text);
}

bool replaces_only_its_own(const std::vector<std::string>& outputs) {
    bool good = true;
    for (const std::string& file : outputs) {
        std::error_code error;
        if (!fs::exists(file, error) || made_by_gallery(file)) continue;
        good = complain(fmt::format("'{}' would be replaced, but it is not a file of a gallery", file),
                        "choose another folder, or move the file");
    }
    return good;
}

// A page of an earlier run shows what its scene no longer is.
std::string remove_old_page(const fs::path& page) {
    std::error_code error;
    if (!made_by_gallery(page)) return {};
    if (!fs::remove(page, error))
        return fmt::format("cannot remove '{}': {}", utf8::printable(page.string()), error.message());
    fmt::print(stderr, "snell: removed '{}', which was made by an earlier run\n", utf8::printable(page.string()));
    return {};
}

// Nothing that a scene reads is overwritten, and nothing that a gallery has not made.
Exit check_gallery(const GalleryOptions& options, const std::vector<Exhibit>& exhibits) {
    const fs::path folder(options.output);
    std::vector<std::string> outputs{(folder / "index.html").string(), (folder / "runtime.js").string()}, scenes;
    for (const Exhibit& exhibit : exhibits) {
        outputs.push_back((folder / exhibit.page).string());
        scenes.push_back(exhibit.scene);
    }
    if (!distinct_outputs(outputs, read_by(scenes, outputs, options.access, options.grade))) return exit_usage;
    if (!replaces_only_its_own(outputs)) return exit_usage;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return complain(exit_input, fmt::format("cannot make the folder '{}': {}", options.output, error.message()));
    return check_outputs(std::vector{outputs.front()}, {});
}

}  // namespace

Exit make_gallery(const GalleryOptions& options) {
    std::string error;
    const std::string page = web_file("gallery.html", error);
    const std::string runtime = error.empty() ? web_file("runtime.js", error) : "";
    std::vector<Exhibit> exhibits;
    if (!error.empty()) complain(error);
    if (!error.empty() || !find_scenes(options.folders, exhibits)) return exit_input;
    name_pages(exhibits);
    if (const Exit refused = check_gallery(options, exhibits); refused != exit_fine) return refused;
    std::vector<GalleryRow> rows;
    Exit status = exit_fine;
    for (const Exhibit& exhibit : exhibits) {
        rows.push_back(row_of(options, exhibit, page, status));
        if (status != exit_fine) return status;
    }
    const fs::path folder(options.output);
    error = content::replace_file((folder / "runtime.js").string(), gallery_runtime(runtime, rows));
    if (error.empty()) error = content::replace_file((folder / "index.html").string(), gallery_index(rows));
    for (std::size_t i = 0; i < rows.size() && error.empty(); ++i)
        if (!rows[i].error.empty()) error = remove_old_page(folder / exhibits[i].page);
    if (!error.empty()) return complain(exit_input, error);
    const auto pages = ranges::count_if(rows, [](const GalleryRow& row) { return row.error.empty(); });
    fmt::print("{}: {} of {} scenes have pages\n", utf8::printable((folder / "index.html").string()), pages,
               rows.size());
    return exit_fine;
}

namespace {

// Names without regard to case; beyond ASCII, if the system knows the letters.
class CaseFolding {
public:
    CaseFolding() = default;
    ~CaseFolding() {
        if (letters_) freelocale(letters_);
    }
    CaseFolding(const CaseFolding&) = delete;
    CaseFolding& operator=(const CaseFolding&) = delete;

    std::string operator()(std::string_view name) const {
        std::string folded;
        for (std::size_t at = 0; at < name.size();) {
            const utf8::Char c = utf8::decode(name, at);
            at += c.length;
            const auto code = static_cast<wint_t>(c.code);
            utf8::append(folded, static_cast<char32_t>(letters_ ? towlower_l(code, letters_) : towlower(code)));
        }
        return folded;
    }

private:
    locale_t letters_ = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
};

// What an address or a system cannot have in a name becomes '-', and so does a first dot, which would hide the page.
std::string page_name(std::string_view text) {
    constexpr std::string_view refused = "/\\:*?\"<>|#%&";
    std::string name;
    for (std::size_t at = 0; at < text.size();) {
        const utf8::Char c = utf8::decode(text, at);
        const bool bad =
            !c.valid || utf8::hidden(c.code) || refused.find(text[at]) != refused.npos || (at == 0 && c.code == '.');
        name += bad ? "-" : text.substr(at, c.length);
        at += c.length;
    }
    return name;
}

std::string name_of_scene(const Exhibit& exhibit) { return page_name(fs::path(exhibit.scene).stem().string()); }

// As seen from the folder that was named.
fs::path name_with_folders(const Exhibit& exhibit) {
    const fs::path near = fs::path(exhibit.scene).lexically_relative(fs::path(exhibit.folder).lexically_normal());
    return near.parent_path() / near.stem();
}

// Scenes right in the folders that were named are told apart by these.
std::string title_with_folders(const Exhibit& exhibit) {
    const fs::path name = name_with_folders(exhibit);
    const fs::path around = fs::weakly_canonical(exhibit.scene).parent_path().filename();
    return utf8::printable((name.has_parent_path() ? name : around / name).string());
}

constexpr std::string_view index_style =
    R"(body { max-width: 70rem; }
ul { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(11rem, calc(50% - .5rem)), 1fr)); gap: 1rem; margin: 0; padding: 0; list-style: none; }
li { border: 1px solid var(--weak); border-radius: .5rem; padding: .5rem; overflow-wrap: anywhere; }
h2 { margin: .25rem 0; font-size: 1rem; }
img { display: block; width: 100%; height: 8rem; object-fit: contain; }
a { color: inherit; display: block; }
a:focus-visible { outline: 3px solid currentColor; outline-offset: 2px; }
p { margin: .25rem 0; font-size: .875rem; color: var(--wrong); }
)";

constexpr std::string_view made_by = "snell";

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

void name_pages(std::vector<Exhibit>& exhibits) {
    const CaseFolding folded;
    std::map<std::string, int> scenes;
    for (const Exhibit& exhibit : exhibits) ++scenes[folded(name_of_scene(exhibit))];
    std::set<std::string> taken{"index"};
    for (const bool clash : {false, true})
        for (Exhibit& exhibit : exhibits) {
            const std::string own = name_of_scene(exhibit);
            if ((scenes[folded(own)] > 1) != clash) continue;
            const std::string name = clash ? page_name(name_with_folders(exhibit).string()) : own;
            exhibit.title =
                clash ? title_with_folders(exhibit) : utf8::printable(fs::path(exhibit.scene).stem().string());
            std::string unique = name;
            for (int number = 2; !taken.insert(folded(unique)).second; ++number)
                unique = fmt::format("{}-{}", name, number);
            exhibit.page = unique + ".html";
        }
}

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

bool is_gallery_index(std::string_view page) {
    return page.find(fmt::format("<meta name=\"generator\" content=\"{}\">", made_by)) != page.npos;
}

std::string gallery_runtime(std::string_view script, const std::vector<GalleryRow>& rows) {
    nlohmann::ordered_json pages = nlohmann::ordered_json::array();
    for (const GalleryRow& row : rows)
        if (row.error.empty()) pages.push_back({row.page, row.title});
    return fmt::format("{}var snellGallery={};\n{}", runtime_mark, script_json(pages), script);
}

bool is_gallery_runtime(std::string_view script) { return script.starts_with(runtime_mark); }

std::string gallery_index(const std::vector<GalleryRow>& rows) {
    std::string body = "<main>\n<h1>Scenes</h1>\n<ul>\n";
    for (const GalleryRow& row : rows) body += gallery_item(row);
    return content::html_page(
        {.title = "Scenes", .body = body + "</ul>\n</main>\n", .style = index_style, .made_by = made_by});
}

}  // namespace snell::app
