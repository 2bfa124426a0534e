// Files that the desktop opens with the installed page: the browser hands them to `launchQueue`, of which a fake stands
// here. A real folder of the browser stands in for the one that its dialog gives.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { built, chromium, drawn, press, served, tab, until } from './harness/browser.mjs';

const scene = (radius) => `Vertex a.vert\nFragment a.frag\nProgram P\nSphere ${radius}\n`;
const files = {
    'first.glib': scene(1),
    'second.glib': scene(0.5),
    'a.vert': 'void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n',
    'a.frag': 'void main() { gl_FragColor = vec4(1., .5, 0., 1.); }\n',
    'alone.glib': 'Sphere 1\n',
};
let page, said;

before(async () => {
    ({ page, said } = await tab(await chromium()));
    await page.evaluateOnNewDocument(() => {
        const folder = () => navigator.storage.getDirectory().then((root) => root.getDirectoryHandle('room', { create: true }));
        window.showDirectoryPicker = folder;
        const launchQueue = { setConsumer: (take) => void (window.launched = take) };
        Object.defineProperty(window, 'launchQueue', { value: launchQueue });
        window.launch = async (name) => window.launched({ files: [await (await folder()).getFileHandle(name)] });
        window.put = async (name, text) => {
            const writer = await (await (await folder()).getFileHandle(name, { create: true })).createWritable();
            await writer.write(text);
            await writer.close();
        };
    });
    await page.goto((await served(join(built, 'site'))).address);
    for (const [name, text] of Object.entries(files)) await page.evaluate((name, text) => window.put(name, text), name, text);
});

const launch = (name) => page.evaluate((name) => window.launch(name), name);
const shows = (title) => until(page, (title) => document.title === title, title).then(() => drawn(page));

test('the folder of the first one is asked for, and the scene opens with its shaders', async () => {
    await launch('first.glib');
    await page.waitForSelector('.editor-dialog[open]');
    assert.match(await page.$eval('.editor-dialog[open]', ({ textContent }) => textContent), /choose the folder of 'first\.glib'/);
    await press(page, 'Choose the folder', '.editor-dialog[open]');
    await shows('first');
    assert.deepEqual(await page.$$eval('.problems:not([hidden]) .problem', (all) => all.map(({ textContent }) => textContent)), []);
});

test('another one of that folder opens without a question, in the page that is open', async () => {
    await launch('second.glib');
    await shows('second');
    assert.equal(await page.$('.editor-dialog[open]'), null);
});

test('a file may be opened alone', async () => {
    await page.goto((await served(join(built, 'site'))).address); // another place has no folders yet
    await page.evaluate((text) => window.put('alone.glib', text), files['alone.glib']);
    await launch('alone.glib');
    await page.waitForSelector('.editor-dialog[open]');
    await press(page, 'Open this file alone', '.editor-dialog[open]');
    await shows('alone');
    assert.deepEqual(said, []);
});
