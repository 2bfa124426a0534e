// A page with a small scene: values, links, time, the graphics that go and come back.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import puppeteer from 'puppeteer-core';

const web = join(dirname(fileURLToPath(import.meta.url)), '../../build/web');
const folder = mkdtempSync(join(tmpdir(), 'snell-scene-'));
const errors = [];
let browser, page;

const fragment = (color) => `uniform float uA;\nuniform vec2 uMouse;\nuniform float uTime;\nvoid main() { gl_FragColor = vec4(${color}, 0., 1.); }\n`;
const vertex = 'void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n';
const scene = (name) => `# caf\xe9\nVertex s/a.vert\nFragment s/${name}\nProgram P uA <1. 2. 10.>\nSphere 1 20 20\n`;
const files = {
    'a.glib': scene('a.frag'),
    'mouse.glib': scene('mouse.frag'),
    'time.glib': scene('time.frag'),
    's/a.vert': vertex,
    's/a.frag': fragment('.1 * uA, .5'),
    's/mouse.frag': fragment('.1 * uA, .001 * uMouse.x'),
    's/time.frag': fragment('.1 * uA, fract(uTime)'),
};

function pageOf(name) {
    const all = Object.entries(files).map(([file, text]) => [file, Buffer.from(text, 'latin1')]);
    const header = JSON.stringify({ files: all.map(([file, bytes]) => ({ name: file, size: bytes.length, decoded: false })) });
    const archive = gzipSync(Buffer.concat([Buffer.from(`${header}\n`), ...all.map(([, bytes]) => bytes)])).toString('base64');
    const data = JSON.stringify({ scene: name, title: name, values: [], rungs: [], view: '', link: '' });
    const html = readFileSync(join(web, 'page.html'), 'utf8')
        .replace('id="scene">null<', () => `id="scene">${data}<`)
        .replace('id="archive"><', () => `id="archive">${archive}<`);
    const path = join(folder, `${name}.html`);
    writeFileSync(path, html);
    return pathToFileURL(path).href;
}

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const sharp = () => page.waitForFunction(() => / ms/.test(document.querySelector('.status span')?.textContent ?? ''));
const message = () => page.$eval('.message', ({ textContent }) => textContent);
const number = () => page.$eval('.row.slider > .number', ({ value }) => Number(value));
const drawn = () => page.evaluate(() => window.drawn);

async function show(name, hash = '') {
    await page.goto('about:blank');
    await page.goto(pageOf(name) + hash);
    await sharp();
}

before(async () => {
    browser = await puppeteer.launch({
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader'],
    });
    page = await browser.newPage();
    await page.setViewport({ width: 1000, height: 600 });
    page.on('console', (said) => errors.push(said.text()));
    page.on('pageerror', (error) => errors.push(String(error)));
    page.on('dialog', (dialog) => dialog.accept());
    // Counts pictures, and the objects of OpenGL that were made and not deleted.
    await page.evaluateOnNewDocument(() => {
        window.drawn = 0;
        window.alive = {};
        const gl = WebGL2RenderingContext.prototype;
        const around = (name, before) => {
            const old = gl[name];
            gl[name] = function (...args) {
                before(args[0]);
                return old.apply(this, args);
            };
        };
        around('flush', () => ++window.drawn);
        for (const kind of ['Texture', 'Program', 'Buffer', 'Framebuffer', 'Renderbuffer', 'VertexArray', 'Shader']) {
            window.alive[kind] = 0;
            around(`create${kind}`, () => ++window.alive[kind]);
            around(`delete${kind}`, (object) => object && --window.alive[kind]);
        }
    });
});

after(async () => {
    await browser?.close();
    rmSync(folder, { recursive: true });
});

test('while the text is edited, the sliders stay; the text is below the picture', async () => {
    await show('a.glib');
    await page.click('#tab-text');
    const box = (selector) => page.$eval(selector, (element) => element.getBoundingClientRect().toJSON());
    const [picture, text, slider] = [await box('.picture'), await box('#panel-text'), await box('.row.slider')];
    assert.ok(text.top >= picture.bottom && text.height > 100 && picture.height > 100);
    assert.ok(slider.width > 100 && slider.left >= text.right);
    await page.setViewport({ width: 390, height: 844 });
    await page.waitForFunction(() => document.querySelector('#panel-controls').hidden && document.querySelector('#tab-text').role === 'tab');
    await page.setViewport({ width: 1000, height: 600 });
});

