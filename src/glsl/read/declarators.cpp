// Declarators with their initialisers, and functions.
#include <span>

#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

void Parser::declarators(const Qualifiers& q, Type type, Group group, bool global) {
    const auto index = static_cast<int>(u_.groups.size());
    if (global) u_.groups.push_back(std::move(group));
    while (token().kind == Kind::identifier) {
        declarator(q, type, index, global);
        if (!accept(",")) break;
    }
    if (!global && is(")")) return;  // the condition of a loop or a branch
    if (!is(";")) {
        give_up();
        if (!global) return skip_to_semicolon();
        u_.groups.back().last = -1;  // not understood: left as it is
        return skip_declaration(u_.groups.back().first);
    }
    ++p_;
    if (global) u_.groups[static_cast<std::size_t>(index)].last = p_ - 1;
}

void Parser::declarator(const Qualifiers& q, Type type, int group, bool global) {
    Global g;
    g.name = text();
    g.name_token = p_;
    g.qualifiers = q;
    g.group = group;
    ++p_;
    const int begin = grown();
    dimensions(type, &g.dims);
    g.type = type;
    std::vector<double> value;
    Expression given;
    // A varying array in a geometry shader, without a direction: one element for each vertex that comes in.
    if (global && q.varying && u_.stage == Stage::geometry && g.type.dims == 1 && !q.directed)
        g.qualifiers.storage = Storage::in;
    if (accept("=")) {
        g.init_first = p_;
        given = initialiser(type);
        const Expression& e = given;
        g.init_last = p_ - 1;
        g.init_constant = e.constant;
        g.init_fits = e.type.base != Base::unknown && e.type.dims == type.dims;
        if (e.constant) value = e.value;
        if (type.size < 0 && type.dims == 1) g.type.size = e.type.size;
        if (!global && q.storage == Storage::constant && !e.constant && (target_.es || target_.version < 420))
            for (int k = q.first; k <= q.last; ++k)
                if (u_.at(k).text == "const") u_.replace(k, "");
    }
    if (global && u_.function_names.contains(g.name)) u_.shared_by_kinds.insert(g.name);
    const int marked = static_cast<int>(u_.marks.size());
    const bool undefined = begins_undefined(q, type, g, global);
    if (given.first >= 0 && q.storage != Storage::constant) mark_kept(given, here(), !global);
    for (Mark& m : std::span(u_.marks).subspan(static_cast<std::size_t>(marked))) m.one = here();
    g.variable = variable(g.type);
    emit(Op::declare, g.variable, {}, g.init_first >= 0 ? 1 : undefined ? 2 : 0);
    if (u_.tree) {
        grow_statement(Form::declarator, begin, g.name_token, g.name);
        Node& node = u_.tree->back();
        node.type = g.type;
        node.variable = g.variable;
        node.constant = q.storage == Storage::constant;
    }
    Symbol symbol{g.type, -1, g.variable, q.storage == Storage::constant && g.init_first >= 0 && g.init_constant,
                  false,  {}};
    if (symbol.constant) symbol.value = value;
    if (global && g.type.base == Base::sampler && q.storage == Storage::plain) {
        diagnostics_.warning("sampler-not-uniform", u_.span(g.name_token), "a sampler is a uniform: taken as one");
        g.qualifiers.storage = Storage::uniform;
        g.dirty = true;
    }
    if (global) {
        symbol.global = static_cast<int>(u_.globals.size());
        g.value = std::move(value);
        u_.groups[static_cast<std::size_t>(group)].globals.push_back(symbol.global);
        u_.globals.push_back(std::move(g));
    }
    // NOLINTNEXTLINE(bugprone-use-after-move): moved from only where it is global
    declare(global ? u_.globals.back().name : g.name, std::move(symbol));
}

// Whether the variable, at the end of its declarator, has what another program left in a register. Local ones get a
// zero.
bool Parser::begins_undefined(const Qualifiers& q, const Type& type, const Global& g, bool global) {
    if (global) return q.storage == Storage::plain || (q.storage == Storage::out && u_.stage == Stage::fragment);
    if (g.init_first >= 0) return false;
    const bool whole = is(";") || is(",");             // else the driver's message is of what is wrong here
    const bool again = type.dims > 0 && find(g.name);  // an array may only be getting its size
    if (!whole || again || q.storage != Storage::plain || u_.at(p_ - 1).macro >= 0) return true;
    const std::string zero = zero_of(u_.structs, type);
    if (!zero.empty()) u_.edit(p_ - 1).after += " = " + zero;
    if (!zero.empty() && settles_ && (type.floating() || !type.basic()))
        u_.marks.push_back({Mark::Kind::kept, -1, -1, -1, p_ - 1});
    return zero.empty();
}

