// Pages, archives and names that somebody made to harm: nothing of them is executed, and what is damaged is said.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { gzipSync, createGzip } from 'node:zlib';
import { zipSync } from 'fflate';
import { built, builtPage, chromium, drawn, drop, openText, press, run, tab, temporaryFolder, until } from './harness/browser.mjs';

const folder = temporaryFolder();
const markup = '<img src=x onerror=window.hit=1><script>window.hit=1</script>';
const word = '<svg/onload=window.hit=1>';
let page, said;

before(async () => {
    ({ page, said } = await tab(await chromium()));
    await page.evaluateOnNewDocument(() => {
        window.violations = [];
        document.addEventListener('securitypolicyviolation', (event) => window.violations.push(event.violatedDirective));
    });
});

const base64 = (bytes) => Buffer.from(bytes).toString('base64');
const header = (files) => `${JSON.stringify({ files })}\n`;

function archive(files) {
    const parts = Object.entries(files).map(([name, text]) => [name, Buffer.from(text)]);
    return Buffer.concat([Buffer.from(header(parts.map(([name, { length }]) => ({ name, size: length })))), ...parts.map(([, bytes]) => bytes)]);
}

// A page of these blocks, which a hostile author can fill with anything.
async function openPage({ scene = { scene: 'a.glib', title: 'a', values: [], rungs: [], view: '', link: '' }, data = '', title = 'a' }) {
    const escaped = typeof scene === 'string' ? scene : JSON.stringify(scene).replaceAll('<', '\\u003c');
    const html = readFileSync(join(built, 'page.html'), 'utf8')
        .replace('<title>snell</title>', () => `<title>${title.replaceAll('<', '&lt;')}</title>`)
        .replace('id="scene">null<', () => `id="scene">${escaped}<`)
        .replace('id="archive"><', () => `id="archive">${data}<`);
    const path = join(folder, 'page.html');
    writeFileSync(path, html);
    await page.goto(pathToFileURL(path).href);
}

const openFiles = (files, more = {}) => openPage({ data: base64(gzipSync(archive(files))), ...more });

async function harmless() {
    const { hit, violations, images, scripts } = await page.evaluate(() => ({
        hit: window.hit,
        violations: window.violations,
        images: document.querySelectorAll('img:not([src^="blob:null/"]), svg[onload], iframe').length + [...document.images].filter((each) => each.onerror || each.hasAttribute('onerror')).length,
        scripts: [...document.scripts].filter(({ type }) => type === '').length,
    }));
    assert.equal(hit, undefined, 'nothing was executed');
    assert.deepEqual(violations, []);
    assert.equal(images, 0);
    assert.equal(scripts, 1);
    assert.deepEqual(said.splice(0), [], 'the console is silent');
}

const failure = async () => {
    await page.waitForSelector('.failure', { timeout: 30_000 });
    return page.$eval('.failure', (element) => element.textContent);
};

const whole = gzipSync(archive({ 'a.glib': 'Sphere 1\n' }));
const cut = (bytes, share) => bytes.subarray(0, Math.round(bytes.length * share));
const listed = (files, rest = '') => base64(gzipSync(Buffer.from(header(files) + rest)));
const damaged = {
    'base64 that is cut': [base64(whole).slice(0, 41), /cut|damaged|cannot be shown/],
    'base64 with other characters': ['*'.repeat(40), /cannot be shown/],
    'gzip that is cut': [base64(cut(whole, 0.6)), /cannot be shown/],
    'something else than gzip': [base64(Buffer.from('PK\u0003\u0004 an archive of another kind')), /cannot be shown/],
    'gzip with a wrong sum': [base64(Buffer.from(whole).fill(0, whole.length - 8)), /cannot be shown/],
    'no list of files': [base64(gzipSync('Sphere 1')), /list of files .* is damaged/],
    'a list that is no JSON': [base64(gzipSync('{"files":[\n')), /list of files .* is damaged/],
    'a list that is none': [base64(gzipSync('{"files":{"length":1}}\n')), /list of files .* is damaged/],
    'a file without a name': [listed([{ size: 1 }], 'x'), /no name/],
    'a size that is too large': [listed([{ name: 'a.glib', size: 100 }], 'x'), /cut off/],
    'a size beyond all numbers': [listed([{ name: 'a.glib', size: 1e300 }], 'x'), /not a number of bytes/],
    'a size below zero': [listed([{ name: 'a.glib', size: -1 }], 'x'), /not a number of bytes/],
    'bytes of no file': [listed([{ name: 'a.glib', size: 1 }], 'xyz'), /longer than its files/],
    'one name twice': [listed([{ name: 'a.glib', size: 1 }, { name: 'a.glib', size: 1 }], 'xy'), /twice/],
    'a folder that is a file': [listed([{ name: 'a', size: 1 }, { name: 'a/b', size: 1 }], 'xy'), /is a file, too/],
    'a name that leads out': [listed([{ name: 'x/../../a.glib', size: 1 }], 'x'), /leads to another folder/],
    'an absolute name': [listed([{ name: '/dev/a.glib', size: 1 }], 'x'), /absolute/],
    'too many files': [listed(Array.from({ length: 10_001 }, (_, i) => ({ name: `${i}`, size: 0 }))), /more than 10000 files/],
};

