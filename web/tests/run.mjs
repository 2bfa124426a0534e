// Bundles every *.test.ts of this folder, and runs them and every *.browser.mjs by node's own test runner.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const folder = dirname(fileURLToPath(import.meta.url));
const wanted = process.argv.slice(2);
const named = (end) =>
    readdirSync(folder).filter((name) => name.endsWith(end) && (wanted.length === 0 || wanted.some((part) => name.includes(part))));
const tests = named('.test.ts');
const out = mkdtempSync(join(tmpdir(), 'snell-web-'));
try {
    await build({
        entryPoints: tests.map((name) => join(folder, name)),
        bundle: true,
        platform: 'node',
        format: 'esm',
        outdir: out,
        outExtension: { '.js': '.mjs' },
    });
    const units = tests.map((name) => join(out, name.replace(/\.ts$/, '.mjs')));
    const files = [...units, ...named('.browser.mjs').map((name) => join(folder, name))];
    const { status } = spawnSync(process.execPath, ['--test', ...files], { stdio: 'inherit' });
    process.exitCode = status ?? 1;
} finally {
    rmSync(out, { recursive: true });
}
