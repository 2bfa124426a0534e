// Vim, Neovim and Emacs with the setups that docs/editors.md prints, without a display, where they are installed.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { program, root, scratch } from './snell.mjs';

const page = readFileSync(join(root, 'docs/editors.md'), 'utf8');
const setup = (language) => new RegExp(`^\`\`\`${language}\n(.*?)^\`\`\``, 'ms').exec(page)[1].replaceAll('DOCS', join(root, 'docs/editors'));
const missing = (name) => spawnSync(name, ['--version']).error !== undefined && `${name} is not installed`;

// A folder with a scene that has one slip, and the program on the path.
function start(t) {
    const folder = scratch(t);
    mkdirSync(join(folder, 'bin'));
    symlinkSync(program, join(folder, 'bin/snell'));
    writeFileSync(join(folder, 'a b.glib'), '##OpenGL GLIB\nPushMatrix\nSpher 1\nPopMatrix\n');
    const run = (name, ...words) =>
        spawnSync(name, words, { cwd: folder, encoding: 'utf8', timeout: 60_000, env: { ...process.env, HOME: folder, XDG_CONFIG_HOME: folder, PATH: `${join(folder, 'bin')}:${process.env.PATH}` } });
    return { folder, run, write: (name, text) => (writeFileSync(join(folder, name), text), name), read: (name) => readFileSync(join(folder, name), 'utf8') };
}

test('Vim knows scenes, lists their errors and formats them', { skip: missing('vim') }, (t) => {
    const { run, write, read } = start(t);
    write('vimrc', setup('vim'));
    write('steps.vim', `
compiler snell
silent make
call writefile([&filetype, &commentstring, synIDattr(synID(2, 1, 1), 'name')], 'kind.txt')
call writefile(map(getqflist(), {_, e -> e.lnum . ':' . e.col . ' ' . e.type . ' ' . e.text}), 'errors.txt')
normal gggqG
wq
`);
    run('vim', '-es', '-N', '-u', 'vimrc', '-S', 'steps.vim', 'a b.glib');
    assert.equal(read('kind.txt'), 'glib\n# %s\nglibCommand\n');
    assert.match(read('errors.txt'), /^3:1 e unknown command 'Spher' \[unknown-command\]\n/);
    assert.equal(read('a b.glib'), '##OpenGL GLIB\nPushMatrix\nSpher 1\nPopMatrix\n');
    write('c.glib', 'PushMatrix\nSphere 1\nPopMatrix\n');
    run('vim', '-es', '-N', '-u', 'vimrc', '-c', 'normal gggqG', '-c', 'wq', 'c.glib');
    assert.equal(read('c.glib'), 'PushMatrix\n    Sphere 1\nPopMatrix\n');
});

test('Neovim starts the server', { skip: missing('nvim') }, (t) => {
    const { run, write, read } = start(t);
    write('init.lua', setup('lua'));
    write('steps.lua', `
vim.wait(20000, function() return #vim.diagnostic.get(0) > 0 end, 50)
local lines = {}
for _, d in ipairs(vim.diagnostic.get(0)) do table.insert(lines, (d.lnum + 1) .. ":" .. (d.col + 1) .. " " .. d.code) end
vim.fn.writefile(lines, "errors.txt")
vim.cmd("qall!")
`);
    const { stderr } = run('nvim', '--headless', '-u', 'init.lua', '-n', 'a b.glib', '-c', 'luafile steps.lua');
    assert.match(read('errors.txt'), /^3:1 unknown-command$/m, stderr);
});

test('Emacs starts the server', { skip: missing('emacs') }, (t) => {
    const { run, write, read } = start(t);
    write('init.el', setup('elisp'));
    write('steps.el', `
(find-file "a b.glib")
(run-hooks 'post-command-hook)
(flymake-start)
(let ((end (+ (float-time) 20)))
  (while (and (null (flymake-diagnostics)) (< (float-time) end)) (accept-process-output nil .05)))
(let ((said (mapconcat (lambda (d) (format "%d %s" (line-number-at-pos (flymake-diagnostic-beg d)) (flymake-diagnostic-text d))) (flymake-diagnostics) "\\n")))
  (with-temp-file "errors.txt" (insert said)))
(eglot-shutdown-all)
`);
    const { stderr } = run('emacs', '--batch', '-l', 'init.el', '-l', 'steps.el');
    assert.match(read('errors.txt'), /^3 .*unknown command 'Spher'/m, stderr);
});
