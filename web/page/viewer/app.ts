// The page: its parts, and how they work together.
import type { Unpacked } from '../archive.ts';
import type { WorkerChecker } from '../editor/checker.ts';
import { makeEditor } from '../editor/editor.ts';
import type { Editor, EditorHost } from '../editor/host.ts';
import { baseOf } from '../editor/names.ts';
import { saveZip } from '../editor/pack.ts';
import type { Engine, Opened, Problem } from '../engine.ts';
import { Address } from './address.ts';
import { Clock, makeTimeBar } from './clock.ts';
import { makeHelp, makePictureDialog } from './dialogs.ts';
import { makeDivider } from './divider.ts';
import { el, painted } from '../dom.ts';
import { rangeText, readFragment, type Settings } from './fragment.ts';
import { listen } from './gestures.ts';
import { listenForKeys } from './keys.ts';
import { makeLayout } from './layout.ts';
import type { SceneData } from './load.ts';
import { Painter } from './painter.ts';
import { makePanel, type Panel } from './panel.ts';
import { makeProblems } from './problems.ts';
import { Session } from './session.ts';
import { copyText, makeTools, saveTexts, type Tools } from './tools.ts';
import { complaint, inVain } from './vain.ts';

export interface Contents {
    engine: Engine;
    // Undefined: ready pictures, whose files are not the scene's.
    checker: WorkerChecker | undefined;
    data: SceneData | undefined;
    unpacked: Unpacked;
}

const messageSeconds = 6;
// Of a message that many read who did not expect it.
const longMessageSeconds = 10;

function pageName(scene: string): string {
    return baseOf(scene).replace(/\.glib$/i, '') || 'snell';
}

export class Page {
    private readonly layout = makeLayout((name) => name === 'text' && this.makeEditor());
    private readonly clock = new Clock();
    private readonly timebar = makeTimeBar(this.clock, () => {
        this.session.move(this.clock.time);
        this.painter?.request();
        this.address?.changed();
    });
    private readonly problems = makeProblems((place) => {
        this.layout.chooseTab('text');
        this.makeEditor()?.goTo(place);
    });
    private readonly divider = makeDivider((split) => {
        if (this.painter) this.painter.split = split;
        this.painter?.request(true);
        this.address?.changed();
    });
    private readonly help = makeHelp();
    private contents: Contents | undefined;
    private session!: Session;
    private painter: Painter | undefined;
    private panel: Panel | undefined;
    private tools: Tools | undefined;
    private address: Address | undefined;
    private editor: Editor | undefined;
    private host: EditorHost | undefined;
    private current: Problem[] = [];
    private lost = false;
    private about: unknown; // of the message that is shown
    private silence: ReturnType<typeof setTimeout> | undefined;

    constructor() {
        const { layout } = this;
        layout.picture.append(this.divider.element);
        layout.stage.append(this.timebar.element, this.problems.element);
        layout.app.append(this.help.element);
        layout.chooseTab('controls');
    }

    get element(): HTMLElement {
        return this.layout.app;
    }
    get canvas(): HTMLCanvasElement {
        return this.layout.canvas;
    }

    say(message: string, about?: unknown, seconds = messageSeconds): void {
        if (message === '' && about !== this.about) return;
        this.about = about;
        this.layout.message.textContent = message;
        clearTimeout(this.silence);
        this.silence = setTimeout(() => void (this.layout.message.textContent = ''), 1000 * seconds);
    }

    progress(what: string): void {
        performance.mark(what);
        this.cover(el('p', { role: 'status', class: 'loading' }, what));
    }

    fail(message: string): void {
        this.cover(el('p', { role: 'alert', class: 'failure' }, message));
    }

    private cover(...content: Node[]): void {
        this.layout.cover.replaceChildren(...content);
        this.layout.cover.hidden = content.length === 0;
    }

    async begin(contents: Contents): Promise<void> {
        this.contents = contents;
        const { engine, data, unpacked, checker } = contents;
        const files = new Map([...unpacked.files, ...unpacked.originals]);
        this.host = {
            files: checker ? files : new Map(),
            scene: data?.scene ?? '',
            checker,
            changed: (changed) => this.edited(changed),
            openScene: (name, opened) => void this.openScene(name, opened),
            say: (message) => this.say(message),
        };
        this.session = new Session(engine, {
            redraw: (drag) => this.painter?.request(drag),
            changed: () => this.refresh(),
            listed: () => this.listed(),
            moved: () => this.moved(),
            problems: (problems) => this.showProblems(problems),
            say: (message) => this.say(message),
        });
        this.painter = this.makePainter(engine);
        this.fillPanel(checker !== undefined);
        this.listen();
        if (!data) return this.welcome();
        this.layout.link.href = data.link;
        this.layout.link.hidden = data.link === '';
        await this.openFiles(data.scene, unpacked.files);
        setTimeout(() => this.makeEditor(), 500);
    }

