// A button that shows more buttons and fields, until something else is clicked.
import { el } from '../dom.ts';

export interface Menu {
    element: HTMLDetailsElement;
    open(): void;
    close(): void;
}

// `fill` makes what the menu shows, whenever it is opened.
export function makeMenu(title: Node | string, attributes: Record<string, string>, fill: () => HTMLElement[]): Menu {
    const items = el('div', { class: 'items' });
    const summary = el('summary', {}, title);
    const element = el('details', attributes, summary, items);
    const open = () => {
        if (!element.open) items.replaceChildren(...fill());
        element.open = true;
    };
    const close = () => void (element.open = false);
    const outside = (event: Event) => element.contains(event.target as Node) || close();
    summary.addEventListener('click', (event) => {
        event.preventDefault();
        if (element.open) close();
        else open();
    });
    element.addEventListener('toggle', () => {
        if (element.open) document.addEventListener('pointerdown', outside);
        else document.removeEventListener('pointerdown', outside);
    });
    element.addEventListener('keydown', (event) => {
        if (event.key !== 'Escape' || !element.open) return;
        event.stopPropagation();
        close();
        summary.focus();
    });
    return { element, open, close };
}
