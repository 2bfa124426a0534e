// The bundle's beginning: the page, or the worker that the page starts from the same text.
import { loadEngine } from './load_engine.ts';
import { start } from './viewer/start.ts';
import { serve, type Scope } from './worker.ts';

// The function around the whole bundle (build.mjs).
declare const snellPage: () => void;

if (typeof document === 'undefined') serve(globalThis as unknown as Scope, loadEngine);
else void start(`(${snellPage.toString()})();`);
