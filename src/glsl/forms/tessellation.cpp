// Vertex and tessellation stages as vertex shaders, for contexts that have no tessellation.
//
// The first shader takes one patch in each run: it runs the author's vertex stage for each vertex of the patch, then
// all invocations of the control stage one after the other, and hands what they output to transform feedback. That
// becomes a texture, which the evaluation stage reads: a vertex shader whose attribute is a vertex of the divided
// domain.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/forms/fusion.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

namespace {

// Numbers in slots of four, as bits.
class Slots {
public:
    // Returns the text that reads the number back from the texel that `slot` makes of the number of its slot.
    template <class Texel>
    std::string add(const Number& number, const Texel& texel) {
        if (count_ % 4 == 0) written_.emplace_back();
        const std::string value = texel(static_cast<int>(written_.size()) - 1) + "." + "xyzw"[count_++ % 4];
        std::string& slot = written_.back();
        slot += (slot.empty() ? "" : ", ") +
                ((number.base == Base::real ? "floatBitsToUint(" : "uint(") + number.from + ")");
        return number.base == Base::real      ? "uintBitsToFloat(" + value + ")"
               : number.base == Base::integer ? "int(" + value + ")"
                                              : value;
    }
    // What follows begins in a slot of its own.
    void end_slot() {
        for (; count_ % 4 != 0; ++count_) written_.back() += ", 0u";
    }
    const std::vector<std::string>& written() const { return written_; }

private:
    std::vector<std::string> written_;
    int count_ = 0;
};

class TessellationForm : Fusion {
public:
    TessellationForm(Program& program, Translation& translation) : Fusion(program, translation) {}

    void run() {
        const StageOutput* const control = stage(Stage::tess_control);
        reference_ = program_.find(Stage::tess_evaluation)->reference;
        read(*stage(Stage::vertex), control);
        evaluation_ = read_again(*stage(Stage::tess_evaluation), false);
        corners_ = std::max(options_.patch_vertices, 1);
        if (!ok_ || !read_layouts()) return;
        separate_names();
        share_declarations();
        take_first();
        control ? take_control() : hand_on();
        if (ok_) take_evaluation();
        if (!ok_) return;
        write_both();
        form_.control = {Stage::vertex, control_text(), files_, {}, written_in_};
        StageOutput evaluation{Stage::vertex,
                               emit(quiet_program_, evaluation_),
                               evaluation_files(),
                               {},
                               std::vector(evaluation_files().size(), Stage::tess_evaluation)};
        std::erase_if(out_.stages, [](const StageOutput& s) { return s.stage < Stage::geometry; });
        out_.stages.insert(out_.stages.begin(), std::move(evaluation));
        if (out_.stages.size() == 2) join_fragment();
        out_.tessellation = std::move(form_);
    }

private:
    const std::vector<FileId>& evaluation_files() { return stage(Stage::tess_evaluation)->files; }

    bool read_layouts() {
        for (const StageLayout& l : second_.layouts) {
            for (const LayoutItem& item : l.qualifiers.layout)
                if (item.name == "vertices") vertices_ = value_of(second_, item.value);
            second_.erase(l.qualifiers.first, l.last);
        }
        for (const StageLayout& l : evaluation_.layouts) {
            for (const LayoutItem& item : l.qualifiers.layout) {
                const std::string& name = item.name;
                if (name == "triangles" || name == "quads" || name == "isolines") form_.domain = name;
                if (name.ends_with("_spacing")) form_.spacing = name;
                if (name == "cw") form_.clockwise = true;
                if (name == "point_mode") form_.points = true;
            }
            evaluation_.erase(l.qualifiers.first, l.last);
        }
        if (second_.tokens.empty()) vertices_ = corners_;
        if (vertices_ < 1)
            fail("the number of vertices that the tessellation control shader outputs is not understood");
        return ok_;
    }

    // ---- the control stage

