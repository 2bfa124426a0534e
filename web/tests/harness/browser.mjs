// What tests in browsers share: browsers with fresh profiles, pages by `snell web`, and what the pages say.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

export const root = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
export const built = resolve(process.env.SNELL_WEB ?? join(root, 'build/web'));
const snell = process.env.SNELL ?? join(root, 'build/release/bin/snell');

// What is to end with the file's tests, the newest first. A hook of its own would end with the hook that it is made in.
const ends = [];
after(async () => {
    for (const end of ends.reverse()) await end();
});

// A folder that is gone after the tests of the file.
export function temporaryFolder() {
    const folder = mkdtempSync(join(tmpdir(), 'snell-web-'));
    ends.push(() => rmSync(folder, { recursive: true, force: true }));
    return folder;
}

// Runs the native program from the repository's folder.
export function run(options, { status = 0, env = {} } = {}) {
    return new Promise((done, failed) => {
        const child = spawn(snell, options, { cwd: root, env: { ...process.env, SNELL_WEB: built, ...env } });
        let said = '';
        for (const stream of [child.stdout, child.stderr]) stream.on('data', (part) => void (said += part));
        child.on('error', failed);
        child.on('close', (code) => (code === status ? done(said) : failed(new Error(`snell ${options[0]}: status ${code}\n${said}`))));
    });
}

// The address of a page that `snell web` makes of a scene.
export async function pageOf(folder, scene, ...options) {
    const path = join(folder, `${scene.replace(/^.*\/|\.glib$/g, '')}.html`);
    await run(['web', scene, '-o', path, ...options]);
    return pathToFileURL(path).href;
}

export const builtPage = (name) => pathToFileURL(join(built, name)).href;

const types = { html: 'text/html', js: 'text/javascript', css: 'text/css', json: 'application/manifest+json', svg: 'image/svg+xml' };

// The address of a static host of the folder, which ends with the file's tests, or by `close`.
export async function served(folder, headers = {}) {
    const server = createServer((request, response) => {
        const name = new URL(request.url, 'http://x').pathname.replace(/\/$/, '/index.html').slice(1);
        const path = join(folder, decodeURIComponent(name));
        response.setHeader('Content-Type', types[name.split('.').pop()] ?? 'text/plain');
        for (const [header, value] of Object.entries(headers)) response.setHeader(header, value);
        if (!existsSync(path)) response.statusCode = 404;
        response.end(existsSync(path) ? readFileSync(path) : '');
    });
    await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
    const close = () => new Promise((closed) => (server.close(closed), server.closeAllConnections()));
    ends.push(close);
    return { address: `http://127.0.0.1:${server.address().port}/`, close };
}

export async function chromium(...more) {
    const browser = await puppeteer.launch({
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader', '--hide-scrollbars', ...more],
        protocolTimeout: 120_000,
    });
    ends.push(() => browser.close());
    return browser;
}

// A display for what draws only on one: its name.
function display() {
    return new Promise((started, failed) => {
        const server = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
        server.on('error', failed);
        server.stdio[3].once('data', (number) => started(`:${String(number).trim()}`));
        ends.push(() => server.kill());
    });
}

// Without graphics hardware, Firefox draws WebGL only if it is told to, and only on a display.
export async function firefox() {
    const env = { ...process.env, DISPLAY: await display() };
    const extraPrefsFirefox = {
        'webgl.force-enabled': true,
        'webgl.disable-fail-if-major-performance-caveat': true,
        'webgl.out-of-process': false,
        'security.sandbox.content.level': 0,
        'gfx.x11-egl.force-enabled': true,
    };
    const browser = await puppeteer.launch({
        browser: 'firefox',
        executablePath: process.env.FIREFOX ?? '/usr/bin/firefox-esr',
        extraPrefsFirefox,
        env,
        headless: false,
        timeout: 60_000,
    });
    ends.push(() => browser.close());
    return browser;
}