for (const [what, [data, message]] of Object.entries(damaged)) {
    test(`${what} is said`, async () => {
        await openPage({ data });
        assert.match(await failure(), message);
        await harmless();
    });
}

test('a bomb ends at the limit', async () => {
    const zip = createGzip({ level: 9 });
    const parts = [];
    zip.on('data', (part) => parts.push(part));
    const zeros = Buffer.alloc(1 << 20);
    for (let i = 0; i < 600; ++i) if (!zip.write(zeros)) await new Promise((resolve) => zip.once('drain', resolve));
    await new Promise((resolve) => zip.end(resolve));
    await openPage({ data: base64(Buffer.concat(parts)) });
    assert.match(await failure(), /larger than a page may be/);
    await harmless();
});

for (const [what, scene] of Object.entries({
    'is cut': '{"scene":"a.gl',
    'is a number': '7',
    'has numbers for texts': '{"scene":7,"title":{},"values":3}',
    'is a list': '[]',
})) {
    test(`a page whose scene's data ${what} opens or says so`, async () => {
        await openPage({ scene, data: base64(whole) });
        await until(page, () => document.querySelector('.failure, .editor-welcome'));
        await harmless();
    });
}

test('a scene that is not in the archive is said', async () => {
    await openPage({ scene: { scene: `../${markup}.glib`, title: markup, values: [`${word}=1`, '=', 'A.b'], rungs: [word], view: markup, link: 'javascript:window.hit=1' }, data: base64(whole) });
    await page.waitForSelector('.problem');
    assert.match(await failure(), /has 1 error/);
    assert.equal(await page.$eval('a', (link) => link.getAttribute('href') ?? ''), '');
    await harmless();
});

test('markup in titles, names and values is text', async () => {
    const name = `a/${markup.replaceAll('/', '')}.glib`;
    const text = `##OpenGL GLIB\nProgram ${word} uA <0. .5 1.>\nSphere 1\n`;
    const scene = { scene: name, title: markup, values: [`${word}.uA=1`, `${markup}=1`], rungs: [`${word}=x`], view: `${markup}=1`, link: `https://example.org/"${markup}` };
    await openFiles({ [name]: text, [`a/${word.replaceAll('/', '')}.frag`]: 'void main() {}\n' }, { scene, title: markup });
    await until(page, () => document.querySelector('.failure') || document.querySelector('.cover').hidden);
    assert.equal(await page.title(), markup);
    assert.equal(await page.$eval('h1', (heading) => heading.textContent), markup);
    await openText(page);
    await page.waitForSelector('.editor-tabs [role=tab]');
    await harmless();
});

test('markup in messages is text, in the list and in the editor', async () => {
    const text = `##OpenGL GLIB\n${word}\nVertex ${markup.replaceAll(' ', '')}.vert\n"${markup}"\nProgram A u${word} 1\nMessageBox ${markup}\n`;
    await openFiles({ 'a.glib': text });
    await page.waitForSelector('.problem');
    const list = await page.$eval('.problems', (element) => element.textContent);
    assert.ok(list.includes(markup.replaceAll(' ', '')), list);
    await openText(page);
    await page.waitForSelector('.editor-code >>> .cm-lint-marker-error');
    await harmless();
});

