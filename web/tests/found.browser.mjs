// What was found in pages: heavy and endless shaders, images and memory beyond limits, lost graphics, room for the text.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { crc32, deflateSync } from 'node:zlib';
import { builtPage, chord, chromium, drawn, drop, openText, pageOf, press, run, shows, tab, temporaryFolder, until } from './harness/browser.mjs';

const folder = temporaryFolder();
const vertex = 'void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n';
let browser;

before(async () => void (browser = await chromium()));

// Opens these files in the page without a scene.
async function opened(files) {
    const { page, said } = await tab(browser);
    await page.goto(builtPage('snell.html'));
    await page.waitForSelector('.editor-welcome li');
    const into = join(folder, Object.keys(files)[0].replace('.', '-'));
    mkdirSync(into, { recursive: true });
    const paths = Object.entries(files).map(([name, bytes]) => (writeFileSync(join(into, name), bytes), join(into, name)));
    await drop(page, ...paths);
    return { page, said };
}

const program = (body) => ({ 'p.vert': vertex, 'p.frag': `uniform float uA;\nvoid main() {\n${body}\n}\n` });
const scene = (name, more = '') => ({ [name]: `Vertex p.vert\nFragment p.frag\n${more}Program P uA <1. 2. 10.>\nSphere 1 20 20\n` });
const retype = async (page, file, text) => {
    await openText(page);
    await page.evaluate((name) => [...document.querySelectorAll('.editor-tabs button')].find((each) => each.title.endsWith(name)).click(), file);
    await (await page.$('.editor-code >>> .cm-content')).click();
    for (const key of ['KeyA', 'Backspace']) {
        if (key === 'KeyA') await page.keyboard.down('Control');
        await page.keyboard.press(key);
        await page.keyboard.up('Control');
    }
    await page.keyboard.sendCharacter(text);
};

const type = async (page, value) => {
    await page.$eval('.row.slider > .number', (field) => (field.focus(), field.select()));
    await page.keyboard.type(value);
    await page.keyboard.press('Enter');
};

test('a picture for which a shader emits much says what it costs', async () => {
    const emits = 'for (int i = 0; i < 64; ++i) { gl_Position = vec4(2.); EmitVertex(); }';
    const { page } = await opened({
        'm.glib': `Geometry m.geom\nProgram P\nglBegin gl_points\n${'glVertex 0 0 0\n'.repeat(5000)}glEnd\n`,
        'm.geom': `#version 400\nlayout(points) in; layout(points, max_vertices = 64) out;\nvoid main() { ${emits} }\n`,
    });
    await until(page, () => /m\.glib:2:1: .*320000 primitives/.test(document.querySelector('.problems').textContent));
    await page.close();
});

// Loops that nothing ends are left after 262,143 rounds, and the page asks before it draws whole pictures.
for (const [what, body] of Object.entries({
    'a loop without an end': 'float x = 0.;\nwhile (true) x += uA;\ngl_FragColor = vec4(x, 1., 0., 1.);',
    'a loop whose break is never taken': 'float x = 1.;\nwhile (true) { x += uA; if (x < 0.) break; }\ngl_FragColor = vec4(x, 1., 0., 1.);',
    'a loop whose counter stays': 'float x = 1.;\nfor (int i = 0; i < 10; ) { x += uA; if (x < 0.) break; }\ngl_FragColor = vec4(x, 1., 0., 1.);',
    'loops within loops': 'float x = 1.;\nfor (int i = 0; i < 2000; ++i) for (int j = 0; j < 2000; ++j) for (int k = 0; k < 2000; ++k) x += uA;\ngl_FragColor = vec4(x, 1., 0., 1.);',
}))
    test(`${what} does not stop the page, nor the next edit`, async () => {
        const { page } = await opened({ ...scene('e.glib', 'LookAt 0 0 1.2 0 0 0 0 1 0\n'), ...program(body) });
        await page.waitForSelector('dialog[open][aria-label="This scene takes long"]');
        await press(page, 'Keep it small', 'dialog[open]');
        await until(page, () => /coarser/.test(document.querySelector('.status span').textContent));
        await retype(page, 'p.frag', 'void main() { gl_FragColor = vec4(1.); }\n');
        await drawn(page);
        await retype(page, 'p.frag', `uniform float uA;\nvoid main() {\n${body}\n}\n`);
        await page.waitForSelector('dialog[open][aria-label="This scene takes long"]');
        await page.close();
    });

