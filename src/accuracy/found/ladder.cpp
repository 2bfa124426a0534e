#include "src/accuracy/found/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "parser/read/syntax.h"
#include "parser/text/ranges.h"
#include "src/glsl/read/divisions.h"
#include "src/glsl/read/lexer.h"
#include "src/plan/used_files.h"

namespace snell::accuracy {

namespace {

using glsl::Extent;
using glsl::whole_groups;

// The lines of a text that are there twice, and what they become.
struct TwiceThere {
    Extent lines;
    std::vector<const Edit*> edits;
};

std::string edited(std::string_view text, const TwiceThere& region) {
    std::string result;
    std::size_t at = region.lines.begin;
    for (const Edit* edit : region.edits) {
        result.append(text.substr(at, edit->span.begin - at)).append(edit->text);
        at = edit->span.end;
    }
    return result.append(text.substr(at, region.lines.end - at));
}

bool ends_line(std::string_view text) { return !text.empty() && (text.back() == '\n' || text.back() == '\r'); }

class Doubler {
public:
    explicit Doubler(std::string_view text)
        : text_(text), clean_(glsl::clean(text).text), divisions_(glsl::divisions(clean_)) {}

    // Why the edit can't be in an #if; "" if it can.
    std::string refusal(const Edit& edit) const {
        const auto [begin, end] = std::pair<std::size_t, std::size_t>(edit.span.begin, edit.span.end);
        for (const auto& [extent, word] : divisions_.directives) {
            const bool touched = begin < end ? begin < extent.end && extent.begin < end
                                             : extent.begin < begin && begin <= extent.end && begin < text_.size();
            if (touched && !(begin <= extent.begin && extent.end <= end))
                return word == "define" ? "the change is in a macro (#define), where no #if can be"
                                        : fmt::format("the change is in a directive (#{}), where no #if can be", word);
            if (word == "version" && end <= extent.begin) return "the change is before #version, where no #if can be";
        }
        return {};
    }

    // Sorted; regions that meet are one.
    std::vector<TwiceThere> regions(const std::vector<const Edit*>& edits) const {
        std::vector<TwiceThere> all;
        for (const Edit* edit : edits) {
            const Extent lines = lines_of(*edit);
            if (all.empty() || lines.begin > all.back().lines.end) {
                all.push_back({lines, {edit}});
                continue;
            }
            // A region before this one may begin after it, for statements grow to both sides.
            TwiceThere& last = all.back();
            last.edits.push_back(edit);
            last.lines = {std::min(last.lines.begin, lines.begin), std::max(last.lines.end, lines.end)};
            while (all.size() > 1 && all.back().lines.begin <= all[all.size() - 2].lines.end) {
                TwiceThere later = std::move(all.back());
                all.pop_back();
                all.back().edits.insert(all.back().edits.end(), later.edits.begin(), later.edits.end());
                all.back().lines.begin = std::min(all.back().lines.begin, later.lines.begin);
                all.back().lines.end = std::max(all.back().lines.end, later.lines.end);
            }
        }
        return all;
    }

    std::string_view text() const { return text_; }

private:
    std::size_t start_at(std::size_t place) const {
        return *std::prev(std::upper_bound(divisions_.starts.begin(), divisions_.starts.end(), place));
    }
    std::size_t end_from(std::size_t place) const {
        const auto start = std::lower_bound(divisions_.starts.begin(), divisions_.starts.end(), place);
        return start == divisions_.starts.end() ? text_.size() : *start;
    }
    bool within_statement(std::size_t place) const {
        return ranges::any_of(divisions_.statements, [&](const Extent& s) { return s.begin < place && place < s.end; });
    }

    Extent lines_of(const Edit& edit) const {
        const std::size_t begin = edit.span.begin, end = edit.span.end;
        const bool inserted = begin == end;
        if (inserted && start_at(begin) == begin && (ends_line(edit.text) || begin == text_.size()) &&
            !within_statement(begin))
            return {begin, begin};
        Extent lines{start_at(begin), end_from(inserted ? std::min(begin + 1, text_.size()) : end)};
        for (bool grown = true; grown;) {
            grown = false;
            for (const Extent& statement : divisions_.statements) {
                if (statement.begin >= lines.end || statement.end <= lines.begin) continue;
                const Extent more{std::min(lines.begin, start_at(statement.begin)),
                                  std::max(lines.end, end_from(statement.end))};
                grown = grown || more.begin < lines.begin || more.end > lines.end;
                lines = more;
            }
        }
        return lines;
    }

