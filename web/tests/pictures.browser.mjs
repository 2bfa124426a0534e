// Every scene of the repository that browsers can draw: the picture that the page saves, against the native program's.
// One page opens scene after scene, so that nothing of an earlier one may stay.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { before, test } from 'node:test';
import { gunzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { zipSync } from 'fflate';
import { builtPage, chromium, drawn, drop, keepDownloads, press, root, run, savedPicture, tab, temporaryFolder, until } from './harness/browser.mjs';
import { exceptions, refused } from './harness/exceptions.mjs';
import { difference, pixelsOf } from './harness/png.mjs';

// The same driver as Chromium's, which ./dev web fetches: one pixel in a thousand may differ by more than 2 of 255. Mesa
// has edges of lines, triangles and texels elsewhere, so that many more do, and only the mean difference is judged.
const angle = join(root, 'build/drivers/angle');
const driver = existsSync(angle)
    ? {
          name: 'ANGLE',
          env: { LD_LIBRARY_PATH: angle, ANGLE_DEFAULT_PLATFORM: 'swiftshader' },
          alike: ({ share }) => share <= 0.001,
      }
    : {
          name: 'Mesa',
          env: { MESA_GLES_VERSION_OVERRIDE: '3.0', LP_NUM_THREADS: '0' },
          alike: ({ mean }) => mean <= 1.5,
      };
const side = 100;

const folder = temporaryFolder();
const native = join(folder, 'native');
const files = readdirSync(join(root, 'scenes'), { recursive: true }).map((name) => join('scenes', name));
const scenes = [...files, ...readdirSync(join(root, 'tests/cases')).map((name) => join('tests/cases', name))]
    .filter((path) => path.endsWith('.glib'))
    .sort();
const nameOf = (path) => basename(path, '.glib');
const packed = new Map(); // by name: the scene's name in its page, and its files
let page, said, gallery, filesOf;

// What `snell web` put into a page: the files as the page reads them.
function unpacked(html) {
    const block = (id) => new RegExp(`id="${id}">([^<]*)<`).exec(html)[1];
    const { files } = filesOf(new Uint8Array(gunzipSync(Buffer.from(block('archive'), 'base64'))));
    return { scene: JSON.parse(block('scene')).scene, files: Object.fromEntries(files) };
}

async function makeGallery(from) {
    const out = join(folder, basename(from));
    const text = await run(['web', '--gallery', from, '-o', out, '--timeout', '120']);
    for (const name of readdirSync(out).filter((each) => each.endsWith('.html') && each !== 'index.html')) {
        const one = unpacked(readFileSync(join(out, name), 'utf8'));
        packed.set(nameOf(one.scene), one);
    }
    return text;
}

function drawNatively() {
    mkdirSync(native);
    const how = ['--size', `${side}x${side}`, '--samples', '1', '--context', 'es3.0', '--no-specialise', '--timeout', '120'];
    return run(['render', ...scenes, '-o', join(native, '{stem}.png'), ...how], { env: driver.env });
}

before(async () => {
    const reader = join(folder, 'archive.mjs');
    await build({ entryPoints: [join(root, 'web/page/archive.ts')], bundle: true, platform: 'node', format: 'esm', outfile: reader });
    ({ filesOf } = await import(reader));
    assert.equal(new Set(scenes.map(nameOf)).size, scenes.length, 'each scene has its own name');
    const made = Promise.all([makeGallery('scenes'), makeGallery('tests/cases'), drawNatively()]);
    // The page's own picture is not looked at.
    ({ page, said } = await tab(await chromium(), { width: 760, height: 240 }));
    await keepDownloads(page);
    await page.goto(builtPage('snell.html'));
    await until(page, () => document.querySelectorAll('.editor-welcome li').length > 10);
    gallery = (await made).slice(0, 2).join('');
});

// Opens a scene in the page as a teacher would, and returns what the page saves.
async function pictureOf(name) {
    const { scene, files } = packed.get(name);
    const zip = join(folder, 'scene.zip');
    writeFileSync(zip, zipSync(files, { level: 0 }));
    await page.evaluate(() => void (document.querySelector('.status span').textContent = ''));
    await drop(page, zip);
    if (Object.keys(files).filter((each) => each.endsWith('.glib')).length > 1) {
        await page.waitForSelector('.editor-dialog[open]');
        await press(page, scene, '.editor-dialog');
    }
    await drawn(page);
    return pixelsOf(await savedPicture(page, side, side, 1));
}

const errorsShown = () =>
    page.$$eval('.problems:not([hidden]) .problem', (all) => all.map((each) => each.textContent).filter((text) => /error: /.test(text)));

for (const name of scenes.map(nameOf)) {
    test(`${name} in the page`, async (t) => {
        if (name in refused) {
            assert.ok(!packed.has(name), 'it has no page');
            return assert.match(gallery, new RegExp(`${name}.*${refused[name]}`));
        }
        const picture = await pictureOf(name);
        assert.deepEqual(await errorsShown(), []);
        assert.deepEqual(said.splice(0), [], 'the console is silent');
        const found = difference(picture, pixelsOf(readFileSync(join(native, `${name}.png`))));
        const { share, largest, mean } = found;
        const measured = `${(100 * share).toFixed(2)} % of the pixels differ, by at most ${largest} of 255, ${mean.toFixed(2)} on average`;
        if (share > 0) t.diagnostic(measured);
        if (exceptions[driver.name][name]) assert.ok(!driver.alike(found), 'this exception is not needed');
        else assert.ok(driver.alike(found), measured);
    });
}
