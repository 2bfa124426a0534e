// Lower levels of tessellation.
#include "src/accuracy/found/shaders/shader.h"

namespace snell::accuracy {

namespace {

using glsl::Form;

// The value that the node stores in an element of gl_TessLevelOuter or gl_TessLevelInner; -1: it does no such thing.
int level(const Shader& shader, int node) {
    if (shader.at(node).form != Form::assign || shader.at(node).text != "=") return -1;
    const std::vector<int> sides = shader.parts(node);
    if (shader.at(sides[0]).form != Form::index) return -1;
    const std::string_view array = shader.at(shader.at(sides[0]).begin).text;
    // a = gl_TessLevelOuter[1] = …: the inner one is enough.
    const bool value = shader.at(sides[1]).form != Form::assign;
    return value && (array == "gl_TessLevelOuter" || array == "gl_TessLevelInner") ? sides[1] : -1;
}

}  // namespace

// All levels together, so that patches still meet.
void add_lower_levels(const Shader& control, Offers& offers) {
    std::vector<int> levels;
    for (int n = 0; n < control.nodes(); ++n)
        if (const int value = level(control, n); value >= 0) levels.push_back(value);
    if (levels.empty()) return;
    for (const double share : {.75, .5, .25}) {
        std::vector<Edit> edits;
        for (const int value : levels) {
            const glsl::Node& n = control.at(value);
            if (!control.own(value)) return;
            const glsl::Type real{.base = glsl::Base::real};
            const std::string text = control.text(value);
            edits.push_back({control.span(value), literal(share, real) + "*" + (closed(n) ? text : "(" + text + ")")});
        }
        offers.add(ChangeKind::lower_levels, control.span(control.parent(levels.front())), std::move(edits));
    }
}

}  // namespace snell::accuracy