    std::string_view text_;
    std::string clean_;
    glsl::Divisions divisions_;
};

std::string doubled(std::string_view text, const TwiceThere& region, const std::string& ladder,
                    const std::string& rung) {
    const std::string_view line_end = line_end_of(text);
    const std::string_view mine = text.substr(region.lines.begin, region.lines.end - region.lines.begin);
    const std::string found = edited(text, region);
    std::string result = fmt::format("#if {0} == {0}_{1}{2}", ladder, found.empty() ? "as_written" : rung, line_end);
    const auto add = [&](std::string_view lines) {
        result += lines;
        if (!ends_line(lines)) result += line_end;
    };
    if (!found.empty()) add(found);
    if (!found.empty() && !mine.empty()) result.append("#else").append(line_end);
    if (!mine.empty()) add(mine);
    result += "#endif";
    if (mine.empty() || ends_line(mine)) result += line_end;
    return result;
}

std::string plain_path(std::string_view path) { return std::filesystem::path(path).lexically_normal().string(); }

// The beginning of the line of the last statement that begins at `place` or before it, or of the first one.
std::size_t statement_start(std::string_view text, FileId file, std::size_t place) {
    Report unheard(0);
    StatementReader reader(text, file, unheard);
    std::size_t at = text.size();
    bool first = true;
    for (Statement statement; reader.next(statement) && (first || statement.command().begin <= place); first = false)
        at = statement.command().begin;
    while (at > 0 && text[at - 1] != '\n' && text[at - 1] != '\r') --at;
    return at;
}

class Maker {
public:
    Maker(const Plan& plan, Files& files, const Sources& sources, FileId scene)
        : plan_(plan), sources_(sources), scene_(scene) {
        for (const PlannedProgram& program : plan.programs) {
            uses_.emplace_back();
            for (const ShaderText& shader : shader_texts(program, sources, files)) {
                uses_.back().insert(plain_path(shader.path));
                texts_.push_back(shader.text);
            }
        }
        for (const Ladder& ladder : plan.scene.ladders) names_.insert(ladder.name);
    }

    AsLadders make(std::span<const Chosen> chosen) {
        exclude_repeated(chosen);
        for (const Chosen& one : chosen) {
            if (!made_.error.empty()) return std::move(made_);
            add(one);
        }
        exclude_overlaps(chosen);
        if (made_.error.empty()) add_statements();
        return std::move(made_);
    }

private:
    struct Doubled {
        FileId file;
        Extent lines;
        std::size_t of;  // which of the chosen ones
    };

    void refuse(std::string error, std::string help, std::optional<Span> where = std::nullopt) {
        if (made_.error.empty()) made_.error = std::move(error), made_.help = std::move(help), made_.where = where;
    }

    void exclude_repeated(std::span<const Chosen> chosen) {
        std::set<std::size_t> seen;
        for (const Chosen& one : chosen)
            for (std::size_t i = 0; i < one.numbers.size(); ++i)
                if (!seen.insert(one.numbers[i]).second)
                    refuse(fmt::format("{} is given twice, and a change can be in one ladder only", one.numbers[i]),
                           "leave out one of them", one.changes[i].where);
    }

    void add(const Chosen& one) {
        const std::string name = chosen_name(one);
        std::map<FileId, std::vector<const Edit*>> by_file;
        for (const Change& change : one.changes)
            for (const Edit& edit : change.edits) by_file[edit.span.file].push_back(&edit);
        const std::string ladder = free_name("FOUND_" + chosen_name(one, "_"));
        const auto rung = add_statement(one, ladder);
        for (auto& [file, edits] : by_file) {
            if (!used_by_a_program(file))
                refuse(
                    fmt::format("{} changes the scene's text, and a ladder chooses among lines of shaders only", name),
                    fmt::format("--apply {} writes the scene with this change", name), edits.front()->span);
            if (!made_.error.empty()) return;
            std::sort(edits.begin(), edits.end(), [](const Edit* a, const Edit* b) {
                return std::pair(a->span.begin, a->span.end) < std::pair(b->span.begin, b->span.end);
            });
            double_lines(file, edits, name, ladder, rung);
        }
    }

