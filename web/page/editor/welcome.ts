// How to open a scene: a folder, files, an example, or a new one.
import { button, el } from '../dom.ts';
import { all, type KeptFolder } from '../store.ts';
import { newScene, readExamples, type Example, type Examples } from './examples.ts';
import { limits, megabytes } from './limits.ts';
import { baseOf } from './names.ts';

export interface WelcomeActions {
    openFiles(): void;
    openFolder(): void;
    openKept(folder: KeptFolder): void;
    openExample(scene: string, files: Map<string, Uint8Array>): void;
}

function section(title: string, items: readonly HTMLElement[]): HTMLElement {
    const list = el('ul', {}, ...items.map((item) => el('li', {}, item)));
    return el('section', {}, el('h3', {}, title), list);
}

function exampleButton(example: Example, examples: Examples, open: WelcomeActions['openExample']): HTMLElement {
    const { scene, subject } = example;
    const item = button('', () => open(scene, examples.open(example)));
    const picture = examples.picture(example);
    if (picture !== '') item.append(el('img', { src: picture, alt: '', width: 128, height: 96 }));
    item.append(el('strong', {}, baseOf(scene).replace(/\.glib$/, '')), ' ', el('span', {}, subject));
    return item;
}

async function exampleSections(open: WelcomeActions['openExample']): Promise<HTMLElement[]> {
    const examples = await readExamples();
    if (!examples) return [];
    const made = (template: boolean) =>
        examples.list.filter((each) => each.template === template).map((each) => exampleButton(each, examples, open));
    const templates = made(true);
    return [...(templates.length > 0 ? [section('Begin a new scene', templates)] : []), section('Examples', made(false))];
}

async function keptSection(open: WelcomeActions['openKept']): Promise<HTMLElement | undefined> {
    const folders = await all('folders');
    const items = folders.map((folder) => {
        const item = button('', () => open(folder));
        const when = new Date(folder.when).toLocaleDateString(undefined, { dateStyle: 'medium' });
        item.append(el('strong', {}, folder.handle.name || 'this folder'), ' ', el('span', {}, `${baseOf(folder.scene)}, ${when}`));
        return item;
    });
    return items.length > 0 ? section('Folders that were open', items) : undefined;
}

export function makeWelcome(actions: WelcomeActions): HTMLElement {
    const live = window.showDirectoryPicker !== undefined;
    const begin = () => {
        const { scene, files } = newScene();
        actions.openExample(scene, files);
    };
    const buttons = el('div', { class: 'editor-buttons' }, button('Open folder…', actions.openFolder), button('Open files…', actions.openFiles), button('New scene', begin));
    const drop = el('p', { class: 'editor-drop-here' }, 'Drop a folder, a .zip archive, or a .glib file with its other files anywhere on this page.');
    const most = `At most ${limits.files} files of ${megabytes(limits.fileBytes)} each and ${megabytes(limits.bytes)} together. The files stay on this device, and the page works without a network.`;
    const about = live
        ? 'A folder stays open: the picture follows what your own editor saves, and Save writes the numbers of the sliders back.'
        : 'This browser reads a folder once: what you change on the disk later is not seen, and files are saved by downloads.';
    const fine = (text: string) => el('p', { class: 'editor-fine-print' }, text);
    const element = el('section', { class: 'editor-welcome', 'aria-labelledby': 'editor-welcome-heading' }, el('h2', { id: 'editor-welcome-heading' }, 'Open a scene'), drop, buttons, fine(`${about} ${most}`));
    const made = Promise.all([keptSection(actions.openKept), exampleSections(actions.openExample)]);
    made.then(
        ([kept, examples]) => element.append(...(kept ? [kept] : []), ...examples),
        (error: unknown) => element.append(fine(`The examples cannot be read: ${String(error)}`)),
    );
    return element;
}
