// The page: its parts, and how they work together.
import type { Unpacked } from '../archive.ts';
import type { WorkerChecker } from '../editor/checker.ts';
import { isScene } from '../editor/code.ts';
import { makeEditor } from '../editor/editor.ts';
import type { Folder } from '../editor/folder.ts';
import type { Editor, EditorHost } from '../editor/host.ts';
import { baseOf, resolve } from '../editor/names.ts';
import { saveZip } from '../editor/pack.ts';
import type { Engine, Opened, Problem } from '../engine.ts';
import { all, drop, put } from '../store.ts';
import { Address } from './address.ts';
import { Clock, makeTimeBar } from './clock.ts';
import { makeHelp, makePictureDialog } from './dialogs.ts';
import { makeDivider } from './divider.ts';
import { ask } from '../dialog.ts';
import { button, canvasOf, el, painted, stored } from '../dom.ts';
import { fragmentOf, readFragment, type Settings } from './fragment.ts';
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
    checker: WorkerChecker;
    data: SceneData | undefined;
    unpacked: Unpacked;
}

const messageSeconds = 6;
// Of a message that many read who did not expect it.
const longMessageSeconds = 10;

function pageName(scene: string): string {
    return baseOf(scene).replace(/\.glib$/i, '') || 'snell';
}

const picturesFolder = 'snell-pictures';
const pictureSize = [160, 120] as const;
const mostFolders = 8;
// Of this tab, so that it shows the same folder after it was loaded again.
const folderKey = 'snell-folder';

