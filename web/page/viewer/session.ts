// The scene that is shown: its controls, ladders and view, and every change of them, which the engine makes and undoes.
import type { Control, Engine, Ladder, Opened, Problem, Shown, State } from '../engine.ts';

export interface Listeners {
    // The picture is out of date; `drag`: by something that is still moving.
    redraw(drag: boolean): void;
    // Values, rungs or the view are others; the controls are the same.
    changed(): void;
    // Other controls or ladders are shown.
    listed(): void;
    // A slider begins or ends to move by itself.
    moved(): void;
    problems(problems: Problem[]): void;
    say(message: string): void;
}

export function isChanged({ value, initial }: Control): boolean {
    return value.some((component, i) => component !== initial[i]);
}

// "uOffset.x" for a component of a vector.
export function nameOf(control: Control, component: number): string {
    const count = control.value.length;
    if (count === 1) return control.name;
    return count <= 4 ? `${control.name}.${'xyzw'[component]}` : `${control.name}[${component}]`;
}

// Of controls whose rows are the same ones.
function shapeOf(controls: readonly Control[]): string {
    return JSON.stringify(controls.map(({ index, key, widget, value }) => [index, key, widget, value.length]));
}

export class Session {
    shown: Shown | undefined;
    state: State;
    // What the last change is part of, while it may go on.
    private gesture: unknown;

    constructor(
        readonly engine: Engine,
        private readonly on: Listeners,
    ) {
        this.state = engine.state();
    }

    get controls(): Control[] {
        return this.shown?.controls ?? [];
    }
    get ladders(): Ladder[] {
        return this.shown?.ladders ?? [];
    }
    get anyChanged(): boolean {
        const turned = this.ladders.some(({ chosen, marked }) => chosen !== marked);
        return turned || this.controls.some(isChanged);
    }
    // Of the sliders that move by themselves, in seconds.
    get periods(): number[] {
        return this.controls.flatMap(({ periods }) => periods).filter((period) => period > 0);
    }

    // What the engine says after open(), choose() or restored().
    accept(opened: Opened): void {
        this.on.problems(opened.problems);
        if (!opened.shown) return;
        // The same controls stay the same objects, so that a slider that is being dragged goes on.
        const before = this.controls;
        this.shown = opened.shown;
        if (shapeOf(before) === shapeOf(this.controls)) this.shown.controls = before.map((control, i) => Object.assign(control, this.controls[i]));
        this.state = this.engine.state();
        this.on.listed();
        this.on.redraw(false);
    }

    // Another scene is opened.
    forget(): void {
        this.shown = undefined;
    }

    // Takes what the engine has now.
    private refresh(): void {
        const moving = this.periods.join();
        this.state = this.engine.state();
        this.state.controls.forEach((control, i) => Object.assign(this.controls[i]!, control));
        if (this.periods.join() !== moving) this.on.moved();
        this.on.changed();
    }

    // Changes of one `gesture` are one step of undo; without a gesture, each call is one.
    change(make: () => void, gesture?: unknown): void {
        if (this.gesture !== gesture) this.engine.follow();
        this.gesture = gesture;
        make();
        if (gesture === undefined) this.engine.follow();
        this.on.redraw(gesture !== undefined);
        this.refresh();
    }

    // The next change begins another step.
    end(): void {
        if (this.gesture === undefined) return;
        this.gesture = undefined;
        this.engine.follow();
        this.refresh();
    }

    // Sets the values of this time.
    move(time: number): void {
        if (this.periods.length === 0) return;
        this.engine.advance(time);
        this.refresh();
    }

    reset(control: Control, component?: number): void {
        this.change(() => this.engine.reset(control.index, component));
    }

    // Of one program, or of all, and then the rungs, too.
    resetAll(program?: string): void {
        this.change(() => {
            if (program === undefined)
                for (const { index, chosen, marked } of this.ladders) if (chosen !== marked) this.accept(this.engine.choose(index, marked));
            for (const control of this.controls) if (control.program === (program ?? control.program)) this.engine.reset(control.index);
        });
    }

    choose(ladder: Ladder, rung: number): void {
        this.change(() => this.accept(this.engine.choose(ladder.index, rung)));
    }

    // Goes a step back, or `forward` again.
    go(forward: boolean): void {
        this.gesture = undefined;
        const { said, opened } = this.engine.go(forward);
        if (opened) this.accept(opened);
        this.on.redraw(false);
        this.refresh();
        this.on.say(said.charAt(0).toUpperCase() + said.slice(1));
    }
}
