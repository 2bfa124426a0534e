#include "src/app/grade/rubric.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "parser/commands/commands.h"
#include "parser/text/ranges.h"
#include "parser/text/real.h"
#include "parser/text/utf8.h"
#include "parser/text/words.h"
#include "src/app/grade/submissions.h"
#include "src/app/grade/toml.h"
#include "src/content/whole_file.h"
#include "src/document/view_text.h"
#include "src/lint/lint.h"
#include "src/runtime/resources/counters.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;
using TomlKind = TomlValue::Kind;
using ItemKind = RubricItem::Kind;

std::string_view words_of(TomlKind kind) {
    constexpr std::array<std::string_view, 6> words{"a text in quotes",     "a number",
                                                    "true or false",        "a list in brackets",
                                                    "a table in braces {}", "something else"};
    return words[static_cast<std::size_t>(kind)];
}

// The keys of one table. Those that nobody asked for are reported when it is done.
class Table {
public:
    Table(const TomlValue& table, Diagnostics& diagnostics) : table_(table), diagnostics_(diagnostics) {}

    const TomlValue* find(std::string_view name, std::optional<TomlKind> kind = std::nullopt) {
        known_.push_back(name);
        for (const TomlValue::Member& member : table_.members) {
            if (member.name != name) continue;
            if (!kind || member.value.kind == *kind) return &member.value;
            diagnostics_.error("rubric-value", member.value.span,
                               fmt::format("'{}' is {}, not {}", name, words_of(*kind), words_of(member.value.kind)));
        }
        return nullptr;
    }
    void read(std::string_view name, std::string& text) {
        if (const TomlValue* value = find(name, TomlKind::text)) text = value->text;
    }
    void read(std::string_view name, std::optional<double>& number) {
        const TomlValue* value = find(name, TomlKind::number);
        if (!value) return;
        if (!std::isfinite(value->number) || value->number < 0)
            diagnostics_.error("rubric-value", value->span, fmt::format("'{}' is a number from 0", name));
        else
            number = value->number;
    }
    void read(std::string_view name, double& number) {
        std::optional<double> read_number;
        read(name, read_number);
        number = read_number.value_or(number);
    }
    std::vector<std::string> texts(std::string_view name) {
        std::vector<std::string> texts;
        const TomlValue* list = find(name);
        if (list && list->kind == TomlKind::text) return {list->text};
        if (list && list->kind != TomlKind::list)
            diagnostics_.error("rubric-value", list->span, fmt::format("'{}' is a list of texts", name));
        for (const TomlValue& part : list ? list->list : std::vector<TomlValue>{})
            if (part.kind == TomlKind::text)
                texts.push_back(part.text);
            else
                diagnostics_.error("rubric-value", part.span, fmt::format("'{}' is a list of texts", name));
        return texts;
    }
    void done() {
        for (const TomlValue::Member& member : table_.members) {
            if (ranges::find(known_, std::string_view(member.name)) != known_.end()) continue;
            const std::string_view near = nearest(member.name, known_);
            diagnostics_.error("rubric-key", member.span, fmt::format("a rubric has no '{}' here", member.name),
                               near.empty() ? fmt::format("possible: {}", fmt::join(known_, ", "))
                                            : fmt::format("did you mean '{}'?", near));
        }
    }
    Span span() const { return table_.span; }

private:
    const TomlValue& table_;
    Diagnostics& diagnostics_;
    std::vector<std::string_view> known_;
};

// A range such as "0..1", "..8" or "2"; false if it is none.
bool parse_range(std::string_view text, std::optional<double>& least, std::optional<double>& most) {
    const std::size_t dots = text.find("..");
    const auto number = [](std::string_view part, std::optional<double>& value) {
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        if (part.empty()) return true;
        double held = 0;
        const auto [end, error] = read_real(part.data(), part.data() + part.size(), held);
        value = held;
        return error == std::errc() && end == part.data() + part.size() && std::isfinite(held);
    };
    if (dots == text.npos) return number(text, least) && least && (most = least);
    return number(text.substr(0, dots), least) && number(text.substr(dots + 2), most) && (least || most);
}

