// Files of templates/, which the bundle has as texts.
declare module '*.glib' { const text: string; export default text; }
declare module '*.vert' { const text: string; export default text; }
declare module '*.frag' { const text: string; export default text; }
