// The files of one scene while they are edited: what is shown, what is checked, and what the page is told.
import { setDiagnostics } from '@codemirror/lint';
import { EditorState, type Extension, type TransactionSpec } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import type { Place, Problem } from '../engine.ts';
import type { Draft } from '../store.ts';
import { read, same, unwritable, type Format } from './bytes.ts';
import { bytesOf, isEdited, keep, keepAs, makeDocument, marksOf, movedMarks, textFiles, type Document, type Mark } from './documents.ts';
import type { Checked, EditorHost, Files } from './host.ts';
import { asWritten, resolve } from './names.ts';
import { rangeOf } from './places.ts';
import { kind, merged } from './problems.ts';
import type { Tab } from './tabs.ts';

// A pause in typing, in milliseconds, after which the text is checked and drawn.
const pause = 150;

export class Session {
    readonly #documents = new Map<string, Document>();
    #current: Document | undefined;
    // Of the text as it was checked and drawn last: what the worker says, and what the engine says besides.
    #quick: Problem[] = [];
    #extra: Problem[] = [];
    // Both: recomputed only when one of them changes, so that the list of problems is not drawn with every key.
    #problems: readonly Problem[] = [];
    // Files from outside that the page does not have yet.
    #added = new Map<string, Uint8Array>();
    // Counts edits and scenes: an answer about another text than the current one is dropped.
    #version = 0;
    #timer: ReturnType<typeof setTimeout> | undefined;

    constructor(
        private readonly host: EditorHost,
        private readonly view: EditorView,
        // Tabs and problems are others now.
        private readonly refresh: () => void,
        private readonly editsChanged: () => void,
    ) {}

    get problems(): readonly Problem[] {
        return this.#problems;
    }

    get current(): Document | undefined {
        return this.#current;
    }

