// What a slider's name offers: reset, a logarithmic scale, and a motion of its own.
import type { Control } from '../engine.ts';
import { button, el } from '../dom.ts';
import { makeField } from './field.ts';
import { makeMenu } from './menu.ts';
import { usualPeriod } from './motion.ts';
import { nameOf, type Session } from './session.ts';
import { canBeLogarithmic } from './steps.ts';

function check(text: string, checked: boolean, change: (on: boolean) => void, disabled = false): HTMLElement {
    const box = el('input', { type: 'checkbox', disabled });
    box.checked = checked;
    box.addEventListener('change', () => change(box.checked));
    return el('label', { class: 'check' }, box, text);
}

// `time` is that of the scene, in seconds.
export function makeSliderMenu(session: Session, control: Control, component: number, label: HTMLElement, time: () => number): HTMLElement {
    const motion = () => session.motionOf(control, component);
    const fill = () => {
        const period = makeField({
            label: 'Seconds of one period',
            type: 'float',
            shown: () => String(Number((motion()?.period ?? usualPeriod).toPrecision(4))),
            exact: () => String(motion()?.period ?? usualPeriod),
            apply: (seconds) => {
                if (!motion()) session.animate(control, component, time());
                session.slow(motion()!, seconds, time());
            },
            say: () => undefined,
        });
        const scale = (on: boolean) => {
            if (on) session.logarithmic.add(control.key);
            else session.logarithmic.delete(control.key);
            session.rescaled();
        };
        const animate = (on: boolean) => (on ? session.animate(control, component, time()) : session.stop(control.key, component));
        const reset = button('Reset', () => {
            session.reset(control, component);
            menu.close();
        });
        return [
            reset,
            check('Logarithmic', session.logarithmic.has(control.key), scale, !canBeLogarithmic(control)),
            check('Animate', motion() !== undefined, animate),
            el('label', { class: 'field' }, 'Period, s', period.element),
        ];
    };
    const menu = makeMenu(label, { class: 'options', 'aria-label': `Options of ${nameOf(control, component)}` }, fill);
    menu.element.addEventListener('contextmenu', (event) => {
        event.preventDefault();
        menu.open();
    });
    return menu.element;
}
