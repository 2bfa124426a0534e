#include "src/glsl/run/trial.h"

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/read/legacy.h"
#include "src/glsl/run/machine.h"

namespace snell::glsl::run {

namespace {

constexpr int most_rounds = 16;
constexpr std::size_t most_changes = 62;  // at once: a lane each

// From 0 to 1, the same for the same arguments.
double random(std::string_view name, int k, int seed) {
    std::uint64_t h = 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(k) * 0xBF58476D1CE4E5B9u +
                      static_cast<std::uint64_t>(seed) * 0x94D049BB133111EBu;
    for (const char c : name) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    h ^= h >> 29;
    h *= 0xBF58476D1CE4E5B9u;
    h ^= h >> 32;
    return static_cast<double>(h >> 11) / static_cast<double>(std::uint64_t{1} << 53);
}

// The type of a variable's k-th number.
Base base_at(const Unit& u, const Type& type, int k) {
    if (type.base != Base::structure || type.structure < 0) return type.base;
    Type one = type;
    one.dims = 0;
    k %= std::max(count(u, one), 1);
    for (const Member& m : u.structure(type).members) {
        const int size = count(u, m.type);
        if (k < size) return base_at(u, m.type, k);
        k -= size;
    }
    return Base::unknown;
}

// By turns: as scenes are, all components of one sign, and of both.
double real_value(const Type& type, std::string_view name, int k, int round, double u) {
    if (round % 2 == 1) return 2 * u - .8;
    if (round % 4 == 2 && type.cols == 1) return random(name, -1, round) < .5 ? -.1 - u : .1 + u;
    if (type.cols > 1) return (k % (type.rows + 1) == 0 ? 1 : 0) + .2 * u - (k == 14 ? 3 : 0);  // ahead of the eye
    if (name == "Normal") return k == 2 ? 1 : .3 * u;
    return name == "Vertex" && k == 3 ? 1 : .05 + u;
}

// A value of a uniform: each round tries others, of other sizes.
double uniform_value(const Type& type, Base base, std::string_view name, int k, int round, bool changed) {
    const double first = random(name, k, round * 2), u = changed ? random(name, k, round * 2 + 1) : first;
    // Each number and each truth value has its turn.
    const auto turn = [&](int n) {
        const int seed = round < n ? 0 : round;
        return std::fmod(std::floor(random(name, k, seed) * n) + round % n, n);
    };
    if (base == Base::boolean) return (turn(2) != 0) != changed ? 1 : 0;
    if (base == Base::integer || base == Base::uinteger)
        return changed ? std::fmod(turn(4) + 1 + std::floor(u * 3), 4) : turn(4);
    if (base == Base::unknown) return nothing;
    if (type.cols > 1) return real_value(type, name, k, round, u);
    if (round % 4 == 3) return 2 * u - 1;
    return round % 4 == 1 && random(name, -1, round) < .5 ? 20 * u : .05 + u;
}

// What vertices and fragments are given.
double input(const Type& type, Base base, std::string_view name, int k, int round, bool neighbour) {
    const double u = random(name, k, 1000 + round);
    if (base == Base::boolean) return u < .7 ? 1 : 0;
    if (base == Base::integer) return std::floor(u * 3);
    const double step = neighbour ? .01 * (1 + random(name, k, 2000)) : 0;
    if (name == "FragCoord") return 300 * u + step;
    return (name == "PointCoord" ? u : real_value(type, name, k, round, u)) + step;
}

struct Place {
    int variable = -1, first = 0, size = 0;
};

bool derives(const Unit& u) {
    return ranges::any_of(u.code.steps, [](const Instruction& i) {
        return i.op == Op::built_in && (i.text.starts_with("dF") || i.text.starts_with("fwidth"));
    });
}

class Trial {
public:
    Trial(const std::vector<Unit>& units, const std::vector<Tried>& uniforms) : uniforms_(uniforms) {
        for (const Unit& u : units) {
            machines_.emplace_back(u);
            tokens_ += static_cast<int>(u.tokens.size());
            derives_ = derives_ || derives(u);
        }
    }
    std::set<std::string_view> run();

private:
    using Outputs = std::vector<double>;  // of each lane, one after the other
    struct Result {
        Machine::End end = Machine::End::unknown;
        std::size_t lanes = 1;
        Outputs position, colors;
    };

