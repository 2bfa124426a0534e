#include "src/app/page/baked.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/progress.h"
#include "src/app/picture/picture.h"
#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/plan/values/controls.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

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

}  // namespace

EncodedPicture encoded(const content::Image& picture, bool lossless) {
    if (lossless) return {content::encode_png(picture)};
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/picture.webp";
    std::string error =
        folder.path().empty() ? "there is no folder for temporary files" : content::write_image(file, picture);
    if (!error.empty()) return {{}, "webp", std::move(error)};
    return {content::whole_file(file), "webp"};
}

namespace {

using Json = nlohmann::ordered_json;

struct BakedAxis {
    std::size_t control = 0;  // index into Controls::items
    std::vector<double> values;
};

// The controls of that name that a program uses, as --set takes it, or the one of that key, such as "P#2.uA".
std::vector<std::size_t> sliders_named(const Document& document, const std::string& name) {
    std::vector<std::size_t> found;
    const std::vector<snell::Control>& items = document.controls.items;
    const std::vector<std::string> keys = control_names(document.scene(), document.controls);
    if (const auto key = ranges::find(keys, name); key != keys.end() && name.find('.') != name.npos)
        return {static_cast<std::size_t>(key - keys.begin())};
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string whole = document.scene().programs[items[i].program].name + '.' + items[i].name;
        if (items[i].active && (items[i].name == name || whole == name)) found.push_back(i);
    }
    return found;
}

std::string wrong_slider(const Document& document, const std::string& name, const std::vector<std::size_t>& found) {
    if (found.empty()) return fmt::format("no program uses a uniform '{}'", name);
    if (found.size() > 1) return fmt::format("several programs have '{}': write Program.{}", name, name);
    const snell::Control& control = document.controls.items[found[0]];
    if (!control.active) return fmt::format("no program uses a uniform '{}'", name);
    if (control.widget == Widget::color)
        return fmt::format("'{}' is a colour: --baked takes sliders of one number", name);
    if (control.widget == Widget::none || control.value.size() != 1)
        return fmt::format("'{}' is not a slider of one number", name);
    return {};
}

