// node studio_screenshots.mjs PXM FOLDER [NAME]: the main states of the studio as pictures.
import { cpSync, mkdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { withPalette } from './palette_png.mjs';
import { openPage, settled, startBrowser, startStudio } from './studio.mjs';

const [program, out, only = ''] = process.argv.slice(2);
if (!out) {
  console.error('usage: studio_screenshots PXM FOLDER [NAME]');
  process.exit(2);
}
mkdirSync(out, { recursive: true });
const { browser, context } = await startBrowser({ viewport: { width: 1120, height: 700 }, colorScheme: 'dark', reducedMotion: 'reduce' });
const studio = await startStudio(resolve(program), folder => {
  for (const name of ['tetra.pxm', 'menger.pxm', 'fir.pxm', 'pound_sign.pxm'])
    cpSync(new URL(`../../scenes/${name}`, import.meta.url), join(folder, name));
});

async function shoot(name, hash, prepare = async () => {}) {
  if (only && name !== only) return;
  const { page } = await openPage(context, studio.address, hash);
  page.setDefaultTimeout(180_000);
  await prepare(page);
  writeFileSync(join(out, `${name}.png`), withPalette(await page.screenshot()));
  await page.close();
  console.log(join(out, `${name}.png`));
}

try {
  await shoot('gallery', '', async page => {
    await page.evaluate(() => { document.getElementById('own').hidden = true; });
    await page.waitForFunction(() => document.querySelectorAll('#shipped-cards canvas.made').length >= 8);
  });
  await shoot('maps', '#scene=fir.pxm', async page => {
    await settled(page);
    await page.click('.map-title >> nth=1');
  });
  await shoot('graph', '#scene=pound_sign.pxm', async page => {
    await settled(page);
    await page.evaluate(() => { const graph = document.querySelector('.graph'); graph.open = true; graph.scrollIntoView(); });
    await page.fill('#volume-level', '2');
  });
  await shoot('descent', '#scene=tetra.pxm&tab=machine', async page => {
    await settled(page);
    const box = await page.locator('#handles').boundingBox();
    await page.mouse.click(box.x + box.width * 0.5, box.y + box.height * 0.4);
    await page.waitForSelector('.tree');
    await page.hover('.tree li li li li .cell >> nth=2');
  });
  await shoot('plant', '', async page => {
    await page.click('#new');
    await settled(page);
    await page.click('.map-title >> nth=1');
    await page.click('.card.open button:text-is("Mirror")');
    await page.click('button:text-is("+ Map")');
    await page.click('.card.open button:text-is("x y z")');
    for (const [axis, value] of Object.entries({ x: '0.03', y: '0.35', z: '0.03' })) await page.fill(`.card.open [aria-label="scale ${axis}"]`, value);
    await settled(page);
    await page.click('.map-title >> nth=1');
    await page.evaluate(() => document.activeElement.blur());
  });
  await shoot('flight', '#scene=menger.pxm&tab=text', async page => {
    await settled(page);
    const box = await page.locator('#handles').boundingBox();
    await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.5);
    for (let last = 1; last < 1e18;) {
      await page.mouse.wheel(0, -400);
      await page.waitForFunction(m => studio.camera.reach / studio.camera.distance > m, last, { polling: 20 });
      last = await page.evaluate(() => studio.camera.reach / studio.camera.distance);
    }
    await settled(page);
  });
  await shoot('machine', '#scene=pound_sign.pxm&tab=machine', async page => {
    await settled(page);
    await page.selectOption('#model', '964dX');
    await page.waitForSelector('.nodes i');
    await settled(page);
    await page.click('text=blocks');
  });
} finally {
  await browser.close();
  await studio.stop();
}
