// Sliders that move to and fro over their ranges, as functions of time, by the window's rules (docs/window.md).
import type { Setting } from './history.ts';
import { fractionOf, valueAt, type Track } from './steps.ts';

export interface Motion {
    // Of the control.
    key: string;
    component: number;
    // Seconds from the minimum to the maximum and back.
    period: number;
    // A time at which the value is the minimum.
    start: number;
    // Of the control when the motion began, for undo.
    before: Setting;
}

export const usualPeriod = 4;
const shortest = 0.1;
const longest = 3600;

// Begins at the value, upwards.
export function motionFrom(key: string, component: number, value: number, track: Track, time: number, before: Setting): Motion {
    return { key, component, period: usualPeriod, start: time - (fractionOf(value, track) * usualPeriod) / 2, before };
}

// With another period, the value of this moment stays.
export function slowed(motion: Motion, period: number, time: number): void {
    const next = Math.min(Math.max(period, shortest), longest);
    motion.start = time - ((time - motion.start) * next) / motion.period;
    motion.period = next;
}

export function valueOf({ start, period }: Motion, track: Track, time: number): number {
    const cycles = (time - start) / period;
    return valueAt(1 - Math.abs(2 * (cycles - Math.floor(cycles)) - 1), track);
}
