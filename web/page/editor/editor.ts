// The editor: the scene's files as tabs, their text and problems, and ways to open and to download scenes.
import { redo, undo } from '@codemirror/commands';
import { openSearchPanel } from '@codemirror/search';
import { EditorView } from '@codemirror/view';
import { makeDialog } from '../dialog.ts';
import { button, el } from '../dom.ts';
import { bytesOf } from './documents.ts';
import { Drafts } from './drafts.ts';
import type { Editor, EditorHost } from './host.ts';
import { Living } from './living.ts';
import { makeOpening } from './opening.ts';
import { saveBytes, saveZip } from './pack.ts';
import { makeProblemList } from './problems.ts';
import { Session } from './session.ts';
import { makeTabs } from './tabs.ts';

const help =
    'Ctrl Space completes, Ctrl F searches, F8 goes to the next problem, Ctrl Z undoes, Ctrl S saves or downloads. To leave the text by keyboard, press Esc and then Tab.';

// The text field is in a shadow tree: there, CodeMirror's styles are constructed style sheets, which the page's
// Content-Security-Policy allows.
function makeCode(): { panel: HTMLElement; view: EditorView } {
    const panel = el('div', { class: 'editor-code', id: 'editor-code', role: 'tabpanel', 'aria-label': 'Text' });
    const root = panel.attachShadow({ mode: 'open' });
    const view = new EditorView({ root });
    root.append(view.dom);
    // Keys that are typed are none of the page's shortcuts.
    for (const type of ['keydown', 'keypress', 'keyup'])
        panel.addEventListener(type, (event) => /^F\d+$/.test((event as KeyboardEvent).key) || event.stopPropagation());
    return { panel, view };
}

// The list of problems grows below the text: the line that is being written stays in sight.
function keepCaret(panel: HTMLElement, view: EditorView): void {
    let before = 0;
    const observer = new ResizeObserver(() => {
        const { main } = view.state.selection;
        const { top, bottom, height } = panel.getBoundingClientRect();
        const caret = view.hasFocus ? view.coordsAtPos(main.head) : null;
        if (caret && caret.bottom > bottom && caret.top < top + before)
            view.dispatch({ effects: EditorView.scrollIntoView(main.head) });
        before = height;
    });
    observer.observe(panel);
}

function downloads(host: EditorHost, session: Session) {
    // Edits of a folder's texts are kept when they are in the folder.
    const kept = (names: Iterable<string>) => host.folder || session.kept(names);
    const all = () => {
        const files = session.files();
        saveZip(host.scene, files);
        kept(files.keys());
    };
    const one = () => {
        const shown = session.current;
        if (!shown) return;
        saveBytes(shown.name, bytesOf(shown));
        kept([shown.name]);
    };
    return { all, one };
}

export function makeEditor(host: EditorHost): Editor {
    const { panel, view } = makeCode();
    keepCaret(panel, view);
    const goTo: Editor['goTo'] = (place) => {
        if (!session.goTo(place)) host.say(`'${place.file}' is not one of the scene's texts.`);
    };
    const tabs = makeTabs(panel, (name) => session.choose(name));
    const list = makeProblemList(goTo);
    const session = new Session(host, view, () => {
        tabs.show(session.tabs(), session.current?.name ?? '');
        list.show(session.problems);
    }, () => drafts.changed());
    const drafts = new Drafts(host, session);
    const living = new Living(host, session);
    const save = downloads(host, session);
    const opening = makeOpening({
        host,
        problems: () => session.problems,
        edited: () => session.edited(),
        download: save.all,
        save: () => living.save(),
        add: (files) => session.add(files),
    });
    const dialog = makeDialog('Open a scene');
    dialog.className = 'editor-dialog';
    const open = () => {
        // The same element is on the page while there is no scene.
        dialog.replaceChildren(opening.welcome, button('Close', () => dialog.close()));
        dialog.showModal();
    };
    const bar = el(
        'div',
        { class: 'editor-buttons' },
        button('Open…', open),
        button('Download .zip', save.all),
        button('Download this file', save.one),
        button('Undo', () => undo(view)),
        button('Redo', () => redo(view)),
        button('Find', () => openSearchPanel(view)),
    );
    const hint = el('details', { class: 'editor-fine-print' }, el('summary', {}, 'Keys'), help);
    const head = el('div', { class: 'editor-head' }, tabs.element, bar);
    const element = el('section', { class: 'editor', 'aria-label': 'Editor' }, head, panel, list.element, hint, dialog);
    // Captured, because keys do not leave the text field.
    const saveKey = (event: KeyboardEvent) => {
        if (!(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey || event.key !== 's') return;
        event.preventDefault();
        if (host.folder) void living.save();
        else save.all();
    };
    element.addEventListener('keydown', saveKey, { capture: true });
    element.addEventListener('focusin', () => session.warm(), { once: true });
    window.addEventListener('beforeunload', (event) => session.edited().length > 0 && !drafts.safe && event.preventDefault());

    return {
        element,
        welcome: opening.welcome,
        show: (problems) => session.show(problems),
        goTo,
        opened: () => {
            dialog.close();
            session.open();
            living.opened();
            void drafts.opened();
        },
        download: save.all,
        save: () => void living.save(),
        scenes: opening.scenes,
        edited: () => session.edited(),
        openKept: opening.openKept,
    };
}
