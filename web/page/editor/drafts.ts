// Edits that outlive the page: each visit keeps its own, and the next one offers them.
import { ask } from '../dialog.ts';
import { all, drop, put, type Draft } from '../store.ts';
import { same } from './bytes.ts';
import type { EditorHost } from './host.ts';
import { saveZip } from './pack.ts';
import type { Session } from './session.ts';

// Milliseconds after the last edit.
const pause = 400;
const oldest = 90 * 24 * 3600 * 1000;

const names = ({ texts }: Draft) => texts.map(({ name }) => `'${name}'`).join(', ');
const time = ({ when }: Draft) => new Date(when).toLocaleString(undefined, { dateStyle: 'medium', timeStyle: 'short' });

export class Drafts {
    readonly #visit = crypto.randomUUID?.() ?? String(Math.random());
    #timer: ReturnType<typeof setTimeout> | undefined;
    #told = false;
    #edits = 0;
    // Everything that was edited is kept.
    safe = true;

    constructor(
        private readonly host: EditorHost,
        private readonly session: Session,
    ) {
        // A page that is hidden may never come back.
        document.addEventListener('visibilitychange', () => document.hidden && void this.#write());
    }

    // Call it after each edit.
    changed(): void {
        this.safe = false;
        ++this.#edits;
        clearTimeout(this.#timer);
        this.#timer = setTimeout(() => void this.#write(), pause);
    }

    async #write(): Promise<void> {
        clearTimeout(this.#timer);
        if (this.safe) return;
        const texts = this.session.edits();
        const { place } = this.host;
        const id = `${place}\n${this.#visit}`;
        const edits = this.#edits;
        if (texts.length === 0) await drop('drafts', id);
        const kept = texts.length === 0 || (await put('drafts', { id, place, when: Date.now(), texts }));
        if (edits === this.#edits) this.safe = kept; // else there is an edit that this draft does not have
        if (kept || this.#told) return;
        this.#told = true;
        this.host.say('This browser keeps no drafts here: download or save your edits before you leave the page.');
    }

    // Offers what earlier visits have left of this scene, the last one first.
    async opened(): Promise<void> {
        this.safe = true;
        const { place } = this.host;
        const found = (await all('drafts')).filter(({ id }) => !id.endsWith(this.#visit));
        for (const each of found) if (Date.now() - each.when > oldest) void drop('drafts', each.id);
        const drafts = found.filter((each) => each.place === place);
        for (const [i, draft] of drafts.entries()) {
            if (this.host.place !== place) return;
            await this.#offer(draft, drafts.length > 1 ? ` (${i + 1} of ${drafts.length})` : '');
        }
    }

    async #offer(draft: Draft, which: string): Promise<void> {
        const { host, session } = this;
        const { place } = host;
        const there = new Set(session.names());
        const fits = draft.texts.every(({ name, base }) => there.has(name) && same(session.bytes(name), base));
        const taken = fits ? { text: 'Take the edits', value: 'take' } : { text: 'Download the edited texts', value: 'download' };
        const newer = fits ? '' : ' They belong to an older text than the scene has now.';
        const answer = await ask(`Edits that were not saved${which}`, `${time(draft)}: edits of ${names(draft)}.${newer}`, [
            taken,
            { text: 'Discard the edits', value: 'discard' },
        ]);
        if (answer === undefined || host.place !== place) return;
        if (answer === 'take') for (const { name, bytes } of draft.texts) session.retext(name, bytes);
        if (answer === 'download') saveZip(host.scene, new Map(draft.texts.map(({ name, bytes }) => [name, bytes])));
        if (answer === 'take') await this.#write();
        await drop('drafts', draft.id);
    }
}
