// The files as tabs: arrow keys, Home and End move between them.
import { button, el } from '../dom.ts';
import { shortNames } from './names.ts';

export interface Tab {
    name: string;
    edited: boolean;
    errors: number;
    warnings: number;
}

export interface Tabs {
    element: HTMLElement;
    show(tabs: readonly Tab[], chosen: string): void;
}

function label(short: string, { name, edited, errors, warnings }: Tab): string {
    const facts = [edited ? 'edited' : '', errors > 0 ? `errors: ${errors}` : '', warnings > 0 ? `warnings: ${warnings}` : ''];
    return [short === name ? name : `${short}, ${name}`, ...facts.filter((fact) => fact !== '')].join(', ');
}

function fill(button: HTMLElement, short: string, tab: Tab, chosen: boolean): void {
    button.textContent = short;
    // Marks are drawn by the style sheet: the label says them in words.
    button.dataset.edited = String(tab.edited);
    button.dataset.count = tab.errors + tab.warnings > 0 ? `${tab.errors || tab.warnings}` : '';
    button.dataset.worst = tab.errors > 0 ? 'error' : 'warning';
    button.title = tab.name;
    button.setAttribute('aria-label', label(short, tab));
    button.setAttribute('aria-selected', String(chosen));
    button.tabIndex = chosen ? 0 : -1;
}

export function makeTabs(panel: HTMLElement, choose: (name: string) => void): Tabs {
    const element = el('div', { class: 'editor-tabs', role: 'tablist', 'aria-label': 'Files' });
    let names: string[] = [];
    let before = '';

    const make = (name: string) => button('', () => choose(name), { role: 'tab', 'aria-controls': panel.id });

    element.addEventListener('keydown', (event) => {
        const at = [...element.children].indexOf(document.activeElement as Element);
        const last = names.length - 1;
        const steps: Record<string, number> = {
            ArrowRight: at === last ? 0 : at + 1,
            ArrowLeft: at <= 0 ? last : at - 1,
            Home: 0,
            End: last,
        };
        const next = steps[event.key];
        if (at < 0 || next === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        choose(names[next]);
        (element.children[next] as HTMLElement).focus();
    });

    const show = (tabs: readonly Tab[], chosen: string) => {
        const wanted = tabs.map(({ name }) => name);
        if (wanted.join('\n') !== names.join('\n')) element.replaceChildren(...wanted.map(make));
        names = wanted;
        const short = shortNames(names);
        tabs.forEach((tab, i) => {
            fill(element.children[i] as HTMLElement, short.get(tab.name)!, tab, tab.name === chosen);
        });
        if (chosen === before) return;
        before = chosen;
        // scrollIntoView() would scroll the page, too.
        const button = element.children[names.indexOf(chosen)] as HTMLElement | undefined;
        if (button) element.scrollLeft = Math.max(0, button.offsetLeft - element.offsetLeft - element.clientWidth / 3);
    };
    return { element, show };
}
