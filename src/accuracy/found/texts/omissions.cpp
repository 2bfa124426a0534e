// What can be left out of the scene and its shaders, to see whether any pixel depends on it.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"
#include "src/accuracy/found/texts/texts.h"

namespace snell::accuracy::texts {

namespace {

using glsl::Form;

constexpr std::size_t most_omissions = 200;
constexpr std::size_t most_list_statements = 2000;  // of one list of vertices

class Omissions : OfStatements {
public:
    Omissions(const Reading& reading, std::vector<Change>& changes) : OfStatements(reading, changes, most_omissions) {}

    void run() {
        for (const Draw& draw : scene_.draws)
            if (draw.program == none || whole(draw.program)) leave_out(draw);
        for (Index i = 0; i < scene_.textures.size(); ++i)
            if (!needed(i) && (scene_.textures[i].files.empty() || is_there(scene_, i, files_)))
                leave_out(ChangeKind::no_texture, scene_.textures[i].span);
        for (Index i = 0; i < scene_.programs.size(); ++i)
            for (const UniformValue& uniform : scene_.programs[i].uniforms)
                if (uniform.span.begin < uniform.span.end && whole(i))
                    to_.add(ChangeKind::no_uniform, uniform.span, without_uniform(uniform.span));
        for (const Shader& shader : shaders_)
            for (int n = 0; n < shader.nodes(); ++n)
                if (shader.at(n).form == Form::evaluated || shader.at(n).form == Form::declaration)
                    leave_out(shader, n);
    }

private:
    // Nothing is known about what a program draws that cannot be read.
    bool whole(Index program) const { return program < plan_.programs.size() && plan_.programs[program].readable; }

    // The text leaves nothing behind but its comments.
    Edit without(Span span) const {
        const std::string_view text = to_.text(span);
        std::string comments;
        for (std::size_t line = 0; line < text.size();) {
            const std::size_t end = std::min(text.find('\n', line), text.size());
            const std::string_view words = text.substr(line, end - line);
            const std::size_t first = words.find_first_not_of(" \t");
            if (line > 0 && first != words.npos && (words[first] == '#' || words.substr(first).starts_with("//")))
                comments.append(words).append("\n");
            line = end + 1;
        }
        return {span, std::move(comments)};
    }

    // A line of comment alone would be skipped, and the next statement would belong to the program: the backslash of
    // the line before goes, too, if the statement ends here.
    std::vector<Edit> without_uniform(Span span) const {
        std::vector<Edit> edits{without(span)};
        const std::string_view all = to_.sources().text(span.file);
        const std::size_t before = all.substr(0, span.begin).find_last_not_of(" \t\r\n");
        const std::string_view rest = all.substr(span.end, all.find_first_of("\r\n", span.end) - span.end);
        const std::size_t first = rest.find_first_not_of(" \t"), last = rest.find_last_not_of(" \t");
        const bool comment = first != rest.npos && (rest[first] == '#' || rest.substr(first).starts_with("//"));
        if (comment && rest[last] != '\\' && before != all.npos && all[before] == '\\') {
            const auto at = static_cast<std::uint32_t>(before);
            edits.insert(edits.begin(), {{span.file, at, at + 1}, ""});
        }
        return edits;
    }

    void leave_out(ChangeKind kind, Span span) {
        const Span at = to_.first_reading(span);
        if (statement_at(all_, at)) to_.add(kind, at, {without(at)});
    }

    void leave_out(const Draw& draw) {
        if (!std::holds_alternative<VertexList>(draw.shape)) return leave_out(ChangeKind::no_draw, draw.span);
        const Statement* begin = statement(draw.span);
        if (!begin) return;
        if (begin->command != "glBegin") return leave_out(ChangeKind::no_draw, draw.span);
        // Colours, normals and texture coordinates stay: they are in force behind the list.
        std::vector<Edit> edits{without(begin->span)};
        for (const Statement* at = begin + 1; at != all_.data() + all_.size(); ++at) {
            const bool ends = at->command == "glEnd";
            if (at->command == "glBegin" || edits.size() > most_list_statements) return;
            if (ends || at->command == "glVertex") edits.push_back(without(at->span));
            if (ends) break;
        }
        to_.add(ChangeKind::no_draw, begin->span, std::move(edits));
    }

    // A pass draws to it, or another one is computed from it.
    bool needed(Index texture) const {
        for (const Pass& pass : scene_.passes)
            if (ranges::find(pass.textures, texture) != pass.textures.end()) return true;
        return ranges::any_of(scene_.textures, [&](const Texture& t) { return t.source == texture; });
    }

    // A statement of a function.
    void leave_out(const Shader& shader, int node) {
        const glsl::Node& n = shader.at(node);
        const int function = shader.function_of(n.first);
        const std::vector<int> inside = shader.parts(node);
        if (function < 0 || inside.size() != 1 || may_end_a_loop(shader, node)) return;
        for (int k = n.first; k < shader.at(inside.front()).first; ++k)
            if (shader.token(k).text == "struct") return;
        const Expression value(shader, inside.front());
        const bool simple = n.form == Form::evaluated && may_go(shader, value);
        const bool unread = n.form == Form::declaration && !read(shader, inside.front());
        // The semicolon stays: a branch may have nothing else.
        if (!simple && !unread) return;
        if (const auto span = shader.place(n.first, simple ? n.last - 1 : n.last))
            to_.add(ChangeKind::no_statement, *span, {{*span, ""}});
    }

