#include "src/app/grade/rubric/rubric.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/grade/rubric/items.h"
#include "src/app/grade/rubric/table.h"
#include "src/app/grade/rubric/toml.h"
#include "src/content/files.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;
using TomlKind = TomlValue::Kind;

// Two whole numbers of pixels, such as "320x240".
bool parse_sides(std::string_view text, int& width, int& height) {
    const char* const end = text.data() + text.size();
    const auto [middle, wrong_width] = std::from_chars(text.data(), end, width);
    if (wrong_width != std::errc() || middle == end || *middle != 'x') return false;
    const auto [last, wrong_height] = std::from_chars(middle + 1, end, height);
    const auto usual = [](int side) { return side >= 16 && side <= 4096; };
    return wrong_height == std::errc() && last == end && usual(width) && usual(height);
}

}  // namespace

std::string unusable(const std::string& path) {
    constexpr std::size_t most_entries = 20'000;
    constexpr std::uint64_t most_bytes = std::uint64_t{2} << 30;
    std::error_code error;
    if (!fs::exists(path, error)) return "is not there";
    std::size_t entries = 0;
    std::uint64_t bytes = fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
    const bool folder = fs::is_directory(path, error);
    const std::error_code unread =
        folder ? content::walk(path,
                               [&](const fs::path& entry, fs::file_status status, int) {
                                   ++entries;
                                   std::error_code unknown_size;
                                   const std::uintmax_t size =
                                       fs::is_regular_file(status) ? fs::file_size(entry, unknown_size) : 0;
                                   if (!unknown_size) bytes += size;
                                   return entries <= most_entries && bytes <= most_bytes ? content::Walk::on
                                                                                         : content::Walk::end;
                               })
               : error;
    if (unread) return "cannot be read: " + unread.message();
    if (entries > most_entries) return fmt::format("holds more than {} files and folders", most_entries);
    return bytes > most_bytes ? "holds more than 2 GB" : "";
}

namespace {

// The keys above the items, and the items.
class Reader {
public:
    Reader(Rubric& rubric, fs::path folder, Diagnostics& diagnostics)
        : rubric_(rubric), folder_(std::move(folder)), diagnostics_(diagnostics) {}

    void read(const TomlValue& root) {
        Table table(root, diagnostics_);
        rubric_.pictures.emplace_back();
        table.read("title", rubric_.title);
        table.read("timeout", rubric_.timeout, seconds_above_0);
        double samples = rubric_.samples;
        table.read("samples", samples, samples_of_a_pixel);
        rubric_.samples = static_cast<int>(samples);
        read_scenes(table);
        read_size(table);
        rubric_.shared = paths(table, "shared");
        rubric_.templates = paths(table, "template");
        if (const TomlValue* aliases = table.find("aliases", TomlKind::table)) {
            Table names(*aliases, diagnostics_);
            for (const auto& member : aliases->members) rubric_.aliases[member.name] = names.texts(member.name);
        }
        if (const TomlValue* scenes = table.find("scenes", TomlKind::table))
            for (const auto& [name, span, value] : scenes->members) {
                rubric_.scenes[name] = value.text;
                if (value.text.empty())
                    wrong(value.span, fmt::format("'{}' is the scene of a submission, such as \"ball.glib\"", name));
            }
        if (const TomlValue* items = table.find("item", TomlKind::list))
            for (const TomlValue& item : items->list) read_item(item, rubric_, diagnostics_);
        table.done();
        if (rubric_.items.empty() && !diagnostics_.has_errors())
            diagnostics_.error("rubric-empty", root.span, "the rubric has no items",
                               "each begins with a line '[[item]]'; 'snell grade --new SCENE' writes some");
    }

private:
    void wrong(Span span, std::string message, std::string help = {}) {
        wrong_value(diagnostics_, span, std::move(message), std::move(help));
    }

    std::string absolute(const std::string& path) const {
        std::error_code error;
        return fs::weakly_canonical(fs::absolute(folder_ / path, error), error).string();
    }

    // The lecturer's scene, and how those of the submissions are called.
    void read_scenes(Table& table) {
        const TomlValue* pattern = table.find("scene", TomlKind::text);
        if (pattern) rubric_.scene = pattern->text;
        if (rubric_.scene.find('/') != std::string::npos)
            wrong(pattern->span, "'scene' is the name of a file, without folders",
                  "scenes are found in folders of any depth");
        const TomlValue* value = table.find("reference", TomlKind::text);
        if (!value) return;
        rubric_.reference = absolute(value->text);
        if (std::error_code error; !fs::is_regular_file(rubric_.reference, error))
            wrong(value->span, fmt::format("there is no scene '{}'", value->text),
                  "the path is relative to the folder of the rubric");
    }

    std::vector<std::string> paths(Table& table, std::string_view name) {
        std::vector<std::string> found;
        const std::vector<std::string> texts = table.texts(name);
        const TomlValue* value = table.find(name);
        for (std::size_t i = 0; i < texts.size(); ++i) {
            found.push_back(absolute(texts[i]));
            const Span span = value->list.size() == texts.size() ? value->list[i].span : value->span;
            if (const std::string why = unusable(found.back()); !why.empty())
                wrong(span, fmt::format("'{}' names '{}', which {}", name, texts[i], why));
        }
        return found;
    }

    void read_size(Table& table) {
        const TomlValue* size = table.find("size", TomlKind::text);
        if (size && !parse_sides(size->text, rubric_.width, rubric_.height))
            wrong(size->span, fmt::format("'{}' is not a size from 16x16 to 4096x4096", size->text));
    }

    Rubric& rubric_;
    fs::path folder_;
    Diagnostics& diagnostics_;
};

}  // namespace

std::string Shown::label() const {
    std::string text = fmt::format("{}", fmt::join(sets, " "));
    if (time != 0) text += fmt::format("{}time={}", text.empty() ? "" : " ", time);
    if (!view.empty()) text += (text.empty() ? "" : " ") + view;
    return text;
}

double Rubric::points() const {
    double sum = 0;
    for (const RubricItem& item : items) sum += item.most();
    return sum;
}

std::vector<const RubricItem*> RubricItem::parts() const {
    if (kind != Kind::either) return {this};
    std::vector<const RubricItem*> all;
    for (const RubricItem& part : either) all.push_back(&part);
    return all;
}

bool RubricItem::judges(Kind what) const {
    return ranges::any_of(parts(), [what](const RubricItem* part) { return part->kind == what; });
}

bool Rubric::judges(RubricItem::Kind kind) const {
    return ranges::any_of(items, [kind](const RubricItem& item) { return item.judges(kind); });
}

const std::vector<std::string_view>& expect_names() {
    static const std::vector<std::string_view> names{"darker",   "brighter",  "different", "same",
                                                     "mirrored", "reference", "finite"};
    return names;
}

std::optional<Rubric> read_rubric(const std::string& path, Sources& sources, Diagnostics& diagnostics) {
    Rubric rubric;
    rubric.path = path;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        diagnostics.error("rubric-unreadable", fmt::format("cannot read the rubric '{}'", utf8::printable(path)),
                          "'snell grade --new SCENE' writes one to start from");
        return std::nullopt;
    }
    rubric.text = content::whole_file(path);
    const FileId file = sources.add(path, rubric.text);
    const auto root = read_toml(file, sources, diagnostics);
    if (!root) return std::nullopt;
    Reader(rubric, fs::path(path).parent_path(), diagnostics).read(*root);
    if (diagnostics.has_errors()) return std::nullopt;
    return rubric;
}

}  // namespace snell::app