test('a link with markup sets nothing and runs nothing', async () => {
    await openFiles({ 'a.glib': '##OpenGL GLIB\nSphere 1\n' });
    await drawn(page);
    await page.evaluate((text) => void (location.hash = text), `A.${encodeURIComponent(markup)}=1&view=${encodeURIComponent(markup)}&%=%&__proto__.x=1`);
    await until(page, () => /does not have/.test(document.querySelector('.message').textContent));
    assert.equal(await page.evaluate(() => ({}).x), undefined);
    await harmless();
});

test('archives that are dropped run nothing and write nowhere else', async () => {
    const entries = { '../up.glib': 'x', 'C:/x.glib': 'x', [`a/${markup.replaceAll('/', '')}.glib`]: `${word}\n`, [`b/${word.replaceAll('/', '')}.glib`]: 'Sphere 1\n', '__proto__': 'x' };
    const path = join(folder, 'evil.zip');
    writeFileSync(path, zipSync(Object.fromEntries(Object.entries(entries).map(([name, text]) => [name, Buffer.from(text)]))));
    await page.goto(builtPage('snell.html'));
    await page.waitForSelector('.editor-welcome li');
    await drop(page, path);
    await page.waitForSelector('.editor-dialog[open]');
    await harmless();
    await press(page, 'a/', '.editor-dialog');
    await page.waitForSelector('.problem');
    assert.match(await page.$eval('.message', (element) => element.textContent), /'\.\.\/up\.glib' is left out/);
    await harmless();
});

test('the policy of the page keeps from running and loading what it does not know', async () => {
    await openFiles({ 'a.glib': '##OpenGL GLIB\nSphere 1\n' });
    await drawn(page);
    const found = await page.evaluate(async () => {
        const script = document.createElement('script');
        script.textContent = 'window.hit = 1';
        document.body.append(script);
        document.body.insertAdjacentHTML('beforeend', '<img src=x onerror="window.hit=2"><a href="javascript:window.hit=3" id="bad">x</a>');
        document.getElementById('bad').click();
        const fetched = await fetch('https://example.org/').then(() => 'yes', () => 'no');
        await new Promise((resolve) => setTimeout(resolve, 300));
        return { hit: window.hit, fetched, violations: [...new Set(window.violations)].sort() };
    });
    assert.equal(found.hit, undefined);
    assert.equal(found.fetched, 'no');
    assert.deepEqual(found.violations, ['connect-src', 'img-src', 'script-src-attr', 'script-src-elem']);
    said.length = 0;
});

test('a gallery of scenes with markup in their names is text', async () => {
    const from = join(folder, 'scenes');
    mkdirSync(from);
    const name = markup.replaceAll('/', '');
    writeFileSync(join(from, `${name}.glib`), '##OpenGL GLIB\nSphere 1\n');
    writeFileSync(join(from, `${word.replaceAll('/', '')}.glib`), `##OpenGL GLIB\n${markup}\n`);
    await run(['web', '--gallery', from, '-o', join(folder, 'gallery')]);
    await page.goto(pathToFileURL(join(folder, 'gallery/index.html')).href);
    const state = await page.evaluate(() => ({
        hit: window.hit,
        violations: window.violations,
        scripts: document.scripts.length,
        pictures: [...document.images].map(({ src }) => src.slice(0, 11)),
        text: document.body.textContent,
    }));
    assert.equal(state.hit, undefined);
    assert.deepEqual(state.violations, []);
    assert.equal(state.scripts, 0);
    assert.ok(state.pictures.every((source) => source === 'data:image/'), String(state.pictures));
    assert.ok(state.text.includes(name), state.text);
    await page.click('main a, a[href$=".html"]');
    await drawn(page);
    assert.equal(await page.title(), name);
    assert.equal(await page.evaluate(() => window.hit), undefined);
    assert.deepEqual(said.splice(0), []);
});
