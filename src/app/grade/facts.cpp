#include "src/app/grade/judge.h"

#include <fmt/format.h>

#include "parser/commands/commands.h"
#include "parser/read/syntax.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/lint/lint.h"

namespace snell::app {

namespace {

using Kind = RubricItem::Kind;

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, "; ")); }

// A share of the points for what is right.
Judged shared_points(const RubricItem& item, std::size_t wrong, std::size_t of, const std::vector<std::string>& why) {
    const double share = of > 0 ? static_cast<double>(of - wrong) / static_cast<double>(of) : 1;
    return {item.points * share, wrong == 0, joined(why)};
}

Judged judge_errors(const RubricItem& item, const Document& document) {
    const std::size_t errors = document.diagnostics.errors();
    if (errors == 0) return {item.points, true, "there are no errors"};
    return {0, false, fmt::format("there {} {}", errors == 1 ? "is" : "are", counted(errors, "error"))};
}

Judged judge_lints(const RubricItem& item, const Document& document) {
    std::vector<std::string> found;
    for (const std::string& code : item.names)
        if (ranges::count(document.diagnostics.items(), code, &Diagnostic::code) > 0) found.push_back(code);
    if (found.empty()) return {item.points, true, "nothing was found"};
    const double lost = item.each ? *item.each * static_cast<double>(found.size()) : item.points;
    return {std::max(0., item.points - lost), false, fmt::format("found: {}", fmt::join(found, ", "))};
}

bool has_uniform(const Document& document, std::string_view name) {
    return ranges::any_of(document.controls.items, [&](const snell::Control& c) { return c.name == name; });
}

std::string own_name(const std::string& name, const Rubric& rubric, const Document& document) {
    if (has_uniform(document, name)) return name;
    if (const auto aliases = rubric.aliases.find(name); aliases != rubric.aliases.end())
        for (const std::string& alias : aliases->second)
            if (has_uniform(document, alias)) return alias;
    return name;
}

// "" or what is wrong with it.
std::string missing(const NeededUniform& needed, const Rubric& rubric, const Document& document) {
    const std::string name = own_name(needed.name, rubric, document);
    if (!has_uniform(document, name)) {
        std::vector<std::string_view> names;
        for (const snell::Control& control : document.controls.items) names.push_back(control.name);
        const std::string_view near = nearest(needed.name, names);
        return fmt::format("there is no uniform '{}'{}", needed.name,
                           near.empty() ? "" : fmt::format(", but '{}'", near));
    }
    std::string wrong;
    for (const snell::Control& control : document.controls.items) {
        if (control.name != name) continue;
        const std::string type = type_of(document, control);
        if (type.empty())
            wrong = fmt::format("no shader uses '{}'", name);
        else if (!needed.type.empty() && type != needed.type)
            wrong =
                fmt::format("'{}' is {} {}, not {} {}", name, article(type), type, article(needed.type), needed.type);
        else if ((needed.least || needed.most) && control.widget == Widget::none)
            wrong = fmt::format("'{}' has no slider", name);
        else if ((needed.least && control.min > *needed.least) || (needed.most && control.max < *needed.most))
            wrong = fmt::format("the slider of '{}' goes from {} to {}, not{}{}", name, control.min, control.max,
                                needed.least ? fmt::format(" from {}", *needed.least) : "",
                                needed.most ? fmt::format(" to {}", *needed.most) : "");
        else
            return {};
    }
    return wrong;
}

Judged judge_uniforms(const RubricItem& item, const Rubric& rubric, const Document& document) {
    std::vector<std::string> why;
    for (const NeededUniform& needed : item.uniforms)
        if (std::string wrong = missing(needed, rubric, document); !wrong.empty()) why.push_back(std::move(wrong));
    Judged judged = shared_points(item, why.size(), item.uniforms.size(), why);
    if (judged.passed) judged.why = "all uniforms are as they should be";
    return judged;
}

Judged judge_commands(const RubricItem& item, const UsedCommands& commands) {
    const bool needed = item.kind == Kind::needs;
    std::vector<std::string> right, wrong;
    for (const std::string& name : item.names) {
        const Command* command = find_command(name);
        const auto used = commands.find(command ? std::string(command->name) : name);
        const bool is_used = used != commands.end();
        (is_used == needed ? right : wrong)
            .push_back(is_used ? fmt::format("it uses {} ({})", name, used->second)
                               : fmt::format("it does not use {}", name));
    }
    const std::size_t of = needed ? item.names.size() : std::min<std::size_t>(wrong.size(), 1);
    return shared_points(item, needed ? wrong.size() : of, of, wrong.empty() ? right : wrong);
}

bool tries_every_value(const snell::Control& slider) {
    return slider.type == ValueType::bool_ || slider.type == ValueType::int_ || slider.type == ValueType::uint_;
}

