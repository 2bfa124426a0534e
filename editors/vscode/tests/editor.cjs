// As much of VS Code as vscode-languageclient needs, without a window: documents, events, what extensions register, and
// what they show. The library itself and the extension are the real ones.
const Module = require('node:module');
const { readFileSync, writeFileSync } = require('node:fs');
const { basename } = require('node:path');
const minimatch = require('minimatch');
const { URI, Utils } = require('vscode-uri');

class EventEmitter {
    listeners = new Set();
    event = (listener, self, disposables) => {
        const call = self ? listener.bind(self) : listener;
        this.listeners.add(call);
        const disposable = new Disposable(() => this.listeners.delete(call));
        disposables?.push(disposable);
        return disposable;
    };
    fire(value) {
        for (const listener of [...this.listeners]) listener(value);
    }
    dispose() {
        this.listeners.clear();
    }
}

class Disposable {
    constructor(dispose) {
        this.dispose = dispose ?? (() => {});
    }
    static from(...all) {
        return new Disposable(() => all.forEach((one) => one.dispose()));
    }
}

class CancellationTokenSource {
    cancelled = new EventEmitter();
    token = { isCancellationRequested: false, onCancellationRequested: this.cancelled.event };
    cancel() {
        this.token.isCancellationRequested = true;
        this.cancelled.fire();
    }
    dispose() {}
}

// A class whose arguments become fields.
const record = (...fields) =>
    class {
        constructor(...values) {
            fields.forEach((field, i) => (this[field] = values[i]));
        }
    };

class Position extends record('line', 'character') {}
class Range {
    constructor(a, b, c, d) {
        [this.start, this.end] = typeof a === 'number' ? [new Position(a, b), new Position(c, d)] : [a, b];
    }
}
class TextEdit extends record('range', 'newText') {
    static replace = (range, text) => new TextEdit(range, text);
}
class WorkspaceEdit {
    edits = new Map();
    set(uri, edits) {
        this.edits.set(uri.toString(), edits);
    }
    entries() {
        return [...this.edits].map(([uri, edits]) => [URI.parse(uri), edits]);
    }
}
class CodeActionKind {
    constructor(value) {
        this.value = value;
    }
    append = (part) => new CodeActionKind(this.value ? `${this.value}.${part}` : part);
}
for (const name of ['Empty', 'QuickFix', 'Refactor', 'Source']) CodeActionKind[name] = new CodeActionKind(name.toLowerCase());

class Document {
    version = 1;
    isClosed = false;
    constructor(path, languageId) {
        this.uri = URI.file(path);
        this.fileName = path;
        this.languageId = languageId;
        this.text = readFileSync(path, 'utf8');
    }
    getText(range) {
        return range ? this.text.slice(this.offsetAt(range.start), this.offsetAt(range.end)) : this.text;
    }
    offsetAt({ line, character }) {
        let at = 0;
        while (line-- > 0) at = this.text.indexOf('\n', at) + 1;
        return at + character;
    }
    positionAt(offset) {
        const before = this.text.slice(0, offset);
        return new Position(before.split('\n').length - 1, offset - (before.lastIndexOf('\n') + 1));
    }
    // The place of a word.
    find(word, behind = 0) {
        return this.positionAt(this.text.indexOf(word) + behind);
    }
}

function matches(selector, document) {
    const filters = [selector].flat().map((filter) => (typeof filter === 'string' ? { language: filter } : filter));
    return filters.some(
        ({ language, scheme, pattern }) =>
            (!language || language === document.languageId) &&
            (!scheme || scheme === document.uri.scheme) &&
            (!pattern || minimatch(document.uri.fsPath, typeof pattern === 'string' ? pattern : `${pattern.baseUri.fsPath}/${pattern.pattern}`)),
    );
}

