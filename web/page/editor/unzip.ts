// Reads .zip archives that anyone may have made: sizes are not believed, and names are checked.
import { Inflate } from 'fflate';
import { crc32 } from './crc.ts';
import type { Folder } from './folder.ts';
import { Budget } from './limits.ts';
import { Names } from './names.ts';

export interface Unpacked {
    files: Map<string, Uint8Array>;
    // Why files were left out.
    messages: string[];
    // The folder that they are in, if it can be read again.
    folder?: Folder;
}

interface Entry {
    name: string;
    flags: number;
    method: number;
    crc: number;
    packed: number;
    size: number;
    offset: number;
    link: boolean;
}

export class BadArchive extends Error {}

const damaged = 'the archive is damaged';
const zip64 = 'the archive has the format ZIP64, which the page cannot read';

// Code page 437 from 0x80, for names that are not marked as UTF-8.
const oldNames =
    'ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00a0';

function decodeName(bytes: Uint8Array, utf8: boolean): string {
    try {
        return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    } catch {
        const high = utf8 ? '\ufffd'.repeat(128) : oldNames;
        return Array.from(bytes, (byte) => (byte < 0x80 ? String.fromCharCode(byte) : high[byte - 0x80])).join('');
    }
}

// The offset of the end record, which a comment of up to 65,535 bytes follows.
function endRecord(view: DataView): number {
    const first = Math.max(0, view.byteLength - 22 - 0xffff);
    for (let at = view.byteLength - 22; at >= first; --at)
        if (view.getUint32(at, true) === 0x06054b50 && at + 22 + view.getUint16(at + 20, true) <= view.byteLength) return at;
    throw new BadArchive('it is not a .zip archive, or it is not whole');
}

function readEntry(bytes: Uint8Array, view: DataView, at: number): { entry: Entry; next: number } {
    if (at + 46 > view.byteLength || view.getUint32(at, true) !== 0x02014b50) throw new BadArchive(damaged);
    const flags = view.getUint16(at + 8, true);
    const nameEnd = at + 46 + view.getUint16(at + 28, true);
    const next = nameEnd + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    if (next > view.byteLength) throw new BadArchive(damaged);
    const unix = view.getUint8(at + 5) === 3;
    const entry = {
        name: decodeName(bytes.subarray(at + 46, nameEnd), (flags & 0x800) !== 0),
        flags,
        method: view.getUint16(at + 10, true),
        crc: view.getUint32(at + 16, true),
        packed: view.getUint32(at + 20, true),
        size: view.getUint32(at + 24, true),
        offset: view.getUint32(at + 42, true),
        link: unix && (view.getUint16(at + 40, true) & 0xf000) === 0xa000,
    };
    if ([entry.packed, entry.size, entry.offset].includes(0xffffffff)) throw new BadArchive(zip64);
    return { entry, next };
}

function* entriesOf(bytes: Uint8Array, view: DataView): Generator<Entry> {
    const end = endRecord(view);
    const count = view.getUint16(end + 10, true);
    let at = view.getUint32(end + 16, true);
    if (count === 0xffff || at === 0xffffffff) throw new BadArchive(zip64);
    if (view.getUint16(end + 4, true) !== 0) throw new BadArchive('the archive is one part of several');
    for (let i = 0; i < count; ++i) {
        const { entry, next } = readEntry(bytes, view, at);
        at = next;
        yield entry;
    }
}

function packedBytes(bytes: Uint8Array, view: DataView, { offset, packed }: Entry): Uint8Array {
    if (offset + 30 > view.byteLength || view.getUint32(offset, true) !== 0x04034b50) throw new BadArchive(damaged);
    const start = offset + 30 + view.getUint16(offset + 26, true) + view.getUint16(offset + 28, true);
    if (start + packed > view.byteLength) throw new BadArchive(damaged);
    return bytes.subarray(start, start + packed);
}

// Inflates to exactly `size` bytes, and never to much more: 1 byte of input gives at most 1032 bytes of output.
function inflated(packed: Uint8Array, size: number): Uint8Array {
    const out = new Uint8Array(size);
    let length = 0;
    const stream = new Inflate((chunk) => {
        if (length + chunk.length > size) throw new BadArchive('it is larger than the archive says');
        out.set(chunk, length);
        length += chunk.length;
    });
    const step = 4096;
    try {
        for (let at = 0; at < packed.length; at += step)
            stream.push(packed.subarray(at, at + step), at + step >= packed.length);
    } catch (error) {
        throw error instanceof BadArchive ? error : new BadArchive('it is damaged');
    }
    if (length !== size) throw new BadArchive('it is smaller than the archive says');
    return out;
}

function unpacked(bytes: Uint8Array, view: DataView, entry: Entry, name: string, budget: Budget): Uint8Array {
    if (entry.flags & 0x41) throw new BadArchive('it is encrypted');
    if (entry.method !== 0 && entry.method !== 8)
        throw new BadArchive('it is compressed by a method that the page cannot read; store or deflate it');
    budget.bytes(name, entry.size);
    const packed = packedBytes(bytes, view, entry);
    if (entry.method === 0 && packed.length !== entry.size) throw new BadArchive('it is damaged');
    const out = entry.method === 0 ? packed.slice() : inflated(packed, entry.size);
    if (crc32(out) !== entry.crc) throw new BadArchive('it is damaged');
    return out;
}

// Throws a BadArchive or a TooMuch where nothing can be used. Gives the page time between the files.
export async function unzip(bytes: Uint8Array, budget = new Budget()): Promise<Unpacked> {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const files = new Map<string, Uint8Array>();
    const messages: string[] = [];
    const names = new Names();
    let rested = Date.now();
    for (const entry of entriesOf(bytes, view)) {
        budget.file();
        if (entry.link || /[\\/]$/.test(entry.name)) continue;
        const { name, error } = names.clean(entry.name);
        if (error) messages.push(`'${entry.name}' is left out: ${error}.`);
        if (!name) continue;
        try {
            files.set(name, unpacked(bytes, view, entry, name, budget));
        } catch (error) {
            if (!(error instanceof BadArchive)) throw error;
            messages.push(`'${name}' is left out: ${error.message}.`);
        }
        if (Date.now() - rested > 50) {
            await new Promise((resolve) => setTimeout(resolve));
            rested = Date.now();
        }
    }
    return { files, messages };
}

