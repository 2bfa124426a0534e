// Sizes and times that the page promises. Times are printed; they fail only far above what an idle machine has.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { built, chromium, pageOf, shows, tab, temporaryFolder, until } from './harness/browser.mjs';

const folder = temporaryFolder();
let address, lesson, browser;

before(async () => {
    [address, lesson, browser] = await Promise.all([
        pageOf(folder, 'scenes/refraction-room/refraction-room.glib'),
        pageOf(folder, 'docs/teaching/06-geometry/solution/round.glib'),
        chromium(),
    ]);
});

const inside = (html, pattern) => pattern.exec(html)[1];

test('the runtime has at most 760 kB, page and editor at most 350 kB, gzipped', (t) => {
    const html = readFileSync(join(built, 'page.html'), 'utf8');
    const runtime = Buffer.from(inside(html, /id="runtime">([^<]*)</), 'base64').length;
    const rest = gzipSync(html.replace(/(id="runtime">)[^<]*/, '$1'), { level: 9 }).length;
    t.diagnostic(`runtime ${(runtime / 1000).toFixed(1)} kB, page and editor ${(rest / 1000).toFixed(1)} kB`);
    assert.ok(runtime > 100_000 && runtime <= 760_000);
    assert.ok(rest > 50_000 && rest <= 350_000);
});

test('the page asks for no other file', async () => {
    const { page } = await tab(browser);
    const asked = [];
    page.on('request', (request) => asked.push(request.url()));
    await shows(page, address);
    const others = asked.filter((url) => !url.startsWith('data:') && !url.startsWith('blob:'));
    assert.deepEqual(others, [address]);
    await page.close();
});

// Milliseconds from the beginning of the navigation until the graphics have finished the first picture.
async function firstPicture(address) {
    const { page, said } = await tab(browser);
    await page.evaluateOnNewDocument(() => {
        const watch = new MutationObserver(() => {
            const status = document.querySelector('.status span');
            if (!window.first && status?.textContent.includes('ms')) window.first = performance.now();
        });
        watch.observe(document, { childList: true, subtree: true, characterData: true });
    });
    await page.goto(address);
    await until(page, () => window.first);
    const first = await page.evaluate(() => window.first);
    assert.deepEqual(said, []);
    await page.close();
    return first;
}

async function holdsFirstPicture(t, address, most) {
    const times = [];
    for (let i = 0; i < 5; ++i) times.push(await firstPicture(address));
    times.sort((a, b) => a - b);
    t.diagnostic(`${times.map((time) => (time / 1000).toFixed(2)).join(', ')} s`);
    assert.ok(times[0] < most, `${times[0]} ms`);
}

test('the first picture of the refraction room', (t) => holdsFirstPicture(t, address, 6000));

// Vertex shaders stand for its tessellation and geometry shaders.
test('the first picture of the geometry lesson', (t) => holdsFirstPicture(t, lesson, 2000));

test('a slider is in the picture in the next frame of the display', async (t) => {
    const { page } = await tab(browser);
    await shows(page, address);
    const found = await page.evaluate(async () => {
        let draws = 0;
        const drawing = WebGL2RenderingContext.prototype;
        for (const name of ['drawArrays', 'drawElements']) {
            const draw = drawing[name];
            drawing[name] = function (...values) {
                ++draws;
                return draw.apply(this, values);
            };
        }
        const slider = document.querySelector('.row.slider input[type=range]');
        const frames = [];
        for (let i = 0; i < 10; ++i) {
            await new Promise((resolve) => setTimeout(resolve, 700)); // the last picture is finished, and sharp
            draws = 0;
            slider.value = String(Number(slider.min) + ((Number(slider.max) - Number(slider.min)) * (i + 1)) / 12);
            slider.dispatchEvent(new Event('input', { bubbles: true }));
            const before = draws;
            await new Promise(requestAnimationFrame);
            frames.push([before, draws]);
        }
        return frames;
    });
    t.diagnostic(`draws in the same task, and after the next frame: ${found.map((pair) => pair.join(' ')).join(', ')}`);
    assert.ok(found.every(([before, after]) => before === 0 && after > 0));
    await page.close();
});
