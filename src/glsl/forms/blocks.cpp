// OpenGL ES before 3.2 passes no blocks between shaders: their members become variables of their own.
#include "parser/text/ranges.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

bool passes_between(const Unit& u, const Block& b) {
    const Storage storage = b.qualifiers.storage;
    return (storage == Storage::out && u.stage == Stage::vertex) ||
           (storage == Storage::in && u.stage == Stage::fragment);
}

void blank(Unit& u, int first, int last) {
    for (int i = first; i <= last; ++i) u.replace(i, "");
}

// `first` … `last`: one declaration of members, with its semicolon. Interpolation stands before the storage.
void declare(const Program& program, Unit& u, const Block& b, int first, int last) {
    std::string interpolation(b.qualifiers.interpolation), auxiliary(b.qualifiers.auxiliary);
    int type = first;
    for (; type < last; ++type) {
        const std::string_view t = u.at(type).text;
        if (t == "flat" || t == "smooth" || t == "noperspective")
            interpolation = t;
        else if (t == "centroid")
            auxiliary = t;
        else if (t != "in" && t != "out")
            break;
    }
    blank(u, first, type - 1);
    for (std::string* word : {&interpolation, &auxiliary})
        if (!word->empty()) *word += ' ';
    u.edit(type).before += interpolation + auxiliary + (b.qualifiers.storage == Storage::in ? "in " : "out ");
    for (int i = type + 1; i < last; ++i) {
        const std::string_view next = u.at(i + 1).text;
        const bool name = ranges::find(b.members, u.at(i).text, &Member::name) != b.members.end();
        if (name && (next == "," || next == ";" || next == "["))
            u.replace(i, variable_of(program, b.name, u.at(i).text));
    }
}

// An input block that no stage writes is not passed at all: it reads as zero.
bool is_written(const Program& program, const Block& b) {
    return b.qualifiers.storage == Storage::out || ranges::any_of(program.units, [&](const Unit& u) {
               return ranges::any_of(u.blocks, [&](const Block& other) {
                   return other.name == b.name && other.qualifiers.storage == Storage::out;
               });
           });
}

}  // namespace

void flatten_block(const Program& program, Unit& u, const Block& b) {
    blank(u, b.first, b.open);
    for (const auto& [first, last] : b.member_tokens) declare(program, u, b, first, last);
    blank(u, b.close, b.last);
    if (b.instance.empty()) return;
    for (int i = b.last + 1; i + 2 < static_cast<int>(u.tokens.size()); ++i) {
        if (u.at(i).text != b.instance || u.at(i - 1).text == "." || u.at(i + 1).text != ".") continue;
        u.replace(i, variable_of(program, b.name, u.at(i + 2).text));
        blank(u, i + 1, i + 2);
    }
}

// A block without an instance lends its members' names to the whole text, so they stay.
std::string variable_of(const Program& program, std::string_view block, std::string_view member) {
    for (const Unit& u : program.units)
        for (const Block& b : u.blocks)
            if (b.name == block && b.instance.empty() && passes_between(u, b)) return std::string(member);
    return "snell_" + std::string(block) + "_" + std::string(member);
}

// Where a geometry stage is emulated, its form sees to the blocks.
bool flattens_blocks(const Program& program) {
    return program.target().es && program.units.size() == 2 &&
           (program.target().version < 320 || (!program.options.wide_lines && passes_numbers(program)));
}

void flatten_blocks(Program& program) {
    if (!flattens_blocks(program)) return;
    for (Unit& u : program.units)
        for (const Block& b : u.blocks)
            if (passes_between(u, b) && !b.arrayed && is_written(program, b)) flatten_block(program, u, b);
}

// Where a fragment is in a picture that is drawn part by part.

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
