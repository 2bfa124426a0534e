// A folder that stays open: a real folder of the browser stands in for the one that its dialog gives.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { built, chord, chromium, drawn, openText, press, served, tab, until } from './harness/browser.mjs';

const vertex = 'void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n';
const fragment = (green) => `uniform float uA;\nvoid main() { gl_FragColor = vec4(.1 * uA, ${green}, 0., 1.); }\n`;
const scene = '# first\r\nVertex a.vert\r\nFragment a.frag\r\nProgram P uA <1. 2. 10.>\r\nSphere 1 20 20\r\n';
const files = { 'a.glib': scene, 'b.glib': scene.replace('first', 'second'), 'a.vert': vertex, 'a.frag': fragment('.5') };
let origin, browser, page, said;

before(async () => {
    origin = (await served(join(built, 'site'))).address;
    browser = await chromium();
    ({ page, said } = await tab(browser));
    await page.evaluateOnNewDocument(standIn);
    await page.goto(origin);
    for (const [name, text] of Object.entries(files)) await page.evaluate((name, text) => window.put(name, text), name, text);
});

// In the page: the folder that its dialog gives.
function standIn() {
    const folder = () => navigator.storage.getDirectory().then((root) => root.getDirectoryHandle('room', { create: true }));
    window.showDirectoryPicker = folder;
    // Another program writes.
    window.put = async (name, text) => {
        const handle = await (await folder()).getFileHandle(name, { create: true });
        const writer = await handle.createWritable();
        await writer.write(text);
        await writer.close();
    };
    window.removed = async (name) => (await folder()).removeEntry(name);
    // Empty while it is being written.
    window.text = async (name) => (await (await (await folder()).getFileHandle(name)).getFile()).text().catch(() => '');
}

const message = (pattern) => until(page, (text) => new RegExp(text).test(document.querySelector('.message').textContent), pattern.source);
const text = (name) => page.evaluate((name) => window.text(name), name);
const put = (name, what) => page.evaluate((name, what) => window.put(name, what), name, what);
const number = () => page.$eval('.row.slider > .number', ({ value }) => Number(value));
const shown = (pattern, where = page) => until(where, (text) => new RegExp(text).test(document.querySelector('.editor-code').shadowRoot.querySelector('.cm-content').textContent), pattern);

async function type(value) {
    await page.$eval('.row.slider > .number', (field) => (field.focus(), field.select()));
    await page.keyboard.type(value);
    await page.keyboard.press('Enter');
}

async function openFolder(where = page) {
    await press(where, 'Open folder', '.editor-welcome');
    await where.waitForSelector('.editor-dialog[open] .thumb canvas');
}

test('a folder that the browser does not give is said', async () => {
    const other = await tab(browser);
    await other.page.evaluateOnNewDocument(() => {
        window.showDirectoryPicker = () => Promise.reject(new DOMException('The user aborted a request.', 'AbortError'));
    });
    await other.page.goto(origin);
    await press(other.page, 'Open folder', '.editor-welcome');
    await until(other.page, () => document.querySelector('.message').textContent === 'No folder was opened.');
    assert.deepEqual(other.said, []);
    await other.page.close();
});

test('a folder lists its scenes with pictures, and one opens', async () => {
    await openFolder();
    await until(page, () => document.querySelectorAll('.thumb canvas').length === 2);
    const painted = await page.$$eval('.thumb canvas', (all) => all.map((each) => new Set(each.getContext('2d').getImageData(0, 0, 160, 120).data).size));
    assert.ok(painted.every((colours) => colours > 3), String(painted));
    await press(page, 'room/a.glib', '.editor-dialog[open]');
    await drawn(page);
    assert.equal(await page.title(), 'a');
    await openText(page);
});

// The page has read what another program wrote into the scene.
async function seenWithinASecond(page, what) {
    const begun = Date.now();
    await page.evaluate((name, text) => window.put(name, text), 'a.glib', scene.replace('first', what));
    await shown(what, page);
    const milliseconds = Date.now() - begun;
    assert.ok(milliseconds < 1500, `${milliseconds} ms`);
}

test('what another program saves is seen within a second', () => seenWithinASecond(page, 'observed'));

