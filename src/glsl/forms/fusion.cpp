#include "src/glsl/forms/fusion.h"

#include <algorithm>
#include <charconv>

#include "parser/text/ranges.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

std::string number(int n) { return std::to_string(n); }

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

namespace {

constexpr const char* first_prefix = "snellV";

bool same_members(const Struct& a, const Struct& b) {
    return ranges::equal(a.members, b.members, [](const Member& x, const Member& y) {
        return x.name == y.name && x.type.name == y.type.name && x.type.dims == y.type.dims &&
               x.type.size == y.type.size;
    });
}

bool passes(const Qualifiers& q) { return q.storage == Storage::in || q.storage == Storage::out; }
bool shared(const Qualifiers& q) { return q.storage == Storage::uniform || q.storage == Storage::buffer; }

// Names at global scope that a stage shares with no other; or those that it shares.
std::set<std::string_view> names_of(const Unit& u, bool uniforms) {
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
std::vector<bool> member_tokens(const Unit& u) {
    std::vector<bool> members(u.tokens.size(), false);
    const auto mark = [&](int open) {
        int depth = 0;
        for (int i = open; u.at(i).kind != Kind::end; ++i) {
            const std::string_view t = u.at(i).text, next = u.at(i).kind == Kind::identifier ? u.at(i + 1).text : "";
            depth += t == "{" || t == "[" || t == "(" ? 1 : t == "}" || t == "]" || t == ")" ? -1 : 0;
            if (depth == 0) return;
            if (depth == 1 && (next == ";" || next == "," || next == "[")) members[static_cast<std::size_t>(i)] = true;
        }
    };
    for (int i = 0; i + 2 < static_cast<int>(u.tokens.size()); ++i)
        if (u.at(i).text == "struct" && u.at(i + 2).text == "{") mark(i + 2);
    for (const Block& b : u.blocks)
        if (!b.instance.empty()) mark(b.open);
    return members;
}

void rename(Unit& u, const std::set<std::string_view>& names, const std::string& prefix) {
    const std::vector<bool> members = member_tokens(u);
    for (int i = 0; i < static_cast<int>(u.tokens.size()); ++i)
        if (u.at(i).kind == Kind::identifier && names.contains(u.at(i).text) && !members[static_cast<std::size_t>(i)] &&
            (i == 0 || u.at(i - 1).text != "."))
            u.replace(i, prefix + std::string(u.at(i).text));
}

// One for each vertex of the primitive.
std::string elements(const std::string& type, const std::string& values, int count) {
    std::string all;
    for (int n = 0; n < count; ++n) all += (n ? ", " : "") + type + "(" + values + ")";
    return type + "[" + number(count) + "](" + all + ")";
}

// Arrays without a size, or with the largest, have an element for each vertex of the primitive.
void give_size(Unit& u, int first, int last, int count) {
    for (int k = first; k < last; ++k)
        if (u.at(k).text == "[" && (u.at(k + 1).text == "]" || u.at(k + 2).text == "]")) {
            u.replace(k, "[" + number(count));
            if (u.at(k + 1).text != "]") u.replace(k + 1, "");
        }
}

std::string instance_of(const Unit& u, const Block& b) {
    for (int k = b.close; k <= b.last; ++k)
        if (u.at(k).text == b.instance) return std::string(u.now(k));
    return std::string(b.instance);
}

// What neither WebGL 2 nor these forms have.
constexpr std::string_view refused_names[] = {"gl_Layer", "gl_ViewportIndex", "gl_ClipDistance", "gl_CullDistance"};

// The first layer or viewport is what there is without them: `gl_Layer = 0`.
bool is_first(const Unit& u, int i) {
    return u.at(i + 1).text == "=" && u.at(i + 2).text == "0" && u.at(i + 3).text == ";";
}

// At its place in the author's text.
bool refuses(const Program& program) {
    for (const Unit& u : program.units)
        for (int i = 0; i < static_cast<int>(u.tokens.size()) && u.stage != Stage::fragment; ++i)
            if (ranges::find(refused_names, u.now(i)) != std::end(refused_names) && !is_first(u, i)) {
                program.diagnostics.error(
                    "unsupported-stage", u.span(i),
                    "'" + std::string(u.at(i).text) +
                        "' cannot be used: on this OpenGL, vertex shaders replace geometry and tessellation shaders",
                    "such a shader can neither choose a layer or a viewport nor cull");
                return true;
            }
    return false;
}

}  // namespace

void emulate_stages(Program& program, Translation& translation) {
    const bool tessellates = program.find(Stage::tess_evaluation) != nullptr;
    const bool geometry = program.find(Stage::geometry) != nullptr;
    if ((!tessellates && !geometry) || refuses(program)) return;
    const std::size_t errors = program.diagnostics.errors();
    if (tessellates) emulate_tessellation(program, translation);
    if (geometry && program.diagnostics.errors() == errors) emulate_geometry(program, translation);
}

StageOutput* Fusion::stage(Stage which) {
    const auto found = ranges::find(out_.stages, which, &StageOutput::stage);
    return found == out_.stages.end() ? nullptr : &*found;
}

void Fusion::fail(std::string message) {
    if (ok_) program_.diagnostics.error("unsupported-stage", reference_, std::move(message));
    ok_ = false;
}

void Fusion::cannot_pass(Stage which, std::string_view name) {
    const Unit& u = *program_.find(which);
    const auto token = ranges::find(u.tokens, name, &Token::text);
    if (token != u.tokens.end()) reference_ = u.span(static_cast<int>(token - u.tokens.begin()));
    fail("'" + std::string(name) +
         "' has a type that cannot be passed on this OpenGL, where vertex shaders replace the other stages, such as an "
         "array of arrays");
}

Unit Fusion::read_again(const StageOutput& from, bool apart, std::size_t first_file) {
    Unit u;
    u.stage = from.stage;
    u.verbatim = false;
    preprocess(u, sources_.add("", apart ? this->apart(from.text, first_file) : from.text), sources_, options_, quiet_);
    Parser(u, options_.target, quiet_).run();
    u.edits.clear();  // what there was to mend is mended
    for (Token& t : u.tokens) t.edit = -1;
    if (quiet_.errors() > 0) fail("the shaders are too intricate for an OpenGL that lacks some of their stages");
    return u;
}

// Source strings of the stages are numbered one after the other, and extensions go ahead of both.
std::string Fusion::apart(std::string_view text, std::size_t first_file) {
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

void Fusion::read(const StageOutput& first, const StageOutput* second) {
    first_ = read_again(first, true);
    add_files(first);
    if (!second) return;
    second_file_ = files_.size();
    second_ = read_again(*second, true, second_file_);
    add_files(*second);
}

void Fusion::add_files(const StageOutput& from) {
    for (std::size_t i = 0; i < from.files.size(); ++i) {
        files_.push_back(from.files[i]);
        written_in_.push_back(from.stage_of(i));
    }
}

void Fusion::separate_names() {
    std::set<std::string_view> words, clash;
    for (const Token& t : second_.tokens)
        if (t.kind == Kind::identifier) words.insert(t.text);
    const auto structures = [&](std::string_view name) {
        const auto a = ranges::find(first_.structs, name, &Struct::name);
        const auto b = ranges::find(second_.structs, name, &Struct::name);
        return a != first_.structs.end() && b != second_.structs.end() && same_members(*a, *b);
    };
    for (const std::string_view name : names_of(first_, false)) {
        if (structures(name))
            common_.insert(name);
        else if (words.contains(name))
            clash.insert(name);
    }
    clash.insert("main");
    rename(first_, clash, first_prefix);
    clash = {"main"};
    const std::set<std::string_view> uniforms = names_of(first_, true);
    for (const std::string_view name : names_of(second_, false))
        if (uniforms.contains(name)) clash.insert(name);
    rename(second_, clash, "snellG");
}

void Fusion::share_declarations() {
    for (Global& g : second_.globals)
        if (shared(g.qualifiers) && ranges::any_of(first_.globals, [&](const Global& other) {
                return other.name == g.name && shared(other.qualifiers);
            }))
            g.removed = g.dirty = true;
    for (const Block& b : second_.blocks) {
        const auto other = ranges::find(first_.blocks, b.name, &Block::name);
        if (!shared(b.qualifiers) || other == first_.blocks.end()) continue;
        second_.erase(b.first, b.last);
        if (b.instance != other->instance)
            fail("the " + std::string(stage_name(first_.stage)) + " and the " + std::string(stage_name(second_.stage)) +
                 " shader give the instance of the uniform block '" + std::string(b.name) + "' different names");
    }
    for (int i = 0; i + 2 < static_cast<int>(second_.tokens.size()); ++i) {
        if (second_.at(i).text != "struct" || !common_.contains(second_.at(i + 1).text)) continue;
        int close = i + 2;
        for (int depth = 0; second_.at(close).kind != Kind::end; ++close) {
            depth += second_.at(close).text == "{" ? 1 : second_.at(close).text == "}" ? -1 : 0;
            if (depth == 0) break;
        }
        second_.erase(i, i);
        second_.erase(i + 2, close);
        if (second_.at(close + 1).text == ";") second_.erase(i + 1, close + 1);
    }
}

void Fusion::leave_redeclarations(Unit& u) {
    const auto leave = [&](int first, int last) {
        u.erase(first, last);
        for (int k = first; k <= last; ++k) u.tokens[static_cast<std::size_t>(k)].text = {};  // no name to replace
    };
    for (const auto& [first, last] : u.redeclared) leave(first, last);
    u.redeclared.clear();
    for (Global& g : u.globals)
        if (passes(g.qualifiers) && g.name.starts_with("gl_")) g.removed = g.dirty = true;
    for (const Block& b : u.blocks)
        if (b.name == "gl_PerVertex") leave(b.first, b.last);
}

// Drivers warn of what the text reads above the statement that sets it.
void Fusion::make_plain(Unit& u, Global& g, int count) {
    Type type = g.type;
    if (count > 0) {
        type.size = count;
        g.dims = type.dims == 1 && g.dims != "" ? "[" + number(count) + "]" : g.dims;
        const Group& group = u.groups[static_cast<std::size_t>(g.group)];
        give_size(u, group.type_first, group.type_last, count);
    }
    g.initial = zero_of(u.structs, type);
    const Qualifiers old = g.qualifiers;
    g.qualifiers = {};
    g.qualifiers.precision = old.precision;
    g.qualifiers.first = old.first;
    g.qualifiers.last = old.last;
    g.dirty = true;
}

// A block becomes a structure of that instance, or its members become variables.
void Fusion::make_plain(Unit& u, const Block& b, const std::string& prefix, int count) {
    u.erase(b.first, b.open - 1);
    unqualify_members(u, b);
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
    if (b.arrayed && count > 0) give_size(u, b.close, b.last, count);
    u.edit(b.last).before = " = " + (b.arrayed && count > 0 ? elements(type, zeros, count) : type + "(" + zeros + ")");
}

void Fusion::make_plain(Storage storage, int count, const std::string& prefix) {
    const auto of = [&](const Qualifiers& q) { return q.auxiliary == "patch" ? 0 : count; };
    for (Global& g : second_.globals)
        if (g.qualifiers.storage == storage && !g.removed) make_plain(second_, g, of(g.qualifiers));
    for (const Block& b : second_.blocks)
        if (b.qualifiers.storage == storage && b.name != "gl_PerVertex")
            make_plain(second_, b, prefix, of(b.qualifiers));
}

std::vector<Port> Fusion::ports(const Unit& u, Storage storage) {
    std::vector<Port> found;
    for (const Global& g : u.globals)
        if (g.qualifiers.storage == storage && !g.removed && !g.name.starts_with("gl_"))
            found.push_back({std::string(g.name), std::string(u.now(g.name_token)),
                             std::string(g.qualifiers.interpolation) + " " + std::string(g.qualifiers.auxiliary),
                             std::string(g.qualifiers.layout_value("location")), g.type,
                             g.qualifiers.auxiliary == "patch"});
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
            found.push_back({key, b.instance.empty() ? name : instance_of(u, b) + "." + name, how, "",
                             b.members[n].type, b.qualifiers.auxiliary == "patch"});
        }
    }
    return found;
}