    private makePainter(engine: Engine): Painter {
        return new Painter({
            engine,
            canvas: this.canvas,
            clock: this.clock,
            ready: () => this.session.shown !== undefined && !this.lost,
            drawn: (milliseconds, divisor) => {
                const { width, height } = this.painter!.frame();
                this.layout.status.textContent = `${width} × ${height}, ${milliseconds.toFixed(0)} ms${divisor > 1 ? ', coarser while dragging' : ''}`;
            },
            ticked: () => {
                this.session.move(this.clock.time);
                this.timebar.refresh();
            },
        });
    }

    private fillPanel(files: boolean): void {
        const { layout, session } = this;
        const picture = makePictureDialog({
            engine: session.engine,
            frame: () => this.painter!.frame(),
            name: () => pageName(session.shown?.scene ?? ''),
            say: (message) => this.say(message),
        });
        const actions = {
            resetView: () => this.resetView(),
            fullScreen: () => this.fullScreen(),
            copyLink: () => void this.copyLink(),
            picture: () => session.shown && picture.open(),
            zip: () => (this.editor ? this.editor.download() : saveZip(this.host!.scene, this.host!.files)),
            textWithValues: () => this.say(saveTexts(this.host!.scene, session.engine.saved())),
            help: () => this.help.open(),
        };
        this.tools = makeTools(session, actions, files);
        layout.tools.append(...this.tools.elements);
        this.panel = makePanel(session, this.divider.toggle, (message, about) => this.say(message, about), () => this.clock.time);
        layout.controls.append(this.panel.element);
        layout.app.append(picture.element);
        layout.app.dataset.files = String(files);
        const none = this.contents?.data;
        const has = none && (none.values.length > 0 || none.rungs.length > 0 || none.view !== '');
        this.address = new Address(() => this.settings(), has ? 'initial' : '', () => this.follow());
    }

    private listen(): void {
        const { session } = this;
        const { engine } = session;
        listen(this.canvas, {
            turn: (dx, dy, gesture, begins) => session.changeView(() => engine.turn(dx, dy, begins), gesture),
            move: (dx, dy, gesture, toward) => {
                const { clientWidth, clientHeight } = this.canvas;
                session.changeView(() => engine.move(dx, dy, clientWidth, clientHeight, toward), gesture);
            },
            zoom: (factor, gesture) => session.changeView(() => engine.zoom(factor), gesture),
            reset: () => this.resetView(),
            pointed: (x, y) => this.pointed(x, y),
            end: () => session.history.end(),
        });
        listenForKeys({
            undo: () => session.undo(),
            redo: () => session.redo(),
            resetView: () => this.resetView(),
            fullScreen: () => this.fullScreen(),
            time: () => this.timebar.toggle(),
            help: () => this.help.open(),
        });
        this.canvas.addEventListener('webglcontextlost', (event) => {
            event.preventDefault();
            this.lost = true;
            this.say('The browser took the graphics away. The picture comes back with them.');
        });
        this.canvas.addEventListener('webglcontextrestored', () => {
            this.lost = false;
            const opened = engine.restored();
            session.accept(opened);
            this.say(opened.ok ? 'The graphics are back.' : 'The graphics are back, but the scene cannot be drawn.');
            this.painter?.request();
        });
    }

    private pointed(x: number, y: number): void {
        if (!this.session.shown?.usesMouse || !this.painter) return;
        const { width, height } = this.painter.frame();
        const { clientWidth, clientHeight } = this.canvas;
        this.painter.mouse = [(x * width) / clientWidth, ((clientHeight - y) * height) / clientHeight];
        this.painter.request();
    }

    private resetView(): void {
        if (this.session?.shown) this.session.changeView(() => void this.session.engine.setView(''));
    }

    private fullScreen(): void {
        const change = document.fullscreenElement ? document.exitFullscreen() : this.layout.stage.requestFullscreen();
        change.catch(() => this.say('This browser does not allow full screen here.'));
    }

    private async copyLink(): Promise<void> {
        this.address?.write();
        const copied = await copyText(location.href);
        this.say(copied ? 'The link to this picture is copied.' : 'The browser does not allow copying: copy the address of the page.');
    }

    // What differs from the scene, for the address. Undefined: there is no scene, or one that a link cannot lead to.
    private settings(): Settings | undefined {
        if (!this.session.shown || this.host?.scene !== this.contents?.data?.scene) return undefined;
        const { engine, shown } = this.session;
        const time = shown.animated && !this.clock.playing && this.clock.time > 0 ? this.clock.time : undefined;
        return { values: engine.values(), rungs: engine.rungs(), ranges: this.session.ranges(), view: engine.view(), time, split: this.painter?.split };
    }

    // The address is another one: a link to the same page was followed.
    private follow(): void {
        if (!this.session.shown) return;
        this.session.history.clear();
        this.open(this.host!.scene, location.hash);
    }

