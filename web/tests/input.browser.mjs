// Real input in Chromium: a page from a disk, in a fresh profile.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { zipSync } from 'fflate';
import { builtPage, chord, chromium, drawn, drop, pageOf, root, shows, tab, temporaryFolder, until } from './harness/browser.mjs';
import { colours, difference, pixelsOf } from './harness/png.mjs';

const folder = temporaryFolder();
const scene = 'scenes/refraction-room/refraction-room.glib';
let browser, address, page, said;

// Counts what is drawn and what is asked of the display, and finds the runtime's memory.
function watch() {
    Object.assign(window, { draws: 0, asked: 0, waiting: new Set(), memories: new Set() });
    const drawing = WebGL2RenderingContext.prototype;
    for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']) {
        const draw = drawing[name];
        drawing[name] = function (...values) {
            ++window.draws;
            return draw.apply(this, values);
        };
    }
    const ask = window.requestAnimationFrame;
    window.frame = () => new Promise(ask);
    window.requestAnimationFrame = (call) => {
        ++window.asked;
        const id = ask((now) => {
            window.waiting.delete(id);
            call(now);
        });
        window.waiting.add(id);
        return id;
    };
    const cancel = window.cancelAnimationFrame;
    window.cancelAnimationFrame = (id) => (window.waiting.delete(id), cancel(id));
    const make = WebAssembly.instantiate;
    WebAssembly.instantiate = async (...values) => {
        const made = await make(...values);
        const memory = Object.values((made.instance ?? made).exports).find((each) => each instanceof WebAssembly.Memory);
        if (memory) window.memories.add(memory);
        return made;
    };
}

async function opened(size) {
    const made = await tab(browser, size);
    await made.page.evaluateOnNewDocument(watch);
    return made;
}

before(async () => {
    [address, browser] = await Promise.all([pageOf(folder, scene), chromium()]);
    ({ page, said } = await opened());
});

const quiet = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

// Waits until the last picture is sharp and finished. A new size is known after one frame of the display, and drawn in
// the next.
async function rested(from) {
    await from.evaluate(() => window.frame().then(window.frame));
    await drawn(from);
    await until(from, () => window.waiting.size === 0 && / ms$/.test(document.querySelector('.status span').textContent));
}

// What the display shows, without messages and focus, when nothing moves any more.
async function shown(from = page) {
    await rested(from);
    await from.evaluate(() => {
        document.querySelector('.message').style.visibility = 'hidden';
        document.querySelector('canvas').style.outline = 'none';
    });
    return pixelsOf(Buffer.from(await (await from.$('canvas')).screenshot()));
}

const same = (a, b) => assert.equal(difference(a, b).share, 0);
const differs = (a, b) => assert.ok(difference(a, b).share > 0.02, 'the picture is another one');
const fragment = (pattern) => until(page, (text) => new RegExp(text).test(decodeURIComponent(location.hash)), pattern);
const middle = async (selector) => {
    const { x, y, width, height } = await (await page.$(selector)).boundingBox();
    return { x: x + width / 2, y: y + height / 2, width };
};

async function drag(selector, dx, dy) {
    const { x, y } = await middle(selector);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 8; ++i) await page.mouse.move(x + (dx * i) / 8, y + (dy * i) / 8);
    await page.mouse.up();
}

// Undoes all edits of the text that is shown. Keys that follow each other quickly are one.
async function undone() {
    const edited = () => page.$eval('.editor-tabs [aria-selected=true]', (tab) => /edited/.test(tab.getAttribute('aria-label')));
    while (await edited()) await chord(page, 'z');
}

// The text is drawn a moment after its last change.
async function becomes(picture) {
    for (const end = Date.now() + 20_000; Date.now() < end; await quiet(50)) if (difference(await shown(), picture).share === 0) return;
    assert.fail('the picture is another one');
}

let first;

