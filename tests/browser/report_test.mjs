// node report_test.mjs REPORT.html...: what a person does with a report works in a real browser.
import assert from 'node:assert/strict';
import { open } from './browser.mjs';

/// The tooltip's text with the pointer at the middle of an element; null if none is shown.
async function tipOver(page, element) {
  await element.scrollIntoViewIfNeeded();
  const box = await element.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  return page.evaluate(() => {
    const tip = document.getElementById('tip');
    return getComputedStyle(tip).display === 'none' ? null : tip.textContent;
  });
}

async function isEmpty(page, selector) {
  return (await page.$$(selector)).length === 0;
}

async function checkPlots(page) {
  const plots = await page.$$('svg');
  assert.ok(plots.length > 0, 'there are plots');
  for (const plot of plots) {
    const box = await plot.boundingBox();
    assert.ok(box.width > 100 && box.height > 50, 'a plot has a size');
    assert.ok((await plot.$$('[data-tip]')).length > 0, 'a plot has marks');
  }
  const places = await page.$$eval('svg circle, svg rect, svg text', marks =>
    marks.flatMap(m => ['cx', 'cy', 'x', 'y'].map(a => m.getAttribute(a))).filter(v => v !== null));
  assert.ok(places.every(v => Number.isFinite(Number(v))), 'every mark has a place');
}

async function checkHovering(page) {
  for (const kind of ['.bar', '.cell', '.hit']) {
    if (await isEmpty(page, kind)) continue;
    const marks = await page.$$(kind);
    const tip = await tipOver(page, marks[Math.floor(marks.length / 2)]);
    assert.match(tip ?? '', /\d/, `hovering ${kind} shows a value`);
  }
  for (const image of await page.$$('img[data-values]')) {
    assert.match(await tipOver(page, image) ?? '', /\d+ of|\d/, 'hovering a map shows a value');
  }
  await page.mouse.move(1, 1);
  const shown = await page.evaluate(() => document.getElementById('tip').style.display);
  assert.equal(shown, 'none', 'nothing is shown beside the marks');
}

async function checkPictures(page) {
  const broken = await page.$$eval('img', images => images.filter(i => !i.naturalWidth).length);
  assert.equal(broken, 0, 'every picture is in the page');
}

async function checkWidth(page) {
  const wide = await page.evaluate(() =>
    document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(wide <= 0, `the page is ${wide} pixels too wide`);
}

/// Texts of a plot that lie on one another cannot be read.
async function checkLabels(page) {
  const overlaps = await page.$$eval('svg', plots => plots.flatMap(plot => {
    const texts = [...plot.querySelectorAll('text')].map(t => [t.textContent, t.getBoundingClientRect()]);
    const meet = (a, b) => a.left + 1 < b.right && b.left + 1 < a.right && a.top + 2 < b.bottom && b.top + 2 < a.bottom;
    return texts.flatMap(([name, a], i) => texts.slice(i + 1).filter(([, b]) => meet(a, b))
      .map(([other]) => `${plot.getAttribute('aria-label')}: "${name}" on "${other}"`));
  }));
  assert.deepEqual(overlaps, [], 'no text of a plot lies on another');
}

/// A phone shows the page at its own width; what is wider scrolls by itself.
async function checkPhone(page) {
  const before = page.viewportSize();
  await page.setViewportSize({ width: 390, height: 844 });
  await checkWidth(page);
  const small = await page.$$eval('figure.wide svg', plots =>
    plots.filter(p => p.getBoundingClientRect().width < 590).length);
  assert.equal(small, 0, 'plots keep a size that can be read');
  await page.setViewportSize(before);
}

async function checkPrint(page) {
  const pdf = await page.pdf({ format: 'A4' });
  assert.equal(pdf.subarray(0, 5).toString(), '%PDF-');
  const sheets = (pdf.toString('latin1').match(/\/Type\s*\/Page\b/g) ?? []).length;
  assert.ok(sheets >= 1 && sheets < 200, `${sheets} sheets`);
}

let passed = 0;
for (const file of process.argv.slice(2)) {
  const { browser, page, complaints } = await open(file);
  for (const check of [checkPlots, checkHovering, checkPictures, checkWidth, checkLabels, checkPhone, checkPrint]) {
    await check(page);
    ++passed;
  }
  assert.deepEqual(complaints, [], 'the browser has nothing to complain of');
  ++passed;
  await browser.close();
}
console.log(`${passed} passed, 0 failed`);
