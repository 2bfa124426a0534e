// The worker: the same bundle and the same runtime as the page, without graphics. It checks text and decodes images.
import type { Problem } from './engine.ts';

export interface Start {
    kind: 'start';
    // snell.wasm.
    runtime: WebAssembly.Module;
}

export type Job =
    | { kind: 'check'; id: number; scene: string; changed: [string, Uint8Array][]; removed: string[] }
    | { kind: 'decode'; id: number; name: string; bytes: Uint8Array };

export type Answer =
    | { kind: 'ready' }
    | { kind: 'failed'; why: string }
    | { kind: 'checked'; id: number; problems: Problem[] }
    | { kind: 'decoded'; id: number; image?: Uint8Array };

// What the worker needs of WasmEngine.
export interface WorkerEngine {
    write(name: string, bytes: Uint8Array): void;
    remove(name: string): void;
    check(scene: string): Problem[];
    // The decoded image ("SNELLIMG"), or the error.
    decode(name: string, bytes: Uint8Array): Uint8Array | string;
}

// What of a worker's global scope is used.
export interface Scope {
    onmessage: ((event: MessageEvent<Start | Job>) => void) | null;
    postMessage(answer: Answer, transfer: Transferable[]): void;
}

function answered(engine: WorkerEngine, job: Job): Answer {
    if (job.kind === 'decode') {
        const image = engine.decode(job.name, job.bytes);
        return { kind: 'decoded', id: job.id, image: typeof image === 'string' ? undefined : image };
    }
    for (const name of job.removed) engine.remove(name);
    for (const [name, bytes] of job.changed) engine.write(name, bytes);
    return { kind: 'checked', id: job.id, problems: engine.check(job.scene) };
}

// Answers what the page asks. An exception of the runtime reaches the page as the worker's error, which starts it again.
export function serve(scope: Scope, make: (runtime: WebAssembly.Module) => Promise<WorkerEngine>): void {
    let engine: WorkerEngine | undefined;
    scope.onmessage = ({ data }) => {
        if (data.kind === 'start') {
            make(data.runtime).then(
                (made) => {
                    engine = made;
                    scope.postMessage({ kind: 'ready' }, []);
                },
                (error) => scope.postMessage({ kind: 'failed', why: String(error) }, []),
            );
        } else if (engine) {
            const answer = answered(engine, data);
            const image = answer.kind === 'decoded' ? answer.image : undefined;
            scope.postMessage(answer, image ? [image.buffer as ArrayBuffer] : []);
        }
    };
}
