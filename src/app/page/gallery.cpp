#include "src/app/page/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "parser/text/ranges.h"
#include "parser/text/utf8.h"
#include "parser/text/words.h"
#include "src/app/page/gallery_index.h"
#include "src/app/page/html.h"
#include "src/app/page/page.h"
#include "src/app/picture/outputs.h"
#include "src/app/picture/picture.h"
#include "src/app/picture/sheet.h"
#include "src/content/replace.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

bool wrong(const std::string& what) {
    fmt::print(stderr, "snell: error: {}\n", what);
    return false;
}

// A scene, and the file name of its page.
struct Exhibit {
    std::string scene, folder;  // `folder`: the one that was named
    std::string page;
};

// Sorted by name, so that the index does not depend on the file system.
bool find_scenes(const std::vector<std::string>& folders, std::vector<Exhibit>& exhibits) {
    std::set<fs::path> known;  // folders may be within each other
    for (const std::string& folder : folders) {
        std::error_code error;
        const std::size_t first = exhibits.size();
        fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
        if (error)
            return wrong(fmt::format("cannot read the folder '{}': {}", utf8::printable(folder), error.message()));
        for (; !error && entry != end; entry.increment(error)) {
            const fs::path& path = entry->path();
            if (!same_word(path.extension().string(), ".glib") || !entry->is_regular_file(error)) continue;
            if (!known.insert(fs::weakly_canonical(path, error)).second) continue;
            exhibits.push_back({path.lexically_normal().string(), folder, {}});
        }
        std::sort(exhibits.begin() + static_cast<std::ptrdiff_t>(first), exhibits.end(),
                  [](const Exhibit& a, const Exhibit& b) { return a.scene < b.scene; });
    }
    if (exhibits.empty()) return wrong("there are no scenes in these folders");
    if (exhibits.size() > most_gallery_scenes)
        return wrong(fmt::format("{} scenes are too many: a gallery takes {}", exhibits.size(), most_gallery_scenes));
    return true;
}

// Letters and digits as they are: such a name is the same in an address, and on every system.
std::string page_name(std::string_view text) {
    std::string name;
    for (const char c : text) {
        const bool good = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
        const char low = lower(c);
        name += good || (low >= 'a' && low <= 'z') ? low : '-';
    }
    return name;
}

// A scene whose name another one has gets the names of its folders, too, and a number if that is not enough.
void name_pages(std::vector<Exhibit>& exhibits) {
    std::map<std::string, int> stems;
    const auto stem = [](const Exhibit& e) { return page_name(fs::path(e.scene).stem().string()); };
    for (const Exhibit& exhibit : exhibits) ++stems[stem(exhibit)];
    std::set<std::string> taken{"index"};
    for (Exhibit& exhibit : exhibits) {
        std::string name = stem(exhibit);
        if (stems[name] > 1) {
            const fs::path near =
                fs::path(exhibit.scene).lexically_relative(fs::path(exhibit.folder).lexically_normal());
            name = page_name((near.parent_path() / near.stem()).string());
        }
        std::string unique = name;
        for (int number = 2; !taken.insert(unique).second; ++number) unique = fmt::format("{}-{}", name, number);
        exhibit.page = unique + ".html";
    }
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
    return content::encode_png(thumbnail(draw_picture(runtime, frame, target, {.width = w, .height = h}, {})));
}

class Gallery {
public:
    Gallery(const GalleryOptions& options, std::string page) : options_(options), page_(std::move(page)) {}

