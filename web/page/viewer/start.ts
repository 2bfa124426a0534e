// Loads what the page has with it, and shows it.
import make from 'snell-engine';
import { makeChecker, pageWorker, type WorkerChecker } from '../editor/checker.ts';
import { Crash, guarded, type Engine } from '../engine.ts';
import { Page } from './app.ts';
import { el } from '../dom.ts';
import { readArchive, readRuntime, readScene } from './load.ts';
import { WasmEngine } from '../wasm.ts';

function showsWebGl(): boolean {
    return el('canvas', {}).getContext('webgl2') !== null;
}

export const noWebGl =
    'This browser does not offer WebGL 2, which draws the picture. Update the browser, or allow it hardware acceleration in its settings.';

interface Program {
    engine: Engine;
    checker: WorkerChecker;
}

// The served form of the page is kept for times without a network.
function stay(): void {
    if (document.querySelector('link[rel=manifest]')) void navigator.serviceWorker?.register('service.js').catch(() => undefined);
}

// The server, or what is around the page, may forbid more than the page itself does.
let forbidden = '';

function hearPolicies(): void {
    document.addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI, originalPolicy }) => {
        forbidden ||= ` The policy of this page's server forbids it (${effectiveDirective}, ${blockedURI}): '${originalPolicy}'.`;
    });
}

async function loadProgram(page: Page, source: string): Promise<Program> {
    const runtime = await readRuntime();
    const engine = guarded(await WasmEngine.load(make, runtime), (why) => page.crashed(why));
    return { engine, checker: makeChecker({ spawn: pageWorker(source, runtime), say: (message) => page.say(message) }) };
}

async function load(page: Page, source: string): Promise<void> {
    const data = readScene();
    page.progress('Unpacking…');
    const program = loadProgram(page, source);
    // The browser needs as long for the context as for the program, and can prepare both at the same time.
    const [unpacked, { engine, checker }] = await Promise.all([readArchive().finally(() => void WasmEngine.context(page.canvas)), program]);
    page.progress('Starting…');
    const error = await engine.start(page.canvas);
    if (error !== '') return page.fail(showsWebGl() ? `There is no picture: ${error}` : noWebGl);
    await page.begin({ engine, checker, data, unpacked });
}

export async function start(source: string): Promise<void> {
    const page = new Page();
    // The data blocks stay: the editor's examples are read later.
    document.querySelector('main')!.replaceWith(page.element);
    hearPolicies();
    stay();
    try {
        await load(page, source);
    } catch (error) {
        if (error instanceof Crash) return; // the page has said so
        await new Promise((resolve) => setTimeout(resolve)); // the event about the policy comes later
        page.fail(`This page cannot be shown: ${error instanceof Error ? error.message : String(error)}${forbidden}`);
    }
}
