// Compares the times of two builds of the page, in one browser and in turns: of frames, and of the first picture.
//   node compare.mjs OLD frames|looks|first ROUNDS [WORD...]
// OLD: another checkout, where `./dev web` was run; WORD: of scenes' paths; without one, all scenes.
// looks: frames of scenes with long loops, before each of which the new build looks ahead as the page does; OLD may be
// this checkout.
// Prints for each scene the median times of both, and the median of the quotients new / old of a round with the bounds
// between which 95 % of such medians lie: of the CPU's time of all the browser's processes, and of the wall's time.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import puppeteer from 'puppeteer-core';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '..');
const [other, what, wantedRounds, ...words] = process.argv.slice(2);
const rounds = Number(wantedRounds);
const builds = { old: resolve(other), new: root };
const snell = process.env.SNELL ?? join(root, 'build/release/bin/snell');

function filesBelow(folder, suffix = '') {
    return readdirSync(join(root, folder))
        .map((name) => `${folder}/${name}`)
        .flatMap((path) => (statSync(join(root, path)).isDirectory() ? filesBelow(path, suffix) : path.endsWith(suffix) ? [path] : []));
}

const folders = ['scenes', 'docs/teaching', 'templates'];
const scenes = folders
    .flatMap((folder) => filesBelow(folder, '.glib'))
    .filter((path) => !/end-to-end|submissions|handout|geometry/.test(path))
    .filter((path) => words.length === 0 || words.some((word) => path.includes(word)));

const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader'],
    protocolTimeout: 600_000,
});
process.on('exit', () => browser.process()?.kill());

// Nanoseconds that each thread of the browser has run.
function threads() {
    const parents = new Map();
    for (const pid of readdirSync('/proc').filter((name) => /^\d+$/.test(name)))
        try {
            parents.set(Number(pid), Number(/\) \S (\d+)/.exec(readFileSync(`/proc/${pid}/stat`, 'utf8'))[1]));
        } catch {} // it has ended
    const ours = (pid) => pid === browser.process().pid || (parents.has(pid) && ours(parents.get(pid)));
    const times = new Map();
    for (const pid of [...parents.keys()].filter(ours))
        try {
            for (const thread of readdirSync(`/proc/${pid}/task`))
                times.set(`${pid}/${thread}`, Number(readFileSync(`/proc/${pid}/task/${thread}/schedstat`, 'utf8').split(' ')[0]));
        } catch {}
    return times;
}

// Milliseconds of the CPU, and of the wall as `work` returns them.
async function measured(work) {
    const before = threads();
    const wall = await work();
    let cpu = 0;
    for (const [thread, time] of threads()) cpu += (time - (before.get(thread) ?? 0)) / 1e6;
    return { cpu, wall };
}

const sorted = (numbers) => [...numbers].sort((a, b) => a - b);
const median = (numbers) => sorted(numbers)[numbers.length >> 1];

// The middle and, by the binomial distribution, bounds of the median.
function interval(numbers) {
    const all = sorted(numbers);
    const off = Math.ceil(0.98 * Math.sqrt(all.length));
    const at = (i) => all[Math.min(Math.max(i, 0), all.length - 1)];
    const half = all.length >> 1;
    return [at(half), at(half - off), at(half + off)].map((value) => value.toFixed(3));
}

// Of rounds, each of which has the times of both.
function told(scene, name, found) {
    const middle = {};
    const shown = ['cpu', 'wall'].map((clock) => {
        const [at, low, high] = interval(found.map((round) => round.new[clock] / round.old[clock]));
        const [before, now] = ['old', 'new'].map((build) => median(found.map((round) => round[build][clock])).toFixed(1));
        middle[clock] = Number(at);
        return `${clock} ${before} ms, ${now} ms: ${at} (${low} to ${high})`;
    });
    console.log(`${scene.replace(/^.*\/(.*?\/.*)\.glib$/, '$1')}, ${name}: ${shown.join('; ')}`);
    return middle;
}

// Nobody is always the first.
async function inTurn(round, act) {
    const found = {};
    for (const build of round % 2 ? ['new', 'old'] : ['old', 'new']) found[build] = await act(build);
    return found;
}

// ---- frames: both engines in one page

