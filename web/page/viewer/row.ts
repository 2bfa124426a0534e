// One row of the panel: a slider of one component.
import type { Control } from '../engine.ts';
import { el } from '../dom.ts';
import { makeField, type Say } from './field.ts';
import { nameOf, type Session } from './session.ts';
import { makeSliderMenu } from './slider_menu.ts';

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

// With Alt or Shift, the knob moves by a twentieth of the way, from where it is.
function dragFine(input: HTMLInputElement, fraction: () => number, slide: (fraction: number) => void): void {
    let at: { x: number; fraction: number } | undefined;
    input.addEventListener('pointerdown', (event) => {
        if (!(event.altKey || event.shiftKey) || event.button !== 0) return;
        event.preventDefault();
        input.focus();
        input.setPointerCapture(event.pointerId);
        at = { x: event.clientX, fraction: fraction() };
    });
    input.addEventListener('pointermove', (event) => {
        if (!at) return;
        const moved = (event.clientX - at.x) / Math.max(input.clientWidth, 1);
        slide(at.fraction + moved / 20);
    });
    for (const type of ['pointerup', 'pointercancel'])
        input.addEventListener(type, () => void (at = undefined));
}

// How many steps a key makes; 0: it is none of the track's keys.
function stepsOf(key: string, shift: boolean): number {
    const unit = shift ? 0.1 : 1;
    const steps: Record<string, number> = { ArrowRight: unit, ArrowUp: unit, ArrowLeft: -unit, ArrowDown: -unit, PageUp: 10, PageDown: -10 };
    return steps[key] ?? 0;
}

function makeTrack(session: Session, control: Control, component: number, type: () => void): Row {
    // The element itself knows no logarithms.
    const input = el('input', { type: 'range', min: 0, max: 1, step: 'any', 'aria-label': `${control.program} ${nameOf(control, component)}` });
    const { engine } = session;
    // One object for each gesture: what it changes is one step of undo.
    let gesture = {};
    const end = () => {
        gesture = {};
        session.end();
    };
    const slide = (fraction: number, fine = false) => session.change(() => engine.slide(control.index, component, fraction, fine), gesture);
    dragFine(input, () => control.at[component]!, (fraction) => slide(fraction, true));
    input.addEventListener('input', () => slide(input.valueAsNumber));
    input.addEventListener('change', end);
    input.addEventListener('keyup', end);
    input.addEventListener('pointerup', end);
    input.addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        const steps = stepsOf(event.key, event.shiftKey);
        if (steps !== 0) session.change(() => engine.step(control.index, component, steps), gesture);
        else if (event.key === 'Home') slide(0);
        else if (event.key === 'End') slide(1);
        else if (event.key === 'Enter') type();
        else return;
        event.preventDefault();
        event.stopPropagation();
    });
    input.addEventListener('contextmenu', (event) => {
        event.preventDefault();
        session.reset(control, component);
    });
    input.addEventListener('dblclick', type);
    input.addEventListener('click', (event) => event.ctrlKey && type());
    const refresh = () => {
        const at = control.at[component]!;
        input.value = String(at);
        input.setAttribute('aria-valuetext', control.shown[component]!);
        input.style.setProperty('--at', `${100 * at}%`);
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
    const field = makeField({
        label: `${control.program} ${name}, number`,
        typed: (text) => session.engine.typed(text, control.index),
        shown: () => short(control.shown[component]!, control.value[component]!),
        exact: () => String(control.value[component]!),
        apply: (value, entered) => {
            session.change(() => session.engine.set(control.index, component, value, entered));
            if (control.value[component] !== value) say(`${name} is ${control.shown[component]}: press Enter after a number to widen the range.`);
        },
        say,
    });
    const track = makeTrack(session, control, component, () => field.element.focus());
    const dot = makeDot(name, () => session.reset(control, component));
    const label = makeName(name, '');
    const menu = makeSliderMenu(session, control, component, label, time);
    const element = el('div', { class: 'row slider' }, dot.element, menu, track.element, field.element);
    const refresh = () => {
        label.title = `${name}: ${control.min} … ${control.max}\nscene's value: ${control.initialShown[component]}`;
        element.classList.toggle('moves', control.periods[component]! > 0);
        dot.show(control.value[component] !== control.initial[component]);
        track.refresh();
        field.refresh();
    };
    refresh();
    return { element, refresh };
}
