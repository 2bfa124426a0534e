// Answers of the worker: late ones, none, and those of a text that is no longer there.
import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { makeChecker, type Thread } from '../page/editor/checker.ts';
import { merged, summary } from '../page/editor/problems.ts';
import { cannotAdd, missingFiles, placed, plan } from '../page/editor/intake.ts';
import { serve, type Answer, type Job, type Scope, type Start } from '../page/worker.ts';
import type { Problem } from '../page/engine.ts';

const utf8 = (text: string) => new TextEncoder().encode(text);
const files = (text: string) => new Map([['a.glib', utf8(text)]]);
const problem = (message: string): Problem => ({ severity: 'error', code: 'c', message, help: '', text: message });

class Fake implements Thread {
    jobs: Job[] = [];
    ended = false;
    onmessage: Thread['onmessage'] = null;
    onerror: Thread['onerror'] = null;
    postMessage(message: Start | Job) {
        if (message.kind !== 'start') this.jobs.push(message);
    }
    terminate() {
        this.ended = true;
    }
    say(answer: Answer) {
        this.onmessage?.({ data: answer } as MessageEvent<Answer>);
    }
    answer(message: string) {
        this.say({ kind: 'checked', id: this.jobs.at(-1)!.id, problems: [problem(message)] });
    }
}

function setUp(milliseconds = 10_000) {
    const threads: Fake[] = [];
    const said: string[] = [];
    const spawn = () => {
        threads.push(new Fake());
        return threads.at(-1)!;
    };
    const checker = makeChecker({ spawn, say: (message) => said.push(message), milliseconds });
    return { checker, threads, said };
}

const messages = (checked: Awaited<ReturnType<ReturnType<typeof setUp>['checker']['check']>>) =>
    checked.state === 'done' ? checked.problems.map(({ message }) => message) : checked.state;

test('the newest text is checked, and answers about older ones are dropped', async () => {
    const { checker, threads } = setUp();
    const first = checker.check('a.glib', files('1'));
    threads[0].say({ kind: 'ready' });
    const second = checker.check('a.glib', files('2'));
    const third = checker.check('a.glib', files('3'));
    assert.equal(messages(await second), 'replaced');
    threads[0].answer('of the first text');
    assert.equal(messages(await first), 'replaced');
    threads[0].answer('of the third text');
    assert.deepEqual(messages(await third), ['of the third text']);
    assert.equal(threads[0].jobs.length, 2);
});

test('the worker gets only the files that are new to it', async () => {
    const { checker, threads } = setUp();
    const image = utf8('pixels');
    const with_ = (text: string) => new Map([...files(text), ['image.png', image] as const]);
    const first = checker.check('a.glib', with_('1'));
    threads[0].say({ kind: 'ready' });
    threads[0].answer('');
    await first;
    void checker.check('a.glib', with_('2'));
    threads[0].answer('');
    void checker.check('b.glib', new Map([['b.glib', utf8('')]]));
    const [one, two, three] = threads[0].jobs as Extract<Job, { kind: 'check' }>[];
    assert.deepEqual(one.changed.map(([name, { length }]) => [name, length]), [['a.glib', 1], ['image.png', 0]]);
    assert.deepEqual(two.changed.map(([name]) => name), ['a.glib']);
    assert.deepEqual([three.changed.map(([name]) => name), three.removed], [['b.glib'], ['a.glib', 'image.png']]);
    checker.stop();
});

test('a worker without an answer is ended, said so, and started again with all files', async () => {
    mock.timers.enable({ apis: ['setTimeout'] });
    const { checker, threads, said } = setUp();
    const first = checker.check('a.glib', files('endless'));
    threads[0].say({ kind: 'ready' });
    mock.timers.tick(10_000);
    assert.equal(messages(await first), 'stopped');
    assert.ok(threads[0].ended);
    assert.match(said[0], /more than 10 s/);
    const second = checker.check('a.glib', files('good'));
    assert.equal(threads.length, 2);
    threads[0].answer('too late');
    threads[1].say({ kind: 'ready' });
    threads[1].answer('good');
    assert.deepEqual(messages(await second), ['good']);
    mock.timers.reset();
});

test('a worker that fails at a text is started again', async () => {
    const { checker, threads, said } = setUp();
    const first = checker.check('a.glib', files('1'));
    threads[0].say({ kind: 'ready' });
    threads[0].onerror?.({} as ErrorEvent);
    assert.equal(messages(await first), 'stopped');
    assert.match(said[0], /failed/);
    void checker.check('a.glib', files('2'));
    assert.equal(threads.length, 2);
    checker.stop();
});

test('without a worker nobody waits', async () => {
    const { checker, threads } = setUp();
    const first = checker.check('a.glib', files('1'));
    const decoded = checker.decodeLarge(new Map([['a.png', new Uint8Array(300_000)]]));
    threads[0].say({ kind: 'failed', why: 'no WebAssembly' });
    assert.equal(messages(await first), 'absent');
    assert.equal((await decoded).size, 0);
    assert.equal(messages(await checker.check('a.glib', files('2'))), 'absent');
    assert.equal(threads.length, 1);
});