test('scenes with such loops have no small picture, and the others have', async () => {
    const loop = 'while (true) { x += uA; if (x < 0.) break; }';
    const body = `float x = 1.;\n${loop}\ngl_FragColor = vec4(x);`;
    const { page } = await opened({ ...scene('z.glib', 'LookAt 0 0 1.2 0 0 0 0 1 0\n'), ...program(body), 'fine.glib': 'Sphere 1\n' });
    await until(page, () => document.querySelector('.thumb canvas') && document.querySelector('.thumb.none'));
    assert.deepEqual(await page.$$eval('.thumb', (all) => all.map((each) => each.textContent)), ['', 'a picture of it takes long']);
    await page.close();
});

test('where a small picture takes seconds, the page asks before it goes on', async () => {
    const body = 'float x = gl_FragCoord.x;\nfor (int i = 0; i < 40000; ++i) x = fract(sin(x + uA) * 43758.5);\ngl_FragColor = vec4(x);';
    const { page } = await opened({ ...scene('h.glib', 'LookAt 0 0 1.2 0 0 0 0 1 0\n'), ...program(body) });
    await page.waitForSelector('dialog[open][aria-label="This scene takes long"]');
    assert.match(await page.$eval('dialog[open]', ({ textContent }) => textContent), /may take about \d+ s/);
    await press(page, 'Keep it small', 'dialog[open]');
    await until(page, () => /coarser/.test(document.querySelector('.status span').textContent));
    await openText(page);
    await page.close();
});

// `asked`: after the change, a question.
for (const [what, bound, asked] of [['a value that makes a loop go on and on', '1000000000', true], ['one that does not', '40', false]])
    test(`${what} is ${asked ? 'asked about, and can be taken back' : 'drawn'}`, async () => {
        const text = 'uniform float uA;\nvoid main() { float x = 0.; for (float i = 0.; i < uA; i++) x = fract(sin(x + i) * 43758.5); gl_FragColor = vec4(x, 1., 0., 1.); }\n';
        const { page } = await opened({ ...scene('v.glib', 'LookAt 0 0 1.2 0 0 0 0 1 0\n'), 'p.vert': vertex, 'p.frag': text });
        await drawn(page);
        await page.$eval('.row.slider > .number', (field) => (field.focus(), field.select()));
        await page.keyboard.type(bound);
        await page.evaluate(() => void (document.querySelector('.status span').textContent = ''));
        await page.keyboard.press('Enter');
        if (asked) {
            await page.waitForSelector('dialog[open][aria-label="This scene takes long"]');
            // Without graphics there is nothing to decide; with them again, there is.
            await page.evaluate(() => {
                window.context = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
                window.context.loseContext();
            });
            await until(page, () => !document.querySelector('dialog[open]'));
            await page.evaluate(() => window.context.restoreContext());
            await page.waitForSelector('dialog[open][aria-label="This scene takes long"]');
            await press(page, 'Cancel', 'dialog[open]');
            await until(page, () => /^not drawn/.test(document.querySelector('.status span').textContent));
            await page.evaluate(() => document.activeElement.blur());
            await chord(page, 'KeyZ');
        }
        await until(page, () => /ms$/.test(document.querySelector('.status span').textContent));
        assert.equal(await page.$('dialog[open]'), null);
        await page.close();
    });

test('a picture that was kept small is whole again with a value that makes it quick', async () => {
    const text = 'uniform float uA;\nvoid main() { float x = 0.; for (float i = 0.; i < uA; i++) x = fract(sin(x + i) * 43758.5); gl_FragColor = vec4(x, 1., 0., 1.); }\n';
    const { page } = await opened({ ...scene('k.glib', 'LookAt 0 0 1.2 0 0 0 0 1 0\n'), 'p.vert': vertex, 'p.frag': text });
    await drawn(page);
    await type(page, '1000000000');
    await page.waitForSelector('dialog[open]');
    await press(page, 'Keep it small', 'dialog[open]');
    await until(page, () => /coarser/.test(document.querySelector('.status span').textContent));
    await type(page, '3');
    await drawn(page);
    await page.close();
});