    void take_control() {
        leave_redeclarations(second_);
        written_ = ports(second_, Storage::out);
        resets_ = resets(second_, "        ");
        for (const Global& g : second_.globals)
            if (g.qualifiers.storage != Storage::plain) passed_.insert(g.name);
        take_inputs();
        if (!ok_) return;
        make_plain(Storage::out, vertices_, "snellO");
        split_at_barriers();
        for (int i = 0; i < static_cast<int>(second_.tokens.size()); ++i) replace_built_in(i);
    }

    void replace_built_in(int i) {
        Unit& u = second_;
        const std::string_view t = u.at(i).text;
        if (t == "gl_in") u.replace(i, "snell_gl_in");
        if (t == "gl_out") u.replace(i, "snell_gl_out");
        if (t == "gl_Position") u.replace(i, "position");
        if (t == "gl_PointSize") u.replace(i, "size");
        if (t == "gl_InvocationID") u.replace(i, "snell_invocation");
        if (t == "gl_PrimitiveID") u.replace(i, "snell_primitive");
        if (t == "gl_PatchVerticesIn") u.replace(i, number(corners_));
        if (t == "gl_TessLevelOuter") u.replace(i, "snell_outer");
        if (t == "gl_TessLevelInner") u.replace(i, "snell_inner");
        if (t == "memoryBarrier") u.replace(i, "snell_memory");
        replace_limits(u, i);
    }

    static void replace_limits(Unit& u, int i) {
        const std::string_view t = u.at(i).text;
        if (t == "gl_MaxPatchVertices") u.replace(i, "32");
        if (t == "gl_MaxTessGenLevel") u.replace(i, "64");
    }

    // Behind a barrier, each invocation sees what all have written above it: main() becomes functions, each of which is
    // run for all invocations before the next one.
    void split_at_barriers() {
        Unit& u = second_;
        const Function* const body = body_of_main();
        std::vector<int> barriers;
        for (int i = 0, depth = 0; i + 3 < static_cast<int>(u.tokens.size()); ++i) {
            depth += u.at(i).text == "{" ? 1 : u.at(i).text == "}" ? -1 : 0;
            if (u.at(i).text != "barrier") continue;
            if (!body || i < body->open || i > body->close || depth != 1 || u.at(i + 3).text != ";")
                return refuse("barrier() must be a statement of main() itself");
            barriers.push_back(i);
        }
        if (barriers.empty()) return;
        keep_globals();
        keep_locals(*body, barriers);
        for (const int i : barriers) {
            u.erase(i, i + 2);
            u.replace(i + 3, "} void snell_phase" + number(++phases_) + "() {");
        }
    }

    // At the author's barrier.
    void refuse(const std::string& why) {
        const Unit& u = *program_.find(Stage::tess_control);
        const auto barrier = ranges::find_if(u.tokens, [](const Token& t) { return t.text == "barrier"; });
        if (barrier != u.tokens.end()) reference_ = u.span(static_cast<int>(barrier - u.tokens.begin()));
        fail("this OpenGL has no tessellation shaders, and without them, " + why);
    }

    const Function* body_of_main() const {
        const Function* found = nullptr;
        for (const Function& f : second_.functions)
            if (f.open >= 0 && (f.name == "snell_main" || (f.name == "main" && !found))) found = &f;
        return found;
    }

    void keep_globals() {
        Unit& u = second_;
        for (const Global& g : u.globals) {
            if (g.qualifiers.storage != Storage::plain || !g.written || passed_.contains(g.name)) continue;
            if (g.type.dims > 0) return refuse("arrays outside of main() cannot be kept across barrier()");
            const std::string name(u.now(g.name_token)), kept = "snell_kept_" + name;
            u.trailer += own_type_name(u, g.type) + " " + kept + "[" + number(vertices_) + "];\n";
            save_ += "        " + kept + "[snell_i] = " + name + ";\n";
            restore_ += "        " + name + " = " + kept + "[snell_i];\n";
        }
    }

