// What is taken from outside: checked before memory is taken.
export const limits = {
    files: 2000,
    bytes: 256 << 20,
    fileBytes: 64 << 20,
};

export function megabytes(bytes: number): string {
    const value = bytes / (1 << 20);
    return value < 10 ? `${value.toFixed(1)} MB` : `${Math.round(value)} MB`;
}

// Counts what is taken, and throws a TooMuch at the limit.
export class Budget {
    #files = 0;
    #bytes = 0;

    constructor(private readonly most = limits) {}

    // The bytes of one file that can still be taken.
    get room(): number {
        return Math.min(this.most.fileBytes, this.most.bytes - this.#bytes);
    }

    file(): void {
        if (++this.#files > this.most.files) throw new TooMuch(`there are more than ${this.most.files} files`);
    }

    // `name` is the file's, `bytes` its size.
    bytes(name: string, bytes: number): void {
        if (bytes > this.most.fileBytes)
            throw new TooMuch(`'${name}' has more than ${megabytes(this.most.fileBytes)}, which is the limit for one file`);
        this.#bytes += bytes;
        if (this.#bytes > this.most.bytes)
            throw new TooMuch(`the files have more than ${megabytes(this.most.bytes)} together, which is the limit`);
    }
}

export class TooMuch extends Error {}
