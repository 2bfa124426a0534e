// A page in Firefox: it opens from a disk, draws, and takes real input.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { chord, drawn, firefox, pageOf, shows, tab, temporaryFolder, until } from './harness/browser.mjs';
import { colours, difference, pixelsOf } from './harness/png.mjs';

const folder = temporaryFolder();
let page, said, first;

before(async () => {
    const [address, browser] = await Promise.all([pageOf(folder, 'scenes/refraction-room/refraction-room.glib'), firefox()]);
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

test('the console is silent', () => assert.deepEqual(said, []));
