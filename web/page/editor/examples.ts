// The scenes that the page has with it (examples.mjs).
import blankScene from '../../../templates/blank/blank.glib';
import blankFragment from '../../../templates/blank/ball.frag';
import blankVertex from '../../../templates/blank/ball.vert';
import { unpack } from '../archive.ts';

export interface Example {
    scene: string;
    subject: string;
    files: string[];
    // A place to start from, as `snell new` has it.
    template: boolean;
    // The name of a small picture among the files of the page.
    picture?: string;
}

export interface Examples {
    list: Example[];
    // The files of one example, and nothing else.
    open(example: Example): Map<string, Uint8Array>;
    // Its address; '' if there is none.
    picture(example: Example): string;
}

// Undefined: the page has none.
export async function readExamples(): Promise<Examples | undefined> {
    const block = document.getElementById('examples');
    if (!block?.textContent?.trim()) return undefined;
    const { files } = await unpack(block.textContent);
    const list = JSON.parse(new TextDecoder().decode(files.get('examples.json'))) as Example[];
    // Copies, because all files share the memory of the archive.
    const open = (example: Example) =>
        new Map(example.files.flatMap((name) => {
            const bytes = files.get(name);
            return bytes ? [[name, bytes.slice()] as const] : [];
        }));
    const picture = (example: Example) => {
        const bytes = files.get(example.picture ?? '');
        return bytes ? URL.createObjectURL(new Blob([bytes.slice()])) : '';
    };
    return { list, open, picture };
}

export function newScene(): { scene: string; files: Map<string, Uint8Array> } {
    const files = { 'scene.glib': blankScene, 'ball.vert': blankVertex, 'ball.frag': blankFragment };
    const bytes = Object.entries(files).map(([name, text]) => [name, new TextEncoder().encode(text)] as const);
    return { scene: 'scene.glib', files: new Map(bytes) };
}
