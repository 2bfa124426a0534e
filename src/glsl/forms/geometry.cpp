// A vertex and a geometry stage as vertex shaders, for contexts that have no geometry stage.
//
// Each run of such a shader takes one primitive: it fetches the attributes of the primitive's vertices from textures,
// runs the author's vertex stage for each of them, and then the author's geometry stage. EmitVertex() counts, or keeps
// what is to be captured. No output is indexed, as that is slow, and none is an array, as ANGLE captures none.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/forms/fusion.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

namespace {

// What the geometry stage writes, and what the fragment stage calls it.
struct Passed {
    std::string from, to;
    Type type;
};

class GeometryForm : Fusion {
public:
    GeometryForm(Program& program, Translation& translation) : Fusion(program, translation) {}

    void run() {
        const Unit* const theirs = program_.find(Stage::geometry);  // null: it is snell's
        reference_ = (theirs ? *theirs : program_.units.front()).reference;
        read(*stage(Stage::vertex), stage(Stage::geometry));
        fragment_ = read_again(*stage(Stage::fragment), false);
        if (!ok_ || !read_layouts()) return;
        separate_names();
        share_declarations();
        take_first();
        take_geometry();
        take_fragment();
        if (!ok_ || !pack()) return;
        write_both();
        form_.count = {Stage::vertex, count_text(), files_, {}, written_in_};
        StageOutput* const fragment = stage(Stage::fragment);
        fragment->text = emit(quiet_program_, fragment_);
        StageOutput drawn{Stage::vertex, {}, files_, {}, written_in_};
        if (form_.listed) {
            drawn.text = drawing_text(*fragment);
        } else {
            form_.capture = {Stage::vertex, capture_text(), files_, {}, written_in_};
            drawn = {Stage::vertex, passing_text(), {}};
            drawn.files = {program_.sources.add("<built-in vertex shader>", drawn.text)};
        }
        if (!ok_) return;
        std::erase_if(out_.stages, [](const StageOutput& s) { return s.stage != Stage::fragment; });
        out_.stages.insert(out_.stages.begin(), std::move(drawn));
        out_.geometry = std::move(form_);
    }

private:
    bool read_layouts() {
        for (const StageLayout& l : second_.layouts) {
            const bool in = l.qualifiers.storage == Storage::in;
            for (const LayoutItem& item : l.qualifiers.layout) {
                if (item.name == "invocations") form_.invocations = std::max(1, value_of(second_, item.value));
                if (item.name == "max_vertices") most_ = value_of(second_, item.value);
                if (item.value.empty()) (in ? form_.input : form_.output) = item.name;
            }
            second_.erase(l.qualifiers.first, l.last);
        }
        corners_ = vertices_in(second_);
        if (most_ < 0 || form_.invocations < 1) fail("the number of vertices that this shader emits is not understood");
        words_ = form_.output == "points" ? 0 : most_ / 32 + 1;
        return ok_;
    }

    void take_geometry() {
        leave_redeclarations(second_);
        written_ = ports(second_, Storage::out);
        take_inputs();
        if (!ok_) return;
        make_plain(Storage::out, 0, "snellO");
        replace_built_ins();
    }

    bool may_leave(int token) const {
        return ranges::any_of(second_.functions, [&](const Function& f) {
            return (f.name == "main" || f.name == "snell_main") && f.open < token && token < f.close;
        });
    }

    void replace_built_ins() {
        Unit& u = second_;
        for (int i = 0; i < static_cast<int>(u.tokens.size()); ++i) {
            const std::string_view t = u.at(i).text;
            const bool member = i > 0 && u.at(i - 1).text == ".";
            if (t == "gl_in") u.replace(i, "snell_gl_in");
            if (t == "gl_Position") u.replace(i, member ? "position" : "snell_position");
            if (t == "gl_PointSize") u.replace(i, member ? "size" : "snell_size"), sized_ = sized_ || !member;
            if (t == "gl_PrimitiveIDIn") u.replace(i, "snell_primitive");
            if (t == "gl_InvocationID") u.replace(i, "snell_invocation");
            if (t == "gl_PrimitiveID") u.replace(i, "snell_primitive_out");
            if (t == "gl_Layer" || t == "gl_ViewportIndex") u.erase(i, i + 2);
            if (t == "EndPrimitive") u.replace(i, "snell_end");
            if (t != "EmitVertex") continue;
            u.replace(i, "snell_emit");
            if (!may_leave(i) || u.at(i + 1).text != "(" || u.at(i + 2).text != ")" || u.at(i + 3).text != ";")
                continue;
            u.edit(i).before = "{ if (";  // nothing of what follows is captured
            u.edit(i + 3).after = " return; }";
            u.replace(i + 3, ")");
        }
    }