// An editor with one folder open; `settings` are those of `snell`.
function createEditor(folder, settings, findFiles) {
    const emitters = {};
    const on = (name) => (emitters[name] ??= new EventEmitter()).event;
    const editor = { documents: [], providers: {}, diagnostics: new Map(), commands: new Map(), opened: [], messages: [] };
    const say = async (message) => void editor.messages.push(message);
    const channel = { name: '', append() {}, appendLine() {}, replace() {}, clear() {}, show() {}, hide() {}, dispose() {} };
    const configuration = { get: (key, value) => settings[key] ?? value, has: (key) => key in settings, inspect: () => undefined, update: async () => {} };
    const watcher = () => ({ onDidCreate: on('created'), onDidChange: on('changed'), onDidDelete: on('deleted'), dispose() {} });
    const register = (kind) => (selector, provider) => {
        (editor.providers[kind] ??= []).push({ selector, provider });
        return new Disposable(() => {});
    };
    const workspaceFolders = [{ uri: URI.file(folder), name: basename(folder), index: 0 }];
    const known = {
        version: '1.82.0',
        Uri: Object.assign(URI, { joinPath: Utils.joinPath }),
        EventEmitter, Disposable, CancellationTokenSource, Position, Range, TextEdit, WorkspaceEdit, CodeActionKind,
        Selection: Range,
        Location: record('uri', 'range'),
        Diagnostic: record('range', 'message', 'severity'),
        DiagnosticRelatedInformation: record('location', 'message'),
        DiagnosticSeverity: { Error: 0, Warning: 1, Information: 2, Hint: 3 },
        DiagnosticTag: { Unnecessary: 1, Deprecated: 2 },
        CompletionItem: record('label', 'kind'),
        CompletionList: record('items', 'isIncomplete'),
        CompletionItemKind: {}, CompletionItemTag: {}, CompletionTriggerKind: { Invoke: 0 },
        CodeAction: record('title', 'kind'), CodeActionTriggerKind: { Invoke: 1, Automatic: 2 },
        CodeLens: record('range', 'command'),
        Color: record('red', 'green', 'blue', 'alpha'),
        ColorInformation: record('range', 'color'), ColorPresentation: record('label'),
        DocumentSymbol: record('name', 'detail', 'kind', 'range', 'selectionRange'),
        FoldingRange: record('start', 'end', 'kind'), FoldingRangeKind: {},
        Hover: record('contents', 'range'), MarkdownString: record('value'), SnippetString: record('value'),
        ParameterInformation: record('label', 'documentation'), SignatureInformation: record('label', 'documentation'),
        SignatureHelp: record(), SignatureHelpTriggerKind: {}, SymbolKind: {}, SymbolTag: {}, SymbolInformation: record(),
        SemanticTokens: record('data', 'resultId'), SemanticTokensLegend: record('tokenTypes', 'tokenModifiers'),
        SemanticTokensEdits: record(), SemanticTokensEdit: record(), DocumentHighlight: record('range', 'kind'), DocumentHighlightKind: {},
        RelativePattern: class { constructor(base, pattern) { this.baseUri = base.uri ?? base; this.pattern = pattern; } },
        CancellationError: class extends Error {}, FileType: {}, ViewColumn: { Beside: -2 }, ProgressLocation: {},
        env: { language: 'en', appName: 'test', openExternal: async () => true },
        extensions: { getExtension: () => undefined },
        commands: {
            registerCommand(name, run) {
                if (editor.commands.has(name)) throw new Error(`${name} is registered twice`);
                editor.commands.set(name, run);
                return new Disposable(() => editor.commands.delete(name));
            },
            executeCommand: async (name, ...words) => (name === 'vscode.open' ? void editor.opened.push(words[0].toString()) : editor.commands.get(name)(...words)),
        },
        window: {
            activeTextEditor: undefined, visibleTextEditors: [], tabGroups: { all: [], onDidChangeTabs: on('tabs'), onDidChangeTabGroups: on('groups') },
            onDidChangeActiveTextEditor: on('active'), onDidChangeVisibleTextEditors: on('visible'),
            createOutputChannel: () => channel, showErrorMessage: say, showWarningMessage: say, showInformationMessage: say,
            withProgress: (_, run) => run({ report() {} }, new CancellationTokenSource().token),
            showTextDocument: async (uri) => void editor.opened.push(uri.toString()),
        },
        workspace: {
            workspaceFolders, textDocuments: editor.documents, notebookDocuments: [], isTrusted: true, fs: {},
            getConfiguration: () => configuration, createFileSystemWatcher: watcher, findFiles,
            getWorkspaceFolder: (uri) => (uri.fsPath.startsWith(`${folder}/`) ? workspaceFolders[0] : undefined),
            saveAll: async () => editor.documents.every((one) => !writeFileSync(one.uri.fsPath, one.text)),
            asRelativePath: (path) => String(path), applyEdit: async () => true,
        },
        languages: {
            match: (selector, document) => (matches(selector, document) ? 10 : 0),
            createDiagnosticCollection: () => ({
                set: (uri, all) => editor.diagnostics.set(uri.toString(), all), delete: (uri) => editor.diagnostics.delete(uri.toString()),
                clear: () => editor.diagnostics.clear(), get: (uri) => editor.diagnostics.get(uri.toString()), has: () => false, forEach() {}, dispose() {},
            }),
        },
    };
    // Other events are never fired, other classes hold nothing, and other providers are kept by their names.
    const others = (object, otherwise) => new Proxy(object, { get: (own, name) => (name in own || typeof name === 'symbol' ? own[name] : (own[name] = otherwise(name))) });
    known.workspace = others(known.workspace, on);
    known.languages = others(known.languages, (name) => register(name.replace(/^register(.*)Provider$/, '$1')));
    const vscode = others(known, (name) => (/^[A-Z]/.test(name) ? record() : undefined));

    const load = Module._load;
    Module._load = function (request, ...rest) {
        return request === 'vscode' ? vscode : load.call(this, request, ...rest);
    };

    editor.vscode = vscode;
    editor.open = (path, languageId) => {
        const document = new Document(path, languageId);
        editor.documents.push(document);
        known.window.activeTextEditor = { document, selection: { active: new Position(0, 0) } };
        emitters.onDidOpenTextDocument?.fire(document);
        return document;
    };
    editor.edit = (document, from, text) => {
        const at = document.text.indexOf(from);
        const range = new Range(document.positionAt(at), document.positionAt(at + from.length));
        document.text = document.text.slice(0, at) + text + document.text.slice(at + from.length);
        document.version++;
        emitters.onDidChangeTextDocument?.fire({ document, contentChanges: [{ range, rangeOffset: at, rangeLength: from.length, text }], reason: undefined });
    };
    // The answers of the providers of one kind, for a document that they want.
    editor.ask = async (kind, method, document, ...words) => {
        const token = new CancellationTokenSource().token;
        for (const { selector, provider } of editor.providers[kind] ?? [])
            if (matches(selector, document)) return provider[method](document, ...words, token);
        return undefined;
    };
    return editor;
}

module.exports = { createEditor };
