// The scenes of the repository as a data block of snell.html: an archive as in every page, and a list of the scenes.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const folder = join(dirname(fileURLToPath(import.meta.url)), '..', 'scenes');
const text = /\.(glib|inc|glsl|vert|frag|geom|tesc|tese)$/;
// What the page decodes itself.
const drawn = /\.(png|jpe?g|bmp|tga|hdr|obj)$/;

function names() {
    return readdirSync(folder, { recursive: true })
        .map((name) => name.replaceAll('\\', '/'))
        .filter((name) => statSync(join(folder, name)).isFile() && (text.test(name) || drawn.test(name)))
        .sort();
}

const contents = (name) => readFileSync(join(folder, name));

// Without comments, every word and every quoted text of a file that names another one.
function named(name, all) {
    const words = contents(name).toString('utf8').replace(/^\s*(\/\/|#(?!\s*include)).*$/gm, '').split(/[\s"<>]+/);
    return words.map((word) => posix.join(posix.dirname(name), word)).filter((path) => all.has(path));
}

function closure(scene, all) {
    const found = new Set([scene]);
    for (const name of found) if (text.test(name)) for (const next of named(name, all)) found.add(next);
    return [...found].sort();
}

// The first sentence of the comment at the beginning.
function subject(scene) {
    const comment = /^(?:##.*\n)?((?:#.*\n)+)/.exec(contents(scene).toString('utf8'))?.[1] ?? '';
    const lines = comment.replace(/^#+ ?/gm, '').replace(/\s+/g, ' ').trim();
    return /^.*?[.:](?= |$)/.exec(lines)?.[0].replace(/:$/, '.') ?? lines;
}

// [{ scene, subject, files }], the scene to begin with first.
export function exampleList() {
    const files = names();
    const all = new Set(files);
    const scenes = files.filter((name) => name.endsWith('.glib'));
    const included = new Set(scenes.flatMap((scene) => closure(scene, all).filter((name) => name !== scene)));
    return scenes
        .filter((scene) => !included.has(scene))
        .sort((a, b) => Number(b.startsWith('refraction-room/')) - Number(a.startsWith('refraction-room/')) || (a < b ? -1 : 1))
        .map((scene) => ({ scene, subject: subject(scene), files: closure(scene, all) }));
}

// The element of the page, in place of <script type="text/plain" id="examples"></script>.
export function examples() {
    const list = exampleList();
    const used = [...new Set(list.flatMap(({ files }) => files))].sort();
    const parts = [['examples.json', Buffer.from(JSON.stringify(list))], ...used.map((name) => [name, contents(name)])];
    const header = JSON.stringify({ files: parts.map(([name, bytes]) => ({ name, size: bytes.length, decoded: false })) });
    const archive = Buffer.concat([Buffer.from(`${header}\n`), ...parts.map(([, bytes]) => bytes)]);
    const packed = gzipSync(archive, { level: 9 }).toString('base64');
    return `<script type="text/plain" id="examples">${packed}</script>`;
}
