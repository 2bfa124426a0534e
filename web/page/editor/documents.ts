// The text files of a scene in the editor, each with its own undo history.
import { forEachDiagnostic, type Diagnostic } from '@codemirror/lint';
import type { EditorState, Extension, StateEffect, StateField } from '@codemirror/state';
import type { Problem } from '../engine.ts';
import { isText, read, same, write, type Format } from './bytes.ts';
import { stateOf } from './code.ts';
import { endsField } from './ends.ts';
import type { Files } from './host.ts';
import { asWritten, folderOf, resolve } from './names.ts';
import { rangeOf } from './places.ts';

export interface Document {
    name: string;
    format: Format;
    ends: StateField<readonly string[]>;
    state: EditorState;
    // Where it was scrolled to when another file was chosen.
    scroll?: StateEffect<unknown>;
    // As it was opened or downloaded last.
    kept: { bytes: Uint8Array; doc: EditorState['doc']; ends: readonly string[] };
    // The bytes of `of`, which is the text of a state: an unedited text keeps its array.
    bytes: Uint8Array;
    of: EditorState['doc'];
}

export function makeDocument(name: string, bytes: Uint8Array, names: () => string[], more: (format: Format) => Extension): Document {
    const { format, lines, ends } = read(bytes);
    const field = endsField(ends);
    const state = stateOf(name, lines, { names }, [field, more(format)]);
    return { name, format, ends: field, state, kept: { bytes, doc: state.doc, ends }, bytes, of: state.doc };
}

export function bytesOf(document: Document): Uint8Array {
    const { state, format } = document;
    if (document.of === state.doc) return document.bytes;
    const bytes = write({ format, lines: state.doc.toJSON(), ends: [...state.field(document.ends)] });
    document.bytes = same(bytes, document.kept.bytes) ? document.kept.bytes : bytes;
    document.of = state.doc;
    return document.bytes;
}

// Without the bytes, which take long in a large file.
export function isEdited({ state, kept, ends }: Document): boolean {
    const now = state.field(ends);
    return !state.doc.eq(kept.doc) || (now !== kept.ends && now.some((end, i) => end !== kept.ends[i]));
}

// What is kept of the one becomes that of the other.
export function keepAs(document: Document, { kept, ends, state }: Document): void {
    document.kept = { ...kept, ends: state.field(ends) };
}

export function keep(document: Document): void {
    document.kept = { bytes: bytesOf(document), doc: document.state.doc, ends: document.state.field(document.ends) };
}

// The scene first, then what its text names, then the other files of its folder, then all others: scenes and includes
// before shaders.
export function textFiles(scene: string, files: Files): string[] {
    const text = new TextDecoder().decode(files.get(scene));
    const kind = (name: string) => (/\.(glib|inc)$/i.test(name) ? 0 : /\.(txt|md)$/i.test(name) ? 2 : 1);
    const near = (name: string) => (text.includes(asWritten(scene, name)) ? 0 : folderOf(name) === folderOf(scene) ? 1 : 2);
    const rank = new Map([...files.keys()].map((name) => [name, name === scene ? -1 : 3 * near(name) + kind(name)]));
    return [...files]
        .filter(([name, bytes]) => isText(name, bytes))
        .map(([name]) => name)
        .sort((a, b) => rank.get(a)! - rank.get(b)! || (a < b ? -1 : 1));
}

const severities = { error: 'error', warning: 'warning', note: 'info' } as const;

// A mark in the text, which moves with edits.
export interface Mark extends Diagnostic {
    problem: Problem;
}

// The marks of a file's problems, by their places in its text.
export function marksOf(document: Document, problems: readonly Problem[]): Mark[] {
    return problems.flatMap((problem) => {
        if (!problem.at || resolve('', problem.at.file) !== document.name) return [];
        const range = rangeOf(problem.at, document.state.doc, document.format);
        const message = problem.help ? `${problem.message}\n${problem.help}` : problem.message;
        return [{ ...range, severity: severities[problem.severity], message, source: problem.code, problem }];
    });
}

// The marks of these problems where they are now, after edits.
export function movedMarks(document: Document, problems: ReadonlySet<Problem>): Mark[] {
    const out: Mark[] = [];
    forEachDiagnostic(document.state, (diagnostic, from, to) => {
        if (problems.has((diagnostic as Mark).problem)) out.push({ ...(diagnostic as Mark), from, to });
    });
    return out;
}