test('a link keeps both bounds of a range, after the page is loaded again, and people can read it', async () => {
    await show('a.glib', '#view=rotate_y=30');
    await page.click('.row.slider > .number');
    const type = async (text) => {
        await page.keyboard.type(text);
        await page.keyboard.press('Enter');
    };
    await type('-5');
    await type('40');
    await type('20');
    await pause(500);
    const hash = () => page.evaluate(() => location.hash);
    assert.equal(await hash(), '#P.uA=20&P.uA:range=-5,40&view=rotate_y=30');
    await page.reload();
    await sharp();
    assert.equal(await number(), 20);
    assert.match(await page.$eval('.row.slider .name', ({ title }) => title), /^uA: -5 … 40\n/);
});

test('the link is copied, and says which edits it lacks', async () => {
    await show('a.glib');
    const copied = async (pattern) => {
        await page.click('.menu > summary');
        await page.$$eval('.menu button', (all) => all.find(({ textContent }) => textContent === 'Copy link').click());
        await page.waitForFunction((text) => new RegExp(text).test(document.querySelector('.message').textContent), {}, pattern);
    };
    await copied('^The link to this picture is copied\\.$');
    await page.click('#tab-text');
    await (await page.$('.editor-code >>> .cm-content')).click();
    await page.keyboard.type('# mine\n');
    await copied("copied\\. It leads to the texts without the edits of 'a\\.glib'\\.$");
});

test('what an address asks for in vain is one message, and no problem of the scene', async () => {
    await show('a.glib', `#Foo.bar=1&P.uA=abc&%zz=1&P.uA:range=5,3&view=<b>x</b>&${'x'.repeat(500)}=1`);
    assert.match(await message(), /^The address asks for what this scene does not have: .*, and \d more\.$/);
    assert.ok((await message()).length < 700);
    assert.equal(await page.$eval('.problems', ({ hidden }) => hidden), true);
    assert.equal(await number(), 2);
});

test('each thing that an address asks for in vain is named', async () => {
    for (const asked of ['P.uC=1', 'P.uA=1e999', 'uX=1e999', 'uX=1', 'P.uC:range=1,2', 'LADDER=high', 'view=rotate=1']) {
        await show('a.glib', `#${asked}`);
        assert.match(await message(), /^The address asks for what this scene does not have: .+\.$/, asked);
        assert.equal(await number(), 2, asked);
    }
});

test('a range that is not taken, and what is no name of a ladder, are named as they are written', async () => {
    for (const [asked, said] of [['P.uA:range=5,1', 'P.uA:range=5,1'], ['uX=1', "there is no uniform 'uX'"], ['P.uA=1e999', "the value '1e999' of 'P.uA' is not a number that fits"]]) {
        await show('a.glib', `#${asked}`);
        assert.equal(await message(), `The address asks for what this scene does not have: ${said}.`);
    }
});

test('an address names a uniform without its program, and takes a decimal comma', async () => {
    for (const [asked, value] of [['uA=3.5', 3.5], ['P.uA=4,5', 4.5], ['uA=0,5', 0.5]]) {
        await show('a.glib', `#${asked}`);
        assert.equal(await message(), '', asked);
        assert.equal(await number(), value, asked);
    }
    await show('a.glib', '#P.uA=1,2,3');
    assert.match(await message(), /'uA' takes 1 number, not 3/);
    assert.equal(await number(), 2);
});

test('a value that is taken ends the message about its field', async () => {
    await show('a.glib');
    await page.click('.row.slider > .number');
    for (const [wrong, key, said] of [['1/0', 'Enter', /is not a number\.$/], ['1e999', 'Enter', /is not a number that fits\.$/], ['50', 'Tab', /press Enter/]]) {
        await page.$eval('.row.slider > .number', (field) => (field.focus(), field.select()));
        await page.keyboard.type(wrong);
        await page.keyboard.press(key);
        assert.match(await message(), said, wrong);
        await page.$eval('.row.slider > .number', (field) => (field.focus(), field.select()));
        await page.keyboard.type('3');
        await page.keyboard.press('Enter');
        assert.equal(await message(), '', wrong);
        assert.equal(await number(), 3);
    }
});

