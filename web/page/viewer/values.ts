// Rows of check boxes and colours.
import type { Control } from '../engine.ts';
import { el } from '../dom.ts';
import { makeField, type Say } from './field.ts';
import { makeDot, makeName, type Row } from './row.ts';
import { isChanged, type Session } from './session.ts';

export function makeCheckRow(session: Session, control: Control): Row {
    const box = el('input', { type: 'checkbox' });
    box.addEventListener('change', () => session.change(() => session.engine.set(control.index, 0, Number(box.checked))));
    const dot = makeDot(control.name, () => session.reset(control));
    const label = el('label', { class: 'check' }, box, makeName(control.name, control.key));
    label.addEventListener('contextmenu', (event) => {
        event.preventDefault();
        session.reset(control);
    });
    const refresh = () => {
        box.checked = control.value[0] !== 0;
        dot.show(isChanged(control));
    };
    refresh();
    return { element: el('div', { class: 'row' }, dot.element, label), refresh };
}

// "#rrggbb", as the browser's picker has it.
function hexOf(value: readonly number[]): string {
    const byte = (part: number) => Math.round(255 * Math.min(Math.max(part, 0), 1));
    return `#${value.slice(0, 3).map((part) => byte(part).toString(16).padStart(2, '0')).join('')}`;
}

export function makeColorRow(session: Session, control: Control, say: Say): Row {
    const swatch = el('input', { type: 'color', 'aria-label': `${control.program} ${control.name}` });
    let gesture = {};
    const pick = (hex: string) =>
        [1, 3, 5].forEach((at, i) => session.engine.pick(control.index, i, parseInt(hex.slice(at, at + 2), 16)));
    swatch.addEventListener('input', () => session.change(() => pick(swatch.value), gesture));
    swatch.addEventListener('change', () => {
        gesture = {};
        session.end();
    });
    const fields = control.value.map((_, i) =>
        makeField({
            label: `${control.program} ${control.name}, ${['red', 'green', 'blue', 'alpha'][i]}`,
            typed: (text) => session.engine.typed(text, control.index),
            shown: () => String(Number(control.value[i]!.toPrecision(4))),
            exact: () => String(control.value[i]!),
            apply: (value) => session.change(() => session.engine.set(control.index, i, value)),
            say: (message) => say(message, `${control.key}.${i}`),
        }),
    );
    const dot = makeDot(control.name, () => session.reset(control));
    const numbers = el('span', { class: 'numbers' }, swatch, ...fields.map(({ element }) => element));
    const element = el('div', { class: 'row color' }, dot.element, makeName(control.name, control.key), numbers);
    const refresh = () => {
        swatch.value = hexOf(control.value);
        dot.show(isChanged(control));
        fields.forEach((field) => field.refresh());
    };
    refresh();
    return { element, refresh };
}
