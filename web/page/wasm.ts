// The engine by WebAssembly: the functions of web/interface/interface.cpp behind the page's own interface.

import type { Engine, Frame, Opened, Problem, Saved, State } from './engine.ts';

// What Emscripten gives (build/web/engine/snell.js).
interface Files {
    mkdirTree(path: string): void;
    chdir(path: string): void;
    writeFile(path: string, bytes: Uint8Array): void;
    readFile(path: string): Uint8Array;
    analyzePath(path: string): { exists: boolean };
    unlink(path: string): void;
    readdir(path: string): string[];
    rmdir(path: string): void;
    utime(path: string, accessed: number, modified: number): void;
}

type Pointer = number;
type Moment = [time: number, width: number, height: number, split: number, mouseX: number, mouseY: number];

interface Program {
    FS: Files;
    HEAPU8: Uint8Array;
    specialHTMLTargets: Record<string, unknown>;
    UTF8ToString(text: Pointer): string;
    stringToUTF8(text: string, to: Pointer, most: number): void;
    lengthBytesUTF8(text: string): number;
    _malloc(bytes: number): Pointer;
    _free(at: Pointer): void;
    _snell_new(): Pointer;
    _snell_start(engine: Pointer, canvas: Pointer): Pointer;
    _snell_driver(engine: Pointer): Pointer;
    _snell_open(engine: Pointer, scene: Pointer, settings: Pointer): Pointer;
    _snell_check(engine: Pointer, scene: Pointer): Pointer;
    _snell_set(engine: Pointer, index: number, component: number, value: number, widens: number): void;
    _snell_slide(engine: Pointer, index: number, component: number, fraction: number, fine: number): void;
    _snell_step(engine: Pointer, index: number, component: number, steps: number): void;
    _snell_pick(engine: Pointer, index: number, component: number, byte: number): void;
    _snell_reset(engine: Pointer, index: number, component: number): void;
    _snell_scale(engine: Pointer, index: number, logarithmic: number): void;
    _snell_animate(engine: Pointer, index: number, component: number, period: number, time: number): void;
    _snell_advance(engine: Pointer, time: number): void;
    _snell_typed(engine: Pointer, index: number, text: Pointer): number;
    _snell_follow(engine: Pointer): void;
    _snell_go(engine: Pointer, forward: number): Pointer;
    _snell_choose(engine: Pointer, ladder: number, rung: number): Pointer;
    _snell_state(engine: Pointer): Pointer;
    _snell_set_view(engine: Pointer, text: Pointer): Pointer;
    _snell_turn(engine: Pointer, dx: number, dy: number, begins: number): void;
    _snell_move(engine: Pointer, dx: number, dy: number, width: number, height: number, toward: number): void;
    _snell_zoom(engine: Pointer, factor: number): void;
    _snell_draw(engine: Pointer, ...moment: [...Moment, number, number]): Pointer;
    _snell_drew(engine: Pointer, milliseconds: number): number;
    _snell_settle(engine: Pointer, ...moment: Moment): number;
    _snell_foresee(engine: Pointer, ...moment: [...Moment, number]): number;
    _snell_picture(engine: Pointer, ...moment: [...Moment, number]): Pointer;
    _snell_preview(engine: Pointer, scene: Pointer, width: number, height: number): Pointer;
    _snell_decode(engine: Pointer, name: Pointer, bytes: Pointer, size: number): Pointer;
    _snell_bytes(engine: Pointer): Pointer;
    _snell_byte_count(engine: Pointer): number;
    _snell_free_bytes(engine: Pointer): void;
    _snell_saved(engine: Pointer): Pointer;
    _snell_restored(engine: Pointer): Pointer;
}

type Instantiate = (imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void) => object;

export type MakeProgram = (options: { instantiateWasm: Instantiate }) => Promise<Program>;

// The folder that names of files are relative to, away from the folders that every system has.
const folder = '/files';
const canvasName = '!snell';

function moment(frame: Frame): Moment {
    const [x, y] = frame.mouse ?? [0, 0];
    return [frame.time, frame.width, frame.height, frame.split ?? 1, x, y];
}

function sameBytes(a: Uint8Array, b: Uint8Array): boolean {
    return a.length === b.length && a.every((byte, i) => byte === b[i]);
}

