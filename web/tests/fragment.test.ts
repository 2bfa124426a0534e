// The state in the page's address, and addresses that anyone may have made.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fragmentOf, readFragment } from '../page/viewer/fragment.ts';
import { safeLink, sceneOf } from '../page/viewer/load.ts';

test('an address gives back what was written, for any names', () => {
    const settings = {
        values: ['Glass.uEta=1.3', 'A b&c#2.uColor=1,0.5,0', 'Über.x=-1e-05'],
        rungs: ['FRESNEL=exact', 'BEND=a & b=c'],
        ranges: ['A b&c#2.uColor=0,2.5'],
        view: 'rotate_x=30,scale=1.2',
        time: 1.5,
        split: 0.25,
    };
    const text = fragmentOf(settings);
    assert.match(text, /^[\w.~%=&,:/!'()*-]+$/);
    assert.deepEqual(readFragment(`#${text}`), { settings, refused: [] });
    assert.ok(text.startsWith('Glass.uEta=1.3&'));
    assert.ok(text.includes('&view=rotate_x=30,scale=1.2&'), 'people can read it');
});

test('nothing changed is an empty address', () => {
    assert.equal(fragmentOf({ values: [], rungs: [], ranges: [], view: '' }), '');
    assert.deepEqual(readFragment(''), { settings: { values: [], rungs: [], ranges: [], view: '' }, refused: [] });
});

test('what is no setting is refused and named', () => {
    const bad = ['%zz=1', 'abc', '=1', 'Glass.uEta=', 'time=-1', 'time=1e9', 'time=NaN', 'split=2', 'split=', 'a%00.b=1', 'view=%0a'];
    for (const text of bad) {
        const { settings, refused } = readFragment(`#${text}`);
        assert.equal(refused.length, 1, text);
        assert.deepEqual([settings.values, settings.rungs, settings.ranges, settings.view, settings.time, settings.split], [[], [], [], '', undefined, undefined], text);
    }
});

test('a very long address is refused as a whole', () => {
    const { settings, refused } = readFragment('#' + 'G.u=1&'.repeat(10_000));
    assert.deepEqual(settings.values, []);
    assert.equal(refused.length, 1);
});

test('the data of a page has the types that the page expects', () => {
    assert.equal(sceneOf('null'), undefined);
    assert.equal(sceneOf('{"scene":5}'), undefined);
    const data = sceneOf('{"scene":"a.glib","values":["A.b=1",5,null],"rungs":"x","view":{},"link":"javascript:alert(1)"}')!;
    assert.deepEqual(data, { scene: 'a.glib', title: '', values: ['A.b=1'], rungs: [], view: '', link: '' });
    assert.equal(safeLink('https://example.org/a'), 'https://example.org/a');
    assert.equal(safeLink(' data:text/html,x'), '');
});