const looping = 'uniform float uA;\nvoid main() { float x = 0.; for (float i = 0.; i < uA; i++) x = fract(sin(x + i) * 43758.5); gl_FragColor = vec4(x, 1., 0., 1.); }\n';

test('a slider that moves by itself into long loops is asked about, and a key meant for something else is no answer', async () => {
    const { page } = await opened({ 'a.glib': scene('a.glib')['a.glib'].replace('<1. 2. 10.>', '<1. 2. 1000000.>'), 'p.vert': vertex, 'p.frag': looping });
    await drawn(page);
    await page.click('.options summary');
    await page.waitForSelector('.options .items label');
    await page.evaluate(() => [...document.querySelectorAll('.options label')].find(({ textContent }) => textContent === 'Animate').click());
    await page.waitForSelector('dialog[open][aria-label="This scene takes long"]');
    await page.keyboard.press('Enter');
    assert.notEqual(await page.$('dialog[open]'), null);
    await press(page, 'Cancel', 'dialog[open]');
    await until(page, () => /^not drawn/.test(document.querySelector('.status span').textContent));
    await page.close();
});

test('a drag through long loops and back asks nothing, and is one step', async () => {
    const { page } = await opened({ 'd.glib': scene('d.glib')['d.glib'].replace('<1. 2. 10.>', '<1. 2. 1000000.>'), 'p.vert': vertex, 'p.frag': looping });
    await drawn(page);
    const box = await (await page.$('.row.slider > input')).boundingBox();
    const y = box.y + box.height / 2;
    await page.mouse.move(box.x + 2, y);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width - 2, y, { steps: 5 });
    await until(page, () => /^not drawn/.test(document.querySelector('.status span').textContent));
    assert.equal(await page.$('dialog[open]'), null);
    await page.mouse.move(box.x - 20, y, { steps: 5 });
    await page.mouse.up();
    await until(page, () => /ms$/.test(document.querySelector('.status span').textContent));
    assert.equal(await page.$('dialog[open]'), null);
    await page.evaluate(() => document.activeElement.blur());
    await chord(page, 'KeyZ');
    await until(page, () => Number(document.querySelector('.row.slider > .number').value) === 2);
    await page.close();
});

test('a moving scene that is kept small is whole again with a value that makes it quick', async () => {
    const moving = looping.replace('i < uA;', 'i < uA * (1. + Timer);').replace('uniform', 'uniform float Timer;\nuniform');
    const { page } = await opened({ 't.glib': `Timer 4.\n${scene('t.glib')['t.glib'].replace('<1. 2. 10.>', '<1. 2. 1000000.>')}`, 'p.vert': vertex, 'p.frag': moving });
    await until(page, () => /ms$/.test(document.querySelector('.status span').textContent));
    await type(page, '400000');
    await page.waitForSelector('dialog[open]');
    await press(page, 'Keep it small', 'dialog[open]');
    await until(page, () => /coarser/.test(document.querySelector('.status span').textContent));
    await type(page, '3');
    await until(page, () => /ms$/.test(document.querySelector('.status span').textContent));
    await page.close();
});

// Small triangles: a picture of few pixels has as many of them, and more where it has more samples.
test('a picture that is kept small takes about half a second, and no longer', async () => {
    const { page } = await opened({ 's.glib': scene('s.glib')['s.glib'].replace('<1. 2. 10.>', '<1. 1000000. 1000000.>').replace('20 20', '60 60'), 'p.vert': vertex, 'p.frag': looping });
    await page.waitForSelector('dialog[open][aria-label="This scene takes long"]');
    await press(page, 'Keep it small', 'dialog[open]');
    await until(page, () => /coarser/.test(document.querySelector('.status span').textContent));
    const milliseconds = await page.$eval('.status span', ({ textContent }) => Number(/(\d+) ms/.exec(textContent)[1]));
    assert(milliseconds < 4000, `${milliseconds} ms`);
    await page.close();
});

