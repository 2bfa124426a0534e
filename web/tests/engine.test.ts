// The engine in Chromium, against the native program on the same version of OpenGL ES.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import type { JSHandle, Page, Browser } from 'puppeteer-core';
import type { EnginePage, Files } from './engine_page.ts';

const require = createRequire(join(process.cwd(), 'package.json'));
const root = join(process.cwd(), '..');
const snell = process.env.SNELL ?? join(root, 'build/release/bin/snell');
const built = process.env.SNELL_ENGINE ?? join(root, 'build/web/engine');

let browser: Browser;
let page: Page;
let said: string[] = [];

function filesBelow(folder: string, prefix = ''): Files {
    const files: Files = {};
    for (const name of readdirSync(join(root, folder, prefix))) {
        const path = join(prefix, name);
        if (statSync(join(root, folder, path)).isDirectory()) Object.assign(files, filesBelow(folder, path));
        else files[path] = readFileSync(join(root, folder, path)).toString('base64');
    }
    return files;
}

const text = (files: Files, name: string) => Buffer.from(files[name]!, 'base64').toString();

async function bundle(): Promise<string> {
    const code = `import make from ${JSON.stringify(join(built, 'snell.js'))};
        import { EnginePage } from './engine_page.ts';
        Object.assign(globalThis, { make, EnginePage });`;
    const result = await require('esbuild').build({
        stdin: { contents: code, resolveDir: join(process.cwd(), 'tests'), loader: 'ts' },
        bundle: true,
        format: 'iife',
        write: false,
        external: ['module', 'fs', 'path', 'url'],
    });
    return result.outputFiles[0].text;
}

async function started(): Promise<JSHandle<EnginePage>> {
    const wasm = readFileSync(join(built, 'snell.wasm')).toString('base64');
    return page.evaluateHandle((wasm) => {
        const { make, EnginePage } = globalThis as unknown as Record<string, never>;
        return (EnginePage as unknown as { start(...args: unknown[]): Promise<EnginePage> }).start(make, wasm);
    }, wasm);
}

// The same driver as the browser's gives the same bytes. Another rounds filtered textures and edges in its own way.
const angle = join(root, 'build/drivers/angle');
const sameDriver = existsSync(angle);
const driver = sameDriver
    ? { LD_LIBRARY_PATH: angle, ANGLE_DEFAULT_PLATFORM: 'swiftshader' }
    : { MESA_GLES_VERSION_OVERRIDE: '3.0' };

// The picture that the native program draws, as RGBA.
async function native(scene: string, size: string): Promise<number[]> {
    const out = mkdtempSync(join(tmpdir(), 'snell-engine-'));
    try {
        const png = join(out, 'picture.png');
        const { status, stderr } = spawnSync(
            snell,
            ['render', scene, '-o', png, '--size', size, '--context', 'es3.0', '--no-specialise'],
            { cwd: root, env: { ...process.env, ...driver }, encoding: 'utf8' },
        );
        assert.equal(status, 0, stderr);
        return await page.evaluate((png) => {
            const { EnginePage } = globalThis as unknown as { EnginePage: { pixels(png: string): Promise<number[]> } };
            return EnginePage.pixels(png);
        }, readFileSync(png).toString('base64'));
    } finally {
        rmSync(out, { recursive: true });
    }
}

// The share of pixels with a difference of at most 2 of 255.
function alike(a: number[], b: number[]): number {
    assert.equal(a.length, b.length);
    let same = 0;
    for (let i = 0; i < a.length; i += 4) {
        const near = (c: number) => Math.abs(a[i + c]! - b[i + c]!) <= 2;
        if (near(0) && near(1) && near(2)) same += 1;
    }
    return same / (a.length / 4);
}

function spread(picture: number[]): number {
    return new Set(picture.filter((_, i) => i % 4 === 0)).size;
}

before(async () => {
    browser = await require('puppeteer-core').launch({
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader'],
    });
    page = await browser.newPage();
    page.on('console', (message) => {
        // Reading a picture back waits for it, as the driver remarks.
        if (!message.text().includes('GPU stall due to ReadPixels')) said.push(message.text());
    });
    page.on('pageerror', (error) => said.push(String(error)));
    await page.addScriptTag({ content: await bundle() });
});

after(async () => {
    await browser.close();
    assert.deepEqual(said, [], 'nothing was written to the console');
});

const room = 'refraction-room/refraction-room.glib';
const frame = { time: 0, width: 400, height: 300 };

