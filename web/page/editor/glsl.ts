// Highlighting and completion of shaders.
import { completeAnyWord, type Completion, type CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { indentService, StreamLanguage, type StreamParser } from '@codemirror/language';
import { countColumn } from '@codemirror/state';
import { variables } from './words.ts';
import words from './words.json';

// Highlighted, and not offered.
const legacy = /^(texture|shadow)[123]D|^noise\d|^image|^atomic|Stream/;

const [keywords, types] = [new Set(words.keywords), new Set(words.types)];
const functions = words.functions.filter((name) => !legacy.test(name));
const functionNames = new Set(words.functions);
const given = new Set(variables.map(({ name }) => name.replace(/\[.*/, '')));

interface State {
    // Within a comment of several lines.
    comment: boolean;
}

const parser: StreamParser<State> = {
    name: 'glsl',
    startState: () => ({ comment: false }),
    token(stream, state) {
        if (state.comment) {
            state.comment = !stream.match(/^.*?\*\//);
            if (state.comment) stream.skipToEnd();
            return 'comment';
        }
        if (stream.eatSpace()) return null;
        if (stream.match(/^\/\/.*/)) return 'comment';
        if (stream.match('/*')) {
            state.comment = true;
            return 'comment';
        }
        if (stream.match(/^#\s*\w*/)) return 'meta';
        if (stream.match(/^"[^"]*"?/)) return 'string';
        if (stream.match(/^(0x[\da-f]+u?|(\d+\.?\d*|\.\d+)(e[-+]?\d+)?(lf|f|u)?)/i)) return 'number';
        if (stream.match(/^[A-Za-z_]\w*/)) {
            const word = stream.current();
            if (keywords.has(word)) return 'keyword';
            if (types.has(word)) return 'typeName';
            if (word === 'true' || word === 'false') return 'atom';
            if (functionNames.has(word)) return 'variableName.standard';
            return word.startsWith('gl_') || given.has(word) ? 'variableName.special' : 'variableName';
        }
        stream.next();
        return /[-+*/%=<>!&|^~?:]/.test(stream.current()) ? 'operator' : null;
    },
    languageData: {
        commentTokens: { line: '//', block: { open: '/*', close: '*/' } },
        indentOnInput: /^\s*[{}]$/,
    },
};

// As the line above, deeper after an open brace.
const indent = indentService.of((context, position) => {
    const broken = context.simulatedBreak === position;
    if (!broken && position === 0) return 0;
    const above = broken ? context.lineAt(position, -1) : context.state.doc.lineAt(position - 1);
    const opened = /[{(]\s*(\/\/.*)?$/.test(above.text) ? context.unit : 0;
    const closes = /^\s*[})]/.test(context.textAfterPos(position)) ? context.unit : 0;
    const width = countColumn(/^\s*/.exec(above.text)![0], context.state.tabSize);
    return Math.max(0, width + opened - closes);
});

export const glsl = [StreamLanguage.define(parser), indent];

const options: Completion[] = [
    ...variables.map(({ name, type, doc }) => ({ label: name, type: 'variable', detail: type, info: doc })),
    ...functions.map((label) => ({ label, type: 'function' })),
    ...[...types].map((label) => ({ label, type: 'type' })),
    ...[...keywords].map((label) => ({ label, type: 'keyword' })),
];

// Names of the language and of snell, and the words of the file.
export function completeShader(context: CompletionContext): CompletionResult | null {
    const word = context.matchBefore(/\w+/);
    if (!word && !context.explicit) return null;
    const from = word?.from ?? context.pos;
    const own = completeAnyWord(context) as CompletionResult | null;
    const known = new Set(options.map(({ label }) => label));
    const ofFile = (own?.options ?? []).filter(({ label }) => !known.has(label));
    return { from, options: [...options, ...ofFile], validFor: /^\w*$/ };
}
