// Programs for the values that their uniforms have: which values these are, and what they switch off.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/plan/values/declared.h"
#include "src/runtime/impl.h"
#include "src/runtime/resources/program.h"

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
        return ranges::find_if(linked.declared, [&](const auto& declared) { return of(uniform, declared); }) -
               linked.declared.begin();
    };
    ranges::stable_sort(uniforms, {}, [&](const ActiveUniform& uniform) {
        return std::pair(rank(uniform), std::string_view(uniform.name));
    });
    return uniforms;
}

constexpr std::size_t most_forms = 4;  // besides that of any values

}  // namespace

// The controls of a program that is not compiled yet are those of the uniforms that it declares.
glsl::Settler Runtime::Impl::settler(Index program) const {
    return [this, program](std::span<const glsl::DeclaredUniform> declared) {
        std::vector<std::vector<ActiveUniform>> uniforms(plan.scene.programs.size());
        for (const glsl::DeclaredUniform& one : declared)
            if (one.simple) uniforms[program].push_back(described(plan.scene.programs[program], one));
        Diagnostics unheard;  // the controls of all active uniforms will report it
        Controls controls = make_controls(plan.scene, uniforms, unheard);
        settle(controls, plan.scene);
        std::vector<glsl::Settled> constants;
        for (const ActiveUniform& uniform : uniforms[program]) {
            const Control* control = controls.find(program, uniform.name);
            if (!uniform.system && control && !control->varies) constants.push_back({uniform.name, control->value});
        }
        return constants;
    };
}

std::vector<ActiveUniform> Runtime::Impl::general_uniforms(Index program, const LinkedProgram& linked,
                                                           runtime::Variant variant, Loading& loading) {
    std::vector<ActiveUniform> uniforms = linked.active;
    if (linked.settled.empty()) return as_declared(std::move(uniforms), linked);
    const auto is_active = [&](const glsl::DeclaredUniform& declared) {
        return ranges::any_of(linked.active, [&](const ActiveUniform& uniform) { return of(uniform, declared); });
    };
    for (const glsl::DeclaredUniform& declared : linked.declared) {
        // Of an array or a structure, a program for values may need fewer elements or members.
        const bool whole =
            declared.simple || (declared.array_size == 0 && sampler_target(declared.name, declared.glsl_type));
        if (!declared.used || (whole && is_active(declared))) continue;
        if (whole) {
            uniforms.push_back(described(plan.scene.programs[program], declared));
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
        const auto live = ranges::find(linked.samplers, uniform.name, &SamplerUniform::name);
        const int elements = live == linked.samplers.end() ? 0 : live->size;
        if (uniform.type != ValueType::sampler || elements >= uniform.array_size) continue;
        SamplerUniform sampler{uniform.name,
                               uniform.glsl_type,
                               sampler_target(uniform.name, uniform.glsl_type),
                               -1,
                               0,
                               uniform.array_size,
                               {}};
        sampler.first_unit = elements;  // the first element that is dormant: it has no unit of OpenGL
        for (const double unit : uniform.initial) sampler.initial.push_back(static_cast<int>(unit));
        dormant[program].push_back(std::move(sampler));
    }
}

void Runtime::Impl::report_dormant(Index pass, const runtime::ReadyDraw& ready, Diagnostics& diagnostics) const {
    const Draw& draw = plan.scene.draws[ready.draw];
    if (draw.program == none) return;
    for (const runtime::Sampled& sampled : sampled_by(draw, dormant[draw.program]))
        if (sampled.element >= sampled.sampler->first_unit)
            if (auto problem = unreadable(sampled, draw, pass, ready.draw)) diagnostics.add(std::move(*problem));
    if (!spares_harmonics(draw, *ready.program)) return;
    if (auto problem = no_harmonics(pass, ready.draw)) diagnostics.add(std::move(*problem));
}

void Runtime::Impl::note_dormant() {
    dormant_textures.clear();
    const auto note = [&](Index texture) {
        if (!textures.asked(texture)) dormant_textures.insert(textures.first(texture));
    };
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const Item& item : plan.scene.passes[pass].items) {
            if (item.kind != Item::Kind::draw || !passes[pass].wanted) continue;
            const Draw& draw = plan.scene.draws[item.index];
            const LinkedProgram* linked = program_of(pass, draw);
            if (!linked) continue;
            ranges::for_each(spared_by(draw, *linked), note);
            if (!passes[pass].live) ranges::for_each(read_by(draw, *linked), note);
        }
    counters.images_spared = 0;
    for (const Index texture : dormant_textures) counters.images_spared += plan.scene.textures[texture].files.size();
}