test('without an observer, too', async () => {
    const other = await tab(browser);
    await other.page.evaluateOnNewDocument(standIn);
    await other.page.evaluateOnNewDocument(() => void delete window.FileSystemObserver);
    await other.page.goto(origin);
    await openFolder(other.page);
    await press(other.page, 'room/a.glib', '.editor-dialog[open]');
    await drawn(other.page);
    await openText(other.page);
    await seenWithinASecond(other.page, 'looked at');
    await other.page.close();
    await page.bringToFront();
});

test('a mistake keeps the picture and stands at its line', async () => {
    const colour = () => page.$eval('canvas', (canvas) => canvas.toDataURL().length > 1000);
    assert.ok(await colour());
    await put('a.frag', fragment('.5 +'));
    await until(page, () => [...document.querySelectorAll('.editor-problems .problem.error')].some((each) => /room\/a\.frag:2:/.test(each.textContent)));
    assert.ok(await colour());
    assert.equal(page.workers().length, 1, 'the text was checked by the worker');
    await put('a.frag', fragment('.8'));
    await until(page, () => !document.querySelector('.editor-problems .problem.error'));
});

test('Save writes the numbers, and nothing else', async () => {
    await type('7.5');
    const before = await text('a.glib');
    await press(page, 'Save', '.tools');
    await message(/^Saved a\.glib\./);
    assert.equal(await text('a.glib'), before.replace('<1. 2. 10.>', '<1. 7.5 10.>'));
    assert.equal(await text('a.frag'), fragment('.8'));
    await shown('7\\.5');
    await until(page, () => !document.querySelector('.editor-tabs [data-edited=true]'));
    await until(page, () => document.querySelector('.dot').style.visibility === 'hidden'); // it is the scene's value now
    assert.equal(await number(), 7.5);
});

test('nothing is overwritten that has changed meanwhile', async () => {
    await type('3');
    // Right before the file is written, and before the page has looked at it.
    const other = scene.replace('first', 'of another program');
    await page.evaluate((other) => {
        const make = FileSystemFileHandle.prototype.createWritable;
        FileSystemFileHandle.prototype.createWritable = async function (...options) {
            FileSystemFileHandle.prototype.createWritable = make;
            const writer = await make.apply(this, options);
            await window.put('a.glib', other);
            return writer;
        };
    }, other);
    await press(page, 'Save', '.tools');
    await message(/^Nothing was written: another program has changed 'room\/a\.glib'/);
    assert.equal(await text('a.glib'), other);
    await shown('of another program');
});