test('loops of a geometry shader are foreseen to take as long as they do', async () => {
    const { page } = await opened({
        'g.glib': 'Vertex p.vert\nGeometry p.geom\nFragment p.frag\nProgram P uA <1. 100000. 1000000.>\nSphere 1 20 20\n',
        'p.vert': '#version 150 compatibility\nvoid main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n',
        'p.geom': `#version 150 compatibility
layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;
uniform float uA;
void main() {
    float x = 0.;
    for (float i = 0.; i < uA; i++) x = fract(sin(x + i) * 43758.5);
    for (int k = 0; k < 3; ++k) { gl_Position = gl_in[k].gl_Position + vec4(x * 1e-9); EmitVertex(); }
}
`,
        'p.frag': '#version 150 compatibility\nvoid main() { gl_FragColor = vec4(1.); }\n',
    });
    const said = await page.waitForFunction(() => {
        const dialog = document.querySelector('dialog[open][aria-label="This scene takes long"]');
        return dialog ? Number(/about (\d+) s/.exec(dialog.textContent)[1]) : /ms$/.test(document.querySelector('.status span').textContent) && 1;
    });
    assert(await said.jsonValue() < 60, 'seconds, not hours');
    await page.close();
});

// What the picture's size does not change is told by shorter loops: the page asks after seconds of it, not after minutes.
for (const [name, stage, drawn] of [
    ['vertices', 'vert', 'Sphere .9 400 400'],
    ['a texture', 'frag', 'RenderToTexture 5\nQuadXY 0. 1. 1 1\nRenderToTexture\nFragment b.frag\nProgram B uT 5\nQuadXY 0. 1. 1 1'],
])
    test(`long loops of ${name} are told by short ones`, async () => {
        const loop = 'for (int i = 0; i < uN; ++i) a = fract(a * 1.1 + sin(float(i) * vST.x));';
        const place = 'gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex';
        const begins = '#version 150 compatibility\nuniform int uN;\n';
        const { page } = await opened({
            'l.glib': `Ortho -1. 1. -1. 1.\nLookAt 0 0 1  0 0 0  0 1 0\nTexture2D 5 1024 1024\nVertex p.vert\nFragment p.frag\nProgram P uN <1 200000 250000>\n${drawn}\n`,
            'p.vert': `${begins}out vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; float a = 0.; ${stage === 'vert' ? loop : ''} ${place} + vec4(1e-9 * a); }\n`,
            'p.frag': `${begins}in vec2 vST;\nvoid main() { float a = .2; ${stage === 'frag' ? loop : ''} gl_FragColor = vec4(a, vST, 1.); }\n`,
            'b.frag': '#version 150 compatibility\nuniform sampler2D uT;\nin vec2 vST;\nvoid main() { gl_FragColor = texture(uT, vST); }\n',
        });
        const began = Date.now();
        await until(page, () => document.querySelector('dialog[open][aria-label="This scene takes long"]'));
        assert(Date.now() - began < 20_000, 'the page stood still');
        const choices = await page.$$eval('dialog[open] button', (all) => all.map(({ textContent }) => textContent));
        assert.deepEqual(choices, ['Draw it', 'Cancel'], 'a small picture would take as long');
        await page.close();
    });

test('work for vertices is not taken for work that grows with the picture', async () => {
    const moving = 'uniform float uA;\nvoid main() { float x = uA; for (int i = 0; i < 2000; ++i) x = fract(sin(x) * 43758.5); gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex + vec4(x * 1e-9); }\n';
    const plain = 'uniform float uA;\nvoid main() { gl_FragColor = vec4(uA, 1., 0., 1.); }\n';
    const grid = { 'w.glib': scene('w.glib')['w.glib'].replace('Sphere 1 20 20', 'Sphere 1 100 100') };
    const { page } = await opened({ ...grid, 'p.vert': moving, 'p.frag': plain });
    await until(page, () => document.querySelector('dialog[open][aria-label="This scene takes long"]') || /ms$/.test(document.querySelector('.status span').textContent));
    assert.equal(await page.$('dialog[open]'), null);
    await page.close();
});

// A grey PNG image.
function png(width, height) {
    const chunk = (kind, data) => {
        const body = Buffer.concat([Buffer.from(kind), data]);
        const size = Buffer.alloc(4);
        size.writeUInt32BE(data.length);
        const sum = Buffer.alloc(4);
        sum.writeUInt32BE(crc32 ? crc32(body) : 0);
        return Buffer.concat([size, body, sum]);
    };
    const header = Buffer.alloc(13);
    header.writeUInt32BE(width, 0);
    header.writeUInt32BE(height, 4);
    header.set([8, 0, 0, 0, 0], 8);
    const pixels = deflateSync(Buffer.alloc((width + 1) * height, 0));
    return Buffer.concat([Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]), chunk('IHDR', header), chunk('IDAT', pixels), chunk('IEND', Buffer.alloc(0))]);
}

