// What draws a scene, as the page sees it.

// Lines and columns begin at 1; columns count characters, as in every message of snell.
export interface Place {
    file: string;
    line: number;
    column: number;
    endLine: number;
    endColumn: number;
}

export interface Problem {
    severity: 'error' | 'warning' | 'note';
    code: string;
    message: string;
    help: string;
    at?: Place;
    // The whole message with its excerpt, as `snell check` prints it.
    text: string;
}

export interface Control {
    // For set() and the like; valid until the next open() or choose().
    index: number;
    // "Glass.uEta", or "Glass#2.uEta" in the second program of that name.
    key: string;
    program: string;
    name: string;
    widget: 'slider' | 'check_box' | 'color';
    min: number;
    max: number;
    value: number[];
    // What the scene's text says: a reset restores it.
    initial: number[];
    logarithmic: boolean;
    canBeLogarithmic: boolean;
    // Of each component: where it is on its track, 0 to 1; value and initial as text; and in how many seconds it goes
    // there and back by itself, 0 if it does not.
    at: number[];
    shown: string[];
    initialShown: string[];
    periods: number[];
}

export interface Ladder {
    index: number;
    name: string;
    rungs: string[];
    chosen: number;
    marked: number;
    // The most exact rung.
    reference: number;
}

// What is shown after open() or choose().
export interface Shown {
    title: string;
    scene: string;
    controls: Control[];
    ladders: Ladder[];
    // As the scene wants its window.
    width: number;
    height: number;
    // It changes with time; with the mouse.
    animated: boolean;
    usesMouse: boolean;
    // Its loops go round thousands of times, or nobody knows how often.
    longLoops: boolean;
    // The period of the scene's own timer, in seconds, where it has one; 0: none.
    period: number;
    // Paths of the files that were read.
    files: string[];
    counters: Record<string, number>;
}

// All that changes without open() and choose().
export interface State {
    // In the order of Shown.
    controls: Control[];
    // What differs from the scene, as the command line takes it: "Glass.uEta=1.3", "Glass.uEta=1,5", "FRESNEL=exact",
    // "rotate_x=30,scale=1.2".
    values: string[];
    ranges: string[];
    rungs: string[];
    view: string;
    canUndo: boolean;
    canRedo: boolean;
}

export interface Opened {
    // False: it has errors, and what was shown before is shown still.
    ok: boolean;
    problems: Problem[];
    shown?: Shown;
    milliseconds: number;
}

export interface Frame {
    time: number;
    width: number;
    height: number;
    // From the left, 0 to 1: left of it the chosen rungs, right of it the references. Undefined: no split.
    split?: number;
    // In pixels of the frame, from the bottom left.
    mouse?: [number, number];
}

export interface Saved {
    files: { name: string; bytes: Uint8Array<ArrayBuffer> }[];
    // Values that have no place in the text, and why.
    unwritten: string[];
    error: string;
}

// The program has ended, as for want of memory: only restart() may be called.
export class Crash extends Error {}

// Calls `crashed` when the program ends.
export function guarded<Guarded extends Engine>(engine: Guarded, crashed: (why: string) => void): Guarded {
    return new Proxy(engine, {
        get(target, name) {
            const value = Reflect.get(target, name) as unknown;
            if (typeof value !== 'function') return value;
            return (...values: unknown[]) => {
                try {
                    return value.apply(target, values) as unknown;
                } catch (error) {
                    if (!(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) throw error;
                    crashed(error.message);
                    throw new Crash(error.message);
                }
            };
        },
    });
}

export interface Engine {
    // Begins again, without files and graphics.
    restart(): Promise<void>;
    // Makes a context on the canvas. "" or why there is none.
    start(canvas: HTMLCanvasElement): Promise<string>;
    // The driver's name and limits, for people.
    driver(): Record<string, string | number>;

    // Files in memory; names are relative, with '/'.
    write(name: string, bytes: Uint8Array): void;
    remove(name: string): void;

    // `settings`: values, rungs, ranges and view by name take effect before the first picture; what does not fit is a problem.
    // Values that were set by hand before are kept where the scene still has them, unless `fresh`.
    open(scene: string, settings?: { values?: string[]; rungs?: string[]; ranges?: string[]; view?: string; fresh?: boolean; lints?: boolean }): Opened;
    // What is said without graphics, with lints.
    check(scene: string): Problem[];

    // Values outside of the range widen it if `widens`, and else are moved into it.
    set(index: number, component: number, value: number, widens?: boolean): void;
    // To a fraction of the track; `fine`: with more digits.
    slide(index: number, component: number, fraction: number, fine?: boolean): void;
    // By hundredths of the range, whole numbers by one.
    step(index: number, component: number, steps: number): void;
    // To the byte of a picker of colours.
    pick(index: number, component: number, byte: number): void;
    reset(index: number, component?: number): void;
    scale(index: number, logarithmic: boolean): void;
    // Begins or changes the motion of a slider at this time of the scene, in seconds; 0: it ends.
    animate(index: number, component: number, period: number, time: number): void;
    advance(time: number): void;
    // The number that a text means for a control, or for none; NaN if it is none, infinity if it does not fit.
    typed(text: string, index?: number): number;
    // What was changed since the last call is a step of undo.
    follow(): void;
    // Goes a step back, or `forward` again; `opened` if the rungs are others.
    go(forward: boolean): { said: string; opened?: Opened };
    state(): State;
    // Compiles what the rung needs; the controls may be others afterwards.
    choose(ladder: number, rung: number): Opened;

    // "" or the error.
    setView(view: string): string;
    // The pointer's movement in CSS pixels, by the window's own rules.
    // `begins`: this is another drag than before; one that begins with the scene upside down turns the other way.
    turn(dx: number, dy: number, begins?: boolean): void;
    // `toward` the viewer.
    move(dx: number, dy: number, width: number, height: number, toward?: number): void;
    zoom(factor: number): void;

    // What the picture was found to cost is told once. One that is `dragged` may be coarser than the frame.
    draw(frame: Frame, dragged?: boolean, small?: boolean): Problem[];
    // The graphics took so long for it. In how many milliseconds a sharp picture is due; infinity if it was sharp.
    drew(milliseconds: number): number;
    // Compiles one more program for the values as they are. False: nothing is left to do.
    settle(frame: Frame): boolean;
    // About how many milliseconds the picture takes, found by small ones, as far as it may be more than `enough`.
    // Negative: a smaller one would take as long.
    foresee(frame: Frame, enough: number): number;
    // RGBA bytes, the top row first, of any size that fits into the limits; a message otherwise.
    picture(frame: Frame, samples: number): Uint8ClampedArray | string;

    // A small picture of another scene, as it is written; a message if there is none.
    preview(scene: string, width: number, height: number): Uint8ClampedArray | string;

    // The files with the values as they are now, edited where the values stand; an error otherwise.
    saved(): Saved;

    // After the browser took the context and gave it back.
    restored(): Opened;
}
