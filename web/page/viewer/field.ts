// A number that a click edits.
import { el } from '../dom.ts';

// Shows a message for a while; "" ends the one about the same thing.
export type Say = (message: string, about?: unknown) => void;

export interface FieldOptions {
    label: string;
    // NaN if the text is not a number, infinity if it does not fit.
    typed(text: string): number;
    // As it is shown, and as it is typed.
    shown(): string;
    exact(): string;
    // `entered`: by Enter, which may widen the range.
    apply(value: number, entered: boolean): void;
    say(message: string): void;
}

export interface Field {
    element: HTMLInputElement;
    refresh(): void;
}

// Enter and leaving apply the text; Escape restores the value.
export function makeField(options: FieldOptions): Field {
    const { label, typed, shown, exact, apply, say } = options;
    const element = el('input', { type: 'text', inputmode: 'decimal', class: 'number', 'aria-label': label, autocomplete: 'off', spellcheck: 'false' });
    let before: string | undefined;

    const refresh = () => {
        if (before !== undefined) return;
        element.value = shown();
        element.removeAttribute('aria-invalid');
    };
    const begin = () => {
        element.value = before = exact();
        element.select();
    };
    // Returns false if the text is not a number. What is taken leaves no older message about the field.
    const finish = (entered: boolean): boolean => {
        if (before === undefined) return true;
        // Leaving what was not edited says nothing new.
        if (element.value === before && !entered) return true;
        const value = typed(element.value);
        if (!Number.isFinite(value)) {
            say(`'${element.value}' is not a number${Number.isNaN(value) ? '' : ' that fits'}.`);
            return false;
        }
        say('');
        if (element.value !== before) apply(value, entered);
        return true;
    };
    element.addEventListener('focus', begin);
    // Without this, the click that focuses would undo the selection.
    element.addEventListener('pointerdown', (event) => {
        if (document.activeElement === element) return;
        event.preventDefault();
        element.focus();
    });
    element.addEventListener('blur', () => {
        finish(false);
        before = undefined;
        refresh();
    });
    element.addEventListener('input', () => element.removeAttribute('aria-invalid'));
    element.addEventListener('keydown', (event) => {
        if (event.key === 'Enter') {
            if (finish(true)) begin();
            else element.setAttribute('aria-invalid', 'true');
        } else if (event.key === 'Escape' && before !== undefined) {
            event.stopPropagation();
            element.removeAttribute('aria-invalid');
            begin();
            element.value = before = exact();
        } else return;
        event.preventDefault();
    });
    refresh();
    return { element, refresh };
}
