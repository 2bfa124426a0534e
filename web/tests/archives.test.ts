// Archives that anyone may have made: nothing leads out of the folder, and nothing takes more memory than allowed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { zipSync } from 'fflate';
import { Budget, TooMuch } from '../page/editor/limits.ts';
import { cleanName, Names, resolve, shortNames } from '../page/editor/names.ts';
import { zip } from '../page/editor/pack.ts';
import { BadArchive, unzip } from '../page/editor/unzip.ts';

const utf8 = (text: string) => new TextEncoder().encode(text);
const small = () => new Budget({ files: 10, bytes: 1000, fileBytes: 600 });

function archive(files: Record<string, string | Uint8Array>, level: 0 | 6 = 6): Uint8Array {
    return zipSync(Object.fromEntries(Object.entries(files).map(([name, text]) => [name, typeof text === 'string' ? utf8(text) : text])), { level });
}

// Offsets of the entries in the directory.
function entries(bytes: Uint8Array): number[] {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const out: number[] = [];
    for (let at = 0; at + 4 <= bytes.length; ++at) if (view.getUint32(at, true) === 0x02014b50) out.push(at);
    return out;
}

// The same archive with other numbers in its first entry.
function forged(bytes: Uint8Array, change: (view: DataView, entry: number) => void): Uint8Array {
    const copy = bytes.slice();
    change(new DataView(copy.buffer), entries(copy)[0]);
    return copy;
}

test('an archive gives its files', async () => {
    const { files, messages } = await unzip(archive({ 'room/a.glib': 'Sphere 1', 'room/ü.frag': 'void main() {}', 'empty': '' }));
    assert.deepEqual([...files.keys()], ['room/a.glib', 'room/ü.frag', 'empty']);
    assert.deepEqual(files.get('room/a.glib'), utf8('Sphere 1'));
    assert.deepEqual(messages, []);
});

test('names that lead elsewhere are left out, and the rest is read', async () => {
    const bad = ['../up', 'a/../../up', '/etc/passwd', 'C:/x', 'c:x', '..\\up', '\\\\server\\x', 'a\u0000b', 'line\nbreak'];
    const { files, messages } = await unzip(archive(Object.fromEntries([...bad, 'good'].map((name) => [name, 'x']))));
    assert.deepEqual([...files.keys()], ['good']);
    assert.equal(messages.length, bad.length);
});

test('backslashes separate folders, and names are written in one way', () => {
    assert.deepEqual(cleanName('a\\b/./c'), { name: 'a/b/c' });
    assert.deepEqual(cleanName('u\u0308.frag'), { name: 'ü.frag' });
    assert.ok('error' in cleanName('.'));
    assert.ok('error' in cleanName('x/'.repeat(40) + 'y'));
    assert.deepEqual(cleanName('<img src=x onerror=alert(1)>'), { name: '<img src=x onerror=alert(1)>' });
});

test('files that Windows could not tell apart are taken once', async () => {
    const { files, messages } = await unzip(archive({ 'A.frag': '1', 'a.frag': '2', 'dir/x': '3', 'DIR': '4', 'a.FRAG/y': '5' }));
    assert.deepEqual([...files.keys()], ['A.frag', 'dir/x']);
    assert.equal(messages.length, 3);
    assert.equal(new Names().take('x'), '');
});

test('what systems leave in folders is not part of a scene', async () => {
    const { files, messages } = await unzip(archive({ '__MACOSX/a': '', '.git/config': '', 'a/.DS_Store': '', 'a/Thumbs.db': '', 'a/b': '' }));
    assert.deepEqual([...files.keys()], ['a/b']);
    assert.deepEqual(messages, []);
});

test('names of objects are names of files, too', async () => {
    const names = ['__proto__', 'constructor', 'toString'];
    const packed = zip(new Map(names.map((name) => [name, utf8(name)])));
    const { files } = await unzip(packed);
    for (const name of names) assert.deepEqual(files.get(name), utf8(name));
});

test('links of Unix are ignored', async () => {
    const linked = forged(archive({ link: '/etc/passwd', b: 'x' }), (view, entry) => {
        view.setUint8(entry + 5, 3);
        view.setUint32(entry + 38, (0o120777 << 16) >>> 0, true);
    });
    assert.deepEqual([...(await unzip(linked)).files.keys()], ['b']);
});