export class WasmEngine implements Engine {
    private program!: Program;
    private engine: Pointer = 0;
    private writes = 0;

    private constructor(
        private readonly make: MakeProgram,
        private readonly runtime: WebAssembly.Module,
    ) {}

    // `make` is the default export of snell.js, `runtime` is snell.wasm: compiled once for the page and its worker.
    static async load(make: MakeProgram, runtime: WebAssembly.Module): Promise<WasmEngine> {
        const engine = new WasmEngine(make, runtime);
        await engine.restart();
        return engine;
    }

    async restart(): Promise<void> {
        const { make, runtime } = this;
        this.program = await new Promise<Program>((resolve, reject) => {
            const instantiateWasm: Instantiate = (imports, done) => {
                WebAssembly.instantiate(runtime, imports).then((instance) => done(instance, runtime), reject);
                return {};
            };
            make({ instantiateWasm }).then(resolve, reject);
        });
        this.engine = this.program._snell_new();
        this.program.FS.mkdirTree(folder);
        this.program.FS.chdir(folder);
    }

    // Pictures are drawn and multisampled in a framebuffer of the program's own, and then copied to the canvas.
    static context(canvas: HTMLCanvasElement): WebGL2RenderingContext | null {
        return canvas.getContext('webgl2', { alpha: false, depth: false, antialias: false });
    }

    async start(canvas: HTMLCanvasElement): Promise<string> {
        WasmEngine.context(canvas);
        this.program.specialHTMLTargets[canvasName] = canvas;
        return this.call((name) => this.program._snell_start(this.engine, name), canvasName);
    }

    driver(): Record<string, string | number> {
        return this.json(this.program._snell_driver(this.engine));
    }

    // An unchanged file keeps its time, so that nothing made of it is made again. Times have whole seconds, so each
    // write is a second after the one before.
    write(name: string, bytes: Uint8Array): void {
        const files = this.program.FS;
        if (files.analyzePath(name).exists && sameBytes(files.readFile(name), bytes)) return;
        const slash = name.lastIndexOf('/');
        if (slash > 0) files.mkdirTree(`${folder}/${name.slice(0, slash)}`); // it takes every name as from the root
        files.writeFile(name, bytes);
        const time = 1000 * ++this.writes;
        files.utime(name, time, time);
    }

    // Folders that are empty then go, too: a later file may have the name of one.
    remove(name: string): void {
        const files = this.program.FS;
        if (!files.analyzePath(name).exists) return;
        files.unlink(name);
        for (let at = name.lastIndexOf('/'); at > 0; at = name.lastIndexOf('/', at - 1)) {
            const parent = name.slice(0, at);
            if (files.readdir(parent).some((each) => each !== '.' && each !== '..')) return;
            files.rmdir(parent);
        }
    }

    open(scene: string, settings: Parameters<Engine['open']>[1] = {}): Opened {
        return this.asked(
            (name, json) => this.program._snell_open(this.engine, name, json),
            scene,
            JSON.stringify(settings),
        );
    }

    check(scene: string): Problem[] {
        return this.asked((name) => this.program._snell_check(this.engine, name), scene);
    }

    set(index: number, component: number, value: number, widens = false): void {
        this.program._snell_set(this.engine, index, component, value, Number(widens));
    }

    slide(index: number, component: number, fraction: number, fine = false): void {
        this.program._snell_slide(this.engine, index, component, fraction, Number(fine));
    }

    step(index: number, component: number, steps: number): void {
        this.program._snell_step(this.engine, index, component, steps);
    }

    pick(index: number, component: number, byte: number): void {
        this.program._snell_pick(this.engine, index, component, byte);
    }

    reset(index: number, component = -1): void {
        this.program._snell_reset(this.engine, index, component);
    }

    scale(index: number, logarithmic: boolean): void {
        this.program._snell_scale(this.engine, index, Number(logarithmic));
    }

    animate(index: number, component: number, period: number, time: number): void {
        this.program._snell_animate(this.engine, index, component, period, time);
    }

    advance(time: number): void {
        this.program._snell_advance(this.engine, time);
    }

    typed(text: string, index = -1): number {
        return this.passed((at) => this.program._snell_typed(this.engine, index, at), text);
    }

    follow(): void {
        this.program._snell_follow(this.engine);
    }

    go(forward: boolean): { said: string; opened?: Opened } {
        return this.json(this.program._snell_go(this.engine, Number(forward)));
    }

