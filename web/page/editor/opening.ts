// Opens scenes from outside, and adds files to the scene that is open.
import type { Problem } from '../engine.ts';
import { ask } from './dialog.ts';
import { chooseFiles, listenForDrops } from './drops.ts';
import { newScene } from './examples.ts';
import type { EditorHost } from './host.ts';
import { cannotAdd, plan } from './intake.ts';
import { baseOf } from './names.ts';
import type { Unpacked } from './unzip.ts';
import { makeWelcome } from './welcome.ts';

export interface Author {
    host: EditorHost;
    problems(): readonly Problem[];
    // Names of files whose edits were not downloaded.
    edited(): string[];
    download(): void;
    add(files: Map<string, Uint8Array>): void;
}

export interface Opening {
    welcome: HTMLElement;
    openFiles(): void;
    openFolder(): void;
    newScene(): void;
}

const mostMessages = 5;

function sayAll(host: EditorHost, messages: readonly string[]): void {
    const rest = messages.length - mostMessages;
    const text = messages.slice(0, mostMessages).join(' ') + (rest > 0 ? ` ${rest} more files are left out.` : '');
    if (text !== '') host.say(text);
}

// True if nothing is lost, or the author wants it so.
async function leave(author: Author): Promise<boolean> {
    const edited = author.edited();
    if (edited.length === 0) return true;
    const names = edited.map((name) => `'${name}'`).join(', ');
    const answer = await ask('Edited files', `These edits were not downloaded: ${names}.`, [
        { text: 'Download, then open', value: 'download' },
        { text: 'Discard the edits', value: 'discard' },
    ]);
    if (answer === 'download') author.download();
    return answer !== undefined;
}

async function open(author: Author, scene: string, files: Map<string, Uint8Array>): Promise<void> {
    if (await leave(author)) author.host.openScene(scene, files);
}

async function take(author: Author, { files, messages }: Unpacked): Promise<void> {
    const { host } = author;
    const what = plan(files, { scene: host.scene, files: host.files, problems: author.problems() });
    if (what.kind === 'no scene') messages.push('There is no .glib file among these files.');
    if (what.kind === 'nothing' && messages.length === 0) messages.push('There are no files to open.');
    sayAll(host, messages);
    if (what.kind === 'add') {
        const error = cannotAdd(what.files, host.files);
        if (error !== '') return host.say(error);
        author.add(what.files);
        if (messages.length === 0) host.say(`Added to the scene: ${[...what.files.keys()].map(baseOf).join(', ')}.`);
    } else if (what.kind === 'open') {
        const choices = what.scenes.map((name) => ({ text: name, value: name }));
        const scene =
            choices.length === 1
                ? what.scenes[0]
                : await ask('Several scenes', `There are ${choices.length} scenes. Choose one.`, choices);
        if (scene !== undefined) await open(author, scene, what.files);
    }
}

export function makeOpening(author: Author): Opening {
    const choose = async (folder: boolean) => {
        const chosen = await chooseFiles(folder);
        if (chosen) await take(author, chosen);
    };
    const begin = () => {
        const { scene, files } = newScene();
        void open(author, scene, files);
    };
    const actions = {
        openFiles: () => void choose(false),
        openFolder: () => void choose(true),
        newScene: begin,
    };
    const mark = (held: boolean) => void document.documentElement.classList.toggle('editor-over', held);
    listenForDrops(async (unpacked) => take(author, await unpacked), mark);
    const openExample = (scene: string, files: Map<string, Uint8Array>) => void open(author, scene, files);
    return { ...actions, welcome: makeWelcome({ ...actions, openExample }) };
}