    void take_fragment() {
        Unit& u = fragment_;
        std::vector<Port> inputs;
        quiet_program_.units.clear();
        for (const Port& input : ports(u, Storage::in)) inputs.push_back(input);
        quiet_program_.units.push_back(u);
        for (const Block& b : u.blocks) {
            if (b.qualifiers.storage != Storage::in || b.name == "gl_PerVertex") continue;
            if (b.arrayed) return fail("the fragment shader's block '" + std::string(b.name) + "' is an array");
            for (Port& input : inputs)
                if (input.key.starts_with(std::string(b.name) + "."))
                    input.name = variable_of(quiet_program_, b.name, input.key.substr(b.name.size() + 1));
            flatten_block(quiet_program_, u, b);
        }
        for (const Port& input : inputs) {
            const Port* from = port_of(written_, input);
            if (!from) continue;
            passed_.push_back({from->name, input.name, from->type});
            outputs_ += declared(input);
        }
        if (!take_number(u)) return;
        outputs_ += "flat out highp int snell_PrimitiveID;\n";
        passed_.push_back({"snell_primitive_out", "snell_PrimitiveID", make_type(Base::integer)});
    }

    std::string declared(const Port& input) {
        std::string text = input.location.empty() ? "" : "layout(location = " + input.location + ") ";
        text += input.qualifiers + " out " + own_type_name(fragment_, input.type) + " " + input.name;
        if (input.type.base == Base::structure) define(input.type.structure);
        return text + (input.type.dims ? "[" + number(input.type.size) + "];\n" : ";\n");
    }

    void define(int structure) {
        if (!defined_.insert(structure).second) return;
        const Struct& s = fragment_.structs[static_cast<std::size_t>(structure)];
        std::string text = "struct " + std::string(s.name) + " {";
        for (const Member& m : s.members) {
            if (m.type.base == Base::structure) define(m.type.structure);
            text += " " + own_type_name(fragment_, m.type) + " " + std::string(m.name) +
                    (m.type.dims ? "[" + number(m.type.size) + "];" : ";");
        }
        structs_ += text + " };\n";
    }

    // Numbers fill slots one after the other: those with fractions first, then whole ones, which keep their bits.
    bool pack() {
        std::vector<Number> numbers;
        passed_.insert(passed_.begin(), {"snell_position", "gl_Position", make_type(Base::real, 4)});
        if (form_.output == "points" && sized_)
            passed_.push_back({"snell_size", "gl_PointSize", make_type(Base::real)});
        for (const Passed& passed : passed_)
            if (!add_numbers(second_, passed.type, passed.from, passed.to, numbers))
                cannot_pass(Stage::fragment, passed.to);
        for (const bool integral : {false, true}) {
            int at = 0;
            for (const Number& n : numbers) {
                if ((n.base != Base::real) != integral) continue;
                if (at++ % 4 == 0) slots_.emplace_back(), form_.integral.push_back(integral);
                std::string& slot = slots_.back();
                slot += (slot.empty() ? "" : ", ") + (integral ? "uint(" + n.from + ")" : n.from);
                const std::string value =
                    "snell_A" + number(static_cast<int>(slots_.size()) - 1) + "." + "xyzw"[(at - 1) % 4];
                hand_on_ += "    " + n.to + " = " + (n.base == Base::integer ? "int(" + value + ")" : value) + ";\n";
            }
            for (; at % 4 != 0; ++at) slots_.back() += integral ? ", 0u" : ", 0.0";
        }
        const int slots = static_cast<int>(slots_.size());
        form_.listed = slots > most_slots;
        form_.most = std::max(most_, 1);
        form_.vertices = std::clamp(most_slots / std::max(slots, 1), 1, std::max(most_, 1));
        return ok_;
    }

    // ---- texts

    static constexpr std::string_view own = R"(highp vec4 snell_position = vec4(0.0);
highp float snell_size = 1.0;
highp int snell_primitive_out = 0, snell_emitted = 0;
bool snell_emit();
void snell_end();
)";

