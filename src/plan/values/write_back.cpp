#include "src/plan/values/write_back.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"

namespace snell {
namespace {

using Kind = UniformValue::Kind;
constexpr std::string_view blanks = " \t";

bool is_word(std::string_view text) { return same_word(text, "true") || same_word(text, "false"); }

// The shortest text that reads back to the same bits, with a point or a leading zero if `like` has one. Empty if the
// language cannot express the number.
std::string number_text(double value, std::string_view like) {
    const bool whole = value == std::round(value) && std::abs(value) < 1e15;
    std::string text = text_of::number(value, whole && written_integral(like));
    const std::size_t sign = text.starts_with('-') ? 1 : 0;
    const std::size_t first = like.find_first_not_of("+-");
    const bool bare = first != std::string_view::npos && like[first] == '.';
    if (bare && text.substr(sign).starts_with("0.") && text.size() > sign + 2) text.erase(sign, 1);
    const Number read = read_number(text);
    return read.fault == NumberFault::none && read.value == value ? text : std::string();
}

std::string value_text(double value, std::string_view like) {
    if (!is_word(like) || (value != 0 && value != 1)) return number_text(value, is_word(like) ? "0" : like);
    std::string text = value == 0 ? "false" : "true";
    const auto capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const auto raise = [](char& c) { c = static_cast<char>(c - 'a' + 'A'); };
    if (capital(like[1])) {
        ranges::for_each(text, raise);
    } else if (capital(like[0])) {
        raise(text[0]);
    }
    return text;
}

// The changed form of one value on a Program line.
struct Rewritten {
    UniformValue uniform;
    std::vector<Edit> edits;
    std::string refused;  // the reason if the value cannot be written
};

// The components of a control that one value of the Program line sets.
struct Part {
    const Control* control = nullptr;
    std::size_t first = 0;
    bool element = false;     // the value sets one element of an array, by its index
    std::vector<char> given;  // by component; 0 if a later value overrides it
};

class Rewriter {
public:
    Rewriter(const UniformValue& uniform, const Part& part, const Sources& sources)
        : uniform_(uniform), part_(part), sources_(sources), result_{uniform, {}, {}} {}

    Rewritten run() {
        if (uniform_.kind == Kind::range)
            range();
        else
            values();
        if (!result_.refused.empty()) result_ = {uniform_, {}, result_.refused};
        return std::move(result_);
    }

private:
    double wanted(std::size_t component) const { return part_.control->value[component]; }
    bool changed(std::size_t component) const { return wanted(component) != part_.control->initial[component]; }
    std::string_view text(const Span& span) const {
        return sources_.text(span.file).substr(span.begin, span.end - span.begin);
    }

    std::string written(double value, std::string_view like) {
        std::string text = value_text(value, like);
        if (text.empty()) result_.refused = fmt::format("a scene cannot contain the number {}", value);
        return text;
    }

    void replace(std::size_t number, double value) {
        if (uniform_.values[number] == value) return;
        const Span& span = uniform_.value_spans[number];
        result_.uniform.values[number] = value;
        result_.edits.push_back({span, written(value, text(span))});
    }

    // Rewrites <min current max>, whose one number sets all components.
    void range() {
        std::optional<double> value;
        bool moved = false;
        const std::size_t end = part_.element ? part_.first + 1 : part_.control->value.size();
        for (std::size_t i = part_.first; i < end; ++i) {
            if (!part_.given[i]) continue;
            moved = moved || changed(i);
            if (value && *value != wanted(i))
                result_.refused = "a range sets all components to the same number; write [x y z] to set each one";
            value = wanted(i);
        }
        if (!value || !moved || !result_.refused.empty()) return;
        // A number outside of the range widens it.
        const std::size_t low = uniform_.values[0] <= uniform_.values[2] ? 0 : 2, high = 2 - low;
        if (*value < uniform_.values[low]) replace(low, *value);
        if (*value > uniform_.values[high]) replace(high, *value);
        if (uniform_.value_spans[1].begin != uniform_.value_spans[1].end) return replace(1, *value);
        result_.uniform.values[1] = *value;
        result_.edits.push_back({uniform_.value_spans[1], " " + written(*value, text(uniform_.value_spans[0]))});
    }

    // Rewrites the numbers of the components; numbers that the text lacks are appended after the last one.
    void values() {
        const std::size_t room = part_.control->value.size() - part_.first;
        std::size_t there = 0, last_changed = 0;
        const std::size_t counted = uniform_.kind == Kind::boolean ? 1 : uniform_.values.size();
        for (std::size_t i = 0; i < std::min(counted, room); ++i) {
            const Span& span = uniform_.value_spans[i];
            if (span.begin == span.end && i > 0) break;
            ++there;
            if (part_.given[part_.first + i] && changed(part_.first + i)) replace(i, wanted(part_.first + i));
        }
        for (std::size_t i = there; i < room && !part_.element; ++i)
            if (part_.given[part_.first + i] && changed(part_.first + i)) last_changed = i;
        if (last_changed == 0) return;
        if (uniform_.kind != Kind::array && uniform_.kind != Kind::color) {
            result_.refused = fmt::format("the scene has only 1 of its {} numbers; write {}",
                                          part_.control->value.size(), uniform_text(*part_.control));
            return;
        }
        add(there, last_changed);
    }

