// Bundles every *.test.ts of this folder, and runs them and every *.browser.mjs by node's own test runner: as many at a
// time as there are processors, and then those that judge times, alone. One of these that fails is run once more, because
// another process may have taken the processor.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
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
        loader: { '.glib': 'text', '.vert': 'text', '.frag': 'text' },
        outdir: out,
        outExtension: { '.js': '.mjs' },
    });
    const units = tests.map((name) => join(out, name.replace(/\.ts$/, '.mjs')));
    const pages = named('.browser.mjs').map((name) => join(folder, name));
    const judgesTimes = (path) => path.endsWith('budgets.browser.mjs');
    const fails = (files, concurrency) =>
        files.length > 0 && spawnSync(process.execPath, ['--test', `--test-concurrency=${concurrency}`, ...files], { stdio: 'inherit' }).status !== 0;
    const failed = fails([...units, ...pages.filter((path) => !judgesTimes(path))], availableParallelism());
    const timed = pages.filter(judgesTimes);
    process.exitCode = (fails(timed, 1) && fails(timed, 1)) || failed ? 1 : 0;
} finally {
    rmSync(out, { recursive: true });
}