LinkedProgram* Runtime::Impl::program_of(Index pass, const Draw& draw) const {
    runtime::Variant variant = variant_of(pass, draw);
    variant.settled = draw.program == none ? 0 : settled_values;
    const auto found = programs.find({draw.program, variant});
    return found == programs.end() ? nullptr : found->second.get();
}

std::shared_ptr<LinkedProgram> Runtime::Impl::link_for(Index pass, const Draw& draw,
                                                       std::vector<glsl::Settled> constants) {
    Counters uncounted;  // nothing is drawn with it
    Diagnostics unheard;
    return runtime::link_program({plan.scene.programs[draw.program], plan.programs[draw.program].stages,
                                  plan.scene.ladders, variant_of(pass, draw), caps, *files, *sources, store.get(),
                                  uncounted, [&](const auto&) { return constants; }},
                                 unheard);
}

// False: there is nothing to link.
bool Runtime::Impl::link_alone() {
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const Item& item : plan.scene.passes[pass].items) {
            if (item.kind != Item::Kind::draw || !passes[pass].live) continue;
            const Draw& draw = plan.scene.draws[item.index];
            LinkedProgram* const linked = program_of(pass, draw);
            if (!linked || linked->alone.size() == linked->settled.size()) continue;
            // Without one, as where a driver refuses the constant, nothing is known to be left out.
            const auto names = [&](const LinkedProgram* of) {
                std::vector<std::string> all;
                for (const ActiveUniform& uniform : of ? of->active : active[draw.program]) all.push_back(uniform.name);
                return all;
            };
            if (!linked->general) {
                linked->general = names(link_for(pass, draw, {}).get());
                return true;
            }
            const glsl::Settled& one = linked->settled[linked->alone.size()];
            const bool read = ranges::count(*linked->general, one.name) > 0;
            std::vector<glsl::Settled> constants = linked->settled;
            for (glsl::Settled& other : constants)  // of two numbers only the larger is known: it decides nothing
                if (other.name != one.name) other.values.push_back(other.values.front());
            linked->alone.push_back(names(read ? link_for(pass, draw, std::move(constants)).get() : nullptr));
            return true;
        }
    return false;
}

std::vector<const Control*> Runtime::Impl::without_effect(double seconds) const {
    std::vector<const Control*> found;
    const runtime::Patience patience{seconds};
    for (Index program = 0; program < plan.scene.programs.size(); ++program) {
        std::vector<const Control*> sliders;
        for (const Control& control : given.items)
            if (control.program == program && control.active && control.listed && control.value.size() == 1 &&
                (control.widget == Widget::slider || control.type == ValueType::bool_))
                sliders.push_back(&control);
        bool drawn = false;  // in each of its variants the slider must be without effect
        for (const auto& [key, linked] : programs) {
            const auto& [index, variant] = key;
            if (index != program || !linked || variant.settled != 0) continue;
            drawn = true;
            if (8 * linked->load_ms > 1000 * seconds) sliders.clear();  // it would have to be linked many times
            Counters uncounted;
            sliders = runtime::without_effect({plan.scene.programs[program], plan.programs[program].stages,
                                               plan.scene.ladders, variant, caps, *files, *sources, nullptr, uncounted},
                                              std::move(sliders), patience);
        }
        if (drawn) found.insert(found.end(), sliders.begin(), sliders.end());
    }
    return found;
}

void Runtime::Impl::find_stand() {
    stand.clear();
    for (const auto& [key, linked] : programs) {
        const auto& [program, variant] = key;
        if (!linked || variant.settled != settled_values) continue;
        for (const glsl::Settled& one : linked->settled)
            if (const Control* control = given.find(program, one.name); control && control->active)
                stand.push_back({static_cast<Index>(control - given.items.data()), one.values});
    }
}

bool Runtime::Impl::stands(const Controls& controls) const {
    return ranges::all_of(stand,
                          [&](const runtime::Settled& one) { return controls.items[one.control].value == one.values; });
}

// ---- forms, for windows -----------------------------------------------------------------------------------

void Runtime::Impl::exchange(runtime::Form& other) {
    for (Index pass = 0; pass < passes.size(); ++pass) {  // both draw into the same cube maps
        other.passes[pass].cube_seen = std::move(passes[pass].cube_seen);
        other.passes[pass].next_face = passes[pass].next_face;
        other.passes[pass].stale = passes[pass].stale;
    }
    std::swap(settled_values, other.settled_values);
    std::swap(stand, other.stand);
    std::swap(dormant, other.dormant);
    std::swap(dormant_textures, other.dormant_textures);
    std::swap(passes, other.passes);
    std::swap(animated, other.animated);
    std::swap(mouse, other.mouse);
    fitted.reset();
}

