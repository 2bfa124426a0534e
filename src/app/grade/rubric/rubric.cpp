#include "src/app/grade/rubric/rubric.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "parser/commands/commands.h"
#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/grade/rubric/table.h"
#include "src/content/files.h"
#include "src/gl/program.h"
#include "src/lint/lint.h"
#include "src/plan/setup.h"
#include "src/runtime/resources/counters.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;
using TomlKind = TomlValue::Kind;
using ItemKind = RubricItem::Kind;

struct Range {
    std::optional<double> least, most;
};

// A range such as "0..1", "..8" or "2"; nullopt if it is none.
std::optional<Range> parse_range(std::string_view text) {
    const auto number = [](std::string_view part, std::optional<double>& value) {
        part = trimmed(part, " ");
        if (part.empty()) return true;
        value = read_whole<double>(part);
        return value && std::isfinite(*value);
    };
    Range range;
    const std::size_t dots = text.find("..");
    if (!number(text.substr(0, std::min(dots, text.size())), range.least)) return std::nullopt;
    if (dots == text.npos)
        range.most = range.least;
    else if (!number(text.substr(dots + 2), range.most))
        return std::nullopt;
    return range.least || range.most ? std::optional(range) : std::nullopt;
}

// Adds an item, and the pictures that it needs, to the rubric, whose `reference` is known. Reports mistakes.
class ItemReader {
public:
    ItemReader(const TomlValue& value, Rubric& rubric, Diagnostics& diagnostics)
        : value_(value), rubric_(rubric), diagnostics_(diagnostics), table_(value, diagnostics) {}

    void read() {
        table_.read("name", item_.name);
        table_.read("points", item_.points, above_0);
        if (const TomlValue* deduct = table_.find("deduct", TomlKind::number)) {
            if (table_.find("points")) wrong(deduct->span, "the item has both 'points' and 'deduct'");
            table_.read("deduct", item_.points, above_0);
            item_.deducts = true;
        }
        if (const TomlValue* either = table_.find("either", TomlKind::list)) read_either(*either);
        if (read_judged()) rubric_.items.push_back(std::move(item_));
    }

private:
    // Exactly one of the keys says what the item judges.
    bool read_judged() {
        const std::size_t errors = diagnostics_.errors();
        read_names();
        read_tables();
        if (const TomlValue* slower = table_.find("slower", TomlKind::number)) {
            table_.read("slower", item_.ratio, above_0);
            judges(ItemKind::time, fmt::format("At most {} times the reference's time", item_.ratio));
            if (rubric_.reference.empty()) wrong(slower->span, "the rubric has no 'reference' whose time counts");
        }
        // Asked for last: its own keys are known only with it.
        if (const TomlValue* expect = table_.find("expect", TomlKind::text)) {
            read_picture(*expect);
            const std::string label = rubric_.pictures[item_.picture].label();
            judges(ItemKind::picture, fmt::format("{}: {}", label.empty() ? "As it is" : label, expect->text));
        }
        table_.done();
        if (judged_ <= 1 && (judged_ == 1 || diagnostics_.errors() > errors)) return true;
        wrong(value_.span, judged_ == 0 ? "the item does not say what it judges" : "the item judges two things",
              "one of: no_errors, no_lints, uniforms, needs, forbids, expect, counters, slower, named, except, either");
        return false;
    }

    void read_either(const TomlValue& list) {
        for (const TomlValue& one : list.list) {
            if (one.kind != TomlKind::table) continue;
            ItemReader part(one, rubric_, diagnostics_);
            part.item_.points = item_.points;
            if (part.read_judged()) item_.either.push_back(std::move(part.item_));
        }
        if (list.list.size() < 2 ||
            !ranges::all_of(list.list, [](const auto& one) { return one.kind == TomlKind::table; }))
            wrong(list.span, "'either' is a list of at least two tables, each of which says what it judges");
        std::vector<std::string> names;
        for (const RubricItem& part : item_.either) names.push_back(part.name);
        judges(ItemKind::either, fmt::format("{}", fmt::join(names, ", or ")));
    }

    void wrong(Span span, std::string message, std::string help = {}) {
        wrong_value(diagnostics_, span, std::move(message), std::move(help));
    }

    void judges(ItemKind kind, std::string name) {
        ++judged_;
        item_.kind = kind;
        if (item_.name.empty()) item_.name = std::move(name);
    }

