// What can be left out of the scene and its shaders, to see whether any pixel depends on it.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/accuracy/found/texts/texts.h"

namespace snell::accuracy::texts {

namespace {

constexpr std::size_t most_omissions = 200;
constexpr std::size_t most_list_statements = 2000;  // of one list of vertices

class Omissions {
public:
    Omissions(const Plan& plan, Files& files, Sources& sources, std::vector<Change>& changes)
        : scene_(plan.scene),
          shaders_(shaders(plan, files, sources)),
          all_(statements(files, sources)),
          to_(files, sources, changes, most_omissions) {}

    void run() {
        for (const Draw& draw : scene_.draws) leave_out(draw);
        for (Index i = 0; i < scene_.textures.size(); ++i)
            if (!needed(i)) leave_out(ChangeKind::no_texture, scene_.textures[i].span);
        for (const Program& program : scene_.programs)
            for (const UniformValue& uniform : program.uniforms)
                if (uniform.span.begin < uniform.span.end)
                    to_.add(ChangeKind::no_uniform, uniform.span, {without(uniform.span)});
        for (const Shader& shader : shaders_)
            for (const Body& body : shader.bodies) leave_out(shader, body);
    }

private:
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

    void leave_out(ChangeKind kind, Span span) {
        const Span at = to_.first_reading(span);
        if (statement_at(all_, at)) to_.add(kind, at, {without(at)});
    }

    void leave_out(const Draw& draw) {
        if (!std::holds_alternative<VertexList>(draw.shape)) return leave_out(ChangeKind::no_draw, draw.span);
        const Statement* begin = statement_at(all_, to_.first_reading(draw.span));
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

    void leave_out(const Shader& shader, const Body& body) {
        const bool repeats =
            ranges::any_of(body.loops, [&](const Loop& loop) { return shader.unit.at(loop.word).text != "for"; });
        for (const Piece& piece : body.pieces) {
            // A loop may end by it.
            if (!piece.loops.empty() && (repeats || steers(shader.unit, body, piece))) continue;
            const bool simple = piece.kind == Piece::Kind::expression && may_go(shader.unit, piece.value);
            const bool unread =
                piece.kind == Piece::Kind::declaration && piece.whole && !read(shader.unit, body, piece);
            // The semicolon stays: it may be all that a branch has.
            const int last = simple ? piece.last - 1 : piece.last;
            if (!simple && !unread) continue;
            if (const auto span = span_of(shader.unit, to_, piece.first, last))
                to_.add(ChangeKind::no_statement, *span, {{*span, ""}});
        }
    }

    static std::string_view target(const glsl::Unit& unit, const Tree& tree) {
        return tree.first >= 0 ? unit.at(tree.first).text : std::string_view();
    }

    bool may_go(const glsl::Unit& unit, const Tree& tree) const {
        if (tree.kind == Tree::Kind::call) return true;
        if (tree.kind != Tree::Kind::assign) return false;
        const std::string_view name = target(unit, tree);
        if (name == "gl_Position") return false;
        // The only colour that a shader writes is no candidate.
        const bool output =
            name == "gl_FragColor" || name == "gl_FragData" || ranges::any_of(unit.globals, [&](const glsl::Global& g) {
                return g.name == name && unit.stage == Stage::fragment && g.qualifiers.storage == glsl::Storage::out;
            });
        return !output || ranges::count(unit.tokens, name, &glsl::Token::text) > (name.starts_with("gl_") ? 1 : 2);
    }

    static bool steers(const glsl::Unit& unit, const Body& body, const Piece& piece) {
        const std::string_view name = target(unit, piece.value);
        return ranges::any_of(piece.loops, [&](int n) {
            const Loop& loop = body.loops[static_cast<std::size_t>(n)];
            for (int k = loop.open; k < loop.close; ++k)
                if (unit.at(k).text == name) return true;
            return false;
        });
    }

    static bool read(const glsl::Unit& unit, const Body& body, const Piece& piece) {
        for (int k = body.function->open; k < body.function->close; ++k)
            if (k != piece.name_token && unit.at(k).text == piece.name) return true;
        return unit.has_conditionals;  // another branch may read it
    }

    const Scene& scene_;
    Shaders shaders_;
    std::vector<Statement> all_;
    Collector to_;
};

}  // namespace

}  // namespace snell::accuracy::texts

namespace snell::accuracy {

void add_omissions(const Plan& plan, Files& files, Sources& sources, std::vector<Change>& changes) {
    texts::Omissions(plan, files, sources, changes).run();
}

}  // namespace snell::accuracy