test('the picture keeps its size when its line is filled', async () => {
    await page.setViewport({ width: 1000, height: 700 });
    await page.goto('about:blank');
    const sizes = await page.evaluateOnNewDocument(() => {
        window.sizes = new Set();
        document.addEventListener('DOMContentLoaded', () => {
            const watch = new ResizeObserver(([{ contentRect }]) => window.sizes.add(`${contentRect.width} × ${contentRect.height}`));
            const found = new MutationObserver(() => {
                const canvas = document.querySelector('canvas');
                if (canvas) watch.observe(canvas);
            });
            found.observe(document, { childList: true, subtree: true });
        });
    });
    await page.goto(pageOf('a.glib'));
    await sharp();
    await pause(300);
    await page.removeScriptToEvaluateOnNewDocument(sizes.identifier);
    assert.equal(await page.evaluate(() => window.sizes.size), 1);
    assert.equal(await drawn(), 2, 'the small first picture, and the sharp one');
    await page.setViewport({ width: 1000, height: 600 });
});

test('a scene that uses the mouse is drawn when the mouse moves, and else not', async () => {
    await show('mouse.glib');
    await pause(1500);
    const before = await drawn();
    await pause(600);
    assert.equal(await drawn(), before);
    await page.mouse.move(100, 100);
    await pause(300);
    assert.ok((await drawn()) > before);
    assert.equal(await page.$eval('.timebar', ({ hidden }) => hidden), true);
});

test('time runs, pauses, is dragged, and stands still while the page is hidden', async () => {
    await show('time.glib');
    const time = () => page.$eval('.time', ({ textContent }) => parseFloat(textContent));
    const begun = await time();
    await page.waitForFunction((begun) => parseFloat(document.querySelector('.time').textContent) > begun + 0.2, {}, begun);
    const other = await browser.newPage();
    await other.bringToFront();
    await pause(200);
    const hidden = await time();
    await pause(700);
    assert.ok((await time()) < hidden + 0.3, 'it stands still');
    await other.close();
    await page.bringToFront();
    await page.click('.play');
    const paused = await time();
    await pause(300);
    assert.equal(await time(), paused);
    await page.focus('.timebar input');
    await page.keyboard.press('ArrowRight');
    assert.ok((await time()) > paused);
});

test('the menu of a slider makes it logarithmic, and moves it to and fro; an undo stops it', async () => {
    await show('a.glib');
    await page.click('.options summary');
    const choose = (text) => page.evaluate((text) => [...document.querySelectorAll('.options label')].find((label) => label.textContent === text).click(), text);
    await page.waitForSelector('.options .items label');
    await choose('Logarithmic');
    assert.ok(Math.abs((await page.$eval('.row.slider > input', ({ value }) => Number(value))) - Math.log10(2)) < 1e-6);
    await choose('Animate');
    await page.waitForFunction(() => Number(document.querySelector('.row.slider > .number').value) > 2.5);
    await page.keyboard.press('Escape');
    await page.click('.tools button');
    const stopped = await number();
    assert.equal(stopped, 2);
    await pause(200);
    assert.equal(await number(), stopped);
    assert.equal(await page.$eval('.timebar', ({ hidden }) => hidden), true);
});

test('the text with the values has every other byte of the author', async () => {
    await show('a.glib', '#P.uA=7.5');
    const devtools = await page.createCDPSession();
    const downloads = join(folder, 'downloads');
    await devtools.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
    await page.click('.menu summary');
    await page.evaluate(() => [...document.querySelectorAll('.menu button')].find((each) => /these values/.test(each.textContent)).click());
    for (let i = 0; i < 100 && !existsSync(join(downloads, 'a.glib')); ++i) await pause(50);
    assert.deepEqual(readdirSync(downloads), ['a.glib']);
    assert.equal(readFileSync(join(downloads, 'a.glib'), 'latin1'), files['a.glib'].replace('<1. 2. 10.>', '<1. 7.5 10.>'));
});

