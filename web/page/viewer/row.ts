// One row of the panel: a slider of one component.
import type { Control } from '../engine.ts';
import { el } from './dom.ts';
import { makeField } from './field.ts';
import { shown } from './numbers.ts';
import { isIntegral, nameOf, type Session } from './session.ts';
import { fractionOf, stepped, stepsOf, valueAt, type Track } from './steps.ts';

export interface Row {
    element: HTMLElement;
    refresh(): void;
}

// A long name is cut in the middle: its end tells it from its neighbours.
export function makeName(name: string, title: string): HTMLElement {
    const end = name.length > 10 ? 5 : 0;
    const head = el('span', { class: 'head' }, name.slice(0, name.length - end));
    return el('span', { class: 'name', title }, head, el('span', {}, end ? name.slice(-end) : ''));
}

// The dot at the left of what is not the scene's.
export function makeDot(name: string, reset: () => void): { element: HTMLElement; show(changed: boolean): void } {
    const element = el('button', { type: 'button', class: 'dot', 'aria-label': `Reset ${name}`, title: `Reset ${name}` });
    element.addEventListener('click', reset);
    return { element, show: (changed) => void (element.style.visibility = changed ? 'visible' : 'hidden') };
}

export function trackOf(control: Control): Track {
    return { min: control.min, max: control.max, integral: isIntegral(control) };
}

// With Alt, the knob moves by a twentieth of the way, from where it is.
function dragFine(input: HTMLInputElement, control: Control, component: number, set: (value: number) => void): void {
    let at: { x: number; fraction: number } | undefined;
    input.addEventListener('pointerdown', (event) => {
        if (!event.altKey || event.button !== 0) return;
        event.preventDefault();
        input.focus();
        input.setPointerCapture(event.pointerId);
        at = { x: event.clientX, fraction: fractionOf(control.value[component]!, trackOf(control)) };
    });
    input.addEventListener('pointermove', (event) => {
        if (!at) return;
        const moved = (event.clientX - at.x) / Math.max(input.clientWidth, 1);
        set(valueAt(at.fraction + moved / 20, trackOf(control), true));
    });
    for (const type of ['pointerup', 'pointercancel'])
        input.addEventListener(type, () => void (at = undefined));
}

function makeTrack(session: Session, control: Control, component: number, type: () => void): Row {
    const input = el('input', { type: 'range', 'aria-label': `${control.program} ${nameOf(control, component)}` });
    // One object for each gesture: what it changes is one step of undo.
    let gesture = {};
    const end = () => {
        gesture = {};
        session.history.end();
    };
    const set = (value: number) => void session.set(control, component, value, { gesture });
    const reset = () => session.reset(control, component);
    dragFine(input, control, component, set);
    input.addEventListener('input', () => set(valueAt(fractionOf(input.valueAsNumber, trackOf(control)), trackOf(control))));
    input.addEventListener('change', end);
    input.addEventListener('keyup', end);
    input.addEventListener('pointerup', end);
    input.addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        const steps = stepsOf(event.key, event.shiftKey);
        if (steps !== 0) set(stepped(control.value[component]!, steps, trackOf(control)));
        else if (event.key === 'Home') set(control.min);
        else if (event.key === 'End') set(control.max);
        else if (event.key === 'Enter') type();
        else return;
        event.preventDefault();
        event.stopPropagation();
    });
    input.addEventListener('contextmenu', (event) => {
        event.preventDefault();
        reset();
    });
    input.addEventListener('dblclick', type);
    input.addEventListener('click', (event) => event.ctrlKey && type());
    const refresh = () => {
        const { min, max } = control;
        const value = control.value[component]!;
        const step = isIntegral(control) ? '1' : 'any';
        Object.assign(input, { min: String(min), max: String(max), step, value: String(value) });
        input.setAttribute('aria-valuetext', shown(value, min, max, isIntegral(control)));
        input.style.setProperty('--at', `${100 * fractionOf(value, trackOf(control))}%`);
    };
    return { element: input, refresh };
}

// What fits into a field.
function short(text: string, value: number): string {
    return text.length <= 8 ? text : String(Number(value.toPrecision(3)));
}

export function makeSliderRow(session: Session, control: Control, component: number, say: (message: string) => void): Row {
    const name = nameOf(control, component);
    const text = (value: number) => shown(value, control.min, control.max, isIntegral(control));
    const field = makeField({
        label: `${control.program} ${name}, number`,
        type: control.type,
        shown: () => short(text(control.value[component]!), control.value[component]!),
        exact: () => String(control.value[component]!),
        apply: (value, entered) => {
            const now = session.set(control, component, value, { widen: entered });
            const why = control.fixed ? 'there are no pictures beyond its range' : 'press Enter after a number to widen the range';
            if (now !== value) say(`${name} is ${text(now)}: ${why}.`);
        },
        say,
    });
    const track = makeTrack(session, control, component, () => field.element.focus());
    const dot = makeDot(name, () => session.reset(control, component));
    const label = makeName(name, '');
    const element = el('div', { class: 'row slider' }, dot.element, label, track.element, field.element);
    const refresh = () => {
        label.title = `${name}: ${control.min} … ${control.max}\nscene's value: ${text(control.initial[component]!)}`;
        dot.show(control.value[component] !== control.initial[component]);
        track.refresh();
        field.refresh();
    };
    refresh();
    return { element, refresh };
}
