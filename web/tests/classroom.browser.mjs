// snell.html, the page without a scene: its examples, and files that are dropped on it.
import assert from 'node:assert/strict';
import { copyFileSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { exampleList } from '../examples.mjs';
import { builtPage, chromium, drawn, drop, openText, press, root, tab, temporaryFolder, until } from './harness/browser.mjs';

const folder = temporaryFolder();
const examples = exampleList();
let page, said;

before(async () => {
    ({ page, said } = await tab(await chromium(), { width: 800, height: 500 }));
    await page.goto(builtPage('snell.html'));
    await until(page, (count) => [...document.querySelectorAll('.editor-welcome section')].find((each) => each.firstChild.textContent === 'Examples')?.querySelectorAll('li').length === count, examples.length);
});

const shownErrors = () =>
    page.$$eval('.problems:not([hidden]) .problem', (all) => all.map((each) => each.textContent).filter((text) => /error: /.test(text)));

async function opens(act, title) {
    await page.evaluate(() => void (document.querySelector('.status span').textContent = ''));
    await act();
    await until(page, (text) => document.title === text, title);
    await drawn(page);
    assert.deepEqual(await shownErrors(), []);
    assert.deepEqual(said.splice(0), [], 'the console is silent');
}

// The list is on the page while there is no scene, and in a dialog of the editor afterwards.
async function openList() {
    if (await page.evaluate(() => !document.querySelector('.cover').hidden)) return;
    await openText(page);
    await press(page, 'Open…', '.editor-buttons');
    await page.waitForSelector('.editor-dialog[open] .editor-welcome li');
}

for (const [i, { scene }] of examples.entries()) {
    const name = scene.replace(/^.*\/|\.glib$/g, '');
    test(`the example ${name} opens after the one before`, async () => {
        await openList();
        await opens(async () => (await page.$$('.editor-welcome section:last-child li button'))[i].click(), name);
        const tabs = await page.$$eval('.editor-tabs [role=tab]', (all) => all.map((each) => each.textContent));
        assert.ok(tabs.some((text) => text.includes(`${name}.glib`)), String(tabs));
    });
}

test('a new scene opens', async () => {
    await openList();
    await opens(() => press(page, 'New scene', '.editor-dialog[open]'), 'scene');
});

test('single files, a folder, and a missing file are dropped', async () => {
    const shaders = join(root, 'tests/cases/shaders');
    mkdirSync(join(folder, 'one'));
    const scene = join(folder, 'one/dropped.glib');
    writeFileSync(scene, '##OpenGL GLIB\nVertex lit.vert\nFragment lit.frag\nProgram Lit\nSphere 1\n');
    await opens(() => drop(page, scene, join(shaders, 'lit.vert'), join(shaders, 'lit.frag')), 'dropped');
    mkdirSync(join(folder, 'two/deep'), { recursive: true });
    writeFileSync(join(folder, 'two/deep/other.glib'), '##OpenGL GLIB\nVertex ../lit.vert\nProgram Lit\nBox\n');
    copyFileSync(join(shaders, 'lit.vert'), join(folder, 'two/lit.vert'));
    await opens(() => drop(page, join(folder, 'two')), 'other');
    await page.evaluate(() => void (document.querySelector('.status span').textContent = ''));
    await drop(page, scene);
    await until(page, () => /lit\.vert/.test(document.querySelector('.problems').textContent));
    await drop(page, join(shaders, 'lit.vert'), join(shaders, 'lit.frag'));
    await until(page, () => document.querySelector('.problems').hidden);
    await drawn(page);
    assert.deepEqual(said, []);
});
