// Opens scenes from outside, and adds files to the scene that is open.
import type { Problem } from '../engine.ts';
import { ask } from '../dialog.ts';
import { el } from '../dom.ts';
import { all, type KeptFolder } from '../store.ts';
import { isScene } from './code.ts';
import { chooseFiles, chooseFolder, listenForDrops, readChosen, readFolder } from './drops.ts';
import type { EditorHost, Files } from './host.ts';
import { cannotAdd, plan } from './intake.ts';
import { baseOf } from './names.ts';
import type { Unpacked } from './unzip.ts';
import { makeWelcome } from './welcome.ts';

export interface Author {
    host: EditorHost;
    problems(): readonly Problem[];
    // Names of files whose edits were not saved.
    edited(): string[];
    download(): void;
    // Into the folder. False: nothing was written.
    save(): Promise<boolean>;
    add(files: Map<string, Uint8Array>): void;
}

export interface Opening {
    welcome: HTMLElement;
    // Lists the scenes of the files that are open.
    scenes(): void;
    // A folder of an earlier visit.
    openKept(folder: KeptFolder): void;
}

// Not in every browser: files that the desktop opens with the installed page.
declare global {
    interface Window {
        launchQueue?: { setConsumer(take: (launch: { files: FileSystemHandle[] }) => void): void };
    }
}

const mostMessages = 5;
// Scenes of which there are pictures, and milliseconds after which there are no more.
const mostPictures = 60;
const longest = 20_000;

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
    const keep = author.host.folder ? { text: 'Save, then continue', value: 'save' } : { text: 'Download, then continue', value: 'download' };
    const answer = await ask('Edited files', `These edits were not saved: ${list}.`, [keep, { text: 'Discard the edits', value: 'discard' }]);
    if (answer === 'download') author.download();
    return answer === 'save' ? author.save() : answer !== undefined;
}

async function open(author: Author, scene: string, { files, folder }: Omit<Unpacked, 'messages'>): Promise<void> {
    if (await leave(author, [...author.host.files.keys()])) await author.host.openScene(scene, files, folder);
}

async function add(author: Author, files: Map<string, Uint8Array>): Promise<void> {
    const { host } = author;
    const error = cannotAdd(files, host.files);
    if (error !== '') return host.say(error);
    if (!(await leave(author, [...files.keys()]))) return;
    author.add(files);
    host.say(`Taken into the scene: ${[...files.keys()].map(baseOf).join(', ')}.`);
}

// A list of scenes, whose pictures come one after the other.
async function choose(host: EditorHost, scenes: readonly string[], files: Files): Promise<string | undefined> {
    const places = scenes.map(() => el('span', { class: 'thumb' }));
    const choices = scenes.map((name, i) => ({ text: name, value: name, picture: places[i] }));
    const answer = ask('Several scenes', `There are ${scenes.length} scenes. Choose one.`, choices);
    let chosen = false;
    void answer.then(() => (chosen = true));
    const pictures = host.pictures(files);
    const begun = performance.now();
    for (const [i, scene] of scenes.slice(0, mostPictures).entries()) {
        await new Promise((resolve) => setTimeout(resolve, 30));
        if (chosen || performance.now() - begun > longest) break;
        const picture = pictures.of(scene);
        places[i]!.append(picture);
        places[i]!.classList.toggle('none', typeof picture === 'string');
    }
    pictures.end();
    return answer;
}

async function openOneOf(author: Author, scenes: readonly string[], unpacked: Unpacked): Promise<void> {
    const { host } = author;
    const { files, folder } = unpacked;
    if (files.size === 1 && !folder && baseOf(scenes[0]) === baseOf(host.scene)) {
        const text = `The scene that is open has the name '${scenes[0]}', too.`;
        const answers = [
            { text: 'Replace its text', value: true },
            { text: 'Open another scene', value: false },
        ];
        const replace = await ask('A scene of the same name', text, answers);
        if (replace) return add(author, new Map([[host.scene, files.get(scenes[0])!]]));
        if (replace === undefined) return;
    }
    const scene = scenes.length === 1 ? scenes[0] : await choose(host, scenes, files);
    if (scene !== undefined) await open(author, scene, unpacked);
}