    // Writes the page of the scene, if it can have one. Returns false if the gallery must end.
    bool add(const Exhibit& exhibit, Deadline& deadline) {
        const Access access = access_to(exhibit.scene, options_.access, options_.grade);
        deadline.begin(fmt::format("reading '{}'", exhibit.scene));
        const auto caps = contexts_.web();
        if (!caps) return false;
        GalleryRow row{utf8::printable(fs::path(exhibit.scene).stem().string()), {}, {}, {}};
        {
            OpenedScene opened = opened_scene(exhibit.scene, {}, *caps, access);
            row.error = opened.first_error;
            if (opened.document->runtime && row.error.empty())
                if (const Diagnostics unfit = unfit_statements(*opened.document); !unfit.empty())
                    row.error = short_text(unfit.items().front(), opened.document->sources);
            if (row.error.empty()) write_page(exhibit, opened, access, row);
        }
        if (!row.error.empty() && !shown_natively(exhibit, access, row)) return false;
        if (!row.error.empty()) fmt::print(stderr, "snell: warning: no page: {}\n", row.error);
        rows_.push_back(std::move(row));
        return ok_;
    }
    const std::vector<GalleryRow>& rows() const { return rows_; }

private:
    void write_page(const Exhibit& exhibit, const OpenedScene& opened, const Access& access, GalleryRow& row) {
        const PageParts parts = page_parts(exhibit.scene, {}, options_.link, opened, access);
        row.error = parts.error;
        if (!row.error.empty()) return;
        row.picture = small_picture(opened);
        const auto text = filled_page(page_, {parts.title, parts.scene, parts.archive});
        const std::string file = (fs::path(options_.output) / exhibit.page).string();
        const std::string failed =
            text ? content::replace_file(file, *text) : "the browser's part of snell is of another version";
        row.page = exhibit.page;
        ok_ = failed.empty() || wrong(fmt::format("cannot write '{}': {}", utf8::printable(file), failed));
    }

    // A scene that only browsers cannot draw has a picture all the same; the errors of another one are these.
    bool shown_natively(const Exhibit& exhibit, const Access& access, GalleryRow& row) {
        const auto caps = contexts_.native();
        if (!caps) return false;
        const OpenedScene opened = opened_scene(exhibit.scene, {}, *caps, access);
        if (opened.fits)
            row.picture = small_picture(opened);
        else
            row.error = opened.first_error;
        return true;
    }

    const GalleryOptions& options_;
    std::string page_;
    PageContexts contexts_{""};
    std::vector<GalleryRow> rows_;
    bool ok_ = true;
};

// Nothing that a scene reads is overwritten.
Exit check_gallery(const GalleryOptions& options, const std::vector<Exhibit>& exhibits) {
    const fs::path folder(options.output);
    std::vector<std::string> outputs{(folder / "index.html").string(), (folder / "runtime.js").string()}, read;
    for (const Exhibit& exhibit : exhibits) {
        outputs.push_back((folder / exhibit.page).string());
        read.push_back(exhibit.scene);
    }
    if (replace_a_file(outputs))
        for (const Exhibit& exhibit : exhibits)
            for (std::string& path :
                 files_read_by(exhibit.scene, access_to(exhibit.scene, options.access, options.grade)))
                read.push_back(std::move(path));
    if (!distinct_outputs(outputs, read)) return exit_usage;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        wrong(fmt::format("cannot make the folder '{}': {}", utf8::printable(options.output), error.message()));
        return exit_input;
    }
    return check_outputs(std::vector{outputs.front()}, {});
}

}  // namespace

Exit make_gallery(const GalleryOptions& options) {
    std::string error;
    const std::string page = web_file("gallery.html", error);
    const std::string runtime = error.empty() ? web_file("runtime.js", error) : "";
    std::vector<Exhibit> exhibits;
    if (!error.empty()) wrong(error);
    if (!error.empty() || !find_scenes(options.folders, exhibits)) return exit_input;
    name_pages(exhibits);
    if (const Exit status = check_gallery(options, exhibits); status != exit_fine) return status;
    Gallery gallery(options, page);
    Deadline deadline(options.timeout);
    for (const Exhibit& exhibit : exhibits)
        if (!gallery.add(exhibit, deadline)) return exit_graphics;
    deadline.begin("writing the gallery");
    const fs::path folder(options.output);
    error = content::replace_file((folder / "runtime.js").string(), runtime);
    if (error.empty()) error = content::replace_file((folder / "index.html").string(), gallery_index(gallery.rows()));
    if (!error.empty()) return wrong(error) ? exit_fine : exit_input;
    const auto pages = ranges::count_if(gallery.rows(), [](const GalleryRow& row) { return row.error.empty(); });
    fmt::print("{}: {} of {} scenes have pages\n", utf8::printable((folder / "index.html").string()), pages,
               gallery.rows().size());
    return exit_fine;
}

}  // namespace snell::app
