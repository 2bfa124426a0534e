// Undo, over a fake engine: what is undone is exactly what was there.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Session } from '../page/viewer/session.ts';
import { FakeEngine } from './fake_engine.ts';

function makeSession() {
    const engine = new FakeEngine();
    const said: string[] = [];
    const nothing = () => {};
    const on = { redraw: nothing, changed: nothing, listed: nothing, problems: nothing, say: (message: string) => void said.push(message) };
    const session = new Session(engine, on);
    session.accept(engine.open('fake.glib'));
    const find = (key: string) => session.controls.find((control) => control.key === key)!;
    return { engine, session, said, find };
}

test('one drag is one step, and undo restores the value of the engine', () => {
    const { engine, session, said, find } = makeSession();
    const gesture = {};
    for (const value of [1.6, 1.7, 1.8]) session.set(find('Glass.uEta'), 0, value, { gesture });
    assert.deepEqual(engine.values(), ['Glass.uEta=1.8']);
    session.undo();
    assert.deepEqual(engine.values(), []);
    assert.equal(said.at(-1), 'Undo: Glass.uEta 1.8 → 1.5');
    assert.equal(session.history.canUndo, false);
    session.redo();
    assert.deepEqual(engine.values(), ['Glass.uEta=1.8']);
});

test('two drags are two steps, and a drag back to its beginning is none', () => {
    const { session, engine, find } = makeSession();
    session.set(find('Glass.uEta'), 0, 2, { gesture: {} });
    const gesture = {};
    session.set(find('Glass.uMix'), 0, 0.5, { gesture });
    session.set(find('Glass.uMix'), 0, 0, { gesture });
    session.history.end();
    session.undo();
    assert.deepEqual(engine.values(), []);
});

test('a typed value outside of the range widens it, and undo narrows it again', () => {
    const { session, engine, find } = makeSession();
    assert.equal(session.set(find('Glass.uEta'), 0, 5), 3);
    assert.equal(session.set(find('Glass.uEta'), 0, 5, { widen: true }), 5);
    assert.equal(engine.controls[0]!.max, 5);
    session.undo();
    assert.equal(engine.controls[0]!.max, 3);
    assert.deepEqual(engine.values(), ['Glass.uEta=3']);
});

test('rungs, the view and a reset of everything are steps', () => {
    const { session, engine, find } = makeSession();
    session.choose(session.ladders[0]!, 2);
    session.changeView(() => engine.turn(20, 10));
    session.set(find('Walls.uOffset'), 1, 0.75);
    session.resetAll();
    assert.deepEqual([engine.values(), engine.rungs()], [[], []]);
    session.undo();
    assert.deepEqual([engine.values(), engine.rungs()], [['Walls.uOffset=0,0.75,-0.5'], ['BEND=bounces']]);
    session.undo();
    session.undo();
    assert.equal(engine.view(), '');
    session.undo();
    assert.deepEqual(engine.rungs(), []);
    assert.equal(session.history.canUndo, false);
});

test('a new change ends what could be redone, and at most 200 steps are kept', () => {
    const { session, engine, find } = makeSession();
    for (let i = 1; i <= 250; ++i) session.set(find('Walls.uGloss'), 0, i % 100);
    for (let i = 0; i < 300; ++i) session.undo();
    assert.deepEqual(engine.values(), ['Walls.uGloss=50']);
    session.set(find('Glass.uMix'), 0, 1);
    assert.equal(session.history.canRedo, false);
});

test('steps of what the scene no longer has are skipped', () => {
    const { session, engine, find } = makeSession();
    session.set(find('Glass.uMix'), 0, 1);
    session.set(find('Walls.uSeed'), 0, 5);
    session.shown!.controls = session.shown!.controls.filter(({ key }) => key !== 'Walls.uSeed');
    session.undo();
    session.undo();
    assert.deepEqual(engine.values(), ['Walls.uSeed=5']);
});
