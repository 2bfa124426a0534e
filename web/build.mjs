// Makes the pages' templates. The engine comes from build/web/engine, or from $SNELL_ENGINE.
//   page.html     one page with everything; `snell web` fills in its data blocks
//   snell.html    the same with the shipped scenes as examples, for scenes that are dropped on it
//   gallery.html  the page without bundle and runtime, which runtime.js has for a whole folder of pages
//   site/         snell.html as a folder for any static host, which can be installed and works offline
import { createHash } from 'node:crypto';
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build, transform } from 'esbuild';
import { examples } from './examples.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.env.SNELL_WEB_OUT ?? join(here, '../build/web'));
const engine = process.env.SNELL_ENGINE ?? join(here, '../build/web/engine');
if (!existsSync(join(engine, 'snell.js'))) {
    console.error(`${engine} has no snell.js: './dev web' builds it`);
    process.exit(1);
}

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
        loader: { '.glib': 'text', '.vert': 'text', '.frag': 'text' },
        define: { 'import.meta.url': '"file:///snell.js"' },
        external: ['module', 'fs', 'path', 'url', 'node:*', 'worker_threads'],
        alias: { 'snell-engine': join(resolve(engine), 'snell.js') },
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

// The program that draws pictures of the examples; without it there are none.
const native = process.env.SNELL ?? join(here, '../build/release/bin/snell');
const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

function policy(script, style, more = '') {
    return [
        "default-src 'none'",
        `script-src ${script} 'wasm-unsafe-eval'`,
        `worker-src blob:${more}`,
        `img-src blob: data:${more}`,
        `style-src ${style}`,
        ...(more ? [`manifest-src${more}`] : []),
        "base-uri 'none'",
        "form-action 'none'",
    ].join('; ');
}

function filled(name, parts) {
    return readFileSync(join(here, name), 'utf8').replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]);
}
const page = (parts) => filled('page/page.html', parts);

const [bundle, style] = await Promise.all([bundled(), styled()]);
const program = readFileSync(join(engine, 'snell.wasm'));
const packed = gzipSync(program, { level: 9 }).toString('base64');
const runtime = `<script type="text/plain" id="runtime">${packed}</script>`;
const own = { head: '<link rel="icon" href="data:,">', style: `<style>${style}</style>` };
const inline = { ...own, policy: policy(hash(bundle), hash(style)), script: `<script>${bundle}</script>` };
mkdirSync(out, { recursive: true });
const write = (name, text) => writeFileSync(join(out, name), text);
write('page.html', page({ ...inline, blocks: runtime }));
const start = existsSync(native) ? examples(native, join(out, 'pictures')) : examples();
write('snell.html', page({ ...inline, blocks: `${runtime}\n${start}` }));
// Files on a disk have no origin of their own, which 'self' would name.
const script = '<script src="runtime.js"></script>';
const shared = { ...own, policy: policy("'self' file:", hash(style)), script };
write('gallery.html', page({ ...shared, blocks: '' }));
const runtimeScript = `var snellRuntime=${JSON.stringify(packed)};\n${bundle}\n`;
write('runtime.js', runtimeScript);

// Nothing of it is inline, so that hosts may forbid that.
const head = '<link rel="icon" href="icon.svg"><link rel="manifest" href="manifest.json">';
const site = { head, style: '<link rel="stylesheet" href="style.css">', policy: policy("'self'", "'self'", " 'self'"), script };
const index = page({ ...site, blocks: start });
const parts = { 'index.html': index, 'runtime.js': runtimeScript, 'style.css': style };
mkdirSync(join(out, 'site'), { recursive: true });
for (const [name, text] of Object.entries(parts)) write(join('site', name), text);
copyFileSync(join(here, '../desktop/snell.svg'), join(out, 'site/icon.svg'));
copyFileSync(join(here, 'page/site/manifest.json'), join(out, 'site/manifest.json'));
const facts = { version: createHash('sha256').update(Object.values(parts).join()).digest('hex').slice(0, 12) };
facts.files = JSON.stringify(['./', ...Object.keys(parts).slice(1), 'icon.svg', 'manifest.json']);
write('site/service.js', filled('page/site/service.js', facts));
const sizes = { bundle: gzipSync(bundle).length, style: gzipSync(style).length, runtime: Math.round(packed.length * 0.75) };
const most = { runtime: ' of at most 760' }; // tests/budgets.browser.mjs holds it
for (const [name, bytes] of Object.entries(sizes)) console.log(`${name.padEnd(8)} ${(bytes / 1000).toFixed(1).padStart(7)} kB gzipped${most[name] ?? ''}`);
