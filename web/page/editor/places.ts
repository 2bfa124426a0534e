// Places of messages in the text of the editor, which counts UTF-16 units.
import type { Place } from '../engine.ts';
import type { Format } from './bytes.ts';

// A character of UTF-8 in text whose bytes are one character each.
const sequence =
    /[\xc2-\xdf][\x80-\xbf]|\xe0[\xa0-\xbf][\x80-\xbf]|\xed[\x80-\x9f][\x80-\xbf]|[\xe1-\xec\xee\xef][\x80-\xbf]{2}|\xf0[\x90-\xbf][\x80-\xbf]{2}|\xf4[\x80-\x8f][\x80-\xbf]{2}|[\xf1-\xf3][\x80-\xbf]{3}|[^]/g;

// The lengths, in UTF-16 units, of what the messages count as one column.
function columns(line: string, bytesOf: (line: string) => string, format: Format): number[] {
    if (format.encoding === 'utf-8') return Array.from(line, (character) => character.length);
    return (bytesOf(line).match(sequence) ?? []).map((bytes) => bytes.length);
}

// Windows-1252 text as a string of characters up to U+00FF, one for each byte.
function binary(line: string): string {
    return line.replace(/[^\x00-\x7f\xa0-\xff]/g, (character) => String.fromCharCode(0x80 + upper.indexOf(character)));
}
const upper = [...new TextDecoder('windows-1252').decode(Uint8Array.from({ length: 32 }, (_, i) => 0x80 + i))];

// The offset in the line of a column, which is moved into the line. Columns begin at 1.
export function offsetOf(line: string, column: number, format: Format): number {
    if (column <= 1) return 0;
    if (/^[\x00-\x7f]*$/.test(line)) return Math.min(column - 1, line.length);
    return columns(line, binary, format)
        .slice(0, column - 1)
        .reduce((sum, length) => sum + length, 0);
}

// The column of an offset in the line.
export function columnOf(line: string, offset: number, format: Format): number {
    let at = 0;
    let column = 1;
    for (const length of columns(line, binary, format)) {
        at += length;
        if (at > offset) break;
        ++column;
    }
    return column;
}

// What the mapping needs of a text of the editor; lines begin at 1.
export interface Lines {
    lines: number;
    line(n: number): { from: number; to: number; text: string };
}

// The range in the text: at least one character where the line has one, so that a mark is seen.
export function rangeOf(place: Place, text: Lines, format: Format): { from: number; to: number } {
    const at = (line: number, column: number) => {
        if (line > text.lines) return text.line(text.lines).to;
        const found = text.line(Math.max(1, line));
        return found.from + offsetOf(found.text, column, format);
    };
    const from = at(place.line, place.column);
    const to = Math.max(from, at(place.endLine, place.endColumn));
    if (to > from) return { from, to };
    const line = text.line(Math.min(Math.max(1, place.line), text.lines));
    if (from < line.to) {
        const next = line.text.codePointAt(from - line.from) ?? 0;
        return { from, to: from + (next > 0xffff ? 2 : 1) };
    }
    const last = line.text.length > 1 && line.text.codePointAt(line.text.length - 2)! > 0xffff ? 2 : 1;
    return from > line.from ? { from: from - last, to: from } : { from, to: from };
}
