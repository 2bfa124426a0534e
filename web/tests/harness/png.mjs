// Pictures as PNG, of 8 bits a channel, as red, green, blue of each pixel, and how alike two are.
import assert from 'node:assert/strict';
import { inflateSync } from 'node:zlib';

function chunks(bytes) {
    const found = {};
    for (let at = 8; at < bytes.length; ) {
        const size = bytes.readUInt32BE(at);
        const kind = bytes.toString('latin1', at + 4, at + 8);
        (found[kind] ??= []).push(bytes.subarray(at + 8, at + 8 + size));
        at += size + 12;
    }
    return found;
}

// The nearest of the neighbours to left + above - corner.
function paeth(left, above, corner) {
    const guess = left + above - corner;
    const [a, b, c] = [left, above, corner].map((each) => Math.abs(guess - each));
    return a <= b && a <= c ? left : b <= c ? above : corner;
}

export function pixelsOf(png) {
    const { IHDR, IDAT } = chunks(png);
    const [width, height] = [IHDR[0].readUInt32BE(0), IHDR[0].readUInt32BE(4)];
    const channels = { 0: 1, 2: 3, 6: 4 }[IHDR[0][9]];
    assert.ok(IHDR[0][8] === 8 && channels && IHDR[0][12] === 0, 'a plain PNG');
    const packed = inflateSync(Buffer.concat(IDAT));
    const row = width * channels;
    const flat = new Uint8Array(row * height);
    for (let y = 0, from = 0; y < height; ++y) {
        const filter = packed[from++];
        for (let x = 0; x < row; ++x, ++from) {
            const at = y * row + x;
            const left = x < channels ? 0 : flat[at - channels];
            const above = y === 0 ? 0 : flat[at - row];
            const corner = x < channels || y === 0 ? 0 : flat[at - row - channels];
            flat[at] = packed[from] + [0, left, above, (left + above) >> 1, paeth(left, above, corner)][filter];
        }
    }
    const pixels = new Uint8Array(width * height * 3);
    for (let i = 0; i < width * height; ++i)
        for (let c = 0; c < 3; ++c) pixels[3 * i + c] = flat[i * channels + (channels < 3 ? 0 : c)];
    return { width, height, pixels };
}

// The share of pixels that differ by more than 2 of 255; the largest difference, and the mean one, of 255.
export function difference(a, b) {
    assert.deepEqual([a.width, a.height], [b.width, b.height]);
    let over = 0;
    let [largest, sum] = [0, 0];
    for (let i = 0; i < a.pixels.length; i += 3) {
        const most = Math.max(...[0, 1, 2].map((c) => Math.abs(a.pixels[i + c] - b.pixels[i + c])));
        largest = Math.max(largest, most);
        sum += most;
        if (most > 2) ++over;
    }
    const count = a.pixels.length / 3;
    return { share: over / count, largest, mean: sum / count };
}

export function colours({ pixels }) {
    const found = new Set();
    for (let i = 0; i < pixels.length; i += 3) found.add((pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2]);
    return found.size;
}
