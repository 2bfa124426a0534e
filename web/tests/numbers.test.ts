// Numbers of sliders: as they are shown, typed, rounded and reached by the track and by keys.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { evaluated, shown, tidy, tidyColor, typed, whyNot } from '../page/viewer/numbers.ts';
import { fractionOf, stepped, stepsOf, valueAt } from '../page/viewer/steps.ts';
import { hexOf, picked } from '../page/viewer/values.ts';

test('arithmetic is that of doubles', () => {
    const right: [string, number][] = [
        ['1/3', 1 / 3], ['2*pi', 2 * Math.PI], ['1e3-5', 995], ['2+3*4', 14], ['(2+3)*4', 20], ['-2', -2], ['2--3', 5],
        ['2*-3', -6], ['8/4/2', 1], [' ( 1,5 + .5 ) ', 2], ['-(1-3)', 2], ['+1.5', 1.5], ['5.', 5], ['1-2-3', -4], ['0,7', 0.7],
    ];
    for (const [text, value] of right) assert.equal(evaluated(text), value, text);
});

test('what is no finite number is refused', () => {
    const wrong = ['', ' ', '1/0', '0/0', 'nan', 'inf', '1 2', '1,2,3', '(1', '1)', '2*', '*2', 'pi2', '--1', '1e400', '0x10', 'abc', '()', '2(3)'];
    for (const text of wrong) assert.equal(evaluated(text), undefined, text);
    assert.equal(evaluated('('.repeat(100) + '1' + ')'.repeat(100)), 1);
    assert.equal(evaluated('('.repeat(999) + '1'), undefined);
});

test('a typed number fits its type', () => {
    assert.equal(typed('2.6', 'int'), 3);
    assert.equal(typed('3e9', 'int'), undefined);
    assert.equal(typed('3e9', 'uint'), 3e9);
    assert.equal(typed('-1', 'uint'), undefined);
    assert.equal(typed('1e39', 'float'), undefined);
    for (const text of ['1e39', '1e999', '-1e999', '1,5e400', '3e9', '-1']) assert.equal(whyNot(text), ' that fits', text);
    for (const text of ['', ' ', 'abc', '1/0', '1 2']) assert.equal(whyNot(text), '', text);
});

test('what is shown is close enough to see a step', () => {
    for (const [min, max] of [[0, 1], [0.1, 5], [0, 1e-5], [0, 1e-9], [-1e5, 1e5], [0, 1e30]] as const)
        for (const at of [0, 0.137, 0.5, 1]) {
            const value = min + at * (max - min);
            const error = Math.abs(Number(shown(value, min, max, false)) - value);
            assert.ok(error <= (max - min) * 1e-3, `${value} in ${min} … ${max}`);
        }
    assert.equal(shown(1.1, 0.1, 5, false), '1.1000');
    assert.equal(shown(8, 1, 32, true), '8');
});

test('colours have the fewest decimals that give the same byte', () => {
    for (let byte = 0; byte <= 255; ++byte) {
        assert.equal(Math.round(tidyColor(byte / 255) * 255), byte);
        assert.ok(String(tidyColor(byte / 255)).length <= 5);
    }
    assert.equal(tidyColor(209 / 255), 0.82);
});

test('a picked colour changes only the components that were picked', () => {
    const value = [0.123456, 0.5, 2.5, 0.3];
    assert.deepEqual(picked(hexOf(value), value), value);
    const [red, green, blue, alpha] = picked('#ff80ff', value);
    assert.deepEqual([red, green, blue, alpha], [1, 0.5, 2.5, 0.3]);
});

test('dragging reaches both ends, short numbers, and survives extreme ranges', () => {
    const track = { min: 0.1, max: 5, integral: false };
    assert.equal(valueAt(0, track), 0.1);
    assert.equal(valueAt(1, track), 5);
    assert.equal(valueAt(1 / 3, track), 1.7333);
    assert.equal(tidy(0.123456789, 0, 1, true), 0.123457);
    const huge = { min: -1.7e308, max: 1.7e308, integral: false };
    for (const at of [0, 0.25, 0.5, 1]) assert.ok(Math.abs(fractionOf(valueAt(at, huge), huge) - at) < 1e-9);
});

test('keys step by a hundredth, a thousandth and a tenth, whole numbers by one', () => {
    const track = { min: 0, max: 1, integral: false };
    assert.equal(stepped(0.5, stepsOf('ArrowRight', false), track), 0.51);
    assert.equal(stepped(0.5, stepsOf('ArrowDown', true), track), 0.499);
    assert.equal(stepped(0.5, stepsOf('PageUp', false), track), 0.6);
    assert.equal(stepped(0.995, stepsOf('ArrowUp', false), track), 1);
    const whole = { min: 1, max: 32, integral: true };
    assert.equal(stepped(8, stepsOf('ArrowLeft', true), whole), 7);
    assert.equal(stepped(8, stepsOf('PageUp', false), whole), 11);
    assert.equal(stepped(32, stepsOf('ArrowUp', false), whole), 32);
    assert.equal(stepsOf('a', false), 0);
});
