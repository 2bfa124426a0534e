// Problems from two sources, and their list.
import { el } from '../dom.ts';
import type { Place, Problem } from '../engine.ts';
import { resolve } from './names.ts';

// What tells problems apart. Not the severity: what is an error without graphics may be a note once it is known that
// nothing reads the file.
function key({ code, message, at }: Problem): string {
    return JSON.stringify([code, message, at?.file, at?.line, at?.column]);
}

// The same where their places have moved.
export function kind({ code, message, at }: Problem): string {
    return JSON.stringify([code, message, at?.file]);
}

const order = { error: 0, warning: 1, note: 2 };

// What the engine says, which is more exact, and what only the worker says; errors first.
export function merged(full: readonly Problem[], quick: readonly Problem[]): Problem[] {
    const known = new Set(full.map(key));
    const all = [...full, ...quick.filter((problem) => !known.has(key(problem)))];
    return all.sort((a, b) => order[a.severity] - order[b.severity]);
}

function plural(count: number, word: string): string[] {
    return count === 0 ? [] : [`${count} ${word}${count === 1 ? '' : 's'}`];
}

export function summary(problems: readonly Problem[]): string {
    const count = (severity: Problem['severity']) => problems.filter((problem) => problem.severity === severity).length;
    const parts = [...plural(count('error'), 'error'), ...plural(count('warning'), 'warning'), ...plural(count('note'), 'note')];
    return parts.length === 0 ? 'No problems' : parts.join(', ');
}

export interface ProblemList {
    element: HTMLElement;
    show(problems: readonly Problem[]): void;
}

const shown = 200;

// A problem as it is listed, here and below the picture.
export function problemItem(problem: Problem, goTo: (place: Place) => void): HTMLElement {
    const { at, severity, message, help } = problem;
    const place = el('strong', { class: severity }, `${at ? `${resolve('', at.file)}:${at.line}:${at.column}: ` : ''}${severity}: `);
    const hint = help === '' ? [] : [el('span', { class: 'help' }, help)];
    const item = el(at ? 'button' : 'div', { type: at && 'button', class: `problem ${severity}` }, place, message, ...hint);
    if (at) item.addEventListener('click', () => goTo(at));
    return el('li', {}, item);
}

export function makeProblemList(goTo: (place: Place) => void): ProblemList {
    const heading = el('p', { role: 'status' });
    const list = el('ul', {});
    const element = el('section', { class: 'editor-problems', 'aria-label': 'Problems of the text' }, heading, list);
    let before: readonly Problem[] | undefined;
    const show = (problems: readonly Problem[]) => {
        if (problems === before) return;
        before = problems;
        const text = summary(problems);
        // The same text again would be announced again.
        if (heading.textContent !== text) heading.textContent = text;
        list.replaceChildren(...problems.slice(0, shown).map((problem) => problemItem(problem, goTo)));
        if (problems.length > shown) list.append(el('li', {}, `${problems.length - shown} more are not listed.`));
    };
    return { element, show };
}
