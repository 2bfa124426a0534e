// Builds the display list: it holds the current state, and adds draws that refer to the state at their statements.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/read/parse.h"
#include "parser/text/diagnostic.h"

namespace snell {

// The current value of a state that draws refer to by index. It is added to its list when a draw first needs it.
template <class T>
struct Current {
    T value{};
    Index index = none;
    void set(const T& to) {
        if (to == value) return;
        value = to;
        index = none;
    }
};

struct OpenMatrix {
    Current<Mat4> entry;
    Span span;  // of the PushMatrix statement
};

class Builder {
public:
    Builder(Scene& scene, Collector& report, const Limits& limits, std::size_t text_bytes);

    Collector& report() { return report_; }
    const Limits& limits() const { return limits_; }
    Scene& scene() { return scene_; }
    Pass& pass() { return scene_.passes.back(); }

    // ---- state
    Camera camera() const { return camera_.value; }
    void set_camera(const Camera& camera) { camera_.set(camera); }
    RasterState raster() const { return raster_.value; }
    void set_raster(const RasterState& raster) { raster_.set(raster); }
    Vec4 color() const { return color_.value; }
    void set_color(const Vec4& color) { color_.set(color); }
    // Sets the background of the current pass.
    void set_background(const Vec4& color);

    // Multiplies the current matrix from the right by an affine one. If the product exceeds the range of floats,
    // returns false and changes nothing.
    bool transform(const Mat4& matrix);
    void push_matrix(Span span);
    void pop_matrix(Span span);

    // ---- textures
    Filter filter;  // for the textures that follow
    // Adds the texture to the scene and binds it to its unit and target.
    void bind(Texture texture);
    // The texture that is bound; nullopt if there is none.
    std::optional<Index> bound(int unit, TextureTarget target) const;
    void begin_pass(Pass pass);  // past the limit of passes, the draws that follow stay in the previous pass

    // ---- programs
    std::array<std::optional<FileName>, stage_count> stages;
    std::string geometry_input, geometry_output;
    // Adds the program, with the current stages and ladders, and makes it the current one.
    void begin_program(Program program);
    void no_program() { program_ = none; }
    // The program that a uniform on a line of its own belongs to, which is the current one; nullptr if there is none.
    Program* program();

    // ---- geometry
    void draw(const Shape& shape, Span span, bool wire = false);
    void clear(Span span);
    // Adds a file name to the scene, once for each name, and returns its index.
    Index file(std::string_view name, Span span);
    // The list between glBegin and glEnd; nullptr outside of these.
    VertexListData* open_list();
    bool in_list() const { return in_list_; }
    Vec4 list_color() const { return list_color_; }  // the current colour at the glBegin
    Index add_list(VertexListData list);
    // Begins a list with the current state. Without a topology (its name was invalid), vertices are accepted but not
    // drawn.
    void begin_list(std::optional<Topology> topology, Span span);
    void end_list(Span span);
    int patch_vertices = 3;
    Vec3 normal{0, 0, 1}, texcoord{0, 0, 0};

    // Parses another text at this place. Set by the parser.
    std::function<void(std::string_view name, Span span, Span name_span)> include;
    std::string from;  // FileName::from for the names that follow

    // Tells how many bytes have been read, from which the final size of lists is estimated.
    void progress(std::size_t bytes) { read_bytes_ = bytes; }
    // Call it at the end of the text: reports a glBegin without glEnd and a PushMatrix without PopMatrix.
    void finish();

private:
    template <class T>
    Index index_of(Current<T>& current, std::vector<T>& list);
    template <class T>
    void append(std::vector<T>& list, T value);
    void refuse(std::string_view code, std::uint64_t Limits::*limit, Span span);

    Scene& scene_;
    Collector& report_;
    Limits limits_;
    std::size_t text_bytes_, read_bytes_ = 0;

    Current<Camera> camera_;
    Current<RasterState> raster_;
    Current<Vec4> color_{{1, 1, 1, 1}, none};
    Current<Mat4> matrix_{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, none};
    std::vector<OpenMatrix> stack_;
    std::size_t refused_pushes_ = 0;
    std::set<std::string_view> refused_;  // codes
    Current<Bindings> bindings_;
    Index program_ = none;
    Index open_list_ = none;
    bool in_list_ = false;
    Span list_span_;
    Vec4 list_color_{1, 1, 1, 1};
    std::unordered_map<std::string, Index> files_;
};

// Replaces '\' and '\\' by '/'.
std::string file_name(std::string_view written);

}  // namespace snell
