// A page around the editor without an engine, for editor.browser.mjs. Its checker knows one mistake: words at the beginning
// of a line of a scene that are no commands.
import type { Problem } from '../../page/engine.ts';
import { makeEditor } from '../../page/editor/editor.ts';
import type { EditorHost, Files } from '../../page/editor/host.ts';
import { findCommand } from '../../page/editor/words.ts';

function problemsOf(scene: string, files: Files): Problem[] {
    const lines = new TextDecoder('windows-1252').decode(files.get(scene)).split(/\r\n|\n/);
    return lines.flatMap((text, i) => {
        const word = /^[a-z]\w*/i.exec(text)?.[0];
        if (!word || findCommand(word)) return [];
        const at = { file: scene, line: i + 1, column: 1, endLine: i + 1, endColumn: word.length + 1 };
        const message = `unknown command '${word}'`;
        return [{ severity: 'error', code: 'unknown-command', message, help: '', at, text: message }];
    });
}

const said: string[] = [];
const place = document.getElementById('place')!;
const host: EditorHost = {
    files: new Map(),
    scene: '',
    checker: { check: async (scene, files) => ({ state: 'done', problems: problemsOf(scene, files) }) },
    changed: (files) => {
        for (const [name, bytes] of files) host.files.set(name, bytes);
        editor.show(problemsOf(host.scene, host.files));
    },
    openScene: (scene, files) => {
        host.scene = scene;
        host.files = files;
        place.replaceChildren(editor.element);
        editor.opened();
        editor.show(problemsOf(scene, files));
    },
    say: (message) => void said.push(message),
};
const editor = makeEditor(host);
place.replaceChildren(editor.welcome);
Object.assign(window, { host, said });
