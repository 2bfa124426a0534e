// Dialogs, and questions to the author.
import { button, el } from './dom.ts';

export function makeDialog(title: string, ...children: Node[]): HTMLDialogElement {
    const dialog = el('dialog', { 'aria-label': title, tabindex: -1 }, el('h2', {}, title), ...children);
    // Keys do not reach the page below.
    dialog.addEventListener('keydown', (event) => event.stopPropagation());
    dialog.addEventListener('click', (event) => event.target === dialog && dialog.close());
    return dialog;
}

// The dialog itself has the focus at first, so that it begins at its top.
export function showFromTop(dialog: HTMLDialogElement): void {
    dialog.showModal();
    dialog.focus();
}

export interface Choice<T> {
    text: string;
    value: T;
    // Above the text.
    picture?: HTMLElement;
}

// Resolves with the choice, or undefined after Escape or Cancel. With a signal, which takes the question back, the page asks
// by itself: a key that was meant for something else must not answer, so no answer has the focus.
export function ask<T>(title: string, text: string, choices: readonly Choice<T>[], signal?: AbortSignal): Promise<T | undefined> {
    return new Promise((resolve) => {
        let chosen: T | undefined;
        const choose = (value: T | undefined) => {
            chosen = value;
            dialog.close();
        };
        const pictured = choices.some(({ picture }) => picture);
        const made = choices.map(({ text, value, picture }) => {
            const each = button(text, () => choose(value));
            if (picture) each.append(picture);
            return each;
        });
        const list = el('div', { class: `editor-dialog-buttons${pictured ? ' pictured' : ''}` }, ...made, button('Cancel', () => choose(undefined)));
        const dialog = makeDialog(title, el('p', {}, text), list);
        dialog.className = 'editor-dialog';
        dialog.addEventListener('close', () => {
            dialog.remove();
            resolve(chosen);
        });
        signal?.addEventListener('abort', () => choose(undefined));
        document.body.append(dialog);
        if (signal) showFromTop(dialog);
        else dialog.showModal();
    });
}
