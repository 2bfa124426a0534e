// What the editor and the page around it know of each other.
import type { Place, Problem } from '../engine.ts';

// Reports problems without graphics, off the main thread (worker.ts).
export interface Checker {
    // Resolves with undefined where a later call has replaced this one.
    check(scene: string, files: Map<string, Uint8Array>): Promise<Problem[] | undefined>;
}

export interface EditorHost {
    // The files of the scene, as the page has them now: the author's bytes, not decoded images.
    files: Map<string, Uint8Array>;
    // The name of the scene's .glib among them.
    scene: string;
    // Undefined where there is no engine for the worker (ready pictures).
    checker: Checker | undefined;
    // The author edited a file, and these are its bytes now: not every file is UTF-8, and line ends are the author's.
    // The page puts them into `files`, draws again, and calls show() with what the engine says.
    changed(name: string, bytes: Uint8Array): void;
    // Another scene takes the place of this one: dropped, or chosen among the examples.
    openScene(name: string, files: Map<string, Uint8Array>): void;
    // A message for the page's live region, such as why a dropped file cannot be opened.
    say(message: string): void;
}

export interface Editor {
    element: HTMLElement;
    show(problems: Problem[]): void;
    goTo(place: Place): void;
    // host.files and host.scene are others now.
    opened(): void;
}
