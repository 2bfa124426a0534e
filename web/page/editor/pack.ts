// Files as one .zip archive: the same files give the same bytes, at any time and place.
import { deflateSync } from 'fflate';
import { download } from '../dom.ts';
import { crc32 } from './crc.ts';
import { baseOf } from './names.ts';

// Deflate does not make these smaller.
const packedAlready = /\.(png|jpe?g|gif|webp|zip)$/i;

// 1 January 1980, the first day that an archive can name.
const date = (1 << 5) | 1;

interface Packed {
    name: Uint8Array;
    bytes: Uint8Array;
    // Version, flags (the name is UTF-8), method, time, date, checksum, sizes, length of the name, and no extra field: the
    // part that both headers of an entry have.
    facts: Uint8Array;
}

function numbers(...values: [number, 2 | 4][]): Uint8Array {
    const out = new DataView(new ArrayBuffer(values.reduce((sum, [, size]) => sum + size, 0)));
    let at = 0;
    for (const [value, size] of values) {
        if (size === 2) out.setUint16(at, value, true);
        else out.setUint32(at, value, true);
        at += size;
    }
    return new Uint8Array(out.buffer);
}

function packed(name: string, bytes: Uint8Array): Packed {
    const encoded = new TextEncoder().encode(name);
    const smaller = packedAlready.test(name) ? bytes : deflateSync(bytes, { level: 6 });
    const body = smaller.length < bytes.length ? smaller : bytes;
    const method = body === bytes ? 0 : 8;
    const facts = numbers([20, 2], [0x800, 2], [method, 2], [0, 2], [date, 2], [crc32(bytes), 4], [body.length, 4],
        [bytes.length, 4], [encoded.length, 2], [0, 2]);
    return { name: encoded, bytes: body, facts };
}

function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
    const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) {
        out.set(part, at);
        at += part.length;
    }
    return out;
}

export function zip(files: ReadonlyMap<string, Uint8Array>): Uint8Array<ArrayBuffer> {
    const sorted = [...files].sort(([a], [b]) => (a < b ? -1 : a > b ? 1 : 0));
    const bodies: Uint8Array[] = [];
    const directory: Uint8Array[] = [];
    let offset = 0;
    for (const [fileName, fileBytes] of sorted) {
        const { name, bytes, facts } = packed(fileName, fileBytes);
        const body = [numbers([0x04034b50, 4]), facts, name, bytes];
        const noComment = numbers([0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]);
        directory.push(numbers([0x02014b50, 4], [20, 2]), facts, noComment, name);
        offset += body.reduce((sum, part) => sum + part.length, 0);
        bodies.push(...body);
    }
    const list = joined(directory);
    const count = sorted.length;
    const end = numbers([0x06054b50, 4], [0, 2], [0, 2], [count, 2], [count, 2], [list.length, 4], [offset, 4], [0, 2]);
    return joined([...bodies, list, end]);
}

// One file of a scene, without its folders.
export function saveBytes(name: string, bytes: Uint8Array): void {
    download(baseOf(name), new Blob([new Uint8Array(bytes)], { type: 'application/octet-stream' }));
}

// Named after the scene.
export function saveZip(scene: string, files: ReadonlyMap<string, Uint8Array>): void {
    download(`${baseOf(scene).replace(/\.glib$/i, '')}.zip`, new Blob([zip(files)], { type: 'application/zip' }));
}