test('large images are decoded one by one, and checks overtake them', async () => {
    const { checker, threads } = setUp();
    const decoded = checker.decodeLarge(
        new Map([
            ['a.png', new Uint8Array(300_000)],
            ['b.PNG', new Uint8Array(300_000)],
            ['small.png', new Uint8Array(10)],
            ['large.obj', new Uint8Array(300_000)],
        ]),
    );
    threads[0].say({ kind: 'ready' });
    const checked = checker.check('a.glib', files('1'));
    threads[0].say({ kind: 'decoded', id: threads[0].jobs[0].id, image: utf8('SNELLIMG') });
    threads[0].answer('');
    await checked;
    threads[0].say({ kind: 'decoded', id: threads[0].jobs[2].id });
    assert.deepEqual([...(await decoded).keys()], ['a.png']);
    assert.deepEqual(threads[0].jobs.map(({ kind }) => kind), ['decode', 'check', 'decode']);
});

test('the worker answers with what its engine says', async () => {
    const out: Answer[] = [];
    const held = new Map<string, Uint8Array>();
    const scope: Scope = { onmessage: null, postMessage: (answer) => out.push(answer) };
    serve(scope, async () => ({
        write: (name, bytes) => void held.set(name, bytes),
        remove: (name) => void held.delete(name),
        check: (scene) => [problem(`${scene} of ${[...held.keys()].join()}`)],
        decode: () => 'no image',
    }));
    const send = (data: Start | Job) => scope.onmessage!({ data } as MessageEvent<Start | Job>);
    send({ kind: 'start', runtime: new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0)) });
    await Promise.resolve();
    await Promise.resolve();
    send({ kind: 'check', id: 1, scene: 'a.glib', changed: [['a.glib', utf8('')], ['b', utf8('')]], removed: [] });
    send({ kind: 'check', id: 2, scene: 'a.glib', changed: [], removed: ['b'] });
    send({ kind: 'decode', id: 3, name: 'x.png', bytes: utf8('') });
    assert.deepEqual(out.map(({ kind }) => kind), ['ready', 'checked', 'checked', 'decoded']);
    assert.deepEqual(out[2], { kind: 'checked', id: 2, problems: [problem('a.glib of a.glib')] });
});

test('what both say is said once', () => {
    const [one, two] = [problem('1'), problem('2')];
    assert.deepEqual(merged([one], [structuredClone(one), two]), [one, two]);
    const note: Problem = { ...one, severity: 'note' };
    assert.deepEqual(merged([note], [one, two]), [two, note]);
    assert.equal(summary([one, two, { ...one, severity: 'warning' }]), '2 errors, 1 warning');
    assert.equal(summary([]), 'No problems');
});

const missing = (code: string, message: string, file: string): Problem => ({
    ...problem(message),
    code,
    at: { file, line: 1, column: 1, endLine: 1, endColumn: 1 },
});

test('files without a scene go to where the scene misses them', () => {
    const problems = [
        missing('file-not-found', "there is no file 'img/Wall.png'", 'room/room.glib'),
        missing('file-not-found', "there are no files 'px.bmp', 'nx.bmp' for faces of 'p.bmp'", 'room/room.glib'),
        missing('include-not-found', "'../u.glib' cannot be read", 'room/room.glib'),
        missing('missing-include', "cannot read the included file 'z.glsl'", 'room/sub/b.frag'),
        problem("there is no file 'x'"),
    ];
    assert.deepEqual(missingFiles(problems), ['room/img/Wall.png', 'room/px.bmp', 'room/nx.bmp', 'u.glib', 'room/sub/z.glsl']);
    const open = { scene: 'room/room.glib', files: new Map([['room/sub/b.frag', utf8('')]]), problems };
    const dropped = new Map(['wall.png', 'z.glsl', 'sub/b.frag', 'new/n.txt'].map((name) => [name, utf8(name)]));
    const placedNames = [...placed(dropped, open.scene, open.files, missingFiles(problems)).keys()];
    assert.deepEqual(placedNames, ['room/img/Wall.png', 'room/sub/z.glsl', 'room/sub/b.frag', 'room/new/n.txt']);
    assert.equal(plan(dropped, open).kind, 'add');
    assert.equal(plan(new Map([['u.glib', utf8('')]]), open).kind, 'add');
    assert.equal(plan(new Map([['other.glib', utf8('')]]), open).kind, 'open');
    assert.equal(plan(dropped, { scene: '', files: new Map(), problems: [] }).kind, 'no scene');
    assert.equal(plan(new Map(), open).kind, 'nothing');
});

test('added files fit to those that are there', () => {
    const there = new Map([['room/a.glib', utf8('')]]);
    assert.equal(cannotAdd(new Map([['room/b.frag', utf8('')], ['room/a.glib', utf8('new')]]), there), '');
    assert.match(cannotAdd(new Map([['room', utf8('')]]), there), /'room' cannot be added: a folder/);
    assert.match(cannotAdd(new Map([['Room/A.glib', utf8('')]]), there), /upper and lower case/);
    const half = new Uint8Array(60 << 20);
    const many = new Map([1, 2, 3, 4, 5].map((i) => [`${i}`, half]));
    assert.match(cannotAdd(many, there), /more than 256 MB together/);
});
