// The text field for one file after the other: extensions of CodeMirror, and the state of a file.
import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { bracketMatching, indentOnInput, indentUnit } from '@codemirror/language';
import { lintGutter, lintKeymap } from '@codemirror/lint';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { EditorState, type Extension } from '@codemirror/state';
import {
    drawSelection,
    EditorView,
    highlightActiveLine,
    highlightActiveLineGutter,
    highlightSpecialChars,
    keymap,
    lineNumbers,
} from '@codemirror/view';
import { completeScene, glib, type Neighbours } from './glib.ts';
import { completeShader, glsl } from './glsl.ts';
import { theme } from './theme.ts';

const sceneName = /\.(glib|inc)$/i;

export function isScene(name: string): boolean {
    return /\.glib$/i.test(name);
}

function language(name: string, neighbours: Neighbours): Extension {
    if (sceneName.test(name)) return [glib, autocompletion({ override: [completeScene(neighbours)], icons: false })];
    if (/\.(txt|md|json|csv)$/i.test(name)) return [];
    return [glsl, autocompletion({ override: [completeShader], icons: false })];
}

// Indentation as most lines of the file have it.
function unit(text: string): string {
    if (/^\t/m.test(text)) return '\t';
    return /^ {2}\S/m.test(text) ? '  ' : '    ';
}

const common: Extension = [
    lineNumbers(),
    lintGutter(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    highlightSpecialChars(),
    history(),
    drawSelection(),
    indentOnInput(),
    bracketMatching(),
    closeBrackets(),
    highlightSelectionMatches(),
    search({ top: false }),
    EditorState.tabSize.of(4),
    EditorView.lineWrapping,
    keymap.of([
        ...closeBracketsKeymap,
        ...completionKeymap,
        ...searchKeymap,
        ...historyKeymap,
        ...lintKeymap,
        ...defaultKeymap,
        // Escape and then Tab leaves the field.
        indentWithTab,
    ]),
    theme,
];

// Accepts the lines as they are: line ends are kept apart (ends.ts).
export function stateOf(name: string, lines: readonly string[], neighbours: Neighbours, more: Extension): EditorState {
    const doc = lines.join('\n');
    return EditorState.create({
        doc,
        extensions: [
            common,
            language(name, neighbours),
            indentUnit.of(unit(doc)),
            EditorView.contentAttributes.of({
                'aria-label': `Text of ${name}`,
                autocapitalize: 'off',
                spellcheck: 'false',
                tabindex: '0',
            }),
            more,
        ],
    });
}
