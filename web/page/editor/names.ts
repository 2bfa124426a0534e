// Names of files from outside: archives, folders and other people.

// A relative name with '/', or why the name is refused. '\' separates folders, as some archives of Windows have it.
export function cleanName(raw: string): { name: string } | { error: string } {
    if (/[\x00-\x1f\x7f]/.test(raw)) return { error: 'its name contains control characters' };
    const slashes = raw.replaceAll('\\', '/').normalize('NFC');
    if (slashes.startsWith('/')) return { error: 'its name is an absolute path' };
    if (/^[a-z]:/i.test(slashes)) return { error: 'its name begins with a drive letter' };
    const parts = slashes.split('/').filter((part) => part !== '' && part !== '.');
    if (parts.includes('..')) return { error: 'its name leads out of the folder' };
    if (parts.length === 0) return { error: 'it has no name' };
    const name = parts.join('/');
    if (parts.length > 32 || name.length > 500) return { error: 'its name is too long' };
    return { name };
}

// What systems and programs leave in folders, which is not part of a scene.
export function isJunk(name: string): boolean {
    return name.split('/').some((part) => part.startsWith('.') || /^(__MACOSX|Thumbs\.db|desktop\.ini)$/i.test(part));
}

// Names that were taken: two that differ only in case are one file on Windows and macOS, and a file cannot be a folder.
export class Names {
    readonly #files = new Set<string>();
    readonly #folders = new Set<string>();

    // The name to use, or why the file is left out; neither for junk.
    clean(raw: string): { name?: string; error?: string } {
        const clean = cleanName(raw);
        if ('error' in clean) return clean;
        if (isJunk(clean.name)) return {};
        const error = this.take(clean.name);
        return error ? { error } : clean;
    }

    // Returns why the name cannot be taken, or ''.
    take(name: string): string {
        const key = name.toLowerCase();
        const folders = key.split('/').slice(0, -1).map((_, i, parts) => parts.slice(0, i + 1).join('/'));
        if (this.#files.has(key)) return 'another file has the same name, or one that differs only in upper and lower case';
        if (this.#folders.has(key)) return 'a folder has the same name';
        if (folders.some((folder) => this.#files.has(folder))) return 'one of its folders has the name of a file';
        this.#files.add(key);
        for (const folder of folders) this.#folders.add(folder);
        return '';
    }
}

export function folderOf(name: string): string {
    return name.slice(0, name.lastIndexOf('/') + 1);
}

export function baseOf(name: string): string {
    return name.slice(name.lastIndexOf('/') + 1);
}

// `name` as a scene in `folder` ("room/") writes it; '..' above the topmost folder stays there, as in a file system.
export function resolve(folder: string, name: string): string {
    const parts: string[] = [];
    for (const part of (folder + name.replaceAll('\\', '/')).split('/')) {
        if (part === '..') parts.pop();
        else if (part !== '' && part !== '.') parts.push(part);
    }
    return parts.join('/');
}

// A file's name as the scene writes it.
export function asWritten(scene: string, name: string): string {
    const folder = scene.split('/').slice(0, -1), parts = name.split('/');
    let same = 0;
    while (same < folder.length && folder[same] === parts[same]) ++same;
    return '../'.repeat(folder.length - same) + parts.slice(same).join('/');
}

// The shortest ends of the names that tell them apart: "ball.frag", but "glass/glass.frag" where there are two.
export function shortNames(names: readonly string[]): Map<string, string> {
    const tail = (name: string, parts: number) => name.split('/').slice(-parts).join('/');
    return new Map(
        names.map((name) => {
            let parts = 1;
            while (tail(name, parts) !== name && names.some((other) => other !== name && tail(other, parts) === tail(name, parts)))
                ++parts;
            return [name, tail(name, parts)];
        }),
    );
}
