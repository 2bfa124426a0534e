#include "src/glsl/read/tree.h"

#include <cmath>

namespace snell::glsl {

namespace {

const Node& at(const Unit& u, int node) { return (*u.tree)[static_cast<std::size_t>(node)]; }

bool is_variable(const Node& n, int variable) { return n.form == Form::name && n.variable == variable; }

}  // namespace

std::optional<Update> update_of(const Unit& u, int variable, int node) {
    const Node& n = at(u, node);
    const std::vector<int> inside = parts(*u.tree, node);
    if (inside.empty() || !is_variable(at(u, inside[0]), variable)) return std::nullopt;
    if (n.form == Form::step) return Update{n.text.front(), 1};
    if (n.form != Form::assign) return std::nullopt;
    const char op = n.text.front();
    if (n.text.size() > 2 || std::string_view("=+-*/").find(op) == std::string_view::npos) return std::nullopt;
    const Node& amount = at(u, inside[1]);
    if (amount.value.size() == 1) return Update{op, amount.value.front()};
    const bool steps = (op == '+' || op == '-') && amount.type.scalar();
    return steps ? std::optional(Update{op, std::nan(""), inside[1]}) : std::nullopt;
}

double updated(double value, Update update, Base base) {
    const auto [op, by, amount] = update;
    value = op == '+' ? value + by : op == '-' ? value - by : op == '*' ? value * by : op == '/' ? value / by : by;
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

bool compares(std::string_view op) { return std::string_view("< <= > >= == !=").find(op) != std::string_view::npos; }

}  // namespace snell::glsl