// Whole numbers take all their values if these are no more than the steps. The current value is among the others: the
// page begins with it.
std::vector<double> values_of(const snell::Control& control, int steps) {
    std::vector<double> values;
    const bool whole = control.type == ValueType::int_ || control.type == ValueType::uint_;
    const double range = control.max - control.min;
    if (control.type == ValueType::bool_) return {0, 1};
    const int count = whole ? static_cast<int>(std::min(range + 1, static_cast<double>(steps))) : steps;
    for (int k = 0; k < count; ++k) {
        const double value = count > 1 ? control.min + range * k / (count - 1) : control.min;
        values.push_back(whole ? std::round(value) : k + 1 == count ? control.max : value);
    }
    values.push_back(control.value[0]);
    ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::string find_axes(const Document& document, const Baking& baking, std::vector<BakedAxis>& axes) {
    const int steps = baking.steps > 0 ? baking.steps : default_steps(baking.sliders.size());
    std::size_t count = 1;
    for (const std::string& name : baking.sliders) {
        const std::vector<std::size_t> found = sliders_named(document, name);
        if (std::string wrong = wrong_slider(document, utf8::printable(name), found); !wrong.empty()) return wrong;
        if (!axes.empty() && axes[0].control == found[0])
            return fmt::format("'{}' is given twice", utf8::printable(name));
        axes.push_back({found[0], values_of(document.controls.items[found[0]], steps)});
        count *= axes.back().values.size();
    }
    if (count <= most_baked) return {};
    return fmt::format("{} pictures are too many: --steps with a smaller number makes at most {}", count, most_baked);
}

Json control_json(const Document& document, const BakedAxis& axis, std::size_t index) {
    constexpr std::array types{"float", "int", "uint", "bool", "float", "int", "double"};  // as ValueType
    const snell::Control& control = document.controls.items[axis.control];
    return {{"index", index},
            {"key", control_names(document.scene(), document.controls)[axis.control]},
            {"program", document.scene().programs[control.program].name},
            {"name", control.name},
            {"widget", control.widget == Widget::check_box ? "check_box" : "slider"},
            {"type", types[static_cast<std::size_t>(control.type)]},
            {"components", 1},
            {"min", control.min},
            {"max", control.max},
            {"value", control.value},
            {"initialMin", control.min},
            {"initialMax", control.max},
            {"initial", control.value},
            {"active", true}};
}

// Draws the pictures one after the other; the last axis varies fastest.
class Baker {
public:
    Baker(Document& document, const View& view, const Baking& baking, Deadline& deadline)
        : document_(document), view_(view), baking_(baking), deadline_(deadline), controls_(document.controls) {}

    std::string draw(const std::vector<BakedAxis>& axes, std::vector<PackedFile>& pictures) {
        target_ = gl::make_target(baking_.width, baking_.height, baking_.samples, document_.runtime->display_pixels());
        if (!target_.framebuffer)
            return fmt::format("this OpenGL gives no picture of {}x{} with {} samples", baking_.width, baking_.height,
                               baking_.samples);
        const std::size_t rows = axes.size() > 1 ? axes[0].values.size() : 1;
        const BakedAxis& fast = axes.back();
        progress_.begin();
        for (std::size_t row = 0; row < rows; ++row)
            for (const double value : fast.values) {
                if (axes.size() > 1) controls_.items[axes[0].control].value = {axes[0].values[row]};
                controls_.items[fast.control].value = {value};
                if (std::string error = add(pictures, rows * fast.values.size()); !error.empty()) return error;
            }
        progress_.clear();
        return {};
    }

private:
    std::string add(std::vector<PackedFile>& pictures, std::size_t all) {
        deadline_.begin("drawing a picture for the page");
        const content::Image picture = draw_picture(*document_.runtime, {baking_.time, view_, controls_}, target_,
                                                    {.width = baking_.width, .height = baking_.height}, {});
        EncodedPicture made = encoded(picture, baking_.lossless);
        if (!made.error.empty()) return made.error + "\n   help: --lossless makes PNG pictures";
        pictures.push_back({fmt::format("pictures/{}.{}", pictures.size(), made.extension), std::move(made.bytes)});
        bytes_ += pictures.back().bytes.size();
        progress_.show(fmt::format("drawing pictures: {} of {}", pictures.size(), all),
                       static_cast<double>(pictures.size()) / static_cast<double>(all));
        if (bytes_ <= most_baked_bytes) return {};
        progress_.clear();
        return fmt::format(
            "the first {} of {} pictures are more than {} MB: a smaller --size or fewer --steps take less",
            pictures.size(), all, most_baked_bytes >> 20);
    }

    Document& document_;
    const View& view_;
    const Baking& baking_;
    Deadline& deadline_;
    Controls controls_;
    gl::Target target_;
    ProgressLine progress_;
    std::size_t bytes_ = 0;
};

}  // namespace

int default_steps(std::size_t sliders) { return sliders > 1 ? 9 : 24; }

Baked baked(Document& document, const View& view, const Baking& baking, const gl::Caps& caps, const Limits& limits,
            Deadline& deadline) {
    Baked result;
    std::vector<BakedAxis> axes;
    const PictureSize size{baking.width, baking.height, baking.samples};
    const Tiling tiling = tile(size, limits, caps);
    result.error = tiling.error;
    if (result.error.empty() && !tiling.whole(size))
        result.error = fmt::format("{}x{} is too large for the pictures of a page", baking.width, baking.height);
    if (result.error.empty()) result.error = find_axes(document, baking, axes);
    if (result.error.empty()) result.error = Baker(document, view, baking, deadline).draw(axes, result.pictures);
    result.json = {
        {"width", baking.width}, {"height", baking.height}, {"axes", Json::array()}, {"pictures", Json::array()}};
    for (std::size_t i = 0; i < axes.size(); ++i)
        result.json["axes"].push_back({{"control", control_json(document, axes[i], i)}, {"values", axes[i].values}});
    for (const PackedFile& picture : result.pictures) result.json["pictures"].push_back(picture.name);
    return result;
}

}  // namespace snell::app
