// Makes dist/: the client in one file, and copies of what has its place elsewhere in the repository.
import { copyFileSync, mkdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../..');
mkdirSync(join(here, 'dist'), { recursive: true });
const copies = { 'docs/editors/glib.tmLanguage.json': 'dist/glib.tmLanguage.json', 'desktop/snell.svg': 'dist/icon.svg', LICENSE: 'LICENSE' };
for (const [from, to] of Object.entries(copies)) copyFileSync(join(root, from), join(here, to));

await build({
    entryPoints: [join(here, 'src/extension.ts')],
    outfile: join(here, 'dist/extension.js'),
    bundle: true,
    minify: true,
    platform: 'node',
    format: 'cjs',
    target: 'node18',
    external: ['vscode'],
});
