// How to open a scene: drop it, choose it, take an example, or begin one.
import { button } from '../dom.ts';
import { readExamples, type Example } from './examples.ts';
import { limits, megabytes } from './limits.ts';
import { baseOf } from './names.ts';

export interface WelcomeActions {
    openFiles(): void;
    openFolder(): void;
    newScene(): void;
    openExample(scene: string, files: Map<string, Uint8Array>): void;
}

function paragraph(className: string, text: string): HTMLElement {
    const element = document.createElement('p');
    element.className = className;
    element.textContent = text;
    return element;
}

function exampleButton({ scene, subject }: Example, open: () => void): HTMLElement {
    const item = document.createElement('li');
    const example = button('', open);
    const name = document.createElement('strong');
    name.textContent = baseOf(scene).replace(/\.glib$/, '');
    const about = document.createElement('span');
    about.textContent = subject;
    example.append(name, ' ', about);
    item.append(example);
    return item;
}

async function exampleSection(open: WelcomeActions['openExample']): Promise<HTMLElement | undefined> {
    const examples = await readExamples();
    if (!examples) return undefined;
    const section = document.createElement('section');
    const heading = document.createElement('h3');
    heading.textContent = 'Examples';
    const list = document.createElement('ul');
    for (const example of examples.list)
        list.append(exampleButton(example, () => open(example.scene, examples.open(example))));
    section.append(heading, list);
    return section;
}

export function makeWelcome(actions: WelcomeActions): HTMLElement {
    const element = document.createElement('section');
    element.className = 'editor-welcome';
    const heading = document.createElement('h2');
    heading.id = 'editor-welcome-heading';
    heading.textContent = 'Open a scene';
    element.setAttribute('aria-labelledby', heading.id);
    const buttons = document.createElement('div');
    buttons.className = 'editor-buttons';
    buttons.append(
        button('Open files…', actions.openFiles),
        button('Open folder…', actions.openFolder),
        button('New scene', actions.newScene),
    );
    element.append(
        heading,
        paragraph('editor-drop-here', 'Drop a folder, a .zip archive, or a .glib file with its other files anywhere on this page.'),
        buttons,
        paragraph(
            'editor-fine-print',
            `At most ${limits.files} files of ${megabytes(limits.fileBytes)} each and ${megabytes(limits.bytes)} together. ` +
                'The files stay on this device, and the page works without a network.',
        ),
    );
    exampleSection(actions.openExample).then(
        (section) => section && element.append(section),
        (error: unknown) => element.append(paragraph('editor-fine-print', `The examples cannot be read: ${String(error)}`)),
    );
    return element;
}
