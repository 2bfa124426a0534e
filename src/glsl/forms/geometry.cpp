// A vertex and a geometry stage as vertex shaders, for contexts that have no geometry stage.
//
// Each run of such a shader takes one primitive: it fetches the attributes of the primitive's vertices from textures,
// runs the author's vertex stage for each of them, and then the author's geometry stage. EmitVertex() counts, or keeps
// what is to be captured. No output is indexed, as that is slow, and none is an array, as ANGLE captures none.
#include <algorithm>
#include <charconv>

#include "parser/text/ranges.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/preprocess.h"
#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

// What shaders of every context may hand to transform feedback, in slots of four components.
constexpr int most_slots = 15;

// What neither WebGL 2 nor this form has.
constexpr std::string_view refused_names[] = {"gl_Layer",        "gl_ViewportIndex", "gl_ClipDistance",
                                              "gl_CullDistance", "EmitStreamVertex", "EndStreamPrimitive"};

// A number, or a vector of them, in a variable: `path` leads to it.
struct Leaf {
    std::string path;
    Base base;
    int rows;
};

// What the geometry stage writes, and what the fragment stage calls it.
struct Passed {
    std::string from, to;
    Type type;
};

// What passes between two stages, by one key on both sides: the name, or "block.member".
struct Port {
    std::string key, name, qualifiers, location;
    Type type;
};

std::string number(int n) { return std::to_string(n); }

// The text with values in the place of their names.
std::string filled(std::string_view text, std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
    std::string out;
    while (!text.empty()) {
        const std::size_t at = std::min(text.find('@'), text.size());
        out += text.substr(0, at);
        text.remove_prefix(at);
        for (const auto& [name, value] : values)
            if (text.starts_with(name)) {
                out += value;
                text.remove_prefix(name.size());
                break;
            }
    }
    return out;
}

const Port* port_of(const std::vector<Port>& ports, const Port& other) {
    auto found = ranges::find(ports, other.key, &Port::key);
    if (found == ports.end() && !other.location.empty()) found = ranges::find(ports, other.location, &Port::location);
    return found == ports.end() ? nullptr : &*found;
}

std::string own_type_name(const Unit& u, const Type& type) {
    return type.base == Base::structure ? std::string(u.structure(type).name)
                                        : std::string(type_name(type.base, type.rows, type.cols));
}

bool same_members(const Struct& a, const Struct& b) {
    return ranges::equal(a.members, b.members, [](const Member& x, const Member& y) {
        return x.name == y.name && x.type.name == y.type.name && x.type.dims == y.type.dims &&
               x.type.size == y.type.size;
    });
}

class GeometryEmulator {
public:
    GeometryEmulator(Program& program, Translation& out)
        : program_(program), out_(out), options_(program.options), reference_(program.units.front().reference) {}

    void run() {
        if (refuses()) return;
        read();
        if (!ok_ || !read_layouts()) return;
        separate_names();
        share_declarations();
        take_vertex();
        take_geometry();
        take_fragment();
        if (!ok_ || !pack()) return;
        for (Unit* u : {&vertex_, &geometry_}) write_declarations(quiet_program_, *u);
        const StageOutput* const vertex = stage(Stage::vertex);
        both_ = text_of(vertex_, 0) + text_of(geometry_, vertex->files.size());
        files_ = vertex->files;
        files_.insert(files_.end(), stage(Stage::geometry)->files.begin(), stage(Stage::geometry)->files.end());
        form_.count = {Stage::vertex, count_text(), files_};
        form_.capture = {Stage::vertex, capture_text(), files_};
        StageOutput* const fragment = stage(Stage::fragment);
        fragment->text = emit(quiet_program_, fragment_);
        StageOutput passing{Stage::vertex, passing_text(), {}};
        std::erase_if(out_.stages, [](const StageOutput& s) { return s.stage != Stage::fragment; });
        passing.files = {program_.sources.add("<built-in vertex shader>", passing.text)};
        out_.stages.insert(out_.stages.begin(), std::move(passing));
        out_.emulated = std::move(form_);
    }

private:
    StageOutput* stage(Stage which) {
        const auto found = ranges::find(out_.stages, which, &StageOutput::stage);
        return found == out_.stages.end() ? nullptr : &*found;
    }