test('the page opens from a disk and draws', async () => {
    await shows(page, address);
    first = await shown();
    assert.ok(colours(first) > 100, `${colours(first)} colours`);
    assert.equal(await page.title(), 'refraction-room');
});

test('a drag turns the scene, and undo turns it back', async () => {
    await drag('canvas', 90, 20);
    await fragment('view=rotate_');
    const turned = await shown();
    differs(turned, first);
    await chord(page, 'z');
    same(await shown(), first);
    await chord(page, 'y');
    same(await shown(), turned);
    await chord(page, 'z');
});

test('a drag of a slider is one change', async () => {
    await drag('.row.slider input[type=range]', 40, 0);
    await fragment('\\.u\\w+=');
    differs(await shown(), first);
    await chord(page, 'z');
    same(await shown(), first);
    assert.equal(await page.$$eval('.tools button', (all) => all.find((each) => each.textContent === 'Undo').disabled), true);
});

test('a typed number is taken by Enter, and undone', async () => {
    await page.click('.row.slider input:not([type=range])', { count: 3 });
    await page.keyboard.type('1,2');
    await page.keyboard.press('Enter');
    await fragment('=1\\.2');
    differs(await shown(), first);
    await page.click('canvas');
    await chord(page, 'z');
    same(await shown(), first);
});

test('the wheel and the keys of the picture scale and turn it', async () => {
    const { x, y } = await middle('canvas');
    await page.mouse.move(x, y);
    await page.mouse.wheel({ deltaY: -300 });
    await page.focus('canvas');
    await page.keyboard.press('ArrowLeft');
    await fragment('rotate_.*scale=1');
    differs(await shown(), first);
    await page.keyboard.press('r');
    same(await shown(), first);
});

test('an edit to broken text keeps the picture, and its undo the scene', async () => {
    await page.click('#tab-text');
    await (await page.waitForSelector('.editor-code >>> .cm-content')).click();
    // The text takes room from the picture.
    const before = await shown();
    await chord(page, 'End');
    await page.keyboard.type('Spere 1');
    await until(page, () => /Spere/.test(document.querySelector('.problems').textContent));
    assert.ok(colours(await shown()) > 100, 'the picture is there');
    await undone();
    await until(page, () => document.querySelector('.problems').hidden);
    same(await shown(), before);
    await chord(page, 'Home');
    const draws = await page.evaluate(() => window.draws);
    await page.keyboard.type('Background 1 0 0\n');
    await until(page, (count) => window.draws > count, draws);
    await undone();
    await becomes(before);
    await page.click('#tab-text');
    same(await shown(), first);
});

test('nothing is drawn and nothing asked of the display while nothing changes', async () => {
    // Programs for the values are made half a second after the last picture, one at a time.
    for (let i = 0, before = -1; i < 20; ++i) {
        await quiet(800);
        const now = await page.evaluate(() => window.draws + window.asked);
        if (now === before) break;
        before = now;
    }
    await page.evaluate(() => Object.assign(window, { draws: 0, asked: 0 }));
    await quiet(1500);
    assert.deepEqual(await page.evaluate(() => [window.draws, window.asked]), [0, 0]);
    same(await shown(), first);
});

test('a lost context comes back with the same picture and values', async () => {
    assert.deepEqual(said.splice(0), []);
    await drag('.row.slider input[type=range]', 40, 0);
    const moved = await shown();
    for (let round = 0; round < 2; ++round) {
        await page.evaluate(() => {
            window.taken = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
            window.taken.loseContext();
        });
        await until(page, () => /took the graphics away/.test(document.querySelector('.message').textContent));
        await page.evaluate(() => window.taken.restoreContext());
        await until(page, () => /graphics are back/.test(document.querySelector('.message').textContent));
        await page.evaluate(() => void (document.querySelector('.status span').textContent = ''));
        await drag('canvas', 30, 0);
        await chord(page, 'z');
        same(await shown(), moved);
    }
    // Chromium says itself that the page took the context away.
    assert.deepEqual(said.splice(0).filter((text) => !/CONTEXT_LOST_WEBGL: loseContext/.test(text)), []);
});

