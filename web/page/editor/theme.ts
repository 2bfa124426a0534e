// Colours of the text: CSS variables of the page, which follow the system's light or dark.
import { HighlightStyle, syntaxHighlighting } from '@codemirror/language';
import { EditorView } from '@codemirror/view';
import { tags } from '@lezer/highlight';

const view = EditorView.theme({
    '&': { height: '100%', color: 'var(--text)', backgroundColor: 'var(--field)', fontSize: '.875rem' },
    '&.cm-focused': { outline: '2px solid var(--accent)', outlineOffset: '-2px' },
    '.cm-scroller': { fontFamily: 'var(--mono, ui-monospace, Menlo, Consolas, monospace)', lineHeight: '1.5' },
    '.cm-content': { caretColor: 'var(--text)' },
    '.cm-cursor, .cm-dropCursor': { borderLeftColor: 'var(--text)' },
    '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
        backgroundColor: 'var(--selection)',
    },
    '.cm-gutters': { backgroundColor: 'var(--panel)', color: 'var(--quiet)', borderRight: '1px solid var(--line)' },
    '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'color-mix(in srgb, var(--accent) 9%, transparent)' },
    '.cm-panels, .cm-tooltip': {
        color: 'var(--text)',
        backgroundColor: 'var(--panel)',
        borderColor: 'var(--line)',
    },
    '.cm-panels-bottom': { borderTop: '1px solid var(--line)' },
    '.cm-panel.cm-search': { fontSize: '.875rem', padding: '6px 30px 6px 8px' },
    '.cm-panel.cm-search label': { fontSize: '.875rem' },
    '.cm-panel.cm-search input, .cm-panel.cm-search button': { fontSize: 'inherit' },
    '.cm-textfield': { color: 'var(--text)', backgroundColor: 'var(--field)', border: '1px solid var(--line)' },
    '.cm-button': { color: 'var(--text)', backgroundImage: 'none', backgroundColor: 'var(--field)', border: '1px solid var(--line)' },
    '.cm-tooltip': { maxWidth: 'min(36rem, 90vw)' },
    '.cm-tooltip-autocomplete > ul > li[aria-selected]': { color: 'var(--on-accent)', backgroundColor: 'var(--accent)' },
    '.cm-diagnostic': { whiteSpace: 'pre-wrap', padding: '4px 8px' },
    '.cm-diagnostic-error': { borderLeftColor: 'var(--error)' },
    '.cm-diagnostic-warning': { borderLeftColor: 'var(--warning)' },
    '.cm-diagnostic-info': { borderLeftColor: 'var(--quiet)' },
    '.cm-lintRange': { backgroundImage: 'none', textDecoration: 'underline wavy', textDecorationSkipInk: 'none' },
    '.cm-lintRange-error': { textDecorationColor: 'var(--error)' },
    '.cm-lintRange-warning': { textDecorationColor: 'var(--warning)' },
    '.cm-lintRange-info': { textDecorationColor: 'var(--quiet)' },
    '.cm-lintRange-active': { backgroundColor: 'color-mix(in srgb, var(--warning) 20%, transparent)' },
    '.cm-lint-marker': { content: 'none', width: '1em', height: '1em', textAlign: 'center', lineHeight: '1em' },
    '.cm-lint-marker-error::before': { content: '"✖"', color: 'var(--error)' },
    '.cm-lint-marker-warning::before': { content: '"▲"', color: 'var(--warning)' },
    '.cm-lint-marker-info::before': { content: '"●"', color: 'var(--quiet)' },
    '&.cm-focused .cm-matchingBracket': { backgroundColor: 'var(--selection)' },
    '.cm-searchMatch': { backgroundColor: 'color-mix(in srgb, var(--warning) 30%, transparent)' },
    '.cm-searchMatch-selected': { backgroundColor: 'color-mix(in srgb, var(--warning) 55%, transparent)' },
    '.cm-selectionMatch': { backgroundColor: 'color-mix(in srgb, var(--accent) 16%, transparent)' },
});

const colours = HighlightStyle.define([
    { tag: tags.comment, color: 'var(--code-comment)', fontStyle: 'italic' },
    { tag: [tags.keyword, tags.typeName], color: 'var(--code-keyword)' },
    { tag: [tags.number, tags.atom], color: 'var(--code-number)' },
    { tag: tags.string, color: 'var(--code-string)' },
    { tag: tags.meta, color: 'var(--code-meta)' },
    { tag: [tags.standard(tags.variableName), tags.special(tags.variableName)], color: 'var(--code-known)' },
    { tag: tags.invalid, textDecoration: 'underline dotted var(--error)' },
]);

export const theme = [view, syntaxHighlighting(colours)];
