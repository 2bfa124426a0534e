// The engine by WebAssembly, from the bytes of snell.wasm. Tests put fake_engine.ts in the place of this file.
import make from 'snell-engine';
import type { Engine } from './engine.ts';
import { WasmEngine } from './wasm.ts';
import type { WorkerEngine } from './worker.ts';

export function loadEngine(runtime: Uint8Array): Promise<Engine & WorkerEngine> {
    return WasmEngine.load(make, runtime);
}
