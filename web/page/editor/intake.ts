// What to do with files from outside: open one of their scenes, or add them to the scene that is open.
import type { Problem } from '../engine.ts';
import type { Files } from './host.ts';
import { isScene } from './code.ts';
import { Budget, TooMuch } from './limits.ts';
import { baseOf, folderOf, Names, resolve } from './names.ts';

const missingCodes = new Set(['file-not-found', 'include-not-found', 'missing-include']);

// The files that the scene names and that are not there, as they would be called.
export function missingFiles(problems: readonly Problem[]): string[] {
    const names = problems.flatMap(({ code, message, at }) => {
        const list = missingCodes.has(code) && at ? (/'[^']+'(?:, '[^']+')*/.exec(message)?.[0] ?? '') : '';
        return [...list.matchAll(/'([^']+)'/g)].map(([, name]) => resolve(folderOf(at!.file), name));
    });
    return [...new Set(names)];
}

// Where each file goes: in place of a missing one of that name, of one that the scene has, or next to the scene.
export function placed(files: Files, scene: string, existing: Files, missing: readonly string[]): Map<string, Uint8Array> {
    const out = new Map<string, Uint8Array>();
    for (const [name, bytes] of files) {
        const tail = name.toLowerCase();
        const fits = (known: string) => `/${known.toLowerCase()}`.endsWith(`/${tail}`);
        const sameBase = (known: string) => baseOf(known).toLowerCase() === baseOf(tail);
        const beside = folderOf(scene) + name;
        const target = missing.find(fits) ?? missing.find(sameBase) ?? (existing.has(beside) ? beside : [...existing.keys()].find(fits));
        out.set(target ?? beside, bytes);
    }
    return out;
}

// Why the files cannot be added to those that are there, or ''.
export function cannotAdd(added: Files, existing: Files): string {
    const budget = new Budget();
    const names = new Names();
    try {
        for (const [name, bytes] of new Map([...existing, ...added])) {
            const error = names.take(name);
            if (error !== '') return `'${name}' cannot be added: ${error}.`;
            budget.file();
            budget.bytes(name, bytes.length);
        }
    } catch (error) {
        if (!(error instanceof TooMuch)) throw error;
        return `Nothing was added: ${error.message}.`;
    }
    return '';
}

export type Plan =
    | { kind: 'nothing' }
    | { kind: 'no scene' }
    | { kind: 'add'; files: Map<string, Uint8Array> }
    | { kind: 'open'; scenes: string[]; files: Map<string, Uint8Array> };

// Files without a scene, or whose scenes are all missed by the open one, are added to it.
export function plan(
    files: Map<string, Uint8Array>,
    open: { scene: string; files: Files; problems: readonly Problem[] },
): Plan {
    if (files.size === 0) return { kind: 'nothing' };
    const missing = missingFiles(open.problems);
    const missed = (name: string) => missing.some((path) => baseOf(path).toLowerCase() === baseOf(name).toLowerCase());
    const scenes = [...files.keys()].filter(isScene);
    if (open.scene !== '' && scenes.every(missed))
        return { kind: 'add', files: placed(files, open.scene, open.files, missing) };
    if (scenes.length === 0) return { kind: 'no scene' };
    const depth = (name: string) => name.split('/').length;
    return { kind: 'open', scenes: scenes.sort((a, b) => depth(a) - depth(b) || (a < b ? -1 : 1)), files };
}