// An initialiser: an expression, or a list in braces.
Expression Parser::initialiser(const Type& due) {
    if (!is("{")) {
        Expression e = assignment();
        note_assigned(due, e);
        convert(e, due, Due::initialiser);
        return e;
    }
    const int open = p_, begin = grown();
    ++p_;
    Type element = due;
    if (element.dims > 0)
        --element.dims;
    else if (element.cols > 1)
        element.cols = 1;
    else
        element.rows = 1;
    if (due.dims == 0) element = make_type(due.base, element.rows, element.cols);
    Expression list;
    list.first = open;
    list.type = due;
    std::vector<Expression> elements;
    int count = 0;
    bool known = true;
    if (++depth_ > 200) {
        p_ = open;
        skip_balanced();
        --depth_;
        give_up();
        return list;
    }
    while (!at_end() && !is("}")) {
        const int before = p_;
        const Expression e = initialiser(element);
        list.constant = list.constant && e.constant;
        known = known && !e.value.empty();
        list.value.insert(list.value.end(), e.value.begin(), e.value.end());
        elements.push_back(e);
        ++count;
        if (!accept(",")) break;
        if (p_ == before) ++p_;
    }
    --depth_;
    const int close = p_;
    if (!accept("}")) {
        give_up();
        p_ = open;
        skip_balanced();
        return list;
    }
    if (!known) list.value.clear();
    list.last = close;
    if (due.dims > 0) list.type.size = count;
    emit(Op::construct, count, {}, list.type);
    list.step = here() - 1;
    if (settles_ && (due.dims > 0 || due.base == Base::structure)) constructed_[here() - 1] = std::move(elements);
    grow(Form::list, begin, list);
    if ((target_.es || target_.version < 420) && due.structure < 0 && !due.name.empty() && element.dims == 0) {
        u_.replace(open, std::string(due.name) + (due.dims > 0 ? "[" + std::to_string(count) + "]" : "") + "(");
        u_.replace(close, ")");
        if (u_.at(close - 1).text == ",") u_.replace(close - 1, "");
    }
    return list;
}

// An out parameter that the body does not always assign as a whole begins as zero. The body's brace is next.
void Parser::give_parameter(int name, const Type& type) {
    const std::string value = u_.at(p_).macro < 0 ? zero_of(u_.structs, type) : "";
    int depth = 0;
    for (int i = p_; i + 1 < static_cast<int>(u_.tokens.size()) && u_.at(i).text != "return"; ++i) {
        const std::string_view t = u_.at(i).text;
        depth += t == "{" ? 1 : t == "}" ? -1 : 0;
        if (depth == 0) break;
        const bool starts = u_.at(i - 1).text == ";" || u_.at(i - 1).text == "{" || u_.at(i - 1).text == "}";
        if (depth == 1 && starts && t == u_.at(name).text && u_.at(i + 1).text == "=") return;
    }
    if (!value.empty()) u_.edit(p_).after += " " + std::string(u_.now(name)) + " = " + value + ";";
    if (!value.empty() && settles_) u_.marks.push_back({Mark::Kind::kept, -1, -1, -1, p_});
}

void Parser::function(const Type& result, int first, int name) {
    Function f;
    f.name = text();
    f.result = result;
    f.name_token = name;
    f.first = first;
    // OpenGL ES forbids redefinitions of built-in functions.
    if (target_.es && !builtin_signatures(f.name).empty()) u_.replace(name, "snell_user_" + std::string(f.name));
    p_ = name + 2;
    open_scope();
    std::vector<std::pair<int, Type>> given;  // out parameters: tokens of their names
    std::vector<std::string_view> names;
    while (!at_end() && !is(")")) {
        const int before = p_;
        const Qualifiers q = qualifiers();
        const std::optional<Type> type = type_specifier();
        if (!type) break;
        Parameter parameter{*type, q.storage == Storage::out || q.storage == Storage::inout ? q.storage : Storage::in};
        dimensions(parameter.type, nullptr);
        if (token().kind == Kind::identifier) {
            const std::string_view parameter_name = text();
            const int name_at = p_++;
            dimensions(parameter.type, nullptr);
            parameter.variable = variable(parameter.type);
            declare(parameter_name, {parameter.type, -1, parameter.variable, false, false, {}});
            if (parameter.storage == Storage::out) given.emplace_back(name_at, parameter.type);
            names.push_back(parameter_name);
        } else {
            names.emplace_back();
        }
        parameter.written = true;
        if (parameter.type.base != Base::none) f.parameters.push_back(parameter);
        if (!accept(",") || p_ == before) break;
    }
    if (!accept(")")) {
        close_scope();
        return skip_declaration(first);
    }
    f.parameters_end = p_ - 1;
    const auto index = u_.functions.size();
    const std::string_view function_name = f.name;
    u_.functions.push_back(std::move(f));
    u_.function_names.insert(function_name);
    if (is("{")) {
        u_.functions[index].open = p_;
        for (const auto& [parameter_name, type] : given) give_parameter(parameter_name, type);
        result_ = result;
        written_.clear();
        const int around = emit(Op::jump);
        u_.functions[index].code = here();
        compound();
        u_.functions[index].block = grown() - 1;
        u_.functions[index].code_end = emit(Op::back);
        land(around);
        u_.functions[index].close = p_ - 1;
        for (std::size_t n = 0; n < u_.functions[index].parameters.size(); ++n)
            u_.functions[index].parameters[n].written = written_.contains(names[n]);
    } else {
        accept(";");
    }
    close_scope();
    if (const Symbol* variable = find(function_name); variable && !variable->function)
        u_.shared_by_kinds.insert(function_name);
    else
        declare(function_name, {result, -1, -1, false, true, {}});
}

}  // namespace snell::glsl