    void double_lines(FileId file, const std::vector<const Edit*>& edits, const std::string& name,
                      const std::string& ladder, const std::string& rung) {
        const Doubler doubler(sources_.text(file));
        const std::string help = fmt::format("--apply {} writes the shader with this change", name);
        for (const Edit* edit : edits)
            if (std::string wrong = doubler.refusal(*edit); !wrong.empty())
                return refuse(fmt::format("{} can't be a ladder: {}", name, wrong), help, edit->span);
        for (const TwiceThere& region : doubler.regions(edits)) {
            const auto [begin, end] = region.lines;
            if (!whole_groups(doubler.text().substr(begin, end - begin)) ||
                !whole_groups(edited(doubler.text(), region)))
                return refuse(fmt::format("{} can't be a ladder: its lines have one end of a group of #if … #endif, "
                                          "and not the other one",
                                          name),
                              help, region.edits.front()->span);
            const Span span{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
            made_.change.edits.push_back({span, doubled(doubler.text(), region, ladder, rung)});
            doubled_.push_back({file, region.lines, made_.statements.size() - 1});
        }
    }

    // Returns the name of the rung.
    std::string add_statement(const Chosen& one, const std::string& ladder) {
        const auto better = ranges::count(one.changes, Aim::better, [](const Change& c) { return facts(c.kind).aim; });
        if (better != 0 && better != static_cast<std::ptrdiff_t>(one.changes.size()))
            refuse(fmt::format("{} makes the picture both cheaper and better, and a ladder goes from cheap to exact",
                               chosen_name(one)),
                   fmt::format("write --as-ladder {} for a ladder each", chosen_name(one, ",")));
        std::string rung = one.changes.size() == 1 ? std::string(facts(one.changes.front().kind).name) : "changed";
        std::replace(rung.begin(), rung.end(), '-', '_');
        made_.statements.push_back(better != 0 ? fmt::format("Ladder {} <as_written> {}", ladder, rung)
                                               : fmt::format("Ladder {} {} <as_written>", ladder, rung));
        return rung;
    }

    // A name that neither the scene nor a shader has.
    std::string free_name(const std::string& wanted) {
        const auto taken = [&](const std::string& name) {
            return names_.contains(name) || ranges::any_of(texts_, [&](std::string_view text) {
                       return text.find(name) != std::string_view::npos;
                   });
        };
        std::string name = wanted;
        for (int i = 2; taken(name); ++i) name = fmt::format("{}_v{}", wanted, i);
        names_.insert(name);
        return name;
    }

    bool used_by_a_program(FileId file) {
        bool used = false;
        for (std::size_t i = 0; i < uses_.size(); ++i)
            if (uses_[i].contains(plain_path(sources_.name(file)))) used = true, programs_.insert(i);
        return used;
    }

    static bool can_join(const Chosen& one, const Chosen& other) {
        return !ranges::any_of(one.changes, [&](const Change& a) {
            return ranges::any_of(other.changes, [&](const Change& b) { return !compatible(a, b); });
        });
    }

    void exclude_overlaps(std::span<const Chosen> chosen) {
        for (std::size_t b = 1; b < doubled_.size(); ++b)
            for (std::size_t a = 0; a < b; ++a) {
                const Doubled &one = doubled_[a], &other = doubled_[b];
                if (one.of == other.of || one.file != other.file) continue;
                const bool empty = one.lines.begin == one.lines.end || other.lines.begin == other.lines.end;
                const bool meet = empty ? one.lines.begin <= other.lines.end && other.lines.begin <= one.lines.end
                                        : one.lines.begin < other.lines.end && other.lines.begin < one.lines.end;
                if (!meet) continue;
                const std::string first = chosen_name(chosen[one.of]), second = chosen_name(chosen[other.of]);
                refuse(fmt::format("{} and {} change the same lines, so they can't be two ladders", first, second),
                       can_join(chosen[one.of], chosen[other.of])
                           ? fmt::format("write --as-ladder {}+{} for one ladder of both, or one after the other",
                                         first, second)
                           : "",
                       Span{other.file, static_cast<std::uint32_t>(other.lines.begin),
                            static_cast<std::uint32_t>(other.lines.end)});
            }
    }

    // Before all programs that the ladders are for: a program knows only the ladders before it.
    void add_statements() {
        const std::string_view text = sources_.text(scene_);
        std::size_t place = text.size();
        bool here = true;  // all of them are in the scene's own text
        const auto note = [&](const Span& span) {
            here = here && span.file == scene_;
            place = std::min<std::size_t>(place, span.begin);
        };
        for (const std::size_t index : programs_) {
            note(plan_.scene.programs[plan_.programs[index].program].span);
            for (const glsl::StageInput& stage : plan_.programs[index].stages) note(stage.reference);
        }
        place = statement_start(text, scene_, here ? place : 0);
        std::string lines;
        for (const std::string& statement : made_.statements) lines.append(statement).append(line_end_of(text));
        const auto at = static_cast<std::uint32_t>(place);
        made_.change.edits.insert(made_.change.edits.begin(), {{scene_, at, at}, lines});
    }

    const Plan& plan_;
    const Sources& sources_;
    FileId scene_;
    std::vector<std::set<std::string>> uses_;  // for each program, the shaders that it reads
    std::vector<std::string_view> texts_;      // of all shaders
    std::set<std::string> names_;              // of ladders
    std::set<std::size_t> programs_;           // those whose shaders change
    std::vector<Doubled> doubled_;
    AsLadders made_;
};

}  // namespace

AsLadders as_ladders(const Plan& plan, Files& files, const Sources& sources, FileId scene,
                     std::span<const Chosen> chosen) {
    return Maker(plan, files, sources, scene).make(chosen);
}

}  // namespace snell::accuracy