std::string tried_values(const snell::Control& slider) {
    if (slider.type == ValueType::bool_) return "for false and true";
    return fmt::format("for {} from {} to {}", tries_every_value(slider) ? "every value" : "all tried values",
                       slider.min, slider.max);
}

}  // namespace

std::string type_of(const Document& document, const snell::Control& control) {
    const auto& all = document.runtime->active_uniforms()[control.program];
    const auto found = ranges::find(all, control.name, &ActiveUniform::name);
    return found == all.end() ? "" : found->glsl_type;
}

UsedCommands used_commands(const std::string& scene, const Access& access) {
    Files files(scene_folder(scene), access);
    Sources sources;  // only scenes: no plan is made, which would read shaders
    Diagnostics unheard(access.limits);
    UsedCommands used;
    if (!parse_document(scene, files, sources, unheard)) return used;
    for (std::size_t file = 0; file < sources.size(); ++file) {
        Collector report(1);
        const auto id = static_cast<FileId>(file);
        StatementReader reader(sources.text(id), id, report);
        Statement statement;
        while (reader.next(statement))
            if (const Command* command = find_command(reader.lexer().text(statement.command())))
                used.emplace(command->name, fmt::format("{}:{}", utf8::printable(sources.name(id)),
                                                        sources.position(id, statement.command().begin).line));
    }
    return used;
}

Judged judge_text(const RubricItem& item, const Rubric& rubric, const Document& document,
                  const UsedCommands& commands) {
    switch (item.kind) {
        case Kind::no_errors:
            return judge_errors(item, document);
        case Kind::no_lints:
            return judge_lints(item, document);
        case Kind::uniforms:
            return judge_uniforms(item, rubric, document);
        default:
            return judge_commands(item, commands);
    }
}

Judged judge_counters(const RubricItem& item, const Counters& counters) {
    std::vector<std::string> told;
    std::size_t wrong = 0;
    for (const Bounds& bounds : item.counters)
        for (const CounterName& counter : counter_names()) {
            if (counter.name != bounds.counter) continue;
            const auto value = static_cast<double>(counters.*counter.value);
            const bool low = bounds.least && value < *bounds.least, high = bounds.most && value > *bounds.most;
            wrong += low || high;
            std::string text = fmt::format("{} {}", counter.name, value);
            if (low) text += fmt::format(", at least {} expected", *bounds.least);
            if (high) text += fmt::format(", at most {} allowed", *bounds.most);
            told.push_back(std::move(text));
        }
    return {wrong == 0 ? item.points : 0, wrong == 0, joined(told)};
}

std::set<std::string> uniforms_of(const Scene& scene, const Rubric& rubric) {
    std::set<std::string> asked, found;
    for (const RubricItem& item : rubric.items)
        for (const RubricItem* part : item.parts())
            for (const NeededUniform& needed : part->uniforms) asked.insert(needed.name);
    for (const Shown& shown : rubric.pictures)
        for (const std::string& set : shown.sets) asked.insert(set.substr(0, set.find('=')));
    const auto sets = [&scene](const std::string& name) {
        return ranges::any_of(scene.programs, [&](const Program& program) {
            return ranges::find(program.uniforms, name, &UniformValue::name) != program.uniforms.end();
        });
    };
    const auto has = [&](const std::string& name) {
        const auto aliases = rubric.aliases.find(name);
        return sets(name) || (aliases != rubric.aliases.end() && ranges::any_of(aliases->second, sets));
    };
    for (const std::string& name : asked)
        if (has(name) || has(name.substr(name.find('.') + 1))) found.insert(name);  // behind a program's name
    return found;
}

std::string with_aliases(const std::string& assignment, const Rubric& rubric, const Document& document) {
    const std::size_t equals = std::min(assignment.find('='), assignment.size());
    const std::string name = assignment.substr(0, equals);
    std::string own = own_name(name, rubric, document);
    // What is ahead of a dot is a program's name, or a structure's.
    if (const std::size_t behind = name.find('.') + 1; own == name && behind > 0)
        own = name.substr(0, behind) + own_name(name.substr(behind), rubric, document);
    return own + assignment.substr(equals);
}

void add_idle_sliders(Document& document, double seconds) {
    if (!document.runtime || document.diagnostics.has_errors() || lint::may_not_end(document.diagnostics)) return;
    const lint::RuleFacts& rule = lint::facts(lint::Rule::slider_without_effect);
    for (const snell::Control* slider : document.runtime->without_effect(seconds)) {
        const Program& program = document.scene().programs[slider->program];
        const std::string_view where = program.ladders > 0 ? "with these rungs, " : "";
        document.diagnostics.warning(rule.code, slider->span,
                                     fmt::format("'{}' {} no effect: {}program '{}' computes the same {}", slider->name,
                                                 tries_every_value(*slider) ? "has" : "seems to have", where,
                                                 program.name, tried_values(*slider)),
                                     fmt::format("{} ({})", rule.instead, lint::more(rule)));
    }
}

}  // namespace snell::app
