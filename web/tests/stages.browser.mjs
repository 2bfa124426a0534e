// Scenes with geometry and tessellation shaders, which WebGL 2 does not have, in both browsers: the picture that the
// page saves, against the native program's on OpenGL ES 3.0.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { before, test } from 'node:test';
import { chromium, firefox, keepDownloads, pageOf, root, run, savedPicture, shows, tab, temporaryFolder } from './harness/browser.mjs';
import { exceptions } from './harness/exceptions.mjs';
import { colours, difference, pixelsOf } from './harness/png.mjs';

const folder = temporaryFolder();
const cases = ['Geometry', 'GeometryInput', 'GeometryOutput', 'LinesAdjacency', 'NumPatchVertices', 'ObjAdj', 'ObjPatch', 'TessControl', 'TessEvaluation'];
const scenes = [...cases.map((name) => `tests/cases/${name}.glib`), 'docs/teaching/06-geometry/solution/round.glib', ...written()];
const nameOf = (scene) => basename(scene, '.glib');
const side = 100;

// More numbers for each vertex than transform feedback takes, and no perspective; lines that are thin everywhere.
function written() {
    const shaders = {
        'many.vert': 'void main() { gl_Position = gl_Vertex; }\n',
        'many.geom':
            '#version 400\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\nout vec4 many[13]; flat out ivec3 whole; noperspective out vec2 place;\n' +
            'void main() {\n    for (int i = 0; i < 3; ++i) {\n        vec4 p = gl_in[i].gl_Position;\n        for (int k = 0; k < 13; ++k) many[k] = p * float(k);\n' +
            '        whole = ivec3(gl_PrimitiveIDIn, i, 2); place = p.xy; gl_Position = vec4(p.xyz, 1.) * (2. + p.x); EmitVertex();\n    }\n}\n',
        'many.frag':
            '#version 400\nin vec4 many[13]; flat in ivec3 whole; noperspective in vec2 place; out vec4 c;\n' +
            'void main() {\n    c = vec4(place * .3, 0., 1.);\n    for (int k = 0; k < 13; ++k) c.xyz += many[k].xyz * .01;\n    c.xyz = fract(c.xyz + vec3(whole % 5) * .2);\n}\n',
    };
    for (const [name, text] of Object.entries(shaders)) writeFileSync(join(folder, name), text);
    writeFileSync(join(folder, 'thin.geom'), shaders['many.geom'].replace('triangle_strip', 'line_strip').replaceAll('13', '11'));
    writeFileSync(join(folder, 'thin.frag'), shaders['many.frag'].replaceAll('13', '11'));
    return ['many', 'thin'].map((name) => {
        const scene = join(folder, `${name}.glib`);
        writeFileSync(scene, `Vertex many.vert\nGeometry ${name}.geom\nFragment ${name}.frag\nProgram P\nQuadXY 0. .8 3 3\n`);
        return scene;
    });
}

// Chromium draws by ANGLE's SwiftShader and Firefox by Mesa; where ANGLE is not installed, Mesa has edges elsewhere.
const angle = join(root, 'build/drivers/angle');
const drivers = {
    ANGLE: { env: { LD_LIBRARY_PATH: angle, ANGLE_DEFAULT_PLATFORM: 'swiftshader' }, alike: ({ share }) => share <= 0.001 },
    Mesa: { env: { MESA_GLES_VERSION_OVERRIDE: '3.0', LP_NUM_THREADS: '0' }, alike: ({ mean }) => mean <= 1.5 },
};
const browsers = [
    ['Chromium', chromium, existsSync(angle) ? 'ANGLE' : 'Mesa'],
    ['Firefox', firefox, 'Mesa'],
];

const pages = new Map();

before(async () => {
    for (const name of new Set(browsers.map(([, , driver]) => driver))) {
        mkdirSync(join(folder, name));
        const how = ['--size', `${side}x${side}`, '--samples', '1', '--context', 'es3.0', '--no-specialise', '--without-stages', '--timeout', '120'];
        await run(['render', ...scenes, '-o', join(folder, name, '{stem}.png'), ...how], { env: drivers[name].env });
    }
    for (const scene of scenes) pages.set(scene, await pageOf(folder, scene));
});

for (const [browser, start, driver] of browsers)
    test(`geometry and tessellation in ${browser}`, async (t) => {
        const { page, said } = await tab(await start(), { width: 400, height: 300, still: false });
        await keepDownloads(page);
        for (const [scene, address] of pages)
            await t.test(nameOf(scene), async (t) => {
                await shows(page, address);
                const picture = pixelsOf(await savedPicture(page, side, side, 1));
                const found = difference(picture, pixelsOf(readFileSync(join(folder, driver, `${nameOf(scene)}.png`))));
                const measured = `${(100 * found.share).toFixed(2)} % of the pixels differ, by at most ${found.largest} of 255, ${found.mean.toFixed(2)} on average`;
                if (found.share > 0) t.diagnostic(measured);
                assert.ok(colours(picture) > 1, 'something is drawn');
                if (exceptions[driver][nameOf(scene)]) assert.ok(!drivers[driver].alike(found), 'this exception is not needed');
                else assert.ok(drivers[driver].alike(found), measured);
                assert.deepEqual(said.splice(0), [], 'the console is silent');
            });
    });