std::string element_of(const std::string& name, const std::string& index) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    return name.substr(0, dot) + "[" + index + "]" + name.substr(dot);
}

std::string Fusion::resets(const Unit& u, const std::string& indent) {
    std::string text;
    for (const Global& g : u.globals)
        if (g.qualifiers.storage == Storage::plain && g.init_first >= 0 && u.now(g.init_first) != "{")
            text += indent + std::string(u.now(g.name_token)) + " = " + render(u, g.init_first, g.init_last) + ";\n";
    return text;
}

void Fusion::take_first() {
    leave_redeclarations(first_);
    given_ = ports(first_, Storage::out);
    fetches_ = resets(first_, "        ");
    for (Global& g : first_.globals) {
        if (g.qualifiers.storage == Storage::in && !g.removed)
            fetches_ += fetch(g, std::string(first_.now(g.name_token)));
        if (passes(g.qualifiers)) make_plain(first_, g, 0);
    }
    for (const Block& b : first_.blocks)
        if (passes(b.qualifiers) && b.name != "gl_PerVertex") make_plain(first_, b, first_prefix, 0);
    for (int i = 0; i < static_cast<int>(first_.tokens.size()); ++i) {
        const std::string_view t = first_.at(i).text;
        if (t == "gl_Position") first_.replace(i, "snell_vertex_position");
        if (t == "gl_PointSize") first_.replace(i, "snell_vertex_size");
        if (t == "gl_VertexID") first_.replace(i, "snell_vertex_id");
        if (t == "gl_InstanceID") first_.replace(i, "0");
    }
}

