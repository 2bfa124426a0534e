// What the editor and the page around it know of each other.
import type { Place, Problem, Saved } from '../engine.ts';
import type { KeptFolder } from '../store.ts';
import type { Folder } from './folder.ts';

export type Files = ReadonlyMap<string, Uint8Array>;

export type Checked =
    | { state: 'done'; problems: Problem[] }
    // replaced: a later call has taken the place of this one. stopped: no answer within the time limit. absent: there is
    // no worker, so that nobody knows.
    | { state: 'replaced' | 'stopped' | 'absent' };

// Reports problems without graphics, off the main thread (checker.ts).
export interface Checker {
    check(scene: string, files: Files): Promise<Checked>;
}

export interface EditorHost {
    // The files of the scene, as the page has them now: the author's bytes, not decoded images.
    files: Map<string, Uint8Array>;
    // The name of the scene's .glib among them; '' while the page shows no scene.
    scene: string;
    // Where the files are from, if that can be read and written again.
    folder?: Folder;
    // Where the scene is from, so that drafts of its texts find it.
    place: string;
    checker: Checker;
    // These files were edited or added, and these are their bytes: not every file is UTF-8, and line ends are the
    // author's; those that are `gone` are there no more. The page puts them into `files`, draws again, and calls show()
    // with what the engine says.
    changed(files: Files, gone?: readonly string[]): void;
    // Another scene takes the place of this one: dropped, or chosen among the examples. The page calls opened().
    openScene(name: string, files: Map<string, Uint8Array>, folder?: Folder): Promise<void>;
    // Names of the files that the scene reads.
    used(): string[];
    // The texts with the values as they are now.
    saved(): Saved;
    // Small pictures of scenes among these files, one after the other, until it is ended. A string: why there is none.
    pictures(files: Files): { of(scene: string): HTMLElement | string; end(): void };
    // A message for the page's live region, such as why a dropped file cannot be opened.
    say(message: string): void;
}

export interface Editor {
    element: HTMLElement;
    // What the page shows while it has no scene: how to open one, the examples, and a new scene.
    welcome: HTMLElement;
    show(problems: Problem[]): void;
    goTo(place: Place): void;
    // host.files and host.scene are others now. The page calls show() afterwards.
    opened(): void;
    // Downloads the scene as a .zip with all edits, which are then no longer marked, unless they belong into a folder.
    download(): void;
    // Writes values and edits into the folder.
    save(): void;
    // The list of the scenes among the files.
    scenes(): void;
    // Names of files whose edits were not saved.
    edited(): string[];
    // Opens a folder of an earlier visit.
    openKept(folder: KeptFolder): void;
}