// Two whole numbers of pixels, such as "320x240".
bool parse_sides(std::string_view text, int& width, int& height) {
    const char* const end = text.data() + text.size();
    const auto [middle, wrong_width] = std::from_chars(text.data(), end, width);
    if (wrong_width != std::errc() || middle == end || *middle != 'x') return false;
    const auto [last, wrong_height] = std::from_chars(middle + 1, end, height);
    const auto usual = [](int side) { return side >= 16 && side <= 4096; };
    return wrong_height == std::errc() && last == end && usual(width) && usual(height);
}

class Reader {
public:
    Reader(Rubric& rubric, fs::path folder, Diagnostics& diagnostics)
        : rubric_(rubric), folder_(std::move(folder)), diagnostics_(diagnostics) {}

    void read(const TomlValue& root) {
        Table table(root, diagnostics_);
        rubric_.pictures.emplace_back();
        table.read("title", rubric_.title);
        table.read("scene", rubric_.scene);
        table.read("timeout", rubric_.timeout);
        if (rubric_.timeout <= 0) rubric_.timeout = 1e6;
        read_reference(table);
        read_size(table);
        rubric_.shared = paths(table, "shared");
        rubric_.templates = paths(table, "template");
        if (const TomlValue* aliases = table.find("aliases", TomlKind::table)) {
            Table names(*aliases, diagnostics_);
            for (const auto& member : aliases->members) rubric_.aliases[member.name] = names.texts(member.name);
        }
        if (const TomlValue* items = table.find("item", TomlKind::list))
            for (const TomlValue& item : items->list) read_item(item);
        table.done();
        if (rubric_.items.empty() && !diagnostics_.has_errors())
            diagnostics_.error("rubric-empty", root.span, "the rubric has no items",
                               "each begins with a line '[[item]]'; 'snell grade --new SCENE' writes some");
    }

private:
    void wrong(Span span, std::string message, std::string help = {}) {
        diagnostics_.error("rubric-value", span, std::move(message), std::move(help));
    }

    std::string absolute(const std::string& path) const {
        std::error_code error;
        return fs::weakly_canonical(fs::absolute(folder_ / path, error), error).string();
    }

    void read_reference(Table& table) {
        const TomlValue* value = table.find("reference", TomlKind::text);
        if (!value) return;
        rubric_.reference = absolute(value->text);
        if (std::error_code error; !fs::is_regular_file(rubric_.reference, error))
            wrong(value->span, fmt::format("there is no scene '{}'", value->text),
                  "the path is relative to the folder of the rubric");
    }

    std::vector<std::string> paths(Table& table, std::string_view name) {
        std::vector<std::string> found;
        for (const std::string& path : table.texts(name)) {
            found.push_back(absolute(path));
            if (const std::string why = unusable(found.back()); !why.empty())
                wrong(table.find(name)->span, fmt::format("'{}' names '{}', which {}", name, path, why));
        }
        return found;
    }

    void read_size(Table& table) {
        std::optional<double> samples;
        table.read("samples", samples);
        rubric_.samples = static_cast<int>(std::clamp(samples.value_or(1), 1., 64.));
        const TomlValue* size = table.find("size", TomlKind::text);
        if (!size) return;
        if (!parse_sides(size->text, rubric_.width, rubric_.height))
            wrong(size->span, fmt::format("'{}' is not a size from 16x16 to 4096x4096", size->text));
    }

    // Returns the index of the picture, which items may share.
    std::size_t picture(Shown shown) {
        const auto found = ranges::find(rubric_.pictures, shown);
        if (found != rubric_.pictures.end()) return static_cast<std::size_t>(found - rubric_.pictures.begin());
        rubric_.pictures.push_back(std::move(shown));
        return rubric_.pictures.size() - 1;
    }

