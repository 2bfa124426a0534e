// Errors and warnings below the picture; each leads to its place in the text.
import { problemItem, summary } from '../editor/problems.ts';
import type { Place, Problem } from '../engine.ts';
import { el } from '../dom.ts';

export interface Problems {
    element: HTMLElement;
    show(problems: Problem[]): void;
}

const most = 100;

export function makeProblems(goTo: (place: Place) => void): Problems {
    const title = el('summary', {});
    const list = el('ul', {});
    const details = el('details', {}, title, list);
    const element = el('section', { class: 'problems', 'aria-label': 'Problems', hidden: true }, details);
    const show = (problems: Problem[]) => {
        const errors = problems.some(({ severity }) => severity === 'error');
        element.hidden = problems.length === 0;
        title.textContent = summary(problems);
        title.className = errors ? 'error' : '';
        // Errors are shown, warnings on request.
        details.open = errors;
        const sorted = [...problems].sort((a, b) => Number(b.severity === 'error') - Number(a.severity === 'error'));
        list.replaceChildren(...sorted.slice(0, most).map((problem) => problemItem(problem, goTo)));
        if (problems.length > most) list.append(el('li', { class: 'quiet' }, `${problems.length - most} more`));
    };
    return { element, show };
}
