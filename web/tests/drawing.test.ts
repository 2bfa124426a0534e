// How coarse pictures of a drag are, sizes of saved pictures, the sides of the split, and the wheel.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Clock } from '../page/viewer/clock.ts';
import { Coarseness } from '../page/viewer/coarse.ts';
import { limits, sizeProblem } from '../page/viewer/dialogs.ts';
import { sidesOf } from '../page/viewer/divider.ts';
import { stepsOfWheel } from '../page/viewer/gestures.ts';

// Drags for some frames, of which each takes as long as `cost` says for its divisor. Returns the divisors.
function drag(coarse: Coarseness, begin: number, frames: number, cost: (divisor: number) => number): number[] {
    let now = begin;
    return Array.from({ length: frames }, () => {
        const divisor = coarse.next(true, now);
        now += cost(divisor);
        coarse.took(cost(divisor), now);
        return divisor;
    });
}

test('fast pictures stay sharp in a drag, and one slow frame changes nothing', () => {
    const coarse = new Coarseness();
    assert.deepEqual(drag(coarse, 0, 5, () => 16), [1, 1, 1, 1, 1]);
    coarse.took(90, 200);
    assert.equal(coarse.next(true, 210), 1);
});

test('slow pictures become coarser until they are fast, and sharp 150 ms after the last move', () => {
    const coarse = new Coarseness();
    assert.deepEqual(drag(coarse, 0, 5, (divisor) => 80 / divisor ** 2), [1, 1, 2, 2, 2]);
    const due = coarse.due;
    assert.equal(coarse.next(false, due - 1), 2);
    assert.equal(coarse.next(false, due), 1);
    assert.deepEqual(drag(coarse, due + 1000, 3, (divisor) => 120 / divisor), [2, 2, 4]);
});

test('pictures that take longer than the rest of a drag are of the same drag', () => {
    assert.deepEqual(drag(new Coarseness(), 0, 4, (divisor) => 900 / divisor ** 2), [1, 2, 4, 4]);
});

test('a drag that has become fast begins finer the next time', () => {
    const coarse = new Coarseness();
    drag(coarse, 0, 3, () => 50);
    assert.deepEqual(drag(coarse, 1000, 2, () => 10), [2, 2]);
    assert.deepEqual(drag(coarse, 2000, 2, () => 10), [1, 1]);
});

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
