// What the page has with it: the scene's data, its files, and the runtime.
import { fromBase64, unpack, unzipped, type Unpacked } from '../archive.ts';

export interface SceneData {
    scene: string;
    title: string;
    values: string[];
    rungs: string[];
    view: string;
    // Address of the scene's text; '' if there is none.
    link: string;
}

function block(id: string): string {
    return document.getElementById(id)?.textContent ?? '';
}

function strings(value: unknown): string[] {
    return Array.isArray(value) ? value.filter((each) => typeof each === 'string') : [];
}

function text(value: unknown): string {
    return typeof value === 'string' ? value : '';
}

// A link that leads to a page, and runs nothing.
export function safeLink(link: string): string {
    return /^https?:\/\//i.test(link) ? link : '';
}

// Undefined: the page has no scene. Only the types are checked: names are checked where they are used.
export function sceneOf(json: string): SceneData | undefined {
    const data = JSON.parse(json || 'null') as Record<string, unknown> | null;
    if (!data || typeof data.scene !== 'string') return undefined;
    return {
        scene: data.scene,
        title: text(data.title),
        values: strings(data.values),
        rungs: strings(data.rungs),
        view: text(data.view),
        link: safeLink(text(data.link)),
    };
}

export function readScene(): SceneData | undefined {
    return sceneOf(block('scene'));
}

export function readArchive(): Promise<Unpacked> {
    return unpack(block('archive'));
}

// Pages of a gallery share a file, which defines this.
declare global {
    // eslint-disable-next-line no-var
    var snellRuntime: string | undefined;
}

// snell.wasm, which the browser compiles on other threads while it is unpacked.
export async function readRuntime(): Promise<WebAssembly.Module> {
    const packed = block('runtime').trim() || globalThis.snellRuntime || '';
    if (packed === '') throw new Error('its program is missing.');
    const headers = { 'Content-Type': 'application/wasm' };
    return WebAssembly.compileStreaming(new Response(unzipped(fromBase64(packed)), { headers }));
}