test('after the graphics were lost and are back, an edit works without a warning', async () => {
    await show('a.glib');
    await page.evaluate(async () => {
        const extension = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
        extension.loseContext();
        await new Promise((resolve) => setTimeout(resolve, 200));
        extension.restoreContext();
    });
    await page.waitForFunction(() => /are back/.test(document.querySelector('.message').textContent));
    await page.click('#tab-text');
    await page.waitForSelector('#editor-code');
    await page.evaluate(() => document.querySelector('#editor-code').shadowRoot.querySelector('.cm-content').focus());
    const before = await drawn();
    await page.keyboard.type('Box 1\n');
    await page.waitForFunction((before) => window.drawn > before, {}, before);
    assert.equal(await page.$eval('.editor-problems', ({ textContent }) => textContent), 'No problems');
    assert.equal(await page.evaluate(() => document.querySelector('canvas').getContext('webgl2').getError()), 0);
});

// As a drop gives them: names are those of single files.
async function drop(contents) {
    await page.evaluate((contents) => {
        const data = new DataTransfer();
        for (const [name, text] of contents) data.items.add(new File([text], name));
        document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
    }, contents);
}

test('values that are set while the graphics are gone are taken, kept and saved', async () => {
    await show('a.glib');
    await page.evaluate(() => document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext());
    await page.waitForFunction(() => /took the graphics away/.test(document.querySelector('.message').textContent));
    await page.click('.row.slider > .number');
    await page.keyboard.type('7');
    await page.keyboard.press('Enter');
    assert.equal(await number(), 7);
    await pause(500);
    assert.equal(await page.evaluate(() => location.hash), '#P.uA=7');
    await page.click('.menu > summary');
    await page.$$eval('.menu button', (all) => all.find(({ textContent }) => textContent === 'Text with these values').click());
    await page.waitForFunction(() => /^Saved a\.glib with these values/.test(document.querySelector('.message').textContent));
});

test('scenes that are opened one after the other leave nothing behind', async () => {
    await show('a.glib');
    await page.waitForSelector('.editor'); // it takes what is dropped
    const open = async (name, radius) => {
        await page.$eval('.status span', (status) => void (status.textContent = ''));
        // A folder of the first scene has the name of this one's shader.
        await drop([[name, `Vertex s\nFragment f\nProgram Q uA <1. 2. 3.>\nSphere ${radius} 30 30\n`], ['s', vertex], ['f', files['s/a.frag']]]);
        await page.waitForFunction((title) => document.title === title, {}, name.replace('.glib', ''));
        await sharp();
        assert.equal(await page.$eval('.problems', ({ hidden }) => hidden), true);
        await pause(800);
        return page.evaluate(() => ({ ...window.alive }));
    };
    const first = await open('one.glib', 1);
    for (const [i, name] of ['two.glib', 'three.glib', 'four.glib'].entries()) assert.deepEqual(await open(name, i + 2), first);
});

test('a section that is folded stays so in its scene only', async () => {
    await show('a.glib');
    await page.waitForSelector('.editor');
    const open = () => page.$eval('.group details', ({ open }) => open);
    await page.$eval('.group details', (details) => void (details.open = false));
    await page.click('#tab-text');
    await (await page.$('.editor-code >>> .cm-content')).click();
    await page.keyboard.type('# mine\n');
    await pause(1000);
    assert.equal(await open(), false);
    await drop([['b.glib', 'Vertex v\nFragment f\nProgram P uA <1. 2. 3.>\nSphere 1 30 30\n'], ['v', vertex], ['f', files['s/a.frag']]]);
    await (await page.waitForSelector('dialog[open] ::-p-text(Discard the edits)')).click();
    await page.waitForFunction(() => document.title === 'b');
    await sharp();
    assert.equal(await open(), true);
});

test('a scene that is opened while another one still reads its images has none of its files', async () => {
    await show('a.glib');
    await page.waitForSelector('.editor');
    const text = 'Vertex v.vert\nFragment only.frag\nProgram Q uA <1. 2. 3.>\nSphere 1 30 30\n';
    const image = `P6\n400 300\n255\n${'x'.repeat(360_000)}`; // large enough for the worker
    await drop([['one.glib', text], ['v.vert', vertex], ['only.frag', files['s/a.frag']], ['big.ppm', image]]);
    await drop([['two.glib', text], ['v.vert', vertex]]);
    await page.waitForFunction(() => document.title === 'two');
    await page.waitForFunction(() => /only\.frag/.test(document.querySelector('.problems').textContent));
    await pause(500);
    assert.match(await page.$eval('.problems', ({ textContent }) => textContent), /only\.frag/);
});

test('nothing was written to the console', () => assert.deepEqual(errors, []));
