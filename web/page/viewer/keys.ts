// Keys of the whole page.
import { takesText } from '../dom.ts';

export interface Keys {
    undo(): void;
    redo(): void;
    resetView(): void;
    fullScreen(): void;
    time(): void;
    help(): void;
    // False: there is nothing to save.
    save(): boolean;
}

// Buttons, check boxes and the like use the space bar for themselves.
function usesSpace(target: EventTarget | null): boolean {
    return target instanceof HTMLElement && target.closest('button, input:not([type=range]), select, summary, a') !== null;
}

export function listenForKeys(keys: Keys): void {
    document.addEventListener('keydown', (event) => {
        if (takesText(event.target) || document.querySelector('dialog[open]')) return;
        const command = event.ctrlKey || event.metaKey;
        const key = event.key.toLowerCase();
        if (command && !event.altKey) {
            if (key === 'z') event.shiftKey ? keys.redo() : keys.undo();
            else if (key === 'y') keys.redo();
            else if (key !== 's' || !keys.save()) return;
        } else if (command || event.altKey) {
            return;
        } else if (key === 'r') keys.resetView();
        else if (key === 'f') keys.fullScreen();
        else if (key === '?') keys.help();
        else if (key === ' ' && !usesSpace(event.target)) keys.time();
        else return;
        event.preventDefault();
    });
}
