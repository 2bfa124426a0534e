// The scenes of the repository, and the templates of `snell new`, as a data block of snell.html: an archive as in every
// page, and a list of the scenes.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const root = join(dirname(fileURLToPath(import.meta.url)), '..');
const folder = join(root, 'scenes');
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
function subject(text) {
    const comment = /^(?:##.*\n)?((?:#.*\n)+)/.exec(text.toString('utf8'))?.[1] ?? '';
    const lines = comment.replace(/^#+ ?/gm, '').replace(/\s+/g, ' ').trim();
    return /^.*?[.:](?= |$)/.exec(lines)?.[0].replace(/:$/, '.') ?? lines;
}

// [{ scene, subject, files, template }], the scene to begin with first.
export function exampleList() {
    const files = names();
    const all = new Set(files);
    const scenes = files.filter((name) => name.endsWith('.glib'));
    const included = new Set(scenes.flatMap((scene) => closure(scene, all).filter((name) => name !== scene)));
    return scenes
        .filter((scene) => !included.has(scene))
        .sort((a, b) => Number(b.startsWith('refraction-room/')) - Number(a.startsWith('refraction-room/')) || (a < b ? -1 : 1))
        .map((scene) => ({ scene, subject: subject(contents(scene)), files: closure(scene, all), template: false }));
}

function snell(program, ...options) {
    const { status, stderr } = spawnSync(program, options, { encoding: 'utf8' });
    if (status !== 0) throw new Error(`snell ${options.join(' ')}: ${stderr}`);
}

// As `snell new` writes them into `made`, with their bytes.
function templateList(program, made) {
    rmSync(made, { recursive: true, force: true });
    mkdirSync(made, { recursive: true });
    return readdirSync(join(root, 'templates')).sort().map((kind) => {
        snell(program, 'new', join(made, kind), '--kind', kind);
        const files = readdirSync(join(made, kind), { recursive: true }).map((name) => `${kind}/${name.replaceAll('\\', '/')}`);
        const bytes = new Map(files.filter((name) => statSync(join(made, name)).isFile()).sort().map((name) => [name, readFileSync(join(made, name))]));
        const scene = `${kind}/${kind}.glib`;
        return { scene, subject: subject(bytes.get(scene)), files: [...bytes.keys()], template: true, bytes };
    });
}

// Draws a scene once: as long as its picture is newer than its files.
function picture(program, path, files, to) {
    const newest = Math.max(...files.map((file) => statSync(file).mtimeMs));
    if (!existsSync(to) || statSync(to).mtimeMs < newest) snell(program, 'render', path, '-o', to, '--size', '160x120', '--samples', '4');
    return readFileSync(to);
}

// The element of the page, in place of <script type="text/plain" id="examples"></script>. With the native `program` it
// has pictures, which are kept in the folder `kept`, and templates.
export function examples(program, kept) {
    const made = kept && join(kept, 'new');
    const templates = program ? templateList(program, made) : [];
    const list = [...exampleList(), ...templates];
    const parts = new Map([...new Set(list.flatMap(({ files }) => files))].sort().map((name) => [name, templates.find(({ bytes }) => bytes.has(name))?.bytes.get(name) ?? contents(name)]));
    if (program)
        for (const each of list) {
            each.picture = `pictures/${each.scene.replaceAll('/', '-')}.webp`;
            const from = each.template ? made : folder;
            const own = each.template ? [join(root, 'templates', each.scene.split('/')[0])] : each.files.map((name) => join(from, name));
            parts.set(each.picture, picture(program, join(from, each.scene), own, join(kept, each.picture.replace('pictures/', ''))));
        }
    const all = [['examples.json', Buffer.from(JSON.stringify(list.map(({ bytes, ...each }) => each)))], ...parts];
    const header = JSON.stringify({ files: all.map(([name, bytes]) => ({ name, size: bytes.length, decoded: false })) });
    const archive = Buffer.concat([Buffer.from(`${header}\n`), ...all.map(([, bytes]) => bytes)]);
    const packed = gzipSync(archive, { level: 9 }).toString('base64');
    return `<script type="text/plain" id="examples">${packed}</script>`;
}
