// What the page keeps in the browser from one visit to the next: drafts of texts, and folders that were open.

// By the name of a store; each record has an `id`.
export interface Draft {
    id: string;
    // The scene, and where it came from: a draft is offered to no other one.
    place: string;
    when: number;
    // Each text with the one that it was made of.
    texts: { name: string; base: Uint8Array; bytes: Uint8Array }[];
}

export interface KeptFolder {
    id: string;
    handle: FileSystemDirectoryHandle;
    when: number;
    // The scene that was open last.
    scene: string;
}

interface Kept {
    drafts: Draft;
    folders: KeptFolder;
}

let opened: Promise<IDBDatabase> | undefined;

function database(): Promise<IDBDatabase> {
    opened ??= new Promise((resolve, reject) => {
        const asked = indexedDB.open('snell', 1);
        asked.onupgradeneeded = () => {
            for (const name of ['drafts', 'folders']) asked.result.createObjectStore(name, { keyPath: 'id' });
        };
        asked.onsuccess = () => resolve(asked.result);
        asked.onerror = () => reject(asked.error);
    });
    return opened;
}

async function work<T>(name: keyof Kept, mode: IDBTransactionMode, act: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
    const transaction = (await database()).transaction(name, mode);
    const asked = act(transaction.objectStore(name));
    return new Promise((resolve, reject) => {
        transaction.oncomplete = () => resolve(asked.result);
        transaction.onabort = () => reject(transaction.error);
    });
}

// False where the browser keeps nothing, as in some private windows.
export function put<Name extends keyof Kept>(name: Name, record: Kept[Name]): Promise<boolean> {
    return work(name, 'readwrite', (store) => store.put(record)).then(() => true, () => false);
}

export async function drop(name: keyof Kept, id: string): Promise<void> {
    await work(name, 'readwrite', (store) => store.delete(id)).catch(() => undefined);
}

// The newest first.
export async function all<Name extends keyof Kept>(name: Name): Promise<Kept[Name][]> {
    const found: Kept[Name][] = await work(name, 'readonly', (store) => store.getAll()).catch(() => []);
    return found.sort((a, b) => b.when - a.when);
}