test('a bomb that says its size ends at the limit, before it is inflated', async () => {
    const large = forged(archive({ bomb: 'x' }), (view, entry) => view.setUint32(entry + 24, 100_000_000, true));
    await assert.rejects(unzip(large), TooMuch);
    await assert.rejects(unzip(archive({ bomb: new Uint8Array(601) }), small()), TooMuch);
    await assert.rejects(unzip(archive({ a: new Uint8Array(600), b: new Uint8Array(600) }), small()), TooMuch);
});

test('a bomb that says a smaller size ends at that size', async () => {
    const lying = forged(archive({ bomb: new Uint8Array(100_000_000) }), (view, entry) => view.setUint32(entry + 24, 100, true));
    const before = process.memoryUsage().arrayBuffers;
    const { files, messages } = await unzip(lying, small());
    assert.equal(files.size, 0);
    assert.match(messages[0], /larger than the archive says/);
    assert.ok(process.memoryUsage().arrayBuffers - before < 50_000_000);
});

test('entries that share their bytes count each time', async () => {
    const one = archive({ a: new Uint8Array(500) });
    const view = new DataView(one.buffer, one.byteOffset);
    const entry = entries(one)[0];
    const end = one.length - 22;
    const record = one.slice(entry, end);
    const records = Array.from({ length: 3 }, (_, i) => {
        const copy = record.slice();
        copy[46] = 'a'.charCodeAt(0) + i;
        return copy;
    });
    const tail = one.slice(end);
    new DataView(tail.buffer).setUint16(10, 3, true);
    const bytes = Buffer.concat([one.subarray(0, entry), ...records, tail]);
    assert.equal(view.getUint32(end + 16, true), entry);
    await assert.rejects(unzip(new Uint8Array(bytes), small()), TooMuch);
});

test('more files than allowed', async () => {
    const many = Object.fromEntries(Array.from({ length: 11 }, (_, i) => [`f${i}`, '']));
    await assert.rejects(unzip(archive(many), small()), TooMuch);
});

test('what the page cannot read is said', async () => {
    const one = archive({ a: 'text text text text', b: 'x' });
    const said = async (change: (view: DataView, entry: number) => void) => (await unzip(forged(one, change))).messages.join();
    assert.match(await said((view, entry) => view.setUint16(entry + 8, 1, true)), /'a'.*encrypted/);
    assert.match(await said((view, entry) => view.setUint16(entry + 10, 14, true)), /method/);
    assert.match(await said((view, entry) => view.setUint32(entry + 16, 7, true)), /damaged/);
    assert.match(await said((view, entry) => view.setUint32(entry + 24, 400, true)), /smaller/);
    await assert.rejects(said((view, entry) => view.setUint32(entry + 24, 0xffffffff, true)), /ZIP64/);
    await assert.rejects(unzip(utf8('this is no archive, whatever its name says')), BadArchive);
    await assert.rejects(unzip(new Uint8Array(0)), BadArchive);
});

test('an archive that is cut or changed anywhere gives an error or files, and nothing else', async () => {
    const one = archive({ 'a.glib': 'Sphere 1\n'.repeat(20), 'b.frag': 'void main() {}\n'.repeat(20) });
    for (let i = 0; i < one.length; ++i) {
        const changed = one.slice();
        changed[i] ^= 1 << i % 8;
        for (const bytes of [changed, one.slice(0, i)]) {
            try {
                const { files } = await unzip(bytes, new Budget({ files: 10, bytes: 10_000, fileBytes: 10_000 }));
                for (const name of files.keys()) assert.ok('name' in cleanName(name));
            } catch (error) {
                assert.ok(error instanceof BadArchive || error instanceof TooMuch, String(error));
            }
        }
    }
});

test('the same files give the same archive, in any order and time zone', () => {
    const files: [string, Uint8Array][] = [['b', utf8('2')], ['a/c', utf8('1')], ['10', utf8('3')]];
    const zone = process.env.TZ;
    process.env.TZ = 'Asia/Tokyo';
    const first = zip(new Map(files));
    process.env.TZ = 'America/New_York';
    assert.deepEqual(zip(new Map(files.reverse())), first);
    if (zone === undefined) delete process.env.TZ;
    else process.env.TZ = zone;
});

test('names of a scene lead to files, and never above the topmost folder', () => {
    assert.equal(resolve('light/glass/', '../room.glsl'), 'light/room.glsl');
    assert.equal(resolve('glass/', '..\\..\\..\\environments/room.inc'), 'environments/room.inc');
});

test('tabs tell files of one name apart', () => {
    const short = shortNames(['a/x.frag', 'b/x.frag', 'b/y.frag', 'x.frag']);
    assert.deepEqual([...short.values()], ['a/x.frag', 'b/x.frag', 'y.frag', 'x.frag']);
});