// `wanted`: the scene that is opened if it is there.
async function take(author: Author, unpacked: Unpacked, wanted = ''): Promise<void> {
    const { host } = author;
    const { files, messages, folder } = unpacked;
    const live = folder && [...files.keys()].some(isScene);
    const now = { scene: live ? '' : host.scene, files: host.files, problems: author.problems() };
    const what = plan(files, now);
    if (what.kind === 'no scene') messages.push('There is no .glib file among these files.');
    if (what.kind === 'nothing' && messages.length === 0) messages.push('There are no files to open.');
    sayAll(host, messages);
    if (what.kind === 'add') await add(author, what.files);
    else if (what.kind === 'open' && files.has(wanted)) await open(author, wanted, unpacked);
    else if (what.kind === 'open') await openOneOf(author, what.scenes, unpacked);
}

async function openKept(author: Author, { handle, scene }: KeptFolder): Promise<void> {
    const allowed = (await handle.requestPermission?.({ mode: 'read' })) ?? 'granted';
    if (allowed !== 'granted') return author.host.say(`The browser was not allowed to read the folder '${handle.name}'.`);
    await take(author, await readFolder(handle), scene);
}

// A scene needs its other files: those of a folder that was open before, or of one that the author chooses.
async function openLaunched(author: Author, file: FileSystemFileHandle): Promise<void> {
    for (const { handle } of await all('folders')) {
        const path = await handle.resolve(file).catch(() => null);
        const wanted = path && [handle.name, ...path].join('/').normalize('NFC');
        if (wanted && (await handle.queryPermission?.({ mode: 'read' })) === 'granted') return take(author, await readFolder(handle), wanted);
    }
    const text = `A scene reads other files of its folder, and a page reads only what you choose: choose the folder of '${file.name}'.`;
    const folder = await ask('The folder of the scene', text, [
        { text: 'Choose the folder…', value: true },
        { text: 'Open this file alone', value: false },
    ]);
    if (folder === undefined) return;
    const chosen = folder ? await chooseFolder(file) : await readChosen([await file.getFile()]);
    if (!chosen) return;
    const wanted = [...chosen.files.keys()].filter((name) => baseOf(name) === file.name);
    await take(author, chosen, wanted.length === 1 ? wanted[0] : '');
}

export function makeOpening(author: Author): Opening {
    const { host } = author;
    // One after the other: what is opened last stays, however long an earlier archive takes.
    let turn: Promise<void> = Promise.resolve();
    const inTurn = (work: () => Promise<void>) => (turn = turn.then(work, work));
    const chosen = async (choosing: Promise<Unpacked | undefined>) => {
        const unpacked = await choosing;
        if (unpacked) await inTurn(() => take(author, unpacked));
    };
    const scenes = async () => {
        const scene = await choose(host, [...host.files.keys()].filter(isScene).sort(), host.files);
        if (scene !== undefined && scene !== host.scene) await open(author, scene, { files: host.files, folder: host.folder });
    };
    const mark = (held: boolean) => void document.documentElement.classList.toggle('editor-over', held);
    listenForDrops((unpacked) => void inTurn(async () => take(author, await unpacked)), mark);
    window.launchQueue?.setConsumer(({ files: [file] }) => {
        if (file?.kind === 'file') void inTurn(() => openLaunched(author, file as FileSystemFileHandle));
    });
    const kept = (folder: KeptFolder) => void inTurn(() => openKept(author, folder));
    const welcome = makeWelcome({
        openFiles: () => void chosen(chooseFiles(false)),
        openFolder: () => void chosen(chooseFolder()),
        openKept: kept,
        openExample: (scene, files) => void inTurn(() => open(author, scene, { files })),
    });
    return { welcome, scenes: () => void inTurn(scenes), openKept: kept };
}
