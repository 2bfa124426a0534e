// Calls of functions: which overload is meant, and what its arguments must become; and casts.
#include <algorithm>

#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

namespace {

// What one character of a signature asks for, given the size of the generic parameters (0: not known yet).
std::optional<Type> parameter_type(char code, int size) {
    constexpr Base bases[] = {Base::real, Base::integer, Base::uinteger, Base::boolean};
    constexpr std::string_view vectors = "FIUB", scalars = "fiub";
    if (const std::size_t n = vectors.find(code); n != vectors.npos) return make_type(bases[n], size);
    if (const std::size_t n = scalars.find(code); n != scalars.npos) return make_type(bases[n]);
    if (code >= '2' && code <= '4') return make_type(Base::real, code - '0');
    return std::nullopt;
}

bool generic(char code) { return std::string_view("FIUB").find(code) != std::string_view::npos; }

// How well a value of type `have` serves where `want` is due: 0 not at all, 1 by conversion, 2 exactly.
int fit(const Type& have, const Type& want) {
    if (have.base == Base::unknown) return 1;
    if (have.dims || have.cols > 1 || have.rows != want.rows) return 0;
    if (have.base == want.base || (have.base == Base::dreal && want.base == Base::real)) return 2;
    if (want.base == Base::real && have.integral()) return 1;
    return want.base == Base::uinteger && have.base == Base::integer ? 1 : 0;
}

struct Overload {
    char result = 'X';
    std::string parameters;
    std::size_t least = 0;  // parameters that must be given
};

Overload read_overload(std::string_view text) {
    Overload o{text[0], std::string(text.substr(2))};
    o.least = std::min(o.parameters.find('['), o.parameters.size());
    std::erase(o.parameters, '[');
    return o;
}

int generic_size(const Overload& o, const std::vector<Expression>& given) {
    for (std::size_t n = 0; n < given.size(); ++n)
        if (generic(o.parameters[n]) && given[n].type.base != Base::unknown) return given[n].type.rows;
    return 1;
}

int match(const Overload& o, const std::vector<Expression>& given) {
    if (given.size() < o.least || given.size() > o.parameters.size()) return 0;
    const int size = generic_size(o, given);
    int worst = 2;
    for (std::size_t n = 0; n < given.size(); ++n)
        if (const auto want = parameter_type(o.parameters[n], size)) worst = std::min(worst, fit(given[n].type, *want));
    return worst;
}

bool ends_with_any(std::string_view text, std::initializer_list<std::string_view> ends) {
    return std::any_of(ends.begin(), ends.end(), [&](std::string_view e) { return text.ends_with(e); });
}

Type texel(std::string_view sampler) {
    if (sampler.ends_with("Shadow")) return make_type(Base::real);
    const Base base = sampler.starts_with("i") && !sampler.starts_with("image") ? Base::integer
                      : sampler.starts_with("u")                                ? Base::uinteger
                                                                                : Base::real;
    return make_type(base, 4);
}

Type texture_size(std::string_view sampler) {
    if (sampler.ends_with("Shadow")) sampler.remove_suffix(6);
    if (ends_with_any(sampler, {"1D", "Buffer"})) return make_type(Base::integer);
    if (ends_with_any(sampler, {"3D", "2DArray", "CubeArray", "2DMSArray"})) return make_type(Base::integer, 3);
    return make_type(Base::integer, 2);
}

// Results that depend on more than the invocation's constants.
bool impure(std::string_view name) {
    return name.starts_with("te") || name.starts_with("noise") || name.starts_with("dF") ||
           name.starts_with("fwidth") || name.starts_with("image") || name.starts_with("interpolate") ||
           name == "ftransform" || name.starts_with("atomic");
}

}  // namespace

