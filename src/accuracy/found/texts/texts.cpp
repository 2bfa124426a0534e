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
#include "src/plan/locate.h"
#include "src/plan/plan.h"
#include "src/plan/texts.h"

namespace snell::accuracy::texts {

namespace {

void read_statements(FileId file, const Files& files, const Sources& sources, std::set<std::string_view>& seen,
                     std::vector<Statement>& all) {
    if (!seen.insert(sources.name(file)).second) return;
    Collector unheard(0);  // parsing reported what is wrong
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

// ---- shaders ------------------------------------------------------------------------------------------------

std::optional<Edit> declared(const Shader& shader, int token, std::string_view declaration) {
    const std::string_view name =
        declaration.substr(declaration.rfind(' ') + 1, declaration.size() - declaration.rfind(' ') - 2);
    const auto place = shader.ahead_of(shader.function_of(token));
    if (!place) return std::nullopt;
    if (ranges::find(shader.unit.globals, name, &glsl::Global::name) != shader.unit.globals.end())
        return before(*place, "");
    return before(*place, std::string(declaration) + "\n");
}

std::optional<Edit> included(const Shader& shader, std::string_view file) {
    if (shader.files.empty()) return std::nullopt;
    const FileId main = shader.files.front();
    for (const FileId other : shader.files)
        if (shader.sources.name(other) == file) return Edit{{main, 0, 0}, ""};
    const std::string_view text = shader.sources.text(main);
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
    return Edit{{main, offset, offset}, (open ? "\n#include <" : "#include <") + std::string(file) + ">\n"};
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

// Whether all of the shaders' text that the change is in is never run, as with a function that another rung calls: such
// a change has no error and saves nothing, and what looks like a saving is noise.
bool is_idle(const Change& change, const Reading& reading) {
    bool idle = false;
    for (const Shader& shader : reading.shaders)
        for (int k = 0; k + 1 < static_cast<int>(shader.unit.tokens.size()); ++k) {
            const glsl::Token& token = shader.token(k);
            const auto touches = [&](const Edit& edit) {
                const Span& at = edit.span;
                return shader.files[token.file] == at.file && token.offset >= at.begin &&
                       (token.offset < at.end || token.offset == at.begin);
            };
            if (!ranges::any_of(change.edits, touches)) continue;
            if (shader.runs(k)) return false;
            idle = true;
        }
    return idle;
}

}  // namespace

std::vector<Change> find_changes(const Plan& plan, Files& files, Sources& sources) {
    std::vector<Change> changes;
    const Reading reading(plan, files, sources);
    add_scene_changes(reading, changes);
    add_better_changes(reading, changes);
    add_shader_changes(reading, changes);
    std::erase_if(changes, [&](const Change& change) { return is_idle(change, reading); });
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
