// One row of the panel: a slider of one component.
import type { Control } from '../engine.ts';
import { el } from '../dom.ts';
import { makeField, type Say } from './field.ts';
import { shown } from './numbers.ts';
import { isIntegral, nameOf, type Session } from './session.ts';
import { makeSliderMenu } from './slider_menu.ts';
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

// With Alt, the knob moves by a twentieth of the way, from where it is.
function dragFine(input: HTMLInputElement, value: () => number, track: () => Track, set: (value: number) => void): void {
    let at: { x: number; fraction: number } | undefined;
    input.addEventListener('pointerdown', (event) => {
        if (!event.altKey || event.button !== 0) return;
        event.preventDefault();
        input.focus();
        input.setPointerCapture(event.pointerId);
        at = { x: event.clientX, fraction: fractionOf(value(), track()) };
    });
    input.addEventListener('pointermove', (event) => {
        if (!at) return;
        const moved = (event.clientX - at.x) / Math.max(input.clientWidth, 1);
        set(valueAt(at.fraction + moved / 20, track(), true));
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
    const track = () => session.trackOf(control);
    dragFine(input, () => control.value[component]!, track, set);
    // The element itself knows no logarithms.
    const own = () => (track().logarithmic ? { min: 0, max: 1, integral: false } : track());
    input.addEventListener('input', () => set(valueAt(fractionOf(input.valueAsNumber, own()), track())));
    input.addEventListener('change', end);
    input.addEventListener('keyup', end);
    input.addEventListener('pointerup', end);
    input.addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        const steps = stepsOf(event.key, event.shiftKey);
        if (steps !== 0) set(stepped(control.value[component]!, steps, track()));
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
        const fraction = fractionOf(value, track());
        const scale = own();
        const at = track().logarithmic ? fraction : value;
        Object.assign(input, { min: String(scale.min), max: String(scale.max), step: scale.integral ? '1' : 'any', value: String(at) });
        input.setAttribute('aria-valuetext', shown(value, min, max, isIntegral(control)));
        input.style.setProperty('--at', `${100 * fraction}%`);
    };
    return { element: input, refresh };
}

// What fits into a field.
function short(text: string, value: number): string {
    return text.length <= 8 ? text : String(Number(value.toPrecision(3)));
}

export function makeSliderRow(session: Session, control: Control, component: number, sayAbout: Say, time: () => number): Row {
    const name = nameOf(control, component);
    const say = (message: string) => sayAbout(message, `${control.key}.${component}`);
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
    const menu = makeSliderMenu(session, control, component, label, time);
    const element = el('div', { class: 'row slider' }, dot.element, menu, track.element, field.element);
    const refresh = () => {
        label.title = `${name}: ${control.min} … ${control.max}\nscene's value: ${text(control.initial[component]!)}`;
        element.classList.toggle('moves', session.motionOf(control, component) !== undefined);
        dot.show(control.value[component] !== control.initial[component]);
        track.refresh();
        field.refresh();
    };
    refresh();
    return { element, refresh };
}
