// Bytes of files that were not edited come back, and places of messages are those of the text.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EditorState } from '@codemirror/state';
import { isText, read, unwritable, usualEnd, write } from '../page/editor/bytes.ts';
import { bytesOf, isEdited, makeDocument, textFiles } from '../page/editor/documents.ts';
import { columnOf, offsetOf, rangeOf } from '../page/editor/places.ts';

const utf8 = (text: string) => new TextEncoder().encode(text);
const latin = (text: string) => Uint8Array.from(text, (character) => character.charCodeAt(0));
const plain = { bom: false, encoding: 'utf-8' } as const;
const single = { bom: false, encoding: 'windows-1252' } as const;

// A document that no view shows.
const documentOf = (bytes: Uint8Array) => makeDocument('a.txt', bytes, () => [], () => []);

function edited(bytes: Uint8Array, from: number, to: number, insert: string): Uint8Array {
    const document = documentOf(bytes);
    document.state = document.state.update({ changes: { from, to, insert } }).state;
    return bytesOf(document);
}

test('any bytes without an edit are the same bytes', () => {
    const samples = [
        utf8(''),
        utf8('\n'),
        utf8('a\r\nb\nc\rd\r\n\r\n'),
        utf8('\ufeffé 😀\u2028 x'),
        latin('caf\xe9 \x80\x81\x9d\xff\r\n'),
        latin('\xc3\xa9 mixed \xe9'),
        latin('\xef\xbb\xbf\xe9'),
        latin('\xed\xa0\x80 a surrogate'),
        Uint8Array.from({ length: 256 }, (_, i) => i),
    ];
    for (const bytes of samples) {
        assert.deepEqual(write(read(bytes)), new Uint8Array(bytes));
        assert.equal(bytesOf(documentOf(bytes)), bytes);
    }
});

test('an edit changes nothing else', () => {
    const mixed = 'a\r\nb\nc\rd\r\n';
    assert.deepEqual(edited(utf8(mixed), 2, 3, 'B!'), utf8('a\r\nB!\nc\rd\r\n'));
    assert.deepEqual(edited(latin('caf\xe9\r\nx\r\n'), 5, 6, 'yz'), latin('caf\xe9\r\nyz\r\n'));
    assert.deepEqual(edited(utf8('\ufeffab\r\n'), 1, 1, '-'), utf8('\ufeffa-b\r\n'));
});

test('new lines get the usual end of the file, and others keep theirs', () => {
    const bytes = utf8('a\r\nb\r\nc\nd');
    assert.deepEqual(edited(bytes, 1, 1, '\nx'), utf8('a\r\nx\r\nb\r\nc\nd'));
    assert.deepEqual(edited(bytes, 5, 6, ''), utf8('a\r\nb\r\ncd'));
    assert.deepEqual(edited(bytes, 2, 4, ''), utf8('a\r\nc\nd'));
    assert.equal(usualEnd([]), '\n');
});

test('two edits at once in lines with different ends', () => {
    const document = documentOf(utf8('a\r\nb\nc\rd'));
    const changes = [
        { from: 1, insert: '\n1\n2' },
        { from: 4, to: 6, insert: '+' },
    ];
    document.state = document.state.update({ changes }).state;
    assert.equal(document.state.doc.toString(), 'a\n1\n2\nb\n+d');
    const ends = document.state.field(document.ends);
    assert.equal(ends.length, document.state.doc.lines - 1);
    assert.deepEqual([...ends], ['\r\n', '\r\n', '\r\n', '\n']);
});

test('an edit that is undone leaves the file as it was', () => {
    const document = documentOf(utf8('a\r\nb'));
    document.state = document.state.update({ changes: { from: 0, insert: 'x\n' } }).state;
    assert.ok(isEdited(document));
    document.state = document.state.update({ changes: { from: 0, to: 2 } }).state;
    assert.ok(!isEdited(document));
});

test('what Windows-1252 lacks is found before it is written', () => {
    assert.deepEqual(unwritable('é\n', single), []);
    assert.deepEqual(unwritable('→a→', single), ['→']);
    assert.deepEqual(unwritable('→', plain), []);
});

test('text is told from other files', () => {
    assert.ok(isText('a.frag', utf8('void main() {}')));
    assert.ok(isText('README', latin('caf\xe9')));
    assert.ok(!isText('a.frag', utf8('\0')));
    assert.ok(!isText('mesh.obj', utf8('v 0 0 0')));
});

test('columns count characters, also beyond the basic plane', () => {
    const line = '\té😀x';
    assert.deepEqual([1, 2, 3, 4, 5, 9].map((column) => offsetOf(line, column, plain)), [0, 1, 2, 4, 5, 5]);
    assert.deepEqual([0, 1, 2, 4, 5].map((offset) => columnOf(line, offset, plain)), [1, 2, 3, 4, 5]);
});

test('in text that is not UTF-8, what is UTF-8 in it counts as one column', () => {
    // As the messages count it: each byte that is not valid is one character.
    const bytes = latin('\xe9\xc3\xa9\xf0\x9f\x98\x80\xed\xa0\x80x');
    const line = read(bytes).lines[0];
    assert.equal(line.length, bytes.length);
    assert.deepEqual([1, 2, 3, 4, 5, 6, 7, 8].map((column) => offsetOf(line, column, single)), [0, 1, 3, 7, 8, 9, 10, 11]);
});

test('a mark is seen: it has a character where the line has one', () => {
    const doc = EditorState.create({ doc: 'ab\n\n😀' }).doc;
    const at = (line: number, column: number, endLine = line, endColumn = column) =>
        rangeOf({ file: 'a', line, column, endLine, endColumn }, doc, plain);
    assert.deepEqual(at(1, 2, 1, 3), { from: 1, to: 2 });
    assert.deepEqual(at(1, 1), { from: 0, to: 1 });
    assert.deepEqual(at(1, 3), { from: 1, to: 2 });
    assert.deepEqual(at(2, 1), { from: 3, to: 3 });
    assert.deepEqual(at(3, 2), { from: 4, to: 6 });
    assert.deepEqual(at(99, 99), { from: 4, to: 6 });
    assert.deepEqual(at(0, 0), { from: 0, to: 1 });
});

test('of a folder with many scenes, the first tabs are the texts of the one that is open', () => {
    const texts = {
        'class/ann/ball.frag': '', 'class/ann/ball.glib': 'Sphere 1\n', 'class/ann/notes.txt': '', 'class/shared/light.frag': '',
        'class/bob/ball.frag': '', 'class/bob/ball.glib': 'Vertex ../shared/all.vert\nFragment ball.frag\n', 'class/bob/other.glib': '',
        'class/shared/all.vert': '',
    };
    const files = new Map(Object.entries(texts).map(([name, text]) => [name, utf8(text || 'x\n')]));
    assert.deepEqual(textFiles('class/bob/ball.glib', files), [
        'class/bob/ball.glib', 'class/bob/ball.frag', 'class/shared/all.vert', 'class/bob/other.glib', 'class/ann/ball.glib',
        'class/ann/ball.frag', 'class/shared/light.frag', 'class/ann/notes.txt',
    ]);
});
