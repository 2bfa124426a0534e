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
export function pageWorker(source: string, runtime: Uint8Array): () => Thread {
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

export function makeChecker({ spawn, say, milliseconds = 10_000 }: CheckerOptions): WorkerChecker {
    let thread: Thread | undefined;
    let absent = false;
    let ready = false;
    let running: Task | undefined;
    let timer: ReturnType<typeof setTimeout> | undefined;
    let queue: Task[] = [];
    // The files that the worker has.
    let known = new Map<string, Uint8Array>();
    let next = 1;

    const end = () => {
        clearTimeout(timer);
        thread?.terminate();
        thread = undefined;
        ready = false;
        known = new Map();
    };

    const give = (answer: Answer | 'stopped' | 'absent') => {
        clearTimeout(timer);
        const task = running;
        running = undefined;
        task?.done(answer);
        proceed();
    };

    const fail = () => {
        end();
        absent = true;
        const waiting = queue;
        queue = [];
        for (const task of waiting) task.done('absent');
        give('absent');
    };

    const late = () => {
        if (!ready) return fail();
        stopped(`took more than ${milliseconds / 1000} s and was stopped`);
    };

    const stopped = (what: string) => {
        const check = running?.job.kind === 'check';
        end();
        if (check) say(`Checking the text ${what}. The picture is that of the text before the last edit.`);
        give('stopped');
    };

    const begin = (task: Task) => {
        if (task.job.kind === 'check') {
            const files = task.files ?? new Map<string, Uint8Array>();
            task.job.changed = [...files].filter(([name, bytes]) => known.get(name) !== bytes);
            task.job.removed = [...known.keys()].filter((name) => !files.has(name));
            known = new Map(files);
        }
        thread?.postMessage(sent(task.job));
        timer = setTimeout(late, milliseconds);
    };

    const receive = (answer: Answer) => {
        if (answer.kind === 'failed') return fail();
        if (answer.kind === 'ready') {
            clearTimeout(timer);
            ready = true;
            if (running) begin(running);
        } else if (answer.id === running?.job.id) {
            give(answer);
        }
    };

    const start = () => {
        const started = spawn();
        thread = started;
        // A worker that was ended may have answers under way.
        started.onmessage = ({ data }) => void (thread === started && receive(data));
        started.onerror = () => void (thread === started && (ready ? stopped('failed') : fail()));
        timer = setTimeout(late, 2 * milliseconds);
    };

    const proceed = () => {
        if (running || queue.length === 0) return;
        running = queue.shift()!;
        if (ready) return begin(running);
        if (thread) return;
        try {
            start();
        } catch {
            fail();
        }
    };

    const add = (task: Task) => {
        if (absent) return task.done('absent');
        if (task.job.kind === 'check') {
            // Checks come first: someone is waiting for them.
            for (const older of queue.filter(({ job }) => job.kind === 'check')) older.done('replaced');
            queue = [task, ...queue.filter(({ job }) => job.kind !== 'check')];
        } else {
            queue.push(task);
        }
        proceed();
    };

    const check = (scene: string, files: Files) =>
        new Promise<Checked>((resolve) => {
            const id = next++;
            newest = id;
            const done: Task['done'] = (answer) => {
                if (newest !== id && answer !== 'absent') resolve({ state: 'replaced' });
                else if (typeof answer === 'string') resolve({ state: answer });
                else resolve({ state: 'done', problems: answer.kind === 'checked' ? answer.problems : [] });
            };
            add({ job: { kind: 'check', id, scene, changed: [], removed: [] }, files: new Map(files), done });
        });
    let newest = 0;

    const decode = (name: string, bytes: Uint8Array) =>
        new Promise<Uint8Array | undefined>((resolve) => {
            const done: Task['done'] = (answer) =>
                resolve(typeof answer !== 'string' && answer.kind === 'decoded' ? answer.image : undefined);
            add({ job: { kind: 'decode', id: next++, name, bytes }, done });
        });

    return {
        check,
        decodeLarge: async (files) => {
            const large = [...files].filter(([name, bytes]) => bytes.length > largeImage && images.test(name));
            const out = new Map<string, Uint8Array>();
            await Promise.all(
                large.map(async ([name, bytes]) => {
                    const image = await decode(name, bytes);
                    if (image) out.set(name, image);
                }),
            );
            return out;
        },
        stop: fail,
    };
}