test('the refraction room looks as the native program draws it', async () => {
    const engine = await started();
    const opened = await engine.evaluate((e, files, room) => e.open(files, room), filesBelow('scenes'), room);
    assert.deepEqual(opened.problems, []);
    assert.ok(opened.ok);
    const picture = await engine.evaluate((e, frame) => e.picture(frame), frame);
    assert.ok(spread(picture) > 50, 'it shows something');
    const expected = await native(`scenes/${room}`, '400x300');
    const share = alike(picture, expected);
    assert.ok(share >= (sameDriver ? 0.999 : 0.99), `${share} of the pixels are alike`);
    assert.equal(await engine.evaluate((e) => e.error()), 0);
});

test('the canvas shows the picture with four samples', async () => {
    const engine = await started();
    await engine.evaluate((e, files, room) => e.open(files, room), filesBelow('scenes'), room);
    const shown = await engine.evaluate((e, frame) => e.shown(frame), frame);
    const picture = await engine.evaluate((e, frame) => e.picture(frame, 4), frame);
    assert.ok(alike(shown, picture) === 1);
    assert.ok(spread(shown) > 50);
});

// The pixels of the columns from `left` to `right`.
function columns(picture: number[], left: number, right: number): number[] {
    return picture.filter((_, i) => {
        const x = Math.floor(i / 4) % frame.width;
        return x >= left && x < right;
    });
}

test('left of the split are the chosen rungs, right of it the references', async () => {
    const engine = await started();
    const scene = 'light/fresnel/fresnel.glib';
    const opened = await engine.evaluate((e, files, scene) => e.open(files, scene), filesBelow('scenes'), scene);
    const ladders = opened.shown!.ladders;
    assert.ok(ladders.length > 0);
    const [chosen, both] = await engine.evaluate(
        (e, count, frame) => {
            for (let i = 0; i < count; ++i) e.engine.choose(i, 0);
            return [e.picture(frame), e.picture({ ...frame, split: 0.5 })];
        },
        ladders.length, frame);
    const reference = await engine.evaluate(
        (e, ladders, frame) => {
            for (const ladder of ladders) e.engine.choose(ladder.index, ladder.reference);
            return e.picture(frame);
        },
        ladders, frame);
    assert.ok(alike(chosen!, reference) < 0.999, 'the rungs differ');
    assert.deepEqual(columns(both!, 0, 200), columns(chosen!, 0, 200));
    assert.deepEqual(columns(both!, 200, 400), columns(reference, 200, 400));
});

test('what is set by name, turned and moved is what state() says', async () => {
    const engine = await started();
    const opened = await engine.evaluate((e, files, room) => e.open(files, room), filesBelow('scenes'), room);
    const slider = opened.shown!.controls.find((control) => control.widget === 'slider')!;
    const [values, view, wrong] = await engine.evaluate(
        (e, room, value) => {
            const { problems } = e.engine.open(room, { values: [value, 'Glass.uNone=1'], view: 'rotate_x=30', lints: false });
            e.engine.turn(20, 0, true);
            e.engine.zoom(2);
            e.engine.move(0, -10, 400, 300);
            const { values, view } = e.engine.state();
            return [values, view, problems.length] as const;
        },
        room, `${slider.key}=${slider.max}`);
    assert.deepEqual(values, [`${slider.key}=${slider.max}`]);
    assert.match(view, /^rotate_x=30,rotate_y=10,scale=2,y=[.0-9]+$/);
    assert.equal(wrong, 1);
});

test('a gesture is one step of undo, and what is undone is what was there', async () => {
    const engine = await started();
    const [steps, said] = await engine.evaluate((e) => {
        const { session, said } = e.session();
        const index = (name: string) => session.controls.find((control) => control.name === name)!.index;
        const steps: [string[], string[], string, boolean][] = [];
        const note = () => {
            const { values, ranges, view, canUndo } = session.state;
            steps.push([values, ranges, view, canUndo]);
        };
        const gesture = {};
        for (const at of [0.25, 0.5]) session.change(() => e.engine.slide(index('uA'), 0, at), gesture);
        session.end();
        note();
        session.change(() => e.engine.set(index('uA'), 0, 20, false));
        session.change(() => e.engine.set(index('uA'), 0, 20, true));
        note();
        session.change(() => e.engine.turn(20, 10, true));
        session.reset(session.controls[0]!);
        session.resetAll();
        note();
        for (let i = 0; i < 4; ++i) {
            session.go(false);
            note();
        }
        session.go(true);
        note();
        // A drag back to where it began is no step.
        const other = {};
        for (const at of [0.5, 0]) session.change(() => e.engine.slide(index('uMix'), 0, at), other);
        session.end();
        session.go(false);
        note();
        return [steps, said] as const;
    });
    const turned = 'rotate_x=5,rotate_y=10';
    assert.deepEqual(steps, [
        [['P.uA=5.5'], [], '', true],
        [['P.uA=20'], ['P.uA=1,20'], '', true],
        [[], [], turned, true],
        [['P.uA=20'], ['P.uA=1,20'], turned, true],
        [['P.uA=20'], ['P.uA=1,20'], '', true],
        [['P.uA=10'], [], '', true],
        [['P.uA=5.5'], [], '', true],
        [['P.uA=10'], [], '', true],
        [['P.uA=5.5'], [], '', true],
    ]);
    assert.deepEqual(said.slice(-2), ['Redo: P.uA 5.5 → 10', 'Undo: P.uA 10 → 5.5']);
});

