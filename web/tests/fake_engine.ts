// An engine without snell: controls of every kind, drawn as coloured bars. Tests of the page run without a build of it.
import type { Control, Engine, Frame, Ladder, Opened, Problem, Saved } from '../page/engine.ts';
import type { WorkerEngine } from '../page/worker.ts';

function control(index: number, key: string, more: Partial<Control> & { initial: number[] }): Control {
    const [program, name] = key.split('.') as [string, string];
    const { min = 0, max = 1 } = more;
    const all = { widget: 'slider' as const, type: 'float' as const, components: more.initial.length, active: true, ...more };
    return { index, key, program, name, ...all, min, max, value: [...more.initial], initialMin: min, initialMax: max };
}

function makeControls(): Control[] {
    const rows: [string, Partial<Control> & { initial: number[] }][] = [
        ['Glass.uEta', { min: 1, max: 3, initial: [1.5] }],
        ['Glass.uMix', { initial: [0] }],
        ['Glass.uBounces', { type: 'int', min: 1, max: 32, initial: [8] }],
        ['Glass.uBothSides', { type: 'bool', widget: 'check_box', initial: [1] }],
        ['Glass.uTint', { widget: 'color', initial: [1, 0.82, 0.1] }],
        ['Glass.uEdge', { widget: 'color', initial: [0.2, 0.4, 0.9, 1] }],
        ['Walls.uOffset', { min: -1, max: 1, initial: [0, 0.25, -0.5] }],
        ['Walls.uAVeryLongNameThatDoesNotFitIntoTheColumnA', { initial: [0.3] }],
        ['Walls.uAVeryLongNameThatDoesNotFitIntoTheColumnB', { initial: [0.6] }],
        ['Walls.uLarge', { min: 0, max: 1e30, initial: [1e6] }],
        ['Walls.uTiny', { min: 0, max: 1e-5, initial: [5e-6] }],
        ['Walls.uSeed', { type: 'uint', min: 0, max: 9, initial: [3] }],
        ['Walls.uGloss', { min: 0, max: 100, initial: [20] }],
        ['Walls.uHeight', { initial: [0.5] }],
        ['Walls.uUnused', { initial: [0.5], active: false }],
    ];
    return rows.map(([key, more], index) => control(index, key, more));
}

export class FakeEngine implements Engine, WorkerEngine {
    controls = makeControls();
    ladders: Ladder[] = [
        { index: 0, name: 'BEND', rungs: ['none', 'single', 'bounces'], chosen: 1, marked: 1, reference: 2 },
        { index: 1, name: 'FRESNEL', rungs: ['schlick', 'exact'], chosen: 0, marked: 0, reference: 1 },
    ];
    readonly files = new Map<string, Uint8Array>();
    frames = 0;
    settled = 0;
    private turned = [0, 0, 1];
    private canvas: HTMLCanvasElement | undefined;

