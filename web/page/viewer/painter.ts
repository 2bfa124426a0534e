// When the picture is drawn, and how large: only if something changed or time runs, at most once a frame of the display.
import type { Engine, Frame, Problem } from '../engine.ts';
import type { Clock } from './clock.ts';

export interface PainterOptions {
    engine: Engine;
    canvas: HTMLCanvasElement;
    clock: Clock;
    // Nothing can be drawn yet, or the context is lost.
    ready(): boolean;
    // After each picture but the small first one, when the graphics have finished it.
    drawn(milliseconds: number, coarse: boolean): void;
    // What a picture was found to cost.
    costs(costs: Problem[]): void;
    // The clock moved.
    ticked(): void;
    // A picture will take about so long, in which the page does not answer: whether it is drawn all the same; false: a
    // small one, if that `helps`; undefined: none until something changes. `signal`: the question is no longer one.
    goesOn(milliseconds: number, helps: boolean, signal: AbortSignal): Promise<boolean | undefined>;
}

const longestSide = 8192;
// The first picture of a scene has so much less width and height.
const preview = 4;
// Milliseconds of such a picture after which the author is asked, and of a whole one that is foreseen.
const tooLong = 2000;
const longest = 5000;
// Milliseconds of a picture that is to be small.
const short = 500;
// Milliseconds after which a picture counts as finished, because a lost context never says so.
const longestWait = 5000;
// Milliseconds without a picture before the engine makes later ones faster.
const settleAfter = 500;

export class Painter {
    split: number | undefined;
    mouse: [number, number] | undefined;
    private dirty = false;
    private dragged = false;
    private scheduled = false;
    private size: [number, number] = [0, 0];
    private divisor = 1;
    // The next picture is the first one of a scene, with this divisor; 0: it is not.
    private first = preview;
    // No picture has more pixels.
    private least = 1;
    private waits = false;
    private question: AbortController | undefined;
    // Another value may make the picture take for ever: it is drawn very small before, and timed.
    private risky = false;
    private foreseen = false; // as things are now
    private shrinks = false; // the author wants small pictures rather than slow ones
    private looksAgain = -Infinity;
    // Milliseconds that the author wants to wait.
    private accepted = longest;
    // The same first picture is drawn a second time.
    private again = false;
    // It is being drawn.
    private drawsFirst = false;
    private began: number | undefined;
    // Passed when the graphics have finished the last picture.
    private fence: WebGLSync | null = null;
    private settling: ReturnType<typeof setTimeout> | undefined;
    private sharp: ReturnType<typeof setTimeout> | undefined;
    // Whether the engine may have something to settle.
    private unsettled = false;
    frames = 0;

    constructor(private readonly with_: PainterOptions) {
        this.observe();
        document.addEventListener('visibilitychange', () => {
            with_.clock.hold();
            if (!document.hidden) this.schedule();
        });
    }

    // The size in pixels of the display, whatever its ratio to the page's pixels is.
    private observe(): void {
        const { canvas } = this.with_;
        const resized = (width: number, height: number) => {
            this.size = [Math.max(Math.min(Math.round(width), longestSide), 1), Math.max(Math.min(Math.round(height), longestSide), 1)];
            this.request();
        };
        const observer = new ResizeObserver(([entry]) => {
            const device = entry!.devicePixelContentBoxSize?.[0];
            if (device) return resized(device.inlineSize, device.blockSize);
            const { width, height } = entry!.contentRect;
            resized(width * devicePixelRatio, height * devicePixelRatio);
        });
        try {
            observer.observe(canvas, { box: 'device-pixel-content-box' });
        } catch {
            observer.observe(canvas);
        }
    }

    frame(): Frame {
        const [width, height] = this.size;
        return { time: this.with_.clock.time, width, height, split: this.split, mouse: this.mouse };
    }

    // The next picture is that of another scene. Nobody knows how long it takes, so a small one comes first.
    begin(risky: boolean): void {
        this.first = preview;
        this.edited(risky);
    }

    // The text is another one: what was found out about the one before says nothing of it.
    edited(risky: boolean): void {
        this.withdraw();
        this.risky = risky;
        this.accepted = longest;
        this.least = 1;
        this.shrinks = false;
        this.request();
    }

    // There is nothing to answer any more.
    withdraw(): void {
        this.question?.abort();
    }

    // Whether the graphics have something to do.
    get busy(): boolean {
        return this.began !== undefined;
    }

    request(drag = false): void {
        this.foreseen = false;
        this.withdraw(); // a question about another picture
        this.dragged ||= drag;
        this.redo();
    }

    // The same picture again, perhaps of another size.
    private redo(): void {
        this.dirty = true;
        this.unsettled = true;
        this.schedule();
    }

    private schedule(): void {
        if (this.scheduled || document.hidden) return;
        this.scheduled = true;
        requestAnimationFrame((now) => {
            this.scheduled = false;
            this.tick(now);
        });
    }