std::string Fusion::fetch(const Global& g, const std::string& name) {
    const auto attribute = attribute_of(g);
    const std::string swizzle = g.type.rows < 4 ? "." + std::string("xyzw").substr(0, g.type.rows) : "";
    std::string value = "vec4(0.0, 0.0, 0.0, 1.0)";
    if (attribute && static_cast<int>(*attribute) < stage_attributes)
        value = "texelFetch(snell_StageVertices, snell_at(snell_vertex_id * " + number(stage_attributes) + " + " +
                number(static_cast<int>(*attribute)) + "), 0)";
    if (attribute == Attribute::color) value = "(snell_StageRange.y == 0 ? snell_StageColor : " + value + ")";
    return "        " + name + " = " + value + swizzle + ";\n";
}

void Fusion::take_inputs() {
    for (const Port& input : ports(second_, Storage::in)) {
        const Port* const from = port_of(given_, input);
        if (!from)
            return fail("an input of the " + std::string(stage_name(second_.stage)) + " shader, '" + input.key +
                        "', has no output to match");
        if (input.type.dims > 1) return cannot_pass(second_.stage, input.key);
        copies_ += "        " + element_of(input.name, "snell_corner") + " = " + from->name + ";\n";
    }
    make_plain(Storage::in, corners_, "snellI");
}

