#include "tests/oracle/scene/print.h"

#include <limits>

#include "parser/text_of.h"
#include "tests/oracle/scene/decompose.h"

namespace snell {
namespace {

constexpr Mat4 identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// Writes statements, and keeps what they have set so far: only what changes is written.
class Printer {
public:
    explicit Printer(const Scene& scene) : scene_(scene) {}

    std::string run() {
        header();
        for (std::size_t i = 0; i < scene_.passes.size(); ++i) pass(scene_.passes[i], i == 0);
        programs(static_cast<Index>(scene_.programs.size()));
        ladders(scene_.ladders.size());
        textures(static_cast<Index>(scene_.textures.size()));
        return std::move(out_);
    }

private:
    void line(std::string_view statement) {
        out_ += statement;
        out_ += '\n';
    }

    void header() {
        line("##OpenGL GLIB");
        line("WindowSize " + std::to_string(scene_.window_size[0]) + " " + std::to_string(scene_.window_size[1]));
        line("Timer " + text_of::number(scene_.timer_period));
        line("Noise2D " + std::to_string(scene_.noise2d));
        line("Noise3D " + std::to_string(scene_.noise3d));
        if (scene_.output == Encoding::srgb) line("Output srgb");
        if (scene_.gstap) line("GSTAP");
        if (scene_.verbose) line("Verbose");
        for (const Message& message : scene_.messages) {
            const std::string& text = message.text;
            const bool quotes = text.size() >= 2 && text.front() == '"' && text.back() == '"';
            line("MessageBox " + (quotes ? "\"" + text + "\"" : text));
        }
    }

    void pass(const Pass& pass, bool first) {
        Index last_texture = 0;
        for (const Index texture : pass.textures)
            if (texture != none) last_texture = std::max(last_texture, texture + 1);
        textures(last_texture);
        std::string statement = "RenderToTexture";
        if (pass.kind == Pass::Kind::cube) statement = "RenderToCube";
        for (const int unit : pass.units) statement += " " + std::to_string(unit);
        if (pass.kind == Pass::Kind::cube) statement = text_of::numbers(statement, pass.center.data(), 3);
        if (pass.faces_per_frame < 6) statement += " " + std::to_string(pass.faces_per_frame);
        if (!first) line(statement);
        if (pass.background) line(text_of::numbers("Background", pass.background->data(), 4));
        for (const Item& item : pass.items) {
            if (item.kind == Item::Kind::clear) {
                line("Clear");
            } else {
                draw(scene_.draws[item.index]);
            }
        }
    }

    void draw(const Draw& draw) {
        Index last_texture = 0;
        for (const Bindings::Entry& entry : scene_.bindings[draw.bindings].entries)
            last_texture = std::max(last_texture, entry.texture + 1);
        textures(last_texture);
        program(draw.program);
        camera(scene_.cameras[draw.camera]);
        raster(scene_.rasters[draw.raster]);
        color("Color", scene_.colors[draw.color]);
        const Mat4& matrix = scene_.matrices[draw.matrix];
        if (matrix != identity) transformation(matrix);
        if (const auto* list = std::get_if<VertexList>(&draw.shape)) {
            vertices(scene_.vertex_lists[list->list], text_of::shape(scene_, draw.shape, false));
        } else {
            line(text_of::shape(scene_, draw.shape, draw.wire));
        }
        if (matrix != identity) line("PopMatrix");
    }

    void transformation(const Mat4& matrix) {
        const Decomposed parts = decompose(matrix);
        line("PushMatrix");
        if (parts.translate != Vec3{}) line(text_of::numbers("Translate", parts.translate.data(), 3));
        if (parts.outer) turn(*parts.outer);
        if (parts.scale != Vec3{1, 1, 1}) scale(parts.scale);
        if (parts.inner) turn(*parts.inner);
    }

    void turn(const Turn& turn) {
        line("Rotate " + text_of::number(turn.angle) + text_of::numbers("", turn.axis.data(), 3));
    }

    // A singular value may be larger than any number that can be written.
    void scale(Vec3 by) {
        constexpr double part = 16;
        for (const double s : by) {
            if (std::abs(s) <= std::numeric_limits<float>::max()) continue;
            for (double& other : by) other /= part;
            line("Scale " + text_of::number(part));
            break;
        }
        line(text_of::numbers("Scale", by.data(), 3));
    }

    void textures(Index end) {
        for (; texture_ < end; ++texture_) {
            const Texture& t = scene_.textures[texture_];
            if (t.filter != filter_) line(text_of::filter(t.filter));
            filter_ = t.filter;
            line(text_of::texture(t));
        }
    }

