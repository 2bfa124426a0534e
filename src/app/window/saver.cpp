#include "src/app/window/saver.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/batch/shots.h"
#include "src/app/desktop/folder.h"
#include "src/plan/locate.h"
#include "src/runtime/resources/uniforms.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

// A larger part would keep the window from answering for long.
constexpr int largest_part = 2048;

Picture wanted(const Picture& shown, const ui::PictureMemory& picture) {
    Picture result = shown;
    result.width = static_cast<int>(picture.width);
    result.height = static_cast<int>(picture.height);
    result.samples = static_cast<int>(picture.samples);
    result.file = picture.file.data();
    result.transparent = picture.transparent;
    result.frames = picture.sequence ? ui::picture_count(picture) : 0;
    result.rate = picture.rate;
    if (picture.sequence) result.time = picture.from;
    // The mouse stays at the same place of the picture.
    result.view.mouse_x *= picture.width / std::max(1, shown.width);
    result.view.mouse_y *= picture.height / std::max(1, shown.height);
    return result;
}

// A sequence of one whole period of the slowest slider repeats without a jump.
void offer_period(const std::vector<Animated>& animated, ui::PictureMemory& picture) {
    picture.from = 0;
    picture.to = ranges::max(animated, {}, &Animated::period).period;
}

// The files are named as `snell render -o` names them.
std::vector<std::string> files_of(const std::string& scene, const Picture& picture, std::string& error) {
    std::vector<app::Axis> axes;
    if (picture.frames > 0) axes.push_back(app::frames_axis(static_cast<std::size_t>(picture.frames)));
    const auto shots = app::plan_shots({scene}, std::move(axes), picture.file, error);
    return shots ? shots->files : std::vector<std::string>{};
}

}  // namespace

// The default is a file next to the scene, in the size of the window's picture, and a sequence of one round of its
// time.
void PictureSaver::fill(const Document& document, const Picture& shown, ui::PictureMemory& picture) {
    picture.error.clear();
    picture.there.clear();
    picture.largest = std::min(static_cast<double>(limits_.output_side), static_cast<double>(caps_.max_viewport));
    picture.most = app::max_pictures;
    if (picture.width > 0) return;
    std::error_code error;
    fs::path path = fs::absolute(document.path, error).replace_extension("png");
    std::string text;
    for (const char c : path.string()) text += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
    const std::size_t length = text.copy(picture.file.data(), picture.file.size() - 1);
    picture.file[length] = '\0';
    picture.width = shown.width;
    picture.height = shown.height;
    constexpr double longest = 600;  // seconds: 15,000 pictures
    if (document.runtime->animated()) picture.to = std::min(document.scene().timer_period, longest);
}

// Says where the pictures go, and what those of a sequence are called.
void PictureSaver::name(const Document& document, ui::PictureMemory& picture) {
    Picture asked;
    asked.file = picture.file.data();
    asked.frames = picture.sequence ? std::min(ui::picture_count(picture), 2) : 0;
    std::string problem;
    const std::vector<std::string> files = files_of(document.path, asked, problem);
    picture.folder.clear();
    picture.names.clear();
    if (files.empty()) return;
    std::error_code none;
    picture.folder =
        utf8::printable(with_tilde(fs::absolute(files.front(), none).lexically_normal().parent_path().string()));
    for (const std::string& file : files)
        picture.names += (picture.names.empty() ? "" : ", ") + utf8::printable(fs::path(file).filename().string());
    if (files.size() > 1) picture.names += " \u2026";
}

void PictureSaver::serve(const ui::Requests& requests, const Document& document, const Picture& shown, Window& window,
                         ui::Memory& memory) {
    ui::PictureMemory& picture = memory.picture;
    if (picture.open) name(document, picture);
    switch (requests.picture) {
        case ui::PictureRequest::none:
            return;
        case ui::PictureRequest::open:
            fill(document, shown, picture);
            if (memory.animating() && picture.sequence) offer_period(memory.animated, picture);
            picture.open = true;
            return name(document, picture);
        case ui::PictureRequest::command: {
            const std::string command = render_command(document, wanted(shown, picture));
            window.set_clipboard(command);
            memory.notice = "copied: " + command;
            return;
        }
        case ui::PictureRequest::stop:
            return end(memory, work_ && work_->files.size() > 1
                                   ? fmt::format("stopped after {} of {} pictures", work_->done, work_->files.size())
                                   : "stopped");
        case ui::PictureRequest::save:
            picture.error = utf8::printable(begin(document, shown, memory));
            return;
    }
}

