// The dialogs: a picture as PNG, and the help.
import type { Engine, Frame } from '../engine.ts';
import { makeDialog, showFromTop } from '../dialog.ts';
import { button, canvasOf, download, el } from '../dom.ts';

export const limits = { side: 8192, pixels: 32_000_000, samples: 64 };

// What is wrong with a size, or "".
export function sizeProblem(width: number, height: number, samples: number): string {
    const whole = (value: number, most: number) => Number.isInteger(value) && value >= 1 && value <= most;
    if (!whole(width, limits.side) || !whole(height, limits.side)) return `Width and height are whole numbers of 1 to ${limits.side} pixels.`;
    if (width * height > limits.pixels) return `A picture has at most ${limits.pixels / 1e6} million pixels.`;
    if (!whole(samples, limits.samples)) return `Samples are a whole number of 1 to ${limits.samples}.`;
    return '';
}

async function save(pixels: Uint8ClampedArray, width: number, height: number, name: string): Promise<string> {
    const canvas = canvasOf(pixels, width, height);
    const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
    if (!blob) return 'The browser cannot write a picture of this size.';
    download(name, blob);
    return '';
}

export interface PictureOptions {
    engine: Engine;
    frame(): Frame;
    name(): string;
    say(message: string): void;
}

export function makePictureDialog({ engine, frame, name, say }: PictureOptions): { element: HTMLDialogElement; open(): void } {
    const field = (label: string) => {
        const input = el('input', { type: 'text', inputmode: 'numeric', class: 'number' });
        return { input, row: el('label', { class: 'field' }, label, input) };
    };
    const [width, height, samples] = [field('Width, pixels'), field('Height, pixels'), field('Samples per pixel')];
    samples.input.value = '16';
    const message = el('p', { class: 'error', role: 'alert' });
    const take = async () => {
        const [w, h, s] = [width, height, samples].map(({ input }) => engine.typed(input.value)) as [number, number, number];
        message.textContent = sizeProblem(w, h, s);
        if (message.textContent !== '') return;
        message.textContent = 'Drawing…';
        await new Promise((resolve) => setTimeout(resolve, 30));
        const now = frame();
        const scaled: [number, number] | undefined = now.mouse && [(now.mouse[0] * w) / now.width, (now.mouse[1] * h) / now.height];
        const pixels = engine.picture({ ...now, width: w, height: h, mouse: scaled }, s);
        const error = typeof pixels === 'string' ? pixels : await save(pixels, w, h, `${name()}.png`);
        message.textContent = error;
        if (error !== '') return;
        element.close();
        say(`Saved ${name()}.png, ${w} × ${h} pixels.`);
    };
    const note = `At most ${limits.side} pixels wide and high, ${limits.pixels / 1e6} million pixels together, and ${limits.samples} samples per pixel.`;
    const form = el('form', { method: 'dialog' }, width.row, height.row, samples.row, el('p', { class: 'quiet' }, note), message);
    form.append(el('div', { class: 'buttons' }, el('button', { type: 'submit', class: 'main' }, 'Save PNG'), button('Cancel', () => element.close())));
    const element = makeDialog('Picture as PNG', form);
    form.addEventListener('submit', (event) => {
        event.preventDefault();
        void take();
    });
    const open = () => {
        const now = frame();
        width.input.value = String(now.width);
        height.input.value = String(now.height);
        message.textContent = '';
        element.showModal();
        width.input.select();
    };
    return { element, open };
}

const keys: [string, string][] = [
    ['drag; one finger', 'turn the scene'],
    ['right drag, Shift drag; two fingers', 'move it'],
    ['wheel, middle drag, Ctrl drag; pinch', 'scale it'],
    ['Shift wheel, Ctrl Shift drag', 'move it towards the viewer'],
    ['double click, R or Home', 'reset the view'],
    ['arrow keys on the picture; with Shift; + and -', 'turn; move; scale'],
    ['space bar', 'pause or resume time'],
    ['F', 'full screen'],
    ['Ctrl Z; Ctrl Y or Ctrl Shift Z', 'undo; redo'],
    ['arrow keys on a slider; with Shift; Page keys', 'change it in steps; fine; coarse'],
    ['Enter or double click on a slider', 'type its number'],
    ['Enter or Tab in a number; Esc', 'apply it; restore the old one'],
    ['right click on a slider; the dot at its left', "reset it to the scene's value"],
    ['Alt or Shift drag of a slider', 'fine adjustment'],
    ["a slider's name", 'reset, logarithmic scale, animation'],
    ['?', 'show this list'],
];

export function makeHelp(): { element: HTMLDialogElement; open(): void } {
    const rows = keys.map(([key, what]) => el('tr', {}, el('th', { scope: 'row' }, key), el('td', {}, what)));
    const about = [
        'Numbers take arithmetic and a decimal comma, such as 1/3, 2*pi or 0,7. A number outside of the range widens the range if you press Enter.',
        'Values, rungs, view and time are in the address of the page: Copy link gives a link to what you see.',
        'Text shows the files of the scene. The picture follows each edit; while there is an error, the last good picture stays.',
        'Nothing leaves this device: the page works without a network.',
    ];
    const close = button('Close', () => element.close());
    const element = makeDialog('Help', ...about.map((text) => el('p', {}, text)), el('table', {}, el('tbody', {}, ...rows)), close);
    return { element, open: () => showFromTop(element) };
}
