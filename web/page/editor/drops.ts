// Files that were dropped or chosen: folders with all that they contain, archives, and single files.
import { Folder as LiveFolder } from './folder.ts';
import { Budget, TooMuch } from './limits.ts';
import { isJunk, Names } from './names.ts';
import { BadArchive, unzip, type Unpacked } from './unzip.ts';

declare global {
    interface DataTransferItem {
        // Not in every browser.
        getAsFileSystemHandle?(): Promise<FileSystemHandle | null>;
    }
    interface FileSystemDirectoryHandle {
        values(): AsyncIterable<FileSystemHandle>;
    }
}

export interface Found {
    path: string;
    file: File;
    // Of folders that can be read again.
    handle?: FileSystemFileHandle;
}

// A folder by one of the two interfaces that browsers have: in a page from a disk, Chromium's older one fails.
type Folder = FileSystemDirectoryEntry | FileSystemDirectoryHandle;
type Child = { name: string; folder: Folder } | { name: string; file: () => Promise<File>; handle?: FileSystemFileHandle };

function readBatch(reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> {
    return new Promise((resolve, reject) => reader.readEntries(resolve, reject));
}

function childOf(entry: FileSystemEntry): Child {
    const { name } = entry;
    if (entry.isDirectory) return { name, folder: entry as FileSystemDirectoryEntry };
    return { name, file: () => new Promise((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject)) };
}

async function* childrenOf(folder: Folder): AsyncGenerator<Child> {
    if ('createReader' in folder) {
        const reader = folder.createReader();
        // A reader gives at most 100 entries at a time.
        for (let batch = await readBatch(reader); batch.length > 0; batch = await readBatch(reader)) yield* batch.map(childOf);
        return;
    }
    for await (const handle of folder.values())
        yield handle.kind === 'directory'
            ? { name: handle.name, folder: handle as FileSystemDirectoryHandle }
            : { name: handle.name, file: () => (handle as FileSystemFileHandle).getFile(), handle: handle as FileSystemFileHandle };
}

// A folder of a million files ends at the budget, before any of them is read.
export async function collect(folder: Folder, path: string, budget: Budget, out: Found[]): Promise<void> {
    for await (const child of childrenOf(folder)) {
        if (isJunk(child.name)) continue;
        const inner = (path === '' ? child.name : `${path}/${child.name}`).normalize('NFC');
        if ('folder' in child) {
            await collect(child.folder, inner, budget, out);
        } else {
            budget.file();
            out.push({ path: inner, file: await child.file(), handle: child.handle });
        }
    }
}

export async function readFiles(found: readonly Found[], budget: Budget): Promise<Unpacked> {
    const files = new Map<string, Uint8Array>();
    const messages: string[] = [];
    const names = new Names();
    for (const { path, file } of found) {
        const { name, error } = names.clean(path);
        if (error) messages.push(`'${path}' is left out: ${error}.`);
        if (!name) continue;
        budget.bytes(name, file.size);
        files.set(name, new Uint8Array(await file.arrayBuffer()));
    }
    return { files, messages };
}

async function unpack(found: readonly Found[]): Promise<Unpacked> {
    const budget = new Budget();
    const archive = found.length === 1 && /\.zip$/i.test(found[0].path) ? found[0].file : undefined;
    if (!archive) return readFiles(found, budget);
    if (archive.size > budget.room) budget.bytes(archive.name, archive.size);
    return unzip(new Uint8Array(await archive.arrayBuffer()), budget);
}

async function explained(what: () => Promise<Unpacked>): Promise<Unpacked> {
    try {
        return await what();
    } catch (error) {
        const known = error instanceof BadArchive || error instanceof TooMuch;
        const why = known ? error.message : 'the browser cannot read it';
        return { files: new Map(), messages: [`Nothing was opened: ${why}.`] };
    }
}

// What a drop holds: taken within the event, because it is not there afterwards.
interface Item {
    file: File | null;
    entry: FileSystemEntry | null;
    handle: Promise<FileSystemHandle | null> | undefined;
}

function itemOf(item: DataTransferItem): Item {
    const entry = item.webkitGetAsEntry();
    return { file: item.getAsFile(), entry, handle: entry?.isDirectory ? item.getAsFileSystemHandle?.() : undefined };
}

async function collectItem({ file, entry, handle }: Item, budget: Budget, out: Found[]): Promise<void> {
    if (entry?.isDirectory) {
        const known = await handle?.catch(() => null);
        return collect((known ?? entry) as Folder, entry.name, budget, out);
    }
    if (!file) return;
    budget.file();
    out.push({ path: file.name, file });
}

export function readDrop(data: DataTransfer): Promise<Unpacked> {
    const items = [...data.items].filter(({ kind }) => kind === 'file').map(itemOf);
    return explained(async () => {
        const budget = new Budget();
        const found: Found[] = [];
        const handle = items.length === 1 && (await items[0].handle?.catch(() => null));
        if (handle) return new LiveFolder(handle as FileSystemDirectoryHandle).read();
        for (const item of items) await collectItem(item, budget, found);
        return unpack(found);
    });
}

export function readChosen(files: Iterable<File>): Promise<Unpacked> {
    const found = [...files].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
    return explained(async () => {
        const budget = new Budget();
        found.forEach(() => budget.file());
        return unpack(found);
    });
}

export function readFolder(handle: FileSystemDirectoryHandle): Promise<Unpacked> {
    return explained(() => new LiveFolder(handle).read());
}

// The browser's dialog for a folder that stays open, where it has one. `startIn`: it begins at this file.
export async function chooseFolder(startIn?: FileSystemHandle): Promise<Unpacked | undefined> {
    if (!window.showDirectoryPicker) return chooseFiles(true);
    const handle = await window.showDirectoryPicker({ id: 'snell', mode: 'read', startIn }).catch(() => undefined);
    return handle ? readFolder(handle) : { files: new Map(), messages: ['No folder was opened.'] };
}

// The browser's dialog for files, or for a folder.
export function chooseFiles(folder: boolean): Promise<Unpacked | undefined> {
    return new Promise((resolve) => {
        const input = document.createElement('input');
        input.type = 'file';
        input.multiple = true;
        input.webkitdirectory = folder;
        input.addEventListener('change', () => resolve(input.files ? readChosen(input.files) : undefined));
        input.addEventListener('cancel', () => resolve(undefined));
        input.click();
    });
}

function hasFiles(event: DragEvent): boolean {
    return event.dataTransfer?.types.includes('Files') ?? false;
}

// The whole page takes files; `over` says whether some are held over it.
export function listenForDrops(take: (unpacked: Promise<Unpacked>) => void, over: (held: boolean) => void): void {
    window.addEventListener('dragover', (event) => {
        if (!hasFiles(event)) return;
        event.preventDefault();
        over(true);
    });
    window.addEventListener('dragleave', (event) => {
        if (!event.relatedTarget) over(false);
    });
    // Captured, because CodeMirror inserts the text of files that are dropped on it.
    const drop = (event: DragEvent) => {
        over(false);
        if (!event.dataTransfer || !hasFiles(event)) return;
        event.preventDefault();
        event.stopPropagation();
        take(readDrop(event.dataTransfer));
    };
    window.addEventListener('drop', drop, { capture: true });
}
