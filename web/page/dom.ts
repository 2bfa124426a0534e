// Elements. Text is always set as text, because scenes come from anywhere.

type Attributes = Record<string, string | number | boolean | undefined>;

export function el<Tag extends keyof HTMLElementTagNameMap>(
    tag: Tag,
    attributes: Attributes = {},
    ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (value === undefined || value === false) continue;
        if (name === 'class') element.className = String(value);
        else element.setAttribute(name, value === true ? '' : String(value));
    }
    element.append(...children);
    return element;
}

export function button(text: string, click: () => void, attributes: Attributes = {}): HTMLButtonElement {
    const element = el('button', { type: 'button', ...attributes }, text);
    element.addEventListener('click', click);
    return element;
}

// Lets the browser show what was changed before the next piece of work.
export function painted(): Promise<void> {
    return new Promise((resolve) => {
        // A hidden page has no frames.
        const timer = setTimeout(resolve, 100);
        requestAnimationFrame(() => {
            clearTimeout(timer);
            setTimeout(resolve);
        });
    });
}

// True for fields that use keys for themselves.
export function takesText(target: EventTarget | null): boolean {
    if (!(target instanceof HTMLElement)) return false;
    if (target.isContentEditable || target instanceof HTMLTextAreaElement || target.shadowRoot) return true;
    return target instanceof HTMLInputElement && /^(text|number|search)$/.test(target.type);
}

// What the browser keeps for small things, if it does.
export function stored<T>(use: (store: Storage) => T): T | undefined {
    try {
        return use(localStorage);
    } catch {
        return undefined;
    }
}

export function canvasOf(pixels: Uint8ClampedArray, width: number, height: number): HTMLCanvasElement {
    const canvas = el('canvas', { width, height });
    canvas.getContext('2d')?.putImageData(new ImageData(new Uint8ClampedArray(pixels), width, height), 0, 0);
    return canvas;
}

export function download(name: string, blob: Blob): void {
    const url = URL.createObjectURL(blob);
    const link = el('a', { href: url, download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