test('keys, a logarithmic scale and a picker set what the window sets', async () => {
    const engine = await started();
    const found = await engine.evaluate((e) => {
        const { session } = e.session();
        const of = (name: string) => session.controls.find((control) => control.name === name)!;
        session.change(() => e.engine.step(of('uMix').index, 0, 0.1));
        session.change(() => e.engine.step(of('uCount').index, 0, 10));
        session.change(() => e.engine.pick(of('uTint').index, 0, 128));
        session.change(() => e.engine.pick(of('uTint').index, 1, 209));
        session.change(() => e.engine.scale(of('uA').index, true));
        const at = of('uA').at[0]!;
        session.change(() => e.engine.slide(of('uA').index, 0, 0.5));
        const typed = ['1/3', '2,5', '1e39', '1e999', '1/0', 'abc', ''].map((text) => String(e.engine.typed(text, of('uA').index)));
        return { values: ['uMix', 'uCount', 'uTint', 'uA'].map((name) => of(name).value), at, typed, shown: of('uA').shown };
    });
    assert.deepEqual(found.values, [[0.001], [11], [0.5, 0.82, 0.1], [3.162]]);
    assert.ok(Math.abs(found.at - Math.log10(2)) < 1e-12);
    assert.deepEqual(found.shown, ['3.1620']);
    assert.deepEqual(found.typed, [String(1 / 3), '2.5', 'Infinity', 'Infinity', 'NaN', 'NaN', 'NaN']);
});

test('a slider that moves by itself goes there and back, and its motion is one step', async () => {
    const engine = await started();
    const found = await engine.evaluate((e) => {
        const { session } = e.session();
        const { index } = session.controls[1]!;
        const at = (time: number) => (session.move(time), session.controls[1]!.value[0]!);
        session.change(() => e.engine.animate(index, 0, 4, 10));
        const values = [10, 11, 12, 13, 14].map(at);
        session.change(() => e.engine.animate(index, 0, 8, 14));
        values.push(...[14, 16, 18].map(at));
        const { canUndo } = session.state;
        session.go(false);
        return { values, periods: session.periods, after: session.state.values, canUndo, more: session.state.canUndo };
    });
    assert.deepEqual(found, { values: [0, 0.5, 1, 0.5, 0, 0, 0.5, 1], periods: [], after: [], canUndo: true, more: false });
});

test('a large picture, drawn in parts, has every pixel in its place', async () => {
    const engine = await started();
    const wrong = await engine.evaluate((e) => {
        e.edit('fill.glib', 'Vertex fill.vert\nFragment fill.frag\nProgram P\nQuadXY 0. 1.');
        e.edit('fill.vert', 'void main() { gl_Position = vec4(gl_Vertex.xy, 0., 1.); }');
        e.edit('fill.frag', 'void main() { gl_FragColor = vec4(mod(floor(gl_FragCoord.xy), 256.) / 255., 0., 1.); }');
        e.engine.open('fill.glib', { lints: false });
        const [width, height] = [8192, 1400]; // with four samples, more than is drawn at once
        const picture = e.engine.picture({ time: 0, width, height }, 4);
        if (typeof picture === 'string') return picture;
        let wrong = 0;
        for (let row = 0; row < height; ++row)
            for (let x = 0; x < width; ++x) {
                const at = 4 * (row * width + x);
                if (picture[at] !== x % 256 || picture[at + 1] !== (height - 1 - row) % 256) ++wrong;
            }
        return wrong;
    });
    assert.equal(wrong, 0);
});

