// The page's parts, without what they do.
import { el } from '../dom.ts';

export interface Layout {
    app: HTMLElement;
    canvas: HTMLCanvasElement;
    picture: HTMLElement;
    stage: HTMLElement;
    // Covers the picture: progress, a failure, or how to open a scene.
    cover: HTMLElement;
    status: HTMLElement;
    message: HTMLElement;
    title: HTMLElement;
    link: HTMLAnchorElement;
    tools: HTMLElement;
    controls: HTMLElement;
    text: HTMLElement;
    chooseTab(name: 'controls' | 'text'): void;
}

type TabName = 'controls' | 'text';

// As in style.css: there is room for one of the two only.
const narrow = '(max-width: 46rem), (max-aspect-ratio: 1/1)';

interface Tabs {
    element: HTMLElement;
    choose(name: TabName): void;
}

function makeButtons(choose: (name: TabName) => void, other: () => void): Record<TabName, HTMLButtonElement> {
    const make = (name: TabName, title: string) => {
        const tab = el('button', { type: 'button', id: `tab-${name}`, 'aria-controls': `panel-${name}` }, title);
        tab.addEventListener('click', () => choose(name));
        tab.addEventListener('keydown', (event) => {
            if (tab.role !== 'tab' || (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight')) return;
            event.preventDefault();
            other();
        });
        return tab;
    };
    return { controls: make('controls', 'Controls'), text: make('text', 'Text') };
}

// Narrow pages have tabs for controls and text. On others the controls stay, and a button shows the text below the picture.
function makeTabs(panels: Record<TabName, HTMLElement>, app: HTMLElement, chosen: (name: TabName) => void): Tabs {
    const media = matchMedia(narrow);
    let now: TabName = 'controls';
    const element = el('div', { class: 'tabs', 'aria-label': 'Panel' });
    const press = (name: TabName) => choose(!media.matches && name === 'text' && now === 'text' ? 'controls' : name);
    const other = () => {
        choose(now === 'text' ? 'controls' : 'text');
        buttons[now].focus();
    };
    const buttons = makeButtons(press, other);
    element.append(buttons.controls, buttons.text);
    const arrange = () => {
        element.role = media.matches ? 'tablist' : 'group';
        for (const name of ['controls', 'text'] as const) {
            const tab = buttons[name];
            const open = name === now;
            tab.role = media.matches ? 'tab' : null;
            tab.ariaSelected = media.matches ? String(open) : null;
            tab.ariaExpanded = media.matches ? null : String(open);
            tab.tabIndex = open || !media.matches ? 0 : -1;
            panels[name].role = media.matches ? 'tabpanel' : 'region';
            panels[name].hidden = !open && (media.matches || name === 'text');
        }
        buttons.controls.hidden = !media.matches;
    };
    const choose = (name: TabName) => {
        now = app.dataset.tab = name;
        arrange();
        chosen(name);
    };
    media.addEventListener('change', arrange);
    return { element, choose };
}

export function makeLayout(chosen: (name: TabName) => void): Layout {
    const canvas = el('canvas', { tabindex: 0, role: 'application', 'aria-label': 'Picture' });
    const cover = el('div', { class: 'cover' });
    const message = el('p', { class: 'message', role: 'status', 'aria-live': 'polite' });
    const picture = el('div', { class: 'picture' }, canvas, cover, message);
    const status = el('span', { class: 'quiet' });
    const link = el('a', { hidden: true, rel: 'noopener noreferrer', target: '_blank' }, 'Text of this scene');
    const stage = el('section', { class: 'stage', 'aria-label': 'Picture' }, picture, el('p', { class: 'status' }, status, link));
    const title = el('h1', {}, document.title);
    const tools = el('div', { class: 'tools', role: 'toolbar', 'aria-label': 'Tools' });
    const panels = {
        controls: el('div', { class: 'panel', id: 'panel-controls', 'aria-labelledby': 'tab-controls' }),
        text: el('div', { class: 'panel text', id: 'panel-text', 'aria-labelledby': 'tab-text' }),
    };
    const app = el('main', { class: 'app' });
    const tabs = makeTabs(panels, app, chosen);
    const side = el('section', { class: 'panels', 'aria-label': 'Scene' }, title, tools, tabs.element, panels.controls);
    app.append(stage, side, panels.text);
    return { app, canvas, picture, stage, cover, status, message, title, link, tools, ...panels, chooseTab: tabs.choose };
}
