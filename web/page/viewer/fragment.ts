// The page's state in the address: "#Glass.uEta=4&Glass.uEta:range=1,5&FRESNEL=exact&view=rotate_y=20&time=1.5".

export interface Settings {
    values: string[];
    rungs: string[];
    // As values, with the minimum and the maximum.
    ranges: string[];
    view: string;
    // Undefined: the scene's own.
    time?: number;
    split?: number;
}

const longest = 20_000;
const mostParts = 2_000;
// After the name of a value whose range is not the scene's.
const rangeEnd = ':range';

// Keeps what a reader of the address recognises.
function encoded(text: string): string {
    return encodeURIComponent(text).replace(/%(2C|3A|2F)/g, decodeURIComponent);
}

// The first '=' ends the name; others are as they are.
function assigned(text: string): string {
    return encoded(text).replaceAll('%3D', '=');
}

function ranged(assignment: string): string {
    const at = assignment.indexOf('=');
    return `${encoded(assignment.slice(0, at))}${rangeEnd}=${encoded(assignment.slice(at + 1))}`;
}

export function fragmentOf({ values, rungs, ranges, view, time, split }: Settings): string {
    const parts = [...values.map(assigned), ...ranges.map(ranged), ...rungs.map(assigned)];
    if (view !== '') parts.push(`view=${assigned(view)}`);
    if (time !== undefined) parts.push(`time=${Number(time.toFixed(3))}`);
    if (split !== undefined) parts.push(`split=${Number(split.toFixed(3))}`);
    return parts.join('&');
}

function decoded(text: string): string | undefined {
    try {
        return decodeURIComponent(text);
    } catch {
        return undefined;
    }
}

function amount(text: string, min: number, max: number): number | undefined {
    const value = text === '' ? NaN : Number(text);
    return value >= min && value <= max ? value : undefined;
}

// Takes what one part says. Returns false if it says nothing.
function take(settings: Settings, key: string, value: string): boolean {
    if (key === 'view') {
        settings.view = value;
        return true;
    }
    if (key === 'time') return (settings.time = amount(value, 0, 1e6)) !== undefined;
    if (key === 'split') return (settings.split = amount(value, 0, 1)) !== undefined;
    // Values are named with their program; ladders have no dot.
    if (key.endsWith(rangeEnd)) settings.ranges.push(`${key.slice(0, -rangeEnd.length)}=${value}`);
    else if (key.includes('.')) settings.values.push(`${key}=${value}`);
    else settings.rungs.push(`${key}=${value}`);
    return true;
}

const sign = /[\u0000-\u001f\u007f]/;

// Anyone can have made the address: what is no setting is left out, and named.
export function readFragment(fragment: string): { settings: Settings; refused: string[] } {
    const settings: Settings = { values: [], rungs: [], ranges: [], view: '' };
    const refused: string[] = [];
    const text = fragment.replace(/^#/, '');
    if (text.length > longest) return { settings, refused: ['an address that is too long'] };
    for (const piece of text.split('&').slice(0, mostParts)) {
        if (piece === '') continue;
        const at = piece.indexOf('=');
        const key = decoded(piece.slice(0, Math.max(at, 0)));
        const value = decoded(piece.slice(at + 1));
        const fits = at > 0 && key && value && !sign.test(key) && !sign.test(value);
        if (!fits || !take(settings, key, value)) refused.push(piece.slice(0, 60));
    }
    return { settings, refused };
}
