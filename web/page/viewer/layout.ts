// The page's parts, without what they do.
import { el, stored } from '../dom.ts';

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

// What divides picture and text: by the pointer, or by the arrow keys. Its place stays for other visits.
function makeGrip(app: HTMLElement): HTMLElement {
    const key = 'snell-share';
    const beside = matchMedia('(min-width: 100rem)');
    const grip = el('div', { class: 'grip', role: 'separator', tabindex: 0, 'aria-label': 'Divider between picture and text', 'aria-valuemin': 10, 'aria-valuenow': 42, 'aria-valuemax': 90 });
    const set = (share: number) => {
        const fits = Math.round(Math.min(Math.max(share, 10), 90) * 10) / 10;
        app.style.setProperty('--share', beside.matches ? `${fits * 0.8}%` : `${fits}%`);
        grip.setAttribute('aria-valuenow', String(fits));
        return fits;
    };
    const keep = (share: number) => stored((store) => store.setItem(key, String(set(share))));
    const turn = () => void (grip.ariaOrientation = beside.matches ? 'vertical' : 'horizontal');
    const now = () => Number(grip.getAttribute('aria-valuenow') ?? 42);
    grip.addEventListener('pointerdown', (event) => grip.setPointerCapture(event.pointerId));
    grip.addEventListener('pointermove', (event) => {
        if (!grip.hasPointerCapture(event.pointerId)) return;
        const { left, top, width, height } = app.getBoundingClientRect();
        keep(beside.matches ? (125 * (event.clientX - left)) / width : (100 * (event.clientY - top)) / height);
    });
    grip.addEventListener('keydown', ({ key }) => {
        const step = { ArrowUp: -2, ArrowLeft: -2, ArrowDown: 2, ArrowRight: 2 }[key];
        if (step) keep(now() + step);
    });
    beside.addEventListener('change', turn);
    turn();
    const before = Number(stored((store) => store.getItem(key)));
    if (before > 0) set(before);
    return grip;
}

// Pages of a gallery know the others (src/app/page/gallery.cpp).
declare global {
    // eslint-disable-next-line no-var
    var snellGallery: [page: string, title: string][] | undefined;
}

function galleryLinks(): HTMLElement[] {
    const pages = globalThis.snellGallery ?? [];
    const own = decodeURIComponent(location.pathname.replace(/^.*\//, ''));
    const at = pages.findIndex(([page]) => page === own);
    if (at < 0) return [];
    const link = (text: string, to: [string, string] | undefined) => (to ? [el('a', { href: encodeURIComponent(to[0]), title: to[1] }, text)] : []);
    return [el('nav', { class: 'gallery', 'aria-label': 'Gallery' }, el('a', { href: 'index.html' }, 'All scenes'), ...link('‹ Previous', pages[at - 1]), ...link('Next ›', pages[at + 1]))];
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
    panels.text.append(makeGrip(app));
    const side = el('section', { class: 'panels', 'aria-label': 'Scene' }, ...galleryLinks(), title, tools, tabs.element, panels.controls);
    app.append(stage, side, panels.text);
    return { app, canvas, picture, stage, cover, status, message, title, link, tools, ...panels, chooseTab: tabs.choose };
}
