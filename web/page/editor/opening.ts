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
    // An empty one takes away what was said about an earlier try.
    host.say(messages.slice(0, mostMessages).join(' ') + (rest > 0 ? ` ${rest} more files are left out.` : ''));
}

// True if none of these files has edits that would be lost, or the author wants it so.
async function leave(author: Author, names: readonly string[]): Promise<boolean> {
    const edited = author.edited().filter((name) => names.includes(name));
    if (edited.length === 0) return true;
    const list = edited.map((name) => `'${name}'`).join(', ');
    const answer = await ask('Edited files', `These edits were not downloaded: ${list}.`, [
        { text: 'Download, then continue', value: 'download' },
        { text: 'Discard the edits', value: 'discard' },
    ]);
    if (answer === 'download') author.download();
    return answer !== undefined;
}

async function open(author: Author, scene: string, files: Map<string, Uint8Array>): Promise<void> {
    if (await leave(author, [...author.host.files.keys()])) author.host.openScene(scene, files);
}

async function add(author: Author, files: Map<string, Uint8Array>): Promise<void> {
    const { host } = author;
    const error = cannotAdd(files, host.files);
    if (error !== '') return host.say(error);
    if (!(await leave(author, [...files.keys()]))) return;
    author.add(files);
    host.say(`Taken into the scene: ${[...files.keys()].map(baseOf).join(', ')}.`);
}

async function openOneOf(author: Author, scenes: readonly string[], files: Map<string, Uint8Array>): Promise<void> {
    const { host } = author;
    const choices = scenes.map((name) => ({ text: name, value: name }));
    if (files.size === 1 && baseOf(scenes[0]) === baseOf(host.scene)) {
        const text = `The scene that is open has the name '${scenes[0]}', too.`;
        const answers = [
            { text: 'Replace its text', value: true },
            { text: 'Open another scene', value: false },
        ];
        const replace = await ask('A scene of the same name', text, answers);
        if (replace) return add(author, new Map([[host.scene, files.get(scenes[0])!]]));
        if (replace === undefined) return;
    }
    const several = `There are ${choices.length} scenes. Choose one.`;
    const scene = choices.length === 1 ? scenes[0] : await ask('Several scenes', several, choices);
    if (scene !== undefined) await open(author, scene, files);
}

async function take(author: Author, { files, messages }: Unpacked): Promise<void> {
    const { host } = author;
    const what = plan(files, { scene: host.scene, files: host.files, problems: author.problems() });
    if (what.kind === 'no scene') messages.push('There is no .glib file among these files.');
    if (what.kind === 'nothing' && messages.length === 0) messages.push('There are no files to open.');
    sayAll(host, messages);
    if (what.kind === 'add') await add(author, what.files);
    else if (what.kind === 'open') await openOneOf(author, what.scenes, what.files);
}

export function makeOpening(author: Author): Opening {
    // One after the other: what is opened last stays, however long an earlier archive takes.
    let turn: Promise<void> = Promise.resolve();
    const inTurn = (work: () => Promise<void>) => (turn = turn.then(work, work));
    const choose = async (folder: boolean) => {
        const chosen = await chooseFiles(folder);
        if (chosen) await inTurn(() => take(author, chosen));
    };
    const openNew = (scene: string, files: Map<string, Uint8Array>) => void inTurn(() => open(author, scene, files));
    const begin = () => {
        const { scene, files } = newScene();
        openNew(scene, files);
    };
    const actions = {
        openFiles: () => void choose(false),
        openFolder: () => void choose(true),
        newScene: begin,
    };
    const mark = (held: boolean) => void document.documentElement.classList.toggle('editor-over', held);
    listenForDrops((unpacked) => void inTurn(async () => take(author, await unpacked)), mark);
    return { ...actions, welcome: makeWelcome({ ...actions, openExample: openNew }) };
}
