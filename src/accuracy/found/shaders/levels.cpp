// Lower levels of tessellation.
#include "src/accuracy/found/shaders/shader.h"

namespace snell::accuracy {

namespace {

using glsl::Form;

bool levels(std::string_view name) { return name == "gl_TessLevelOuter" || name == "gl_TessLevelInner"; }

bool is_level(const Shader& shader, int node) {
    return shader.at(node).form == Form::index && levels(shader.at(shader.at(node).begin).text);
}

bool stores_level(const Shader& shader, int node) {
    const glsl::Node& n = shader.at(node);
    return n.form == Form::assign && n.text == "=" && is_level(shader, shader.parts(node)[0]);
}

// The value that the node stores in a level; -1: it does no such thing.
int level(const Shader& shader, int node) {
    if (!stores_level(shader, node)) return -1;
    const int value = shader.parts(node)[1];
    // a = gl_TessLevelOuter[1] = …: the inner one is enough. a = gl_TessLevelOuter[1]: that one is smaller already.
    const int bare = shader.bare(value);
    return shader.at(bare).form == Form::assign || is_level(shader, bare) ? -1 : value;
}

// Whether a value depends on levels in another way than by being one.
bool computes_with_levels(const Shader& shader) {
    for (int n = 0; n < shader.nodes(); ++n) {
        if (shader.at(n).form != Form::name || !levels(shader.at(n).text)) continue;
        int around = shader.parent(n);
        if (around < 0 || !is_level(shader, around)) return true;
        do around = shader.parent(around);
        while (around >= 0 && shader.at(around).form == Form::group);
        if (around < 0 || !stores_level(shader, around)) return true;
    }
    return false;
}

}  // namespace

// All levels together, so that patches still meet.
void add_lower_levels(const Shader& control, Offers& offers) {
    std::vector<int> values;
    for (int n = 0; n < control.nodes(); ++n)
        if (const int value = level(control, n); value >= 0) values.push_back(value);
    if (values.empty() || computes_with_levels(control)) return;
    for (const double share : {.75, .5, .25}) {
        std::vector<Edit> edits;
        for (const int value : values) {
            const glsl::Node& n = control.at(value);
            if (!control.own(value)) return;
            const glsl::Type real{.base = glsl::Base::real};
            const std::string text = control.text(value);
            edits.push_back({control.span(value), literal(share, real) + "*" + (closed(n) ? text : "(" + text + ")")});
        }
        offers.add(ChangeKind::lower_levels, control.span(control.parent(values.front())), std::move(edits));
    }
}

}  // namespace snell::accuracy
