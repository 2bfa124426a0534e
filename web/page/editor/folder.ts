// A folder of the disk that stays open: what other programs save in it is seen, and texts are written back.
import { same } from './bytes.ts';
import { collect, readFiles, type Found } from './drops.ts';
import type { Files } from './host.ts';
import { Budget } from './limits.ts';
import type { Unpacked } from './unzip.ts';

type Mode = { mode: 'read' | 'readwrite' };

// Not in every browser.
declare global {
    interface FileSystemHandle {
        queryPermission?(mode: Mode): Promise<PermissionState>;
        requestPermission?(mode: Mode): Promise<PermissionState>;
    }
    interface Window {
        showDirectoryPicker?(options: Mode & { id: string; startIn?: FileSystemHandle }): Promise<FileSystemDirectoryHandle>;
        FileSystemObserver?: new (changed: () => void) => {
            observe(handle: FileSystemHandle, options: { recursive: boolean }): Promise<void>;
            disconnect(): void;
        };
    }
}

// Milliseconds from one look at the folder to the next, and where the browser tells of changes.
const pause = 400;
const longPause = 3000;
// Of a larger folder, only the files of the scene are looked at each time.
const few = 200;
// Looks until the folder is listed again, for files that are new or gone.
const oftenEnough = 6;

export interface Changes {
    files: Map<string, Uint8Array>;
    gone: string[];
}

export class Folder {
    // As they were read or written last.
    readonly files = new Map<string, Uint8Array>();
    readonly #found = new Map<string, Found>();
    // Files that were empty at the last look: a program that saves may have emptied them first.
    readonly #empty = new Set<string>();
    #looks = 0;

    constructor(readonly handle: FileSystemDirectoryHandle) {}

    async #list(): Promise<Found[]> {
        const found: Found[] = [];
        await collect(this.handle, this.handle.name, new Budget(), found);
        return found;
    }

    // Reads all files. Throws a TooMuch.
    async read(): Promise<Unpacked> {
        const found = await this.#list();
        const unpacked = await readFiles(found, new Budget());
        for (const each of found) {
            const bytes = unpacked.files.get(each.path);
            if (bytes) this.#keep(each, bytes);
        }
        return { ...unpacked, folder: this };
    }

    #keep(found: Found, bytes: Uint8Array): void {
        this.#found.set(found.path, found);
        this.files.set(found.path, bytes);
    }

    async #bytes(found: Found): Promise<Uint8Array> {
        return new Uint8Array(await found.file.arrayBuffer());
    }

    // What other programs have changed since then. `used`: names of the scene's files; `all`: of every file.
    async look(used: readonly string[], all: boolean): Promise<Changes> {
        const changes: Changes = { files: new Map(), gone: [] };
        const list = all || this.#looks++ % oftenEnough === 0;
        const known = [...this.#found.values()].filter(({ path }) => this.#found.size <= few || used.includes(path));
        const now = list ? await this.#list() : await Promise.all(known.map(refound));
        for (const each of now) if (each) await this.#compare(each, changes);
        const there = new Set(now.map((each) => each?.path));
        for (const path of list ? [...this.#found.keys()] : known.map(({ path }) => path)) {
            if (there.has(path)) continue;
            this.#found.delete(path);
            this.files.delete(path);
            changes.gone.push(path);
        }
        return changes;
    }

    async #compare(now: Found, changes: Changes): Promise<void> {
        const before = this.#found.get(now.path)?.file;
        if (before && before.lastModified === now.file.lastModified && before.size === now.file.size) return;
        if (now.file.size === 0 && before?.size && !this.#empty.delete(now.path)) return void this.#empty.add(now.path);
        const bytes = await this.#bytes(now);
        const known = this.files.get(now.path);
        this.#keep(now, bytes);
        if (!known || !same(known, bytes)) changes.files.set(now.path, bytes);
    }

    // Writes all texts or none. Returns "" or why nothing was written.
    async write(texts: Files): Promise<string> {
        const mode: Mode = { mode: 'readwrite' };
        const allowed = (await this.handle.requestPermission?.(mode)) ?? 'granted'; // asks only once
        if (allowed !== 'granted') return 'The browser was not allowed to write into the folder.';
        const writers: FileSystemWritableFileStream[] = [];
        try {
            for (const [name, bytes] of texts) {
                const found = this.#found.get(name);
                if (!found?.handle) return `Nothing was written: '${name}' is not in the folder any more.`;
                const writer = await found.handle.createWritable();
                writers.push(writer);
                await writer.write(new Uint8Array(bytes));
            }
            for (const name of texts.keys()) if (await this.#changed(name)) return changedMeanwhile(name);
            // What was written takes the place of the file when it is closed.
            for (const writer of writers.splice(0)) await writer.close();
        } catch (error) {
            return `The folder cannot be written: ${error instanceof Error ? error.message : String(error)}`;
        } finally {
            for (const writer of writers) await writer.abort().catch(() => undefined);
        }
        for (const [name, bytes] of texts) this.#keep((await refound(this.#found.get(name)!)) ?? this.#found.get(name)!, bytes);
        return '';
    }

    async #changed(name: string): Promise<boolean> {
        const now = await refound(this.#found.get(name)!);
        return !now || !same(await this.#bytes(now), this.files.get(name)!);
    }

    // Calls `changed` soon after another program changed something, until it is stopped.
    watch(look: (all: boolean) => Promise<void>): () => void {
        let timer: ReturnType<typeof setTimeout> | undefined;
        let [running, stopped, told, observed] = [false, false, false, false];
        const next = () => {
            clearTimeout(timer);
            if (!stopped && !document.hidden) timer = setTimeout(run, told ? 50 : observed ? longPause : pause);
        };
        const run = async () => {
            if (running || stopped) return;
            running = true;
            const all = told;
            told = false;
            await look(all).catch(() => undefined);
            running = false;
            next();
        };
        const observer = window.FileSystemObserver && new window.FileSystemObserver(() => {
            told = true;
            next();
        });
        observer?.observe(this.handle, { recursive: true }).then(() => (observed = true), () => undefined);
        document.addEventListener('visibilitychange', next);
        next();
        return () => {
            stopped = true;
            clearTimeout(timer);
            observer?.disconnect();
            document.removeEventListener('visibilitychange', next);
        };
    }
}

// The file as it is now; undefined: it is gone.
function refound(found: Found): Promise<Found | undefined> {
    return found.handle!.getFile().then((file) => ({ ...found, file }), () => undefined);
}

function changedMeanwhile(name: string): string {
    return `Nothing was written: another program has changed '${name}' meanwhile.`;
}