    // The keys whose value is a name, or a list of names.
    void read_names() {
        std::vector<std::string_view> lints;
        for (const lint::RuleFacts& rule : lint::rules()) lints.push_back(rule.code);
        if (const TomlValue* on = table_.find("no_errors", TomlKind::truth); on && on->truth)
            judges(ItemKind::no_errors, "The scene reads without errors");
        if (table_.find("no_lints")) {
            item_.names = known_names("no_lints", "lint", lints);
            table_.read("each", item_.each, above_0);
            judges(ItemKind::no_lints, fmt::format("No {}", fmt::join(item_.names, ", ")));
        }
        if (const TomlValue* named = table_.find("named", TomlKind::text)) {
            item_.names = {named->text};
            judges(ItemKind::named, fmt::format("The scene is called {}", named->text));
            if (named->text.empty() || named->text.find('/') != std::string::npos)
                wrong(named->span, "'named' is the name of a file, without folders");
        }
        if (const TomlValue* except = table_.find("except")) {
            item_.names = table_.texts("except");
            judges(ItemKind::except, "Not one of the rubric's list");  // pages of students name no others
            if (except->kind == TomlKind::list && except->list.empty()) empty(*except, "except", "submission");
        }
        for (const auto& [key, kind, text] :
             {std::tuple("needs", ItemKind::needs, "Uses"), std::tuple("forbids", ItemKind::forbids, "Does without")})
            if (table_.find(key)) {
                item_.names = known_names(key, "command", command_names());
                judges(kind, fmt::format("{} {}", text, fmt::join(item_.names, ", ")));
            }
    }

    void read_tables() {
        if (const TomlValue* uniforms = table_.find("uniforms", TomlKind::table)) {
            for (const TomlValue::Member& member : uniforms->members) read_uniform(member);
            if (uniforms->members.empty()) empty(*uniforms, "uniforms", "uniform");
            judges(ItemKind::uniforms, "Uniforms");
        }
        if (const TomlValue* counters = table_.find("counters", TomlKind::table)) {
            for (const TomlValue::Member& member : counters->members) read_counter(member);
            if (counters->members.empty()) empty(*counters, "counters", "counter");
            judges(ItemKind::counters, "What it takes");
        }
    }

    void empty(const TomlValue& value, std::string_view key, std::string_view what) {
        wrong(value.span, fmt::format("'{}' is empty, so that the item never costs points", key),
              fmt::format("name at least one {}, or remove the item", what));
    }

    std::vector<std::string> known_names(std::string_view key, std::string_view what,
                                         const std::vector<std::string_view>& names) {
        std::vector<std::string> found = table_.texts(key);
        const TomlValue& list = *table_.find(key);
        if (list.kind == TomlKind::list && list.list.empty()) empty(list, key, what);
        const auto known = [&](const std::string& one) {
            return ranges::any_of(names, [&](std::string_view name) { return same_word(name, one); });
        };
        for (const TomlValue& one : list.kind == TomlKind::list ? list.list : std::vector{list})
            if (one.kind == TomlKind::text && !known(one.text))
                wrong_name(diagnostics_, one.span, what, one.text, names);
        return found;
    }

    bool in_order(const Range& range, Span span) {
        if (!range.least || !range.most || *range.least <= *range.most) return true;
        wrong(span, fmt::format("the range begins at {}, above its end at {}", *range.least, *range.most),
              fmt::format("did you mean {}..{}?", *range.most, *range.least));
        return false;
    }

    void read_uniform(const TomlValue::Member& member) {
        const auto& [name, span, value] = member;
        NeededUniform needed{name, {}, {}, {}};
        const std::string_view text = value.text;
        const std::size_t blank = std::min(text.find(' '), text.size());
        needed.type = text.substr(0, blank);
        const auto range = blank < text.size() ? parse_range(text.substr(blank + 1)) : Range{};
        const auto types = gl::type_names();
        if (value.kind != TomlKind::text || !range || parse_range(needed.type) ||
            (blank < text.size() && text.find("..") == text.npos))
            wrong(value.span,
                  value.kind == TomlKind::text
                      ? fmt::format("'{}' is not a type with a range, such as \"float 0..1\"", text)
                      : fmt::format("'{}' is a type, with or without a range, such as \"float 0..1\"", name));
        else if (!needed.type.empty() && ranges::find(types, needed.type) == types.end())
            wrong_name(diagnostics_, value.span, "type", needed.type, types);
        else if (blank < text.size() &&
                 (needed.type.starts_with("mat") || needed.type.find("sampler") != std::string::npos))
            wrong(value.span, fmt::format("a {} has no slider, and therefore no range", needed.type),
                  fmt::format("write \"{}\"", needed.type));
        else if (in_order(*range, value.span))
            std::tie(needed.least, needed.most) = std::tie(range->least, range->most);
        item_.uniforms.push_back(std::move(needed));
    }

    void read_counter(const TomlValue::Member& member) {
        const auto& [name, span, value] = member;
        std::vector<std::string_view> names;
        for (const CounterName& counter : counter_names()) names.push_back(counter.name);
        if (ranges::find(names, std::string_view(name)) == names.end())
            wrong_name(diagnostics_, span, "counter", name, names);
        std::optional<Range> range;
        if (value.kind == TomlKind::text) range = parse_range(value.text);
        if (value.kind == TomlKind::number && std::isfinite(value.number)) range = Range{std::nullopt, value.number};
        if (!range || (range->most && *range->most < 0))
            wrong(value.span, fmt::format("'{}' is a maximum from 0, or a range such as \"1..8\"", name));
        else if (in_order(*range, value.span))
            item_.counters.push_back({name, range->least, range->most});
    }