test('settling compiles programs for the values, and the picture stays', async () => {
    const engine = await started();
    await engine.evaluate((e, files, room) => e.open(files, room), filesBelow('scenes'), room);
    const before = await engine.evaluate((e, frame) => e.shown(frame), frame);
    const rounds = await engine.evaluate((e, frame) => {
        let rounds = 0;
        while (e.engine.settle(frame) && rounds < 100) ++rounds;
        return rounds;
    }, frame);
    assert.ok(rounds > 0 && rounds < 100, `${rounds} rounds`);
    assert.ok(alike(await engine.evaluate((e, frame) => e.shown(frame), frame), before) > 0.999);
});

test('stages that hand their triangles on change nothing', async () => {
    const engine = await started();
    const [problems, through, without, tessellated] = await engine.evaluate((e, frame) => {
        const program = 'Fragment g.frag\nProgram P\nSphere 1\n';
        e.edit('g.glib', 'Vertex g.vert\nGeometry g.geom\n' + program);
        e.edit('v.glib', 'Vertex g.vert\n' + program);
        e.edit('t.glib', 'Vertex t.vert\nTessControl t.tcs\nTessEvaluation t.tes\nGeometry g.geom\n' + program);
        e.edit('t.vert', '#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }');
        e.edit('t.tcs', '#version 400 compatibility\nlayout(vertices = 3) out;\nvoid main() {\n' +
            '    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n' +
            '    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelInner[0] = 3.;\n}');
        e.edit('t.tes', '#version 400 compatibility\nlayout(triangles) in;\nvoid main() {\n' +
            '    gl_Position = gl_ModelViewProjectionMatrix * (gl_TessCoord.x * gl_in[0].gl_Position +\n' +
            '        gl_TessCoord.y * gl_in[1].gl_Position + gl_TessCoord.z * gl_in[2].gl_Position);\n}');
        e.edit('g.vert', '#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }');
        e.edit('g.geom', '#version 330 compatibility\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices=3) out;\n' +
            'void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position; EmitVertex(); } EndPrimitive(); }');
        e.edit('g.frag', '#version 330 compatibility\nvoid main() { gl_FragColor = vec4(gl_FragCoord.xy / 200., 1., 1.); }');
        const shown = (scene: string) => {
            const { problems } = e.engine.open(scene);
            return [problems, e.shown(frame)] as const;
        };
        const [problems, through] = shown('g.glib');
        const [more, tessellated] = shown('t.glib');
        return [[...problems, ...more], through, shown('v.glib')[1], tessellated] as const;
    }, frame);
    assert.ok(!problems.some((problem) => problem.severity === 'error'), JSON.stringify(problems));
    assert.ok(spread(through) > 50, `${spread(through)} and ${spread(without)} values`);
    assert.ok(alike(through, without) > 0.999, `${alike(through, without)}`);
    assert.ok(alike(tessellated, without) > 0.999, `${alike(tessellated, without)}`);
});

test('advice is not about a command line', async () => {
    const engine = await started();
    const found = await engine.evaluate((e) => {
        e.edit('many.glib', 'Spere 1\n'.repeat(3000));
        e.edit('large.glib', 'Sphere 1 100000 100000\n');
        return ['many.glib', 'large.glib'].map((scene) => e.engine.check(scene).concat(e.engine.open(scene, { lints: false }).problems));
    });
    for (const [i, code] of ['too-many-diagnostics', 'too-many-vertices'].entries()) {
        const about = found[i]!.filter((problem) => problem.code === code);
        assert.ok(about.length > 0, found[i]!.map((problem) => problem.code).slice(-3).join());
        for (const { help, text } of about) assert.doesNotMatch(help + text, /--|[; ]$/);
    }
});

test('a broken edit keeps the last good picture and its values', async () => {
    const engine = await started();
    const files = filesBelow('scenes');
    const opened = await engine.evaluate((e, files, room) => e.open(files, room), files, room);
    const slider = opened.shown!.controls.find((control) => control.widget === 'slider')!;
    await engine.evaluate((e, slider) => e.engine.set(slider.index, 0, slider.max), slider);
    const before = await engine.evaluate((e, frame) => e.picture(frame), frame);
    const glass = 'refraction-room/glass.frag';
    const broken = text(files, glass).replace('void main', 'float broken(vec3 v) { return v; }\nvoid main');
    const refused = await engine.evaluate(
        (e, name, text, room) => (e.edit(name, text), e.engine.open(room)), glass, broken, room);
    assert.equal(refused.ok, false);
    const error = refused.problems.find((problem) => problem.severity === 'error')!;
    assert.equal(error.at!.file, glass);
    assert.ok(text(files, glass).split('\n').length >= error.at!.line - 1);
    assert.deepEqual(await engine.evaluate((e, frame) => e.picture(frame), frame), before);
    const mended = await engine.evaluate(
        (e, name, text, room) => (e.edit(name, text), e.engine.open(room)), glass, text(files, glass), room);
    assert.ok(mended.ok);
    assert.equal(mended.shown!.controls.find((c) => c.key === slider.key)!.value[0], slider.max);
    assert.deepEqual(await engine.evaluate((e, frame) => e.picture(frame), frame), before);
});