    // Opens the scene with what the address says, and else with the values of the page.
    private open(scene: string, fragment: string): void {
        const { session, contents } = this;
        const own = scene === contents?.data?.scene ? contents.data : undefined;
        const given = /^#?$/.test(fragment) ? undefined : fragment.replace(/^#initial$/, '#');
        const { settings, refused } = readFragment(own ? (given ?? '') : '');
        const from = given === undefined && own ? { ...settings, values: own.values, rungs: own.rungs, view: own.view } : settings;
        const { values, rungs, view } = from;
        let opened = session.engine.open(scene, { values, rungs, view, fresh: true, lints: true });
        const settles = values.length + rungs.length + view.length > 0;
        if (settles && !opened.ok && !opened.shown) opened = session.engine.open(scene, { fresh: true, lints: true });
        const vain = settles && opened.shown ? opened.problems.filter(inVain) : [];
        this.accept({ ...opened, problems: opened.problems.filter((problem) => !vain.includes(problem)) }, settings);
        const ranges = opened.shown ? session.setRanges(settings.ranges) : [];
        if (settings.ranges.length > ranges.length) this.panel?.refresh();
        const wrong = [...refused, ...ranges.map(rangeText), ...vain.map(({ message }) => message)];
        if (wrong.length > 0) this.say(complaint(wrong), 'address', longMessageSeconds);
    }

    private accept(opened: Opened, { time, split }: Settings): void {
        const { session, clock } = this;
        session.accept(opened);
        if (!opened.shown) return this.failOpening(opened);
        this.cover();
        const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
        clock.time = time ?? 0;
        clock.playing = opened.shown.animated && time === undefined && !still;
        this.openTime();
        this.divider.set(session.ladders.length > 0 ? split : undefined);
        this.painter?.begin();
    }

    // Time runs for sliders that move by themselves, too.
    private moved(): void {
        const { motions, shown } = this.session;
        const animated = shown?.animated ?? false;
        if (motions.length > 0) this.clock.playing = true;
        else if (!animated) this.clock.playing = false;
        this.openTime();
        this.painter?.request();
        this.refresh();
    }

    private openTime(): void {
        const { motions, shown } = this.session;
        const period = shown?.animated ? shown.period : Math.max(0, ...motions.map((motion) => motion.period));
        this.timebar.open(shown?.animated || motions.length > 0, period);
    }

    private failOpening({ problems }: Opened): void {
        if (this.session.shown) return;
        const errors = problems.filter(({ severity }) => severity === 'error').length;
        this.fail(`The scene has ${errors} ${errors === 1 ? 'error' : 'errors'}. They are listed below.`);
    }

    private async openFiles(scene: string, files: Map<string, Uint8Array>): Promise<void> {
        const { engine, checker } = this.contents!;
        this.progress('Decoding images…');
        const decoded = checker ? await checker.decodeLarge(files) : new Map<string, Uint8Array>();
        this.progress('Compiling…');
        await painted();
        for (const [name, bytes] of files) engine.write(name, decoded.get(name) ?? bytes);
        this.open(scene, location.hash);
        performance.mark('Compiled');
        this.refreshTitle();
    }

    private async openScene(scene: string, files: Map<string, Uint8Array>): Promise<void> {
        const host = this.host!;
        for (const name of host.files.keys()) this.session.engine.remove(name);
        Object.assign(host, { scene, files });
        delete this.layout.app.dataset.scene;
        this.session.forget();
        this.layout.link.hidden = true;
        if (location.hash !== '') history.replaceState(null, '', location.href.replace(/#.*$/, ''));
        await this.openFiles(scene, files);
        this.makeEditor()?.opened();
        this.editor?.show(this.current);
    }

    private edited(files: ReadonlyMap<string, Uint8Array>): void {
        const host = this.host!;
        const { engine } = this.session;
        for (const [name, bytes] of files) {
            host.files.set(name, bytes);
            engine.write(name, bytes);
        }
        const before = this.session.shown;
        const opened = engine.open(host.scene, { lints: true });
        this.session.accept(opened);
        if (!opened.shown) return this.failOpening(opened);
        if (!before) this.cover();
        if (!before || before.animated !== opened.shown.animated) this.clock.playing = opened.shown.animated;
        this.openTime();
        this.refresh();
    }

    private showProblems(problems: Problem[]): void {
        this.current = problems;
        this.problems.show(problems);
        this.editor?.show(problems);
    }

    private welcome(): void {
        const editor = this.makeEditor();
        if (editor) this.cover(editor.welcome);
        this.layout.app.dataset.scene = 'none';
        this.refreshTitle();
    }

    // Made when it is needed, or after the first picture.
    private makeEditor(): Editor | undefined {
        if (this.editor || !this.host?.checker) return this.editor;
        this.editor = makeEditor(this.host);
        this.layout.text.append(this.editor.element);
        if (this.host.scene !== '') this.editor.opened();
        this.editor.show(this.current);
        return this.editor;
    }

    private listed(): void {
        this.panel?.rebuild();
        this.divider.refresh(this.session.ladders);
        this.tools?.refresh();
    }

    private refresh(): void {
        this.panel?.refresh();
        this.divider.refresh(this.session.ladders);
        this.tools?.refresh();
        this.address?.changed();
    }

    private refreshTitle(): void {
        const { data } = this.contents!;
        const own = this.host?.scene === data?.scene ? data?.title : undefined;
        const title = own || pageName(this.host?.scene ?? '');
        document.title = title;
        this.layout.title.textContent = title;
        this.canvas.setAttribute('aria-label', `Picture of ${title}: arrow keys turn it, plus and minus scale it`);
    }
}
