// Keeps the address of the page and what it shows the same.
import { fragmentOf, type Settings } from './fragment.ts';

// Milliseconds after the last change: browsers allow only so many changes of the address.
const delay = 300;

export class Address {
    private timer: ReturnType<typeof setTimeout> | undefined;
    // The fragment as the page wrote it last.
    private written: string | undefined;

    // `none`: the fragment of the scene as it is written, where an empty one means the values of the page.
    constructor(
        private readonly settings: () => Settings | undefined,
        private readonly none: string,
        came: () => void,
    ) {
        window.addEventListener('hashchange', () => {
            if (location.hash.slice(1) !== this.written) came();
        });
    }

    changed(): void {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.write(), delay);
    }

    write(): void {
        clearTimeout(this.timer);
        const settings = this.settings();
        if (!settings) return;
        const fragment = fragmentOf(settings) || this.none;
        if (fragment === location.hash.slice(1)) return;
        this.written = fragment;
        const address = fragment === '' ? location.href.replace(/#.*$/, '') : `#${fragment}`;
        try {
            history.replaceState(null, '', address);
        } catch {
            // Some browsers refuse this for files on a disk.
            location.replace(`#${fragment}`);
        }
        this.written = location.hash.slice(1);
    }
}
