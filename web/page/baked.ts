// The Engine by ready pictures: one for each combination of the values of one or two sliders.
import type { Control, Engine, Frame, Opened, Problem, Saved, Shown } from './engine.ts';
import { typed, whyNot } from './viewer/numbers.ts';

interface Axis {
    control: Control;
    // Rising.
    values: number[];
}

// The member `baked` of the page's data block, as src/app/page/baked.cpp writes it.
export interface Baked {
    width: number;
    height: number;
    axes: Axis[];
    // Names of files; the last axis varies fastest.
    pictures: string[];
}

export interface BakedScene {
    scene: string;
    title: string;
    baked: Baked;
}

// The index of the value that is nearest; of two as near ones the smaller.
export function nearest(values: readonly number[], value: number): number {
    let best = 0;
    for (let i = 1; i < values.length; ++i)
        if (Math.abs(values[i]! - value) < Math.abs(values[best]! - value)) best = i;
    return best;
}

// The index of the picture for these values of the axes.
export function pictureAt(axes: readonly Axis[], values: readonly number[]): number {
    return axes.reduce((index, axis, i) => index * axis.values.length + nearest(axis.values, values[i]!), 0);
}

// Where a picture is in a canvas: as large as fits, in the middle.
export function fitted(width: number, height: number, inWidth: number, inHeight: number): [number, number, number, number] {
    const scale = Math.min(inWidth / width, inHeight / height);
    const w = width * scale;
    const h = height * scale;
    return [(inWidth - w) / 2, (inHeight - h) / 2, w, h];
}

async function loaded(bytes: Uint8Array | undefined): Promise<HTMLImageElement> {
    if (!bytes) throw new Error('a picture is missing');
    const image = new Image();
    const url = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: 'image/png' }));
    try {
        image.src = url;
        await image.decode();
    } finally {
        URL.revokeObjectURL(url);
    }
    return image;
}

function clampTo(control: Control, value: number): number {
    const within = Math.min(control.max, Math.max(control.min, value));
    return control.type === 'float' || control.type === 'double' ? within : Math.round(within);
}

class BakedEngine implements Engine {
    private readonly baked: Baked;
    private readonly controls: Control[];
    private images: HTMLImageElement[] = [];
    private canvas: HTMLCanvasElement | undefined;

    constructor(
        private readonly scene: BakedScene,
        private readonly files: Map<string, Uint8Array>,
    ) {
        this.baked = scene.baked;
        this.controls = scene.baked.axes.map((axis) => ({
            ...axis.control,
            value: [...axis.control.value],
            initial: [...axis.control.initial],
            fixed: true,
        }));
    }

    async start(canvas: HTMLCanvasElement): Promise<string> {
        this.canvas = canvas;
        try {
            this.images = await Promise.all(this.baked.pictures.map((name) => loaded(this.files.get(name))));
        } catch {
            return 'A picture of this page is missing or damaged.';
        }
        return canvas.getContext('2d') ? '' : 'The browser gives no canvas to draw on.';
    }

    driver(): Record<string, string | number> {
        return { renderer: 'pictures that were drawn before', pictures: this.baked.pictures.length };
    }

    // The pictures stand for the files: there is nothing to edit.
    write(): void {}
    remove(): void {}

    open(_scene = this.scene.scene, settings: Parameters<Engine['open']>[1] = {}): Opened {
        const { values = [], rungs = [], view = '', fresh = false } = settings;
        if (fresh) this.reset();
        // There are no ladders: what names no program is a slider, as for `--set`.
        const wrong = [...values, ...rungs].flatMap((each) => this.assign(each));
        if (view !== '') wrong.push('the page has pictures of one view');
        const problems = wrong.map((message): Problem => ({ severity: 'error', code: 'not-baked', message, help: '', text: message }));
        return { ok: true, problems, shown: this.shown(), milliseconds: 0 };
    }

    // Takes a text such as "Glass.uEta=1.3", or "uEta=1.3" for each program. Returns why it is not taken, or not as it is.
    private assign(assignment: string): string[] {
        const equals = assignment.indexOf('=');
        const key = assignment.slice(0, equals);
        const controls = this.controls.filter((each) => each.key === key || each.name === key);
        if (controls.length === 0) return [`there is no slider '${key}'`];
        const text = assignment.slice(equals + 1);
        return controls.flatMap((control) => {
            const value = typed(text, control.type);
            if (value === undefined) return [`the value '${text}' of '${key}' is not a number${whyNot(text)}`];
            this.set(control.index, 0, value);
            const { min, max } = control;
            return value === control.value[0] ? [] : [`'${key}' cannot be ${value}: its pictures are from ${min} to ${max}`];
        });
    }

    check(): [] {
        return [];
    }

    set(index: number, component: number, value: number): void {
        const control = this.controls[index];
        if (control && component === 0 && Number.isFinite(value)) control.value = [clampTo(control, value)];
    }
    // There are no pictures outside of the range.
    range(): void {}
    reset(index?: number): void {
        for (const control of index === undefined ? this.controls : this.controls.slice(index, index + 1)) {
            const from = this.baked.axes[control.index]!.control;
            control.value = [...from.value];
        }
    }
    choose(): Opened {
        return this.open();
    }

    values(): string[] {
        return this.controls
            .filter((control) => control.value[0] !== this.baked.axes[control.index]!.control.value[0])
            .map((control) => `${control.key}=${control.value[0]}`);
    }
    rungs(): string[] {
        return [];
    }
    view(): string {
        return '';
    }
    setView(): string {
        return '';
    }
    turn(): void {}
    move(): void {}
    zoom(): void {}

    draw(frame: Frame): void {
        if (!this.canvas) return;
        const { width, height } = frame;
        if (this.canvas.width !== width || this.canvas.height !== height) {
            this.canvas.width = width;
            this.canvas.height = height;
        }
        this.paint(this.canvas, width, height);
    }
    settle(): boolean {
        return false;
    }
    async restart(): Promise<void> {}
    preview(): string {
        return 'there are no other pictures';
    }
    picture(frame: Frame): Uint8ClampedArray | string {
        const canvas = document.createElement('canvas');
        canvas.width = frame.width;
        canvas.height = frame.height;
        if (!this.paint(canvas, frame.width, frame.height)) return 'The browser gives no canvas of this size.';
        return canvas.getContext('2d')!.getImageData(0, 0, frame.width, frame.height).data;
    }

    saved(): Saved {
        return { files: [], unwritten: [], error: 'This page has pictures only, not the files of the scene.' };
    }
    restored(): Opened {
        return this.open();
    }

    private paint(canvas: HTMLCanvasElement, width: number, height: number): boolean {
        const context = canvas.getContext('2d');
        const image = this.images[pictureAt(this.baked.axes, this.controls.map((control) => control.value[0]!))];
        if (!context || !image) return false;
        context.clearRect(0, 0, width, height);
        context.drawImage(image, ...fitted(this.baked.width, this.baked.height, width, height));
        return true;
    }

    private shown(): Shown {
        return {
            title: this.scene.title,
            scene: this.scene.scene,
            controls: this.controls,
            ladders: [],
            width: this.baked.width,
            height: this.baked.height,
            animated: false,
            usesMouse: false,
            period: 0,
            files: [],
            counters: {},
        };
    }
}

export function bakedEngine(scene: BakedScene, files: Map<string, Uint8Array>): Engine {
    return new BakedEngine(scene, files);
}
