// What a slider's name offers: reset, a logarithmic scale, and a motion of its own.
import type { Control } from '../engine.ts';
import { button, el } from '../dom.ts';
import { makeField } from './field.ts';
import { makeMenu } from './menu.ts';
import { nameOf, type Session } from './session.ts';

function check(text: string, checked: boolean, change: (on: boolean) => void, disabled = false): HTMLElement {
    const box = el('input', { type: 'checkbox', disabled });
    box.checked = checked;
    box.addEventListener('change', () => change(box.checked));
    return el('label', { class: 'check' }, box, text);
}

// In seconds.
const usualPeriod = 4;

// `time` is that of the scene, in seconds.
export function makeSliderMenu(session: Session, control: Control, component: number, label: HTMLElement, time: () => number): HTMLElement {
    const { engine } = session;
    const period = () => control.periods[component]!;
    const animate = (seconds: number) => session.change(() => engine.animate(control.index, component, seconds, time()));
    const fill = () => {
        const field = makeField({
            label: 'Seconds of one period',
            typed: (text) => engine.typed(text),
            shown: () => String(Number((period() || usualPeriod).toPrecision(4))),
            exact: () => String(period() || usualPeriod),
            apply: (seconds) => animate(Math.max(seconds, 0.1)),
            say: () => undefined,
        });
        const scale = (on: boolean) => session.change(() => engine.scale(control.index, on));
        const reset = button('Reset', () => {
            session.reset(control, component);
            menu.close();
        });
        return [
            reset,
            check('Logarithmic', control.logarithmic, scale, !control.canBeLogarithmic),
            check('Animate', period() > 0, (on) => animate(on ? usualPeriod : 0)),
            el('label', { class: 'field' }, 'Period, s', field.element),
        ];
    };
    const menu = makeMenu(label, { class: 'options', 'aria-label': `Options of ${nameOf(control, component)}` }, fill);
    menu.element.addEventListener('contextmenu', (event) => {
        event.preventDefault();
        menu.open();
    });
    return menu.element;
}
