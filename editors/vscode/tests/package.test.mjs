// build/editors/snell.vsix: what it contains, and whether that fits the program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { files, root, scratch, snell } from './snell.mjs';

const here = join(root, 'editors/vscode');
const json = (path) => JSON.parse(readFileSync(path, 'utf8'));
const manifest = json(join(here, 'package.json'));

test('the package has these files, and no others', (t) => {
    const folder = scratch(t);
    execFileSync('python3', ['-m', 'zipfile', '-e', join(root, 'build/editors/snell.vsix'), folder]);
    assert.deepEqual(files(folder).sort(), [
        '[Content_Types].xml',
        'extension.vsixmanifest',
        'extension/LICENSE.txt',
        'extension/dist/extension.js',
        'extension/dist/glib.tmLanguage.json',
        'extension/dist/icon.svg',
        'extension/icon.png',
        'extension/language-configuration.json',
        'extension/package.json',
        'extension/readme.md',
        'extension/snippets.json',
    ]);
    const copies = { 'LICENSE.txt': 'LICENSE', 'dist/glib.tmLanguage.json': 'docs/editors/glib.tmLanguage.json', 'dist/icon.svg': 'desktop/snell.svg' };
    for (const [copy, original] of Object.entries(copies))
        assert.equal(readFileSync(join(folder, 'extension', copy), 'utf8'), readFileSync(join(root, original), 'utf8'), copy);
    const version = snell(['--version']).stdout.trim().replace('snell ', '');
    assert.equal(json(join(folder, 'extension/package.json')).version, version);
    const { contributes, main, icon } = manifest;
    const named = [main, icon, contributes.snippets[0].path, contributes.grammars[0].path, contributes.languages[0].configuration, contributes.languages[0].icon.light];
    for (const path of named) readFileSync(join(folder, 'extension', path));
});

test('the problem matcher reads what snell check prints', (t) => {
    const folder = scratch(t);
    const scene = join(folder, 'a b.glib');
    writeFileSync(scene, 'Spher 1\nPerspective 50 60\nPushMatrix\nTexture2D 5 missing.png\n');
    const pattern = new RegExp(manifest.contributes.problemPatterns[0].regexp);
    const printed = snell(['check', scene]).stdout.split('\n').map((line) => pattern.exec(line)).filter(Boolean);
    const read = printed.map(([, file, line, column, severity, message, code]) => ({ file, line: +line, column: +column, severity, message, code }));
    const [{ diagnostics }] = JSON.parse(snell(['check', '--json', scene]).stdout);
    const said = diagnostics.flatMap((d) => [
        { file: d.at.file, line: d.at.line, column: d.at.column, severity: d.severity, message: d.message, code: d.code },
        ...(d.notes ?? []).map((n) => ({ file: n.at.file, line: n.at.line, column: n.at.column, severity: 'note', message: n.message, code: undefined })),
    ]);
    assert.ok(said.length >= 3);
    assert.deepEqual(read, said);
});

test('every command has a snippet, which is one and is laid out', (t) => {
    const snippets = json(join(here, 'snippets.json'));
    const commands = JSON.parse(snell(['commands', '--json']).stdout).commands.map((command) => command.name);
    assert.deepEqual(Object.keys(snippets), commands);
    const filled = Object.values(snippets).map(({ body }) =>
        [body].flat().join('\n')
            .replace(/\$\{\d+:([^}]*)\}/g, '$1')
            .replace(/\$\{\d+\|([^,|}]*)[^}]*\}/g, '$1')
            .replaceAll('\t$0', '    Teapot'),
    );
    for (const text of filled) assert.doesNotMatch(text, /[$|]/);
    for (const text of filled) assert.equal(snell(['format', '-'], text).stdout, text);
    const scene = join(scratch(t), 'all.glib');
    writeFileSync(scene, filled.join('\n'));
    const [{ diagnostics }] = JSON.parse(snell(['check', '--json', scene]).stdout);
    assert.deepEqual(diagnostics.filter(({ code }) => code === 'unknown-command' || code === 'surplus-arguments'), []);
});

test('VS Code indents while one types as snell format does', () => {
    const rules = json(join(here, 'language-configuration.json')).indentationRules;
    const more = new RegExp(rules.increaseIndentPattern), less = new RegExp(rules.decreaseIndentPattern);
    let blocks = 0;
    for (const name of files(join(root, 'scenes')).filter((name) => name.endsWith('.glib'))) {
        let depth = 0, continued = false;
        for (const line of readFileSync(join(root, 'scenes', name), 'utf8').split('\n')) {
            const was = continued;
            continued = /\\\s*$/.test(line) && !/^\s*#/.test(line);
            if (was || /^\s*(#.*)?$/.test(line)) continue;
            if (less.test(line)) --depth;
            assert.equal(/^ */.exec(line)[0].length, 4 * depth, `${name}: ${line}`);
            if (more.test(line)) ++depth, ++blocks;
        }
    }
    assert.ok(blocks > 10);
});
