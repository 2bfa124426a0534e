// Questions to the author.
import { button } from '../dom.ts';

function shell(title: string, text: string): { dialog: HTMLDialogElement; buttons: HTMLElement } {
    const dialog = document.createElement('dialog');
    dialog.className = 'editor-dialog';
    dialog.setAttribute('aria-label', title);
    const heading = document.createElement('h2');
    heading.textContent = title;
    const body = document.createElement('p');
    body.textContent = text;
    const buttons = document.createElement('div');
    buttons.className = 'editor-dialog-buttons';
    dialog.append(heading, body, buttons);
    return { dialog, buttons };
}

// Resolves with the choice, or undefined after Escape or Cancel. Keys do not reach the page below.
export function ask<T>(title: string, text: string, choices: readonly { text: string; value: T }[]): Promise<T | undefined> {
    return new Promise((resolve) => {
        const { dialog, buttons } = shell(title, text);
        let chosen: T | undefined;
        const choose = (value: T | undefined) => {
            chosen = value;
            dialog.close();
        };
        for (const { text: label, value } of choices) buttons.append(button(label, () => choose(value)));
        buttons.append(button('Cancel', () => choose(undefined)));
        dialog.addEventListener('keydown', (event) => event.stopPropagation());
        dialog.addEventListener('close', () => {
            dialog.remove();
            resolve(chosen);
        });
        document.body.append(dialog);
        dialog.showModal();
    });
}