Expression Parser::call(int name_token) {
    Expression e;
    e.first = name_token;
    const std::string_view name = text();
    const int begin = grown();
    ++p_;
    std::vector<Expression> given = arguments();
    e.last = p_ - 1;
    if (call_user(e, name, given) || foreign_function(name, given, e)) {
        grow_call(begin, e, name, false);
        return e;
    }
    const std::string_view modern = modern_texture_function(name);
    const bool wraps = !modern.empty() && name.starts_with("shadow");
    if (wraps) {
        Edit& before = u_.edit(e.first);
        before.before = "vec4(" + before.before;
        u_.edit(e.last).after += ")";
    }
    const bool ours = !modern.empty() || !builtin_signatures(name).empty();
    if (!ours) u_.unknown_calls.try_emplace(name, name_token);
    call_builtin(e, modern.empty() ? name : modern, given);
    if (const auto later = foreseen_.find(name);
        later != foreseen_.end() && (!ours || (!modern.empty() && builtin_signatures(name).empty()))) {
        e.type = later->second;
        e.constant = false;
    }
    // OpenGL ES has no textures of one dimension: the runtime makes them one texel high.
    if (target_.es && given.size() > 1 && given.front().type.name == "sampler1D" && given[1].first >= 0) {
        Edit& before = u_.edit(given[1].first);
        before.before = "vec2(" + before.before;
        u_.edit(given[1].last).after += ", 0.5)";
    }
    if (wraps) e.type = make_type(Base::real, 4);
    if ((name == "EmitStreamVertex" || name == "EndStreamPrimitive") && given.size() == 1)
        u_.streams.push_back(
            {e.first, e.last, given[0].value.size() == 1 ? std::optional(given[0].value.front()) : std::nullopt});
    if (ours)
        emit(Op::built_in, static_cast<int>(given.size()), modern.empty() ? name : modern, e.type);
    else
        emit(Op::call, static_cast<int>(given.size()), name, -1);
    grow_call(begin, e, modern.empty() ? name : modern, ours);
    return e;
}

void Parser::grow_call(int begin, const Expression& e, std::string_view name, bool ours) {
    Node* node = grow(ours ? Form::built_in : Form::call, begin, e, name);
    const Instruction& step = u_.code.steps.back();
    if (node && step.op == Op::call) node->function = step.b;
}

Expression Parser::constructor(const Type& type, int first) {
    const int begin = grown();
    Expression e = construction(type, first);
    grow(Form::construct, begin, e, type.name);
    return e;
}

// (float) x, as C has it.
Expression Parser::cast() {
    const int first = p_;
    const Type type = *builtin_type(text(1));
    warn("c-cast", p_, "a cast in parentheses is C: read as " + std::string(type.name) + "(…)");
    p_ += 3;
    const int begin = grown();
    ++depth_;
    Expression e = depth_ > 200 ? Expression{} : unary();
    --depth_;
    if (type.floating() && !e.type.floating()) mark_kept(e, -1);
    emit(Op::construct, 1, {}, type);
    if (e.last >= first + 3) {
        u_.replace(first, "");
        u_.replace(first + 2, "(");
        u_.edit(e.last).after += ")";
    }
    e.first = first;
    e.type = type;
    e.alpha_one = false;
    e.value.clear();
    e.no_variable();
    grow(Form::construct, begin, e, type.name);
    return e;
}

// Functions of Cg and HLSL, which some compilers let pass.
bool Parser::foreign_function(std::string_view name, std::vector<Expression>& given, Expression& result) {
    struct Foreign {
        std::string_view name, ours;
    };
    constexpr Foreign table[] = {{"saturate", "clamp"},
                                 {"lerp", "mix"},
                                 {"frac", "fract"},
                                 {"rsqrt", "inversesqrt"},
                                 {"ddx", "dFdx"},
                                 {"ddy", "dFdy"},
                                 {"fmod", "mod"},
                                 {"atan2", "atan"},
                                 {"tex1D", "texture"},
                                 {"tex2D", "texture"},
                                 {"tex3D", "texture"},
                                 {"texCUBE", "texture"},
                                 {"mul", ""}};
    const auto* found =
        std::find_if(std::begin(table), std::end(table), [&](const Foreign& f) { return f.name == name; });
    if (found == std::end(table) || given.empty() || given.back().last < 0) return false;
    if (u_.at(result.last).text != ")") return false;
    if (name == "mul") {
        if (given.size() != 2 || u_.at(given[0].last + 1).text != ",") return false;
        u_.replace(result.first, "(");
        u_.replace(given[0].last + 1, ") * (");
        u_.replace(result.last, "))");
        emit(Op::infix, 0, "*");
        const int first = result.first, last = result.last;
        result = combine(given[0], given[1], "*");
        result.first = first;
        result.last = last;
    } else {
        u_.replace(result.first, found->ours);
        if (name == "saturate") u_.replace(result.last, ", 0.0, 1.0)");
        if (name == "saturate")
            result.type = given[0].type;
        else
            call_builtin(result, found->ours, given);
        emit(Op::built_in, static_cast<int>(given.size()), name == "saturate" ? name : found->ours, result.type);
    }
    diagnostics_.warning("foreign-function", u_.span(result.first),
                         "'" + std::string(name) + "' is not a function of GLSL; it is read as " +
                             (name == "mul" ? "a product" : std::string(found->ours)));
    return true;
}