    void try_values();
    Result draw(int lanes, int neighbour, std::uint64_t& alive, int changed);
    void give_uniform(Machine& m, int n, std::string_view name, int changed);
    void give_block(Machine& m, const Block& b);
    void give(Machine& m, Machine* before, int changed);
    void give_built_in(Machine& m, Machine* before, std::string_view name, int n);
    void give_interface(Machine& m, Machine& before);
    void collect(Machine& m, int variable, Outputs& out);

    const std::vector<Tried>& uniforms_;
    std::vector<Machine> machines_;
    std::set<std::string_view> found_;
    std::vector<std::string_view> lane_names_;  // the uniform that lane n + 1 changes
    bool derives_ = false;                      // some stage asks for derivatives
    bool known_ = false;                        // what the stage before has given
    int tokens_ = 0, budget_ = 0;
    int round_ = 0, lanes_ = 1, neighbour_ = -1;
};

const Global* find_global(const Unit& u, Storage storage, std::string_view name) {
    for (const Global& g : u.globals)
        if (g.qualifiers.storage == storage && g.name == name && !g.removed) return &g;
    return nullptr;
}

int find_built_in(const Unit& u, std::string_view name) {
    if (const auto found = u.built_ins.find(name); found != u.built_ins.end()) return found->second;
    for (const Global& g : u.globals)
        if (g.name == name) return g.variable;
    return -1;
}

// Where a member of a block is.
Place member_place(const Unit& u, const Block& b, std::size_t member) {
    if (b.variable < 0) return {};
    if (b.instance.empty()) {
        const int n = b.variable + static_cast<int>(member);
        return {n, 0, count(u, u.code.variables[static_cast<std::size_t>(n)])};
    }
    Place place{b.variable, 0, 0};
    for (std::size_t k = 0; k <= member; ++k) {
        place.first += place.size;
        place.size = count(u, b.members[k].type);
        if (place.size == 0) return {};
    }
    return place;
}

Place output_place(const Unit& u, std::string_view name) {
    if (const Global* g = find_global(u, Storage::out, name)) return {g->variable, 0, count(u, g->type)};
    for (const Block& b : u.blocks)
        for (std::size_t k = 0; k < b.members.size(); ++k)
            if (b.qualifiers.storage == Storage::out && b.instance.empty() && b.members[k].name == name)
                return member_place(u, b, k);
    return {};
}

void Trial::collect(Machine& m, int n, Outputs& out) {
    if (n < 0) return;
    const Variable& v = m.variable(n);
    for (int k = 0; k < v.size; ++k)
        for (int l = 0; l < lanes_; ++l) out.push_back(v.get(k, l));
}

// A built-in variable: from the stage before, as its name is there, or from outside.
void Trial::give_built_in(Machine& m, Machine* before, std::string_view name, int n) {
    const bool fragment = m.unit().stage == Stage::fragment;
    const std::string_view key = name.starts_with("gl_MultiTexCoord") ? "MultiTexCoord0" : name.substr(3);
    const bool color = name == "gl_Color" || name == "gl_SecondaryColor", texcoord = name == "gl_TexCoord";
    const bool passes = fragment && (color || texcoord || name == "gl_FogFragCoord");
    const auto unknown = [&] { m.set(n, 1, [](int, int) { return nothing; }); };
    if (passes && (!known_ || before->unit().stage != Stage::vertex)) return unknown();
    if (passes) {
        const std::string from = color ? "gl_Front" + std::string(key) : std::string(name);
        if (color && find_built_in(before->unit(), "gl_Back" + std::string(key)) >= 0) return unknown();
        if (const int source = find_built_in(before->unit(), from); source >= 0) {
            const Variable& v = before->variable(source);
            if (v.size != m.variable(n).size) return unknown();
            return m.set(n, v.lanes, [&](int k, int l) {
                const double x = v.get(k, l);
                return !color || std::isnan(x) ? x : std::clamp(x, 0., 1.);
            });
        }
    }
    if (texcoord || (passes && !color))
        return m.set(n, 1, [&](int k, int) { return texcoord && k % 4 == 3 ? 1. : 0.; });
    const LegacyName* legacy = legacy_name(name);
    const bool uniform = legacy && legacy->kind == LegacyKind::uniform;
    constexpr std::array<std::string_view, 5> inputs = {"gl_FragCoord", "gl_FrontFacing", "gl_PointCoord",
                                                        "gl_VertexID", "gl_InstanceID"};
    if (!uniform && !(legacy && legacy->kind == LegacyKind::attribute) && ranges::find(inputs, name) == inputs.end())
        return unknown();
    const bool varies = neighbour_ >= 0 && !uniform;
    m.set(n, varies ? lanes_ : 1, [&](int k, int l) {
        return input(m.type_of(n), base_at(m.unit(), m.type_of(n), k), key, k, round_, varies && l == neighbour_);
    });
}

void Trial::give_interface(Machine& m, Machine& before) {
    const Unit &u = m.unit(), &from = before.unit();
    const auto copy = [&](int to, int first, int size, const Place& place) {
        Variable& v = m.variable(to);
        if (place.variable < 0 || place.size != size || !known_ || first + size > v.size) return;
        const Variable& w = before.variable(place.variable);
        if (w.lanes > v.lanes) {
            const Variable narrow = v;
            m.set(to, w.lanes, [&](int k, int l) { return narrow.get(k, l); });
        }
        for (int k = 0; k < size; ++k)
            for (int l = 0; l < v.lanes; ++l)
                v.data[static_cast<std::size_t>((first + k) * v.lanes + l)] = w.get(place.first + k, l);
    };
    const auto clear = [&](int n) {
        m.variable(n).given = true;
        m.set(n, 1, [](int, int) { return nothing; });
    };
    for (const Global& g : u.globals)
        if (g.qualifiers.storage == Storage::in && g.variable >= 0 && !g.name.starts_with("gl_")) {
            clear(g.variable);
            const Place place = output_place(from, g.name);
            if (place.variable >= 0 && g.new_type.empty()) copy(g.variable, 0, m.variable(g.variable).size, place);
        }
    for (const Block& b : u.blocks) {
        if (b.qualifiers.storage != Storage::in || b.variable < 0) continue;
        const auto source = ranges::find_if(from.blocks, [&](const Block& o) {
            return o.qualifiers.storage == Storage::out && o.name == b.name && o.members.size() == b.members.size();
        });
        for (std::size_t k = 0; k < b.members.size(); ++k) {
            const Place to = member_place(u, b, k);
            if (to.variable < 0) continue;
            if (k == 0 || b.instance.empty()) clear(to.variable);
            if (source != from.blocks.end() && source->members[k].name == b.members[k].name)
                copy(to.variable, to.first, to.size, member_place(from, *source, k));
        }
    }
}

void Trial::give_uniform(Machine& m, int n, std::string_view name, int changed) {
    const auto lane = static_cast<int>(ranges::find(lane_names_, name) - lane_names_.begin());
    const bool changes = lane < static_cast<int>(lane_names_.size()), own = changes && changed < 0;
    m.set(n, own ? lanes_ : 1, [&](int k, int l) {
        const bool other = changes && (changed < 0 ? l == lane + 1 : lane == changed);
        return uniform_value(m.type_of(n), base_at(m.unit(), m.type_of(n), k), name, k, round_, other);
    });
}

// The same numbers in all stages, whether they have a name for the block as a whole or not.
void Trial::give_block(Machine& m, const Block& b) {
    if (b.variable < 0) return;
    const bool known = b.qualifiers.storage == Storage::uniform;
    int before = 0;
    for (int n = b.variable; n < b.variable + (b.instance.empty() ? static_cast<int>(b.members.size()) : 1); ++n) {
        m.set(n, 1, [&](int k, int) {
            const Base base = base_at(m.unit(), m.type_of(n), k);
            return known ? uniform_value(Type(), base, b.name, before + k, round_, false) : nothing;
        });
        before += m.variable(n).size;
    }
}

void Trial::give(Machine& m, Machine* before, int changed) {
    const Unit& u = m.unit();
    for (const auto& [name, n] : u.built_ins) give_built_in(m, before, name, n);
    for (const Block& b : u.blocks) give_block(m, b);
    for (const Global& g : u.globals) {
        const Storage s = g.qualifiers.storage;
        const bool language = g.name.starts_with("gl_"), varies = neighbour_ >= 0;
        if (g.variable < 0 || (s != Storage::uniform && s != Storage::buffer && g.attribute < 0 && !language)) continue;
        m.variable(g.variable).given = true;
        if (language) {
            give_built_in(m, before, g.name, g.variable);
        } else if (s == Storage::uniform) {
            give_uniform(m, g.variable, g.name, changed);
        } else if (g.attribute >= 0) {
            const AttributeFacts& facts = attribute_facts()[static_cast<std::size_t>(g.attribute)];
            m.set(g.variable, varies ? lanes_ : 1, [&](int k, int l) {
                if (m.type_of(g.variable).base != Base::real) return nothing;
                if (k >= facts.rows) return 0.;  // as assign_attributes widens it
                return input(m.type_of(g.variable), Base::real, facts.name.substr(6), k, round_,
                             varies && l == neighbour_);
            });
        }
    }
    if (before) give_interface(m, *before);
}

// `changed`: the uniform that has its other value in all lanes; -1: each in its own lane.
Trial::Result Trial::draw(int lanes, int neighbour, std::uint64_t& alive, int changed) {
    lanes_ = lanes, neighbour_ = neighbour;
    Result result;
    result.lanes = static_cast<std::size_t>(lanes);
    Machine* before = nullptr;
    for (Machine& m : machines_) {
        known_ = result.end == Machine::End::done;
        give(m, before, changed);
        result.end = m.unit().code.whole ? m.run(lanes, neighbour, alive, budget_) : Machine::End::unknown;
        const bool last = m.unit().stage == Stage::vertex && machines_.size() == 2;
        if (last && result.end == Machine::End::done)
            collect(m, find_built_in(m.unit(), "gl_Position"), result.position);
        before = &m;
    }
    Machine& last = machines_.back();
    if (last.unit().stage != Stage::fragment || result.end != Machine::End::done) return result;
    bool legacy = false;
    for (const std::string_view name : {"gl_FragColor", "gl_FragData", "gl_FragDepth"})
        if (const int n = find_built_in(last.unit(), name); n >= 0) {
            legacy = legacy || name != "gl_FragDepth";
            collect(last, n, result.colors);
        }
    for (const Global& g : last.unit().globals)
        if (g.qualifiers.storage == Storage::out && g.written && !legacy && !g.removed && !g.name.starts_with("gl_"))
            collect(last, g.variable, result.colors);
    return result;
}

// One set of values, and each uniform changed.
void Trial::try_values() {
    lane_names_.clear();
    for (const Tried& t : uniforms_)
        if (!found_.contains(t.name) && lane_names_.size() < most_changes) lane_names_.push_back(t.name);
    const auto changes = static_cast<int>(lane_names_.size());
    std::uint64_t alive = ~std::uint64_t{0};
    const Result base = draw(changes + (derives_ ? 2 : 1), derives_ ? changes + 1 : -1, alive, -1);
    const auto differs = [](const Outputs& a, std::size_t a_lanes, const Outputs& b, std::size_t b_lanes,
                            std::size_t lane) {
        for (std::size_t k = 0; k * b_lanes < b.size() && k * a_lanes < a.size(); ++k) {
            const double x = a[k * a_lanes], y = b[k * b_lanes + lane];
            if (std::abs(x - y) > 1e-9 * std::max({1., std::abs(x), std::abs(y)})) return true;  // false where unknown
        }
        return false;
    };
    for (int n = 0; n < changes && budget_ > 0; ++n) {
        const bool alone = (alive >> (n + 1) & 1) == 0;
        std::uint64_t other_alive = ~std::uint64_t{0};
        const Result own = alone ? draw(derives_ ? 2 : 1, derives_ ? 1 : -1, other_alive, n) : Result{};
        const Result& other = alone ? own : base;
        const std::size_t lane = alone ? 0 : static_cast<std::size_t>(n) + 1;
        const bool ended = base.end != Machine::End::unknown && other.end != Machine::End::unknown;
        if (differs(base.position, base.lanes, other.position, other.lanes, lane) || (ended && base.end != other.end) ||
            differs(base.colors, base.lanes, other.colors, other.lanes, lane))
            found_.insert(lane_names_[static_cast<std::size_t>(n)]);
    }
}

std::set<std::string_view> Trial::run() {
    budget_ = 2000 + 5 * tokens_;
    const auto open = [&](const Tried& t) { return t.wanted && !found_.contains(t.name); };
    for (round_ = 0; round_ < most_rounds && budget_ > 0; ++round_) {
        if (round_ > 0 && ranges::none_of(uniforms_, open)) break;

        try_values();
    }
    return std::move(found_);
}

}  // namespace

std::set<std::string_view> that_matter(const std::vector<Unit>& units, const std::vector<Tried>& uniforms) {
    return Trial(units, uniforms).run();
}

}  // namespace snell::glsl::run
