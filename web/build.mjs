// Bundles the page. The engine comes from build/web/engine, or from $SNELL_ENGINE.
import { build } from 'esbuild';

await build({ entryPoints: ['page/main.ts'], bundle: true, minify: true, format: 'iife', outfile: '../build/web/page.js' });