// Returns "", or why nothing begins.
std::string PictureSaver::begin(const Document& document, const Picture& shown, ui::Memory& memory) {
    ui::PictureMemory& picture = memory.picture;
    const Picture asked = wanted(shown, picture);
    std::string error;
    auto work = std::make_unique<Work>();
    work->files = files_of(document.path, asked, error);
    if (!error.empty()) return error;
    std::error_code none;
    std::string there;  // the first file that exists
    for (const std::string& file : work->files) {
        if (!fs::exists(file, none)) continue;
        if (there.empty()) there = file;
        for (const std::string& read : document.files->read_paths())
            if (fs::equivalent(file, read, none))
                return "'" + file + "' is read by the scene, and would be overwritten";
    }
    if (!ui::confirmed(picture, !there.empty(), there)) return {};
    if (asked.transparent && !app::holds_alpha(work->files.front()))
        return "this format cannot be transparent: PNG and EXR can";
    work->document = &document;
    work->revision = revision_;
    work->from = asked.time;
    work->rate = asked.rate;
    work->view = asked.view;
    work->controls = document.controls;
    if (picture.sequence) work->animated = memory.animated;
    work->size = {asked.width, asked.height, asked.samples, app::holds_floats(work->files.front())};
    work->tiling = app::tile(work->size, limits_, caps_, largest_part);
    work->transparent = asked.transparent;
    if (const app::Tiling& tiling = work->tiling; !tiling.error.empty())
        return tiling.help.empty() ? tiling.error : tiling.error + ": " + tiling.help;
    work_ = std::move(work);
    picture.progress = 0;
    return {};
}

void PictureSaver::end(ui::Memory& memory, const std::string& error) {
    if (!work_) return;
    const Work& work = *work_;
    memory.picture.progress.reset();
    memory.picture.error = utf8::printable(error);
    if (error.empty()) {
        const std::string last = utf8::printable(fs::path(work.files.back()).filename().string());
        memory.notice = work.files.size() == 1
                            ? fmt::format("saved {}, {}x{}", last, work.size.width, work.size.height)
                            : fmt::format("saved {} pictures, the last is {}", work.files.size(), last);
        memory.picture.open = false;
    }
    work_.reset();
}

void PictureSaver::step(Document* document, std::uint64_t revision, ui::Memory& memory) {
    revision_ = revision;
    if (!work_) return;
    Work& work = *work_;
    if (document != work.document || revision != work.revision) return end(memory, "the scene is another now");
    if (!work.painting)
        work.painting = std::make_unique<app::Painting>(work.files[work.done], work.size, work.tiling, work.transparent,
                                                        document->runtime->display_pixels());
    const double time = work.from + runtime::frame_time(work.done, work.rate);
    animate(work.controls, work.animated, time);
    const Frame frame{time, work.view, work.controls};
    if (!work.painting->step(*document->runtime, frame)) {
        if (!work.painting->error().empty()) return end(memory, work.painting->error());
        work.painting.reset();
        ++work.done;
    }
    const double part = work.painting ? work.painting->progress() : 0;
    memory.picture.progress = (static_cast<double>(work.done) + part) / static_cast<double>(work.files.size());
    if (work.done == work.files.size()) end(memory, {});
}

namespace {

constexpr std::size_t most_output = 1 << 20;  // bytes

// The first line of the output with this text; "" if there is none.
std::string line_with(std::string_view output, std::string_view text) {
    const std::size_t found = output.find(text);
    if (found == output.npos) return {};
    const std::size_t at = found == 0 ? 0 : output.rfind('\n', found) + 1;  // npos + 1 is 0
    return utf8::printable(output.substr(at, output.find('\n', at) - at));
}

// The first error of the output, and what helps against it.
std::string error_of(std::string_view output) {
    constexpr std::string_view error = "error: ", own = "snell: error: ", help = "\n   help: ";
    std::string text = line_with(output, error);
    if (text.starts_with(own)) text.erase(0, own.size());
    output.remove_prefix(std::min(output.find(error), output.size()));
    output = output.substr(0, output.find(error, 1));
    if (const std::size_t at = output.find(help); at != output.npos)
        text += "\nHelp: " + line_with(output.substr(at + help.size()), "");
    return text;
}

}  // namespace

std::string page_file(const std::string& name) {
    return has_extension(name, "html") || has_extension(name, "htm") ? name : name + ".html";
}

std::string PageMaker::start(const std::string& page, const std::vector<std::string>& arguments) {
    page_ = page_file(page);
    std::error_code none;
    if (page_ != page && std::filesystem::exists(page_, none))
        return fmt::format("{} exists: give its whole name to replace it",
                           utf8::printable(std::filesystem::path(page_).filename().string()));
    std::vector<std::string> words{"/proc/self/exe", "web", "-o", page_};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return process_.start(words, {.most_output = most_output, .captured = true});
}

std::string PageMaker::look() {
    const auto ended = process_.poll();
    if (!ended) return {};
    const std::string& said = ended->output;
    const std::string name = utf8::printable(std::filesystem::path(page_).filename().string());
    if (ended->status != 0) return fmt::format("{} is not saved: {}", name, error_of(said));
    const std::string line = line_with(said, " redistributes ");
    const std::size_t told = line.find(name);
    return "saved " +
           (told == line.npos ? name : line.substr(told, line.size() - told - (line.ends_with(':') ? 1 : 0)));
}

}  // namespace snell
