// Mouse, touch, wheel and keys over the picture, by the window's rules (docs/window.md).

export interface Gestures {
    // `begins`: the first movement of a drag.
    turn(dx: number, dy: number, gesture: object, begins: boolean): void;
    // `toward` the viewer.
    move(dx: number, dy: number, gesture: object, toward?: number): void;
    zoom(factor: number, gesture: object): void;
    reset(): void;
    // Where the pointer is, in CSS pixels from the upper left.
    pointed(x: number, y: number): void;
    end(): void;
}

const scalePerStep = 1.1;
const scalePerPixel = 1.006;
// Of a step of the wheel, towards the viewer.
const pixelsPerStep = 20;
const pixelsPerKey = 10;
// Milliseconds between turns of the wheel, or keys, that are one gesture.
const again = 300;

// Wheels tell pixels, lines or pages; a usual step is 100 pixels or 3 lines.
export function stepsOfWheel(event: { deltaX: number; deltaY: number; deltaMode: number }): number {
    const unit = event.deltaMode === 0 ? 1 / 100 : event.deltaMode === 1 ? 1 / 3 : 1;
    // Some systems swap the wheel's axes while Shift is down.
    const delta = event.deltaY !== 0 ? event.deltaY : event.deltaX;
    return -Math.min(Math.max(delta * unit, -5), 5);
}

type Kind = 'turn' | 'move' | 'zoom' | 'toward';

function kindOf(event: PointerEvent): Kind {
    const command = event.buttons & 1 && (event.ctrlKey || event.metaKey);
    if (command && event.shiftKey) return 'toward';
    if (event.buttons & 4 || command) return 'zoom';
    return event.buttons & 2 || event.shiftKey ? 'move' : 'turn';
}

class Hand {
    private readonly at = new Map<number, [number, number]>();
    private gesture = {};
    private begins = true;

    constructor(private readonly to: Gestures) {}

    down(event: PointerEvent): void {
        if (this.at.size === 0) {
            this.gesture = {};
            this.begins = true;
        }
        this.at.set(event.pointerId, [event.clientX, event.clientY]);
    }

    move(event: PointerEvent): void {
        const before = this.at.get(event.pointerId);
        if (!before) return;
        const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
        if (dx === 0 && dy === 0) return;
        if (this.at.size === 1) this.one(kindOf(event), dx, dy);
        else if (this.at.size === 2) this.two(event, before);
        this.at.set(event.pointerId, [event.clientX, event.clientY]);
    }

    private one(kind: Kind, dx: number, dy: number): void {
        if (kind === 'zoom') this.to.zoom(scalePerPixel ** (dx - dy), this.gesture);
        else if (kind === 'move') this.to.move(dx, dy, this.gesture);
        else if (kind === 'toward') this.to.move(0, 0, this.gesture, dy);
        else {
            this.to.turn(dx, dy, this.gesture, this.begins);
            this.begins = false;
        }
    }

    // Each finger moves the middle by half of its way.
    private two(event: PointerEvent, before: [number, number]): void {
        const other = [...this.at].find(([id]) => id !== event.pointerId)![1];
        const far = Math.hypot(before[0] - other[0], before[1] - other[1]);
        const now = Math.hypot(event.clientX - other[0], event.clientY - other[1]);
        this.to.move((event.clientX - before[0]) / 2, (event.clientY - before[1]) / 2, this.gesture);
        if (far > 10 && now > 10) this.to.zoom(now / far, this.gesture);
    }

    up(event: PointerEvent): void {
        this.at.delete(event.pointerId);
        if (this.at.size === 0) this.to.end();
    }
}

function keyed(event: KeyboardEvent, to: Gestures, gesture: object, begins: boolean): boolean {
    const ways: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const way = ways[event.key]?.map((part) => part * pixelsPerKey);
    if (way && event.shiftKey) to.move(way[0]!, way[1]!, gesture);
    else if (way) to.turn(way[0]!, way[1]!, gesture, begins);
    else if (event.key === '+' || event.key === '=') to.zoom(scalePerStep, gesture);
    else if (event.key === '-') to.zoom(1 / scalePerStep, gesture);
    else if (event.key === 'Home') to.reset();
    else return false;
    return true;
}

export function listen(element: HTMLElement, to: Gestures): void {
    const hand = new Hand(to);
    let quiet: ReturnType<typeof setTimeout> | undefined;
    let gesture: object | undefined;
    // Turns of the wheel, and keys, that follow each other are one gesture.
    const running = (): [object, boolean] => {
        clearTimeout(quiet);
        const begins = gesture === undefined;
        gesture ??= {};
        quiet = setTimeout(() => {
            gesture = undefined;
            to.end();
        }, again);
        return [gesture, begins];
    };
    element.addEventListener('pointerdown', (event) => {
        element.setPointerCapture(event.pointerId);
        element.focus({ preventScroll: true });
        if (event.button === 1) event.preventDefault();
        hand.down(event);
    });
    element.addEventListener('pointermove', (event) => {
        const box = element.getBoundingClientRect();
        to.pointed(event.clientX - box.left, event.clientY - box.top);
        hand.move(event);
    });
    for (const type of ['pointerup', 'pointercancel'] as const) element.addEventListener(type, (event) => hand.up(event));
    element.addEventListener('contextmenu', (event) => event.preventDefault());
    element.addEventListener('dblclick', () => to.reset());
    element.addEventListener(
        'wheel',
        (event) => {
            event.preventDefault();
            const steps = stepsOfWheel(event);
            const [gesture] = running();
            if (event.shiftKey) to.move(0, 0, gesture, pixelsPerStep * steps);
            else to.zoom(scalePerStep ** steps, gesture);
        },
        { passive: false },
    );
    element.addEventListener('keydown', (event) => {
        // Other keys, such as Ctrl+Z, must not end what is dragged next.
        if (event.ctrlKey || event.metaKey || event.altKey || !keyed(event, to, ...running())) return;
        event.preventDefault();
        event.stopPropagation();
    });
}
