// The bundle's beginning: the page, or the worker that the page starts from the same text.
import make from 'snell-engine';
import { start } from './viewer/start.ts';
import { WasmEngine } from './wasm.ts';
import { serve, type Scope } from './worker.ts';

// The function around the whole bundle (build.mjs).
declare const snellPage: () => void;

if (typeof document === 'undefined') serve(globalThis as unknown as Scope, (runtime) => WasmEngine.load(make, runtime));
else void start(`(${snellPage.toString()})();`);
