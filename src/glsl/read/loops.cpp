#include "src/glsl/read/tree.h"

#include <array>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell::glsl {

namespace {

const Node& at(const Unit& u, int node) { return (*u.tree)[static_cast<std::size_t>(node)]; }

bool is_variable(const Node& n, int variable) { return n.form == Form::name && n.variable == variable; }

constexpr std::array<std::string_view, 6> operators{"+", "-", "*", "/", "<<", ">>"};

constexpr std::array<std::string_view, 6> comparisons{"<", "<=", ">", ">=", "==", "!="};

std::string_view mirrored(std::string_view op) {
    return op == "<" ? ">" : op == "<=" ? ">=" : op == ">" ? "<" : op == ">=" ? "<=" : op;
}

std::optional<Update> update_by(const Unit& u, char op, int node) {
    const Node& amount = at(u, node);
    if (amount.value.size() == 1) return Update{op, amount.value.front()};
    return op != '=' && amount.type.scalar() ? std::optional(Update{op, std::nan(""), node}) : std::nullopt;
}

}  // namespace

std::optional<Update> update_of(const Unit& u, int variable, int node) {
    const Node& n = at(u, node);
    const std::vector<int> inside = parts(*u.tree, node);
    if (inside.empty() || !is_variable(at(u, inside[0]), variable)) return std::nullopt;
    if (n.form == Form::step) return Update{n.text.front(), 1};
    if (n.form != Form::assign) return std::nullopt;
    const Node& result = at(u, inside[1]);
    const auto known = [](std::string_view op) { return ranges::count(operators, op) > 0; };
    if (n.text == "=" && result.form == Form::infix && known(result.text)) {
        const std::vector<int> sides = parts(*u.tree, inside[1]);
        const char op = result.text.front();
        if (is_variable(at(u, sides[0]), variable)) return update_by(u, op, sides[1]);
        if ((op == '+' || op == '*') && is_variable(at(u, sides[1]), variable)) return update_by(u, op, sides[0]);
    }
    const bool updates = n.text == "=" || known(n.text.substr(0, n.text.size() - 1));
    return updates ? update_by(u, n.text.front(), inside[1]) : std::nullopt;
}

double updated(double value, Update update, Base base) {
    const auto [op, by, amount] = update;
    value = op == '+'   ? value + by
            : op == '-' ? value - by
            : op == '*' ? value * by
            : op == '/' ? value / by
            : op == '<' ? value * std::exp2(by)
            : op == '>' ? std::floor(value / std::exp2(by))
                        : by;
    if (base == Base::real) return static_cast<float>(value);
    if (base == Base::dreal) return value;
    if (!(std::abs(value) < 0x1p63)) return value;  // division by zero
    const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    return base == Base::uinteger ? static_cast<double>(bits) : static_cast<double>(static_cast<std::int32_t>(bits));
}

std::optional<int> begin_of(const Unit& u, int variable, int begins) {
    std::optional<int> found;
    for (int k = begins < 0 ? 0 : at(u, begins).begin; k <= begins; ++k) {
        const Node& n = at(u, k);
        const std::vector<int> inside = parts(*u.tree, k);
        const bool declared = n.form == Form::declarator && n.variable == variable && !inside.empty();
        const bool assigned = n.form == Form::assign && n.text == "=" && is_variable(at(u, inside[0]), variable);
        if (declared || assigned) found = inside.back();
    }
    return found;
}

void each_stored(const Unit& u, int first, int last, const std::function<void(int variable)>& each) {
    const auto root = [&](int node) {
        if (const Node& n = at(u, at(u, node).begin); n.form == Form::name && n.variable >= 0) each(n.variable);
    };
    for (int k = first; k <= last; ++k) {
        const Node& n = at(u, k);
        if (n.form == Form::assign || n.form == Form::step) root(k);
        const bool takes_two = n.form == Form::built_in && (n.text == "modf" || n.text == "frexp");
        if (n.form != Form::call && !takes_two) continue;
        const std::vector<int> given = parts(*u.tree, k);
        const auto* f = n.function < 0 ? nullptr : &u.functions[static_cast<std::size_t>(n.function)];
        for (std::size_t i = takes_two ? 1 : 0; i < given.size(); ++i)
            if (!f || i >= f->parameters.size() || f->parameters[i].storage != Storage::in) root(given[i]);
    }
}

bool compares(std::string_view op) { return ranges::count(comparisons, op) > 0; }

bool stores(const Unit& u, int variable, int first, int last) {
    bool found = false;
    each_stored(u, first, last, [&](int other) { found = found || other == variable; });
    return found;
}

std::optional<Comparison> comparison_of(const Unit& u, int condition, int first, int last) {
    while (at(u, condition).form == Form::group) --condition;
    const Node& test = at(u, condition);
    if (test.form != Form::infix || !compares(test.text)) return std::nullopt;
    const std::vector<int> sides = parts(*u.tree, condition);
    const auto variable = [&](int node) { return at(u, node).form == Form::name ? at(u, node).variable : -1; };
    const int left = variable(sides[0]), right = variable(sides[1]);
    if (right >= 0 && (left < 0 || (!stores(u, left, first, last) && stores(u, right, first, last))))
        return Comparison{right, at(u, sides[1]).text, mirrored(test.text), sides[0]};
    return left < 0 ? std::nullopt : std::optional(Comparison{left, at(u, sides[0]).text, test.text, sides[1]});
}

}  // namespace snell::glsl