const code = Object.entries(builds).map(
    ([name, folder]) => `
        import make_${name} from ${JSON.stringify(join(folder, 'build/web/engine/snell.js'))};
        import { WasmEngine as Engine_${name} } from ${JSON.stringify(join(folder, 'web/page/wasm.ts'))};`,
);
const bundle = await build({
    stdin: {
        contents: `${code.join('')}
            const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
            globalThis.engines = {};
            globalThis.prepare = async (wasm, files) => {
                globalThis.files = files.map(([path, text]) => [path, bytes(text)]);
                globalThis.modules = {};
                for (const name in wasm) modules[name] = await WebAssembly.compile(bytes(wasm[name]));
            };
            // The scene in an engine of its own.
            globalThis.start = async (name, scene) => {
                engines[name]?.gl.getExtension('WEBGL_lose_context').loseContext();
                const [Engine, make] = { old: [Engine_old, make_old], new: [Engine_new, make_new] }[name];
                const canvas = document.createElement('canvas');
                const engine = await Engine.load(make, modules[name]);
                const error = await engine.start(canvas);
                if (error) throw new Error(error);
                engines[name] = { engine, gl: canvas.getContext('webgl2') };
                for (const [path, content] of files) engine.write(path, content);
                const { ok, problems, shown } = engine.open(scene, { lints: false });
                if (!ok) throw new Error(JSON.stringify(problems));
                frames(name, 2);
                return shown.longLoops;
            };
            const looks = ${what === 'looks'}, longest = 5000;
            const frame = looks ? { time: 0, width: 960, height: 640 } : { time: 0, width: 256, height: 256 };
            const pixel = new Uint8Array(4);
            // So many frames, while the view is turned or a value moves; returns when the graphics have finished the last one.
            globalThis.frames = (name, count, slides) => {
                const { engine, gl } = engines[name];
                const begun = performance.now();
                for (let i = 0; i < count; ++i) {
                    if (slides) engine.set(0, 0, i / count);
                    else engine.turn(.5, 0, i === 0);
                    if (looks && name === 'new') engine.foresee(frame, longest);
                    engine.draw(frame);
                    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
                }
                return (performance.now() - begun) / count;
            };
            globalThis.settled = (name) => {
                for (let i = 0; i < 30 && engines[name].engine.settle(frame); ++i);
                frames(name, 1);
            };`,
        resolveDir: root,
        loader: 'ts',
    },
    bundle: true,
    format: 'iife',
    write: false,
    external: ['module', 'fs', 'path', 'url'],
});

const files = folders.flatMap((folder) => filesBelow(folder)).map((path) => [path, readFileSync(join(root, path)).toString('base64')]);
const wasm = Object.fromEntries(
    Object.entries(builds).map(([name, folder]) => [name, readFileSync(join(folder, 'build/web/engine/snell.wasm')).toString('base64')]),
);

async function startFrames() {
    const page = await browser.newPage();
    page.on('pageerror', (error) => console.error(String(error)));
    await page.addScriptTag({ content: bundle.outputFiles[0].text });
    await page.evaluate((wasm, files) => prepare(wasm, files), wasm, files);
    return page;
}

// What drivers make of a program in one context is a matter of luck, so that each round has contexts of its own.
async function compareFrames(page, scene) {
    const kinds = what === 'looks' ? { turned: [], dragged: [] } : { frame: [], 'frame at rest': [] };
    let count = 0;
    for (let round = 0; round < rounds; ++round) {
        const { new: longLoops } = await inTurn(round, (name) => page.evaluate((name, scene) => start(name, scene), name, scene));
        if (what === 'looks' && !longLoops) return [];
        count ||= Math.max(1, Math.min(100, Math.ceil(200 / (await page.evaluate(() => frames('old', 1))))));
        for (const [kind, found] of Object.entries(kinds)) {
            const frames = (name) => page.evaluate((...how) => frames(...how), name, count, kind === 'dragged');
            if (kind === 'frame at rest') await page.evaluate(() => ['old', 'new'].forEach(settled));
            found.push(
                await inTurn(round, async (name) => {
                    const { cpu, wall } = await measured(() => frames(name));
                    return { cpu: cpu / count, wall };
                }),
            );
        }
    }
    return Object.entries(kinds).map(([kind, found]) => told(scene, kind, found));
}

// ---- first pictures: whole pages

async function compareFirst(folder, scene) {
    const pages = {};
    for (const [name, from] of Object.entries(builds)) {
        const path = join(folder, `${name}-${basename(scene, '.glib')}.html`);
        execFileSync(snell, ['web', join(root, scene), '-o', path], { env: { ...process.env, SNELL_WEB: join(from, 'build/web') }, stdio: 'ignore' });
        pages[name] = pathToFileURL(path).href;
    }
    const found = [];
    for (let round = 0; round < rounds; ++round) found.push(await inTurn(round, (name) => firstPicture(pages[name])));
    return told(scene, 'first picture', found);
}

async function firstPicture(address) {
    const page = await browser.newPage();
    await page.setViewport({ width: 1000, height: 700 });
    await page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]);
    const found = await measured(async () => {
        await page.goto(address);
        await page.waitForFunction(
            () => {
                document.querySelector('dialog[open][aria-label="This scene takes long"] button')?.click();
                return document.querySelector('.status span')?.textContent.includes('ms');
            },
            { polling: 'mutation', timeout: 120_000 },
        );
        return page.evaluate(() => performance.now());
    });
    await page.close();
    return found;
}

const folder = mkdtempSync(join(tmpdir(), 'snell-compare-'));
try {
    const all = [];
    if (what !== 'first') {
        const page = await startFrames();
        for (const scene of scenes) all.push(...(await compareFrames(page, scene)));
    } else {
        for (const scene of scenes) all.push(await compareFirst(folder, scene));
    }
    const of = (clock) => all.map((each) => each[clock]);
    console.log(`in the median cpu ${median(of('cpu')).toFixed(3)}, wall ${median(of('wall')).toFixed(3)}; at most cpu ${Math.max(...of('cpu')).toFixed(3)}`);
} finally {
    await browser.close();
    rmSync(folder, { recursive: true });
}