test('a link shows what it says', async () => {
    const other = await opened();
    await shows(other.page, `${address}#view=rotate_y%3D40`);
    differs(await shown(other.page), first);
    assert.deepEqual(other.said, []);
    await other.page.close();
});

async function memory(from) {
    const devtools = await from.createCDPSession();
    await devtools.send('HeapProfiler.collectGarbage');
    const { JSHeapUsedSize } = await from.metrics();
    await devtools.detach();
    return JSHeapUsedSize + (await from.evaluate(() => [...window.memories].reduce((sum, each) => sum + each.buffer.byteLength, 0)));
}

test('a hundred scenes after each other leave no memory behind', async (t) => {
    const { page: other, said: otherSaid } = await opened({ width: 800, height: 500 });
    const cases = ['Texture2D', 'Teapot'];
    const zips = cases.map((name, i) => {
        const names = [`${name}.glib`, 'shaders/lit.vert', 'shaders/lit.frag', 'shaders/texture.frag', 'files/letter.bmp'];
        const path = join(folder, `small${i}.zip`);
        writeFileSync(path, zipSync(Object.fromEntries(names.map((each) => [each, readFileSync(join(root, 'tests/cases', each))]))));
        return path;
    });
    await other.goto(builtPage('snell.html'));
    await until(other, () => document.querySelectorAll('.editor-welcome li').length > 10);
    const open = async (round) => {
        await other.evaluate(() => void (document.querySelector('.status span').textContent = ''));
        await drop(other, zips[round % 2]);
        await drawn(other);
    };
    for (let round = 0; round < 10; ++round) await open(round);
    const before = await memory(other);
    for (let round = 0; round < 100; ++round) await open(round);
    const grown = (await memory(other)) - before;
    t.diagnostic(`${(before / 1e6).toFixed(1)} MB, and ${(grown / 1e6).toFixed(2)} MB more after 100 scenes`);
    assert.ok(grown < 5e6, `${grown} bytes`);
    assert.deepEqual(otherSaid, []);
    await other.close();
});

test('a browser without WebGL 2 is told so', async () => {
    const { page: other, said: otherSaid } = await tab(await chromium('--disable-3d-apis'));
    await other.goto(address);
    await other.waitForSelector('.failure');
    assert.match(await other.$eval('.failure', (element) => element.textContent), /does not offer WebGL 2/);
    assert.deepEqual(otherSaid.filter((text) => !/WebGL/.test(text)), []);
});

test('reloads of the page show the same picture', async () => {
    for (let round = 0; round < 3; ++round) {
        await page.goto('about:blank');
        await shows(page, address);
        same(await shown(), first);
    }
});

test('reloads of a page leave no memory behind', async (t) => {
    const reloads = 30;
    const small = await tab(browser, { width: 760, height: 240 });
    await small.page.evaluateOnNewDocument(watch);
    await shows(small.page, await pageOf(folder, 'tests/cases/Sphere.glib'));
    const reload = async () => {
        await small.page.reload();
        await drawn(small.page);
    };
    // The browser's own caches are filled.
    for (let round = 0; round < 5; ++round) await reload();
    const before = await memory(small.page);
    const picture = await shown(small.page);
    for (let round = 0; round < reloads; ++round) await reload();
    same(await shown(small.page), picture);
    const grown = (await memory(small.page)) - before;
    t.diagnostic(`${(before / 1e6).toFixed(1)} MB, and ${(grown / 1e6).toFixed(2)} MB more after ${reloads} reloads`);
    assert.ok(grown < 0.05e6 * reloads, `${grown} bytes`);
    assert.deepEqual(small.said, []);
    await small.page.close();
});

test('the console is silent, and there is no error of OpenGL', async () => {
    assert.deepEqual(said, []);
    assert.equal(await page.$eval('canvas', (canvas) => canvas.getContext('webgl2').getError()), 0);
});
