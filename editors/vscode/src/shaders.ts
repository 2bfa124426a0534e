// Which shaders belong to snell: those in folders that have scenes. Other extensions keep the rest.
import { RelativePattern, Uri, workspace } from 'vscode';
import type { DocumentSelector } from 'vscode-languageclient/node';

export const shaderFiles = '**/*.{vert,frag,geom,tesc,tese,tcs,tes,vs,fs,gs,glsl}';

// The folders of the workspace that have a scene, and those of open scenes outside of it.
export async function sceneFolders(): Promise<Uri[]> {
    const found: Uri[] = [];
    for (const folder of workspace.workspaceFolders ?? []) {
        const scenes = await workspace.findFiles(new RelativePattern(folder, '**/*.glib'), undefined, 1);
        if (scenes.length > 0 && workspace.getConfiguration('snell', folder).get<boolean>('shaders', true)) found.push(folder.uri);
    }
    for (const document of workspace.textDocuments)
        if (document.languageId === 'glib' && document.uri.scheme === 'file' && !workspace.getWorkspaceFolder(document.uri))
            found.push(Uri.joinPath(document.uri, '..'));
    return found;
}

// The text of a glob that means only itself.
const literal = (path: string) => path.replace(/[[\]{}*?\\]/g, (character) => `[${character}]`);

export function selector(folders: Uri[]): DocumentSelector {
    return [
        { scheme: 'file', language: 'glib' },
        ...folders.map((folder) => ({ scheme: 'file', pattern: `${literal(folder.fsPath.replace(/\\/g, '/'))}/${shaderFiles}` })),
    ];
}
