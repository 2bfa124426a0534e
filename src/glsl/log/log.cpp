// Drivers' logs as diagnostics at the user's own lines.
#include "src/glsl/log/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "src/glsl/read/words.h"

namespace snell::glsl {
namespace {

using log::Context;
using log::Entry;
using log::Place;

// The number of independent mistakes shown for one shader: students fix a few and try again.
constexpr std::size_t most_errors = 6;

struct Found {
    Entry entry;
    Place place;
};

bool is_syntax(log::Kind kind) {
    return kind == log::Kind::syntax || kind == log::Kind::end_of_file || kind == log::Kind::if_unfinished;
}

bool same_line(const Found& x, const Found& y) {
    return x.place.known && y.place.known && x.place.file == y.place.file && x.place.line == y.place.line;
}

// Whether no word that ends a statement stands between the two.
bool same_statement(const Found& x, const Found& y, const Context& context) {
    if (!x.place.known || !y.place.known || x.place.file != y.place.file) return false;
    const auto [first, last] = std::minmax(x.place.line, y.place.line);
    const auto [begin, end] = std::minmax(x.place.span.begin, y.place.span.begin);
    const std::string_view text = context.sources.text(x.place.file);
    for (int line = first; line <= last; ++line)
        for (const log::Word& word : context.texts.on_line(x.place.file, line)) {
            if (word.begin < begin || word.begin >= end) continue;
            const std::string_view w = log::text_of(text, word);
            if (word.directive || w == ";" || w == "{" || w == "}") return false;
        }
    return true;
}

bool about_names(const Found& found) {
    return found.entry.kind == log::Kind::undeclared || found.entry.kind == log::Kind::no_function;
}

// Drivers report these kinds for expressions that contain another error.
bool is_consequence(const Found& found) { return !about_names(found) && found.entry.kind != log::Kind::redeclared; }

bool is_consequence_of(const Found& later, const Found& cause, const Context& context) {
    return is_consequence(later) && (same_line(later, cause) || same_statement(later, cause, context));
}

// Whether `later` would vanish if `cause` were mended.
bool follows(const Found& later, const Found& cause, const Context& context) {
    if (later.entry.stage != cause.entry.stage) return false;
    if (is_syntax(cause.entry.kind) && later.entry.string >= 0) return true;
    if (later.entry.kind == log::Kind::redeclared && cause.entry.kind == later.entry.kind &&
        context.sources.name(later.place.file) == context.sources.name(cause.place.file) &&
        context.twice(cause.place.file))
        return true;
    if (about_names(later)) return later.entry.kind == cause.entry.kind && later.entry.a == cause.entry.a;
    if (is_consequence_of(later, cause, context)) return true;
    return later.entry.text == cause.entry.text && later.entry.string < 0;
}

// A variable declared on a line with an error: what is wrong with it later may come from there.
std::set<std::string_view> doubtful_names(const Found& cause, log::Texts& texts) {
    std::set<std::string_view> names;
    if (!cause.place.known) return names;
    for (const log::Declared& d : texts.declared(cause.place.file))
        if (d.line == cause.place.line) names.insert(d.name);
    return names;
}

std::string told_of(const Entry& entry, std::string_view program) {
    if (entry.stage) return fmt::format(" ({} shader of '{}')", stage_name(*entry.stage), program);
    return fmt::format(" (program '{}')", program);
}

// What our own reading of the shader knows of the operands, or of the value, that the driver refused on this line.
const Misfit* misfit_of(const Found& found, const Context& context) {
    const std::string_view text = found.entry.text;
    const bool assigned = found.entry.kind == log::Kind::convert && found.entry.a.empty();
    const bool operands = found.entry.kind == log::Kind::operands || found.entry.kind == log::Kind::condition ||
                          text.find("operator") != text.npos || text.find("operand") != text.npos ||
                          text.find("HS of ") != text.npos;
    if ((!operands && !assigned) || !context.stage || !found.place.known) return nullptr;
    const Misfit* best = nullptr;
    for (const Misfit& m : context.stage->misfits) {
        if (m.span.file != found.place.file || m.op == "=" || (m.op == ":=") != assigned) continue;
        const int first = context.sources.position(m.span.file, m.span.begin).line;
        const int last = context.sources.position(m.span.file, m.span.end).line;
        if (found.place.line < first || found.place.line > last) continue;
        const bool here = m.span.begin <= found.place.span.begin && found.place.span.begin <= m.span.end;
        if (!best || here) best = &m;
        if (here) break;
    }
    return best;
}

Diagnostic explain(const Found& found, const Context& context, std::string_view program) {
    Diagnostic diagnostic;
    diagnostic.severity = found.entry.severity;
    if (const Misfit* misfit = misfit_of(found, context)) {
        diagnostic.code = log::words_of(misfit->op == ":=" ? log::Kind::convert : log::Kind::operands).code;
        diagnostic.span = misfit->span;
        diagnostic.message = log::message(*misfit) + told_of(found.entry, program);
        diagnostic.help = log::help(*misfit);
        return diagnostic;
    }
    diagnostic.code = log::words_of(found.entry.kind).code;
    diagnostic.span = found.place.span;
    diagnostic.message = log::message(found.entry, found.place, context) + told_of(found.entry, program);
    log::hint(found.entry, found.place, context, diagnostic);
    return diagnostic;
}

struct Mistake {
    Found cause;
    std::set<std::string_view> doubtful;
    std::vector<Found> rest;
};

std::vector<Mistake> folded(const std::vector<Found>& all, const Context& context) {
    std::vector<Mistake> groups;
    for (const Found& found : all) {
        const auto caused_by = [&](const Mistake& group) {
            if (follows(found, group.cause, context)) return true;
            const auto beside = [&](const Found& other) { return is_consequence_of(found, other, context); };
            if (std::any_of(group.rest.begin(), group.rest.end(), beside)) return true;
            return found.entry.kind == log::Kind::undeclared && !found.entry.a.empty() &&
                   group.doubtful.contains(found.entry.a);
        };
        const auto group = std::find_if(groups.begin(), groups.end(), caused_by);
        if (group == groups.end()) {
            groups.push_back({found, doubtful_names(found, context.texts), {}});
        } else {
            group->rest.push_back(found);
        }
    }
    return groups;
}

}  // namespace

void explain_log(std::string_view log, const Translation& translation, const StageOutput* stage, Span where,
                 std::string_view program, const Sources& sources, Diagnostics& diagnostics, Lines lines) {
    log::Texts texts(sources);
    const Context context{translation, stage, where, sources, texts};
    std::vector<Found> errors, warnings;
    for (Entry& entry : log::read(log)) {
        auto& list = entry.severity == Severity::error ? errors : warnings;
        if (stage) entry.stage = stage->stage;
        if (stage && lines == Lines::unnumbered) log::number(entry, stage->text);
        const Place place = log::place(entry, context);
        if (stage && entry.string >= 0) entry.stage = stage->stage_of(static_cast<std::size_t>(entry.string));
        list.push_back({std::move(entry), place});
    }
    const std::vector<Mistake> groups = folded(errors, context);
    for (std::size_t i = 0; i < groups.size() && i < most_errors; ++i) {
        Diagnostic diagnostic = explain(groups[i].cause, context, program);
        if (!groups[i].rest.empty())
            diagnostic.notes.push_back(
                {groups[i].rest.front().place.span,
                 fmt::format("and {} more that may come from the same mistake", groups[i].rest.size())});
        if (i + 1 == most_errors && groups.size() > most_errors)
            diagnostic.notes.push_back(
                {groups[i + 1].cause.place.span, fmt::format("and {} more errors", groups.size() - most_errors)});
        diagnostics.add(std::move(diagnostic));
    }
    if (!errors.empty()) return;  // warnings about a shader that does not compile only distract
    for (const Found& found : warnings) diagnostics.add(explain(found, context, program));
}

}  // namespace snell::glsl
