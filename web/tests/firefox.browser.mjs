// A page in Firefox: it opens from a disk, draws, and takes real input.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { join } from 'node:path';
import { built, chord, drawn, firefox, openText, pageOf, press, served, shows, tab, temporaryFolder, until } from './harness/browser.mjs';
import { colours, difference, pixelsOf } from './harness/png.mjs';

const folder = temporaryFolder();
let browser, page, said, first;

before(async () => {
    const address = await pageOf(folder, 'scenes/refraction-room/refraction-room.glib');
    browser = await firefox();
    ({ page, said } = await tab(browser, { still: false }));
    await shows(page, address);
});

async function shown() {
    await new Promise((resolve) => setTimeout(resolve, 600));
    await drawn(page);
    await page.evaluate(() => {
        document.querySelector('.message').style.visibility = 'hidden';
        document.querySelector('canvas').style.outline = 'none';
    });
    return pixelsOf(Buffer.from(await (await page.$('canvas')).screenshot()));
}

const share = (a, b) => difference(a, b).share;
const fragment = (pattern) => until(page, (text) => new RegExp(text).test(decodeURIComponent(location.hash)), pattern);

async function drag(selector, dx) {
    const { x, y, width, height } = await (await page.$(selector)).boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    for (let i = 1; i <= 5; ++i) await page.mouse.move(x + width / 2 + (dx * i) / 5, y + height / 2);
    await page.mouse.up();
}

test('it opens from a disk and draws', async () => {
    first = await shown();
    assert.ok(colours(first) > 100, `${colours(first)} colours`);
    assert.equal(await page.title(), 'refraction-room');
});

test('drags of the picture and of a slider are undone', async () => {
    for (const [selector, dx, pattern] of [['canvas', 90, 'view=rotate_'], ['.row.slider input[type=range]', 40, '\\.u\\w+=']]) {
        await drag(selector, dx);
        await fragment(pattern);
        assert.ok(share(await shown(), first) > 0.02, `${selector}: the picture is another one`);
        await chord(page, 'z');
        assert.equal(share(await shown(), first), 0);
    }
});

test('a typed number is taken by Enter, and undone', async () => {
    await page.click('.row.slider input:not([type=range])', { count: 3 });
    await page.keyboard.type('1.2');
    await page.keyboard.press('Enter');
    await fragment('=1\\.2');
    assert.ok(share(await shown(), first) > 0.02, 'the picture is another one');
    await page.click('canvas');
    await chord(page, 'z');
    assert.equal(share(await shown(), first), 0);
});

test('broken text keeps the picture, and its undo the scene', async () => {
    await page.click('#tab-text');
    await page.waitForSelector('.editor-code');
    const before = await shown();
    await page.evaluate(() => document.querySelector('.editor-code').shadowRoot.querySelector('.cm-content').focus());
    await page.keyboard.type('Spere 1 ');
    await until(page, () => /Spere/.test(document.querySelector('.problems').textContent));
    assert.ok(colours(await shown()) > 100, 'the picture is there');
    await chord(page, 'z');
    await until(page, () => document.querySelector('.problems').hidden);
    assert.equal(share(await shown(), before), 0);
});

test('the start page says that folders are read once, and edits of a new scene survive a reload', async () => {
    const { page, said } = await tab(browser, { still: false });
    await page.goto((await served(join(built, 'site'))).address);
    await page.waitForSelector('.editor-welcome img');
    assert.match(await page.$eval('.editor-welcome', ({ textContent }) => textContent), /reads a folder once/);
    const begin = async () => {
        await press(page, 'New scene', '.editor-welcome');
        await drawn(page);
    };
    await begin();
    await openText(page);
    await page.evaluate(() => document.querySelector('.editor-code').shadowRoot.querySelector('.cm-content').focus());
    await page.keyboard.type('# mine ');
    await new Promise((resolve) => setTimeout(resolve, 1000));
    await page.reload();
    await page.waitForSelector('.editor-welcome img');
    await begin();
    await page.waitForSelector('.editor-dialog[open]');
    await press(page, 'Take the edits', '.editor-dialog[open]');
    await openText(page);
    await until(page, () => /# mine/.test(document.querySelector('.editor-code').shadowRoot.textContent));
    assert.deepEqual(said, []);
    await page.close();
});

test('the console is silent', () => assert.deepEqual(said, []));
