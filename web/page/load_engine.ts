// The engine by WebAssembly, from snell.wasm.
import make from 'snell-engine';
import type { Engine } from './engine.ts';
import { WasmEngine } from './wasm.ts';
import type { WorkerEngine } from './worker.ts';

export function loadEngine(runtime: WebAssembly.Module): Promise<Engine & WorkerEngine> {
    return WasmEngine.load(make, runtime);
}

// The browser needs as long for the context as for the program, and can prepare both at the same time.
export function prepareCanvas(canvas: HTMLCanvasElement): void {
    WasmEngine.context(canvas);
}
