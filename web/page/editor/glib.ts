// Highlighting and completion of scenes.
import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete';
import { StreamLanguage, type StreamParser } from '@codemirror/language';
import { choices, commands, findCommand } from './words.ts';

interface State {
    // The next word is a command.
    begins: boolean;
    // The line ends in a backslash, so that the statement continues on the next one.
    continues: boolean;
}

const words = new Set([...choices, 'true', 'false']);

const parser: StreamParser<State> = {
    name: 'glib',
    startState: () => ({ begins: true, continues: false }),
    blankLine(state) {
        state.begins = true;
        state.continues = false;
    },
    token(stream, state) {
        if (stream.sol()) {
            state.begins = !state.continues;
            state.continues = false;
        }
        if (stream.eatSpace()) return null;
        if (stream.match(/^(#|\/\/).*/)) {
            // A line of comment between the lines of a statement does not end it.
            if (stream.string.slice(0, stream.start).trim() === '') state.continues = !state.begins;
            return 'comment';
        }
        if (stream.match(/^\\\s*$/)) {
            state.continues = true;
            return 'operator';
        }
        if (stream.match(/^"[^"]*"?/)) return 'string';
        if (stream.match(/^[<>[\]{},]/)) return 'bracket';
        if (stream.match(/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?(?=[\s<>[\]{},\\]|$)/i)) return 'number';
        stream.match(/^[^\s<>[\]{},"\\]+/) || stream.next();
        const word = stream.current();
        const first = state.begins;
        state.begins = false;
        if (first) return findCommand(word) ? 'keyword' : 'invalid';
        return words.has(word) ? 'atom' : null;
    },
    languageData: { commentTokens: { line: '#' }, closeBrackets: { brackets: ['[', '{', '"'] } },
};

export const glib = StreamLanguage.define(parser);

const options: Completion[] = commands.map(({ name, signature, doc }) => ({
    label: name,
    type: 'keyword',
    detail: signature.length > 40 ? `${signature.slice(0, 39)}…` : signature,
    info: doc,
}));

// Names of the scene's files, and the folder of the file that is written.
export interface Neighbours {
    names(): string[];
}

function fileOptions(neighbours: Neighbours): Completion[] {
    return neighbours.names().map((label) => ({ label, type: 'text', boost: -1 }));
}

// Commands at the beginning of a statement, otherwise words and files.
export function completeScene(neighbours: Neighbours) {
    return (context: CompletionContext): CompletionResult | null => {
        const line = context.state.doc.lineAt(context.pos);
        const before = line.text.slice(0, context.pos - line.from);
        if (/^\s*(#|\/\/)/.test(before)) return null;
        const word = /[\w./-]*$/.exec(before)![0];
        if (word === '' && !context.explicit) return null;
        const from = context.pos - word.length;
        const continued = line.number > 1 && /\\\s*$/.test(context.state.doc.line(line.number - 1).text);
        if (before.slice(0, before.length - word.length).trim() === '' && !continued)
            return { from, options, validFor: /^\w*$/ };
        const command = findCommand(/^\s*(\w*)/.exec(before)![1]);
        const known = choices.filter((choice) => command?.signature.includes(choice));
        return {
            from,
            options: [...known.map((label) => ({ label, type: 'enum' })), ...fileOptions(neighbours)],
            validFor: /^[\w./-]*$/,
        };
    };
}