    // Whether the statement is in the head of a loop, or within one that may end by it.
    static bool may_end_a_loop(const Shader& shader, int node) {
        const auto is_loop = [&](int n) { return shader.at(n).form == Form::loop; };
        const int part = shader.parts(node).front();
        const std::string_view name = shader.token(shader.at(part).first).text;
        bool within = false;
        for (int inner = node, around = shader.parent(node); around >= 0;
             inner = around, around = shader.parent(around)) {
            if (!is_loop(around)) continue;
            const std::vector<int> parts = shader.parts(around);
            within = true;
            for (const int head : parts) {
                const bool body = shader.at(around).text == "do" ? head == parts.front() : head == parts.back();
                if (!body && head == inner) return true;
                for (int k = shader.at(head).first; !body && k >= 0 && k <= shader.at(head).last; ++k)
                    if (shader.token(k).text == name) return true;
            }
        }
        const int function = shader.function_of(shader.at(node).first);
        for (int n = 0; within && n < shader.nodes(); ++n)
            if (is_loop(n) && shader.at(n).text != "for" && shader.function_of(shader.at(n).first) == function)
                return true;
        return false;
    }

    static std::string_view target(const Shader& shader, const Expression& e) {
        return e ? shader.token(e.first()).text : std::string_view();
    }

    // Without the statement, nothing is left without a value: on some drivers it would be 0, and no pixel would change.
    static bool may_go(const Shader& shader, const Expression& e) {
        const glsl::Unit& unit = shader.unit;
        const auto& function = shader.function(shader.function_of(e.first()));
        if (e.call()) {
            std::set<std::string_view> written = arguments_written(shader, e), seen;
            add_written(unit, e.text(), written, seen);
            return ranges::all_of(
                written, [&](std::string_view name) { return surely_written(unit, function, name, e.first()); });
        }
        if (!e.is(Form::assign)) return false;
        // A depth that no statement writes is that of the surface.
        const bool depth = target(shader, e) == "gl_FragDepth" &&
                           ranges::count(unit.tokens, std::string_view("gl_FragDepth"), &glsl::Token::text) == 1;
        return depth || can_go(unit, function, e.first(), e.text() != "=");
    }

    // The variables that a call may write through its arguments.
    static std::set<std::string_view> arguments_written(const Shader& shader, const Expression& call) {
        std::set<std::string_view> names;
        const auto add = [&](const Expression& argument) { names.insert(target(shader, argument.bare())); };
        if (call.call("modf", 2) || call.call("frexp", 2)) add(call[1]);
        for (const glsl::Function& function : shader.unit.functions)
            for (std::size_t i = 0; function.name == call.text() && i < call.size(); ++i)
                if (i < function.parameters.size() && function.parameters[i].storage != glsl::Storage::in) add(call[i]);
        return names;
    }

    // The globals that a function, and what it calls, may write.
    static void add_written(const glsl::Unit& unit, std::string_view name, std::set<std::string_view>& written,
                            std::set<std::string_view>& seen) {
        if (!unit.function_names.contains(name) || !seen.insert(name).second) return;
        for (const glsl::Function& function : unit.functions)
            for (int k = function.open + 1; function.name == name && function.open >= 0 && k < function.close; ++k) {
                const std::string_view t = unit.at(k).text;
                if (unit.at(k).kind != glsl::Kind::identifier) continue;
                if (unit.at(k + 1).text == "(") add_written(unit, t, written, seen);
                const auto global = ranges::find(unit.globals, t, &glsl::Global::name);
                const bool ours = global != unit.globals.end() && global->qualifiers.storage != glsl::Storage::in &&
                                  global->qualifiers.storage != glsl::Storage::uniform &&
                                  global->qualifiers.storage != glsl::Storage::constant;
                if (ours || (t.starts_with("gl_") && changes(unit, k + 1, function.close))) written.insert(t);
            }
    }

    // Whether the expression before the token is assigned.
    static bool changes(const glsl::Unit& unit, int k, int end) {
        while (k + 1 < end && (unit.at(k).text == "." || unit.at(k).text == "[")) {
            if (unit.at(k).text == "[")
                while (k + 1 < end && unit.at(k).text != "]") ++k;
            k += unit.at(k).text == "]" ? 1 : 2;
        }
        const std::string_view t = unit.at(k).text;
        return t == "++" || t == "--" || (t.ends_with("=") && t != "==" && t != "!=" && t != "<=" && t != ">=");
    }

    // Whether anything but its declarator names the variable, which may be hidden in another branch of the text.
    static bool read(const Shader& shader, int declarator) {
        const glsl::Node& n = shader.at(declarator);
        const glsl::Function& f = shader.function(shader.function_of(n.first));
        for (int k = f.open; k < f.close; ++k)
            if (k != n.first && shader.token(k).text == n.text) return true;
        return shader.unit.has_conditionals;
    }
};

}  // namespace

}  // namespace snell::accuracy::texts

namespace snell::accuracy {

void add_omissions(const Reading& reading, std::vector<Change>& changes) { texts::Omissions(reading, changes).run(); }

}  // namespace snell::accuracy