bool Runtime::Impl::take_form(const Controls& controls) {
    const auto fits = [&](const runtime::Form& form) {
        return form.settled_values != 0 && ranges::all_of(form.stand, [&](const runtime::Settled& one) {
                   return controls.items[one.control].value == one.values;
               });
    };
    auto found = ranges::find_if(forms, fits);
    if (found == forms.end() && settled_values == 0) return true;
    if (found == forms.end()) found = ranges::find(forms, 0, &runtime::Form::settled_values);
    if (found == forms.end()) return false;
    exchange(*found);
    std::rotate(forms.begin(), found, found + 1);
    return true;
}

// Back to programs for any values alone.
void Runtime::Impl::forget_forms() {
    const auto any = ranges::find(forms, 0, &runtime::Form::settled_values);
    if (any != forms.end()) exchange(*any);
    forms.clear();
    std::erase_if(programs, [&](const auto& entry) {
        return entry.first.second.settled != 0 && entry.first.second.settled != settled_values;
    });
    making.values.clear();
    making.state = runtime::Making::State::done;
}

bool Runtime::Impl::specialise(const Frame& frame, const Surface& surface) {
    using State = runtime::Making::State;
    take(frame.controls);
    if (!savings || settle || (settled_values != 0 && making.state == State::done)) return false;
    if (std::vector<double> now = values_of(*values); now != making.values || making.number == 0) {
        if (settled_values != 0) return false;
        making = {making.number + 1, std::move(now), State::linking, 0};
    }
    if (making.state == State::done) return false;  // nothing can be settled, as was found before
    if (making.state == State::linking && !link_next()) return false;
    if (making.state == State::drawing) warm_next(frame, surface);
    return true;
}

// Compiles one of the programs that are drawn, or makes the form once all are there. False: nothing can be settled.
bool Runtime::Impl::link_next() {
    using State = runtime::Making::State;
    Diagnostics heard_before;
    Loading loading{heard_before, {}};
    const Controls now = *values;
    settle = [&now](Controls& controls, const Scene&) {
        for (Control& control : controls.items)
            if (const Control* same = now.find(control.program, control.name);
                same && same->value.size() == control.value.size())
                control.value = same->value;
    };
    bool any = false;
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const auto& item : passes[pass].items) {
            if (!item || plan.scene.draws[item->draw].program == none) continue;
            runtime::Variant variant = variant_of(pass, plan.scene.draws[item->draw]);
            variant.settled = making.number;
            const Index program = plan.scene.draws[item->draw].program;
            const bool known = programs.contains({program, variant});
            any = any || !made(program, variant, loading)->settled.empty();
            if (known) continue;
            settle = nullptr;
            return true;
        }
    making.state = any ? State::drawing : State::done;
    if (any) {
        runtime::Form form;
        form.passes.resize(passes.size());
        exchange(form);
        forms.insert(forms.begin(), std::move(form));
        if (forms.size() > most_forms) drop_form();
        settled_values = making.number;
        textures.resume(heard_before);
        prepare(heard_before);
    }
    settle = nullptr;
    return any;
}

// The one that was not used for the longest time.
void Runtime::Impl::drop_form() {
    const auto oldest =
        std::find_if(forms.rbegin(), forms.rend(), [](const runtime::Form& form) { return form.settled_values != 0; });
    if (oldest == forms.rend()) return;
    const int number = oldest->settled_values;
    forms.erase(std::next(oldest).base());
    std::erase_if(programs, [&](const auto& entry) { return entry.first.second.settled == number; });
    std::erase_if(program_problems, [&](const auto& entry) { return entry.first.second.settled == number; });
}

// Draws one pixel of the window with the next program that was not used yet, into a picture that is drawn again before
// it is shown.
void Runtime::Impl::warm_next(const Frame& frame, const Surface& surface) {
    const std::vector<const runtime::ReadyDraw*> all = window_draws();
    const auto is_new = [&](std::size_t i) {
        const auto before = std::span(all).first(i);
        return !all[i]->program->settled.empty() &&
               ranges::count(before, all[i]->program, &runtime::ReadyDraw::program) == 0;
    };
    while (making.drawn < all.size() && !is_new(making.drawn)) ++making.drawn;
    if (making.drawn < all.size()) {
        std::vector<bool> hidden(plan.scene.draws.size(), true);
        hidden[all[making.drawn++]->draw] = false;
        Frame one = frame;
        one.hidden = &hidden;
        one.standing = true;
        Surface pixel = surface;
        pixel.region = PixelRect{0, 0, 1, 1};
        const Counters before = counters;
        draw(one, pixel);
        counters = before;
    }
    if (making.drawn >= all.size()) making.state = runtime::Making::State::done;
}

}  // namespace snell