    std::vector<std::string> assignments(const TomlValue& table) {
        std::vector<std::string> sets;
        for (const auto& [name, span, value] : table.members) {
            std::string text = value.kind == TomlKind::number  ? fmt::format("{}", value.number)
                               : value.kind == TomlKind::truth ? (value.truth ? "true" : "false")
                                                               : value.text;
            for (const TomlValue& part : value.list) text += fmt::format("{}{}", text.empty() ? "" : ",", part.number);
            if (text.empty()) wrong(value.span, fmt::format("'{}' has no value: a number, true, or a list", name));
            sets.push_back(name + "=" + text);
        }
        return sets;
    }

    Shown shown(Table& table, std::string_view values) {
        Shown shown;
        if (const TomlValue* sets = table.find(values, TomlKind::table)) shown.sets = assignments(*sets);
        return shown;
    }

    void read_picture(Table& table, RubricItem& item, const TomlValue& expect) {
        const auto& names = expect_names();
        const auto found = ranges::find(names, std::string_view(expect.text));
        if (found == names.end()) {
            const std::string_view near = nearest(expect.text, names);
            return wrong(expect.span, fmt::format("there is no relation '{}'", expect.text),
                         near.empty() ? fmt::format("possible: {}", fmt::join(names, ", "))
                                      : fmt::format("did you mean '{}'?", near));
        }
        item.expect = static_cast<Expect>(found - names.begin());
        constexpr std::array<double, 6> usual{.05, .05, .01, .001, .02, 0};
        item.by = usual[static_cast<std::size_t>(item.expect)];
        table.read("by", item.by);
        table.read("max_rmse", item.max_rmse);
        table.read("max_flip", item.max_flip);
        table.read("max_pixels", item.max_pixels);
        if (!item.max_rmse && !item.max_flip && !item.max_pixels) item.max_rmse = .05;
        Shown own = shown(table, "set"), other = shown(table, "than");
        table.read("time", own.time);
        if (const TomlValue* view = table.find("view", TomlKind::text)) {
            View parsed;
            own.view = view->text;
            if (const std::string error = parse_view(own.view, parsed); !error.empty()) wrong(view->span, error);
        }
        other.time = own.time;
        other.view = own.view;
        item.picture = picture(own);
        item.than = item.expect == Expect::reference ? item.picture : picture(other);
        if (item.expect == Expect::reference && rubric_.reference.empty())
            wrong(expect.span, "the rubric has no 'reference' to compare with",
                  "add a line at the top: reference = \"my-scene.glib\"");
        if (item.expect != Expect::reference && item.picture == item.than)
            wrong(expect.span, "the picture would be compared with itself",
                  "'set' gives it values that differ from the scene's own, or from those of 'than'");
    }

    void read_uniforms(RubricItem& item, const TomlValue& uniforms) {
        for (const auto& [name, span, value] : uniforms.members) {
            NeededUniform needed{name, {}, {}, {}};
            const std::string_view text = value.text;
            const std::size_t blank = std::min(text.find(' '), text.size());
            needed.type = text.substr(0, blank);
            if (value.kind != TomlKind::text ||
                (blank < text.size() && !parse_range(text.substr(blank + 1), needed.least, needed.most)))
                wrong(value.span, fmt::format("'{}' is not a type with a range, such as \"float 0..1\"", value.text));
            item.uniforms.push_back(std::move(needed));
        }
    }

    void read_counters(RubricItem& item, const TomlValue& counters) {
        std::vector<std::string_view> names;
        for (const CounterName& counter : counter_names()) names.push_back(counter.name);
        for (const auto& [name, span, value] : counters.members) {
            Bounds bounds{name, {}, {}};
            if (ranges::find(names, std::string_view(name)) == names.end()) unknown(span, "counter", name, names);
            if (value.kind == TomlKind::number)
                bounds.most = value.number;
            else if (!parse_range(value.text, bounds.least, bounds.most))
                wrong(value.span, fmt::format("'{}' is neither a maximum nor a range such as \"1..8\"", value.text));
            item.counters.push_back(std::move(bounds));
        }
    }