    // What main() declares above a barrier and names below it has an element for each invocation.
    void keep_locals(const Function& body, const std::vector<int>& barriers) {
        Unit& u = second_;
        int depth = 0;
        for (int i = body.open; i < barriers.back(); ++i) {
            depth += u.at(i).text == "{" ? 1 : u.at(i).text == "}" ? -1 : 0;
            const std::string_view before = u.at(i).text;
            if (depth != 1 || (before != "{" && before != "}" && before != ";")) continue;
            int type = i + 1;
            while (is_qualifier(u.at(type).text)) ++type;
            const bool known = builtin_type(u.at(type).text).has_value() ||
                               ranges::find(u.structs, u.at(type).text, &Struct::name) != u.structs.end();
            if (!known || u.at(type + 1).kind != Kind::identifier) continue;
            keep(body, barriers, i + 1, type);
        }
    }

    // The declaration whose first token is `first`.
    void keep(const Function& body, const std::vector<int>& barriers, int first, int type) {
        Unit& u = second_;
        std::vector<int> names;
        int last = type + 1;
        for (int open = 0; u.at(last).text != ";" || open > 0; ++last) {
            const std::string_view t = u.at(last).text;
            open += t == "(" || t == "[" || t == "{" ? 1 : t == ")" || t == "]" || t == "}" ? -1 : 0;
            const bool declares = last == type + 1 || (open == 0 && u.at(last - 1).text == ",");
            if (declares && u.at(last).kind == Kind::identifier) names.push_back(last);
        }
        const int barrier = *std::upper_bound(barriers.begin(), barriers.end(), last);
        const auto uses = [&](int name, int from) {
            std::vector<int> found;
            for (int i = from; i < body.close; ++i)
                if (u.at(i).text == u.at(name).text && u.at(i - 1).text != ".") found.push_back(i);
            return found;
        };
        if (ranges::none_of(names, [&](int name) { return !uses(name, barrier).empty(); })) return;
        for (const int name : names) {
            if (u.at(name + 1).text == "[") return refuse("arrays of main() cannot be kept across barrier()");
            const std::string kept = "snell_kept_" + std::string(u.at(name).text);
            u.header += std::string(u.at(type).text) + " " + kept + "[" + number(vertices_) + "];\n";
            for (const int i : uses(name, first)) u.replace(i, kept + "[snell_invocation]");
        }
        u.erase(first, type);
    }

    // Without a control stage, the vertices are handed on as they are.
    void hand_on() {
        std::string members;
        for (std::size_t i = 0; i < given_.size(); ++i) {
            Port port = given_[i];
            const std::string member = "snell_p" + std::to_string(i);
            members += " " + own_type_name(first_, port.type) + " " + member +
                       (port.type.dims ? "[" + number(port.type.size) + "];" : ";");
            copies_ += "        snell_given[snell_corner]." + member + " = " + port.name + ";\n";
            port.name = "snell_given." + member;
            written_.push_back(std::move(port));
        }
        if (!members.empty())
            first_.trailer =
                "struct snell_Given {" + members + " };\nsnell_Given snell_given[" + number(corners_) + "];\n";
    }

    // ---- the evaluation stage

    void take_evaluation() {
        Unit& u = evaluation_;
        u.stage = Stage::vertex;
        for (int i = 0; i < 6; ++i) {
            const std::string level = i < 4 ? "snell_outer[" + number(i) + "]" : "snell_inner[" + number(i - 4) + "]";
            const std::string read = whole_.add({level, level, Base::real}, patch_texel);
            if (mentions(u, i < 4 ? "gl_TessLevelOuter" : "gl_TessLevelInner"))
                start_ += " " + level + " = " + read + ";";
        }
        leave_redeclarations(u);
        corner_function();
        for (Global& g : u.globals)
            if (g.qualifiers.storage == Storage::in && !g.removed) take_input(g);
        for (const Block& b : u.blocks)
            if (b.qualifiers.storage == Storage::in && b.name != "gl_PerVertex") take_input(b);
        for (int i = 0; i < static_cast<int>(u.tokens.size()); ++i) replace_evaluated(i);
        whole_.end_slot();
        each_.end_slot();
        write_declarations(quiet_program_, u);
        for (const auto& [token, text] : functions_) u.edit(token).after += text;
        u.header += evaluation_header();
        at_main_start(u, std::string("snell_tess_coord = vec3(snell_Domain.xy, ") +
                             (form_.domain == "triangles" ? "1.0 - snell_Domain.x - snell_Domain.y" : "0.0") +
                             "); snell_patch = int(snell_Domain.z);" + start_);
    }

