// The editor in a real browser, under the page's Content-Security-Policy, from a disk.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { zipSync } from 'fflate';
import puppeteer from 'puppeteer-core';
import { examples } from '../examples.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'snell-editor-'));
const errors = [];
let browser, page, devtools;

async function writePage() {
    const { outputFiles } = await build({
        entryPoints: [join(here, 'harness/editor.ts'), join(here, '../page/editor/editor.css')],
        bundle: true,
        format: 'iife',
        loader: { '.glib': 'text', '.vert': 'text', '.frag': 'text' },
        outdir: folder,
        write: false,
    });
    const [script, sheet] = ['.js', '.css'].map((end) => outputFiles.find(({ path }) => path.endsWith(end)).text);
    const style = `${sheet}#place { height: 600px; }`;
    const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
    const policy = `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}`;
    const path = join(folder, 'page.html');
    writeFileSync(
        path,
        `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Editor</title>` +
            `<meta http-equiv="Content-Security-Policy" content="${policy}"><style>${style}</style></head>` +
            `<body><main id="place"></main>${examples()}<script>${script}</script></body></html>`,
    );
    return pathToFileURL(path).href;
}

before(async () => {
    const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
    browser = await puppeteer.launch({ executablePath, args: ['--no-sandbox'] });
    page = await browser.newPage();
    page.on('console', (message) => ['error', 'warn'].includes(message.type()) && errors.push(message.text()));
    page.on('pageerror', (error) => errors.push(String(error)));
    page.on('dialog', (dialog) => dialog.accept());
    await page.setViewport({ width: 1000, height: 700 });
    await page.goto(await writePage());
    devtools = await page.createCDPSession();
});

after(async () => {
    await browser?.close();
    rmSync(folder, { recursive: true });
});

function put(name, bytes) {
    const path = join(folder, name);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, bytes);
    return path;
}