test('an image beyond the limit is refused with its name and numbers, and the editor goes on', async () => {
    const files = {
        'i.glib': scene('i.glib', 'Texture2D 5 wide.png\n')['i.glib'].replace('10.>', '10.> uS 5'),
        'p.vert': vertex,
        'p.frag': 'uniform float uA;\nuniform sampler2D uS;\nvoid main() { gl_FragColor = uA * texture2D(uS, vec2(.5)); }\n',
        'wide.png': png(40_000, 2),
    };
    const { page, said } = await opened(files);
    await until(page, () => [...document.querySelectorAll('.problem')].some((each) => /wide\.png/.test(each.textContent) && /40000 x 2 texels exceed the limit of \d+/.test(each.textContent)));
    await retype(page, 'i.glib', scene('i.glib')['i.glib']);
    await drawn(page);
    assert.deepEqual(said, []);
    await page.close();
});

test('after the memory has run out, the editor goes on, and the next edit starts the program again', async () => {
    const { page } = await tab(browser);
    await page.evaluateOnNewDocument(() => {
        const grow = WebAssembly.Memory.prototype.grow;
        WebAssembly.Memory.prototype.grow = function (...pages) {
            if (window.full) throw new RangeError('no memory');
            return grow.apply(this, pages);
        };
    });
    await shows(page, await pageOf(folder, 'tests/cases/Sphere.glib'));
    await page.evaluate(() => void (window.full = true));
    const text = '##OpenGL GLIB\nSphere 1 RINGS RINGS\n';
    await retype(page, 'Sphere.glib', text.replaceAll('RINGS', '2000'));
    await until(page, () => /The program that draws has ended\..*memory/.test(document.querySelector('.cover').textContent));
    await page.evaluate(() => void (window.full = false));
    await retype(page, 'Sphere.glib', text.replaceAll('RINGS', '20'));
    await drawn(page);
    await page.close();
});

test('lost graphics leave the address as it was; what was said of them ends with the next change', async () => {
    const { page } = await opened({ ...scene('l.glib'), ...program('gl_FragColor = vec4(.1 * uA);') });
    await drawn(page);
    await page.close();
    const { page: own } = await tab(browser);
    await shows(own, `${await pageOf(folder, 'scenes/light/metals/metals.glib')}#view=rotate_y=30`);
    const lose = (name) => own.evaluate((name) => {
        window.context ??= document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
        window.context[name]();
    }, name);
    await lose('loseContext');
    await own.evaluate(() => window.dispatchEvent(new Event('resize')));
    await own.keyboard.press('ArrowLeft');
    await new Promise((resolve) => setTimeout(resolve, 700));
    assert.match(await own.evaluate(() => location.hash), /view=rotate_y=30/);
    await lose('restoreContext');
    await until(own, () => document.querySelector('.message').textContent === 'The graphics are back.');
    await own.focus('canvas');
    await own.keyboard.press('ArrowLeft');
    await until(own, () => document.querySelector('.message').textContent === '');
    await own.close();
});

test('graphics that were lost while a picture was drawn come back when the author wants it', async () => {
    const { page } = await tab(browser);
    await page.evaluateOnNewDocument(() => {
        // A picture that is never finished.
        const ask = WebGL2RenderingContext.prototype.getSyncParameter;
        WebGL2RenderingContext.prototype.getSyncParameter = function (...values) {
            return window.stuck ? 0 : ask.apply(this, values);
        };
    });
    await shows(page, await pageOf(folder, 'tests/cases/Cone.glib'));
    await page.evaluate(() => void (window.stuck = true));
    await page.focus('canvas');
    await page.keyboard.press('ArrowLeft');
    await new Promise((resolve) => setTimeout(resolve, 300));
    await page.evaluate(async () => {
        const context = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
        context.loseContext();
        await new Promise((resolve) => setTimeout(resolve, 200));
        context.restoreContext();
    });
    await page.waitForSelector('dialog[open][aria-label="The graphics are back"]');
    await page.evaluate(() => void (window.stuck = false));
    await press(page, 'Draw it small', 'dialog[open]');
    await drawn(page);
    await page.close();
});

