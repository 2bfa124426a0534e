// Loads what the page has with it, and shows it.
import { bakedEngine } from '../baked.ts';
import { makeChecker, pageWorker, type WorkerChecker } from '../editor/checker.ts';
import type { Engine } from '../engine.ts';
import { loadEngine } from '../load_engine.ts';
import { Page } from './app.ts';
import { el } from './dom.ts';
import { readArchive, readRuntime, readScene } from './load.ts';

// Lets the browser show the progress before the next piece of work.
function painted(): Promise<void> {
    return new Promise((resolve) => {
        const timer = setTimeout(resolve, 100);
        requestAnimationFrame(() => {
            clearTimeout(timer);
            setTimeout(resolve);
        });
    });
}

function showsWebGl(): boolean {
    return el('canvas', {}).getContext('webgl2') !== null;
}

export const noWebGl =
    'This browser does not offer WebGL 2, which draws the picture. Update the browser, or allow it hardware acceleration in its settings.';

async function load(page: Page, source: string): Promise<void> {
    const data = readScene();
    page.progress('Unpacking…');
    const [unpacked, runtime] = await Promise.all([readArchive(), data?.baked ? new Uint8Array() : readRuntime()]);
    page.progress('Starting…');
    await painted();
    let engine: Engine;
    let checker: WorkerChecker | undefined;
    if (data?.baked) {
        engine = bakedEngine({ scene: data.scene, title: data.title, baked: data.baked }, unpacked.files);
    } else {
        engine = await loadEngine(runtime);
        checker = makeChecker({ spawn: pageWorker(source, runtime), say: (message) => page.say(message) });
    }
    const error = await engine.start(page.canvas);
    if (error !== '') return page.fail(data?.baked || showsWebGl() ? `There is no picture: ${error}` : noWebGl);
    await page.begin({ engine, checker, data, unpacked });
}

export async function start(source: string): Promise<void> {
    const page = new Page();
    // The data blocks stay: the editor's examples are read later.
    document.querySelector('main')!.replaceWith(page.element);
    try {
        await load(page, source);
    } catch (error) {
        page.fail(`This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`);
    }
}
