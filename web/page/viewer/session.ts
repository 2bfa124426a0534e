// The scene that is shown: its controls, ladders and view, every change of them, and undo.
import type { Control, Engine, Ladder, Opened, Problem, Shown } from '../engine.ts';
import { History, type Change, type Setting, type Step } from './history.ts';
import { motionFrom, slowed, valueOf, type Motion } from './motion.ts';
import { fitting, typed } from './numbers.ts';
import { canBeLogarithmic, type Track } from './steps.ts';

// "Glass.uEta 1.5 → 1.1", as the step is applied.
export function labelOf({ name, changes }: Step): string {
    const [first] = changes;
    if (name !== undefined || !first) return name ?? '';
    if (first.what === 'view') return 'view';
    const say = (side: Change['before']) => (typeof side === 'string' ? side : text(side.value));
    return `${first.key} ${say(first.before)} → ${say(first.after)}`;
}

export interface Listeners {
    // The picture is out of date; `drag`: by something that is still moving.
    redraw(drag: boolean): void;
    // Values, rungs or the view are others; the controls are the same.
    changed(): void;
    // Other controls or ladders are shown.
    listed(): void;
    // A slider begins or ends to move by itself.
    moved(): void;
    problems(problems: Problem[]): void;
    say(message: string): void;
}

function settingOf({ value, min, max }: Control): Setting {
    return { value: [...value], min, max };
}

export function isChanged({ value, initial }: Control): boolean {
    return value.some((component, i) => component !== initial[i]);
}

export function isIntegral({ type }: Control): boolean {
    return type === 'int' || type === 'uint';
}

// "uOffset.x" for a component of a vector.
export function nameOf(control: Control, component: number): string {
    const count = control.value.length;
    if (count === 1) return control.name;
    return count <= 4 ? `${control.name}.${'xyzw'[component]}` : `${control.name}[${component}]`;
}

function text(value: number[]): string {
    return value.map((component) => Number(component.toPrecision(5))).join(', ');
}

export class Session {
    shown: Shown | undefined;
    readonly history = new History();
    motions: Motion[] = [];
    // Keys of the sliders that are logarithmic.
    readonly logarithmic = new Set<string>();

    constructor(
        readonly engine: Engine,
        private readonly on: Listeners,
    ) {}

    get controls(): Control[] {
        return (this.shown?.controls ?? []).filter(({ active }) => active);
    }
    get ladders(): Ladder[] {
        return this.shown?.ladders ?? [];
    }
    get anyChanged(): boolean {
        const turned = this.ladders.some(({ chosen, marked }) => chosen !== marked);
        return turned || this.controls.some(isChanged);
    }

    // What the engine says after open(), choose() or restored().
    accept(opened: Opened): void {
        this.on.problems(opened.problems);
        if (!opened.shown) return;
        this.shown = opened.shown;
        this.on.listed();
        this.on.redraw(false);
    }

    private write(control: Control, next: Setting): void {
        if (next.min !== control.min || next.max !== control.max) this.engine.range(control.index, next.min, next.max);
        for (const [i, value] of next.value.entries())
            if (value !== control.value[i]) this.engine.set(control.index, i, value);
        Object.assign(control, { value: [...next.value], min: next.min, max: next.max });
    }

    private setTo(control: Control, next: Setting, gesture?: unknown): void {
        const before = settingOf(control);
        this.write(control, next);
        this.history.record([{ what: 'value', key: control.key, before, after: settingOf(control) }], gesture);
        this.on.redraw(gesture !== undefined);
        this.on.changed();
    }

    // Another scene is opened.
    forget(): void {
        this.history.clear();
        this.logarithmic.clear();
        this.motions = [];
        this.shown = undefined;
    }

    trackOf(control: Control): Track {
        const { key, min, max } = control;
        return { min, max, integral: isIntegral(control), logarithmic: this.logarithmic.has(key) && canBeLogarithmic(control) };
    }

    // Another scale is chosen, for the same value.
    rescaled(): void {
        this.on.changed();
    }

    motionOf({ key }: Control, component: number): Motion | undefined {
        return this.motions.find((motion) => motion.key === key && motion.component === component);
    }

    animate(control: Control, component: number, time: number): void {
        this.stop(control.key, component);
        const value = control.value[component]!;
        this.motions.push(motionFrom(control.key, component, value, this.trackOf(control), time, settingOf(control)));
        this.on.moved();
    }

    slow(motion: Motion, period: number, time: number): void {
        slowed(motion, period, time);
        this.on.moved();
    }

    // The motion is one step of undo.
    stop(key?: string, component?: number): void {
        const ends = (motion: Motion) => (key ?? motion.key) === motion.key && (component ?? motion.component) === motion.component;
        const ended = this.motions.filter(ends);
        if (ended.length === 0) return;
        this.motions = this.motions.filter((motion) => !ended.includes(motion));
        for (const motion of ended) {
            const control = this.controls.find((each) => each.key === motion.key);
            if (control) this.history.record([{ what: 'value', key: motion.key, before: motion.before, after: settingOf(control) }]);
        }
        this.on.moved();
    }

