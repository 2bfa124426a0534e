import { builtPage, chromium, drop, tab } from './harness/browser.mjs';
import { mkdirSync, writeFileSync } from 'node:fs';
const browser = await chromium();
const bodies = { w: 'float x = 0.;\nwhile (true) x += uA;\ngl_FragColor = vec4(x, 1., 0., 1.);',
 b: 'float x = 1.;\nwhile (true) { x += uA; if (x < 0.) break; }\ngl_FragColor = vec4(x, 1., 0., 1.);',
 n: 'float x = 1.;\nfor (int i = 0; i < 2000; ++i) for (int j = 0; j < 2000; ++j) for (int k = 0; k < 2000; ++k) x += uA;\ngl_FragColor = vec4(x, 1., 0., 1.);' };
for (const [k, body] of Object.entries(bodies)) {
  const d = `/tmp/zz-${k}`; mkdirSync(d, { recursive: true });
  writeFileSync(`${d}/e.glib`, 'LookAt 0 0 1.2 0 0 0 0 1 0\nVertex p.vert\nFragment p.frag\nProgram P uA <1. 2. 10.>\nSphere 1 20 20\n');
  writeFileSync(`${d}/p.vert`, 'void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n');
  writeFileSync(`${d}/p.frag`, `uniform float uA;\nvoid main() {\n${body}\n}\n`);
  const { page } = await tab(browser);
  await page.goto(builtPage('snell.html'));
  await page.waitForSelector('.editor-welcome li');
  const t0 = Date.now();
  await drop(page, `${d}/e.glib`, `${d}/p.vert`, `${d}/p.frag`);
  let last = '';
  while (Date.now() - t0 < 25000) {
    const now = await page.evaluate(() => JSON.stringify([document.querySelector('.status span').textContent, document.querySelector('dialog[open]')?.textContent, document.querySelector('.cover').textContent.slice(0, 60)]));
    if (now !== last) console.log(k, Date.now() - t0, now);
    last = now;
    await new Promise((r) => setTimeout(r, 50));
  }
  await page.close();
}
await browser.close();
