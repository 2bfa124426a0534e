// What the tests share: where things are, and the program.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');
export const program = process.env.SNELL ?? join(root, 'build/release/bin/snell');

export const snell = (words, input) => spawnSync(program, words, { input, encoding: 'utf8', cwd: root });

// A folder that is gone when the test `t` ends.
export function scratch(t) {
    const folder = mkdtempSync(join(tmpdir(), 'snell-editors-'));
    t.after(() => rmSync(folder, { recursive: true, force: true }));
    return folder;
}

// All files below a folder, relative to it.
export function files(folder, below = '') {
    return readdirSync(join(folder, below), { withFileTypes: true }).flatMap((entry) =>
        entry.isDirectory() ? files(folder, join(below, entry.name)) : [join(below, entry.name)],
    );
}
