// The client of `snell lsp`.
import { CancellationTokenSource, commands, ViewColumn, window, workspace, Uri, type ExtensionContext } from 'vscode';
import {
    LanguageClient,
    type LanguageClientOptions,
    type ServerOptions,
    type ShowDocumentParams,
    type ShowDocumentResult,
} from 'vscode-languageclient/node';
import { sceneFolders, selector, shaderFiles } from './shaders';

let client: LanguageClient | undefined;
let folders = '';

const isPicture = (params: ShowDocumentParams) => /\.(png|jpe?g)$/i.test(params.uri) && !params.external;

// Pictures are shown next to the text, which the protocol's own way cannot do.
async function showPicture(uri: string): Promise<boolean> {
    await commands.executeCommand('vscode.open', Uri.parse(uri), { viewColumn: ViewColumn.Beside, preserveFocus: true });
    return true;
}

async function start(): Promise<void> {
    const command = workspace.getConfiguration('snell').get<string>('path', 'snell');
    const shaders = await sceneFolders();
    folders = shaders.join();
    const server: ServerOptions = { command, args: ['lsp'] };
    const options: LanguageClientOptions = {
        documentSelector: selector(shaders),
        synchronize: { fileEvents: [workspace.createFileSystemWatcher('**/*.glib'), workspace.createFileSystemWatcher(shaderFiles)] },
        middleware: {
            window: {
                showDocument: async (params, next) =>
                    isPicture(params)
                        ? { success: await showPicture(params.uri) }
                        : ((await next(params, new CancellationTokenSource().token)) as ShowDocumentResult),
            },
        },
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

// Asks the server to do something with the scene of the active editor, as its code lenses do.
async function ask(what: string): Promise<void> {
    const editor = window.activeTextEditor;
    if (!editor || !client) return;
    await commands.executeCommand(what, editor.document.uri.toString(), editor.selection.active.line);
}

export async function activate(context: ExtensionContext): Promise<void> {
    const scenes = workspace.createFileSystemWatcher('**/*.glib', false, true, true);
    context.subscriptions.push(
        scenes,
        scenes.onDidCreate(() => inTurn(lookAgain)),
        workspace.onDidOpenTextDocument((document) => (document.languageId === 'glib' ? inTurn(lookAgain) : undefined)),
        workspace.onDidChangeWorkspaceFolders(() => inTurn(lookAgain)),
        workspace.onDidChangeConfiguration((change) => (change.affectsConfiguration('snell') ? inTurn(restart) : undefined)),
        commands.registerCommand('snell.openScene', () => ask('snell.open')),
        commands.registerCommand('snell.renderScene', () => ask('snell.render')),
        commands.registerCommand('snell.sceneCost', () => ask('snell.cost')),
        commands.registerCommand('snell.restart', () => inTurn(restart)),
    );
    await inTurn(start);
}

export const deactivate = (): Promise<void> | undefined => client?.dispose();
