// axe-core's rules, over every state of the page that a reader can come to.
import assert from 'node:assert/strict';
import { writeFileSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { zipSync } from 'fflate';
import { builtPage, chord, chromium, drop, openText, pageOf, press, root, run, shows, tab, temporaryFolder } from './harness/browser.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const folder = temporaryFolder();
let page, room, ladders;

before(async () => {
    let browser;
    [room, ladders, browser] = await Promise.all([
        pageOf(folder, 'scenes/refraction-room/refraction-room.glib', '--link', 'https://example.org/room'),
        pageOf(folder, 'scenes/light/fresnel/fresnel.glib'),
        chromium(),
        run(['web', '--gallery', 'scenes/refraction-room', '-o', join(folder, 'gallery')]),
    ]);
    ({ page } = await tab(browser));
});

async function violations() {
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run());
    return violations.flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) => `${id}: ${target}: ${failureSummary.replace(/\s+/g, ' ')}`));
}

const looks = {
    light: { colour: 'light', width: 1000, height: 700 },
    dark: { colour: 'dark', width: 1000, height: 700 },
    'a phone': { colour: 'light', width: 390, height: 844 },
    'a dark phone': { colour: 'dark', width: 390, height: 844 },
};

async function as({ colour, width, height }) {
    await page.setViewport({ width, height, isMobile: width < 500, hasTouch: width < 500 });
    await page.emulateMediaFeatures([
        { name: 'prefers-color-scheme', value: colour },
        { name: 'prefers-reduced-motion', value: 'reduce' },
    ]);
}

const openMenu = () => page.click('.menu > summary');
const closeDialog = () => page.keyboard.press('Escape');
const states = {
    'a scene': () => shows(page, room),
    'a scene with ladders': () => shows(page, ladders),
    'the menu': openMenu,
    'the dialog of the picture': async () => {
        await press(page, 'Picture as PNG');
        await page.hover('dialog[open] button.main');
    },
    'the help': async () => {
        await closeDialog();
        await press(page, '?');
    },
    'the editor': async () => {
        await closeDialog();
        await openText(page);
        await page.waitForSelector('.editor-code >>> .cm-content');
    },
    'a mistake in the text': async () => {
        await (await page.$('.editor-code >>> .cm-content')).click();
        await chord(page, 'Home');
        await page.keyboard.type('Spere 1\n');
        await page.waitForSelector('.problem');
        await page.waitForSelector('.editor-code >>> .cm-lintRange-error');
    },
    'the search': () => press(page, 'Find'),
    'edits of an earlier visit': async () => {
        await new Promise((resolve) => setTimeout(resolve, 600));
        await page.reload();
        await page.waitForSelector('.editor-dialog[open]');
    },
    'the page without a scene': async () => {
        await press(page, 'Discard', '.editor-dialog[open]');
        await new Promise((resolve) => setTimeout(resolve, 300));
        await page.goto(builtPage('snell.html'));
        await page.waitForSelector('.editor-welcome li');
    },
    'the choice of several scenes': async () => {
        const path = join(folder, 'two.zip');
        writeFileSync(path, zipSync({ 'a.glib': Buffer.from('Sphere 1\n'), 'b.glib': Buffer.from('Box 1\n') }));
        await drop(page, path);
        await page.waitForSelector('.editor-dialog[open]');
    },
    "a gallery's index": () => page.goto(pathToFileURL(join(folder, 'gallery/index.html')).href),
};

for (const [name, look] of Object.entries(looks)) {
    test(`every state of the page, ${name}`, async (t) => {
        await as(look);
        for (const [state, reach] of Object.entries(states)) {
            await t.test(state, async () => {
                await reach();
                assert.deepEqual(await violations(), []);
            });
        }
    });
}

test('every control of the page can be reached by the keyboard', async () => {
    await as(looks.light);
    await shows(page, room);
    const wanted = await page.$$eval('main button, main input, main select, main summary, main canvas', (all) =>
        all.filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.disabled && each.tabIndex >= 0).length);
    const reached = new Set();
    for (let i = 0; i < wanted + 20; ++i) {
        await page.keyboard.press('Tab');
        reached.add(await page.evaluate(() => {
            const at = document.activeElement;
            at.dataset.reached ??= String(Math.random());
            return at === document.body ? 'none' : at.dataset.reached;
        }));
    }
    reached.delete('none');
    assert.ok(reached.size >= wanted, `${reached.size} of ${wanted}`);
});
