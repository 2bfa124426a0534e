// The folder of a scene: what other programs save comes into the page, and the page's values and edits go there.
import { ask } from '../dialog.ts';
import { same } from './bytes.ts';
import type { EditorHost } from './host.ts';
import { baseOf, resolve } from './names.ts';
import type { Session } from './session.ts';

const list = (names: readonly string[]) => names.map((name) => baseOf(name)).join(', ');

export class Living {
    #stop = () => {};
    // Texts of other programs, of files that were changed here, too, until it is said whose text it is.
    readonly #undecided = new Map<string, Uint8Array>();

    constructor(
        private readonly host: EditorHost,
        private readonly session: Session,
    ) {}

    // Another scene is open.
    opened(): void {
        this.#stop();
        this.#undecided.clear();
        const { folder } = this.host;
        this.#stop = folder?.watch((all) => this.#look(all)) ?? (() => {});
    }

    async #look(all: boolean): Promise<void> {
        const { host, session } = this;
        const { folder } = host;
        if (!folder) return;
        const { files, gone } = await folder.look([...host.used(), ...session.names()], all);
        if (folder !== host.folder || files.size + gone.length === 0) return;
        for (const name of session.edited()) {
            const theirs = files.get(name);
            if (theirs && (await this.#chosen(name, theirs)) !== 'theirs') files.delete(name);
        }
        if (gone.length > 0) {
            session.gone(gone);
            host.changed(new Map(), gone);
        }
        if (gone.includes(host.scene)) host.say(`'${host.scene}' is not in the folder any more: download it to keep it.`);
        session.replaced(files);
    }

    // A text that was changed here and there: whose is it?
    async #chosen(name: string, theirs: Uint8Array): Promise<'mine' | 'theirs' | undefined> {
        this.#undecided.set(name, theirs);
        const text = `'${name}' has edits here that are not saved, and another program has changed it, too.`;
        const answer = await ask<'mine' | 'theirs'>('Changed twice', text, [
            { text: 'Keep my edits', value: 'mine' },
            { text: 'Take the text of the file', value: 'theirs' },
        ]);
        if (answer) this.#undecided.delete(name);
        if (answer === 'mine') this.session.rebase(name, theirs);
        return answer;
    }

    // Whether it is said of all texts whose they are.
    async #decided(): Promise<boolean> {
        for (const [name, theirs] of this.#undecided) {
            const answer = this.session.edited().includes(name) ? await this.#chosen(name, theirs) : 'theirs';
            if (!answer) return false;
            if (answer === 'theirs') this.session.replaced(new Map([[name, theirs]]));
        }
        this.#undecided.clear();
        return true;
    }

    // Only numbers change in texts that were not edited. False: nothing was written, and the page says why.
    async save(): Promise<boolean> {
        const { host, session } = this;
        const no = (why: string) => (host.say(why), false);
        if (!host.folder) return false;
        if (!(await this.#decided())) return no(`Nothing was written: ${list([...this.#undecided.keys()])} is changed by another program, too.`);
        await session.settled();
        const texts = new Map(session.edited().map((name) => [name, session.bytes(name)]));
        const { files, unwritten, error } = host.saved();
        for (const { name, bytes } of files) texts.set(resolve('', name), bytes);
        const rest = unwritten.slice(0, 3).map((each) => ` Not saved: ${each}.`).join('');
        if (texts.size === 0) return no(error || rest.trim() || 'The values are those of the file.');
        const before = new Map(session.names().map((name) => [name, session.bytes(name)]));
        const failed = await host.folder.write(texts);
        if (failed !== '') return no(failed);
        // What was typed meanwhile is an edit of what was saved.
        const typed = (name: string) => before.has(name) && !same(before.get(name)!, session.bytes(name));
        const untouched = new Map([...texts].filter(([name]) => !typed(name)));
        for (const [name, bytes] of texts) if (!untouched.has(name)) session.rebase(name, bytes);
        session.replaced(untouched);
        host.say(`Saved ${list([...texts.keys()])}.${rest}${error && ` The values are not saved: ${error}.`}`);
        return true;
    }
}
