// What a track does: between its position and the value, and by keys.
import { tidy } from './numbers.ts';

export interface Track {
    min: number;
    max: number;
    integral: boolean;
    // Equal distances are equal ratios.
    logarithmic?: boolean;
}

export function canBeLogarithmic({ min, max }: { min: number; max: number }): boolean {
    return min > 0 && max > min && Number.isFinite(max / min);
}

// No intermediate result overflows, for any range.
export function fractionOf(value: number, track: Track): number {
    const { min, max } = track;
    if (track.logarithmic && value > 0) return Math.min(Math.max(Math.log(value / min) / Math.log(max / min), 0), 1);
    const half = max / 2 - min / 2;
    if (!(half > 0) || !Number.isFinite(value)) return 0;
    return Math.min(Math.max((value / 2 - min / 2) / half, 0), 1);
}

export function valueAt(fraction: number, { min, max, integral, logarithmic }: Track, fine = false): number {
    if (fraction <= 0) return min;
    if (fraction >= 1) return max;
    if (logarithmic) {
        const exact = min * (max / min) ** fraction;
        return Math.min(Math.max(integral ? Math.round(exact) : Number(exact.toPrecision(fine ? 7 : 5)), min), max);
    }
    const value = min * (1 - fraction) + max * fraction;
    return integral ? Math.round(value) : tidy(Math.min(Math.max(value, min), max), min, max, fine);
}

// A step is a hundredth of the range, of whole numbers 1.
export function stepped(value: number, steps: number, track: Track): number {
    const { min, max, integral } = track;
    if (steps === 0 || !(min < max)) return value;
    if (!integral) return valueAt(fractionOf(value, track) + steps / 100, track, Math.abs(steps) < 1);
    const coarse = Math.abs(steps) >= 10 ? Math.round((max - min) / 10) : 1;
    return Math.min(Math.max(value + Math.sign(steps) * Math.max(1, coarse), min), max);
}

// How many steps a key makes; 0: it is none of the track's keys.
export function stepsOf(key: string, shift: boolean): number {
    const unit = shift ? 0.1 : 1;
    const steps: Record<string, number> = {
        ArrowRight: unit,
        ArrowUp: unit,
        ArrowLeft: -unit,
        ArrowDown: -unit,
        PageUp: 10,
        PageDown: -10,
    };
    return steps[key] ?? 0;
}
