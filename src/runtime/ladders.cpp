// Changes rungs while a scene runs. What a rung needs is compiled and loaded when it is first chosen, and kept.

#include "src/runtime/impl.h"

#include "parser/text/ranges.h"

namespace snell {

namespace {

bool exist(const Rungs& rungs, const std::vector<Ladder>& ladders) {
    return ranges::equal(rungs, ladders,
                         [](std::size_t rung, const Ladder& ladder) { return rung < ladder.rungs.size(); });
}

bool same(const Diagnostic& a, const Diagnostic& b) {
    return a.code == b.code && a.span == b.span && a.message == b.message;
}

}  // namespace

bool Runtime::Impl::choose(const Rungs& rungs) {
    if (rungs == plan.rungs || !exist(rungs, plan.scene.ladders)) return false;
    plan.rungs = rungs;
    forget_forms();
    Diagnostics all;
    textures.resume(all);
    prepare(all);
    problems = {};
    for (const Diagnostic& diagnostic : all.items()) {
        const auto known = [&](const Diagnostic& other) { return same(diagnostic, other); };
        if (ranges::none_of(said, known) && ranges::none_of(problems.items(), known)) problems.add(diagnostic);
    }
    return true;
}

void Runtime::Impl::take(const Controls& controls) {
    choose(controls.rungs);
    const auto place = [&] {
        values = &controls;
        if (same_uniforms(controls, given)) return;
        moved = given;
        carry_over(controls, plan.scene, moved, plan.scene);
        values = &moved;
    };
    place();
    if (stands(*values) && (settled_values != 0 || forms.empty())) return;
    if (take_form(*values)) return;
    settle = nullptr;
    settled_values = 0;
    Diagnostics heard_before;
    textures.resume(heard_before);
    prepare(heard_before);
    place();
}

std::vector<Index> Runtime::Impl::controls_of(Index program, const runtime::LinkedProgram& linked) const {
    std::vector<Index> places;
    for (const runtime::UserUniform& uniform : linked.user) {
        const Control* control = given.find(program, uniform.name);
        // A program for values may need fewer elements of an array.
        const bool usable = control && control->active && control->components == uniform.components &&
                            control->value.size() >= uniform.last.size();
        places.push_back(usable ? static_cast<Index>(control - given.items.data()) : none);
    }
    return places;
}

void Runtime::Impl::take_parts(bool wanted) {
    if (parts == wanted) return;
    parts = wanted;
    forget_forms();
    const auto reads_place = [](const auto& program) { return program.second && program.second->reads_place; };
    if (ranges::none_of(programs, reads_place)) return;
    Diagnostics heard_before;
    textures.resume(heard_before);
    prepare(heard_before);
}

// A program knows only the ladders before it.
Rungs Runtime::Impl::rungs_of(Index program) const {
    const auto known = static_cast<std::ptrdiff_t>(plan.scene.programs[program].ladders);
    return {plan.rungs.begin(), plan.rungs.begin() + known};
}

// Links the program for the chosen rungs. If it does not compile, the program stays as it was before.
runtime::LinkedProgram* Runtime::Impl::link_chosen(Index program, runtime::Variant variant, Loading& loading) {
    variant.rungs = rungs_of(program);
    runtime::LinkedProgram* linked = link(program, variant, loading);
    if (linked || !working[program]) {
        if (linked) working[program] = variant.rungs;
        return linked;
    }
    variant.rungs = *working[program];
    return link(program, variant, loading);
}

}  // namespace snell
