// Files as one .zip archive: the same files give the same bytes, at any time and place.
import { zipSync, type Zippable } from 'fflate';

// Deflate does not make these smaller.
const packedAlready = /\.(png|jpe?g|gif|webp|zip)$/i;

export function zip(files: ReadonlyMap<string, Uint8Array>): Uint8Array<ArrayBuffer> {
    const sorted = [...files].sort(([a], [b]) => (a < b ? -1 : a > b ? 1 : 0));
    // Without a prototype, '__proto__' is a name like any other.
    const entries = Object.create(null) as Zippable;
    for (const [name, bytes] of sorted) entries[name] = [bytes, { level: packedAlready.test(name) ? 0 : 6 }];
    // A local time, because an archive stores local times without their zone.
    return zipSync(entries, { mtime: new Date(1980, 0, 1) });
}

// Hands the bytes to the browser's downloads.
export function download(name: string, bytes: Uint8Array<ArrayBuffer>, type: string): void {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes], { type }));
    link.download = name;
    link.click();
    // Some browsers read the blob only after the click.
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
