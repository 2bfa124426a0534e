// Stages: their tokens and trees, what is known of their expressions, and which of their texts may be edited.
#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"
#include "src/plan/texts.h"

namespace snell::accuracy {

using glsl::Form;
using glsl::Node;

Shader::Shader(const Plan& given, const glsl::StageInput& stage, Sources& texts, const glsl::Options& wanted)
    : plan(given), sources(texts), defines(wanted.defines) {
    glsl::Options options = wanted;
    std::set<std::string, std::less<>> embedded;
    options.include = [&](std::string_view from, std::string_view name, bool angle) {
        auto text = wanted.include ? wanted.include(from, name, angle) : std::nullopt;
        if (text && angle) embedded.insert(text->name);
        return text;
    };
    Diagnostics unheard;  // compiling says it
    unit.stage = stage.stage;
    unit.reference = stage.reference;
    glsl::preprocess(unit, stage.file, sources, options, unheard);
    unit.tree = &tree;
    glsl::Parser(unit, options.target, unheard).run();
    for (const FileId file : unit.files) {
        // A text that several stages include was added for each of them.
        FileId first = 0;
        while (first < file && sources.name(first) != sources.name(file)) ++first;
        files.push_back(first);
        library.push_back(embedded.contains(sources.name(file)) || sources.text(first) != sources.text(file));
    }
    link();
}

// Parents, functions and loops, once for all.
void Shader::link() {
    parents_.assign(tree.size(), -1);
    for (int n = 0; n < nodes(); ++n)
        for (const int part : parts(n)) parents_[static_cast<std::size_t>(part)] = n;
    const int tokens = static_cast<int>(unit.tokens.size());
    functions_.assign(unit.tokens.size(), -1);
    free_.assign(unit.tokens.size(), false);
    uses_.resize(unit.code.variables.size());
    declarators_.assign(unit.code.variables.size(), -1);
    for (int n = 0; n < nodes(); ++n) {
        const Node& node = at(n);
        if (node.variable < 0) continue;
        if (node.form == Form::name) uses_[static_cast<std::size_t>(node.variable)].push_back(n);
        if (node.form == Form::declarator) declarators_[static_cast<std::size_t>(node.variable)] = n;
    }
    for (std::size_t f = 0; f < unit.functions.size(); ++f)
        for (int k = unit.functions[f].open; k >= 0 && k < std::min(unit.functions[f].close, tokens); ++k)
            functions_[static_cast<std::size_t>(k)] = static_cast<int>(f);
    changed_.assign(unit.code.variables.size(), false);
    for (int n = 0; n < nodes(); ++n)
        if (at(n).form == Form::name && at(n).variable >= 0 && written(n))
            changed_[static_cast<std::size_t>(at(n).variable)] = true;
    for (int n = 0; n < nodes(); ++n) {
        const Node& loop = at(n);
        if (loop.form != Form::loop || (loop.text == "for" && !counters(*this, n).empty())) continue;
        for (int k = std::max(loop.first, 0); k <= std::min(loop.last, tokens - 1); ++k)
            free_[static_cast<std::size_t>(k)] = true;
    }
    link_expressions();
    link_calls();
}

namespace {

// Whether a condition compares constants, as those of ladders do, and whether it holds then.
std::optional<bool> decided(const Shader& s, int condition) {
    const Node& node = s.at(s.bare(condition));
    if (node.form != Form::infix || (node.text != "==" && node.text != "!=")) return std::nullopt;
    const std::vector<int> sides = s.parts(s.bare(condition));
    const auto &a = s.at(s.bare(sides[0])).value, &b = s.at(s.bare(sides[1])).value;
    if (a.size() != 1 || b.size() != 1) return std::nullopt;
    return (a == b) == (node.text == "==");
}

}  // namespace

void Shader::link_calls() {
    idle_.assign(unit.tokens.size(), false);
    if (!unit.code.whole || main() < 0) return;
    const auto end = [](auto first, auto last) { return last < first ? first : last + 1; };
    const auto rest = [&](int first, int last) {
        if (first >= 0) std::fill(idle_.begin() + first, idle_.begin() + end(first, last), true);
    };
    for (int n = 0; n < nodes(); ++n) {
        if (at(n).form != Form::branch && at(n).form != Form::choose) continue;
        const std::vector<int> arms = parts(n);
        const auto holds = arms.size() > 1 ? decided(*this, arms[0]) : std::nullopt;
        const std::size_t left_out = holds && *holds ? 2 : 1;
        if (holds && left_out < arms.size()) rest(at(arms[left_out]).first, at(arms[left_out]).last);
    }
    std::map<int, std::set<std::string_view>> called;  // by the function that calls
    for (int n = 0; n < nodes(); ++n)
        if (at(n).form == Form::call && runs(at(n).first)) called[function_of(at(n).first)].insert(at(n).text);
    std::set<std::string_view> reached = called[-1];
    std::vector<std::string_view> open(reached.begin(), reached.end());
    open.push_back(function(main()).name);
    while (!open.empty()) {
        const std::string_view name = open.back();
        open.pop_back();
        reached.insert(name);
        for (std::size_t f = 0; f < unit.functions.size(); ++f)
            if (unit.functions[f].name == name)
                for (const std::string_view other : called[static_cast<int>(f)])
                    if (!reached.contains(other)) open.push_back(other);
    }
    for (const glsl::Function& f : unit.functions)
        if (f.open >= 0 && !reached.contains(f.name)) rest(f.first, f.close);
}

void Shader::link_expressions() {
    constexpr int deepest = 100;
    depths_.assign(tree.size(), 0);
    for (int n = 0; n < nodes(); ++n) {
        const Node& node = at(n);
        const bool call = node.form == Form::construct || node.form == Form::call || node.form == Form::built_in;
        const bool never = node.form == Form::other || node.form == Form::list || node.form == Form::length ||
                           node.form == Form::comma || node.form >= Form::declarator;
        if (never || node.first < 0 || node.last < node.first) continue;
        if (call && token(node.first + 1).text != "(") continue;  // casts and arrays
        int depth = 1;
        for (const int part : parts(n)) {
            const int inside = depths_[static_cast<std::size_t>(part)];
            depth = inside == 0 || inside == deepest ? deepest + 1 : std::max(depth, inside + 1);
        }
        if (depth > deepest) continue;
        depths_[static_cast<std::size_t>(n)] = depth;
        if (function_of(node.first) >= 0) expressions_.push_back(n);
    }
    ranges::stable_sort(expressions_, std::less<>(), [&](int n) { return std::pair(at(n).first, -n); });
}

int Shader::bare(int node) const {
    while (at(node).form == Form::group && at(node).begin < node) node = parts(node).back();
    return node;
}

bool Shader::own(int first, int last) const {
    const int end = static_cast<int>(unit.tokens.size()) - 1;  // the last token is no token of the text
    if (first < 0 || last < first || last >= end) return false;
    const glsl::Token& begin = token(first);
    if (begin.file >= files.size() || library[begin.file]) return false;
    const std::string_view all = sources.text(files[begin.file]);
    std::size_t from = begin.offset;
    for (int k = first; k <= last; ++k) {
        const glsl::Token& t = token(k);
        if (t.macro >= 0 || t.file != begin.file || t.offset < from || t.offset > all.size()) return false;
        if (all.substr(from, t.offset - from).find('#') != std::string_view::npos) return false;
        from = unit.span(k).end;
    }
    return from <= all.size();
}

std::optional<Span> Shader::place(int first, int last) const {
    if (first < 0 || last < first || last >= static_cast<int>(unit.tokens.size())) return std::nullopt;
    const glsl::Token &a = token(first), &b = token(last);
    if (a.macro >= 0 || b.macro >= 0 || a.file != b.file || b.offset < a.offset) return std::nullopt;
    if (a.file >= files.size() || library[a.file]) return std::nullopt;
    const Span whole = span(first, last);
    if (whole.end > sources.text(whole.file).size()) return std::nullopt;
    const std::string_view text = sources.text(whole.file).substr(whole.begin, whole.end - whole.begin);
    for (std::size_t line = text.find('\n'); line != text.npos; line = text.find('\n', line + 1)) {
        const std::size_t begin = text.find_first_not_of(" \t\r", line + 1);
        if (begin != text.npos && text[begin] == '#') return std::nullopt;
    }
    return whole;
}

Span Shader::span(int first, int last) const {
    return {files[token(first).file], unit.span(first).begin, unit.span(last).end};
}

std::string Shader::text(const Span& span) const {
    return std::string(sources.text(span.file).substr(span.begin, span.end - span.begin));
}

bool Shader::alike(int a, int b) const {
    const Node &x = at(a), &y = at(b);
    if (x.last - x.first != y.last - y.first || x.first < 0 || y.first < 0) return false;
    for (int k = 0; k <= x.last - x.first; ++k)
        if (token(x.first + k).text != token(y.first + k).text) return false;
    return true;
}

int Shader::function_of(int token) const {
    return token >= 0 && token < static_cast<int>(functions_.size()) ? functions_[static_cast<std::size_t>(token)] : -1;
}

int Shader::main() const {
    for (std::size_t f = 0; f < unit.functions.size(); ++f)
        if (unit.functions[f].name == "main" && unit.functions[f].open >= 0) return static_cast<int>(f);
    return -1;
}

bool Shader::written(int name) const {
    int node = name, around = parent(name);
    const auto first_of = [&](Form form) { return at(around).form == form && at(around).begin == at(node).begin; };
    for (; around >= 0; node = around, around = parent(around))
        if (!first_of(Form::select) && !first_of(Form::index) && !first_of(Form::group)) break;
    if (around < 0) return false;
    const Node& n = at(around);
    if (n.form == Form::step || first_of(Form::assign)) return true;
    if (n.form == Form::built_in) return (n.text == "modf" || n.text == "frexp") && !first_of(Form::built_in);
    if (n.form != Form::call) return false;
    if (n.function < 0 || around - n.begin > 10'000) return true;
    const std::vector<int> given = parts(around);
    const auto which = static_cast<std::size_t>(std::find(given.begin(), given.end(), node) - given.begin());
    const auto& parameters = function(n.function).parameters;
    return which >= parameters.size() || parameters[which].storage != glsl::Storage::in;
}

int Shader::statement(int node) const {
    while (node >= 0 && at(node).form <= Form::declarator) node = parent(node);
    return node;
}

int Shader::loop_around(int node) const {
    while (node >= 0 && at(node).form != Form::loop) node = parent(node);
    return node;
}

std::optional<Span> Shader::ahead_of(int index) const {
    if (index < 0) return std::nullopt;
    const int first = function(index).first;
    if (!own(first, first)) return std::nullopt;
    const Span place = span(first, first);
    return Span{place.file, place.begin, place.begin};
}

// ---- expressions --------------------------------------------------------------------------------------------

Expression Expression::at(const Shader& shader, int token) {
    const auto& all = shader.expressions();
    const auto found = std::lower_bound(all.begin(), all.end(), token,
                                        [&](int node, int wanted) { return shader.at(node).first < wanted; });
    return found != all.end() && shader.at(*found).first == token ? Expression(shader, *found) : Expression();
}

std::string_view Expression::text() const {
    if (!*this) return {};
    const Node& n = s_->at(node_);
    return call() || n.form == Form::number ? s_->token(n.first).text : n.text;
}

Expression Expression::operator[](std::size_t part) const {
    if (!*this) return {};
    const std::vector<int> all = s_->parts(node_);
    return part < all.size() ? Expression(*s_, all[part]) : Expression();
}

Expression Expression::initial() const {
    const int variable = name() ? s_->at(node_).variable : -1;
    const int declarator = variable < 0 || s_->changes(variable) ? -1 : s_->declarator(variable);
    if (declarator < 0) return {};
    const Node& n = s_->at(declarator);
    const std::vector<int> value = s_->parts(declarator);
    const int within = s_->function_of(n.first);
    const bool one = value.size() == 1 && s_->token(n.first + 1).text == "=";
    return one && within >= 0 && within == s_->function_of(first()) ? Expression(*s_, value.front()) : Expression();
}

Expression Expression::resolved() const {
    Expression now = bare();
    for (int steps = 0; steps < 4; ++steps) {
        const Expression value = now.initial();
        if (!value) break;
        now = value.bare();
    }
    return now;
}

std::optional<double> Expression::number() const {
    const Expression e = bare();
    if (e.is(Form::prefix, "-")) {
        const auto value = e[0].number();
        return value ? std::optional(-*value) : std::nullopt;
    }
    if (!e.is(Form::number) || s_->token(e.first()).kind == glsl::Kind::identifier) return std::nullopt;
    double value = 0;
    read_real(e.text().data(), e.text().data() + e.text().size(), value);
    return value;
}

bool Expression::same(const Expression& other) const {
    return *this && other && s_->alike(bare().node(), other.bare().node());
}

Reading::Reading(const Plan& plan_read, Files& its_files, Sources& its_sources)
    : plan(plan_read), files(its_files), sources(its_sources) {
    std::map<std::string, Shader*> known;  // by text, stage and macros
    for (const PlannedProgram& planned : plan.programs) {
        if (!planned.readable) continue;
        const Program& program = plan.scene.programs[planned.program];
        glsl::Options options;
        options.include = shader_includes(files);
        options.limits = files.limits();
        options.geometry_input = program.geometry_input;
        options.geometry_output = program.geometry_output;
        options.defines = ladder_defines(
            std::span(plan.scene.ladders).first(std::min(program.ladders, plan.scene.ladders.size())), plan.rungs);
        std::string macros;
        for (const glsl::Define& define : options.defines) macros += "\n" + define.name + " " + define.value;
        for (const glsl::StageInput& stage : planned.stages) {
            Shader*& shader =
                known[fmt::format("{} {}{}", static_cast<int>(stage.stage), sources.name(stage.file), macros)];
            if (!shader) shader = &shaders.emplace_back(plan, stage, sources, options);
            shader->programs.insert(planned.program);
        }
    }
}

std::vector<const Shader*> Reading::stages(Index program) const {
    std::vector<const Shader*> found;
    for (const Shader& shader : shaders)
        if (shader.programs.contains(program)) found.push_back(&shader);
    ranges::stable_sort(found, std::less<>(), [](const Shader* s) { return s->unit.stage; });
    return found;
}

const Shader* stage_of(const std::vector<const Shader*>& stages, Stage stage) {
    const auto found = ranges::find_if(stages, [&](const Shader* s) { return s->unit.stage == stage; });
    return found == stages.end() ? nullptr : *found;
}

// ---- loops that count ---------------------------------------------------------------------------------------

namespace {

// Of a loop `for`; nodes, each -1 where there is none.
struct LoopHeader {
    int begin = -1, condition = -1, step = -1;
};

LoopHeader header_of(const Shader& s, int loop) {
    const std::vector<int> all = s.parts(loop);
    if (s.at(loop).text != "for" || all.size() != 4) return {};
    const auto there = [&](int node) { return s.at(node).form == Form::empty ? -1 : node; };
    return {there(all[0]), there(all[1]), there(all[2])};
}

// The variable that an operand is, perhaps as float(i); -1: none.
int variable_of(const Shader& s, int node) {
    node = s.bare(node);
    const std::vector<int> inside = s.parts(node);
    if (s.at(node).form == Form::construct && inside.size() == 1) node = s.bare(inside.front());
    return s.at(node).form == Form::name ? s.at(node).variable : -1;
}

// What the step adds to the variable; 0: another thing.
double step_of(const Shader& s, int node, int variable) {
    const Node& n = s.at(node);
    const std::vector<int> inside = s.parts(node);
    if (inside.empty() || variable_of(s, inside.front()) != variable) return 0;
    if (n.form == Form::step) return n.text == "++" ? 1 : -1;
    if (n.form != Form::assign || inside.size() != 2 || s.at(inside[1]).value.size() != 1) return 0;
    const double by = s.at(inside[1]).value.front();
    return n.text == "+=" ? by : n.text == "-=" ? -by : 0;
}

// The value that the loop's variable begins with.
int first_value(const Shader& s, const LoopHeader& header, int variable) {
    if (header.begin < 0) return -1;
    const bool declares = s.at(header.begin).form == Form::declaration;
    for (const int child : declares ? s.parts(header.begin) : std::vector<int>{header.begin}) {
        const Node& n = s.at(child);
        const std::vector<int> inside = s.parts(child);
        if (n.form == Form::declarator && n.variable == variable && inside.size() == 1) return inside.front();
        if (n.form == Form::assign && n.text == "=" && inside.size() == 2 && variable_of(s, inside[0]) == variable)
            return inside[1];
    }
    return -1;
}

void add_counter(const Shader& s, const LoopHeader& header, int node, std::vector<Counter>& found) {
    node = s.bare(node);
    const Node& n = s.at(node);
    const std::vector<int> sides = s.parts(node);
    if (n.form != Form::infix || sides.size() != 2) return;
    if (n.text == "&&") {
        for (const int side : sides) add_counter(s, header, side, found);
        return;
    }
    const bool less = n.text == "<" || n.text == "<=", more = n.text == ">" || n.text == ">=";
    if (!less && !more) return;
    for (const std::size_t counting : {0U, 1U}) {
        const int variable = variable_of(s, sides[counting]);
        if (variable < 0) continue;
        const double step = step_of(s, header.step, variable);
        const int from = first_value(s, header, variable), bound = sides[1 - counting];
        const bool up = less == (counting == 0);
        if (step == 0 || (step > 0) != up) continue;
        found.push_back(
            {node, up ? bound : from, up ? from : bound, header.step, variable, std::abs(step), n.text.size() == 2});
        return;
    }
}

// Whether a condition that ends with the token leads to `break`.
bool breaks(const Shader& s, int last) {
    const auto word = [&](int k) {
        return k < static_cast<int>(s.unit.tokens.size()) ? s.token(k).text : std::string_view();
    };
    return word(last + 1) == ")" && word(last + (word(last + 2) == "{" ? 3 : 2)) == "break";
}

}  // namespace

std::vector<Counter> counters(const Shader& shader, int loop) {
    std::vector<Counter> found;
    const LoopHeader header = header_of(shader, loop);
    if (header.condition < 0 || header.step < 0) return found;
    add_counter(shader, header, header.condition, found);
    if (found.empty()) return found;
    const Counter first = found.front();
    for (int n = header.step + 1; n < loop; ++n) {
        const Node& test = shader.at(n);
        const std::vector<int> sides = shader.parts(n);
        if (test.form != Form::infix || (test.text != ">=" && test.text != ">") || !breaks(shader, test.last)) continue;
        if (variable_of(shader, sides[0]) == first.variable)
            found.push_back({n, sides[1], first.base, first.advance, first.variable, first.step, test.text == ">"});
    }
    return found;
}

// ---- offers -------------------------------------------------------------------------------------------------

bool closed(const Node& node) {
    return node.form == Form::name || node.form == Form::number || node.form == Form::group ||
           node.form == Form::select || node.form == Form::index || node.form == Form::construct ||
           node.form == Form::call || node.form == Form::built_in;
}

std::string literal(double value, const glsl::Type& type) {
    if (type.base == glsl::Base::integer) return fmt::format("{:.0f}", value);
    if (type.base == glsl::Base::uinteger) return fmt::format("{:.0f}u", value);
    return real_literal(value);
}

std::string_view varying_word(const Shader& shader, std::string_view direction) {
    const bool old = ranges::any_of(shader.unit.globals, [](const glsl::Global& g) { return g.qualifiers.varying; });
    return old ? "varying" : direction;
}

namespace {

// The texts of the places, without and with the edits, as one line each.
std::array<std::string, 2> before_and_after(const Sources& sources, const std::vector<Span>& shown,
                                            const std::vector<Edit>& edits) {
    std::array<std::string, 2> lines;
    for (const Span& where : shown) {
        const std::string_view all = sources.text(where.file);
        std::uint32_t at = where.begin;
        for (std::string& line : lines)
            if (!line.empty()) line += "; ";
        lines[0].append(all.substr(where.begin, where.end - where.begin));
        for (const auto& [span, text] : edits) {
            if (span.file != where.file || span.begin < at || span.end > where.end) continue;
            lines[1].append(all.substr(at, span.begin - at)).append(text);
            at = span.end;
        }
        lines[1].append(all.substr(at, where.end - at));
    }
    return {excerpt(lines[0]), excerpt(lines[1])};
}

bool by_place(const Edit& a, const Edit& b) {
    return std::tuple(a.span.file, a.span.begin, a.span.end) < std::tuple(b.span.file, b.span.begin, b.span.end);
}

// Edits that touch become one, so that their order is certain. Returns false if some overlap.
bool join_neighbours(Edits& edits) {
    Edits joined;
    for (Edit& edit : edits) {
        const bool follows = !joined.empty() && joined.back().span.file == edit.span.file;
        if (follows && edit.span.begin < joined.back().span.end) return false;
        if (follows && edit.span.begin == joined.back().span.end) {
            joined.back().span.end = edit.span.end;
            joined.back().text += edit.text;
        } else {
            joined.push_back(std::move(edit));
        }
    }
    edits = std::move(joined);
    return true;
}

}  // namespace

// `return(1.)` without its parentheses is `return 1.`.
void keep_words_apart(Edit& edit, std::string_view text) {
    const auto [file, begin, end] = edit.span;
    const auto word = [](char c) { return glsl::identifier_part(c); };
    const bool before = begin > 0 && word(text[begin - 1]), behind = end < text.size() && word(text[end]);
    if (edit.text.empty() && !(before && behind)) return;
    const bool first = before && (edit.text.empty() || word(edit.text.front()));
    const bool last = behind && !edit.text.empty() && word(edit.text.back());
    edit.text = (first ? " " : "") + edit.text + (last ? " " : "");
}

Offers::Offers(const Files& files, const Sources& sources, std::vector<Change>& changes, std::size_t most)
    : sources_(sources), changes_(changes), left_(most) {
    for (std::string& path : files.read_paths()) names_.insert(std::move(path));
}

bool Offers::add(ChangeKind kind, const std::vector<Span>& shown, Edits edits, std::string_view lint) {
    if (full()) return false;
    Edits made;
    for (Edit& edit : edits) {
        edit.span = first_reading(edit.span);
        if (!names_.contains(sources_.name(edit.span.file))) return false;
        if (text(edit.span) != edit.text) made.push_back(std::move(edit));
    }
    ranges::stable_sort(made, by_place);
    made.erase(std::unique(made.begin(), made.end()), made.end());
    if (made.empty() || !join_neighbours(made)) return false;
    for (Edit& edit : made) keep_words_apart(edit, sources_.text(edit.span.file));
    std::string key;
    for (const auto& [span, text] : made) key += fmt::format("{}:{}-{}:{}\n", span.file, span.begin, span.end, text);
    if (!known_.insert(key).second) return false;
    std::vector<Span> places;
    for (const Span& place : shown) places.push_back(first_reading(place));
    const auto [before, after] = before_and_after(sources_, places, made);
    changes_.push_back({kind, places.front(), before, after, std::move(made), std::string(lint)});
    --left_;
    return true;
}

void Offers::add(Change change) {
    const Span& at = change.where;
    if (full() || !known_.insert(fmt::format("{}:{}-{} mean", at.file, at.begin, at.end)).second) return;
    changes_.push_back(std::move(change));
    --left_;
}

namespace {

// What the statements of a function write ahead of a token.
class Written {
public:
    Written(const glsl::Unit& unit, std::string_view name, int token) : u_(unit), name_(name), token_(token) {}

    bool surely(const glsl::Function& f) const {
        if (f.block < 0) return false;
        if (const auto known = before(f.block)) return *known;
        for (int k = f.open - 1; k > f.name_token; --k) {
            if (u_.at(k).text != name_) continue;
            while (k > f.name_token && u_.at(k).text != "," && u_.at(k).text != "out") --k;
            return u_.at(k).text != "out";
        }
        return ranges::any_of(u_.globals, [&](const glsl::Global& g) { return g.name == name_ && g.init_first >= 0; });
    }

    // Whether a statement writes all of the variable, on some path.
    bool perhaps(const glsl::Function& f) const {
        for (int k = f.open + 1; k < token_; ++k)
            if (u_.at(k).text == name_ && u_.at(k + 1).text == "=" && u_.at(k - 1).text != ".") return true;
        return false;
    }

private:
    const Node& at(int node) const { return (*u_.tree)[static_cast<std::size_t>(node)]; }
    std::vector<int> parts(int node) const { return glsl::parts(*u_.tree, node); }

    // Nothing: the statements within the node say nothing of the variable.
    std::optional<bool> before(int node) const {
        if (at(node).form < Form::declarator) return std::nullopt;
        const std::vector<int> inside = parts(node);
        bool other_case = false;  // of a switch
        for (auto part = inside.rbegin(); part != inside.rend(); ++part) {
            const Node& n = at(*part);
            if (n.first > token_) continue;
            if (n.last >= token_) {
                if (const auto known = before(*part)) return known;
            } else if (n.form == Form::label) {
                other_case = true;
            } else if (at(node).form == Form::block) {
                const auto known = writes(*part);
                if (known && n.form == Form::declaration) return *known && !other_case;
                if (known && !other_case) return known;
            }
        }
        return std::nullopt;
    }
    // Elements are not all of an array, but its initialiser is.
    std::optional<bool> writes(int node) const {
        const Node& n = at(node);
        const std::vector<int> inside = parts(node);
        if (n.form == Form::declarator && n.text == name_) {
            for (int k = n.first; k <= n.last; ++k)
                if (u_.at(k).text == "=") return true;
            return false;
        }
        if (n.form == Form::assign && n.text == "=" && at(inside[0]).form == Form::name &&
            at(inside[0]).text == name_) {
            for (int k = n.first + 1; k <= n.last; ++k)
                if (u_.at(k).text == name_) return std::nullopt;  // made of itself
            return true;
        }
        if (n.form == Form::evaluated || n.form == Form::comma || n.form == Form::declaration)
            for (const int part : inside)
                if (const auto known = writes(part)) return known;
        return std::nullopt;
    }

    const glsl::Unit& u_;
    std::string_view name_;
    int token_;
};

}  // namespace

bool surely_written(const glsl::Unit& unit, const glsl::Function& function, std::string_view name, int token) {
    return Written(unit, name, token).surely(function);
}

bool can_go(const glsl::Unit& unit, const glsl::Function& function, int first, bool updates) {
    const Written written(unit, unit.at(first).text, first);
    return written.surely(function) || (updates && written.perhaps(function));
}

}  // namespace snell::accuracy
