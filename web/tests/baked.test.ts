// Which picture a slider's value shows.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bakedEngine, fitted, nearest, pictureAt } from '../page/baked.ts';
import type { Control } from '../page/engine.ts';

function slider(index: number, type: Control['type'], value: number): Control {
    return {
        index, key: `P.u${index}`, program: 'P', name: `u${index}`, widget: 'slider', type, components: 1, min: 0, max: 4,
        value: [value], initialMin: 0, initialMax: 4, initial: [value], active: true,
    };
}

const axes = [
    { control: slider(0, 'float', 1), values: [0, 1, 4] },
    { control: slider(1, 'int', 2), values: [0, 2] },
];
const scene = { scene: 's.glib', title: 's', baked: { width: 4, height: 2, axes, pictures: ['0', '1', '2', '3', '4', '5'] } };

test('the nearest value is taken, whatever the steps are', () => {
    const values = [0, 1, 4];
    for (const [value, index] of [[-9, 0], [0.4, 0], [0.6, 1], [2.4, 1], [2.6, 2], [99, 2]] as const)
        assert.equal(nearest(values, value), index, String(value));
});

test('the last axis varies fastest', () => {
    const found = [];
    for (const first of axes[0]!.values) for (const second of axes[1]!.values) found.push(pictureAt(axes, [first, second]));
    assert.deepEqual(found, [0, 1, 2, 3, 4, 5]);
});

test('pictures keep their shape in any canvas', () => {
    assert.deepEqual(fitted(4, 2, 8, 8), [0, 2, 8, 4]);
    assert.deepEqual(fitted(4, 2, 8, 2), [2, 0, 4, 2]);
});

test('sliders move, stay within their range, and are reset', () => {
    const engine = bakedEngine(scene, new Map());
    const { shown } = engine.open('s.glib');
    assert.deepEqual(engine.values(), []);
    engine.set(0, 0, 9);
    engine.set(1, 0, 3.4);
    engine.set(1, 0, NaN);
    engine.set(7, 0, 1);
    assert.deepEqual(engine.values(), ['P.u0=4', 'P.u1=3']);
    assert.equal(shown!.controls[0]!.value[0], 4);
    engine.reset(0);
    assert.deepEqual(engine.values(), ['P.u1=3']);
    engine.reset();
    assert.deepEqual(engine.values(), []);
    assert.deepEqual(axes[0]!.control.value, [1]);
});

test('what an address asks for is taken, or named', () => {
    const engine = bakedEngine(scene, new Map());
    const problems = (settings: Parameters<typeof engine.open>[1]) => engine.open('s.glib', settings).problems.map(({ message }) => message);
    assert.deepEqual(problems({ values: ['P.u0=3.5', 'P.u1=2'] }), []);
    assert.deepEqual(engine.values(), ['P.u0=3.5']);
    for (const value of ['P.uC=1', 'P.u0', 'P.u0=', 'P.u0=abc', 'P.u0=1e999', 'P.u0=99', 'P.u1=1.5.5', '__proto__=1'])
        assert.equal(problems({ values: [value] }).length, 1, value);
    assert.equal(problems({ rungs: ['uX=1e999'], view: 'rotate_x=30' }).length, 2);
    assert.deepEqual(problems({ rungs: ['u0=2,5'] }), [], 'a slider without its program, and a decimal comma');
    assert.deepEqual(engine.values(), ['P.u0=2.5']);
    assert.deepEqual(problems({ rungs: ['uX=1'] }), ["there is no slider 'uX'"]);
    assert.deepEqual(problems({ values: ['P.u0=abc', 'P.u0=1e39'] }), [
        "the value 'abc' of 'P.u0' is not a number",
        "the value '1e39' of 'P.u0' is not a number that fits",
    ]);
    assert.deepEqual(problems({ fresh: true }), []);
    assert.deepEqual(engine.values(), []);
});