    state(): State {
        return this.json(this.program._snell_state(this.engine));
    }

    choose(ladder: number, rung: number): Opened {
        return this.json(this.program._snell_choose(this.engine, ladder, rung));
    }

    setView(view: string): string {
        return this.call((text) => this.program._snell_set_view(this.engine, text), view);
    }

    turn(dx: number, dy: number, begins = false): void {
        this.program._snell_turn(this.engine, dx, dy, Number(begins));
    }

    move(dx: number, dy: number, width: number, height: number, toward = 0): void {
        this.program._snell_move(this.engine, dx, dy, width, height, toward);
    }

    zoom(factor: number): void {
        this.program._snell_zoom(this.engine, factor);
    }

    draw(frame: Frame, dragged = false, small = false): Problem[] {
        const costs = this.program.UTF8ToString(this.program._snell_draw(this.engine, ...moment(frame), Number(dragged), Number(small)));
        return costs ? (JSON.parse(costs) as Problem[]) : [];
    }

    drew(milliseconds: number): number {
        return this.program._snell_drew(this.engine, milliseconds);
    }

    settle(frame: Frame): boolean {
        return this.program._snell_settle(this.engine, ...moment(frame)) !== 0;
    }

    foresee(frame: Frame, enough: number): number {
        return this.program._snell_foresee(this.engine, ...moment(frame), enough);
    }

    picture(frame: Frame, samples: number): Uint8ClampedArray | string {
        const error = this.program.UTF8ToString(this.program._snell_picture(this.engine, ...moment(frame), samples));
        return error || new Uint8ClampedArray(this.takenBytes().buffer);
    }

    preview(scene: string, width: number, height: number): Uint8ClampedArray | string {
        const error = this.call((path) => this.program._snell_preview(this.engine, path, width, height), scene);
        return error || new Uint8ClampedArray(this.takenBytes().buffer);
    }

    saved(): Saved {
        type Texts = { files: { name: string; bytes: string }[]; unwritten: string[]; error: string };
        const { files, ...rest } = this.json<Texts>(this.program._snell_saved(this.engine));
        const bytes = (text: string) => Uint8Array.from(text, (character) => character.charCodeAt(0));
        return { files: files.map((file) => ({ name: file.name, bytes: bytes(file.bytes) })), ...rest };
    }

    restored(): Opened {
        return this.json(this.program._snell_restored(this.engine));
    }

    // Decodes an image file for another thread's engine: the result is written there in place of the file. A string is
    // the error.
    decode(name: string, bytes: Uint8Array): Uint8Array | string {
        const { program } = this;
        const at = program._malloc(bytes.length);
        program.HEAPU8.set(bytes, at);
        const error = this.call((text) => program._snell_decode(this.engine, text, at, bytes.length), name);
        program._free(at);
        return error || this.takenBytes();
    }

    // Copies the bytes of the last picture out of the program, and frees them there.
    private takenBytes(): Uint8Array<ArrayBuffer> {
        const { program, engine } = this;
        const at = program._snell_bytes(engine);
        const bytes = program.HEAPU8.slice(at, at + program._snell_byte_count(engine));
        program._snell_free_bytes(engine);
        return bytes as Uint8Array<ArrayBuffer>;
    }

    private json<T>(text: Pointer): T {
        return JSON.parse(this.program.UTF8ToString(text)) as T;
    }

    private asked<T>(ask: (...texts: Pointer[]) => Pointer, ...texts: string[]): T {
        return JSON.parse(this.call(ask, ...texts)) as T;
    }

    // Passes texts, and returns the one that comes back.
    private call(ask: (...texts: Pointer[]) => Pointer, ...texts: string[]): string {
        return this.program.UTF8ToString(this.passed(ask, ...texts));
    }

    // Passes texts, and returns the number that comes back.
    private passed(ask: (...texts: Pointer[]) => number, ...texts: string[]): number {
        const { program } = this;
        const passed = texts.map((text) => {
            const bytes = program.lengthBytesUTF8(text) + 1;
            const at = program._malloc(bytes);
            program.stringToUTF8(text, at, bytes);
            return at;
        });
        const answer = ask(...(passed as [Pointer, Pointer]));
        passed.forEach((at) => program._free(at));
        return answer;
    }
}
