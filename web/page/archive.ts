// The data in a page → files. A page may be made by anyone, so nothing in the archive is trusted.

export interface Unpacked {
    // By name. Images of formats that the engine does not decode are there as pixels: see `originals`.
    files: Map<string, Uint8Array>;
    // The files, of which `files` holds the pixels, as they were: for Download.
    originals: Map<string, Uint8Array>;
}

// As in src/app/page/page.h.
export const mostFiles = 10_000;
export const mostBytes = 512 * 1024 * 1024;
const mostHeaderBytes = 8 * 1024 * 1024;
const mostNameLength = 1024;

interface Entry {
    name: string;
    size: number;
    decoded: boolean;
    // Of a BMP image: where its pixels begin, and bytes of a pixel and of a row.
    rows?: [begin: number, pixel: number, row: number];
}

// What is wrong with a name, or "".
export function nameProblem(name: string): string {
    if (name === '' || name.length > mostNameLength) return 'is empty or too long';
    if (/[\u0000-\u001f\u007f\\]/.test(name)) return 'has control characters or backslashes';
    if (/^[A-Za-z]:/.test(name)) return 'begins with a drive';
    for (const part of name.split('/')) {
        if (part === '') return 'is absolute, or has an empty part';
        if (part === '.' || part === '..') return 'leads to another folder';
    }
    return '';
}

// Not in every browser, and faster where it is.
declare global {
    interface Uint8ArrayConstructor {
        fromBase64?(text: string): Uint8Array<ArrayBuffer>;
    }
}

export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
    return bytes;
}

export function unzipped(packed: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
    return new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
}

// Ends as soon as there are more bytes than allowed, whatever the compressed size is.
export async function gunzip(packed: Uint8Array<ArrayBuffer>, most: number): Promise<Uint8Array> {
    const reader = unzipped(packed).getReader();
    const parts: Uint8Array[] = [];
    let size = 0;
    for (;;) {
        const { done, value } = await reader.read();
        if (done) break;
        size += value.byteLength;
        if (size > most) {
            await reader.cancel();
            throw new Error('The files of this page are larger than a page may be.');
        }
        parts.push(value);
    }
    const all = new Uint8Array(size);
    let at = 0;
    for (const part of parts) {
        all.set(part, at);
        at += part.byteLength;
    }
    return all;
}

function entryOf(value: unknown): Entry {
    const { name, size, decoded, rows } = (value ?? {}) as Record<string, unknown>;
    if (typeof name !== 'string') throw new Error('A file of this page has no name.');
    const problem = nameProblem(name);
    if (problem !== '') throw new Error(`The name ${JSON.stringify(name)} of a file ${problem}.`);
    if (typeof size !== 'number' || !Number.isSafeInteger(size) || size < 0)
        throw new Error(`The size of the file ${JSON.stringify(name)} is not a number of bytes.`);
    if (rows === undefined) return { name, size, decoded: decoded === true };
    const fits = Array.isArray(rows) && rows.length === 3 && rows.every((each) => Number.isSafeInteger(each) && each > 0 && each <= 2 ** 31);
    if (!fits) throw new Error(`The rows of the image ${JSON.stringify(name)} are no numbers of bytes.`);
    return { name, size, decoded: decoded === true, rows: rows as Entry['rows'] };
}

// Adds to each byte what its neighbours foretell, as in PNG (src/app/page/page.cpp).
function foretell(bytes: Uint8Array, [begin, pixel, row]: [number, number, number]): void {
    for (let i = begin; i < bytes.length; ++i) {
        const left = i < begin + pixel ? 0 : bytes[i - pixel]!;
        const above = i < begin + row ? 0 : bytes[i - row]!;
        const corner = i < begin + row + pixel ? 0 : bytes[i - row - pixel]!;
        const guess = left + above - corner;
        const [a, b, c] = [Math.abs(guess - left), Math.abs(guess - above), Math.abs(guess - corner)];
        bytes[i] = bytes[i]! + (a <= b && a <= c ? left : b <= c ? above : corner);
    }
}

function entriesOf(header: string): Entry[] {
    let list: unknown;
    try {
        list = (JSON.parse(header) as { files?: unknown } | null)?.files;
    } catch {
        list = undefined;
    }
    if (!Array.isArray(list)) throw new Error('The list of files of this page is damaged.');
    if (list.length > mostFiles) throw new Error(`This page has more than ${mostFiles} files.`);
    return list.map(entryOf);
}

// Names of which one is a folder of another have no place on a disk.
function clash(names: Iterable<string>): string {
    const all = new Set(names);
    for (const name of all)
        for (let at = name.indexOf('/'); at >= 0; at = name.indexOf('/', at + 1))
            if (all.has(name.slice(0, at))) return name;
    return '';
}

// The bytes of an archive, unpacked. Throws an Error for people if it is damaged or hostile.
export function filesOf(archive: Uint8Array): Unpacked {
    const end = archive.subarray(0, mostHeaderBytes).indexOf(10);
    if (end < 0) throw new Error('The list of files of this page is damaged.');
    const entries = entriesOf(new TextDecoder().decode(archive.subarray(0, end)));
    const unpacked: Unpacked = { files: new Map(), originals: new Map() };
    let at = end + 1;
    for (const { name, size, decoded, rows } of entries) {
        if (size > archive.length - at) throw new Error(`The file ${JSON.stringify(name)} is cut off.`);
        const bytes = archive.subarray(at, at + size);
        if (rows) foretell(bytes, rows);
        at += size;
        const known = unpacked.files.get(name);
        if ((known !== undefined) !== decoded || unpacked.originals.has(name))
            throw new Error(`The file ${JSON.stringify(name)} is there twice.`);
        if (known) unpacked.originals.set(name, known);
        unpacked.files.set(name, bytes);
    }
    const clashing = clash(unpacked.files.keys());
    if (clashing !== '') throw new Error(`A folder of ${JSON.stringify(clashing)} is a file, too.`);
    if (at !== archive.length) throw new Error('The archive of this page is longer than its files.');
    return unpacked;
}

// The text of the page's data block. Empty: the page has no scene.
export async function unpack(text: string): Promise<Unpacked> {
    if (text.trim() === '') return { files: new Map(), originals: new Map() };
    return filesOf(await gunzip(fromBase64(text), mostBytes));
}