bool Parser::call_user(Expression& result, std::string_view name, std::vector<Expression>& given) {
    if (!u_.function_names.contains(name)) return false;
    const Function* best = nullptr;
    int best_fit = -1;
    bool any = false;
    for (const Function& f : u_.functions) {
        if (f.name != name) continue;
        any = true;
        if (f.parameters.size() != given.size()) continue;
        int worst = 2, sum = 0;
        for (std::size_t n = 0; n < given.size(); ++n) {
            const Type& want = f.parameters[n].type;
            const Type& have = given[n].type;
            const int one = have.same(want) ? 2 : want.base == Base::unknown || want.dims ? 1 : fit(have, want);
            worst = std::min(worst, one);
            sum += one;
        }
        if (worst == 0) continue;
        if (sum > best_fit) {
            best_fit = sum;
            best = &f;
        }
    }
    if (!any || (!best && !builtin_signatures(name).empty())) return false;
    result.constant = false;
    emit(Op::call, static_cast<int>(given.size()), name, best ? static_cast<int>(best - u_.functions.data()) : -1);
    if (best && target_.es && !builtin_signatures(name).empty())
        u_.replace(result.first, "snell_user_" + std::string(name));
    if (!best) {
        // No overload fits: if only one has that many parameters, it is meant.
        int candidates = 0;
        for (const Function& f : u_.functions)
            if (f.name == name && f.parameters.size() == given.size()) {
                best = &f;
                candidates += f.open >= 0 ? 1 : 0;
            }
        if (!best) return true;
        if (candidates > 1) {
            result.type = best->result;
            return true;
        }
    }
    result.type = best->result;
    for (std::size_t n = 0; n < given.size(); ++n) {
        const Parameter& parameter = best->parameters[n];
        if (parameter.storage != Storage::in)
            note_write(given[n], nullptr, "out");
        else
            convert(given[n], parameter.type, Due::argument);
        if (parameter.storage == Storage::in && parameter.written) mark_kept(given[n], here() - 1);
    }
    return true;
}

void Parser::call_builtin(Expression& result, std::string_view name, std::vector<Expression>& given) {
    std::string_view signatures = builtin_signatures(name);
    result.constant = !signatures.empty() && !impure(name);
    for (const Expression& a : given) result.constant = result.constant && a.constant;
    if (name == "modf" || name == "frexp") {
        if (given.size() > 1) note_write(given[1], nullptr, "out");
    }
    Overload best;
    int best_fit = 0;
    while (!signatures.empty()) {
        const std::size_t end = std::min(signatures.find(' '), signatures.size());
        Overload o = read_overload(signatures.substr(0, end));
        if (const int one = match(o, given); one > best_fit) {
            best_fit = one;
            best = std::move(o);
        }
        signatures.remove_prefix(std::min(end + 1, signatures.size()));
    }
    if (best_fit == 0) return;
    const int size = generic_size(best, given);
    for (std::size_t n = 0; n < given.size(); ++n) {
        const char code = best.parameters[n];
        if (code == 'C' && given[n].type.integral())
            convert(given[n], make_type(Base::real, given[n].type.rows), Due::argument);
        else if (const auto want = parameter_type(code, size))
            convert(given[n], *want, Due::argument);
    }
    if (name == "mod" && given.size() == 2 && !(given[0].constant && given[1].constant)) mark_divisor(given[1]);
    if (name.ends_with("BitsToFloat") || name.starts_with("unpack")) mark_kept(given[0], -1);
    if (name == "mix" && given.size() == 3 && given[2].type.base == Base::boolean)
        for (const Expression* one : {&given[0], &given[1]}) mark_kept(*one, here());
    const std::string_view sampler = given.empty() ? std::string_view() : given.front().type.name;
    if (const auto type = parameter_type(best.result, size)) {
        result.type = *type;
        const bool dvec =
            std::any_of(given.begin(), given.end(), [](const Expression& e) { return e.type.base == Base::dreal; });
        if (dvec && type->base == Base::real) result.type = make_type(Base::dreal, type->rows);
    } else if (best.result == 'T' && !given.empty() && given.front().type.base == Base::sampler) {
        result.type = texel(sampler);
    } else if (best.result == 'Z' && !given.empty() && given.front().type.base == Base::sampler) {
        result.type = texture_size(sampler);
    } else if (!given.empty() && given.front().type.cols > 1 && name != "outerProduct") {
        const Type& m = given.front().type;
        result.type = name == "transpose" ? make_type(m.base, m.cols, m.rows) : m;
    }
    if (name == "mix" && given.size() == 3) mark_product(result, given[0], given[1], &given[2]);
}

}  // namespace snell::glsl
