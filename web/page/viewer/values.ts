// Rows of check boxes and colours.
import type { Control } from '../engine.ts';
import { el } from '../dom.ts';
import { makeField, type Say } from './field.ts';
import { tidyColor } from './numbers.ts';
import { makeDot, makeName, type Row } from './row.ts';
import { isChanged, type Session } from './session.ts';

export function makeCheckRow(session: Session, control: Control): Row {
    const box = el('input', { type: 'checkbox' });
    box.addEventListener('change', () => session.setAll(control, [box.checked ? 1 : 0]));
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

function byteOf(value: number): number {
    return Math.round(255 * Math.min(Math.max(value, 0), 1));
}

// "#rrggbb", as the browser's picker has it.
export function hexOf(value: readonly number[]): string {
    return `#${value.slice(0, 3).map((part) => byteOf(part).toString(16).padStart(2, '0')).join('')}`;
}

// Only components that were picked change: the others keep the precision that a picker lacks.
export function picked(hex: string, value: readonly number[]): number[] {
    const bytes = [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
    return value.map((part, i) => (i < 3 && bytes[i] !== byteOf(part) ? tidyColor(bytes[i]! / 255) : part));
}

export function makeColorRow(session: Session, control: Control, say: Say): Row {
    const swatch = el('input', { type: 'color', 'aria-label': `${control.program} ${control.name}` });
    let gesture = {};
    swatch.addEventListener('input', () => session.setAll(control, picked(swatch.value, control.value), gesture));
    swatch.addEventListener('change', () => {
        gesture = {};
        session.history.end();
    });
    const fields = control.value.map((_, i) =>
        makeField({
            label: `${control.program} ${control.name}, ${['red', 'green', 'blue', 'alpha'][i]}`,
            type: control.type,
            shown: () => String(Number(control.value[i]!.toPrecision(4))),
            exact: () => String(control.value[i]!),
            apply: (value) => void session.set(control, i, value),
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