    static std::string patch_texel(int slot) {
        return "snell_texel(snell_patch * snell_each_patch + " + number(slot) + ")";
    }
    static std::string vertex_texel(int slot) { return "snell_texel(snell_s + " + number(slot) + ")"; }

    // A function that returns what the control stage gave for one of its vertices.
    std::string reader(const std::string& type, const std::string& name, const std::vector<Number>& numbers) {
        std::string text = type + " " + name + "(int snell_i) { " + type +
                           " snell_v; int snell_s = snell_patch * snell_each_patch + snell_first_vertex + snell_i * "
                           "snell_each_vertex;";
        for (const Number& n : numbers) text += " " + n.to + " = " + each_.add(n, vertex_texel) + ";";
        return text + " return snell_v; }";
    }

    void corner_function() {
        if (!mentions(evaluation_, "gl_in")) return;
        std::vector<Number> numbers;
        const std::string from = second_.tokens.empty() ? "snell_gl_in[@V]" : "snell_gl_out[@V]";
        add_numbers(evaluation_, make_type(Base::real, 4), from + ".position", "snell_v.position", numbers);
        if (mentions(evaluation_, "gl_PointSize")) numbers.push_back({from + ".size", "snell_v.size", Base::real});
        readers_ = "struct snell_PatchCorner { highp vec4 position; highp float size; };\n" +
                   reader("snell_PatchCorner", "snell_patch_corner", numbers) + "\n";
    }

    const Port* source(const std::string& key, const std::string& location) {
        const Port* const found = port_of(written_, {key, "", "", location, {}, false});
        if (!found) fail("an input of the tessellation evaluation shader, '" + key + "', has no output to match");
        return found;
    }

    void cannot_pass(std::string_view name) { Fusion::cannot_pass(Stage::tess_evaluation, name); }

    void take_input(Global& g) {
        Unit& u = evaluation_;
        const std::string name(u.now(g.name_token));
        const Port* const from = source(name, std::string(g.qualifiers.layout_value("location")));
        if (!from) return;
        std::vector<Number> numbers;
        if (g.qualifiers.auxiliary == "patch") {
            if (!add_numbers(u, g.type, from->name, name, numbers)) return cannot_pass(g.name);
            for (const Number& n : numbers) start_ += " " + n.to + " = " + whole_.add(n, patch_texel) + ";";
            return make_plain(u, g, 0);
        }
        Type type = g.type;
        type.dims = 0;
        if (g.type.dims != 1 || !add_numbers(u, type, element_of(from->name, "@V"), "snell_v", numbers))
            return cannot_pass(g.name);
        const std::string function = "snell_of_" + name;
        const int last = u.groups[static_cast<std::size_t>(g.group)].last;
        functions_.emplace_back(last, " " + reader(own_type_name(u, type), function, numbers));
        if (ranges::all_of(g.uses, [&](int i) { return u.at(i + 1).text == "["; })) {
            for (const int i : g.uses) call(i, function);
            g.removed = g.dirty = true;
            return;
        }
        start_ += " for (int snell_i = 0; snell_i < " + number(vertices_) + "; ++snell_i) " + name +
                  "[snell_i] = " + function + "(snell_i);";
        make_plain(u, g, vertices_);
    }

