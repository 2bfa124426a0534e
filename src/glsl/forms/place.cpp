// Where a fragment is in a picture that is drawn part by part.

#include "src/glsl/translate/program.h"

#include "parser/text/ranges.h"

namespace snell::glsl {

bool place_in_picture(Program& program) {
    Unit* fragment = program.find(Stage::fragment);
    if (!fragment) return false;
    Unit& u = *fragment;
    std::string_view offset = "snell_Place.xy";
    const auto declared = ranges::find(u.globals, "gl_FragCoord", &Global::name);
    const int name = declared == u.globals.end() ? -1 : declared->name_token;
    if (name >= 0)
        for (const LayoutItem& item : declared->qualifiers.layout)
            if (item.name == "origin_upper_left") offset = "snell_Place.xz";
    bool reads = false;
    for (int i = 0; i + 1 < static_cast<int>(u.tokens.size()); ++i) {
        if (u.at(i).text != "gl_FragCoord" || i == name) continue;
        reads = true;
        if (program.options.placed) u.replace(i, "(gl_FragCoord + vec4(" + std::string(offset) + ", 0.0, 0.0))");
    }
    if (reads && program.options.placed) declare_once(u, "snell_Place", "uniform vec3 snell_Place;");
    return reads;
}

}  // namespace snell::glsl
