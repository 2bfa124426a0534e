#include "src/accuracy/found/texts/texts.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "parser/commands/commands.h"
#include "parser/read/builder.h"
#include "parser/read/syntax.h"
#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "src/accuracy/found/change.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/preprocess.h"
#include "src/glsl/read/words.h"
#include "src/plan/identity.h"
#include "src/plan/locate.h"
#include "src/plan/texts.h"

namespace snell::accuracy::texts {

namespace {

bool by_place(const Edit& a, const Edit& b) {
    return std::tuple(a.span.file, a.span.begin, a.span.end) < std::tuple(b.span.file, b.span.begin, b.span.end);
}

// Edits that touch become one, so that their order is certain. Returns false if some overlap.
bool join_neighbours(std::vector<Edit>& edits) {
    std::vector<Edit> joined;
    for (Edit& edit : edits) {
        const bool follows = !joined.empty() && joined.back().span.file == edit.span.file;
        if (follows && edit.span.begin < joined.back().span.end) return false;
        if (follows && edit.span.begin == joined.back().span.end) {
            joined.back().span.end = edit.span.end;
            joined.back().text += edit.text;
        } else {
            joined.push_back(std::move(edit));
        }
    }
    edits = std::move(joined);
    return true;
}

}  // namespace

Collector::Collector(const Files& files, const Sources& sources, std::vector<Change>& changes, std::size_t most)
    : sources_(sources), changes_(changes), left_(most) {
    for (std::string& path : files.read_paths()) names_.insert(std::move(path));
}

Span Collector::first_reading(Span span) const {
    return {accuracy::first_reading(span.file, sources_), span.begin, span.end};
}

// The text at the span with those edits that are within it.
std::string Collector::edited(Span span, const std::vector<Edit>& edits) const {
    std::string made;
    std::uint32_t at = span.begin;
    const std::string_view file = sources_.text(span.file);
    for (const Edit& edit : edits) {
        if (edit.span.file != span.file || edit.span.begin < at || edit.span.end > span.end) continue;
        made.append(file.substr(at, edit.span.begin - at)).append(edit.text);
        at = edit.span.end;
    }
    return made.append(file.substr(at, span.end - at));
}

bool Collector::add(ChangeKind kind, Span where, std::vector<Edit> edits, std::string_view lint,
                    const std::vector<Span>& more) {
    if (full()) return false;
    Change change;
    change.kind = kind;
    change.where = first_reading(where);
    change.lint = lint;
    for (Edit& edit : edits) {
        edit.span = first_reading(edit.span);
        if (!author(edit.span.file)) return false;
        if (text(edit.span) != edit.text) change.edits.push_back(std::move(edit));
    }
    ranges::stable_sort(change.edits, by_place);
    change.edits.erase(std::unique(change.edits.begin(), change.edits.end()), change.edits.end());
    if (change.edits.empty() || !join_neighbours(change.edits)) return false;
    if (ranges::any_of(changes_, [&](const Change& other) { return other.edits == change.edits; })) return false;
    std::string before(text(change.where)), after = edited(change.where, change.edits);
    for (const Span& further : more) {
        before.append("; ").append(text(further));
        after.append("; ").append(edited(first_reading(further), change.edits));
    }
    change.before = excerpt(before);
    change.after = excerpt(after);
    changes_.push_back(std::move(change));
    --left_;
    return true;
}

// ---- scenes -------------------------------------------------------------------------------------------------

namespace {

void read_statements(FileId file, const Files& files, const Sources& sources, std::set<std::string_view>& seen,
                     std::vector<Statement>& all) {
    if (!seen.insert(sources.name(file)).second) return;
    snell::Collector unheard(0);  // parsing reported what is wrong
    StatementReader reader(sources.text(file), file, unheard);
    snell::Statement read;
    while (reader.next(read)) {
        Statement statement;
        const Command* command = find_command(reader.lexer().text(read.command()));
        if (command) statement.command = command->name;
        statement.span = reader.span(read);
        statement.name = reader.lexer().span(read.command());
        for (const Token& token : read.arguments()) {
            if (token.kind == TokenKind::word || token.kind == TokenKind::text)
                statement.arguments.push_back(reader.lexer().span(token));
            statement.bracketed =
                statement.bracketed || token.kind == TokenKind::open || token.kind == TokenKind::close;
        }
        all.push_back(statement);
        if (statement.command != "Include" || statement.arguments.empty()) continue;
        const Span name = statement.arguments.front();
        std::string written = file_name(sources.text(file).substr(name.begin, name.end - name.begin));
        std::erase(written, '"');
        const std::string path =
            files.resolve_beside(std::string(sources.name(file)), written, scene_extensions()).path;
        for (FileId other = 0; other < sources.size(); ++other)
            if (!path.empty() && sources.name(other) == path) {
                read_statements(other, files, sources, seen, all);
                break;
            }
    }
}

}  // namespace

std::vector<Statement> statements(const Files& files, const Sources& sources) {
    std::vector<Statement> all;
    std::set<std::string_view> seen;
    if (sources.size() > 0) read_statements(0, files, sources, seen, all);
    return all;
}

const Statement* statement_at(const std::vector<Statement>& all, Span place) {
    const auto found = ranges::find_if(
        all, [&](const Statement& s) { return s.span.file == place.file && s.span.begin == place.begin; });
    return found == all.end() ? nullptr : &*found;
}

bool is_there(const Scene& scene, Index texture, const Files& files) {
    return !texture_identity(scene, texture, files).key.empty();
}

std::string_view line_end(std::string_view text) { return text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n"; }

// ---- shaders ------------------------------------------------------------------------------------------------

Reading::Reading(const Plan& plan_read, Files& its_files, Sources& its_sources)
    : plan(plan_read), files(its_files), sources(its_sources) {
    std::map<std::string, std::size_t> known;  // by text, stage and macros
    for (const PlannedProgram& planned : plan.programs) {
        if (!planned.readable || planned.stages.empty()) continue;
        const Program& program = plan.scene.programs[planned.program];
        glsl::Options options;
        options.include = shader_includes(files);
        options.limits = files.limits();
        options.geometry_input = program.geometry_input;
        options.geometry_output = program.geometry_output;
        options.defines = ladder_defines(
            std::span(plan.scene.ladders).first(std::min(program.ladders, plan.scene.ladders.size())), plan.rungs);
        std::string macros;
        for (const glsl::Define& define : options.defines) macros += "\n" + define.name + " " + define.value;
        for (const glsl::StageInput& stage : planned.stages) {
            const std::string key =
                std::to_string(static_cast<int>(stage.stage)) + std::string(sources.name(stage.file)) + macros;
            const auto [at, fresh] = known.emplace(key, shaders.size());
            if (fresh) {
                Shader& shader = shaders.emplace_back();
                glsl::Unit& unit = shader.unit;
                unit.stage = stage.stage;
                unit.reference = stage.reference;
                Diagnostics unheard;  // compiling reports them
                glsl::preprocess(unit, stage.file, sources, options, unheard);
                unit.tree = &shader.tree;
                glsl::Parser(unit, options.target, unheard).run();
                shader.bodies = bodies(unit);
            }
            shaders[at->second].programs.push_back(planned.program);
        }
    }
}

std::optional<Span> span_of(const glsl::Unit& unit, const Collector& to, int first, int last) {
    if (first < 0 || last < first || last >= static_cast<int>(unit.tokens.size())) return std::nullopt;
    const glsl::Token &a = unit.at(first), &b = unit.at(last);
    if (a.macro >= 0 || b.macro >= 0 || a.file != b.file || b.offset < a.offset) return std::nullopt;
    const Span span{unit.span(first).file, unit.span(first).begin, unit.span(last).end};
    if (!to.author(span.file) || span.end > to.sources().text(span.file).size()) return std::nullopt;
    const std::string_view text = to.text(span);
    for (std::size_t line = text.find('\n'); line != text.npos; line = text.find('\n', line + 1)) {
        const std::size_t begin = text.find_first_not_of(" \t\r", line + 1);
        if (begin != text.npos && text[begin] == '#') return std::nullopt;
    }
    return to.first_reading(span);
}

const Body* body_around(const Shader& shader, int token) {
    const auto found = ranges::find_if(
        shader.bodies, [&](const Body& body) { return body.function->open < token && token < body.function->close; });
    return found == shader.bodies.end() ? nullptr : &*found;
}

const Piece* declaration_of(const Shader& shader, const Tree& name) {
    const Body* body = name.kind == Tree::Kind::name ? body_around(shader, name.first) : nullptr;
    if (!body) return nullptr;
    const auto found = body->certain.find(name.text);
    if (found == body->certain.end() || found->second < 0) return nullptr;
    const Piece& piece = body->pieces[static_cast<std::size_t>(found->second)];
    return piece.name_token < name.first ? &piece : nullptr;
}

const Tree& resolved(const Shader& shader, const Tree& tree) {
    const Tree* at = &bare(tree);
    for (int steps = 0; steps < 4; ++steps) {
        const Piece* piece = declaration_of(shader, *at);
        if (!piece) break;
        at = &bare(piece->value);
    }
    return *at;
}

std::optional<Edit> declared(const Shader& shader, const Collector& to, int token, std::string_view declaration) {
    const std::string_view name =
        declaration.substr(declaration.rfind(' ') + 1, declaration.size() - declaration.rfind(' ') - 2);
    const Body* body = body_around(shader, token);
    if (!body) return std::nullopt;
    const auto first = span_of(shader.unit, to, body->function->first, body->function->first);
    if (!first) return std::nullopt;
    if (ranges::find(shader.unit.globals, name, &glsl::Global::name) != shader.unit.globals.end())
        return before(*first, "");
    return before(*first, std::string(declaration) + std::string(line_end(to.sources().text(first->file))));
}

std::optional<Edit> included(const Shader& shader, const Collector& to, std::string_view file) {
    if (shader.unit.files.empty()) return std::nullopt;
    const FileId main = to.first_reading({shader.unit.files.front(), 0, 0}).file;
    for (const FileId other : shader.unit.files)
        if (to.sources().name(other) == file) return Edit{{main, 0, 0}, ""};
    const std::string_view text = to.sources().text(main), end = line_end(text);
    // Behind #version and #extension, which must be first.
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0, next = at;
    for (int line = 1; next < text.size(); ++line) {
        const std::size_t newline = text.find('\n', next);
        const std::string_view words = text.substr(next, std::min(newline, text.size()) - next);
        const std::size_t hash = words.find('#'), word = words.find_first_not_of(" \t#", hash == words.npos ? 0 : hash);
        const std::string_view name = word == words.npos ? "" : words.substr(word);
        next = newline == text.npos ? text.size() : newline + 1;
        const bool begins = words.find_first_not_of(" \t") == hash && hash != words.npos;
        if (begins && (name.starts_with("version") || name.starts_with("extension"))) at = next;
        if (line > shader.unit.version_line && !begins && word != words.npos && !name.starts_with("//")) break;
    }
    const bool open = at > 0 && text[at - 1] != '\n' && at != 3;
    const auto offset = static_cast<std::uint32_t>(at);
    return Edit{{main, offset, offset},
                std::string(open ? end : "") + "#include <" + std::string(file) + ">" + std::string(end)};
}

}  // namespace snell::accuracy::texts

namespace snell::accuracy {

namespace {

// What the edits do to the texts, however they are written: `x += 1.;` → `;` is `x += 1.` → nothing.
std::string effect(const Change& change, const Sources& sources) {
    std::string all = change.probes.empty() ? "" : "a number that is not known\n";
    for (const Edit& edit : change.edits) {
        std::string_view before = sources.text(edit.span.file).substr(edit.span.begin, edit.span.end - edit.span.begin),
                         after = edit.text;
        // A semicolon alone does nothing.
        if (before.ends_with(';') && (after.empty() || after == ";")) before.remove_suffix(1), after = {};
        all.append(sources.name(edit.span.file)).append("\n" + std::to_string(edit.span.begin) + "\n");
        all.append(std::to_string(before.size()) + "\n").append(after).append("\n");
    }
    return all;
}

// Of changes with the same effect, the first that makes the picture cheaper stays, or else the first.
void drop_repeated(std::vector<Change>& changes, const Sources& sources) {
    std::map<std::string, const Change*> kept;
    std::vector<std::string> effects;
    for (const Change& change : changes) {
        const Change*& known = kept[effects.emplace_back(effect(change, sources))];
        const auto cheaper = [](const Change& c) { return facts(c.kind).aim == Aim::cheaper; };
        if (!known || (cheaper(change) && !cheaper(*known))) known = &change;
    }
    std::vector<Change> left;
    for (std::size_t i = 0; i < changes.size(); ++i)
        if (kept[effects[i]] == &changes[i]) left.push_back(changes[i]);
    changes = std::move(left);
}

}  // namespace

std::vector<Change> find_changes(const Plan& plan, Files& files, Sources& sources) {
    std::vector<Change> changes;
    const texts::Reading reading(plan, files, sources);
    add_scene_changes(reading, changes);
    add_better_changes(reading, changes);
    add_shader_changes(plan, files, sources, changes);
    add_omissions(reading, changes);
    drop_repeated(changes, sources);
    // By names: the numbers of texts depend on what was compiled before.
    const auto key = [&](const Change& change) {
        const Span& at = change.where;
        return std::tuple(at.file == 0 ? std::string_view() : sources.name(at.file), at.begin, at.end, change.kind);
    };
    std::stable_sort(changes.begin(), changes.end(), [&](const Change& a, const Change& b) { return key(a) < key(b); });
    return changes;
}

}  // namespace snell::accuracy
