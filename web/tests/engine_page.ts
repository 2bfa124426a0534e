// What the tests of the engine run in a page: the engine, and a way to see its pictures.
import type { Frame, Opened } from '../page/engine.ts';
import { Session } from '../page/viewer/session.ts';
import { WasmEngine, type MakeProgram } from '../page/wasm.ts';

export type Files = Record<string, string>; // base64

const bytes = (base64: string) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

export class EnginePage {
    private constructor(
        readonly engine: WasmEngine,
        readonly canvas: HTMLCanvasElement,
        readonly heap: () => number,
    ) {}

    static async start(make: MakeProgram, wasm: string): Promise<EnginePage> {
        const canvas = document.createElement('canvas');
        document.body.append(canvas);
        let heap = () => 0;
        const watched: MakeProgram = async (options) => {
            const program = await make(options);
            heap = () => program.HEAPU8.length;
            return program;
        };
        const engine = await WasmEngine.load(watched, await WebAssembly.compile(bytes(wasm)));
        const error = await engine.start(canvas);
        if (error) throw new Error(error);
        return new EnginePage(engine, canvas, () => heap());
    }

    write(files: Files): void {
        for (const [name, base64] of Object.entries(files)) this.engine.write(name, bytes(base64));
    }

    edit(name: string, text: string): void {
        this.engine.write(name, new TextEncoder().encode(text));
    }

    open(files: Files, scene: string): Opened {
        this.write(files);
        return this.engine.open(scene, { lints: false });
    }

    // The page's own session over a small scene, and what it says.
    session(): { session: Session; said: string[] } {
        this.edit('v.vert', 'void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }');
        this.edit('f.frag', 'uniform float uA, uMix; uniform vec3 uTint; uniform int uCount; void main() { gl_FragColor = vec4(uTint * uA + uMix + float(uCount), 1.); }');
        const line = 'Program P uA <1. 2. 10.> uMix <0. 0. 1.> uCount <1 8 32> uTint {1. .82 .1}';
        this.edit('s.glib', `Vertex v.vert\nFragment f.frag\n${line}\nSphere 1 20 20\n`);
        const said: string[] = [];
        const nothing = () => {};
        const on = { redraw: nothing, changed: nothing, listed: nothing, moved: nothing, problems: nothing };
        const session = new Session(this.engine, { ...on, say: (message) => void said.push(message) });
        session.accept(this.engine.open('s.glib', { fresh: true }));
        return { session, said };
    }

    // The bytes of a picture, as an array that crosses to the test.
    picture(frame: Frame, samples = 1): number[] {
        const picture = this.engine.picture(frame, samples);
        if (typeof picture === 'string') throw new Error(picture);
        return Array.from(picture);
    }

    // What the canvas shows, in the same order.
    shown(frame: Frame, dragged = false): number[] {
        this.engine.draw(frame, dragged);
        const copy = document.createElement('canvas');
        copy.width = frame.width;
        copy.height = frame.height;
        const context = copy.getContext('2d')!;
        context.drawImage(this.canvas, 0, 0);
        return Array.from(context.getImageData(0, 0, frame.width, frame.height).data);
    }

    error(): number {
        return this.canvas.getContext('webgl2')!.getError();
    }

    async loseAndRestore(): Promise<Opened> {
        const extension = this.canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
        const event = (name: string) =>
            new Promise((heard) => this.canvas.addEventListener(name, (e) => (e.preventDefault(), heard(e)), { once: true }));
        const lost = event('webglcontextlost');
        const restored = event('webglcontextrestored');
        extension.loseContext();
        await lost;
        this.engine.draw({ time: 0, width: 100, height: 100 }); // does nothing
        setTimeout(() => extension.restoreContext(), 0);
        await restored;
        return this.engine.restored();
    }

    static async pixels(png: string): Promise<number[]> {
        const blob = new Blob([bytes(png)], { type: 'image/png' });
        const image = await createImageBitmap(blob, { colorSpaceConversion: 'none' });
        const canvas = document.createElement('canvas');
        canvas.width = image.width;
        canvas.height = image.height;
        const context = canvas.getContext('2d')!;
        context.drawImage(image, 0, 0);
        return Array.from(context.getImageData(0, 0, image.width, image.height).data);
    }
}