    void fail(std::string message) {
        if (ok_) program_.diagnostics.error("unsupported-stage", reference_, std::move(message));
        ok_ = false;
    }

    // At its place in the author's text.
    bool refuses() {
        for (const Unit& u : program_.units) {
            if (u.stage == Stage::geometry) reference_ = u.reference;
            for (int i = 0; i < static_cast<int>(u.tokens.size()) && ok_ && u.stage != Stage::fragment; ++i)
                if (ranges::find(refused_names, u.at(i).text) != std::end(refused_names)) {
                    program_.diagnostics.error(
                        "unsupported-stage", u.span(i),
                        "'" + std::string(u.at(i).text) + "' needs geometry shaders, which this OpenGL does not have",
                        "without them, a geometry shader can neither choose layers nor streams nor clip");
                    ok_ = false;
                }
        }
        return !ok_;
    }

    // ---- reading what was translated, with macros expanded: those of one stage must not meet the other

    void read() {
        vertex_ = read_again(*stage(Stage::vertex), 0);
        geometry_ = read_again(*stage(Stage::geometry), stage(Stage::vertex)->files.size());
        fragment_ = read_again(*stage(Stage::fragment), 0);
    }

    Unit read_again(const StageOutput& from, std::size_t first_file) {
        Unit u;
        u.stage = from.stage;
        u.verbatim = false;
        const bool whole = from.stage == Stage::fragment;
        preprocess(u, sources_.add("", whole ? from.text : apart(from.text, first_file)), sources_, options_, quiet_);
        Parser(u, options_.target, quiet_).run();
        u.edits.clear();  // what there was to mend is mended
        for (Token& t : u.tokens) t.edit = -1;
        if (quiet_.errors() > 0) fail("the shaders are too intricate for an OpenGL without geometry shaders");
        return u;
    }