std::vector<std::string> Fusion::indices_of(const Unit& u, std::string_view dims) {
    constexpr std::size_t most = 4096;
    std::vector<std::string> all{""};
    for (std::size_t at = dims.find('['); at != std::string_view::npos; at = dims.find('[', at + 1)) {
        const int size = value_of(u, dims.substr(at + 1, dims.find(']', at) - at - 1));
        std::vector<std::string> longer;
        if (size > 0 && all.size() * static_cast<std::size_t>(size) <= most)
            for (const std::string& index : all)
                for (int i = 0; i < size; ++i) longer.push_back(index + "[" + number(i) + "]");
        all = std::move(longer);
    }
    return all;
}

bool Fusion::add_numbers(const Unit& u, Type type, const std::string& from, const std::string& to,
                         std::vector<Number>& numbers) {
    if (type.dims > 1 || (type.dims == 1 && type.size <= 0) || numbers.size() > 4096) return false;
    if (type.dims == 1) {
        type.dims = 0;
        for (int i = 0; i < type.size; ++i) {
            const std::string index = "[" + number(i) + "]";
            if (!add_numbers(u, type, from + index, to + index, numbers)) return false;
        }
        return true;
    }
    if (type.base == Base::structure)
        return type.structure >= 0 && ranges::all_of(u.structure(type).members, [&](const Member& m) {
                   const std::string name = "." + std::string(m.name);
                   return add_numbers(u, m.type, from + name, to + name, numbers);
               });
    if (type.base != Base::real && !type.integral()) return false;
    for (int c = 0; c < type.cols; ++c) {
        const std::string column = type.cols > 1 ? "[" + number(c) + "]" : "";
        for (int row = 0; row < type.rows; ++row) {
            const std::string component = column + (type.rows > 1 ? std::string(".") + "xyzw"[row] : "");
            numbers.push_back({from + component, to + component, type.base});
        }
    }
    return true;
}