    // Takes what the host has, and forgets everything else.
    open(): void {
        clearTimeout(this.#timer);
        ++this.#version;
        this.#documents.clear();
        this.#current = undefined;
        this.#quick = [];
        this.#extra = [];
        this.#problems = [];
        this.#added.clear();
        this.#addDocuments();
        this.choose(this.#documents.keys().next().value ?? '');
    }

    choose(name: string): void {
        if (this.#current) this.#current.scroll = this.view.scrollSnapshot();
        this.#current = this.#documents.get(name);
        this.view.setState(this.#current?.state ?? EditorState.create());
        if (this.#current?.scroll) this.view.dispatch({ effects: this.#current.scroll });
        this.refresh();
    }

    tabs(): Tab[] {
        const count = (name: string, severity: Problem['severity']) =>
            this.problems.filter(({ at, severity: own }) => own === severity && at && resolve('', at.file) === name).length;
        return [...this.#documents.values()].map((document) => ({
            name: document.name,
            edited: isEdited(document),
            errors: count(document.name, 'error'),
            warnings: count(document.name, 'warning'),
        }));
    }

    names(): string[] {
        return [...this.#documents.keys()];
    }

    // Of a text, as it is in the editor.
    bytes(name: string): Uint8Array {
        return bytesOf(this.#documents.get(name)!);
    }

    // What the edited texts were made of, and what they are.
    edits(): Draft['texts'] {
        const edited = [...this.#documents.values()].filter(isEdited);
        return edited.map((document) => ({ name: document.name, base: document.kept.bytes, bytes: bytesOf(document) }));
    }

    edited(): string[] {
        return [...this.#documents.values()].filter(isEdited).map(({ name }) => name);
    }

    // All files of the scene, with the edits.
    files(): Map<string, Uint8Array> {
        const files = new Map([...this.host.files, ...this.#added]);
        for (const document of this.#documents.values()) files.set(document.name, bytesOf(document));
        return files;
    }

    // These files were downloaded as they are now.
    kept(names: Iterable<string>): void {
        for (const name of names) {
            const document = this.#documents.get(name);
            if (document) keep(document);
        }
        this.refresh();
        this.editsChanged();
    }

    show(problems: readonly Problem[]): void {
        this.#extra = [...problems];
        this.#mark((document) => marksOf(document, this.#problems));
    }

    // False: the place is not in a text of the scene.
    goTo(place: Place): boolean {
        const document = this.#documents.get(resolve('', place.file));
        if (!document) return false;
        if (document !== this.#current) this.choose(document.name);
        const { from, to } = rangeOf(place, this.view.state.doc, document.format);
        this.view.dispatch({ selection: { anchor: from, head: to }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
        this.view.focus();
        return true;
    }

    // Its file is another one now, and its edits stay.
    rebase(name: string, bytes: Uint8Array): void {
        const document = this.#documents.get(name)!;
        keepAs(document, makeDocument(name, bytes, () => [], () => []));
        this.refresh();
        this.editsChanged();
    }

    // Edits that come from elsewhere, such as a draft: an undo takes them back.
    retext(name: string, bytes: Uint8Array): boolean {
        const document = this.#documents.get(name);
        if (!document) return false;
        const [now, next] = [document.state.doc.toString(), read(bytes).lines.join('\n')];
        const most = Math.min(now.length, next.length);
        let from = 0;
        while (from < most && now[from] === next[from]) ++from;
        let end = 0;
        while (end < most - from && now[now.length - 1 - end] === next[next.length - 1 - end]) ++end;
        this.#dispatch(document, { changes: { from, to: now.length - end, insert: next.slice(from, next.length - end) } });
        return same(bytesOf(document), bytes);
    }

    // These files are others on the disk, and their texts no longer edited.
    replaced(files: Files): void {
        for (const [name, bytes] of files)
            if (this.retext(name, bytes)) keep(this.#documents.get(name)!);
            else this.#added.set(name, bytes);
        if (this.#added.size > 0) this.add(new Map(this.#added));
        else this.#edited();
    }

    // These files are not on the disk any more; the scene itself and edits stay.
    gone(names: readonly string[]): void {
        const shown = this.#current?.name ?? '';
        for (const name of names) {
            const document = this.#documents.get(name);
            if (!document || name === this.host.scene || isEdited(document)) continue;
            this.#documents.delete(name);
            if (name === shown) this.choose(this.#documents.keys().next().value ?? '');
        }
        this.#edited();
    }

    // Files from outside, which belong to the scene from now on.
    add(files: Files): void {
        const shown = this.#current?.name ?? '';
        for (const [name, bytes] of files) {
            this.#documents.delete(name);
            this.#added.set(name, bytes);
        }
        this.#addDocuments();
        this.choose(this.#documents.has(shown) ? shown : this.host.scene);
        this.#edited();
    }

    // Checks the text as it is, so that the worker has started when it is edited.
    warm(): void {
        void this.settled();
    }

    // The page has all edits.
    settled(): Promise<void> {
        clearTimeout(this.#timer);
        return this.#flush();
    }

    #dispatch(document: Document, spec: TransactionSpec): void {
        if (document === this.#current) return this.view.dispatch(spec);
        const before = document.state.doc;
        document.state = document.state.update(spec).state;
        if (document.state.doc !== before) this.#edited();
    }

    #addDocuments(): void {
        const files = new Map([...this.host.files, ...this.#added]);
        const old = new Map(this.#documents);
        this.#documents.clear();
        for (const name of textFiles(this.host.scene, files)) {
            const made = old.get(name) ?? makeDocument(name, files.get(name)!, () => this.#names(), (format) => this.#extensions(name, format));
            this.#documents.set(name, made);
        }
        // Files that are gone, such as renamed ones, are not known any more, but edits of them are.
        for (const [name, document] of old) if (!this.#documents.has(name) && isEdited(document)) this.#documents.set(name, document);
    }

    // Names of files as the scene writes them.
    #names(): string[] {
        return [...this.host.files.keys()].map((name) => asWritten(this.host.scene, name));
    }

    #extensions(name: string, format: Format): Extension {
        const listener = EditorView.updateListener.of((update) => {
            const document = this.#documents.get(name);
            if (!document || document !== this.#current) return;
            document.state = update.state;
            if (update.docChanged) this.#edited();
        });
        const filter = EditorState.changeFilter.of((transaction) => {
            let lacks: string[] = [];
            transaction.changes.iterChanges((_fromA, _toA, _fromB, _toB, text) => {
                lacks = lacks.concat(unwritable(text.toString(), format));
            });
            if (lacks.length === 0) return true;
            this.host.say(`'${name}' is not in UTF-8 but in Windows-1252, which has no '${lacks[0]}'.`);
            return false;
        });
        return [listener, filter];
    }

    #edited(): void {
        ++this.#version;
        clearTimeout(this.#timer);
        this.#timer = setTimeout(() => void this.#flush(), pause);
        this.refresh();
        this.editsChanged();
    }

    // Checks the text, and then lets the page draw it: a text that the worker does not get through must not reach the
    // page's own thread.
    async #flush(): Promise<void> {
        const version = this.#version;
        const files = this.files();
        const absent: Checked = { state: 'absent' };
        const answer = (await this.host.checker.check(this.host.scene, files)) ?? absent;
        if (version !== this.#version || answer.state === 'replaced' || answer.state === 'stopped') return;
        if (answer.state === 'done') this.#showQuick(answer.problems);
        const changed = [...files].filter(([name, bytes]) => this.host.files.get(name) !== bytes);
        // Marks appear before the programs are compiled.
        await new Promise((resolve) => setTimeout(resolve));
        if (version !== this.#version || changed.length === 0) return;
        this.#added.clear();
        this.host.changed(new Map(changed));
    }

    // What only the engine says stays until it says something else, where its text is now.
    #showQuick(problems: readonly Problem[]): void {
        const said = new Set([...this.#quick, ...problems].map(kind));
        this.#extra = this.#extra.filter((problem) => !said.has(kind(problem)));
        this.#quick = [...problems];
        const extra = new Set(this.#extra);
        this.#mark((document) => [...marksOf(document, problems), ...movedMarks(document, extra)]);
    }

    #mark(marks: (document: Document) => Mark[]): void {
        this.#problems = merged(this.#extra, this.#quick);
        for (const document of this.#documents.values())
            this.#dispatch(document, setDiagnostics(document.state, marks(document)));
        this.refresh();
    }
}
