// The time of an animated scene, and what sets it.
import { button, el } from '../dom.ts';

export class Clock {
    time = 0;
    speed = 1;
    playing = false;
    // When time was advanced last, in milliseconds; undefined while it does not run.
    private last: number | undefined;

    // Called for each frame.
    advance(now: number): void {
        // A page that was hidden, or a frame that took very long, does not make time jump.
        if (this.playing && this.last !== undefined) this.time += (Math.min(Math.max(now - this.last, 0), 250) / 1000) * this.speed;
        this.last = this.playing ? now : undefined;
    }

    hold(): void {
        this.last = undefined;
    }
}

export interface TimeBar {
    element: HTMLElement;
    toggle(): void;
    // `period` in seconds; 0: the scene has none.
    open(animated: boolean, period: number): void;
    refresh(): void;
}

// Seconds of the track of a scene without a period of its own.
const trackSeconds = 20;

export function makeTimeBar(clock: Clock, changed: () => void): TimeBar {
    const play = button('Pause', () => toggle(), { class: 'play' });
    const track = el('input', { type: 'range', min: 0, max: trackSeconds, step: 'any', 'aria-label': 'Time' });
    const shown = el('output', { class: 'time' });
    const speeds = [0.1, 0.25, 0.5, 1, 2, 4].map((speed) => el('option', { value: speed }, `${speed}×`));
    const speed = el('select', { 'aria-label': 'Speed' }, ...speeds);
    const element = el('div', { class: 'timebar', role: 'group', 'aria-label': 'Time', hidden: true }, play, track, shown, speed);
    let seconds = trackSeconds;

    const refresh = () => {
        play.textContent = clock.playing ? 'Pause' : 'Play';
        track.value = String(clock.time % seconds || (clock.time > 0 && !clock.playing ? Math.min(clock.time, seconds) : 0));
        track.style.setProperty('--at', `${(100 * track.valueAsNumber) / seconds}%`);
        shown.textContent = `${clock.time.toFixed(2)} s`;
        track.setAttribute('aria-valuetext', shown.textContent);
        speed.value = String(clock.speed);
    };
    const toggle = () => {
        if (element.hidden) return;
        clock.playing = !clock.playing;
        clock.hold();
        refresh();
        changed();
    };
    track.addEventListener('input', () => {
        clock.playing = false;
        clock.time = Math.floor(clock.time / seconds) * seconds + track.valueAsNumber;
        if (track.valueAsNumber >= seconds) clock.time = seconds;
        refresh();
        changed();
    });
    track.addEventListener('keydown', (event) => {
        const steps: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };
        const step = steps[event.key];
        if (step === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        clock.playing = false;
        clock.time = Math.max(0, clock.time + (step * seconds * (event.shiftKey ? 0.1 : 1)) / 100);
        refresh();
        changed();
    });
    speed.addEventListener('change', () => void (clock.speed = Number(speed.value)));
    const open = (animated: boolean, period: number) => {
        element.hidden = !animated;
        seconds = period > 0 ? period : trackSeconds;
        track.max = String(seconds);
        if (!animated) clock.playing = false;
        refresh();
    };
    return { element, toggle, open, refresh };
}
