// snell.js, which Emscripten writes (build/web/engine).
declare module 'snell-engine' {
    const make: import('./wasm.ts').MakeProgram;
    export default make;
}