    // Returns the index of the picture, which items may share.
    std::size_t picture(Shown shown) {
        const auto found = ranges::find(rubric_.pictures, shown);
        if (found != rubric_.pictures.end()) return static_cast<std::size_t>(found - rubric_.pictures.begin());
        rubric_.pictures.push_back(std::move(shown));
        return rubric_.pictures.size() - 1;
    }

    Shown shown(std::string_view key) {
        Shown shown;
        const TomlValue* sets = table_.find(key, TomlKind::table);
        if (!sets) return shown;
        for (const auto& [name, span, value] : sets->members) {
            const auto text = assigned_text(value);
            if (!text)
                wrong(value.span,
                      fmt::format("'{}' has no value: a finite number, true, false, or a list of them", name),
                      value.kind == TomlKind::table ? "a name with a dot is written in quotes" : "");
            shown.sets.push_back(name + "=" + text.value_or(""));
        }
        return shown;
    }

    // The keys that say how near or far the pictures are.
    void read_limits() {
        if (item_.expect == Expect::finite) return;
        if (item_.expect == Expect::reference) {
            table_.read("max_rmse", item_.max_rmse, below_1);
            table_.read("max_flip", item_.max_flip, below_1);
            table_.read("max_pixels", item_.max_pixels, below_100);
            if (!item_.max_rmse && !item_.max_flip && !item_.max_pixels) item_.max_rmse = .05;
            return;
        }
        constexpr std::array<double, 5> usual{.05, .05, .01, .001, .02};
        item_.by = usual[static_cast<std::size_t>(item_.expect)];
        const bool most = item_.expect == Expect::same || item_.expect == Expect::mirrored;
        table_.read("by", item_.by, most ? below_1 : item_.expect == Expect::brighter ? from_0 : from_0_to_1);
    }

    void read_picture(const TomlValue& expect) {
        const auto& names = expect_names();
        const auto found = ranges::find(names, std::string_view(expect.text));
        if (found == names.end()) {
            const std::string_view near = nearest(expect.text, names);
            for (const char* key : {"set", "than", "time", "view", "by", "max_rmse", "max_flip", "max_pixels"})
                table_.find(key);  // keys of some relation, so that only the relation is reported
            return wrong(expect.span, fmt::format("there is no relation '{}'", expect.text),
                         near.empty() ? fmt::format("possible: {}", fmt::join(names, ", "))
                                      : fmt::format("did you mean '{}'?", near));
        }
        item_.expect = static_cast<Expect>(found - names.begin());
        read_limits();
        const bool against = item_.expect == Expect::reference, one = item_.expect == Expect::finite;
        Shown own = shown("set"), other = own;
        if (!one && (!against || table_.find("than"))) other = shown("than");
        table_.read("time", own.time, from_0);
        if (const TomlValue* view = table_.find("view", TomlKind::text)) {
            View parsed;
            own.view = view->text;
            if (const std::string error = parse_view(own.view, parsed); !error.empty()) wrong(view->span, error);
        }
        other.time = own.time;
        other.view = own.view;
        item_.picture = picture(own);
        item_.than = picture(other);
        if (against) item_.map = rubric_.maps++;
        if (against && rubric_.reference.empty())
            wrong(expect.span, "the rubric has no 'reference' to compare with",
                  "add a line at the top: reference = \"my-scene.glib\"");
        if (!against && !one && item_.expect != Expect::mirrored && item_.picture == item_.than)
            wrong(expect.span, "the picture would be compared with itself",
                  "'set' gives it values that differ from the scene's own, or from those of 'than'");
    }

    const TomlValue& value_;
    Rubric& rubric_;
    Diagnostics& diagnostics_;
    RubricTable table_;
    RubricItem item_;
    std::size_t judged_ = 0;  // how many things
};

// Two whole numbers of pixels, such as "320x240".
bool parse_sides(std::string_view text, int& width, int& height) {
    const std::size_t cross = std::min(text.find('x'), text.size() - 1);
    width = read_whole<int>(text.substr(0, cross)).value_or(0);
    height = read_whole<int>(text.substr(cross + 1)).value_or(0);
    const auto usual = [](int side) { return side >= 16 && side <= 4096; };
    return usual(width) && usual(height);
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
        RubricTable table(root, diagnostics_);
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
            RubricTable names(*aliases, diagnostics_);
            for (const auto& member : aliases->members) rubric_.aliases[member.name] = names.texts(member.name);
        }
        if (const TomlValue* scenes = table.find("scenes", TomlKind::table))
            for (const auto& [name, span, value] : scenes->members) {
                rubric_.scenes[name] = value.text;
                if (value.text.empty())
                    wrong(value.span, fmt::format("'{}' is the scene of a submission, such as \"ball.glib\"", name));
            }
        if (const TomlValue* items = table.find("item", TomlKind::list))
            for (const TomlValue& item : items->list) ItemReader(item, rubric_, diagnostics_).read();
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
    void read_scenes(RubricTable& table) {
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

    std::vector<std::string> paths(RubricTable& table, std::string_view name) {
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

    void read_size(RubricTable& table) {
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