    void unknown(Span span, std::string_view what, const std::string& name,
                 const std::vector<std::string_view>& names) {
        const std::string_view near = nearest(name, names);
        wrong(span, fmt::format("there is no {} '{}'", what, name),
              near.empty() ? "" : fmt::format("did you mean '{}'?", near));
    }

    std::vector<std::string> known_names(Table& table, std::string_view key, std::string_view what,
                                         const std::vector<std::string_view>& names) {
        std::vector<std::string> found = table.texts(key);
        const TomlValue* list = table.find(key);
        for (std::size_t i = 0; i < found.size(); ++i)
            if (ranges::find_if(names, [&](std::string_view name) { return same_word(name, found[i]); }) == names.end())
                unknown(list->kind == TomlKind::list ? list->list[i].span : list->span, what, found[i], names);
        return found;
    }

    // Exactly one of the keys says what the item judges.
    void read_item(const TomlValue& value) {
        Table table(value, diagnostics_);
        RubricItem item;
        table.read("name", item.name);
        table.read("points", item.points);
        std::vector<std::pair<ItemKind, std::string>> told;
        std::vector<std::string_view> lints;
        for (const lint::RuleFacts& rule : lint::rules()) lints.push_back(rule.code);
        if (const TomlValue* on = table.find("no_errors", TomlKind::truth); on && on->truth)
            told.emplace_back(ItemKind::no_errors, "The scene reads without errors");
        if (table.find("no_lints")) {
            item.names = known_names(table, "no_lints", "lint", lints);
            told.emplace_back(ItemKind::no_lints, fmt::format("No {}", fmt::join(item.names, ", ")));
        }
        table.read("each", item.each);
        if (const TomlValue* uniforms = table.find("uniforms", TomlKind::table)) {
            read_uniforms(item, *uniforms);
            told.emplace_back(ItemKind::uniforms, "Uniforms");
        }
        for (const auto& [key, kind, text] :
             {std::tuple("needs", ItemKind::needs, "Uses"), std::tuple("forbids", ItemKind::forbids, "Does without")})
            if (table.find(key)) {
                item.names = known_names(table, key, "command", command_names());
                told.emplace_back(kind, fmt::format("{} {}", text, fmt::join(item.names, ", ")));
            }
        if (const TomlValue* counters = table.find("counters", TomlKind::table)) {
            read_counters(item, *counters);
            told.emplace_back(ItemKind::counters, "What it takes");
        }
        if (table.find("slower", TomlKind::number)) {
            table.read("slower", item.ratio);
            told.emplace_back(ItemKind::time, fmt::format("At most {} times the reference's time", item.ratio));
            if (rubric_.reference.empty()) wrong(value.span, "the rubric has no 'reference' whose time counts");
        }
        // Asked for last: its own keys are known only with it.
        if (const TomlValue* expect = table.find("expect", TomlKind::text)) {
            read_picture(table, item, *expect);
            const std::string label = rubric_.pictures[item.picture].label();
            told.emplace_back(ItemKind::picture,
                              fmt::format("{}: {}", label.empty() ? "As it is" : label, expect->text));
        }
        table.done();
        if (told.size() != 1)
            return wrong(value.span,
                         told.empty() ? "the item does not say what it judges" : "the item judges two things",
                         "one of: no_errors, no_lints, uniforms, needs, forbids, expect, counters, slower");
        item.kind = told.front().first;
        if (item.name.empty()) item.name = told.front().second;
        rubric_.items.push_back(std::move(item));
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
    for (const RubricItem& item : items) sum += item.points;
    return sum;
}

bool Rubric::judges(RubricItem::Kind kind) const {
    return ranges::any_of(items, [kind](const RubricItem& item) { return item.kind == kind; });
}

const std::vector<std::string_view>& expect_names() {
    static const std::vector<std::string_view> names{"darker", "brighter", "different",
                                                     "same",   "mirrored", "reference"};
    return names;
}

std::optional<Rubric> read_rubric(const std::string& path, Sources& sources, Diagnostics& diagnostics) {
    Rubric rubric;
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