    void program(Index current) {
        if (current == none) {
            if (program_set_) line("Program");
            program_set_ = false;
            return;
        }
        programs(current + 1);
        program_set_ = true;
    }

    void programs(Index end) {
        for (; program_ < end; ++program_) {
            const Program& p = scene_.programs[program_];
            ladders(p.ladders);
            for (std::size_t i = 0; i < stage_count; ++i) {
                const std::string name = p.stages[i] ? p.stages[i]->name : "";
                if (name == stages_[i]) continue;
                const std::string command(text_of::stage_command(i));
                line(name.empty() ? command : command + " " + text_of::name(name));
                stages_[i] = name;
            }
            topology("GeometryInput", p.geometry_input, input_);
            topology("GeometryOutput", p.geometry_output, output_);
            std::string statement = "Program " + text_of::name(p.name);
            for (const UniformValue& u : p.uniforms) statement += " " + text_of::uniform(u);
            line(statement);
            program_set_ = true;
        }
    }

    void ladders(std::size_t end) {
        for (; ladder_ < end; ++ladder_) line(text_of::ladder(scene_.ladders[ladder_]));
    }

    void topology(std::string_view command, const std::string& value, std::string& current) {
        if (value == current) return;
        line(std::string(command) + (value.empty() ? "" : " ") + value);
        current = value;
    }

    void camera(const Camera& c) {
        const std::string projection = text_of::projection(c), look_at = text_of::look_at(c);
        if (projection != projection_) line(projection);
        if (look_at != look_at_) line(look_at);
        projection_ = projection;
        look_at_ = look_at;
    }

    void raster(const RasterState& r) {
        const auto on_off = [&](std::string_view command, bool now, bool before) {
            if (now != before) line(std::string(command) + (now ? " on" : " off"));
        };
        const RasterState& b = raster_;
        if (!r.blend && b.blend) line("Blend off");
        if (r.blend && (!b.blend || r.src != b.src || r.dst != b.dst))
            line("Blend " + std::string(blend_factor_name(r.src)) + " " + std::string(blend_factor_name(r.dst)));
        if (r.cull != b.cull) line("CullFace " + std::string(cull_face_name(r.cull)));
        on_off("DepthTest", r.depth_test, b.depth_test);
        on_off("DepthWrite", r.depth_write, b.depth_write);
        on_off("Wireframe", r.wireframe, b.wireframe);
        if (r.flat != b.flat) line(r.flat ? "Flat" : "Smooth");
        if (r.clamp && !b.clamp) line("Clamp");
        if (r.point_size_mode != b.point_size_mode) line(r.point_size_mode ? "PointSizeMode 1" : "PointSizeMode 0");
        if (r.line_width != b.line_width) line("LineWidth " + text_of::number(r.line_width));
        if (r.point_size != b.point_size) line("PointSize " + text_of::number(r.point_size));
        raster_ = r;
    }

    void color(std::string_view command, const Vec4& color) {
        if (color != color_) line(text_of::numbers(command, color.data(), 4));
        color_ = color;
    }

    void vertices(const VertexListData& list, const std::string& begin) {
        if (list.topology == Topology::patches && list.patch_vertices != patch_vertices_) {
            line("NumPatchVertices " + std::to_string(list.patch_vertices));
            patch_vertices_ = list.patch_vertices;
        }
        line(begin);
        if (list.has_color) {
            color_ = list.vertices.empty() ? color_ : list.vertices.front().color;
            line(text_of::numbers("glColor", color_.data(), 4));
        }
        for (const ListVertex& v : list.vertices) {
            if (list.has_color) color("glColor", v.color);
            if (v.normal != normal_) line(text_of::numbers("glNormal", v.normal.data(), 3));
            if (v.texcoord != texcoord_) line(text_of::numbers("glTexCoord", v.texcoord.data(), 3));
            normal_ = v.normal;
            texcoord_ = v.texcoord;
            line(text_of::numbers("glVertex", v.position.data(), 4));
        }
        line("glEnd");
    }

    const Scene& scene_;
    std::string out_;
    Index texture_ = 0, program_ = 0;
    std::size_t ladder_ = 0;
    bool program_set_ = false;
    Filter filter_;
    std::array<std::string, stage_count> stages_;
    std::string input_, output_;
    std::string projection_ = text_of::projection(Camera{}), look_at_ = text_of::look_at(Camera{});
    RasterState raster_;
    Vec4 color_{1, 1, 1, 1};
    Vec3 normal_{0, 0, 1}, texcoord_{0, 0, 0};
    int patch_vertices_ = 3;
};

}  // namespace

std::string print_scene(const Scene& scene) { return Printer(scene).run(); }

}  // namespace snell