test('pages of a gallery name folders where names repeat, and lead to the others', async () => {
    for (const [name, colour] of [['ann', '1.'], ['bob', '.5']]) {
        mkdirSync(join(folder, 'class', name), { recursive: true });
        writeFileSync(join(folder, 'class', name, 'ball.glib'), `##OpenGL GLIB\nColor ${colour} 0. 0.\nSphere 1\n`);
    }
    await run(['web', '--gallery', join(folder, 'class'), '-o', join(folder, 'gallery')]);
    const { page, said } = await tab(browser, { width: 390, height: 844 });
    await page.goto(pathToFileURL(join(folder, 'gallery/index.html')).href);
    const boxes = await page.$$eval('li', (all) => all.map((each) => each.getBoundingClientRect().top));
    assert.equal(boxes[0], boxes[1], 'two columns on a phone');
    await page.click('li a');
    await drawn(page);
    const nav = () => page.$$eval('.gallery a', (all) => all.map(({ textContent, title }) => `${textContent} ${title}`.trim()));
    assert.equal(await page.title(), 'ann/ball');
    assert.deepEqual(await nav(), ['All scenes', 'Next › bob/ball']);
    await page.click('.gallery a:last-child');
    await until(page, () => document.title === 'bob/ball');
    await drawn(page);
    assert.deepEqual(await nav(), ['All scenes', '‹ Previous ann/ball']);
    await page.click('.gallery a');
    await until(page, () => document.title === 'Scenes');
    assert.deepEqual(said, []);
    await page.close();
});

test('a laptop shows enough text and wide sliders; the divider moves; a phone shows the title', async () => {
    const { page } = await tab(browser, { width: 1366, height: 640 });
    const address = await pageOf(folder, 'scenes/refraction-room/refraction-room.glib');
    await shows(page, address);
    await openText(page);
    const lines = () => page.$eval('.editor-code', ({ shadowRoot, clientHeight }) => Math.floor(clientHeight / shadowRoot.querySelector('.cm-line').offsetHeight));
    const before = await lines();
    assert.ok(before >= 13, `${before} lines`);
    assert.equal(await page.$eval('.editor-fine-print', ({ open }) => open), false);
    const slider = await page.$eval('.row.slider input', ({ clientWidth }) => clientWidth);
    assert.ok(slider >= 160, `${slider} pixels`);
    await page.focus('.grip');
    for (let i = 0; i < 6; ++i) await page.keyboard.press('ArrowUp');
    const more = await lines();
    assert.ok(more >= before + 3, `${more} lines`);
    const { x, y, width, height } = await (await page.$('.grip')).boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2, y + 120, { steps: 4 });
    await page.mouse.up();
    const fewer = await lines();
    assert.ok(fewer < more - 3, `${fewer} lines`);
    await page.reload();
    await drawn(page);
    await openText(page);
    assert.equal(await lines(), fewer, 'it stays for other visits');
    await page.setViewport({ width: 390, height: 844 });
    const title = await page.$eval('h1', (each) => ({ text: each.textContent, height: each.getBoundingClientRect().height, seen: each.checkVisibility({ opacityProperty: true }) }));
    assert.deepEqual([title.text, title.seen, title.height > 15], ['refraction-room', true, true]);
    await page.evaluate(() => localStorage.clear());
    await page.close();
});

test('mistakes of types name both, and a surplus brace the block before it', async () => {
    for (const [body, said] of [['vec3 v = vec2(uA);\ngl_FragColor = vec4(v, 1.);', /a 'vec2' cannot be assigned to a 'vec3'/], ['float x;\nx = vec3(uA);\ngl_FragColor = vec4(x);', /a 'vec3' cannot be assigned to a 'float'/]]) {
        const { page } = await opened({ ...scene('t.glib'), ...program(body) });
        await until(page, (text) => new RegExp(text).test(document.querySelector('.problems').textContent), said.source);
        await page.close();
    }
    const { page } = await opened({ ...scene('b.glib'), ...program('gl_FragColor = vec4(uA);\n}') });
    await until(page, () => /the one before it ends the block that begins in line 2/.test(document.body.textContent));
    await page.close();
});
