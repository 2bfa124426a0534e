// Sizes of saved pictures, the sides of the split, and the wheel.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Clock } from '../page/viewer/clock.ts';
import { limits, sizeProblem } from '../page/viewer/dialogs.ts';
import { sidesOf } from '../page/viewer/divider.ts';
import { stepsOfWheel } from '../page/viewer/gestures.ts';

test('sizes of pictures are limited', () => {
    assert.equal(sizeProblem(640, 480, 16), '');
    for (const [width, height, samples] of [[0, 1, 1], [1.5, 1, 1], [NaN, 1, 1], [limits.side + 1, 1, 1], [8192, 8192, 1], [1, 1, 0], [1, 1, 65]] as const)
        assert.notEqual(sizeProblem(width, height, samples), '');
});

test('only ladders that differ from the reference are named at the split', () => {
    const bend = { index: 0, name: 'BEND', rungs: ['single', 'bounces'], chosen: 0, marked: 0, reference: 1 };
    const other = { index: 1, name: 'FRESNEL', rungs: ['schlick', 'exact'], chosen: 1, marked: 0, reference: 1 };
    assert.deepEqual(sidesOf([bend, other]), { left: 'BEND: single', right: 'bounces' });
    assert.deepEqual(sidesOf([other]), { left: 'reference', right: 'reference' });
});

test('the wheel is the same in pixels and in lines, and one turn is bounded', () => {
    assert.equal(stepsOfWheel({ deltaX: 0, deltaY: 100, deltaMode: 0 }), -1);
    assert.equal(stepsOfWheel({ deltaX: 0, deltaY: -3, deltaMode: 1 }), 1);
    assert.equal(stepsOfWheel({ deltaX: -100, deltaY: 0, deltaMode: 0 }), 1);
    assert.equal(stepsOfWheel({ deltaX: 0, deltaY: 1e9, deltaMode: 2 }), -5);
});

test('time runs at its speed, stands while paused, and does not jump after a pause', () => {
    const clock = new Clock();
    clock.playing = true;
    clock.speed = 2;
    clock.advance(1000);
    clock.advance(1100);
    assert.ok(Math.abs(clock.time - 0.2) < 1e-12);
    clock.hold();
    clock.advance(9000);
    assert.ok(Math.abs(clock.time - 0.2) < 1e-12);
    clock.playing = false;
    clock.advance(9100);
    assert.ok(Math.abs(clock.time - 0.2) < 1e-12);
});
