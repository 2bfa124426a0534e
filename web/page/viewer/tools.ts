// The buttons above the panel, and what they save.
import { baseOf } from '../editor/names.ts';
import { saveBytes, saveZip } from '../editor/pack.ts';
import type { Saved } from '../engine.ts';
import { button, el } from '../dom.ts';
import { makeMenu } from './menu.ts';
import type { Session } from './session.ts';

export interface ToolActions {
    resetView(): void;
    fullScreen(): void;
    save(): void;
    scenes(): void;
    copyLink(): void;
    picture(): void;
    zip(): void;
    textWithValues(): void;
    help(): void;
}

export interface Tools {
    elements: HTMLElement[];
    refresh(): void;
}

export function makeTools(session: Session, actions: ToolActions): Tools {
    const undo = button('Undo', () => session.go(false), { title: 'Ctrl+Z' });
    const redo = button('Redo', () => session.go(true), { title: 'Ctrl+Y' });
    const resetAll = button('Reset all', () => session.resetAll());
    const resetView = button('Reset view', actions.resetView, { title: 'R' });
    const save = [
        button('Copy link', actions.copyLink),
        button('Picture as PNG…', actions.picture),
        button('Scene as .zip', actions.zip),
        button('Text with these values', actions.textWithValues),
    ];
    const menu = makeMenu('Save and share', { class: 'menu' }, () => save);
    save.forEach((each) => each.addEventListener('click', menu.close));
    const screen = document.fullscreenEnabled ? [button('Full screen', actions.fullScreen, { title: 'F' })] : [];
    // Of scenes that are from a folder, and of several.
    const live = [button('Save', actions.save, { title: 'Ctrl+S', class: 'of-folder' }), button('Scenes…', actions.scenes, { class: 'of-scenes' })];
    const help = button('?', actions.help, { 'aria-label': 'Help', title: 'Help' });
    const refresh = () => {
        undo.disabled = !session.state.canUndo;
        redo.disabled = !session.state.canRedo;
        resetAll.disabled = !session.shown || !session.anyChanged;
    };
    refresh();
    return { elements: [undo, redo, resetAll, resetView, ...screen, ...live, menu.element, help], refresh };
}

export async function copyText(text: string): Promise<boolean> {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        // Files on a disk have no clipboard in some browsers; a selected text can be copied.
        const area = el('textarea', { 'aria-hidden': 'true', class: 'copied' }, text);
        document.body.append(area);
        area.select();
        const copied = document.execCommand('copy');
        area.remove();
        return copied;
    }
}

// One file as it is, several as an archive. Returns a message.
export function saveTexts(scene: string, { files, unwritten, error }: Saved): string {
    if (error !== '') return error;
    const without = unwritten.slice(0, 3).map((each) => ` Not saved: ${each}.`).join('');
    if (files.length === 0) return without.trim() || 'The values are those of the text.';
    if (files.length === 1) {
        saveBytes(files[0]!.name, files[0]!.bytes);
        return `Saved ${baseOf(files[0]!.name)} with these values.${without}`;
    }
    saveZip(scene, new Map(files.map(({ name, bytes }) => [name, bytes])));
    return `Saved ${files.length} files with these values.${without}`;
}
