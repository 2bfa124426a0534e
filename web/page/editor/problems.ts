// Problems from two sources, and their list.
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

function row(problem: Problem, goTo: (place: Place) => void): HTMLElement {
    const item = document.createElement('li');
    const { at } = problem;
    const button = document.createElement(at ? 'button' : 'span');
    button.className = `editor-problem ${problem.severity}`;
    const place = document.createElement('span');
    place.className = 'editor-place';
    place.textContent = `${at ? `${resolve('', at.file)}:${at.line}:${at.column}: ` : ''}${problem.severity}: `;
    button.append(place, problem.message);
    if (problem.help) {
        const help = document.createElement('span');
        help.className = 'editor-help';
        help.textContent = problem.help;
        button.append(help);
    }
    if (at) button.addEventListener('click', () => goTo(at));
    item.append(button);
    return item;
}

export function makeProblemList(goTo: (place: Place) => void): ProblemList {
    const element = document.createElement('section');
    element.className = 'editor-problems';
    element.setAttribute('aria-label', 'Problems of the text');
    const heading = document.createElement('p');
    heading.setAttribute('role', 'status');
    const list = document.createElement('ul');
    element.append(heading, list);
    let before: readonly Problem[] | undefined;
    const show = (problems: readonly Problem[]) => {
        if (problems === before) return;
        before = problems;
        const text = summary(problems);
        // The same text again would be announced again.
        if (heading.textContent !== text) heading.textContent = text;
        element.classList.toggle('none', problems.length === 0);
        const rows = problems.slice(0, shown).map((problem) => row(problem, goTo));
        if (problems.length > shown) {
            const rest = document.createElement('li');
            rest.textContent = `${problems.length - shown} more are not listed.`;
            rows.push(rest);
        }
        list.replaceChildren(...rows);
    };
    return { element, show };
}