    void take_input(const Block& b) {
        Unit& u = evaluation_;
        const bool patch = b.qualifiers.auxiliary == "patch";
        const std::string type = "snellI" + std::string(b.name), function = "snell_of_" + std::string(b.instance);
        std::vector<Number> numbers;
        for (const Member& m : b.members) {
            const Port* const from = source(std::string(b.name) + "." + std::string(m.name), "");
            if (!from) return;
            const std::string member(m.name),
                to = patch ? (b.instance.empty() ? member : std::string(b.instance) + "." + member)
                           : "snell_v." + member;
            if (!add_numbers(u, m.type, patch ? from->name : element_of(from->name, "@V"), to, numbers))
                return cannot_pass(m.name);
        }
        make_plain(u, b, "snellI", 0);
        if (patch) {
            for (const Number& n : numbers) start_ += " " + n.to + " = " + whole_.add(n, patch_texel) + ";";
            return;
        }
        u.erase(b.close + 1, b.last - 1);
        u.edit(b.last).before.clear();
        functions_.emplace_back(b.last, " " + reader(type, function, numbers));
        for (int i = b.last + 1; i + 1 < static_cast<int>(u.tokens.size()); ++i)
            if (u.at(i).text == b.instance && u.at(i - 1).text != "." && u.at(i + 1).text == "[") call(i, function);
    }

    // name[index] → function(index)
    void call(int token, const std::string& function) {
        Unit& u = evaluation_;
        u.replace(token, function);
        u.replace(token + 1, "(");
        int depth = 1, close = token + 2;
        for (; u.at(close).kind != Kind::end; ++close) {
            depth += u.at(close).text == "[" ? 1 : u.at(close).text == "]" ? -1 : 0;
            if (depth == 0) break;
        }
        u.replace(close, ")");
    }

    void replace_evaluated(int i) {
        Unit& u = evaluation_;
        const std::string_view t = u.at(i).text;
        const bool member = i > 0 && u.at(i - 1).text == ".";
        if (t == "gl_in" && u.at(i + 1).text == "[") call(i, "snell_patch_corner");
        if (t == "gl_in" && u.at(i + 1).text == ".") {  // .length()
            u.replace(i, number(vertices_));
            u.erase(i + 1, i + 4);
        }
        if (t == "gl_Position" && member) u.replace(i, "position");
        if (t == "gl_PointSize" && member) u.replace(i, "size");
        if (t == "gl_TessCoord") u.replace(i, "snell_tess_coord");
        if (t == "gl_PrimitiveID") u.replace(i, "snell_patch");
        if (t == "gl_PatchVerticesIn") u.replace(i, number(vertices_));
        if (t == "gl_TessLevelOuter") u.replace(i, "snell_outer");
        if (t == "gl_TessLevelInner") u.replace(i, "snell_inner");
        replace_limits(u, i);
    }

    std::string evaluation_header() {
        const int whole = static_cast<int>(whole_.written().size()), each = static_cast<int>(each_.written().size());
        const int all = whole + vertices_ * each;
        form_.runs = (all + most_slots - 1) / most_slots;
        form_.slots = (all + form_.runs - 1) / form_.runs;
        form_.corners = corners_;
        return filled(R"(uniform highp usampler2D snell_StagePatches;
layout(location = 0) in highp vec3 snell_Domain;
highp vec3 snell_tess_coord = vec3(0.0);
highp int snell_patch = 0;
highp float snell_outer[4] = float[4](0.0, 0.0, 0.0, 0.0), snell_inner[2] = float[2](0.0, 0.0);
const int snell_each_patch = @PATCH, snell_first_vertex = @FIRST, snell_each_vertex = @EACH;
highp uvec4 snell_texel(int n) { return texelFetch(snell_StagePatches, ivec2(n & 1023, n >> 10), 0); }
@READERS)",
                      {{"@PATCH", number(form_.runs * form_.slots)},
                       {"@FIRST", number(whole)},
                       {"@EACH", number(each)},
                       {"@READERS", readers_}});
    }

