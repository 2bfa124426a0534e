// The served form of the page: it can be installed, works without a network, and says what a host forbids.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { built, chromium, drawn, pageOf, press, served, tab, temporaryFolder, until } from './harness/browser.mjs';

const folder = temporaryFolder();
let browser;

before(async () => void (browser = await chromium()));

test('the browser can install it, for .glib files, too', async () => {
    const { page, said } = await tab(browser);
    const { address } = await served(join(built, 'site'));
    await page.goto(address);
    await page.waitForSelector('.editor-welcome img');
    const devtools = await page.createCDPSession();
    const { manifest, errors } = await devtools.send('Page.getAppManifest');
    assert.deepEqual(errors, []);
    const { fileHandlers } = manifest ?? {};
    if (fileHandlers) assert.deepEqual(fileHandlers.map(({ accepts }) => accepts?.[0]?.fileExtensions ?? []), [['.glib']]);
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    const { installabilityErrors } = await devtools.send('Page.getInstallabilityErrors');
    assert.deepEqual(installabilityErrors.filter(({ errorId }) => errorId !== 'in-incognito'), []);
    assert.deepEqual(said, []);
    await page.close();
});

test('it opens without a network, and draws an example and a template', async () => {
    const { page, said } = await tab(browser);
    const { address, close } = await served(join(built, 'site'));
    await page.goto(address);
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    await until(page, () => navigator.serviceWorker.controller !== null);
    await close();
    await page.goto(address);
    await page.waitForSelector('.editor-welcome img');
    const pictures = await page.$$eval('.editor-welcome img', (all) => Promise.all(all.map((each) => each.decode().then(() => each.naturalWidth))));
    assert.ok(pictures.length > 20 && pictures.every((width) => width === 160), String(pictures));
    for (const [name, title] of [['blank', 'blank'], ['glass', 'glass']]) {
        await page.reload();
        await page.waitForSelector('.editor-welcome img');
        await press(page, name, '.editor-welcome li');
        await drawn(page);
        assert.equal(await page.title(), title);
    }
    assert.deepEqual(said, []);
    await page.close();
});

test("a host's policy that forbids the page is named", async () => {
    const address = await pageOf(folder, 'tests/cases/Sphere.glib');
    const page = async (policy, root = folder) => {
        const { address: host } = await served(root, { 'Content-Security-Policy': policy });
        const made = await tab(browser);
        await made.page.goto(`${host}${root === folder ? address.replace(/^.*\//, '') : ''}`);
        return made.page;
    };
    const text = (from) => from.$eval('body', ({ innerText }) => innerText);
    const blocked = await page("default-src 'self'");
    await until(blocked, () => /forbids scripts within a page, such as default-src 'self'/.test(document.body.innerText));
    const styled = await page("default-src 'self'; style-src 'unsafe-inline'");
    assert.doesNotMatch(await text(styled), /forbids scripts/);
    await until(styled, () => /forbids scripts within a page/.test(document.body.innerText) && getComputedStyle(document.querySelector('.late')).visibility === 'visible');
    const compiled = await page("script-src 'unsafe-inline'");
    await until(compiled, () => /cannot be shown: .*forbids it \(script-src, wasm-eval\): 'script-src 'unsafe-inline''/.test(document.body.innerText));
    const fits = await page("default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; img-src 'self' blob:", join(built, 'site'));
    await fits.waitForSelector('.editor-welcome img');
});