std::vector<Unit>& Fusion::take_both() {
    std::vector<Unit>& units = quiet_program_.units;
    units.clear();
    units.reserve(out_.stages.size());  // texts may be in the units themselves
    for (const StageOutput& each : out_.stages) units.push_back(read_again(each, false));
    return units;
}

void Fusion::put_both() {
    for (std::size_t i = 0; i < out_.stages.size(); ++i)
        out_.stages[i].text = emit(quiet_program_, quiet_program_.units[i]);
}

bool Fusion::take_number(Unit& fragment) {
    if (!mentions(fragment, "gl_PrimitiveID")) return false;
    for (int i = 0; i < static_cast<int>(fragment.tokens.size()); ++i)
        if (fragment.at(i).text == "gl_PrimitiveID") fragment.replace(i, "snell_PrimitiveID");
    fragment.header += "flat in highp int snell_PrimitiveID;\n";
    return true;
}

int Fusion::value_of(const Unit& u, std::string_view text) {
    int n = -1;
    std::from_chars(text.data(), text.data() + text.size(), n);
    if (n >= 0) return n;
    const auto known = ranges::find(u.globals, text, &Global::name);
    return known != u.globals.end() && known->value.size() == 1 ? static_cast<int>(known->value[0]) : -1;
}

std::string Fusion::own_type_name(const Unit& u, const Type& type) {
    return type.base == Base::structure ? std::string(u.structure(type).name)
                                        : std::string(type_name(type.base, type.rows, type.cols));
}

std::string Fusion::head() const {
    return "#version " + number(options_.target.version) + (options_.target.es ? " es\n" : " core\n");
}

std::string Fusion::text_of(Unit& u, std::size_t first_file) const {
    const std::string text = emit(quiet_program_, u);
    return "\n#line 2 " + std::to_string(first_file) + "\n" +
           text.substr(std::min(text.find('\n'), text.size() - 1) + 1) + "\n";
}

void Fusion::write_both() {
    write_declarations(quiet_program_, first_);
    both_ = text_of(first_, 0);
    if (second_.tokens.empty()) return;
    write_declarations(quiet_program_, second_);
    both_ += text_of(second_, second_file_);
}

std::string Fusion::beginning(std::string_view own) const {
    return head() + extensions_ +
           filled(R"(uniform highp sampler2D snell_StageVertices, snell_StagePrimitives;
uniform highp ivec2 snell_StageRange;
layout(location = @COLOR) in vec4 snell_StageColor;
struct snell_PerCorner { highp vec4 position; highp float size; };
snell_PerCorner snell_gl_in[@CORNERS] = @ZEROS;
highp vec4 snell_vertex_position = vec4(0.0);
highp float snell_vertex_size = 1.0;
highp int snell_vertex_id = 0, snell_primitive = 0, snell_invocation = 0;
ivec2 snell_at(int n) { return ivec2(n & 1023, n >> 10); }
)",
                  {{"@COLOR", number(static_cast<int>(Attribute::color))},
                   {"@CORNERS", number(corners_)},
                   {"@ZEROS", elements("snell_PerCorner", "vec4(0.0), 1.0", corners_)}}) +
           std::string(own) + both_;
}

std::string Fusion::run_first() const {
    return filled(R"(    for (int snell_corner = 0; snell_corner < @CORNERS; ++snell_corner) {
        int snell_n = (snell_StageRange.x + snell_primitive) * @CORNERS + snell_corner;
        snell_vertex_id = int(texelFetch(snell_StagePrimitives, snell_at(snell_n >> 2), 0)[snell_n & 3]);
        snell_vertex_position = vec4(0.0);
        snell_vertex_size = 1.0;
@FETCHES        snellVmain();
        snell_gl_in[snell_corner] = snell_PerCorner(snell_vertex_position, snell_vertex_size);
@COPIES    }
)",
                  {{"@CORNERS", number(corners_)}, {"@FETCHES", fetches_}, {"@COPIES", copies_}});
}

}  // namespace snell::glsl