// Remembers the folder for other visits.
async function keepFolder(folder: Folder | undefined, scene: string): Promise<void> {
    stored(() => sessionStorage.removeItem(folderKey));
    if (!folder) return;
    const { handle } = folder;
    const kept = await all('folders');
    let id = `${Date.now()} ${Math.random()}`;
    for (const each of kept) if (await handle.isSameEntry(each.handle).catch(() => false)) id = each.id;
    for (const each of kept.filter((other) => other.id !== id).slice(mostFolders - 1)) await drop('folders', each.id);
    if (await put('folders', { id, handle, when: Date.now(), scene })) stored(() => sessionStorage.setItem(folderKey, id));
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
    // A button of the mouse, or a finger, is down.
    private pressed = false;
    private dead = false;
    // The folder that is opened next was open before a reload: the address has its values.
    private returns = false;
    // The scene is the page's own, not one that was opened in it.
    private own = true;
    // Settings of the other scenes of the folder, as they were left.
    private readonly left = new Map<string, string>();
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
            files,
            scene: data?.scene ?? '',
            place: `${location.origin}${location.pathname}\n${data?.scene ?? ''}`,
            checker,
            changed: (changed, gone) => this.edited(changed, gone),
            openScene: (name, opened, folder) => this.openScene(name, opened, folder),
            used: () => this.session.shown?.files.map((name) => resolve('', name)) ?? [],
            saved: () => engine.saved(),
            pictures: (some) => this.pictures(some),
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
        this.fillPanel();
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
            drawn: (milliseconds, coarse) => {
                const { width, height } = this.painter!.frame();
                this.layout.status.textContent = `${width} × ${height}, ${milliseconds.toFixed(0)} ms${coarse ? ', coarser' : ''}`;
            },
            costs: (costs) => this.showProblems([...this.current, ...costs]),
            goesOn: (milliseconds, helps, signal) => this.goesOn(milliseconds, helps, signal),
            ticked: () => {
                this.session.move(this.clock.time);
                this.timebar.refresh();
            },
        });
    }

    private fillPanel(): void {
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
            save: () => this.makeEditor()?.save(),
            scenes: () => this.makeEditor()?.scenes(),
            zip: () => (this.editor ? this.editor.download() : saveZip(this.host!.scene, this.host!.files)),
            textWithValues: () => this.say(saveTexts(this.host!.scene, session.engine.saved())),
            help: () => this.help.open(),
        };
        this.tools = makeTools(session, actions);
        layout.tools.append(...this.tools.elements);
        this.panel = makePanel(session, this.divider.toggle, (message, about) => this.say(message, about), () => this.clock.time);
        layout.controls.append(this.panel.element);
        layout.app.append(picture.element);
        const none = this.contents?.data;
        const has = none && (none.values.length > 0 || none.rungs.length > 0 || none.view !== '');
        this.address = new Address(() => (this.addressed ? this.settings() : undefined), has ? 'initial' : '', () => this.follow());
    }

    private listen(): void {
        const { session } = this;
        const { engine } = session;
        listen(this.canvas, {
            turn: (dx, dy, gesture, begins) => session.change(() => engine.turn(dx, dy, begins), gesture),
            move: (dx, dy, gesture, toward) => {
                const { clientWidth, clientHeight } = this.canvas;
                session.change(() => engine.move(dx, dy, clientWidth, clientHeight, toward), gesture);
            },
            zoom: (factor, gesture) => session.change(() => engine.zoom(factor), gesture),
            reset: () => this.resetView(),
            pointed: (x, y) => this.pointed(x, y),
            end: () => session.end(),
        });
        listenForKeys({
            undo: () => session.go(false),
            redo: () => session.go(true),
            resetView: () => this.resetView(),
            fullScreen: () => this.fullScreen(),
            time: () => this.timebar.toggle(),
            help: () => this.help.open(),
            save: () => {
                if (this.host?.folder) this.editor?.save();
                return this.host?.folder !== undefined;
            },
        });
        for (const type of ['pointerdown', 'pointerup', 'pointercancel']) addEventListener(type, () => void (this.pressed = type === 'pointerdown'), true);
        let drawing = false;
        this.canvas.addEventListener('webglcontextlost', (event) => {
            event.preventDefault();
            drawing = this.painter?.busy ?? false;
            this.lost = true;
            this.painter?.withdraw();
            if (!this.dead) this.say('The browser took the graphics away. The picture comes back with them.', 'graphics');
        });
        this.canvas.addEventListener('webglcontextrestored', () => void this.restored(drawing));
    }

    // A picture that took too long is a reason to take the graphics away: it is not drawn again unasked.
    private async restored(drawing: boolean): Promise<void> {
        if (this.dead) return this.started();
        const text = 'The browser took the graphics away while a picture was drawn. Perhaps it took too long.';
        const choices = [{ text: 'Draw it small', value: true }, { text: 'Do not draw it', value: false }];
        if (drawing && !(await ask('The graphics are back', text, choices))) return;
        this.lost = false;
        const opened = this.session.engine.restored();
        this.session.accept({ ...opened, problems: opened.ok ? this.current : opened.problems });
        this.say(opened.ok ? 'The graphics are back.' : 'The graphics are back, but the scene cannot be drawn.', 'graphics');
        if (drawing) this.painter?.begin(true);
        else this.painter?.request();
    }

    private async goesOn(milliseconds: number, helps: boolean, signal: AbortSignal): Promise<boolean | undefined> {
        const seconds = `${Math.max(Math.round(milliseconds / 1000), 1)} s`;
        // A dialog would end a drag: it waits until that has ended, and may be in vain then.
        this.layout.status.textContent = `not drawn: it may take ${seconds}`;
        while (this.pressed && !signal.aborted) await new Promise((later) => setTimeout(later, 50));
        if (signal.aborted) return undefined;
        const text = `A picture of it may take about ${seconds}, in which the page does not answer.`;
        const choices = [{ text: 'Draw it', value: true }];
        if (helps) choices.push({ text: 'Keep it small', value: false });
        const answer = await ask('This scene takes long', text, choices, signal);
        if (signal.aborted) return answer;
        this.layout.status.textContent = answer === undefined ? `not drawn: it may take ${seconds}` : answer ? 'drawing…' : '';
        // The page shows it before it stands still.
        if (answer) await new Promise((shown) => requestAnimationFrame(() => setTimeout(shown)));
        return answer;
    }

    // The texts can be edited and saved without the program, and the next edit starts it again.
    crashed(why: string): void {
        if (this.dead) return;
        this.dead = this.lost = true;
        const reason = /memory|alloc|Aborted/i.test(why) ? 'It may have needed more memory than the browser gives.' : why;
        const text = `The program that draws has ended. ${reason} The texts can still be edited, saved and downloaded.`;
        this.cover(el('p', { role: 'alert', class: 'failure' }, text), button('Start again', () => void this.startAgain()));
        setTimeout(() => this.makeEditor());
    }

    // Graphics that come back have nothing of the program before.
    private async startAgain(): Promise<void> {
        const { engine } = this.session;
        this.progress('Starting…');
        await engine.restart();
        const lose = this.canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context');
        lose?.loseContext();
        await new Promise((resolve) => setTimeout(resolve, 100));
        lose?.restoreContext();
    }

    private async started(): Promise<void> {
        this.dead = this.lost = false;
        const error = await this.session.engine.start(this.canvas);
        if (error !== '') return this.fail(`There is no picture: ${error}`);
        await this.openFiles(this.host!.scene, this.host!.files);
        this.editor?.show(this.current);
    }

    private pointed(x: number, y: number): void {
        if (!this.session.shown?.usesMouse || !this.painter) return;
        const { width, height } = this.painter.frame();
        const { clientWidth, clientHeight } = this.canvas;
        this.painter.mouse = [(x * width) / clientWidth, ((clientHeight - y) * height) / clientHeight];
        this.painter.request();
    }

    private resetView(): void {
        if (this.session?.shown) this.session.change(() => void this.session.engine.setView(''));
    }

    private fullScreen(): void {
        const change = document.fullscreenElement ? document.exitFullscreen() : this.layout.stage.requestFullscreen();
        change.catch(() => this.say('This browser does not allow full screen here.'));
    }

    private async copyLink(): Promise<void> {
        if (!this.own) return this.say('A link leads to no files that were opened here: send the scene as .zip, or make a page of it by snell web.');
        this.address?.write();
        const edited = this.editor?.edited() ?? [];
        const without = edited.length > 0 ? ` It leads to the texts without the edits of ${edited.map((name) => `'${name}'`).join(', ')}.` : '';
        const copied = await copyText(location.href);
        this.say(copied ? `The link to this picture is copied.${without}` : 'The browser does not allow copying: copy the address of the page.');
    }

    // What differs from the scene, for the address. Undefined: there is no scene.
    private settings(): Settings | undefined {
        if (this.dead || !this.session.shown) return undefined;
        const { shown } = this.session;
        const { values, rungs, ranges, view } = this.session.engine.state();
        const time = shown.animated && !this.clock.playing && this.clock.time > 0 ? this.clock.time : undefined;
        return { values, rungs, ranges, view, time, split: this.painter?.split };
    }

    // The page's own scene, or that of a folder, which is open again after a reload.
    private get addressed(): boolean {
        return this.own || this.host?.folder !== undefined;
    }

    // The address is another one: a link to the same page was followed.
    private follow(): void {
        if (!this.session.shown) return;
        this.open(this.host!.scene, location.hash);
    }

    // Opens the scene with what the address says, and else with the values of the page.
    private open(scene: string, fragment: string): void {
        const { session, contents } = this;
        const own = this.own ? contents?.data : undefined;
        const given = /^#?$/.test(fragment) ? undefined : fragment.replace(/^#initial$/, '#');
        const { settings, refused } = readFragment(given ?? '');
        const from = given === undefined && own ? { ...settings, values: own.values, rungs: own.rungs, view: own.view } : settings;
        const { values, rungs, ranges, view } = from;
        let opened = session.engine.open(scene, { values, rungs, ranges, view, fresh: true, lints: true });
        const settles = values.length + rungs.length + ranges.length + view.length > 0;
        if (settles && !opened.ok && !opened.shown) opened = session.engine.open(scene, { fresh: true, lints: true });
        const vain = settles && opened.shown ? opened.problems.filter(inVain) : [];
        this.accept({ ...opened, problems: opened.problems.filter((problem) => !vain.includes(problem)) }, settings);
        const wrong = [...refused, ...vain.map(({ message }) => message)];
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
        this.painter?.begin(opened.shown.longLoops);
    }

    // Time runs for sliders that move by themselves, too.
    private moved(): void {
        const { periods, shown } = this.session;
        const animated = shown?.animated ?? false;
        if (periods.length > 0) this.clock.playing = true;
        else if (!animated) this.clock.playing = false;
        this.openTime();
        this.painter?.request();
        this.refresh();
    }

    private openTime(): void {
        const { periods, shown } = this.session;
        const period = shown?.animated ? shown.period : Math.max(0, ...periods);
        this.timebar.open(shown?.animated || periods.length > 0, period);
    }

    private failOpening({ problems }: Opened): void {
        if (this.session.shown) return;
        const errors = problems.filter(({ severity }) => severity === 'error').length;
        this.fail(`The scene has ${errors} ${errors === 1 ? 'error' : 'errors'}. They are listed below.`);
    }

    private async openFiles(scene: string, files: Map<string, Uint8Array>, fragment = this.addressed ? location.hash : ''): Promise<void> {
        const { engine, checker } = this.contents!;
        this.progress('Decoding images…');
        const decoded = await checker.decodeLarge(files);
        this.progress('Compiling…');
        await painted();
        for (const [name, bytes] of files) engine.write(name, decoded.get(name) ?? bytes);
        this.open(scene, fragment);
        performance.mark('Compiled');
        this.refreshTitle();
    }

    private async openScene(scene: string, files: Map<string, Uint8Array>, folder?: Folder): Promise<void> {
        const host = this.host!;
        const settings = this.settings();
        if (files !== host.files) this.left.clear();
        else if (settings) this.left.set(host.scene, fragmentOf(settings));
        for (const name of host.files.keys()) this.session.engine.remove(name);
        const place = `${folder ? 'folder' : 'files'}\n${scene}`;
        Object.assign(host, { scene, files: new Map(files), folder, place });
        void keepFolder(folder, scene);
        delete this.layout.app.dataset.scene;
        this.own = false;
        this.session.forget();
        this.layout.link.hidden = true;
        this.layout.app.dataset.folder = String(folder !== undefined);
        this.layout.app.dataset.scenes = String([...files.keys()].filter(isScene).length > 1);
        if (location.hash !== '' && !this.returns) history.replaceState(null, '', location.href.replace(/#.*$/, ''));
        const fragment = this.left.get(scene) ?? (this.returns ? location.hash : '');
        this.returns = false;
        await this.openFiles(scene, files, fragment);
        this.makeEditor()?.opened();
        this.editor?.show(this.current);
    }

    // Small pictures are drawn of copies of the files, next to those of the scene that is shown.
    private pictures(files: ReadonlyMap<string, Uint8Array>): ReturnType<EditorHost['pictures']> {
        const { engine } = this.session;
        const apart = (name: string) => `${picturesFolder}/${name}`;
        for (const [name, bytes] of files) engine.write(apart(name), bytes);
        const of = (scene: string) => {
            const pixels = engine.preview(apart(scene), ...pictureSize);
            return typeof pixels === 'string' ? pixels : canvasOf(pixels, ...pictureSize);
        };
        return { of, end: () => [...files.keys()].forEach((name) => engine.remove(apart(name))) };
    }

    private edited(files: ReadonlyMap<string, Uint8Array>, gone: readonly string[] = []): void {
        const host = this.host!;
        const { engine } = this.session;
        if (this.dead) {
            for (const [name, bytes] of files) host.files.set(name, bytes);
            return void this.startAgain();
        }
        for (const name of gone) {
            host.files.delete(name);
            engine.remove(name);
        }
        for (const [name, bytes] of files) {
            host.files.set(name, bytes);
            engine.write(name, bytes);
        }
        const before = this.session.shown;
        const opened = engine.open(host.scene, { lints: true });
        this.session.accept(opened);
        if (!opened.shown) return this.failOpening(opened);
        if (!before || !this.layout.cover.hidden) this.cover();
        this.painter?.edited(opened.shown.longLoops);
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
        void this.again();
    }

    // After a reload, the folder that was open is open again.
    private async again(): Promise<void> {
        const id = stored(() => sessionStorage.getItem(folderKey));
        const kept = id ? (await all('folders')).find((each) => each.id === id) : undefined;
        if (kept && (await kept.handle.queryPermission?.({ mode: 'read' })) === 'granted') {
            this.returns = true;
            this.editor?.openKept(kept);
        }
    }

    // Made when it is needed, or after the first picture.
    private makeEditor(): Editor | undefined {
        if (this.editor || !this.host) return this.editor;
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
        this.say('', 'graphics');
        this.panel?.refresh();
        this.divider.refresh(this.session.ladders);
        this.tools?.refresh();
        this.address?.changed();
    }

    private refreshTitle(): void {
        const { data } = this.contents!;
        const title = (this.own && data?.title) || pageName(this.host?.scene ?? '');
        document.title = title;
        this.layout.title.textContent = title;
        this.canvas.setAttribute('aria-label', `Picture of ${title}: arrow keys turn it, plus and minus scale it`);
    }
}
