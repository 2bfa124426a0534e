// Files that were dropped or chosen: folders with all that they contain, archives, and single files.
import { Budget, TooMuch } from './limits.ts';
import { Names } from './names.ts';
import { BadArchive, unzip, type Unpacked } from './unzip.ts';

interface Found {
    path: string;
    file: File;
}

function readAll(reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> {
    return new Promise((resolve, reject) => reader.readEntries(resolve, reject));
}

// A folder of a million files ends at the budget, before any of them is read.
async function collect(entry: FileSystemEntry, folder: string, budget: Budget, out: Found[]): Promise<void> {
    const path = folder + entry.name;
    if (/^\.|^__MACOSX$/.test(entry.name)) return;
    if (entry.isFile) {
        budget.file();
        const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
        out.push({ path, file });
        return;
    }
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    // A reader gives at most 100 entries at a time.
    for (let batch = await readAll(reader); batch.length > 0; batch = await readAll(reader))
        for (const inner of batch) await collect(inner, `${path}/`, budget, out);
}

async function readFiles(found: readonly Found[], budget: Budget): Promise<Unpacked> {
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

// Must be called within the event: the entries are not there afterwards.
export function readDrop(data: DataTransfer): Promise<Unpacked> {
    const entries = [...data.items].filter((item) => item.kind === 'file').map((item) => item.webkitGetAsEntry());
    const plain = [...data.files];
    return explained(async () => {
        const budget = new Budget();
        const found: Found[] = [];
        if (entries.every((entry) => entry !== null)) for (const entry of entries) await collect(entry, '', budget, found);
        else found.push(...plain.map((file) => ({ path: file.name, file })));
        return unpack(found);
    });
}

export function readChosen(files: FileList): Promise<Unpacked> {
    const found = [...files].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
    return explained(async () => {
        const budget = new Budget();
        found.forEach(() => budget.file());
        return unpack(found);
    });
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
