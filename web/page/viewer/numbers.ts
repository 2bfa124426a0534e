// Formats and parses the numbers of sliders, by the window's rules (docs/window.md).

const largestFloat = 3.4028234663852886e38;

function clamp(value: number, min: number, max: number): number {
    return Math.min(Math.max(value, min), max);
}

function digitsBefore(range: number): number {
    return Math.ceil(Math.log10(range) - 1e-9);
}

// With as many decimals as a thousandth of the range needs, but at least four for ranges of about 1.
export function shown(value: number, min: number, max: number, integral: boolean): string {
    if (integral) return value.toFixed(0);
    const range = Math.max(max - min, 0);
    const size = Math.max(Math.abs(value), range);
    if (!(size < 1e7) || !Number.isFinite(range)) return String(Number(value.toPrecision(6)));
    if (range <= 0) return String(Number(value.toPrecision(7)));
    const digits = digitsBefore(range);
    const decimals = digits <= 0 ? 4 - digits : 5 - digits;
    if (decimals > 9) return value.toExponential(4);
    return value.toFixed(clamp(decimals, 1, 9));
}

// Rounds a dragged value to the decimals that are shown (two more if `fine`), so that a saved number is short.
export function tidy(value: number, min: number, max: number, fine: boolean): number {
    const range = max - min;
    if (!(range > 0) || !Number.isFinite(range) || range > 1e7) return value;
    const digits = digitsBefore(range);
    const decimals = (digits <= 0 ? 4 - digits : Math.max(5 - digits, 1)) + (fine ? 2 : 0);
    if (decimals > 15) return value;
    return clamp(Number(value.toFixed(decimals)), min, max);
}

// The fewest decimals that give the same byte.
export function tidyColor(value: number): number {
    if (!(value >= 0 && value <= 1)) return Number(value.toFixed(3));
    for (let count = 0; count < 3; ++count)
        if (Math.round(255 * Number(value.toFixed(count))) === Math.round(255 * value)) return Number(value.toFixed(count));
    return Number(value.toFixed(3));
}

// Reads sums of products of numbers, signs and parentheses. A failure makes the result NaN.
class Evaluator {
    constructor(private rest: string) {}

    run(): number {
        const value = this.sum(0);
        return this.rest.trimStart() === '' ? value : NaN;
    }

    private take(word: string): boolean {
        this.rest = this.rest.trimStart();
        if (!this.rest.startsWith(word)) return false;
        this.rest = this.rest.slice(word.length);
        return true;
    }

    private sum(depth: number): number {
        let value = this.product(depth);
        for (;;) {
            if (this.take('+')) value += this.product(depth);
            else if (this.take('-')) value -= this.product(depth);
            else return value;
        }
    }

    private product(depth: number): number {
        let value = this.factor(depth);
        for (;;) {
            if (this.take('*')) value *= this.factor(depth);
            else if (this.take('/')) value /= this.factor(depth);
            else return value;
        }
    }

    private factor(depth: number): number {
        if (this.take('-')) return -this.operand(depth);
        this.take('+');
        return this.operand(depth);
    }

    private operand(depth: number): number {
        if (this.take('pi')) return Math.PI;
        if (!this.take('(')) return this.number();
        if (depth > 200) return NaN;
        const value = this.sum(depth + 1);
        return this.take(')') ? value : NaN;
    }

    private number(): number {
        const found = /^(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?/.exec(this.rest.trimStart());
        if (!found) return NaN;
        this.rest = this.rest.trimStart().slice(found[0].length);
        return Number(found[0].replace(',', '.'));
    }
}

// Ends "is not a number" for a text that typed() does not take: " that fits" if it is one.
export function whyNot(text: string): string {
    const written = Number(text.trim().replace(',', '.') || NaN);
    return evaluated(text) !== undefined || !Number.isNaN(written) ? ' that fits' : '';
}

// The value of a text such as "1/3", "2*pi", "-(1e3-5)" or "0,7"; undefined if it is not a finite number.
export function evaluated(text: string): number | undefined {
    const value = new Evaluator(text.slice(0, 1000)).run();
    return Number.isFinite(value) ? value : undefined;
}

// The value that a control of this type can have; undefined if it does not fit.
export function fitting(value: number, type: string): number | undefined {
    if (!Number.isFinite(value)) return undefined;
    if (type === 'bool') return value === 0 ? 0 : 1;
    if (type === 'int' || type === 'uint') {
        const whole = Math.round(value) + 0;
        if (type === 'uint') return whole >= 0 && whole <= 0xffffffff ? whole : undefined;
        return whole >= -0x80000000 && whole <= 0x7fffffff ? whole : undefined;
    }
    return Math.abs(value) <= largestFloat ? value : undefined;
}

export function typed(text: string, type: string): number | undefined {
    const value = evaluated(text);
    return value === undefined ? undefined : fitting(value, type);
}
