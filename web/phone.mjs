// Makes a picture of a scene's page as a phone shows it: node web/phone.mjs SCENE PICTURE, in the repository's folder.
import { chromium, drawn, pageOf, tab, temporaryFolder } from './tests/harness/browser.mjs';

const [scene, picture] = process.argv.slice(2);
const address = await pageOf(temporaryFolder(), scene);
const browser = await chromium();
const { page } = await tab(browser);
await page.setViewport({ width: 390, height: 844, deviceScaleFactor: 2, isMobile: true, hasTouch: true });
await page.goto(address);
await drawn(page);
await page.screenshot({ path: picture, type: 'jpeg', quality: 82 });
await browser.close();
