// The extension and vscode-languageclient, as VS Code would run them, drive `snell lsp`.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { files, program, root, scratch, snell } from './snell.mjs';

const require = createRequire(import.meta.url);
const { createEditor } = require('./editor.cjs');
const manifest = require('../package.json');

let editor, extension, folder, scene, shader;
const cleanup = [];

async function until(what, message) {
    for (let i = 0; i < 200; ++i, await wait(50)) {
        const value = what();
        if (value) return value;
    }
    assert.fail(message);
}
const said = (document) => (editor.diagnostics.get(document.uri.toString()) ?? []).map((d) => `${d.range.start.line}:${d.range.start.character} ${d.code?.value ?? d.code}`);

before(async () => {
    folder = scratch({ after: (what) => cleanup.push(what) });
    mkdirSync(join(folder, 'a b'));
    const at = (name) => join(folder, 'a b', name);
    writeFileSync(at('scene.glib'), '##OpenGL GLIB\n# café 🫖\nVertex plain.vert\nFragment plain.frag\nProgram Plain uShine <0. .5 1.>\nPushMatrix\nSpher 1 20 20\nPopMatrix\n');
    writeFileSync(at('plain.vert'), 'void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n');
    writeFileSync(at('plain.frag'), 'uniform float uShine;\nvoid main() { gl_FragColor = vec4(uShine); }\n');
    editor = createEditor(folder, { path: program }, async () => files(folder).filter((name) => name.endsWith('.glib')));
    extension = require('../dist/extension.js');
    scene = editor.open(at('scene.glib'), 'glib');
    await extension.activate({ subscriptions: [], asAbsolutePath: (path) => join(root, 'editors/vscode', path) });
    shader = editor.open(at('plain.frag'), 'plaintext');
});
after(async () => {
    await extension.deactivate();
    cleanup.forEach((clean) => clean());
});

test('every command of the manifest is there', () => {
    assert.deepEqual(editor.messages, []);
    for (const { command } of manifest.contributes.commands) assert.ok(editor.commands.has(command), command);
});

test('errors come and go while one types', async () => {
    await until(() => said(scene).includes('6:0 unknown-command'), 'the slip is not reported');
    editor.edit(scene, 'Spher', 'Sphere');
    await until(() => !said(scene).includes('6:0 unknown-command'), 'the slip is still reported');
    editor.edit(shader, 'vec4(uShine)', 'vec4(uShin)');
    await until(() => said(shader).some((one) => one.startsWith('1:')), 'the shader has no error');
    editor.edit(shader, 'vec4(uShin)', 'vec4(uShine)');
    await until(() => said(shader).length === 0, 'the shader still has an error');
});

test('a quick fix corrects the slip', async () => {
    editor.edit(scene, 'Sphere', 'Spher');
    await until(() => said(scene).includes('6:0 unknown-command'), 'the slip is not reported');
    const slip = editor.diagnostics.get(scene.uri.toString()).find(({ severity }) => severity === editor.vscode.DiagnosticSeverity.Error);
    const actions = await editor.ask('CodeActions', 'provideCodeActions', scene, slip.range, { diagnostics: [slip], triggerKind: 1 });
    const [[uri, [edit]]] = actions[0].edit.entries();
    assert.equal(uri.toString(), scene.uri.toString());
    assert.equal(scene.getText(edit.range), 'Spher');
    editor.edit(scene, 'Spher', edit.newText);
    assert.match(scene.text, /^Sphere 1/m);
    await until(() => said(scene).length === 0, 'the slip is still reported');
});

test('formatting is that of snell format', async () => {
    const options = { tabSize: 4, insertSpaces: true };
    const edits = await editor.ask('DocumentFormattingEdit', 'provideDocumentFormattingEdits', scene, options);
    let text = scene.text;
    for (const { range, newText } of [...edits].reverse()) text = text.slice(0, scene.offsetAt(range.start)) + newText + text.slice(scene.offsetAt(range.end));
    assert.equal(text, snell(['format', '-'], scene.text).stdout);
    assert.notEqual(text, scene.text);
    const all = new editor.vscode.Range(6, 0, 6, 1);
    const some = await editor.ask('DocumentRangeFormattingEdit', 'provideDocumentRangeFormattingEdits', scene, all, options);
    assert.deepEqual(some.map(({ range, newText }) => [range.start.line, newText]), [[6, '    ']]);
});

test('commands are completed and explained', async () => {
    const list = await editor.ask('CompletionItem', 'provideCompletionItems', scene, scene.find('Sphere', 3), {});
    const items = list.items ?? list;
    assert.ok(items.some(({ label }) => (label.label ?? label) === 'Sphere'));
    const hover = await editor.ask('Hover', 'provideHover', scene, scene.find('Sphere', 1));
    assert.match(JSON.stringify(hover.contents), /poles on Y/);
});

test('a uniform is found and renamed in the scene and its shader', async () => {
    const place = await editor.ask('Definition', 'provideDefinition', scene, scene.find('uShine', 1));
    assert.equal([place].flat()[0].uri.toString(), shader.uri.toString());
    const places = await editor.ask('Reference', 'provideReferences', scene, scene.find('uShine', 1), { includeDeclaration: true });
    assert.equal(places.length, 3);
    const edit = await editor.ask('Rename', 'provideRenameEdits', scene, scene.find('uShine', 1), 'uGloss');
    assert.deepEqual(edit.entries().map(([uri, edits]) => [uri.toString(), edits.length]).sort(), [[shader.uri.toString(), 2], [scene.uri.toString(), 1]].sort());
});

test('a scene is rendered next to the text', async () => {
    editor.vscode.window.activeTextEditor = { document: scene };
    await editor.commands.get('snell.renderScene')();
    await until(() => editor.opened.some((uri) => uri.endsWith('.png')), 'no picture is shown');
});

test('a scene that is not drawn says why', async () => {
    editor.edit(scene, 'Sphere', 'Spher');
    await editor.commands.get('snell.renderScene')();
    await until(() => editor.messages.some((message) => /scene\.glib: .*unknown command 'Spher'/.test(message)), 'nothing is said');
});
