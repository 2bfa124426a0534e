// The archive of a page, which anyone may have made.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { filesOf, gunzip, mostFiles, nameProblem, unpack } from '../page/archive.ts';

function archive(files: unknown, bytes = ''): Uint8Array {
    return new TextEncoder().encode(JSON.stringify({ files }) + '\n' + bytes);
}

test('files come out as they went in', async () => {
    const all = archive([{ name: 'a/s.glib', size: 3, decoded: false }, { name: 'ä.png', size: 2, decoded: false }], 'abc\0\n');
    const text = Buffer.from(gzipSync(all)).toString('base64');
    const { files, originals } = await unpack(text);
    assert.deepEqual([...files.keys()], ['a/s.glib', 'ä.png']);
    assert.equal(new TextDecoder().decode(files.get('a/s.glib')), 'abc');
    assert.deepEqual([...files.get('ä.png')!], [0, 10]);
    assert.equal(originals.size, 0);
});

test('the pixels of a BMP image are as they were, and rows that are none are refused', () => {
    const pixels = Uint8Array.from({ length: 36 }, (_, i) => (i * 37) ^ (i >> 2)); // four rows of three pixels
    const packed = pixels.map((byte, i) => {
        const [left, above, corner] = [3, 9, 12].map((back) => pixels[i - back] ?? 0) as [number, number, number];
        const guess = left + above - corner;
        return byte - [left, above, corner].reduce((best, each) => (Math.abs(guess - each) < Math.abs(guess - best) ? each : best));
    });
    const all = (rows: unknown) => new Uint8Array([...archive([{ name: 'a.bmp', size: 40, decoded: false, rows }], 'head'), ...packed]);
    const { files } = filesOf(all([4, 3, 9]));
    assert.deepEqual(files.get('a.bmp'), new Uint8Array([...new TextEncoder().encode('head'), ...pixels]));
    for (const rows of [[4, 3], [4, 0, 9], [4, 3, -9], [4, 3, 1e300], 'x', [4, 3, '9']]) assert.throws(() => filesOf(all(rows)), /no numbers of bytes/);
});

test('a page without a scene has no files', async () => {
    assert.equal((await unpack(' \n')).files.size, 0);
});

test('a decoded image takes the place of its file, which is kept', () => {
    const twins = [{ name: 'a.exr', size: 1, decoded: false }, { name: 'a.exr', size: 2, decoded: true }];
    const { files, originals } = filesOf(archive(twins, 'xyz'));
    assert.equal(new TextDecoder().decode(files.get('a.exr')), 'yz');
    assert.equal(new TextDecoder().decode(originals.get('a.exr')), 'x');
});

test('hostile names are refused', () => {
    const bad = ['', '/a', '../a', 'a/../b', 'a/..', '.', './a', 'a//b', 'a/', 'a\0b', 'a\nb', 'a\\..\\b', 'C:/a', 'x'.repeat(2000)];
    for (const name of bad) {
        assert.notEqual(nameProblem(name), '', JSON.stringify(name));
        assert.throws(() => filesOf(archive([{ name, size: 0, decoded: false }])), Error, JSON.stringify(name));
    }
    for (const name of ['a', 'a/b.c', '..a', 'a..', '<b>.png', '__proto__', 'constructor'])
        assert.ok(filesOf(archive([{ name, size: 1, decoded: false }], 'x')).files.has(name), name);
});

test('sizes that lie are refused', () => {
    for (const size of [2, -1, 1.5, 1e300, NaN, '1', null, undefined])
        assert.throws(() => filesOf(archive([{ name: 'a', size, decoded: false }], 'x')), Error, String(size));
    assert.throws(() => filesOf(archive([{ name: 'a', size: 1, decoded: false }], 'xy')), /longer/);
});

test('damaged lists are refused', () => {
    for (const files of [null, 1, 'x', {}, [null], [1], [{}]]) assert.throws(() => filesOf(archive(files)), Error);
    for (const text of ['', '\n', 'null\n', '{"files":[]', 'no json\n'])
        assert.throws(() => filesOf(new TextEncoder().encode(text)), Error, text);
    const one = { name: 'a', size: 0, decoded: false };
    assert.throws(() => filesOf(archive([one, one])), /twice/);
    assert.throws(() => filesOf(archive([{ ...one, decoded: true }])), /twice/);
    assert.throws(() => filesOf(archive([one, { ...one, name: 'a/b' }])), /folder/);
    assert.throws(() => filesOf(archive([{ ...one, name: 'x/a/b' }, { ...one, name: 'x' }])), /folder/);
    const many = Array.from({ length: mostFiles + 1 }, (_, i) => ({ ...one, name: `f${i}` }));
    assert.throws(() => filesOf(archive(many)), /more than/);
});

test('a bomb ends early', async () => {
    const bomb = new Uint8Array(gzipSync(new Uint8Array(64 << 20)));
    assert.ok(bomb.length < 100_000);
    await assert.rejects(gunzip(bomb, 1 << 20), /larger/);
    await assert.rejects(gunzip(new Uint8Array([1, 2, 3]), 1 << 20));
});
