// node screenshot.mjs REPORT.html OUT.png: the whole page as a picture.
import { open } from './browser.mjs';

const [file, out] = process.argv.slice(2);
if (!out) {
  console.error('usage: screenshot REPORT.html OUT.png');
  process.exit(2);
}
const { browser, page } = await open(file);
await page.screenshot({ path: out, fullPage: true });
await browser.close();