    void add(std::size_t from, std::size_t last) {
        const Span& before = uniform_.value_spans[from - 1];
        std::string more;
        result_.uniform.values.resize(std::max(result_.uniform.values.size(), last + 1));
        for (std::size_t i = from; i <= last; ++i) {
            result_.uniform.values[i] = wanted(part_.first + i);
            more += " " + written(wanted(part_.first + i), text(before));
        }
        result_.edits.push_back({{before.file, before.end, before.end}, std::move(more)});
    }

    const UniformValue& uniform_;
    const Part& part_;
    const Sources& sources_;
    Rewritten result_;
};

std::optional<std::size_t> element_index(std::string_view name) {
    const std::size_t bracket = name.rfind('[');
    if (bracket == std::string_view::npos || !name.ends_with(']')) return std::nullopt;
    return read_whole<std::size_t>(name.substr(bracket + 1, name.size() - bracket - 2));
}

// The components that each value of a Program line sets; if two set the same component, the later one counts.
std::vector<Part> parts_of(const Scene& scene, const Controls& controls, Index program) {
    const std::vector<UniformValue>& uniforms = scene.programs[program].uniforms;
    std::vector<Part> parts(uniforms.size());
    std::map<const Control*, std::vector<std::size_t>> giver;
    for (std::size_t u = 0; u < uniforms.size(); ++u) {
        Part& part = parts[u];
        const auto own = ranges::find_if(controls.items, [&](const Control& control) {
            return control.program == program && control.listed && control.uniform == u;
        });
        if (own != controls.items.end()) {
            part.control = &*own;
        } else if (const auto index = element_index(uniforms[u].name)) {
            part.control = controls.find(program, uniforms[u].name.substr(0, uniforms[u].name.rfind('[')));
            part.element = true;
            if (part.control) part.first = *index * static_cast<std::size_t>(part.control->components);
        }
        if (!part.control || part.first >= part.control->value.size()) {
            part.control = nullptr;
            continue;
        }
        std::vector<std::size_t>& by = giver[part.control];
        by.resize(part.control->value.size(), uniforms.size());
        const std::size_t count = uniforms[u].kind == Kind::range ? 1 : uniforms[u].values.size();
        const std::size_t end = part.element ? std::min(part.first + count, by.size()) : by.size();
        for (std::size_t i = part.first; i < end; ++i) by[i] = u;
    }
    for (std::size_t u = 0; u < uniforms.size(); ++u)
        if (parts[u].control)
            for (const std::size_t by : giver[parts[u].control]) parts[u].given.push_back(by == u);
    return parts;
}

// Identifies a file independent of how its name was written.
std::string file_of(FileId file, const Sources& sources) {
    return std::filesystem::path(sources.name(file)).lexically_normal().string();
}

bool same_change(const Rewritten& a, const Rewritten& b) {
    return ranges::equal(a.edits, b.edits, [](const Edit& x, const Edit& y) {
        return x.span.begin == y.span.begin && x.span.end == y.span.end && x.text == y.text;
    });
}

class Writer {
public:
    Writer(const Scene& scene, const Controls& controls, const Sources& sources)
        : scene_(scene), controls_(controls), sources_(sources) {}

    WriteBack run() {
        result_.programs = scene_.programs;
        result_.ladders = scene_.ladders;
        for (Index program = 0; program < scene_.programs.size(); ++program) rewrite(program);
        for (auto& [place, readings] : readings_) agree(readings);
        refuse_unlisted();
        for (std::size_t i = 0; i < scene_.ladders.size() && i < controls_.rungs.size(); ++i) ladder(i);
        for (Edit& edit : result_.edits) edit.span.file = first_reading(edit.span.file);
        ranges::stable_sort(result_.edits, {},
                            [](const Edit& e) { return std::tuple(e.span.file, e.span.begin, e.span.end); });
        return std::move(result_);
    }

private:
    struct Reading {
        Index program;
        std::size_t uniform;
        Rewritten rewritten;
    };

    void refuse(const std::string& name, std::string reason) { result_.unwritten.push_back({name, std::move(reason)}); }

    std::string full_name(Index program, std::string_view name) const {
        return fmt::format("{}.{}", scene_.programs[program].name, name);
    }

    void rewrite(Index program) {
        const std::vector<Part> parts = parts_of(scene_, controls_, program);
        for (std::size_t u = 0; u < parts.size(); ++u) {
            const UniformValue& uniform = scene_.programs[program].uniforms[u];
            Rewritten rewritten{uniform, {}, {}};
            if (parts[u].control) rewritten = Rewriter(uniform, parts[u], sources_).run();
            if (!rewritten.refused.empty()) refuse(full_name(program, uniform.name), rewritten.refused);
            readings_[{file_of(uniform.span.file, sources_), uniform.span.begin}].push_back(
                {program, u, std::move(rewritten)});
        }
    }

