// The client of `snell lsp`.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { commands, ViewColumn, window, workspace, Uri, type ExtensionContext } from 'vscode';
import { LanguageClient, type LanguageClientOptions, type ServerOptions } from 'vscode-languageclient/node';
import { sceneFolders, selector, shaderFiles } from './shaders';

let client: LanguageClient | undefined;
let folders = '';

const program = (): string => workspace.getConfiguration('snell').get<string>('path', 'snell');

async function start(): Promise<void> {
    const command = program();
    const shaders = await sceneFolders();
    folders = shaders.join();
    const server: ServerOptions = { command, args: ['lsp'] };
    const options: LanguageClientOptions = {
        documentSelector: selector(shaders),
        synchronize: { fileEvents: [workspace.createFileSystemWatcher('**/*.glib'), workspace.createFileSystemWatcher(shaderFiles)] },
    };
    client = new LanguageClient('snell', 'snell', server, options);
    try {
        await client.start();
    } catch (error) {
        client = undefined;
        const reason = error instanceof Error ? error.message : String(error);
        const set = 'Set the path';
        // Not awaited: the message stays until somebody answers it.
        void window.showErrorMessage(`'${command} lsp' does not start: ${reason}`, set).then((answer) =>
            answer === set ? commands.executeCommand('workbench.action.openSettings', 'snell.path') : undefined,
        );
    }
}

// One after another: many files may appear at once.
let busy: Promise<void> = Promise.resolve();
const inTurn = (what: () => Promise<void>): Promise<void> => (busy = busy.then(what, what));

async function restart(): Promise<void> {
    await client?.dispose();
    client = undefined;
    await start();
}

// A first scene in a folder brings in the shaders of the folder.
async function lookAgain(): Promise<void> {
    if ((await sceneFolders()).join() !== folders) await restart();
}

// Runs snell with the scene of the active editor, after all texts are saved. The process outlives the editor.
async function run(words: string[], done: () => unknown = () => undefined): Promise<void> {
    const scene = window.activeTextEditor?.document;
    if (scene?.languageId !== 'glib' || scene.uri.scheme !== 'file') return;
    await workspace.saveAll(false);
    const fail = (why: string) => void window.showErrorMessage(`${basename(scene.uri.fsPath)}: ${why}`);
    const child = spawn(program(), [...words, '--color', 'never', '--', scene.uri.fsPath], { detached: true, stdio: ['ignore', 'ignore', 'pipe'] });
    let said = '';
    child.stderr.on('data', (some) => (said = (said + String(some)).slice(-16384)));
    child.on('error', (error) => fail(error.message));
    child.on('close', (status) => (status === 0 ? done() : fail(/.*error: .*/.exec(said)?.[0] ?? `snell ended with status ${status}`)));
    child.unref();
}

let pictures = '';

// The picture is shown next to the text.
async function render(): Promise<void> {
    pictures ||= mkdtempSync(join(tmpdir(), 'snell-'));
    const picture = join(pictures, `${basename(window.activeTextEditor?.document.uri.fsPath ?? '', '.glib')}.png`);
    const beside = { viewColumn: ViewColumn.Beside, preserveFocus: true };
    await run(['render', '-o', picture], () => commands.executeCommand('vscode.open', Uri.file(picture), beside));
}

export async function activate(context: ExtensionContext): Promise<void> {
    const scenes = workspace.createFileSystemWatcher('**/*.glib', false, true, true);
    context.subscriptions.push(
        scenes,
        scenes.onDidCreate(() => inTurn(lookAgain)),
        workspace.onDidOpenTextDocument((document) => (document.languageId === 'glib' ? inTurn(lookAgain) : undefined)),
        workspace.onDidChangeWorkspaceFolders(() => inTurn(lookAgain)),
        workspace.onDidChangeConfiguration((change) => (change.affectsConfiguration('snell') ? inTurn(restart) : undefined)),
        commands.registerCommand('snell.openScene', () => run([])),
        commands.registerCommand('snell.renderScene', render),
        { dispose: () => (pictures ? rmSync(pictures, { recursive: true, force: true }) : undefined) },
        commands.registerCommand('snell.restart', () => inTurn(restart)),
    );
    await inTurn(start);
}

export const deactivate = (): Promise<void> | undefined => client?.dispose();
