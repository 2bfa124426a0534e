// The accuracy split: left of the divider the chosen rungs, right of it the references.
import type { Ladder } from '../engine.ts';
import { el } from '../dom.ts';

export interface Divider {
    // Over the picture.
    element: HTMLElement;
    // The check box that shows it.
    toggle: HTMLElement;
    set(split: number | undefined): void;
    refresh(ladders: Ladder[]): void;
}

// "BEND: single" and "bounces", of the ladders whose rungs differ.
export function sidesOf(ladders: readonly Ladder[]): { left: string; right: string } {
    const differ = ladders.filter(({ chosen, reference }) => chosen !== reference);
    const name = ({ name, rungs, chosen }: Ladder) => `${name}: ${rungs[chosen]}`;
    if (differ.length === 0) return { left: 'reference', right: 'reference' };
    return { left: differ.map(name).join(', '), right: differ.map(({ rungs, reference }) => rungs[reference]).join(', ') };
}

export function makeDivider(changed: (split: number | undefined) => void): Divider {
    const left = el('span', { class: 'side left' });
    const right = el('span', { class: 'side right' });
    const handle = el('div', { class: 'handle', role: 'slider', tabindex: 0, 'aria-label': 'Divider between the chosen rungs and the reference', 'aria-valuemin': 0, 'aria-valuemax': 100 });
    const element = el('div', { class: 'divider', hidden: true }, left, right, handle);
    const box = el('input', { type: 'checkbox' });
    const toggle = el('label', { class: 'check split' }, box, 'Compare with the reference');
    let at = 0.5;

    const show = (split: number | undefined) => {
        element.hidden = split === undefined;
        box.checked = split !== undefined;
        if (split === undefined) return;
        at = Math.min(Math.max(split, 0), 1);
        element.style.setProperty('--split', `${100 * at}%`);
        handle.setAttribute('aria-valuenow', String(Math.round(100 * at)));
        handle.setAttribute('aria-valuetext', `${Math.round(100 * at)} %, left ${left.textContent}, right ${right.textContent}`);
    };
    const set = (split: number | undefined) => {
        show(split);
        changed(split === undefined ? undefined : at);
    };
    box.addEventListener('change', () => set(box.checked ? at : undefined));
    handle.addEventListener('pointerdown', (event) => {
        event.stopPropagation();
        handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener('pointermove', (event) => {
        if (!handle.hasPointerCapture(event.pointerId)) return;
        const area = element.getBoundingClientRect();
        set((event.clientX - area.left) / Math.max(area.width, 1));
    });
    handle.addEventListener('keydown', (event) => {
        const unit = event.shiftKey ? 0.001 : 0.01;
        const ways: Record<string, number> = { ArrowLeft: -unit, ArrowDown: -unit, ArrowRight: unit, ArrowUp: unit, PageUp: 0.1, PageDown: -0.1, Home: -1, End: 1 };
        const way = ways[event.key];
        if (way === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        set(at + way);
    });
    const refresh = (ladders: Ladder[]) => {
        const sides = sidesOf(ladders);
        left.textContent = sides.left;
        right.textContent = sides.right;
        if (ladders.length === 0 && !element.hidden) set(undefined);
        else show(element.hidden ? undefined : at);
    };
    return { element, toggle, set, refresh };
}
