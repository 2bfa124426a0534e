// Line ends of a file, which CodeMirror does not keep: one for each line but the last.
import { StateField, type ChangeSet, type Text } from '@codemirror/state';
import { usualEnd } from './bytes.ts';

// New lines get the usual end; others keep theirs.
export function changedEnds(ends: readonly string[], usual: string, changes: ChangeSet, before: Text): readonly string[] {
    let out: string[] | undefined;
    let moved = 0;
    changes.iterChanges((fromA, toA, _fromB, _toB, inserted) => {
        const first = before.lineAt(fromA).number - 1;
        const removed = before.lineAt(toA).number - 1 - first;
        const added = inserted.lines - 1;
        if (removed === 0 && added === 0) return;
        out ??= [...ends];
        const kept = ends.slice(first, first + Math.min(removed, added));
        out.splice(first + moved, removed, ...kept, ...Array<string>(added - kept.length).fill(usual));
        moved += added - removed;
    });
    return out ?? ends;
}

export function endsField(ends: readonly string[]): StateField<readonly string[]> {
    const usual = usualEnd(ends);
    return StateField.define<readonly string[]>({
        create: () => ends,
        update: (value, transaction) =>
            transaction.docChanged ? changedEnds(value, usual, transaction.changes, transaction.startState.doc) : value,
    });
}