    private tick(now: number): void {
        const { clock, ready, ticked } = this.with_;
        if (this.waits) return;
        if (!ready() || this.size[0] <= 1) {
            this.began = undefined;
            this.fence = null;
            return;
        }
        // One picture at a time: a queue of them would only be late.
        if (!this.finished()) return this.schedule();
        clock.advance(now);
        if (clock.playing) ticked();
        if (this.dirty || clock.playing) this.draw();
        else this.rest();
    }

    // Whether nothing is being drawn any more.
    private finished(): boolean {
        if (this.began === undefined) return true;
        const milliseconds = performance.now() - this.began;
        const gl = this.fence && this.with_.canvas.getContext('webgl2');
        if (gl && this.fence && milliseconds < longestWait) {
            if (gl.getSyncParameter(this.fence, gl.SYNC_STATUS) !== gl.SIGNALED) return false;
            gl.deleteSync(this.fence);
        }
        this.fence = null;
        this.began = undefined;
        if (this.drawsFirst) {
            if (this.slow(milliseconds)) return false;
            performance.mark('First picture');
        }
        if (this.drawsFirst && this.divisor > this.least) {
            this.redo();
        } else {
            // No more than was foreseen of it.
            if (this.least > 1 && milliseconds > 2 * short) this.least *= 2;
            const due = this.with_.engine.drew(milliseconds);
            if (due < Infinity) this.sharp = setTimeout(() => this.redo(), due + 1);
            this.with_.drawn(milliseconds, this.divisor > 1 || due < Infinity);
        }
        return true;
    }

    // After a first picture: what comes next. True: it waits for an answer.
    private slow(milliseconds: number): boolean {
        const { divisor, again } = this;
        this.again = false;
        if (milliseconds < tooLong) return false;
        // The first picture of all waits for the compiler, too: the same one again does not.
        if (!again && milliseconds < longestWait) {
            this.again = true;
            this.first = divisor;
            this.redo();
            return true;
        }
        this.ask(milliseconds * divisor ** 2);
        return true;
    }

    // `helps`: a smaller picture takes less.
    private ask(milliseconds: number, helps = true): void {
        const { signal } = (this.question = new AbortController());
        this.waits = true;
        void this.with_.goesOn(milliseconds, helps, signal).then((goes) => {
            this.waits = false;
            if (signal.aborted) return this.schedule();
            if (goes === undefined) return void (this.with_.clock.playing = false);
            this.accepted = goes ? Math.max(this.accepted, 2 * milliseconds) : this.accepted;
            this.shrinks = !goes;
            this.shrink(goes ? 0 : milliseconds);
            this.redo();
        });
    }

    // To what takes a short time, if the whole picture takes so long.
    private shrink(milliseconds: number): void {
        this.least = 1;
        while (milliseconds / this.least ** 2 > short) this.least *= 2;
    }

    // Whether the picture is drawn now; the author may have been asked instead.
    private looksAhead(): boolean {
        const { playing } = this.with_.clock;
        if (!this.risky || (this.foreseen && !playing)) return true;
        const begun = performance.now();
        if (playing && this.least > 1 && begun < this.looksAgain) return true;
        const foreseen = this.with_.engine.foresee(this.frame(), this.accepted);
        const milliseconds = Math.abs(foreseen);
        const helps = foreseen > 0;
        // Between small pictures it takes at most a fifth of the time.
        this.looksAgain = performance.now() + 4 * (performance.now() - begun);
        this.shrinks &&= helps && (playing || milliseconds > this.accepted);
        if (milliseconds <= this.accepted || !helps) this.least = 1;
        else if (this.shrinks) this.shrink(milliseconds);
        this.foreseen = milliseconds / this.least ** 2 <= this.accepted;
        if (!this.foreseen) this.ask(milliseconds, helps);
        return this.foreseen;
    }

    private small(divisor: number): Frame {
        const { width, height, mouse, ...rest } = this.frame();
        const side = (pixels: number) => Math.max(Math.round(pixels / divisor), 1);
        return { ...rest, width: side(width), height: side(height), mouse: mouse && [mouse[0] / divisor, mouse[1] / divisor] };
    }

    private draw(): void {
        clearTimeout(this.settling);
        clearTimeout(this.sharp);
        const { dragged } = this;
        this.dirty = this.dragged = false;
        if (!this.looksAhead()) return;
        this.divisor = Math.max(this.first, this.least);
        this.drawsFirst = this.first > 0;
        this.first = 0;
        this.began = performance.now();
        const costs = this.with_.engine.draw(this.small(this.divisor), dragged, this.least > 1);
        if (costs.length > 0) this.with_.costs(costs);
        ++this.frames;
        const gl = this.with_.canvas.getContext('webgl2');
        this.fence = gl?.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0) ?? null;
        gl?.flush();
        // The next frame of the display tells how long this one took, and draws only if something changed.
        this.schedule();
    }

    private rest(): void {
        if (!this.unsettled) return;
        clearTimeout(this.settling);
        this.settling = setTimeout(() => {
            const { engine, ready } = this.with_;
            if (document.hidden || !ready()) return;
            this.unsettled = engine.settle(this.small(this.least));
            this.rest();
        }, settleAfter);
    }
}
