// The page's side of the worker: one job at a time, and an end to jobs that take too long.
import type { Answer, Job, Start } from '../worker.ts';
import { isData } from './bytes.ts';
import type { Checked, Checker, Files } from './host.ts';

// What of a Worker is used.
export interface Thread {
    postMessage(message: Start | Job, transfer?: Transferable[]): void;
    terminate(): void;
    onmessage: ((event: MessageEvent<Answer>) => void) | null;
    onerror: ((event: ErrorEvent) => void) | null;
}

// A spawn() for the page's own bundle, whose text is `source`, and snell.wasm.
export function pageWorker(source: string, runtime: WebAssembly.Module): () => Thread {
    let url: string | undefined;
    return () => {
        url ??= URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
        const worker = new Worker(url);
        worker.postMessage({ kind: 'start', runtime } satisfies Start);
        return worker;
    };
}

export interface WorkerChecker extends Checker {
    // Large images as decoded images ("SNELLIMG"); those that cannot be decoded are left out.
    decodeLarge(files: Files): Promise<Map<string, Uint8Array>>;
    stop(): void;
}

export interface CheckerOptions {
    // Starts a worker that is told its runtime by a Start; throws where the browser allows none.
    spawn(): Thread;
    say(message: string): void;
    // Of one job; a worker that starts has as long again.
    milliseconds?: number;
}

export const largeImage = 256 << 10;
const images = /\.(png|jpe?g|bmp|tga|gif|hdr|psd|ppm|pgm|pnm)$/i;

// A message takes the whole memory that an array is a part of, such as the archive's. A check reads texts only: of images
// and meshes it is enough that they are there.
function sent(job: Job): Job {
    const own = (bytes: Uint8Array) => (bytes.byteLength < bytes.buffer.byteLength ? bytes.slice() : bytes);
    if (job.kind === 'decode') return { ...job, bytes: own(job.bytes) };
    const changed = job.changed.map(([name, bytes]): [string, Uint8Array] => [name, isData(name) ? new Uint8Array() : own(bytes)]);
    return { ...job, changed };
}

interface Task {
    job: Job;
    // Files of a check: what of them the worker lacks is known when its turn comes.
    files?: Files;
    done(answer: Answer | 'replaced' | 'stopped' | 'absent'): void;
}

class Queue implements WorkerChecker {
    #thread: Thread | undefined;
    #absent = false;
    #ready = false;
    #running: Task | undefined;
    #timer: ReturnType<typeof setTimeout> | undefined;
    #waiting: Task[] = [];
    // The files that the worker has.
    #known = new Map<string, Uint8Array>();
    #next = 1;
    // The check whose answer is wanted.
    #newest = 0;

    constructor(
        private readonly options: CheckerOptions,
        private readonly milliseconds = options.milliseconds ?? 10_000,
    ) {}

    check(scene: string, files: Files): Promise<Checked> {
        const id = this.#next++;
        this.#newest = id;
        return new Promise((resolve) => {
            const done: Task['done'] = (answer) => {
                if (this.#newest !== id && answer !== 'absent') resolve({ state: 'replaced' });
                else if (typeof answer === 'string') resolve({ state: answer });
                else resolve({ state: 'done', problems: answer.kind === 'checked' ? answer.problems : [] });
            };
            this.#add({ job: { kind: 'check', id, scene, changed: [], removed: [] }, files: new Map(files), done });
        });
    }

    async decodeLarge(files: Files): Promise<Map<string, Uint8Array>> {
        const out = new Map<string, Uint8Array>();
        const large = [...files].filter(([name, bytes]) => bytes.length > largeImage && images.test(name));
        const decoded = large.map(async ([name, bytes]) => {
            const image = await this.#decode(name, bytes);
            if (image) out.set(name, image);
        });
        await Promise.all(decoded);
        return out;
    }

    // Ends the worker for good.
    stop(): void {
        this.#end();
        this.#absent = true;
        const waiting = this.#waiting;
        this.#waiting = [];
        for (const task of waiting) task.done('absent');
        this.#give('absent');
    }

    #decode(name: string, bytes: Uint8Array): Promise<Uint8Array | undefined> {
        return new Promise((resolve) => {
            const done: Task['done'] = (answer) =>
                resolve(typeof answer !== 'string' && answer.kind === 'decoded' ? answer.image : undefined);
            this.#add({ job: { kind: 'decode', id: this.#next++, name, bytes }, done });
        });
    }

    #add(task: Task): void {
        if (this.#absent) return task.done('absent');
        if (task.job.kind === 'check') {
            // Checks come first: someone is waiting for them.
            const isCheck = ({ job }: Task) => job.kind === 'check';
            for (const older of this.#waiting.filter(isCheck)) older.done('replaced');
            this.#waiting = [task, ...this.#waiting.filter((other) => !isCheck(other))];
        } else {
            this.#waiting.push(task);
        }
        this.#proceed();
    }

    #proceed(): void {
        if (this.#running || this.#waiting.length === 0) return;
        this.#running = this.#waiting.shift()!;
        if (this.#ready) return this.#begin(this.#running);
        if (this.#thread) return;
        try {
            this.#start();
        } catch {
            this.stop();
        }
    }

    #start(): void {
        const started = this.options.spawn();
        this.#thread = started;
        // A worker that was ended may have answers under way.
        started.onmessage = ({ data }) => void (this.#thread === started && this.#receive(data));
        started.onerror = () =>
            void (this.#thread === started && (this.#ready ? this.#stopped('failed') : this.stop()));
        this.#timer = setTimeout(() => this.stop(), 2 * this.milliseconds);
    }

    #receive(answer: Answer): void {
        if (answer.kind === 'failed') return this.stop();
        if (answer.kind === 'ready') {
            clearTimeout(this.#timer);
            this.#ready = true;
            if (this.#running) this.#begin(this.#running);
        } else if (answer.id === this.#running?.job.id) {
            this.#give(answer);
        }
    }

    #begin(task: Task): void {
        if (task.job.kind === 'check') {
            const files = task.files ?? new Map<string, Uint8Array>();
            task.job.changed = [...files].filter(([name, bytes]) => this.#known.get(name) !== bytes);
            task.job.removed = [...this.#known.keys()].filter((name) => !files.has(name));
            this.#known = new Map(files);
        }
        this.#thread?.postMessage(sent(task.job));
        const late = `took more than ${this.milliseconds / 1000} s and was stopped`;
        this.#timer = setTimeout(() => this.#stopped(late), this.milliseconds);
    }

    #give(answer: Answer | 'stopped' | 'absent'): void {
        clearTimeout(this.#timer);
        const task = this.#running;
        this.#running = undefined;
        task?.done(answer);
        this.#proceed();
    }

    #stopped(what: string): void {
        const check = this.#running?.job.kind === 'check';
        this.#end();
        if (check) this.options.say(`Checking the text ${what}. The picture is that of the text before the last edit.`);
        this.#give('stopped');
    }

    #end(): void {
        clearTimeout(this.#timer);
        this.#thread?.terminate();
        this.#thread = undefined;
        this.#ready = false;
        this.#known = new Map();
    }
}

export function makeChecker(options: CheckerOptions): WorkerChecker {
    return new Queue(options);
}