test('an edit here and there: the author chooses', async () => {
    await (await page.$('.editor-code >>> .cm-content')).click();
    await chord(page, 'Home');
    await page.keyboard.type('# mine\n');
    await until(page, () => document.querySelector('.editor-tabs [data-edited=true]'));
    await put('a.glib', scene.replace('first', 'theirs'));
    await page.waitForSelector('.editor-dialog[open]');
    await press(page, 'Keep my edits', '.editor-dialog[open]');
    await shown('# mine');
    await press(page, 'Save', '.tools');
    await message(/^Saved a\.glib\./);
    assert.match(await text('a.glib'), /^# mine\r\n/);
});

// In the page: types into the text as soon as `prototype` does something.
function typedDuring(prototype, act, what) {
    const before = prototype[act];
    prototype[act] = function (...all) {
        prototype[act] = before;
        document.execCommand('insertText', false, what);
        return before.apply(this, all);
    };
}

test('what is typed while the file is written stays an edit', async () => {
    await (await page.$('.editor-code >>> .cm-content')).click();
    await chord(page, 'Home');
    await page.keyboard.type('# one\n');
    await page.evaluate(`(${typedDuring})(FileSystemWritableFileStream.prototype, 'close', 'two ')`);
    // Without taking the focus from the text.
    await page.$$eval('.tools button', (all) => all.find(({ textContent }) => textContent.trim() === 'Save').click());
    await shown('# onetwo # mine');
    await until(page, async () => (await window.text('a.glib')).startsWith('# one\r\n# mine'));
    await new Promise((resolve) => setTimeout(resolve, 300));
    await shown('# onetwo # mine');
    await page.waitForSelector('.editor-tabs [data-edited=true]');
    await press(page, 'Save', '.tools');
    await until(page, () => !document.querySelector('.editor-tabs [data-edited=true]'));
    assert.match(await text('a.glib'), /^# one\r\ntwo # mine/);
    await put('a.glib', scene.replace('first', 'mine'));
    await shown('^# mine');
});

test('a text that was changed twice is not saved before it is said whose it is', async () => {
    const before = await text('a.glib');
    const theirs = before.replace('# mine', '# theirs');
    await (await page.$('.editor-code >>> .cm-content')).click();
    await chord(page, 'Home');
    await page.keyboard.type('# here\n');
    await page.waitForSelector('.editor-tabs [data-edited=true]');
    await put('a.glib', theirs);
    const choose = async (answer) => {
        await page.waitForSelector('.editor-dialog[open]');
        await press(page, answer, '.editor-dialog[open]');
        await until(page, () => !document.querySelector('.editor-dialog[open]'));
    };
    await choose('Cancel');
    await press(page, 'Save', '.tools');
    await choose('Cancel');
    await message(/^Nothing was written: a\.glib is changed by another program, too\./);
    assert.equal(await text('a.glib'), theirs);
    await press(page, 'Save', '.tools');
    await choose('Keep my edits');
    await until(page, async () => (await window.text('a.glib')).startsWith('# here'));
    await put('a.glib', before);
    await shown('^# mine');
});

test('values are there again after another scene of the folder', async () => {
    const open = async (name) => {
        await press(page, 'Scenes', '.tools');
        await page.waitForSelector('.editor-dialog[open] .thumb canvas');
        await press(page, name, '.editor-dialog[open]');
        await until(page, (name) => document.title === name.replace(/^.*\/|\.glib$/g, ''), name);
        await drawn(page);
    };
    await type('6.5');
    await open('room/b.glib');
    assert.notEqual(await number(), 6.5);
    await open('room/a.glib');
    assert.equal(await number(), 6.5);
    await openText(page);
    await press(page, 'Reset all', '.tools');
});

test('a slider that is dragged while its scene is saved goes on', async () => {
    const { x, y, width, height } = await (await page.$('.row.slider input[type=range]')).boundingBox();
    await page.mouse.move(x + .3 * width, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + .6 * width, y + height / 2, { steps: 5 });
    const before = await text('a.glib');
    await chord(page, 's');
    await until(page, async (before) => (await window.text('a.glib')) !== before, before);
    await new Promise((resolve) => setTimeout(resolve, 500));
    const saved = await number();
    await page.mouse.move(x + .9 * width, y + height / 2, { steps: 5 });
    await page.mouse.up();
    assert.ok((await number()) > saved + 1, `${saved}, ${await number()}`);
    await put('a.glib', before);
    await shown('^# mine');
    await press(page, 'Reset all', '.tools');
});

test('a file that is gone is an error, and one that comes back is none', async () => {
    const missing = () => [...document.querySelectorAll('.editor-problems .problem.error')].some((each) => /a\.frag/.test(each.textContent));
    await page.evaluate(() => window.removed('a.frag'));
    await until(page, missing);
    await new Promise((resolve) => setTimeout(resolve, 600));
    assert.ok(await page.evaluate(missing), 'the text in the editor took the place of the file');
    assert.equal((await page.$$eval('.editor-tabs button', (all) => all.map(({ title }) => title))).includes('room/a.frag'), false);
    await put('a.frag', fragment('.8'));
    await until(page, () => !document.querySelector('.editor-problems .problem.error'));
});

test('edits of a file that is renamed stay in the page', async () => {
    const tabs = () => page.$$eval('.editor-tabs button', (all) => all.map(({ title }) => title));
    const choose = (name) => page.evaluate((name) => [...document.querySelectorAll('.editor-tabs button')].find(({ title }) => title.endsWith(name)).click(), name);
    await choose('a.frag');
    await (await page.$('.editor-code >>> .cm-content')).click();
    await chord(page, 'Home');
    await page.keyboard.type('// an hour of work\n');
    await shown('an hour of work');
    await page.evaluate(async () => {
        await window.put('c.frag', await window.text('a.frag'));
        await window.put('a.glib', (await window.text('a.glib')).replace('a.frag', 'c.frag'));
        await window.removed('a.frag');
    });
    await until(page, () => [...document.querySelectorAll('.editor-tabs button')].some(({ title }) => title.endsWith('c.frag')));
    await new Promise((resolve) => setTimeout(resolve, 600));
    assert.ok((await tabs()).some((title) => title.endsWith('a.frag')), 'the edits are gone');
    await choose('a.frag');
    await shown('an hour of work');
    await put('a.frag', fragment('.8'));
    await page.waitForSelector('.editor-dialog[open]');
    await press(page, 'Take', '.editor-dialog[open]');
    await page.evaluate(async () => {
        await window.put('a.glib', (await window.text('a.glib')).replace('c.frag', 'a.frag'));
        await window.removed('c.frag');
    });
    await choose('a.glib');
    await shown('a.frag');
    await until(page, () => !document.querySelector('.editor-problems .problem.error'));
});

test('a scene that is gone stays in the page', async () => {
    const before = await text('a.glib');
    await page.evaluate(() => window.removed('a.glib'));
    await message(/^'room\/a\.glib' is not in the folder any more/);
    await shown('# mine');
    await put('a.glib', before);
    await until(page, () => !document.querySelector('.editor-problems .problem.error'));
});

test('a download of a folder saves nothing in it', async () => {
    await (await page.$('.editor-code >>> .cm-content')).click();
    await chord(page, 'Home');
    await page.keyboard.type('# more\n');
    await page.$$eval('.editor-buttons button', (all) => all.find(({ textContent }) => textContent.startsWith('Download .zip')).click());
    await page.waitForSelector('.editor-tabs [data-edited=true]');
    await press(page, 'Save', '.tools');
    await until(page, async () => (await window.text('a.glib')).startsWith('# more'));
    await put('a.glib', scene.replace('first', 'mine'));
    await shown('^# mine');
});

test('no link leads to a folder', async () => {
    await page.click('.menu > summary');
    await press(page, 'Copy link', '.menu');
    await message(/^A link leads to no files that were opened here/);
});

test('after a reload the folder is open again, with the values as they were', async () => {
    await type('4.5');
    await until(page, () => /uA=4\.5/.test(location.hash));
    await page.reload();
    await drawn(page);
    assert.equal(await page.title(), 'a');
    assert.equal(await number(), 4.5);
    await openText(page);
    await put('a.glib', scene.replace('first', 'seen again'));
    await shown('seen again');
});

test('edits survive a reload, are offered with their time, and taken or discarded', async () => {
    for (const taken of [true, false]) {
        await (await page.$('.editor-code >>> .cm-content')).click();
        await chord(page, 'Home');
        await page.keyboard.type(taken ? '# kept ' : '# gone ');
        await shown(taken ? '# kept' : '# gone');
        await new Promise((resolve) => setTimeout(resolve, 700));
        await page.reload();
        await page.waitForSelector('.editor-dialog[open]');
        const offer = await page.$eval('.editor-dialog[open]', ({ textContent }) => textContent);
        assert.match(offer, new RegExp(`${new Date().getFullYear()}.*'room/a.glib'`));
        await press(page, taken ? 'Take the edits' : 'Discard the edits', '.editor-dialog[open]');
        await drawn(page);
        await openText(page);
        await shown(taken ? '# kept' : '# kept # seen again|^((?!# gone).)*$');
        assert.equal(await page.$eval('.editor-code >>> .cm-content', (code) => code.textContent.includes('# gone')), false);
        if (taken) await press(page, 'Save', '.tools');
        if (taken) await message(/^Saved/);
    }
});

test('drafts of several visits are offered one by one', async () => {
    const offered = (heading, text) =>
        until(
            page,
            (heading, text) => {
                const offer = document.querySelector('.editor-dialog[open]')?.textContent ?? '';
                return offer.includes(heading) && offer.includes(text);
            },
            heading,
            text,
        );
    for (const more of ['# first visit ', '# second visit ']) {
        await (await page.$('.editor-code >>> .cm-content')).click();
        await chord(page, 'Home');
        await page.keyboard.type(more);
        await shown(more.trim());
        await new Promise((resolve) => setTimeout(resolve, 700));
        await page.reload();
        await offered('Edits that were not saved', 'room/a.glib');
        if (more.startsWith('# first')) await press(page, 'Cancel', '.editor-dialog[open]');
        else break;
        await openText(page);
    }
    await offered('(1 of 2)', 'room/a.glib');
    await press(page, 'Discard', '.editor-dialog[open]');
    await offered('(2 of 2)', 'room/a.glib');
    await press(page, 'Take the edits', '.editor-dialog[open]');
    await openText(page);
    await shown('# first visit');
    await chord(page, 'Home');
    await press(page, 'Save', '.tools');
    await message(/^Saved/);
});

test('an edit that is made while a draft is written is kept, too', async () => {
    await (await page.$('.editor-code >>> .cm-content')).click();
    await chord(page, 'Home');
    await page.evaluate(`(${typedDuring})(IDBObjectStore.prototype, 'put', 'late ')`);
    await page.keyboard.type('early ');
    await shown('early late ');
    await new Promise((resolve) => setTimeout(resolve, 1200));
    await page.reload();
    await page.waitForSelector('.editor-dialog[open]');
    await press(page, 'Take the edits', '.editor-dialog[open]');
    await drawn(page);
    await openText(page);
    await shown('early late ');
    await chord(page, 'Home');
    await press(page, 'Save', '.tools');
    await message(/^Saved/);
});

test('a draft is not mixed with a newer file', async () => {
    await (await page.$('.editor-code >>> .cm-content')).click();
    await page.keyboard.type('# old draft ');
    await new Promise((resolve) => setTimeout(resolve, 800));
    await page.goto(`${origin}manifest.json`);
    await put('a.glib', scene.replace('first', 'newer'));
    await page.goto(origin);
    await until(page, () => /belong to an older text/.test(document.querySelector('.editor-dialog[open]')?.textContent));
    await press(page, 'Discard', '.editor-dialog[open]');
    assert.equal(await text('a.glib'), scene.replace('first', 'newer'));
});

test('the start page lists the folder that was open, and opens it', async () => {
    const other = await tab(browser);
    await other.page.evaluateOnNewDocument(() => sessionStorage.clear());
    await other.page.goto(origin);
    await other.page.waitForFunction(() => [...document.querySelectorAll('.editor-welcome h3')].some((each) => /that were open/.test(each.textContent)));
    await press(other.page, 'room', '.editor-welcome');
    await drawn(other.page);
    assert.equal(await other.page.title(), 'a');
    assert.deepEqual(other.said, []);
    await other.page.close();
});

test('edits survive a crash of the tab', async () => {
    await openText(page);
    await (await page.$('.editor-code >>> .cm-content')).click();
    await page.keyboard.type('# before the crash ');
    await shown('# before the crash');
    await new Promise((resolve) => setTimeout(resolve, 800));
    const crashed = new Promise((resolve) => page.once('error', resolve));
    const devtools = await page.createCDPSession();
    devtools.send('Page.crash').catch(() => undefined);
    await crashed;
    const other = await tab(browser);
    await other.page.goto(origin);
    await other.page.waitForSelector('.editor-welcome h3');
    await press(other.page, 'room', '.editor-welcome');
    await other.page.waitForSelector('.editor-dialog[open]');
    await press(other.page, 'Take the edits', '.editor-dialog[open]');
    await openText(other.page);
    await until(other.page, () => /# before the crash/.test(document.querySelector('.editor-code').shadowRoot.textContent));
    await other.page.close();
});

test('where the browser keeps nothing, the first edit says so, and the page asks before it is left', async () => {
    const other = await tab(browser);
    const asked = [];
    other.page.on('dialog', (dialog) => asked.push(dialog.type()));
    await other.page.evaluateOnNewDocument(() => {
        IDBFactory.prototype.open = () => {
            throw new DOMException('not in this window', 'SecurityError');
        };
    });
    await other.page.goto(origin);
    await other.page.waitForSelector('.editor-welcome h3');
    await press(other.page, 'New scene', '.editor-welcome');
    await drawn(other.page);
    await openText(other.page);
    await (await other.page.$('.editor-code >>> .cm-content')).click();
    await other.page.keyboard.type('# lost ');
    await until(other.page, () => /keeps no drafts here/.test(document.querySelector('.message').textContent));
    await other.page.reload();
    assert.deepEqual(asked, ['beforeunload']);
    assert.deepEqual(other.said, []);
    await other.page.close();
});

test('the console is silent', () => assert.deepEqual(said.filter((text) => !/404/.test(text)), [])); // an icon of the manifest