    async start(canvas: HTMLCanvasElement): Promise<string> {
        this.canvas = canvas;
        return canvas.getContext('2d') ? '' : 'no canvas';
    }
    driver(): Record<string, string | number> {
        return { renderer: 'none' };
    }
    write(name: string, bytes: Uint8Array): void {
        this.files.set(name, bytes);
    }
    remove(name: string): void {
        this.files.delete(name);
    }
    // A line that begins with "broken" is an error, "odd" a warning.
    check(scene: string): Problem[] {
        const lines = new TextDecoder().decode(this.files.get(scene)).split('\n');
        return lines.flatMap((text, i) => {
            const severity = text.startsWith('broken') ? 'error' : text.startsWith('odd') ? 'warning' : undefined;
            if (!severity) return [];
            const at = { file: scene, line: i + 1, column: 1, endLine: i + 1, endColumn: 4 };
            return [{ severity, code: 'fake', message: `there is no command '${text}'`, help: 'remove it', at, text: '' } as Problem];
        });
    }
    decode(): string {
        return 'no decoder';
    }
    open(scene: string, settings: Parameters<Engine['open']>[1] = {}): Opened {
        const problems = this.check(scene);
        const ok = problems.every(({ severity }) => severity !== 'error');
        if (ok && settings.fresh) {
            this.reset();
            for (const ladder of this.ladders) ladder.chosen = ladder.marked;
            this.setView(settings.view ?? '');
            for (const value of settings.values ?? []) this.assign(value);
            for (const rung of settings.rungs ?? []) this.assignRung(rung);
        }
        return { ok, problems, shown: ok ? this.shown(scene) : undefined, milliseconds: 1 };
    }
    private assign(text: string): void {
        const [key, numbers] = text.split('=') as [string, string];
        const found = this.controls.find((each) => each.key === key);
        numbers.split(',').forEach((part, i) => found && Number.isFinite(Number(part)) && this.set(found.index, i, Number(part)));
    }
    private assignRung(text: string): void {
        const [name, rung] = text.split('=') as [string, string];
        const ladder = this.ladders.find((each) => each.name === name);
        if (ladder?.rungs.includes(rung)) ladder.chosen = ladder.rungs.indexOf(rung);
    }
    private shown(scene: string): Opened['shown'] {
        const controls = this.controls.map((each) => ({ ...each, value: [...each.value], initial: [...each.initial] }));
        const ladders = this.ladders.map((each) => ({ ...each }));
        const size = { width: 400, height: 300 };
        return { title: 'fake', scene, controls, ladders, ...size, animated: true, usesMouse: false, period: 10, files: [scene], counters: {} };
    }
    set(index: number, component: number, value: number): void {
        this.controls[index]!.value[component] = value;
    }
    range(index: number, min: number, max: number): void {
        Object.assign(this.controls[index]!, { min, max });
    }
    reset(index?: number): void {
        for (const each of index === undefined ? this.controls : [this.controls[index]!])
            Object.assign(each, { value: [...each.initial], min: each.initialMin, max: each.initialMax });
    }
    choose(ladder: number, rung: number): Opened {
        this.ladders[ladder]!.chosen = rung;
        return { ok: true, problems: [], shown: this.shown('fake.glib'), milliseconds: 1 };
    }
    values(): string[] {
        const changed = this.controls.filter(({ value, initial }) => value.some((part, i) => part !== initial[i]));
        return changed.map(({ key, value }) => `${key}=${value.join(',')}`);
    }
    rungs(): string[] {
        return this.ladders.filter(({ chosen, marked }) => chosen !== marked).map(({ name, rungs, chosen }) => `${name}=${rungs[chosen]}`);
    }
    view(): string {
        const [x, y, scale] = this.turned;
        return x === 0 && y === 0 && scale === 1 ? '' : `rotate_x=${x},rotate_y=${y},scale=${scale}`;
    }
    setView(view: string): string {
        const numbers = view.match(/[\d.+-]+(?=,|$)/g)?.map(Number) ?? [];
        this.turned = numbers.length === 3 ? numbers : [0, 0, 1];
        return '';
    }
    turn(dx: number, dy: number): void {
        this.turned = [this.turned[0]! + dy / 2, this.turned[1]! + dx / 2, this.turned[2]!];
    }
    move(dx: number, dy: number): void {
        this.turn(dx, dy);
    }
    zoom(factor: number): void {
        this.turned[2] = this.turned[2]! * factor;
    }
    draw(frame: Frame): Problem[] {
        ++this.frames;
        const { canvas } = this;
        const context = canvas?.getContext('2d');
        if (!canvas || !context) return [];
        Object.assign(canvas, { width: frame.width, height: frame.height });
        const [x, y, scale] = this.turned as [number, number, number];
        context.fillStyle = `hsl(${(y + 20 * frame.time) % 360} 60% 45%)`;
        context.fillRect(0, 0, frame.width, frame.height);
        this.controls.forEach(({ value, min, max }, i) => {
            const height = ((value[0]! - min) / (max - min)) * frame.height * scale;
            context.fillStyle = `hsl(${i * 40 + x} 70% 60%)`;
            context.fillRect((i * frame.width) / 14, frame.height - height, frame.width / 14 - 2, height);
        });
        return [];
    }
    settle(): boolean {
        return ++this.settled < 2;
    }
    picture({ width, height }: Frame): Uint8ClampedArray {
        return new Uint8ClampedArray(4 * width * height).fill(255);
    }
    saved(): Saved {
        const bytes = new TextEncoder().encode(this.values().join('\n'));
        return { files: [{ name: 'fake.glib', bytes }], unwritten: [], error: '' };
    }
    restored(): Opened {
        return this.open('fake.glib');
    }
}

export async function loadEngine(): Promise<FakeEngine> {
    return new FakeEngine();
}

export function prepareCanvas(): void {}