    // A scene that is included twice has two programs for one place in the text; both must change it in the same way.
    void agree(std::vector<Reading>& readings) {
        const bool same = ranges::all_of(
            readings, [&](const Reading& r) { return same_change(r.rewritten, readings.front().rewritten); });
        if (!same) {
            const Reading& first = readings.front();
            refuse(full_name(first.program, first.rewritten.uniform.name),
                   "its file is included more than once, and the values differ between the inclusions");
            return;
        }
        for (const Reading& reading : readings)
            result_.programs[reading.program].uniforms[reading.uniform] = reading.rewritten.uniform;
        ranges::copy(readings.front().rewritten.edits, std::back_inserter(result_.edits));
    }

    void refuse_unlisted() {
        for (const Control& control : controls_.items)
            if (!control.listed && control.value != control.initial)
                refuse(full_name(control.program, control.name),
                       fmt::format("it is not on the Program line; add {}", uniform_text(control)));
    }

    void ladder(std::size_t index) {
        const Ladder& ladder = scene_.ladders[index];
        const std::size_t rung = controls_.rungs[index];
        if (rung == ladder.current || rung >= ladder.rungs.size()) return;
        const Span& old = ladder.rung_spans[ladder.current];
        const Span& now = ladder.rung_spans[rung];
        const std::string_view text = sources_.text(old.file);
        const std::size_t open = old.begin == 0 ? text.npos : text.find_last_not_of(blanks, old.begin - 1);
        if (open < text.size() && std::string_view("<[{(").find(text[open]) != text.npos) erase(old.file, open);
        const std::size_t close = text.find_first_not_of(blanks, old.end);
        if (close < text.size() && std::string_view(">]})").find(text[close]) != text.npos) erase(old.file, close);
        result_.edits.push_back({{now.file, now.begin, now.begin}, "<"});
        result_.edits.push_back({{now.file, now.end, now.end}, ">"});
        result_.ladders[index].current = rung;
    }

    // A blank stays if two words would otherwise become one.
    void erase(FileId file, std::size_t at) {
        const auto place = static_cast<std::uint32_t>(at);
        const std::string_view text = sources_.text(file);
        const auto word = [&](std::size_t i) {
            return i < text.size() && (blanks.find(text[i]) == blanks.npos) && text[i] != '\n' && text[i] != '\r';
        };
        result_.edits.push_back({{file, place, place + 1}, word(at - 1) && word(at + 1) ? " " : ""});
    }

    // The first of several inclusions of the same file.
    FileId first_reading(FileId file) const {
        for (FileId other = 0; other < file; ++other)
            if (file_of(other, sources_) == file_of(file, sources_)) return other;
        return file;
    }

    const Scene& scene_;
    const Controls& controls_;
    const Sources& sources_;
    std::map<std::pair<std::string, std::uint32_t>, std::vector<Reading>> readings_;  // by file and place
    WriteBack result_;
};

}  // namespace

WriteBack write_back(const Scene& scene, const Controls& controls, const Sources& sources) {
    return Writer(scene, controls, sources).run();
}

std::string with_edits(std::string_view text, FileId file, std::span<const Edit> edits) {
    std::string result;
    std::size_t at = 0;
    for (const Edit& edit : edits) {
        if (edit.span.file != file || edit.span.begin < at || edit.span.end > text.size()) continue;
        result += text.substr(at, edit.span.begin - at);
        result += edit.text;
        at = edit.span.end;
    }
    result += text.substr(at);
    return result;
}

bool reads_back(const WriteBack& write_back, const Scene& scene) {
    const auto same_uniform = [](const UniformValue& a, const UniformValue& b) {
        return a.name == b.name && a.values == b.values;
    };
    const auto same_program = [&](const Program& a, const Program& b) {
        return a.name == b.name && ranges::equal(a.uniforms, b.uniforms, same_uniform);
    };
    const auto same_ladder = [](const Ladder& a, const Ladder& b) {
        return a.name == b.name && a.rungs == b.rungs && a.current == b.current;
    };
    return ranges::equal(write_back.programs, scene.programs, same_program) &&
           ranges::equal(write_back.ladders, scene.ladders, same_ladder);
}

std::string uniform_text(const Control& control) {
    UniformValue uniform;
    uniform.name = control.name;
    uniform.values = control.value;
    uniform.integral =
        control.type != ValueType::float_ && control.type != ValueType::double_ && control.type != ValueType::matrix;
    const bool one = control.value.size() == 1;
    uniform.kind = control.widget == Widget::color ? Kind::color : one ? Kind::scalar : Kind::array;
    if (control.type == ValueType::bool_ && one) uniform.kind = Kind::boolean;
    if (control.widget == Widget::slider && one) {
        uniform.kind = Kind::range;
        uniform.values = {control.min, control.value[0], control.max};
    }
    return text_of::uniform(uniform);
}

}  // namespace snell
