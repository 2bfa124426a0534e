// A file's bytes as text, and back without a change outside of what was edited.

// Byte-order mark and encoding. Text that is not UTF-8 is read as Windows-1252, in which every byte is one character.
export interface Format {
    bom: boolean;
    encoding: 'utf-8' | 'windows-1252';
}

export interface Text {
    format: Format;
    // Without line ends: lines.length is ends.length + 1.
    lines: string[];
    ends: string[];
}

const single = new TextDecoder('windows-1252');
const characters = [...single.decode(Uint8Array.from({ length: 256 }, (_, i) => i))];
const byteOf = new Map(characters.map((character, byte) => [character, byte]));

function startsWithBom(bytes: Uint8Array): boolean {
    return bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
}

function decode(bytes: Uint8Array): { format: Format; text: string } {
    const bom = startsWithBom(bytes);
    const body = bom ? bytes.subarray(3) : bytes;
    try {
        const text = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(body);
        return { format: { bom, encoding: 'utf-8' }, text };
    } catch {
        return { format: { bom, encoding: 'windows-1252' }, text: single.decode(body) };
    }
}

export function read(bytes: Uint8Array): Text {
    const { format, text } = decode(bytes);
    const parts = text.split(/(\r\n|\r|\n)/);
    return { format, lines: parts.filter((_, i) => i % 2 === 0), ends: parts.filter((_, i) => i % 2 === 1) };
}

// The line end that new lines get: the most frequent one.
export function usualEnd(ends: readonly string[]): string {
    const counts = new Map<string, number>();
    for (const end of ends) counts.set(end, (counts.get(end) ?? 0) + 1);
    return [...counts].reduce((best, next) => (next[1] > best[1] ? next : best), ['\n', 0])[0];
}

// The characters of the text that the encoding lacks.
export function unwritable(text: string, format: Format): string[] {
    if (format.encoding === 'utf-8') return [];
    return [...new Set(text)].filter((character) => character !== '\n' && !byteOf.has(character));
}

// Throws no error: unwritable() characters become '?'.
export function write({ format, lines, ends }: Text): Uint8Array<ArrayBuffer> {
    const text = lines.map((line, i) => line + (ends[i] ?? '')).join('');
    const body =
        format.encoding === 'utf-8'
            ? new TextEncoder().encode(text)
            : Uint8Array.from([...text], (character) => byteOf.get(character) ?? 0x3f);
    if (!format.bom) return body;
    const out = new Uint8Array(body.length + 3);
    out.set([0xef, 0xbb, 0xbf]);
    out.set(body, 3);
    return out;
}

export function same(a: Uint8Array, b: Uint8Array): boolean {
    return a.length === b.length && a.every((byte, i) => byte === b[i]);
}

// Extensions of files that are text but too large or of no use to edit, and of images, whose bytes may look like text.
const notEdited = /\.(obj|mtl|shp|dbf|shx|ppm|pgm|pnm|hdr|exr|png|jpe?g|bmp|tga|gif|tiff?|psd|webp|tex|zip|pdf)$/i;

// True for images, meshes and the like, by their names.
export function isData(name: string): boolean {
    return notEdited.test(name);
}

export const largestText = 1 << 20;

// True for what the editor shows: text of at most `largestText` bytes.
export function isText(name: string, bytes: Uint8Array): boolean {
    return !isData(name) && bytes.length <= largestText && !bytes.includes(0);
}
