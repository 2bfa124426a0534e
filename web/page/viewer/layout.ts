// The page's parts, without what they do.
import { el } from './dom.ts';

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

function makeTabs(panels: Record<TabName, HTMLElement>, app: HTMLElement, chosen: (name: TabName) => void) {
    const names: TabName[] = ['controls', 'text'];
    const titles = { controls: 'Controls', text: 'Text' };
    const tabs = names.map((name) =>
        el('button', { type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}` }, titles[name]),
    );
    const choose = (name: TabName) => {
        app.dataset.tab = name;
        names.forEach((each, i) => {
            tabs[i]!.setAttribute('aria-selected', String(each === name));
            tabs[i]!.tabIndex = each === name ? 0 : -1;
            panels[each].hidden = each !== name;
        });
        chosen(name);
    };
    tabs.forEach((tab, i) => {
        tab.addEventListener('click', () => choose(names[i]!));
        tab.addEventListener('keydown', (event) => {
            if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
            event.preventDefault();
            choose(names[1 - i]!);
            tabs[1 - i]!.focus();
        });
    });
    return { element: el('div', { class: 'tabs', role: 'tablist', 'aria-label': 'Panel' }, ...tabs), choose };
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
        controls: el('div', { class: 'panel', role: 'tabpanel', id: 'panel-controls', 'aria-labelledby': 'tab-controls' }),
        text: el('div', { class: 'panel', role: 'tabpanel', id: 'panel-text', 'aria-labelledby': 'tab-text' }),
    };
    const app = el('main', { class: 'app' });
    const tabs = makeTabs(panels, app, chosen);
    const side = el('section', { class: 'panels', 'aria-label': 'Controls and text' }, title, tools, tabs.element, panels.controls, panels.text);
    app.append(stage, side);
    return { app, canvas, picture, stage, cover, status, message, title, link, tools, ...panels, chooseTab: tabs.choose };
}