// Notes of the driver on its speed, such as that a read of pixels, which a saved picture is, waits for the graphics.
const harmless = /GL Driver Message \(OpenGL, Performance,/;

// A tab that keeps what the console, the page's policy and exceptions say in `said`.
export async function tab(browser, { width = 1000, height = 700, still = true } = {}) {
    const page = await browser.newPage();
    const said = [];
    page.on('console', (message) => {
        const text = message.text();
        if (['error', 'warn', 'warning'].includes(message.type()) && !harmless.test(text)) said.push(text);
    });
    page.on('pageerror', (error) => said.push(String(error)));
    // Pages with edits ask before they are left.
    page.on('dialog', (dialog) => dialog.accept());
    await page.setViewport({ width, height });
    // Scenes with a timer stand still.
    if (still) await page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]);
    return { page, said };
}

export const until = (page, condition, ...values) => page.waitForFunction(condition, { timeout: 60_000, polling: 30 }, ...values);

// The line below the picture has its size, and the cover is gone. What takes long here is drawn all the same.
export const drawn = (page) =>
    until(page, () => {
        const slow = document.querySelector('dialog[open][aria-label="This scene takes long"] button');
        slow?.click();
        return document.querySelector('.cover')?.hidden && /^\d+ × \d+, \d+ ms$/.test(document.querySelector('.status span').textContent);
    });

export async function shows(page, address) {
    await page.goto(address);
    await drawn(page);
}

// Shows the text: its button hides it again.
export async function openText(page) {
    if (await page.$eval('#panel-text', (panel) => panel.hidden)) await page.click('#tab-text');
    await page.waitForSelector('.editor-code >>> .cm-content');
}

// Presses the first visible button whose text begins so.
export async function press(page, text, within = '') {
    const found = await page.evaluateHandle(
        (selector, begin) => [...document.querySelectorAll(selector)].find((each) => each.checkVisibility() && each.textContent.startsWith(begin)),
        `${within} button`,
        text,
    );
    await (found.asElement() ?? assert.fail(`there is no button '${text}'`)).click();
}

export async function chord(page, key, ...held) {
    const keys = held.length > 0 ? held : ['Control'];
    for (const each of keys) await page.keyboard.down(each);
    await page.keyboard.press(key);
    for (const each of keys) await page.keyboard.up(each);
}

export async function drop(page, ...files) {
    const devtools = await page.createCDPSession();
    const data = { items: [], files, dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop']) await devtools.send('Input.dispatchDragEvent', { type, x: 150, y: 100, data });
    await devtools.detach();
}

// Keeps the bytes of every download in window.saved, in base64: call it before the page is opened.
export function keepDownloads(page) {
    return page.evaluateOnNewDocument(() => {
        window.saved = [];
        const make = URL.createObjectURL;
        URL.createObjectURL = (blob) => {
            if (blob.type.startsWith('image/') || blob.type.startsWith('application/')) {
                const reader = new FileReader();
                reader.onload = () => window.saved.push(reader.result.split(',')[1]);
                reader.readAsDataURL(blob);
            }
            return make.call(URL, blob);
        };
    });
}

// The bytes of the next download.
export async function download(page, act) {
    await page.evaluate(() => void (window.saved.length = 0));
    await act();
    await until(page, () => window.saved.length > 0);
    return Buffer.from(await page.evaluate(() => window.saved[0]), 'base64');
}

// The page's picture as PNG, by its own dialog.
export function savedPicture(page, width, height, samples) {
    return download(page, async () => {
        await page.click('.menu > summary');
        await page.waitForSelector('.menu[open] button');
        await press(page, 'Picture as PNG');
        const fields = await page.$$('dialog[open] input');
        for (const [i, value] of [width, height, samples].entries()) await fields[i].evaluate((input, text) => void (input.value = text), String(value));
        await press(page, 'Save PNG', 'dialog[open]');
    });
}