async function drop(...files) {
    const data = { items: [], files, dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop'])
        await devtools.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
}

const until = (condition, ...values) => page.waitForFunction(condition, { timeout: 5000, polling: 20 }, ...values);
const opened = (scene) => until((name) => window.host.scene === name, scene);
const heading = (text) => until((wanted) => document.querySelector('.editor-problems p').textContent === wanted, text);
const bytes = (name) => page.evaluate((file) => [...window.host.files.get(file)], name);
const press = async (selector, text) => {
    const buttons = await page.$$(selector);
    for (const button of buttons) if ((await button.evaluate((element) => element.textContent)).startsWith(text)) return button.click();
    assert.fail(`there is no '${text}'`);
};
const chord = async (key) => {
    await page.keyboard.down('Control');
    await page.keyboard.press(key);
    await page.keyboard.up('Control');
};

test('an example opens with all its texts', async () => {
    await until(() => document.querySelectorAll('.editor-welcome li').length > 10);
    await press('.editor-welcome li button', 'glass');
    await opened('light/glass/glass.glib');
    const tabs = await page.$$eval('.editor-tabs [role=tab]', (all) => all.map((tab) => tab.textContent));
    assert.equal(tabs[0], 'glass.glib');
    assert.ok(tabs.includes('room.inc') && tabs.includes('glass.frag') && tabs.includes('room.glsl'));
});

test('a mistake is marked where it is, and the mark goes with it', async () => {
    await (await page.$('.editor-code >>> .cm-content')).click();
    await chord('End');
    await page.keyboard.type('Spere 1');
    await heading('1 error');
    // On a busy machine, what is typed first is marked first.
    const marked = () => page.$$eval('.editor-code >>> .cm-lintRange-error', (marks) => marks.map((mark) => mark.textContent).join());
    for (let i = 0; i < 100 && (await marked()) !== 'Spere'; ++i) await new Promise((wake) => setTimeout(wake, 20));
    assert.equal(await marked(), 'Spere');
    assert.ok(await page.$('.editor-code >>> .cm-lint-marker-error'));
    assert.match(await page.$eval('.editor-tabs [aria-selected=true]', (tab) => tab.getAttribute('aria-label')), /edited, errors: 1/);
    await chord('z');
    await heading('No problems');
    assert.equal(await page.$('.editor-code >>> .cm-lintRange-error'), null);
    assert.doesNotMatch(await page.$eval('.editor-tabs [aria-selected=true]', (tab) => tab.getAttribute('aria-label')), /edited/);
});

test('Escape and Tab leave the text', async () => {
    const focused = () => page.evaluate(() => document.activeElement.className);
    await (await page.$('.editor-code >>> .cm-content')).click();
    await page.keyboard.press('Tab');
    assert.equal(await focused(), 'editor-code');
    await chord('z');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Tab');
    assert.notEqual(await focused(), 'editor-code');
});

test('a folder opens, and an edit changes only its place', async () => {
    const text = Buffer.from('##OpenGL GLIB\r\n# caf\xe9\r\nSphere 1\n', 'latin1');
    put('room/a.glib', text);
    put('room/sub/b.frag', 'void main() {}');
    await drop(join(folder, 'room'));
    await opened('room/a.glib');
    await (await page.$('.editor-code >>> .cm-content')).click();
    await chord('End');
    await page.keyboard.type('Box 1');
    await until(() => window.host.files.get('room/a.glib').length > 36);
    assert.deepEqual(await bytes('room/a.glib'), [...text, ...Buffer.from('Box 1')]);
    assert.deepEqual(await bytes('room/sub/b.frag'), [...Buffer.from('void main() {}')]);
});

test('a hostile archive asks before edits are lost, leaves nothing behind and runs nothing', async () => {
    const markup = '<img src=x onerror="window.hit=1"><script>window.hit=1</script>.glib';
    const entries = { '../up.glib': Buffer.from('x'), 'C:/x.glib': Buffer.from('x'), [`a/${markup}`]: Buffer.from('<b onclick=1>\nwrong <script>window.hit=1</script>') };
    await drop(put('evil.zip', zipSync(entries)));
    await page.waitForSelector('.editor-dialog-buttons button');
    await press('.editor-dialog-buttons button', 'Discard');
    await until(() => window.host.files.size === 1);
    const state = await page.evaluate(() => ({ scene: window.host.scene, said: window.said, hit: window.hit, images: document.images.length }));
    assert.equal(state.scene, `a/${markup}`);
    assert.equal(state.hit, undefined);
    assert.equal(state.images, 0);
    assert.match(state.said.join(), /'..\/up.glib' is left out/);
});

test('missing files are added, and the download has every byte', async () => {
    await drop(put('one/c.glib', 'Vertex c.vert\r\nSphere 1\r\n'));
    await opened('c.glib');
    await drop(put('one/c.vert', 'void main() {}\n'));
    await until(() => window.host.files.has('c.vert'));
    const downloads = join(folder, 'downloads');
    await devtools.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
    await press('.editor-buttons button', 'Download this file');
    for (let i = 0; i < 100 && !existsSync(join(downloads, 'c.glib')); ++i) await new Promise((resolve) => setTimeout(resolve, 50));
    assert.deepEqual(readdirSync(downloads), ['c.glib']);
    assert.equal(readFileSync(join(downloads, 'c.glib'), 'latin1'), 'Vertex c.vert\r\nSphere 1\r\n');
});

test('what is dropped last stays, however long an earlier archive takes', async () => {
    const slow = { 'slow.glib': Buffer.from('Sphere 1\n'), 'zeros.bin': Buffer.alloc(60e6) };
    await drop(put('slow.zip', zipSync(slow, { level: 1 })));
    await drop(put('quick.glib', 'Box 1\n'));
    await opened('quick.glib');
    await new Promise((resolve) => setTimeout(resolve, 1500));
    assert.equal(await page.evaluate(() => window.host.scene), 'quick.glib');
});

test('nothing of this was against the policy of the page', () => assert.deepEqual(errors, []));
