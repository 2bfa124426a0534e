// Programs for the values that their uniforms have: which values these are, and what they switch off.
#include <algorithm>

#include "src/runtime/impl.h"

namespace snell {

using runtime::LinkedProgram;
using runtime::SamplerUniform;

namespace {

// The uniform is the declared one, or a member of it.
bool of(const ActiveUniform& uniform, const glsl::DeclaredUniform& declared) {
    const std::size_t length = declared.name.size();
    if (!uniform.name.starts_with(declared.name)) return false;
    return uniform.name.size() == length || uniform.name[length] == '.' || uniform.name[length] == '[';
}

// Drivers list the uniforms of different forms of a program in different orders.
std::vector<ActiveUniform> as_declared(std::vector<ActiveUniform> uniforms, const LinkedProgram& linked) {
    const auto rank = [&](const ActiveUniform& uniform) {
        return std::ranges::find_if(linked.declared, [&](const auto& declared) { return of(uniform, declared); }) -
               linked.declared.begin();
    };
    std::ranges::stable_sort(uniforms, {}, [&](const ActiveUniform& uniform) {
        return std::pair(rank(uniform), std::string_view(uniform.name));
    });
    return uniforms;
}

}  // namespace

// The controls of a program that is not compiled yet are those of the uniforms that it declares.
glsl::Settler Runtime::Impl::settler(Index program) const {
    return [this, program](std::span<const glsl::DeclaredUniform> declared) {
        std::vector<std::vector<ActiveUniform>> uniforms(plan.scene.programs.size());
        for (const glsl::DeclaredUniform& one : declared)
            if (one.simple) uniforms[program].push_back(runtime::described(plan.scene.programs[program], one));
        Diagnostics unheard;  // the controls of all active uniforms will report it
        Controls controls = make_controls(plan.scene, uniforms, unheard);
        settle(controls, plan.scene);
        std::vector<glsl::Settled> settled;
        for (const ActiveUniform& uniform : uniforms[program]) {
            const Control* control = controls.find(program, uniform.name);
            if (!uniform.system && control && !control->varies) settled.push_back({uniform.name, control->value});
        }
        return settled;
    };
}

std::vector<ActiveUniform> Runtime::Impl::general_uniforms(Index program, const LinkedProgram& linked,
                                                           runtime::Variant variant, Loading& loading) {
    std::vector<ActiveUniform> uniforms = linked.active;
    if (linked.settled.empty()) return as_declared(std::move(uniforms), linked);
    const auto is_active = [&](const glsl::DeclaredUniform& declared) {
        return std::ranges::any_of(linked.active, [&](const ActiveUniform& uniform) { return of(uniform, declared); });
    };
    for (const glsl::DeclaredUniform& declared : linked.declared) {
        if (declared.use == glsl::DeclaredUniform::Use::none || is_active(declared)) continue;
        const bool sampler = declared.array_size == 0 && sampler_target(declared.glsl_type);
        if (declared.use == glsl::DeclaredUniform::Use::sure && (declared.simple || sampler)) {
            uniforms.push_back(runtime::described(plan.scene.programs[program], declared));
            continue;
        }
        variant.rungs = working[program].value_or(rungs_of(program));  // the driver knows
        variant.settled = 0;
        const auto& general = made(program, variant, loading);
        if (general) uniforms = general->active;
        break;
    }
    return as_declared(std::move(uniforms), linked);
}

void Runtime::Impl::find_dormant(Index program, const LinkedProgram& linked) {
    for (const ActiveUniform& uniform : active[program]) {
        if (uniform.type != ValueType::sampler ||
            std::ranges::count(linked.samplers, uniform.name, &SamplerUniform::name) > 0)
            continue;
        SamplerUniform sampler{
            uniform.name, uniform.glsl_type, sampler_target(uniform.glsl_type), -1, 0, uniform.array_size, {}};
        for (const double unit : uniform.initial) sampler.initial.push_back(static_cast<int>(unit));
        dormant[program].push_back(std::move(sampler));
    }
}

void Runtime::Impl::report_dormant(Index pass, Index index, Diagnostics& diagnostics) const {
    const Draw& draw = plan.scene.draws[index];
    if (draw.program == none) return;
    for (const runtime::Sampled& sampled : sampled_by(draw, dormant[draw.program]))
        if (auto problem = unreadable(sampled, draw, pass, index)) diagnostics.add(std::move(*problem));
}

void Runtime::Impl::note_dormant() {
    dormant_textures.clear();
    for (const Pass& pass : plan.scene.passes)
        for (const Item& item : pass.items) {
            if (item.kind != Item::Kind::draw) continue;
            const Draw& draw = plan.scene.draws[item.index];
            if (draw.program == none) continue;
            for (const Index texture : read_by(draw, dormant[draw.program]))
                if (!textures.asked(texture)) dormant_textures.insert(textures.first(texture));
        }
    counters.images_spared = 0;
    for (const Index texture : dormant_textures) counters.images_spared += plan.scene.textures[texture].files.size();
}

void Runtime::Impl::find_stand() {
    stand.clear();
    for (const auto& [key, linked] : programs) {
        const auto& [program, variant] = key;
        if (!linked || variant.settled != settled_values) continue;
        for (const glsl::Settled& settled : linked->settled)
            if (const Control* control = given.find(program, settled.name))
                stand.push_back({static_cast<Index>(control - given.items.data()), settled.values});
    }
}

bool Runtime::Impl::stands(const Controls& controls) const {
    return std::ranges::all_of(stand,
                               [&](const Stand& one) { return controls.items[one.control].value == one.values; });
}

}  // namespace snell
