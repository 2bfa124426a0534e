// The stages of the reading as text.
#include "parser/read/match.h"
#include "parser/read/parse.h"
#include "parser/text/words.h"
#include "parser/text_of.h"

namespace snell {
namespace {

std::string place(const Sources& sources, FileId file, std::uint32_t offset) {
    const Position at = sources.position(file, offset);
    return std::to_string(at.line) + ":" + std::to_string(at.column);
}

std::string_view kind(TokenKind kind) {
    constexpr std::string_view names[] = {"word", "text", "open", "close", "comma"};
    return names[static_cast<std::size_t>(kind)];
}

std::string values(const double* v, std::size_t count) { return text_of::numbers("", v, count); }

std::string dump_draw(const Scene& scene, const Draw& d) {
    std::string out = "  draw " + text_of::shape(scene, d.shape, d.wire) + " | matrix " + std::to_string(d.matrix) +
                      " camera " + std::to_string(d.camera) + " raster " + std::to_string(d.raster) + " bindings " +
                      std::to_string(d.bindings) + " color " + std::to_string(d.color) + " program ";
    return out + (d.program == none ? "none" : std::to_string(d.program)) + "\n";
}

std::string dump_pass(const Scene& scene, const Pass& pass) {
    std::string out = "pass window";
    if (pass.kind == Pass::Kind::textures) out = "pass textures";
    if (pass.kind == Pass::Kind::cube) out = "pass cube at" + values(pass.center.data(), 3);
    if (pass.faces_per_frame < 6) out += " faces " + std::to_string(pass.faces_per_frame);
    for (std::size_t i = 0; i < pass.units.size(); ++i)
        out += " unit " + std::to_string(pass.units[i]) + " texture " +
               (pass.textures[i] == none ? "none" : std::to_string(pass.textures[i]));
    if (pass.background) out += " background" + values(pass.background->data(), 4);
    out += "\n";
    for (const Item& item : pass.items)
        out += item.kind == Item::Kind::clear ? "  clear\n" : dump_draw(scene, scene.draws[item.index]);
    return out;
}

std::string dump_program(const Program& p, std::size_t i) {
    std::string out = "program " + std::to_string(i) + " " + text_of::name(p.name);
    for (std::size_t s = 0; s < stage_count; ++s)
        if (p.stages[s]) out += " | " + std::string(text_of::stage_command(s)) + " " + text_of::name(p.stages[s]->name);
    if (!p.geometry_input.empty()) out += " | GeometryInput " + p.geometry_input;
    if (!p.geometry_output.empty()) out += " | GeometryOutput " + p.geometry_output;
    if (p.ladders > 0) out += " | ladders " + std::to_string(p.ladders);
    out += "\n";
    for (const UniformValue& u : p.uniforms) out += "  " + text_of::uniform(u) + "\n";
    return out;
}

std::string dump_raster(const RasterState& r, std::size_t i) {
    const auto flag = [](const char* name, bool on) { return std::string(on ? " " : " no-") + name; };
    return "raster " + std::to_string(i) +
           (r.blend ? " blend " + std::string(blend_factor_name(r.src)) + " " + std::string(blend_factor_name(r.dst))
                    : " no-blend") +
           " cull " + std::string(cull_face_name(r.cull)) + flag("depth-test", r.depth_test) +
           flag("depth-write", r.depth_write) + flag("wireframe", r.wireframe) + flag("flat", r.flat) +
           flag("clamp", r.clamp) + flag("point-size-mode", r.point_size_mode) + " line-width " +
           text_of::number(r.line_width) + " point-size " + text_of::number(r.point_size) + "\n";
}

std::string dump_lists(const Scene& scene) {
    std::string out;
    for (std::size_t i = 0; i < scene.vertex_lists.size(); ++i) {
        const VertexListData& list = scene.vertex_lists[i];
        out += "vertices " + std::to_string(i) + " " + std::string(topology_name(list.topology)) + " patch " +
               std::to_string(list.patch_vertices) + "\n";
        for (const ListVertex& v : list.vertices)
            out += " " + values(v.position.data(), 4) + " normal" + values(v.normal.data(), 3) + " texcoord" +
                   values(v.texcoord.data(), 3) + (list.has_color ? " color" + values(v.color.data(), 4) : "") + "\n";
    }
    return out;
}

}  // namespace

std::string dump_tokens(FileId file, const Sources& sources) {
    std::string out;
    Lexer lexer(sources.text(file), file);
    std::vector<Token> tokens;
    for (bool at_end = false; !at_end;) {
        tokens.clear();
        const Line line = lexer.read_line(tokens);
        if (!line.continued) lexer.begin_statement();
        at_end = line.at_end;
        for (const Token& token : tokens)
            out += place(sources, file, token.begin) + " " + std::string(kind(token.kind)) + " " +
                   utf8::printable(lexer.text(token)) + "\n";
        if (line.continued) out += "continued\n";
    }
    return out;
}

std::string dump_statements(FileId file, const Sources& sources) {
    std::string out;
    Collector report(0);
    StatementReader reader(sources.text(file), file, report);
    Statement statement;
    while (reader.next(statement)) {
        out += place(sources, file, statement.command().begin);
        for (const Token& token : statement.tokens) out += " " + utf8::printable(reader.lexer().text(token));
        out += "\n";
    }
    return out;
}

std::string dump_scene(const Scene& scene) {
    std::string out =
        "window " + std::to_string(scene.window_size[0]) + " " + std::to_string(scene.window_size[1]) + "\n";
    out += "background" + values(scene.background.data(), 4) + "\n";
    if (scene.output == Encoding::srgb) out += "output srgb\n";
    out += "timer " + text_of::number(scene.timer_period) + "\n";
    out += "noise " + std::to_string(scene.noise2d) + " " + std::to_string(scene.noise3d) + "\n";
    if (scene.gstap) out += "gstap\n";
    if (scene.verbose) out += "verbose\n";
    for (const Message& m : scene.messages) out += "message " + utf8::printable(m.text) + "\n";
    for (std::size_t i = 0; i < scene.ladders.size(); ++i)
        out += "ladder " + std::to_string(i) + " " + text_of::ladder(scene.ladders[i]) + "\n";
    for (std::size_t i = 0; i < scene.programs.size(); ++i) out += dump_program(scene.programs[i], i);
    for (std::size_t i = 0; i < scene.textures.size(); ++i)
        out += "texture " + std::to_string(i) + " " + text_of::texture(scene.textures[i]) + " | " +
               text_of::filter(scene.textures[i].filter) + "\n";
    for (const Pass& pass : scene.passes) out += dump_pass(scene, pass);
    for (std::size_t i = 0; i < scene.matrices.size(); ++i)
        out += "matrix " + std::to_string(i) + values(scene.matrices[i].data(), 16) + "\n";
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        out += "camera " + std::to_string(i) + " " + text_of::projection(scene.cameras[i]) + " " +
               text_of::look_at(scene.cameras[i]) + "\n";
    for (std::size_t i = 0; i < scene.rasters.size(); ++i) out += dump_raster(scene.rasters[i], i);
    for (std::size_t i = 0; i < scene.bindings.size(); ++i) {
        out += "bindings " + std::to_string(i);
        for (const auto& e : scene.bindings[i].entries)
            out += " " + std::to_string(e.unit) + ":" + std::to_string(e.texture);
        out += "\n";
    }
    for (std::size_t i = 0; i < scene.colors.size(); ++i)
        out += "color " + std::to_string(i) + values(scene.colors[i].data(), 4) + "\n";
    return out + dump_lists(scene);
}

}  // namespace snell
