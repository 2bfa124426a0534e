// The scenes that the page has with it (examples.mjs).
import { unpack } from '../archive.ts';

export interface Example {
    scene: string;
    subject: string;
    files: string[];
}

export interface Examples {
    list: Example[];
    // The files of one example, and nothing else.
    open(example: Example): Map<string, Uint8Array>;
}

// Undefined: the page has none.
export async function readExamples(): Promise<Examples | undefined> {
    const block = document.getElementById('examples');
    if (!block?.textContent?.trim()) return undefined;
    const { files } = await unpack(block.textContent);
    const list = JSON.parse(new TextDecoder().decode(files.get('examples.json'))) as Example[];
    // Copies, because all files share the memory of the archive.
    const open = (example: Example) =>
        new Map(example.files.flatMap((name) => {
            const bytes = files.get(name);
            return bytes ? [[name, bytes.slice()] as const] : [];
        }));
    return { list, open };
}

const scene = `##OpenGL GLIB
# A ball. Drag the sliders, or edit this text: the picture follows.

Perspective 50
LookAt 2 1.5 3  0 0 0  0 1 0

Vertex scene.vert
Fragment scene.frag
Program Ball  uColor {.9 .5 .1}  uShine <1. 20. 100.>
Sphere 1
`;

const vertex = `#version 330 compatibility

out vec3 vNormal;
out vec3 vPosition;

void main() {
    vNormal = gl_NormalMatrix * gl_Normal;
    vPosition = vec3(gl_ModelViewMatrix * gl_Vertex);
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
`;

const fragment = `#version 330 compatibility

uniform vec3 uColor;
uniform float uShine;

in vec3 vNormal;
in vec3 vPosition;

const vec3 light = normalize(vec3(.5, .8, 1.));

void main() {
    vec3 normal = normalize(vNormal);
    vec3 halfway = normalize(light - normalize(vPosition));
    float diffuse = max(dot(normal, light), 0.);
    float shine = pow(max(dot(normal, halfway), 0.), uShine);
    gl_FragColor = vec4(uColor * (.2 + .8 * diffuse) + .5 * shine, 1.);
}
`;

export function newScene(): { scene: string; files: Map<string, Uint8Array> } {
    const bytes = (text: string) => new TextEncoder().encode(text);
    return {
        scene: 'scene.glib',
        files: new Map([
            ['scene.glib', bytes(scene)],
            ['scene.vert', bytes(vertex)],
            ['scene.frag', bytes(fragment)],
        ]),
    };
}