test('a lost context is taken up again with the values as they were', async () => {
    const engine = await started();
    const opened = await engine.evaluate((e, files, room) => e.open(files, room), filesBelow('scenes'), room);
    const slider = opened.shown!.controls.find((control) => control.widget === 'slider')!;
    await engine.evaluate((e, slider) => e.engine.set(slider.index, 0, slider.max), slider);
    const before = await engine.evaluate((e, frame) => e.picture(frame), frame);
    const restored = await engine.evaluate((e) => e.loseAndRestore());
    assert.ok(restored.ok);
    assert.deepEqual(await engine.evaluate((e, frame) => e.picture(frame), frame), before);
    assert.equal(await engine.evaluate((e) => e.error()), 0);
    said = said.filter((message) => !message.includes('CONTEXT_LOST_WEBGL'));
});

test('slow pictures of a drag become coarser in the same canvas, and the picture at rest is sharp', async () => {
    const engine = await started();
    const seen = await engine.evaluate(async (e, files, room) => {
        e.open(files, room);
        const frame = { time: 0, width: 96, height: 80 };
        const sharp = e.shown(frame);
        const drew = (milliseconds: number) => Math.min(e.engine.drew(milliseconds), 1e9); // infinity does not cross
        const dues = [0, 1, 2, 3, 4].map(() => (e.engine.draw(frame, true), drew(90)));
        const coarse = e.shown(frame, true);
        const size = [e.canvas.width, e.canvas.height];
        await new Promise((after) => setTimeout(after, drew(10) + 1));
        return { sharp, dues, coarse, size, rest: e.shown(frame), due: drew(90) };
    }, filesBelow('scenes'), room);
    const off = (a: number[], b: number[]) => a.reduce((sum, value, i) => sum + Math.abs(value - b[i]!), 0) / a.length;
    assert.equal(seen.dues[0], 1e9, 'one slow picture changes nothing');
    assert.ok(seen.dues.at(-1)! > 100 && seen.dues.at(-1)! <= 150, `${seen.dues.at(-1)}`);
    assert.deepEqual(seen.size, [96, 80]);
    assert.ok(off(seen.coarse, seen.sharp) > 1 && off(seen.coarse, seen.sharp) < 20, `${off(seen.coarse, seen.sharp)}`);
    assert.deepEqual(seen.rest, seen.sharp);
    assert.equal(seen.due, 1e9);
});

// WebGL has no geometry shaders, so what one emits is written to memory for each picture.
test('a picture tells once that a shader emits much', async () => {
    const engine = await started();
    const costs = await engine.evaluate((e) => {
        const emits = 'for (int i = 0; i < 64; ++i) { gl_Position = vec4(2.); EmitVertex(); }';
        e.edit('s.geom', `#version 400\nlayout(points) in; layout(points, max_vertices = 64) out;\nvoid main() { ${emits} }\n`);
        e.edit('s.glib', `Geometry s.geom\nProgram P\nglBegin gl_points\n${'glVertex 0 0 0\n'.repeat(5000)}glEnd\n`);
        if (!e.engine.open('s.glib').ok) throw new Error('refused');
        return [1, 2].map(() => e.engine.draw({ time: 0, width: 50, height: 50 }));
    });
    assert.deepEqual(costs.map((each) => each.map(({ code, at }) => [code, at?.line])), [[['costly-stages', 2]], []]);
});

test('a hundred edits do not make memory grow', async () => {
    const engine = await started();
    const files = filesBelow('scenes');
    await engine.evaluate((e, files, room) => e.open(files, room), files, room);
    const source = text(files, 'refraction-room/glass.frag');
    const grown = await engine.evaluate(
        (e, source, room, frame) => {
            const edit = (round: number) => {
                e.edit('refraction-room/glass.frag', `${source}\n// ${round}\n`);
                if (!e.engine.open(room).ok) throw new Error('refused');
                e.engine.draw(frame);
            };
            for (let round = 0; round < 10; ++round) edit(round);
            const before = e.heap();
            for (let round = 10; round < 110; ++round) edit(round);
            return e.heap() - before;
        },
        source, room, frame);
    assert.ok(grown < 5e6, `${grown} bytes`);
});
