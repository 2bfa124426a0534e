// The panel: ladders, and the controls of each program.
import type { Control, Ladder } from '../engine.ts';
import { button, el } from '../dom.ts';
import type { Say } from './field.ts';
import { makeSliderRow, type Row } from './row.ts';
import { isChanged, type Session } from './session.ts';
import { makeCheckRow, makeColorRow } from './values.ts';

// The scene's, in seconds.
type Time = () => number;

// The filter appears above so many sliders.
const few = 12;

interface Group {
    element: HTMLElement;
    rows: { names: string; element: HTMLElement }[];
    refresh(): void;
}

function rowsOf(session: Session, control: Control, say: Say, time: Time): Row[] {
    if (control.widget === 'check_box') return [makeCheckRow(session, control)];
    if (control.widget === 'color') return [makeColorRow(session, control, say)];
    return control.value.map((_, i) => makeSliderRow(session, control, i, say, time));
}

function makeGroup(session: Session, program: string, controls: Control[], say: Say, time: Time): Group {
    const made = controls.flatMap((control) =>
        rowsOf(session, control, say, time).map((row) => ({ ...row, names: `${program} ${control.name}`.toLowerCase() })),
    );
    const reset = button('Reset', () => session.resetAll(program), { 'aria-label': `Reset ${program || 'program'}`, class: 'small' });
    const body = el('div', { class: 'rows' }, ...made.map(({ element }) => element));
    const details = el('details', { open: true }, el('summary', {}, program || 'Program'), body);
    const element = el('div', { class: 'group' }, details, reset);
    const refresh = () => {
        made.forEach((row) => row.refresh());
        reset.hidden = !controls.some(isChanged);
    };
    return { element, rows: made, refresh };
}

function makeFilter(groups: readonly Group[]): HTMLElement {
    const none = el('p', { class: 'quiet', hidden: true }, 'No name contains this text.');
    const input = el('input', { type: 'search', placeholder: 'Filter by name', 'aria-label': 'Filter sliders by name' });
    const apply = () => {
        const text = input.value.trim().toLowerCase();
        let any = false;
        for (const { element, rows } of groups) {
            for (const row of rows) row.element.hidden = !row.names.includes(text);
            element.hidden = rows.every((row) => row.element.hidden);
            any ||= !element.hidden;
        }
        none.hidden = any;
    };
    input.addEventListener('input', apply);
    input.addEventListener('keydown', (event) => {
        if (event.key !== 'Escape') return;
        input.value = '';
        apply();
    });
    return el('div', { class: 'filter' }, input, none);
}

function makeLadder(session: Session, ladder: Ladder): HTMLElement {
    const options = ladder.rungs.map((rung, i) => el('option', { value: i }, rung));
    const select = el('select', {}, ...options);
    select.value = String(ladder.chosen);
    select.addEventListener('change', () => session.choose(ladder, Number(select.value)));
    select.addEventListener('contextmenu', (event) => {
        event.preventDefault();
        session.choose(ladder, ladder.marked);
    });
    const dot = el('button', { type: 'button', class: 'dot', 'aria-label': `Reset ${ladder.name}`, title: `Reset ${ladder.name}` });
    dot.style.visibility = ladder.chosen === ladder.marked ? 'hidden' : 'visible';
    dot.addEventListener('click', () => session.choose(ladder, ladder.marked));
    return el('div', { class: 'row' }, dot, el('label', { class: 'ladder' }, el('span', { class: 'name' }, ladder.name), select));
}

export interface Panel {
    element: HTMLElement;
    // Other controls, or other ladders.
    rebuild(): void;
    refresh(): void;
}

export function makePanel(session: Session, split: HTMLElement, say: Say, time: Time): Panel {
    const ladders = el('div', { class: 'rows ladders' });
    const list = el('div', { class: 'list' });
    const element = el('div', { class: 'controls' }, ladders, list);
    let groups: Group[] = [];
    let built: readonly Control[] = [];
    let scene: string | undefined;

    const build = () => {
        const programs = [...new Set(session.controls.map(({ program }) => program))];
        groups = programs.map((program) => {
            const controls = session.controls.filter((control) => control.program === program);
            return makeGroup(session, program, controls, say, time);
        });
        const sliders = session.controls.filter(({ widget }) => widget === 'slider').flatMap(({ value }) => value);
        const filter = sliders.length > few ? [makeFilter(groups)] : [];
        const none = el('p', { class: 'quiet' }, 'This scene has no sliders.');
        list.replaceChildren(...filter, ...(groups.length > 0 ? groups.map((group) => group.element) : [none]));
    };
    // A drop-down that has the focus has it again afterwards.
    const buildLadders = () => {
        const at = [...ladders.querySelectorAll('select')].indexOf(document.activeElement as HTMLSelectElement);
        const made = session.ladders.map((ladder) => makeLadder(session, ladder));
        ladders.replaceChildren(...made, ...(made.length > 0 ? [split] : []));
        if (at >= 0) ladders.querySelectorAll('select')[at]?.focus();
    };
    const rebuild = () => {
        buildLadders();
        const same = session.controls.length === built.length && session.controls.every((control, i) => control === built[i]);
        if (same && session.shown?.scene === scene) return refresh();
        const focused = document.activeElement?.getAttribute('aria-label');
        const again = list.contains(document.activeElement) ? focused : undefined;
        // Another scene begins with all of its sliders.
        const old = session.shown?.scene === scene ? groups : [];
        const closed = new Set(old.filter((group) => !group.element.querySelector('details')?.open).map((group) => group.rows[0]?.names));
        built = session.controls;
        scene = session.shown?.scene;
        build();
        for (const group of groups) if (closed.has(group.rows[0]?.names)) group.element.querySelector('details')!.open = false;
        refresh();
        if (element.parentElement) element.parentElement.scrollTop = 0;
        if (again) [...list.querySelectorAll('input')].find((input) => input.getAttribute('aria-label') === again)?.focus();
    };
    const refresh = () => groups.forEach((group) => group.refresh());
    return { element, rebuild, refresh };
}
