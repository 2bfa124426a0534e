// Makes the pages' templates. The engine comes from build/web/engine, or from $SNELL_ENGINE; "fake" draws without one.
//   page.html     one page with everything; `snell web` fills in its data blocks
//   snell.html    the same with the shipped scenes as examples, for scenes that are dropped on it
//   gallery.html  the page without bundle and runtime, which runtime.js has for a whole folder of pages
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build, transform } from 'esbuild';
import { examples } from './examples.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.env.SNELL_WEB_OUT ?? join(here, '../build/web'));
const engine = process.env.SNELL_ENGINE ?? join(here, '../build/web/engine');
const fake = engine === 'fake';
if (!fake && !existsSync(join(engine, 'snell.js'))) {
    console.error(`${engine} has no snell.js: './dev web' builds it`);
    process.exit(1);
}

const standIn = {
    name: 'stand-in',
    setup: ({ onResolve }) => onResolve({ filter: /\/load_engine\.ts$/ }, () => ({ path: join(here, 'tests/fake_engine.ts') })),
};

async function bundled() {
    const { outputFiles } = await build({
        entryPoints: [join(here, 'page/main.ts')],
        bundle: true,
        write: false,
        minify: true,
        format: 'iife',
        target: 'es2022',
        charset: 'utf8',
        // snell.js asks for its own address, and for node's modules where it runs there.
        define: { 'import.meta.url': '"file:///snell.js"' },
        external: ['module', 'fs', 'path', 'url', 'node:*', 'worker_threads'],
        alias: fake ? {} : { 'snell-engine': join(resolve(engine), 'snell.js') },
        plugins: fake ? [standIn] : [],
        // The worker is started from the text of this function.
        banner: { js: '(function snellPage(){' },
        footer: { js: '})();' },
    });
    // An inline script ends at the first end tag, whatever is around it.
    return outputFiles[0].text.trim().replace(/<\/script/gi, '<\\/script').replace(/<!--/g, '<\\!--');
}

async function styled() {
    const sheets = ['page/editor/editor.css', 'page/style.css'].map((name) => readFileSync(join(here, name), 'utf8'));
    return (await transform(sheets.join('\n'), { loader: 'css', minify: true })).code.trim();
}

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

function policy(script, style) {
    return [
        "default-src 'none'",
        `script-src ${script} 'wasm-unsafe-eval'`,
        'worker-src blob:',
        'img-src blob: data:',
        `style-src ${hash(style)}`,
        "base-uri 'none'",
        "form-action 'none'",
    ].join('; ');
}

function page(parts) {
    const template = readFileSync(join(here, 'page/page.html'), 'utf8');
    return template.replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]);
}

const [bundle, style] = await Promise.all([bundled(), styled()]);
const empty = Buffer.from([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]); // the smallest program
const program = fake ? empty : readFileSync(join(engine, 'snell.wasm'));
const packed = gzipSync(program, { level: 9 }).toString('base64');
const runtime = `<script type="text/plain" id="runtime">${packed}</script>`;
const inline = { style, policy: policy(hash(bundle), style), script: `<script>${bundle}</script>` };
mkdirSync(out, { recursive: true });
const write = (name, text) => writeFileSync(join(out, name), text);
write('page.html', page({ ...inline, blocks: runtime }));
write('snell.html', page({ ...inline, blocks: `${runtime}\n${examples()}` }));
// Files on a disk have no origin of their own, which 'self' would name.
const shared = { style, policy: policy("'self' file:", style), script: '<script src="runtime.js"></script>' };
write('gallery.html', page({ ...shared, blocks: '' }));
write('runtime.js', `var snellRuntime=${JSON.stringify(packed)};\n${bundle}\n`);
const sizes = { bundle: gzipSync(bundle).length, style: gzipSync(style).length, runtime: Math.round(packed.length * 0.75) };
for (const [name, bytes] of Object.entries(sizes)) console.log(`${name.padEnd(8)} ${(bytes / 1000).toFixed(1).padStart(7)} kB gzipped`);
