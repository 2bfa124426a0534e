// How coarse the picture is drawn while something is dragged, so that the drag stays smooth.

const divisors = [1, 2, 4];
// Milliseconds of a frame above which the next ones are coarser, and below which the next drag tries finer ones.
const slow = 33;
const fast = 20;
// One frame as slow as this is enough.
const verySlow = 100;
// Milliseconds without a change after which the picture is sharp.
export const rest = 150;

export class Coarseness {
    // Of the current drag, and with which the next one begins.
    private level = 0;
    private until = -Infinity;
    // In a row: one slow frame may be the browser's.
    private slowFrames = 0;
    private slowest = 0;

    // The divisor of width and height for a frame at `now`, in milliseconds. `moved`: a drag changed the picture.
    next(moved: boolean, now: number): number {
        if (moved) {
            if (now >= this.until) this.begin();
            this.until = now + rest;
        }
        return now < this.until ? divisors[this.level]! : 1;
    }

    private begin(): void {
        if (this.level > 0 && this.slowest > 0 && this.slowest < fast) --this.level;
        this.slowFrames = this.slowest = 0;
    }

    // A frame of a drag took so long, and is finished at `now`.
    took(milliseconds: number, now: number): void {
        // The move that comes after a slow frame is of the same drag.
        this.until = Math.max(this.until, now + rest);
        this.slowest = Math.max(this.slowest, milliseconds);
        this.slowFrames = milliseconds > slow ? this.slowFrames + (milliseconds > verySlow ? 2 : 1) : 0;
        if (this.slowFrames < 2 || this.level === 2) return;
        ++this.level;
        this.slowFrames = this.slowest = 0;
    }

    // When a sharp picture is due if nothing moves.
    get due(): number {
        return this.until;
    }
}