    // Source strings of the stages are numbered one after the other, and extensions go ahead of both.
    std::string apart(std::string_view text, std::size_t first_file) {
        std::string out;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
            std::string line(text.substr(0, end));
            text.remove_prefix(end);
            if (line.starts_with("#extension ")) {
                if (extensions_.find(line) == std::string::npos) extensions_ += line;
                line = "\n";
            }
            const std::size_t file = line.starts_with("#line ") ? line.find(' ', 6) : line.npos;
            if (file != line.npos)
                line = line.substr(0, file + 1) + std::to_string(std::stoul(line.substr(file)) + first_file) + "\n";
            out += line;
        }
        return out;
    }

    bool read_layouts() {
        for (const StageLayout& l : geometry_.layouts) {
            const bool in = l.qualifiers.storage == Storage::in;
            for (const LayoutItem& item : l.qualifiers.layout) {
                if (item.name == "invocations") form_.invocations = std::max(1, value_of(item.value));
                if (item.name == "max_vertices") most_ = value_of(item.value);
                if (item.value.empty()) (in ? form_.input : form_.output) = item.name;
            }
            geometry_.erase(l.qualifiers.first, l.last);
        }
        form_.corners = vertices_in(geometry_);
        if (most_ < 0 || form_.invocations < 1) fail("the number of vertices that this shader emits is not understood");
        words_ = form_.output == "points" ? 0 : most_ / 32 + 1;
        return ok_;
    }

    int value_of(std::string_view text) const {
        int n = -1;
        std::from_chars(text.data(), text.data() + text.size(), n);
        if (n >= 0) return n;
        const auto known = ranges::find(geometry_.globals, text, &Global::name);
        return known != geometry_.globals.end() && known->value.size() == 1 ? static_cast<int>(known->value[0]) : -1;
    }

    // ---- names

    static bool passes(const Qualifiers& q) { return q.storage == Storage::in || q.storage == Storage::out; }
    static bool shared(const Qualifiers& q) { return q.storage == Storage::uniform || q.storage == Storage::buffer; }

    // Names at global scope that a stage shares with no other; or those that it shares.
    static std::set<std::string_view> names_of(const Unit& u, bool uniforms) {
        std::set<std::string_view> names;
        for (const Global& g : u.globals)
            if (shared(g.qualifiers) == uniforms) names.insert(g.name);
        for (const Block& b : u.blocks) {
            if (shared(b.qualifiers) != uniforms) continue;
            if (!b.instance.empty()) names.insert(b.instance);
            if (b.instance.empty())
                for (const Member& m : b.members) names.insert(m.name);
        }
        if (uniforms) return names;
        names.insert(u.function_names.begin(), u.function_names.end());
        for (const Struct& s : u.structs) names.insert(s.name);
        return names;
    }

    // Tokens that name members where structures and blocks declare them.
    static std::vector<bool> member_tokens(const Unit& u) {
        std::vector<bool> members(u.tokens.size(), false);
        const auto mark = [&](int open) {
            int depth = 0;
            for (int i = open; u.at(i).kind != Kind::end; ++i) {
                const std::string_view t = u.at(i).text,
                                       next = u.at(i).kind == Kind::identifier ? u.at(i + 1).text : "";
                depth += t == "{" || t == "[" || t == "(" ? 1 : t == "}" || t == "]" || t == ")" ? -1 : 0;
                if (depth == 0) return;
                if (depth == 1 && (next == ";" || next == "," || next == "["))
                    members[static_cast<std::size_t>(i)] = true;
            }
        };
        for (int i = 0; i + 2 < static_cast<int>(u.tokens.size()); ++i)
            if (u.at(i).text == "struct" && u.at(i + 2).text == "{") mark(i + 2);
        for (const Block& b : u.blocks)
            if (!b.instance.empty()) mark(b.open);
        return members;
    }

    static void rename(Unit& u, const std::set<std::string_view>& names, const std::string& prefix) {
        const std::vector<bool> members = member_tokens(u);
        for (int i = 0; i < static_cast<int>(u.tokens.size()); ++i)
            if (u.at(i).kind == Kind::identifier && names.contains(u.at(i).text) &&
                !members[static_cast<std::size_t>(i)] && (i == 0 || u.at(i - 1).text != "."))
                u.replace(i, prefix + std::string(u.at(i).text));
    }

    // Both stages become one text: what only one of them means gets a name of its own where the other has that word.
    void separate_names() {
        std::set<std::string_view> words, clash;
        for (const Token& t : geometry_.tokens)
            if (t.kind == Kind::identifier) words.insert(t.text);
        const auto structures = [&](std::string_view name) {
            const auto a = ranges::find(vertex_.structs, name, &Struct::name);
            const auto b = ranges::find(geometry_.structs, name, &Struct::name);
            return a != vertex_.structs.end() && b != geometry_.structs.end() && same_members(*a, *b);
        };
        for (const std::string_view name : names_of(vertex_, false)) {
            if (structures(name))
                common_.insert(name);
            else if (words.contains(name))
                clash.insert(name);
        }
        rename(vertex_, clash, vertex_prefix);
        clash = {"main"};
        const std::set<std::string_view> uniforms = names_of(vertex_, true);
        for (const std::string_view name : names_of(geometry_, false))
            if (uniforms.contains(name)) clash.insert(name);
        rename(geometry_, clash, "snellG");
    }

    // What both declare is declared once.
    void share_declarations() {
        for (Global& g : geometry_.globals)
            if (shared(g.qualifiers) && ranges::any_of(vertex_.globals, [&](const Global& v) {
                    return v.name == g.name && shared(v.qualifiers);
                }))
                g.removed = g.dirty = true;
        for (const Block& b : geometry_.blocks) {
            const auto other = ranges::find(vertex_.blocks, b.name, &Block::name);
            if (!shared(b.qualifiers) || other == vertex_.blocks.end()) continue;
            geometry_.erase(b.first, b.last);
            if (b.instance != other->instance)
                fail("the vertex and the geometry shader give the instance of the uniform block '" +
                     std::string(b.name) + "' different names");
        }
        for (int i = 0; i + 2 < static_cast<int>(geometry_.tokens.size()); ++i) {
            if (geometry_.at(i).text != "struct" || !common_.contains(geometry_.at(i + 1).text)) continue;
            int close = i + 2;
            for (int depth = 0; geometry_.at(close).kind != Kind::end; ++close) {
                depth += geometry_.at(close).text == "{" ? 1 : geometry_.at(close).text == "}" ? -1 : 0;
                if (depth == 0) break;
            }
            geometry_.erase(i, i);
            geometry_.erase(i + 2, close);
            if (geometry_.at(close + 1).text == ";") geometry_.erase(i + 1, close + 1);
        }
    }

    // ---- stages

    static void leave_redeclarations(Unit& u) {
        for (const auto& [first, last] : u.invariants) u.erase(first, last);
        u.invariants.clear();
        for (Global& g : u.globals)
            if (passes(g.qualifiers) && g.name.starts_with("gl_")) g.removed = g.dirty = true;
        for (const Block& b : u.blocks)
            if (b.name == "gl_PerVertex") u.erase(b.first, b.last);
    }

    // Drivers warn of what the text reads above the statement that sets it.
    void make_plain(const Unit& u, Global& g) const {
        Type type = g.type;
        if (type.dims == 1 && type.size < 0) type.size = form_.corners;
        g.initial = zero_of(u.structs, type);
        const Qualifiers old = g.qualifiers;
        g.qualifiers = {};
        g.qualifiers.precision = old.precision;
        g.qualifiers.first = old.first;
        g.qualifiers.last = old.last;
        g.dirty = true;
    }

    // A block becomes a structure of that instance, or its members become variables.
    void make_plain(Unit& u, const Block& b, const std::string& prefix) {
        u.erase(b.first, b.open - 1);
        for (const auto& [first, last] : b.member_tokens)
            for (int k = first; k <= last && is_qualifier(u.at(k).text); ++k) {
                int end = k;
                if (u.at(k).text == "layout")
                    while (end < last && u.at(end).text != ")") ++end;
                if (u.at(k).text != "highp" && u.at(k).text != "mediump" && u.at(k).text != "lowp") u.erase(k, end);
                k = end;
            }
        std::string zeros;
        for (std::size_t n = 0; n < b.members.size(); ++n) {
            const std::string value = zero_of(u.structs, b.members[n].type);
            zeros += (n ? ", " : "") + value;
            if (b.instance.empty() && !value.empty()) u.edit(b.member_tokens[n].second).before = " = " + value;
        }
        if (b.instance.empty()) {
            u.erase(b.open, b.open);
            u.erase(b.close, b.last);
            return;
        }
        const std::string type = prefix + std::string(b.name);
        u.replace(b.first, "struct " + type + " ");
        give_size(u, b.close, b.last);
        u.edit(b.last).before = " = " + (b.arrayed ? elements(type, zeros) : type + "(" + zeros + ")");
    }

    // One for each vertex of the primitive.
    std::string elements(const std::string& type, const std::string& values) const {
        std::string all;
        for (int n = 0; n < form_.corners; ++n) all += (n ? ", " : "") + type + "(" + values + ")";
        return type + "[" + number(form_.corners) + "](" + all + ")";
    }

    // Arrays of inputs have an element for each vertex of the primitive.
    void give_size(Unit& u, int first, int last) const {
        for (int k = first; k < last; ++k)
            if (u.at(k).text == "[" && u.at(k + 1).text == "]") u.replace(k, "[" + number(form_.corners));
    }

    static std::vector<Port> ports(const Unit& u, Storage storage) {
        std::vector<Port> found;
        for (const Global& g : u.globals)
            if (g.qualifiers.storage == storage && !g.removed && !g.name.starts_with("gl_"))
                found.push_back({std::string(g.name), std::string(u.now(g.name_token)),
                                 std::string(g.qualifiers.interpolation) + " " + std::string(g.qualifiers.auxiliary),
                                 std::string(g.qualifiers.layout_value("location")), g.type});
        for (const Block& b : u.blocks) {
            if (b.qualifiers.storage != storage || b.name == "gl_PerVertex") continue;
            for (std::size_t n = 0; n < b.members.size(); ++n) {
                const auto [first, last] = b.member_tokens[n];
                std::string how(b.qualifiers.interpolation), name(b.members[n].name);
                for (int k = first; k < last; ++k) {
                    const std::string_view t = u.at(k).text;
                    if (t == "flat" || t == "smooth" || t == "noperspective" || t == "centroid" || t == "sample")
                        how += " " + std::string(t);
                    if (b.instance.empty() && t == name) name = u.now(k);
                }
                const std::string key = std::string(b.name) + "." + std::string(b.members[n].name);
                found.push_back(
                    {key, b.instance.empty() ? name : instance_of(u, b) + "." + name, how, "", b.members[n].type});
            }
        }
        return found;
    }

    static std::string instance_of(const Unit& u, const Block& b) {
        for (int k = b.close; k <= b.last; ++k)
            if (u.at(k).text == b.instance) return std::string(u.now(k));
        return std::string(b.instance);
    }

    void take_vertex() {
        leave_redeclarations(vertex_);
        given_ = ports(vertex_, Storage::out);
        for (Global& g : vertex_.globals) {
            const std::string name(vertex_.now(g.name_token));
            if (g.qualifiers.storage == Storage::in && !g.removed) fetches_ += fetch(g, name);
            if (g.qualifiers.storage == Storage::plain && g.init_first >= 0 && vertex_.now(g.init_first) != "{")
                fetches_ += "        " + name + " = " + render(vertex_, g.init_first, g.init_last) + ";\n";
            if (passes(g.qualifiers)) make_plain(vertex_, g);
        }
        for (const Block& b : vertex_.blocks)
            if (passes(b.qualifiers) && b.name != "gl_PerVertex") make_plain(vertex_, b, "snellV");
        for (int i = 0; i < static_cast<int>(vertex_.tokens.size()); ++i) {
            const std::string_view t = vertex_.at(i).text;
            if (t == "gl_Position") vertex_.replace(i, "snell_vertex_position");
            if (t == "gl_PointSize") vertex_.replace(i, "snell_vertex_size");
            if (t == "gl_VertexID") vertex_.replace(i, "snell_vertex_id");
            if (t == "gl_InstanceID") vertex_.replace(i, "0");
        }
    }

    std::string fetch(const Global& g, const std::string& name) {
        const auto attribute = attribute_of(g);
        const std::string swizzle = g.type.rows < 4 ? "." + std::string("xyzw").substr(0, g.type.rows) : "";
        std::string value = "vec4(0.0, 0.0, 0.0, 1.0)";
        if (attribute && static_cast<int>(*attribute) < stage_attributes)
            value = "texelFetch(snell_StageVertices, snell_at(snell_vertex_id * " + number(stage_attributes) + " + " +
                    number(static_cast<int>(*attribute)) + "), 0)";
        if (attribute == Attribute::color) {
            value = "(snell_StageRange.y == 0 ? snell_StageColor : " + value + ")";
        }
        return "        " + name + " = " + value + swizzle + ";\n";
    }

    void take_geometry() {
        leave_redeclarations(geometry_);
        written_ = ports(geometry_, Storage::out);
        const std::vector<Port> inputs = ports(geometry_, Storage::in);
        for (const Port& input : inputs) {
            const Port* const from = port_of(given_, input);
            if (!from) return fail("an input of the geometry shader, '" + input.key + "', has no output to match");
            const std::size_t dot = input.name.find('.');
            const std::string element = input.name.substr(0, dot) + "[snell_corner]";
            copies_ += "        " + element + (dot == input.name.npos ? "" : input.name.substr(dot)) + " = " +
                       from->name + ";\n";
        }
        for (Global& g : geometry_.globals) {
            if (!passes(g.qualifiers) || g.removed) continue;
            if (g.qualifiers.storage == Storage::in) {
                if (g.dims == "[]") g.dims = "[" + number(form_.corners) + "]";
                const Group& group = geometry_.groups[static_cast<std::size_t>(g.group)];
                give_size(geometry_, group.type_first, group.type_last);
            }
            make_plain(geometry_, g);
        }
        for (const Block& b : geometry_.blocks)
            if (passes(b.qualifiers) && b.name != "gl_PerVertex")
                make_plain(geometry_, b, b.qualifiers.storage == Storage::in ? "snellI" : "snellO");
        replace_built_ins();
    }

    bool may_leave(int token) const {
        return ranges::any_of(geometry_.functions, [&](const Function& f) {
            return (f.name == "main" || f.name == "snell_main") && f.open < token && token < f.close;
        });
    }

    void replace_built_ins() {
        Unit& u = geometry_;
        for (int i = 0; i < static_cast<int>(u.tokens.size()); ++i) {
            const std::string_view t = u.at(i).text;
            const bool member = i > 0 && u.at(i - 1).text == ".";
            if (t == "gl_in") u.replace(i, "snell_gl_in");
            if (t == "gl_Position") u.replace(i, member ? "position" : "snell_position");
            if (t == "gl_PointSize") u.replace(i, member ? "size" : "snell_size"), sized_ = sized_ || !member;
            if (t == "gl_PrimitiveIDIn") u.replace(i, "snell_primitive");
            if (t == "gl_InvocationID") u.replace(i, "snell_invocation");
            if (t == "gl_PrimitiveID") u.replace(i, "snell_primitive_out");
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
        for (int i = 0; i < static_cast<int>(u.tokens.size()); ++i) {
            if (u.at(i).text != "gl_PrimitiveID") continue;
            u.replace(i, "snell_PrimitiveID");
            reads_number_ = true;
        }
        if (!reads_number_) return;
        u.header = "flat in highp int snell_PrimitiveID;\n";
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

    // ---- slots

    bool leaves(Type type, const std::string& path, std::vector<Leaf>& found) const {
        if (type.dims > 1 || (type.dims == 1 && type.size <= 0) || found.size() > 64) return false;
        if (type.dims == 1) {
            type.dims = 0;
            for (int i = 0; i < type.size; ++i)
                if (!leaves(type, path + "[" + number(i) + "]", found)) return false;
            return true;
        }
        if (type.base == Base::structure)
            return type.structure >= 0 && ranges::all_of(geometry_.structure(type).members, [&](const Member& m) {
                       return leaves(m.type, path + "." + std::string(m.name), found);
                   });
        if (type.base != Base::real && !type.integral()) return false;
        for (int c = 0; c < type.cols; ++c)
            found.push_back({type.cols > 1 ? path + "[" + number(c) + "]" : path, type.base, type.rows});
        return true;
    }

    // Numbers fill slots one after the other: those with fractions first, then whole ones, which keep their bits.
    bool pack() {
        struct Number {
            std::string from, to;
            Base base;
        };
        std::vector<Number> numbers;
        const auto add = [&](const std::string& from, const std::string& to, Base base, int rows) {
            for (int row = 0; row < rows; ++row) {
                const std::string component = rows > 1 ? std::string(".") + "xyzw"[row] : "";
                numbers.push_back({from + component, to + component, base});
            }
        };
        add("snell_position", "gl_Position", Base::real, 4);
        if (form_.output == "points" && sized_) add("snell_size", "gl_PointSize", Base::real, 1);
        for (const Passed& passed : passed_) {
            std::vector<Leaf> parts;
            if (!leaves(passed.type, "", parts))
                fail("'" + passed.from + "' is of a type that cannot be handed on without geometry shaders");
            for (const Leaf& leaf : parts) add(passed.from + leaf.path, passed.to + leaf.path, leaf.base, leaf.rows);
        }
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
        if (slots > most_slots)
            fail("the geometry shader hands on " + number(slots * 4) +
                 " numbers for each vertex; without geometry shaders this OpenGL takes " + number(most_slots * 4));
        form_.vertices = std::clamp(most_slots / std::max(slots, 1), 1, std::max(most_, 1));
        return ok_;
    }

    // ---- texts

    std::string head() const {
        return "#version " + number(options_.target.version) + (options_.target.es ? " es\n" : " core\n");
    }

    std::string text_of(Unit& u, std::size_t first_file) const {
        const std::string text = emit(quiet_program_, u);
        return "\n#line 2 " + std::to_string(first_file) + "\n" +
               text.substr(std::min(text.find('\n'), text.size() - 1) + 1) + "\n";
    }

    std::string beginning() const {
        const std::string corner = "snell_PerCorner";
        return head() + extensions_ +
               filled(R"(uniform highp sampler2D snell_StageVertices, snell_StagePrimitives;
uniform highp ivec2 snell_StageRange;
layout(location = @COLOR) in vec4 snell_StageColor;
struct snell_PerCorner { highp vec4 position; highp float size; };
snell_PerCorner snell_gl_in[@CORNERS] = @ZEROS;
highp vec4 snell_vertex_position = vec4(0.0), snell_position = vec4(0.0);
highp float snell_vertex_size = 1.0, snell_size = 1.0;
highp int snell_vertex_id = 0, snell_primitive = 0, snell_primitive_out = 0, snell_invocation = 0, snell_emitted = 0;
bool snell_emit();
void snell_end();
ivec2 snell_at(int n) { return ivec2(n & 1023, n >> 10); }
)",
                      {{"@COLOR", number(static_cast<int>(Attribute::color))},
                       {"@CORNERS", number(form_.corners)},
                       {"@ZEROS", elements(corner, "vec4(0.0), 1.0")}}) +
               both_;
    }

    // The stages for the primitive and the invocation that `snell_item` numbers.
    std::string stages() const {
        return filled(R"(void snell_run(int snell_item) {
    snell_primitive = snell_item / @INVOCATIONS;
    snell_invocation = snell_item - snell_primitive * @INVOCATIONS;
    snell_primitive_out = 0;
    snell_emitted = 0;
    snell_size = 1.0;
    for (int snell_corner = 0; snell_corner < @CORNERS; ++snell_corner) {
        int snell_n = (snell_StageRange.x + snell_primitive) * @CORNERS + snell_corner;
        snell_vertex_id = int(texelFetch(snell_StagePrimitives, snell_at(snell_n >> 2), 0)[snell_n & 3]);
        snell_vertex_position = vec4(0.0);
        snell_vertex_size = 1.0;
@FETCHES        snellVmain();
        snell_gl_in[snell_corner] = snell_PerCorner(snell_vertex_position, snell_vertex_size);
@COPIES    }
    snellGmain();
    snell_end();
}
)",
                      {{"@INVOCATIONS", number(form_.invocations)},
                       {"@CORNERS", number(form_.corners)},
                       {"@FETCHES", fetches_},
                       {"@COPIES", copies_}});
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
        return beginning() + filled(R"(flat out highp uint snell_Count;
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
        return beginning() + filled(R"(layout(location = 0) in highp ivec2 snell_Slot;
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
        std::string size;
        const bool points = form_.output == "points";
        if (options_.target.es && points) {  // as give_point_size
            text += sized_ ? "uniform float snell_FixedPointSize;\n" : "uniform float snell_PointSize;\n";
            size = sized_ ? "    if (snell_FixedPointSize > 0.0) gl_PointSize = snell_FixedPointSize;\n"
                          : "    gl_PointSize = snell_PointSize;\n";
        }
        return text + structs_ + outputs_ + "void main() {\n" + hand_on_ + size + "}\n";
    }

    static constexpr const char* vertex_prefix = "snellV";

    Program& program_;
    Translation& out_;
    Options options_;
    Span reference_;
    bool ok_ = true;
    Sources sources_;
    Diagnostics quiet_;
    Program quiet_program_{options_, sources_, quiet_, {}, {}, {}, {}};
    Unit vertex_, geometry_, fragment_;
    EmulatedGeometry form_;
    int most_ = -1, words_ = 0;
    std::set<std::string_view> common_;  // structures of both stages
    std::vector<Port> given_, written_;  // outputs of the vertex and of the geometry stage
    std::vector<Passed> passed_;
    std::string extensions_, fetches_, copies_, structs_, outputs_, hand_on_, both_;
    std::vector<std::string> slots_;
    std::vector<FileId> files_;
    std::set<int> defined_;
    bool sized_ = false, reads_number_ = false;
};

}  // namespace

void emulate_geometry(Program& program, Translation& translation) {
    const auto geometry = ranges::find(translation.stages, Stage::geometry, &StageOutput::stage);
    if (geometry != translation.stages.end()) GeometryEmulator(program, translation).run();
}

}  // namespace snell::glsl
