// Undo and redo. A step is what one gesture changed: a drag, a key that repeats, a typed number.

export interface Setting {
    value: number[];
    min: number;
    max: number;
}

export type Change =
    | { what: 'value'; key: string; before: Setting; after: Setting }
    | { what: 'rung'; key: string; before: string; after: string }
    | { what: 'view'; key: ''; before: string; after: string };

export interface Step {
    // For people, of steps that change several things.
    name?: string;
    changes: Change[];
}

function same(a: Change['before'], b: Change['before']): boolean {
    return JSON.stringify(a) === JSON.stringify(b);
}

function opposite(change: Change): Change {
    return { ...change, before: change.after, after: change.before } as Change;
}

// Adds a change to those of a gesture: what was before the gesture stays.
function merged(changes: readonly Change[], next: Change): Change[] {
    const at = changes.findIndex(({ what, key }) => what === next.what && key === next.key);
    if (at < 0) return [...changes, next];
    return changes.map((change, i) => (i === at ? ({ ...change, after: next.after } as Change) : change));
}

const mostSteps = 200;

export class History {
    private past: Step[] = [];
    private future: Step[] = [];
    // The gesture that made the last step, while it may go on.
    private gesture: unknown;

    // Changes of one `gesture` are one step; without a gesture, each call is one.
    record(changes: Change[], gesture?: unknown, name?: string): void {
        const real = changes.filter(({ before, after }) => !same(before, after));
        const last = this.past.at(-1);
        if (gesture !== undefined && gesture === this.gesture && last) {
            last.changes = real.reduce(merged, last.changes);
        } else {
            if (real.length === 0) return;
            this.past.push({ name, changes: real });
            if (this.past.length > mostSteps) this.past.shift();
        }
        this.gesture = gesture;
        this.future = [];
    }

    // The next change begins another step. A gesture that came back to where it began leaves none.
    end(): void {
        this.gesture = undefined;
        const last = this.past.at(-1);
        if (last && last.changes.every(({ before, after }) => same(before, after))) this.past.pop();
    }

    // What is to be set, in this order.
    undo(): Step | undefined {
        this.end();
        const step = this.past.pop();
        if (!step) return undefined;
        this.future.push(step);
        return { name: step.name, changes: [...step.changes].reverse().map(opposite) };
    }

    redo(): Step | undefined {
        this.end();
        const step = this.future.pop();
        if (!step) return undefined;
        this.past.push(step);
        return step;
    }

    clear(): void {
        this.past = [];
        this.future = [];
        this.gesture = undefined;
    }

    get canUndo(): boolean {
        return this.past.length > 0;
    }
    get canRedo(): boolean {
        return this.future.length > 0;
    }
}
