// Files as one .zip archive: the same files give the same bytes, at any time and place.
import { Zip, ZipDeflate, ZipPassThrough } from 'fflate';
import { download } from '../dom.ts';
import { baseOf } from './names.ts';

// Deflate does not make these smaller.
const packedAlready = /\.(png|jpe?g|gif|webp|zip)$/i;

export function zip(files: ReadonlyMap<string, Uint8Array>): Uint8Array<ArrayBuffer> {
    const parts: Uint8Array[] = [];
    const archive = new Zip((error, part) => {
        if (error) throw error;
        parts.push(part);
    });
    const date = new Date(1980, 0, 1); // the first day that an archive can name
    for (const [name, bytes] of [...files].sort(([a], [b]) => (a < b ? -1 : a > b ? 1 : 0))) {
        const entry = packedAlready.test(name) ? new ZipPassThrough(name) : new ZipDeflate(name, { level: 6 });
        entry.mtime = date;
        archive.add(entry);
        entry.push(bytes, true);
    }
    archive.end();
    const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) {
        out.set(part, at);
        at += part.length;
    }
    return out;
}

// One file of a scene, without its folders.
export function saveBytes(name: string, bytes: Uint8Array): void {
    download(baseOf(name), new Blob([new Uint8Array(bytes)], { type: 'application/octet-stream' }));
}

// Named after the scene.
export function saveZip(scene: string, files: ReadonlyMap<string, Uint8Array>): void {
    download(`${baseOf(scene).replace(/\.glib$/i, '')}.zip`, new Blob([zip(files)], { type: 'application/zip' }));
}
