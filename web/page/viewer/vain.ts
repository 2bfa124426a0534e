// What an address asks for in vain, in one message: anyone can have made it.
import type { Problem } from '../engine.ts';

const most = 3;
const longest = 160;

// It is no error of the scene, and has no place in it.
export function inVain({ at, severity }: Problem): boolean {
    return !at && severity === 'error';
}

export function complaint(wrong: readonly string[]): string {
    const list = wrong.slice(0, most).map((text) => (text.length <= longest ? text : `${text.slice(0, longest - 1)}…`));
    const more = wrong.length > most ? `, and ${wrong.length - most} more` : '';
    return `The address asks for what this scene does not have: ${list.join('; ')}${more}.`;
}