    // The stages for the primitive and the invocation that `snell_item` numbers.
    std::string stages() const {
        return filled(R"(void snell_run(int snell_item) {
    snell_primitive = snell_item / @INVOCATIONS;
    snell_invocation = snell_item - snell_primitive * @INVOCATIONS;
    snell_primitive_out = 0;
    snell_emitted = 0;
    snell_size = 1.0;
@VERTICES    snellGmain();
    snell_end();
}
)",
                      {{"@INVOCATIONS", number(form_.invocations)}, {"@VERTICES", run_first()}});
    }

    std::string count_text() {
        std::string declared, zeros, ends;
        form_.counted = {"snell_Count"};
        for (int i = 0; i < words_; ++i) {
            form_.counted.push_back("snell_Ends" + number(i));
            declared += "flat out highp uint snell_Ends" + number(i) + ";\n";
            zeros += "    snell_ends[" + number(i) + "] = 0u;\n";
            ends += "    snell_Ends" + number(i) + " = snell_ends[" + number(i) + "];\n";
        }
        if (words_ > 0) declared += "uint snell_ends[" + number(words_) + "];\n";
        const std::string_view note = "snell_ends[snell_emitted >> 5] |= 1u << uint(snell_emitted & 31);";
        return beginning(own) + filled(R"(flat out highp uint snell_Count;
@DECLARED
bool snell_emit() {
    if (snell_emitted < @MOST) ++snell_emitted;
    return false;
}
void snell_end() { @NOTE }
@STAGES
void main() {
    gl_Position = vec4(0.0);
    gl_PointSize = 1.0;
@ZEROS    snell_run(gl_VertexID);
    snell_Count = uint(snell_emitted);
@ENDS}
)",
                                       {{"@DECLARED", declared},
                                        {"@MOST", number(most_)},
                                        {"@NOTE", words_ > 0 ? std::string(note) : ""},
                                        {"@STAGES", stages()},
                                        {"@ZEROS", zeros},
                                        {"@ENDS", ends}});
    }

    std::string capture_text() {
        std::string declared, zeros, captures;
        for (int k = 0; k < form_.vertices; ++k) {
            captures += "    if (snell_k == " + number(k) + ") {\n";
            for (std::size_t s = 0; s < slots_.size(); ++s) {
                const std::string name = "snell_B" + number(k) + "_" + std::to_string(s);
                const std::string type = form_.integral[s] ? "uvec4" : "vec4";
                form_.captured.push_back(name);
                declared += (form_.integral[s] ? "flat out highp " : "out highp ") + type + " " + name + ";\n";
                // What is not emitted lies off the screen.
                zeros += "    " + name + " = " + type + (s == 0 ? "(2.0, 2.0, 2.0, 1.0);\n" : "(0);\n");
                captures += "        " + name + " = " + type + "(" + slots_[s] + ");\n";
            }
            captures += "    }\n";
        }
        return beginning(own) + filled(R"(layout(location = 0) in highp ivec2 snell_Slot;
@DECLARED
bool snell_emit() {
    int snell_k = snell_emitted - snell_Slot.y;
    if (snell_emitted >= @MOST) return true;
@CAPTURES    ++snell_emitted;
    return snell_k >= @LAST;
}
void snell_end() {}
@STAGES
void main() {
    gl_Position = vec4(0.0);
    gl_PointSize = 1.0;
@ZEROS    snell_run(snell_Slot.x);
}
)",
                                       {{"@DECLARED", declared},
                                        {"@MOST", number(most_)},
                                        {"@CAPTURES", captures},
                                        {"@LAST", number(form_.vertices - 1)},
                                        {"@STAGES", stages()},
                                        {"@ZEROS", zeros}});
    }

    std::string passing_text() const {
        std::string text = head();
        if (options_.target.es) text += "precision highp float;\nprecision highp int;\n";
        for (std::size_t s = 0; s < slots_.size(); ++s)
            text += "layout(location = " + std::to_string(s) + ") in " + (form_.integral[s] ? "uvec4" : "vec4") +
                    " snell_A" + std::to_string(s) + ";\n";
        const auto [declared, size] = point_size();
        return text + declared + structs_ + outputs_ + "void main() {\n" + hand_on_ + size + "}\n";
    }

    // As give_point_size: the declaration and the statement.
    std::pair<std::string, std::string> point_size() const {
        if (!options_.target.es || form_.output != "points") return {};
        if (!sized_) return {"uniform float snell_PointSize;\n", "    gl_PointSize = snell_PointSize;\n"};
        return {"uniform float snell_FixedPointSize;\n",
                "    if (snell_FixedPointSize > 0.0) gl_PointSize = snell_FixedPointSize;\n"};
    }

    // What the fragment stage reads has other names in it than in the stages that are run here.
    std::string drawing_text(StageOutput& fragment) {
        Unit u = read_again(fragment, false);
        std::string declared = "int snell_wanted = 0;\n", give = "        gl_Position = snell_position;\n";
        for (const Passed& passed : passed_) {
            const auto input = ranges::find(u.globals, passed.to, &Global::name);
            if (passed.to == "gl_PointSize") give += "        gl_PointSize = snell_size;\n";
            if (input != u.globals.end()) give += "        " + pass_as_numbers(u, *input, passed.from, declared) + "\n";
        }
        write_declarations(quiet_program_, u);
        fragment.text = emit(quiet_program_, u);
        const auto [size, sets] = point_size();
        // What is not emitted lies off the screen.
        return beginning(own) + filled(R"(@DECLARED
bool snell_emit() {
    if (snell_emitted == snell_wanted) {
@GIVE    }
    return snell_emitted++ >= snell_wanted;
}
void snell_end() {}
@STAGES
void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = 1.0;
    snell_wanted = gl_VertexID % @MOST;
    snell_run(gl_VertexID / @MOST);
@SETS}
)",
                                       {{"@DECLARED", declared + size},
                                        {"@GIVE", give},
                                        {"@STAGES", stages()},
                                        {"@MOST", number(form_.most)},
                                        {"@SETS", sets}});
    }

    Unit fragment_;
    EmulatedGeometry form_;
    int most_ = -1, words_ = 0;
    std::vector<Port> written_;  // outputs of the geometry stage
    std::vector<Passed> passed_;
    std::string structs_, outputs_, hand_on_;
    std::vector<std::string> slots_;
    std::set<int> defined_;
    bool sized_ = false;
};

}  // namespace

void emulate_geometry(Program& program, Translation& translation) { GeometryForm(program, translation).run(); }

}  // namespace snell::glsl