    // ---- what both sides hand to the fragment stage

    // As in a program that never had other stages.
    void join_fragment() {
        std::vector<Unit>& units = take_both();
        flatten_blocks(quiet_program_);
        if (options_.target.es) give_point_size(units.front());
        if (take_number(units.back())) {
            units.front().header += "flat out highp int snell_PrimitiveID;\n";
            at_main_start(units.front(), "snell_PrimitiveID = int(snell_Domain.z);");
        }
        for (Unit& u : units) write_declarations(quiet_program_, u);
        put_both();
    }

    // ---- the text that transform feedback captures

    std::string own() const {
        return filled(R"(snell_PerCorner snell_gl_out[@VERTICES];
highp float snell_outer[4] = float[4](0.0, 0.0, 0.0, 0.0), snell_inner[2] = float[2](0.0, 0.0);
void snell_memory() {}
)",
                      {{"@VERTICES", number(vertices_)}});
    }

    std::string run_control() const {
        if (second_.tokens.empty())
            return "    snell_outer = float[4](1.0, 1.0, 1.0, 1.0);\n    snell_inner = float[2](1.0, 1.0);\n";
        std::string text;
        for (int phase = 0; phase <= phases_; ++phase)
            text += filled(R"(    for (int snell_i = 0; snell_i < @VERTICES; ++snell_i) {
        snell_invocation = snell_i;
@RESETS        @PHASE();
@SAVE    }
)",
                           {{"@VERTICES", number(vertices_)},
                            {"@RESETS", phase == 0 ? resets_ : restore_},
                            {"@SAVE", phase < phases_ ? save_ : ""},
                            {"@PHASE", phase == 0 ? "snellGmain" : "snell_phase" + number(phase)}});
        return text;
    }

    std::string control_text() {
        std::vector<std::string> all = whole_.written();
        for (int v = 0; v < vertices_; ++v)
            for (const std::string& slot : each_.written()) all.push_back(filled(slot, {{"@V", number(v)}}));
        std::string declared, captures;
        for (int i = 0; i < form_.slots; ++i) {
            form_.captured.push_back("snell_B" + number(i));
            declared += "flat out highp uvec4 snell_B" + number(i) + ";\n";
            captures += "    snell_B" + number(i) + " = uvec4(0u);\n";
        }
        for (int run = 0; run < form_.runs; ++run) {
            captures += "    if (snell_part == " + number(run) + ") {\n";
            for (int i = 0; i < form_.slots; ++i)
                if (const auto at = static_cast<std::size_t>(run * form_.slots + i); at < all.size())
                    captures += "        snell_B" + number(i) + " = uvec4(" + all[at] + ");\n";
            captures += "    }\n";
        }
        return beginning(own()) + filled(R"(@DECLARED
void main() {
    gl_Position = vec4(0.0);
    gl_PointSize = 1.0;
    snell_primitive = gl_VertexID / @RUNS;
    int snell_part = gl_VertexID - snell_primitive * @RUNS;
@FIRST@CONTROL@CAPTURES}
)",
                                         {{"@DECLARED", declared},
                                          {"@RUNS", number(form_.runs)},
                                          {"@FIRST", run_first()},
                                          {"@CONTROL", run_control()},
                                          {"@CAPTURES", captures}});
    }

    Unit evaluation_;
    EmulatedTessellation form_;
    int vertices_ = -1;                  // that the control stage outputs
    int phases_ = 0;                     // of the control stage, behind barriers
    std::vector<Port> written_;          // what the evaluation stage may read
    Slots whole_, each_;                 // of a patch; of each of its vertices
    std::set<std::string_view> passed_;  // inputs and outputs of the control stage
    std::string resets_, save_, restore_, start_, readers_;
    std::vector<std::pair<int, std::string>> functions_;  // behind tokens
};

}  // namespace

void emulate_tessellation(Program& program, Translation& translation) { TessellationForm(program, translation).run(); }

}  // namespace snell::glsl