    // Sets the values of this time.
    move(time: number): void {
        for (const motion of this.motions) {
            const control = this.controls.find(({ key }) => key === motion.key);
            if (control?.value[motion.component] === undefined) continue;
            const moved = valueOf(motion, this.trackOf(control), time);
            const value = control.value.map((each, i) => (i === motion.component ? moved : each));
            this.write(control, { ...settingOf(control), value });
        }
        if (this.motions.length > 0) this.on.changed();
    }

    // Values outside of the range widen it if `widen`, and else are moved into it. Returns what the control has then.
    set(control: Control, component: number, value: number, options: { gesture?: unknown; widen?: boolean } = {}): number {
        this.stop(control.key, component);
        const next = settingOf(control);
        const fit = fitting(value, control.type);
        if (fit === undefined) return control.value[component]!;
        const slides = control.widget === 'slider';
        if (slides && options.widen && !control.fixed) {
            next.min = Math.min(next.min, fit);
            next.max = Math.max(next.max, fit);
        }
        next.value[component] = slides ? Math.min(Math.max(fit, next.min), next.max) : fit;
        this.setTo(control, next, options.gesture);
        return next.value[component];
    }

    // What differs from the scene's ranges: "Glass.uEta=1,5".
    ranges(): string[] {
        const differ = this.controls.filter((control) => control.min !== control.initialMin || control.max !== control.initialMax);
        return differ.map(({ key, min, max }) => `${key}=${min},${max}`);
    }

    // Takes what ranges() gave. Returns what does not fit.
    setRanges(ranges: readonly string[]): string[] {
        return ranges.filter((each) => {
            const equals = each.indexOf('=');
            const control = this.controls.find(({ key, widget }) => widget === 'slider' && key === each.slice(0, equals));
            const [min, max, more] = each.slice(equals + 1).split(',').map((text) => typed(text, control?.type ?? ''));
            const fits = control && !control.fixed && min !== undefined && max !== undefined && more === undefined && min < max;
            if (!fits || control.value.some((value) => value < min || value > max)) return true;
            this.write(control, { value: control.value, min, max });
            return false;
        });
    }

    setAll(control: Control, value: number[], gesture?: unknown): void {
        this.stop(control.key);
        this.setTo(control, { ...settingOf(control), value }, gesture);
    }

    reset(control: Control, component?: number): void {
        this.stop(control.key, component);
        const { initial, initialMin: min, initialMax: max } = control;
        if (component === undefined) return this.setTo(control, { value: [...initial], min, max });
        const value = control.value.map((now, i) => (i === component ? initial[i]! : now));
        const fits = value.every((each) => each >= min && each <= max);
        this.setTo(control, fits ? { value, min, max } : { ...settingOf(control), value });
    }

    // Of one program, or of all, and then the rungs, too.
    resetAll(program?: string): void {
        this.stop();
        const changes: Change[] = [];
        for (const control of this.controls) {
            const { key, initial, initialMin: min, initialMax: max } = control;
            if (program !== undefined && control.program !== program) continue;
            changes.push({ what: 'value', key, before: settingOf(control), after: { value: [...initial], min, max } });
        }
        if (program === undefined)
            for (const { name, rungs, chosen, marked } of this.ladders)
                changes.push({ what: 'rung', key: name, before: rungs[chosen]!, after: rungs[marked]! });
        this.apply({ changes });
        this.history.record(changes, undefined, program ? `reset of ${program}` : 'reset of all values');
        this.on.changed();
    }

    choose(ladder: Ladder, rung: number): void {
        const change: Change = { what: 'rung', key: ladder.name, before: ladder.rungs[ladder.chosen]!, after: ladder.rungs[rung]! };
        this.accept(this.engine.choose(ladder.index, rung));
        const now = this.ladders.find(({ name }) => name === ladder.name);
        if (now?.chosen === rung) this.history.record([change]);
        this.on.changed();
    }

    // A gesture over the picture, or its reset.
    changeView(change: () => void, gesture?: unknown): void {
        const before = this.engine.view();
        change();
        const after = this.engine.view();
        if (after === before) return;
        this.history.record([{ what: 'view', key: '', before, after }], gesture);
        this.on.redraw(gesture !== undefined);
        this.on.changed();
    }

    // Drops what the scene no longer has.
    private apply(step: Step): void {
        for (const change of step.changes) {
            if (change.what === 'view') this.engine.setView(change.after);
            else if (change.what === 'rung') this.applyRung(change.key, change.after);
            else {
                const control = this.shown?.controls.find(({ key }) => key === change.key);
                if (control?.value.length === change.after.value.length) this.write(control, change.after);
            }
        }
        this.on.redraw(false);
    }

    private applyRung(name: string, rung: string): void {
        const ladder = this.ladders.find((each) => each.name === name);
        const at = ladder?.rungs.indexOf(rung) ?? -1;
        if (ladder && at >= 0 && at !== ladder.chosen) this.accept(this.engine.choose(ladder.index, at));
    }

    private go(step: Step | undefined, word: string): void {
        if (!step) return;
        this.apply(step);
        this.on.changed();
        this.on.say(`${word}: ${labelOf(step)}`);
    }

    undo(): void {
        this.stop();
        this.go(this.history.undo(), 'Undo');
    }
    redo(): void {
        this.stop();
        this.go(this.history.redo(), 'Redo');
    }
}
