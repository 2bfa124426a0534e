// Questions to the author.

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

export function makeButton(text: string, action: () => void): HTMLButtonElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = text;
    button.addEventListener('click', action);
    return button;
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
        for (const { text: label, value } of choices) buttons.append(makeButton(label, () => choose(value)));
        buttons.append(makeButton('Cancel', () => choose(undefined)));
        dialog.addEventListener('keydown', (event) => event.stopPropagation());
        dialog.addEventListener('close', () => {
            dialog.remove();
            resolve(chosen);
        });
        document.body.append(dialog);
        dialog.showModal();
    });
}
