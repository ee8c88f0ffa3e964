// node studio_manners_test.mjs PXM [PART OF A NAME]: the studio with keys alone, with fingers, for eyes that
// need contrast, in two tabs, in a page where nothing moves; and what leaves it for other programs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { openPage, pixelsOf, settled, startBrowser, startStudio } from './studio.mjs';

const program = resolve(process.argv[2]);
const only = process.argv[3];
const scenes = new URL('../../scenes/', import.meta.url);

const { browser, context } = await startBrowser();
const studio = await startStudio(program, folder => {
  for (const name of ['tetra', 'menger', 'fir'])
    writeFileSync(join(folder, `${name}.pxm`), readFileSync(new URL(`${name}.pxm`, scenes)));
});

async function scene(name, tab = 'maps', within = context) {
  const opened = await openPage(within, studio.address, `#scene=${name}&tab=${tab}`);
  await settled(opened.page);
  return opened;
}
const textOf = page => page.inputValue('#text');
const press = async (page, ...keys) => { for (const key of keys) await page.keyboard.press(key); };

const tests = {
  async every_text_and_every_edge_can_be_seen() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const states = {
      maps: async () => { await page.click('#tab-maps'); if (!await page.isVisible('.card.open')) await page.click('.map-title >> nth=0'); },
      text: () => page.click('#tab-text'),
      facts: async () => { await page.click('#tab-facts'); await page.waitForSelector('#panel-facts dd'); },
      machine: async () => { await page.click('#tab-machine'); },
      'a mistake': async () => { await page.click('#tab-text'); await page.fill('#text', 'ifs {'); await page.waitForSelector('#mistakes .mistake'); },
      'none again': async () => { await page.fill('#text', readFileSync(new URL('tetra.pxm', scenes), 'utf8')); await settled(page); },
      help: () => page.evaluate(() => document.getElementById('help-dialog').showModal()),
      save: () => page.evaluate(() => document.getElementById('save-dialog').showModal()),
      render: () => page.evaluate(() => studio.rendering.open()),
      export: () => page.evaluate(() => studio.exporting.open()),
      entry: () => page.evaluate(() => document.getElementById('entry-dialog').showModal()),
      gallery: async () => { await page.evaluate(() => { location.hash = ''; }); await page.waitForSelector('#gallery:not([hidden])'); },
    };
    let looked = 0;
    for (const colorScheme of ['dark', 'light']) {
      await page.emulateMedia({ colorScheme });
      if (await page.isHidden('#studio')) { await page.evaluate(() => { location.hash = 'scene=tetra.pxm'; }); await settled(page); }
      for (const [name, show] of Object.entries(states)) {
        await show();
        const { texts, faint } = await page.evaluate(contrasts);
        assert.deepEqual(faint, [], `${name}, ${colorScheme}`);
        assert.ok(texts > 1, `${name} has texts`);
        looked += texts;
        await page.evaluate(() => document.querySelector('dialog[open]')?.close());
      }
    }
    console.log(`  ${looked} texts and edges, the faintest ${await page.evaluate(() => window.faintest.toFixed(2))}`);
    return opened;
  },

  async keys_alone_open_a_scene_shape_it_and_ask_of_it() {
    const opened = await openPage(context, studio.address);
    const { page } = opened;
    await page.waitForSelector('#own-cards button');
    const focused = () => page.evaluate(() => document.activeElement?.title || document.activeElement?.id || document.activeElement?.textContent);
    for (let i = 0; i < 30 && await focused() !== 'tetra.pxm'; ++i) await press(page, 'Tab');
    await press(page, 'Enter');
    await page.waitForFunction(() => window.studio?.name === 'tetra.pxm');
    await settled(page);
    const before = await textOf(page);
    // Everything that can be pressed or filled is reached by Tab; of the panels' tabs one is, and arrows lead on.
    const missed = await page.evaluate(() => {
      const all = [...document.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex]')].filter(e => e.offsetParent && !e.disabled);
      return all.filter(e => e.tabIndex < 0 && e.role !== 'tab').map(e => e.outerHTML);
    });
    assert.deepEqual(missed, []);
    await page.focus('#handles');
    await press(page, 'h');
    assert.match(await page.textContent('#toast'), /Map 1, the whole: arrow keys move it/);
    await press(page, 'ArrowRight', 'ArrowRight', 'Shift+ArrowUp');
    const moved = await textOf(page);
    assert.notEqual(moved, before);
    assert.match(moved, /translate: 0\.\d+,0\.\d+,-?0?\.?\d+/);
    await press(page, 'h');
    assert.match(await page.textContent('#toast'), /the face opposite corner 1/);
    await press(page, 'ArrowLeft');
    assert.match(await textOf(page), /tetrahedron: \(/);
    await press(page, 'Escape');
    const shaped = await textOf(page), view = await page.evaluate(() => studio.camera.moved);
    await press(page, 'ArrowLeft');
    assert.equal(await textOf(page), shaped, 'once it is let go, arrows turn the view');
    assert.ok(!view && await page.evaluate(() => studio.camera.moved));
    for (let i = 0; i < 4; ++i) await press(page, 'Control+z');
    assert.equal(await textOf(page), before, 'each key was a change of its own');
    await settled(page);
    await press(page, 'Home', 'Enter');
    await page.waitForFunction(() => document.getElementById('word').textContent !== '');
    await page.focus('#tab-maps');
    await press(page, 'ArrowLeft');
    assert.ok(await page.isVisible('#panel-machine'));
    await page.focus('#handles');
    await press(page, 'Enter');
    await page.waitForSelector('#descent-tree:not([hidden]) .tree');
    return opened;
  },

  async fingers_turn_and_zoom() {
    const phone = await browser.newContext({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    const opened = await scene('menger.pxm', 'text', phone);
    const { page } = opened;
    const touch = await phone.newCDPSession(page);
    const box = await page.locator('#handles').boundingBox();
    const fingers = (type, ...places) => touch.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(([x, y], id) => ({ x: box.x + x, y: box.y + y, id })) });
    const camera = () => page.evaluate(() => ({ away: studio.camera.away, distance: studio.camera.distance, reach: studio.camera.reach }));
    const first = await camera();
    await fingers('touchStart', [150, 150]);
    for (let i = 1; i <= 6; ++i) await fingers('touchMove', [150 + 12 * i, 150]);
    await fingers('touchEnd');
    const turned = await camera();
    assert.notDeepEqual(turned.away, first.away);
    assert.equal(turned.distance, first.distance);
    await fingers('touchStart', [150, 200], [240, 200]);
    for (let i = 1; i <= 8; ++i) await fingers('touchMove', [150 - 8 * i, 200], [240 + 8 * i, 200]);
    await fingers('touchEnd');
    await page.waitForFunction(m => studio.camera.reach / studio.camera.distance > 1.5 * m, first.reach / first.distance);
    await settled(page);
    return opened;
  },

  async steps_are_dragged_and_typed() {
    const opened = await scene('fir.pxm');
    const { page } = opened;
    await page.evaluate(() => studio.edit('ifs a {\n    newmap scale: 0.5 rotate: y,30 translate: 0.3,0,0\n    newmap scale: 0.4\n}\n'));
    await settled(page);
    await page.click('.map-title >> nth=0');
    const [from, to] = [await page.locator('.card.open .step .grip >> nth=0').boundingBox(), await page.locator('.card.open .step b >> nth=2').boundingBox()];
    await page.mouse.move(from.x + 4, from.y + 6);
    await page.mouse.down();
    await page.mouse.move(to.x + 4, to.y + 6, { steps: 8 });
    await page.mouse.up();
    assert.match(await textOf(page), /newmap rotate: y,30 translate: 0\.3,0,0 scale: 0\.5\n/);
    await page.click('[aria-label="scale earlier"]');
    assert.match(await textOf(page), /newmap rotate: y,30 scale: 0\.5 translate: 0\.3,0,0\n/);
    await page.click('.adder >> text=matrix');
    assert.equal((await page.$$('.card.open .matrix input')).length, 12);
    await page.click('[aria-label="remove matrix"]');
    await page.fill('.looks input[type="color"]', '#ff0000');
    await page.fill('.looks input[placeholder="auto"]', '3');
    assert.match(await textOf(page), /color: 1,0,0,0\.5/);
    assert.match(await textOf(page), /weight: 3/);
    const number = page.locator('[aria-label="translate x"]');
    await number.focus();
    await press(page, 'ArrowUp');
    assert.match(await textOf(page), /translate: 0\.31,0,0/);
    const scrub = await page.locator('label.value:has([aria-label="translate y"]) .scrub').boundingBox();
    await page.mouse.move(scrub.x + 4, scrub.y + 6);
    await page.mouse.down();
    await page.mouse.move(scrub.x + 44, scrub.y + 6, { steps: 4 });
    await page.mouse.up();
    assert.match(await textOf(page), /translate: 0\.31,0\.2,0/);
    const cut = await page.$$eval('.card.open .value input', all => all.filter(e => e.value.length <= 6 && e.scrollWidth > e.clientWidth).map(e => e.value));
    assert.deepEqual(cut, [], 'short numbers can be read');
    await settled(page);
    return opened;
  },

  async a_map_that_does_not_shrink_is_red_and_the_picture_stays() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const before = await pixelsOf(page);
    await page.click('.map-title >> nth=0');
    await page.fill('[aria-label="scale x"]', '1.2');
    await page.waitForSelector('#mistakes:not([hidden])');
    await page.waitForSelector('[data-lip="0"].bad');
    assert.equal(await pixelsOf(page), before);
    return opened;
  },

  async two_tabs_do_not_disturb_each_other() {
    const [one, two] = [await scene('tetra.pxm', 'text'), await scene('menger.pxm', 'text')];
    const [tetra, menger] = [await textOf(one.page), await textOf(two.page)];
    const shown = await pixelsOf(two.page);
    const name = await one.page.evaluate(() => { studio.edit(`${studio.text}# of the first\n`); return studio.name; });
    await Promise.all([one.page, two.page].map(async page => {
      await page.focus('#handles');
      for (let i = 0; i < 10; ++i) await press(page, i < 5 ? 'ArrowLeft' : 'ArrowRight');
    }));
    await one.page.evaluate(async () => { const server = await import('/server.js'); await server.stopAll(); });
    await settled(two.page);
    await two.page.click('#reset');
    await settled(two.page);
    assert.equal(name, 'tetra.pxm');
    assert.equal(await textOf(two.page), menger);
    assert.equal(await pixelsOf(two.page), shown);
    await two.page.reload();
    await settled(two.page);
    assert.equal(await textOf(two.page), menger);
    assert.equal(await textOf(one.page), `${tetra}# of the first\n`);
    assert.deepEqual(two.complaints, []);
    await two.page.close();
    await one.page.focus('#handles');
    await press(one.page, 'ArrowLeft');
    await settled(one.page);
    return one;
  },

  async nothing_moves_for_who_wants_that() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const moving = () => page.evaluate(() => [...document.querySelectorAll('*')].filter(e => {
      const style = getComputedStyle(e);
      return style.animationName !== 'none' || style.transitionDuration.split(',').some(t => parseFloat(t) > 0);
    }).length);
    assert.ok(await moving() > 0);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    assert.equal(await moving(), 0);
    return opened;
  },

  async scenes_are_exported_to_what_export_writes() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const note = pattern => page.waitForFunction(p => new RegExp(p).test(document.getElementById('export-note').textContent), pattern);
    const exportAs = async (format, name, more = async () => {}) => {
      await page.selectOption('#export-format', format);
      await more();
      if (name) await page.fill('#export-name', name);
      await page.click('#export-start');
    };
    const ofCommand = (name, ...options) => {
      execFileSync(program, ['export', 'tetra.pxm', '-o', `same_${name}`, ...options, '--quiet'], { cwd: studio.folder, stdio: 'pipe' });
      return readFileSync(join(studio.folder, `same_${name}`));
    };
    const same = (name, ...options) => assert.deepEqual(readFileSync(join(studio.folder, name)), ofCommand(name, ...options), name);
    await page.click('#export');
    for (const format of await page.$$eval('#export-format option', o => o.map(e => e.value))) {
      const cells = !['aifs', 'flame'].includes(format);
      assert.equal(await page.selectOption('#export-format', format).then(() => page.isVisible('#export-cells')), cells);
      if (format === 'gltf' || format === 'flame') continue;
      await exportAs(format, '', async () => { if (cells) { await page.selectOption('#export-end', 'levels'); await page.fill('#export-levels', '3'); } });
      await note(`^tetra\\.${format} is written`);
      same(`tetra.${format}`, ...(cells ? ['--levels', '3'] : []));
      assert.ok(!(await page.textContent('#export-note')).includes('/pxm-studio-'), 'it does not say where the folder lies');
    }
    // Its numbers stand beside a .gltf, and neither is replaced unasked.
    writeFileSync(join(studio.folder, 'two.bin'), 'mine');
    await exportAs('gltf', 'two.gltf');
    await note('there already');
    assert.equal(readFileSync(join(studio.folder, 'two.bin'), 'utf8'), 'mine');
    await page.click('#export-start');
    await note('^two\\.gltf is written');
    assert.ok(readFileSync(join(studio.folder, 'two.bin')).length > 100);
    // Cells by their size; a flame cannot hold what is not of the plane, and says so.
    await exportAs('obj', 'small.obj', async () => { await page.selectOption('#export-end', 'detail'); await page.fill('#export-detail', '0.3'); });
    await note('^small\\.obj is written');
    same('small.obj', '--detail', '0.3');
    await exportAs('flame', 'tetra.flame');
    await page.waitForSelector('#export-note.refused');
    assert.ok(!existsSync(join(studio.folder, 'tetra.flame')));
    // Not out of the folder, not through a link, and not more than the studio exports.
    symlinkSync('/tmp', join(studio.folder, 'linked'));
    for (const [name, said] of [['../out.stl', 'below the studio'], ['linked/out.stl', 'is a link'], ['.hidden.stl', 'hidden']]) {
      await exportAs('stl', name, async () => { await page.selectOption('#export-end', 'levels'); await page.fill('#export-levels', '2'); });
      await note(said);
    }
    await exportAs('stl', 'many.stl', () => page.fill('#export-levels', '12'));
    await note('more than 4000000 cells');
    assert.ok(!existsSync(join(studio.folder, 'many.stl')));
    // What is given up leaves nothing.
    await exportAs('ply', 'slow.ply', () => page.fill('#export-levels', '10'));
    await note('^\\d+ %$');
    await page.click('#export-cancel');
    await note('Given up');
    await page.click('#export-cancel');
    assert.ok(await page.isHidden('#export-dialog'));
    assert.deepEqual(readdirSync(studio.folder).filter(file => /slow|many|out/.test(file)), []);
    return opened;
  },

  async nothing_that_is_not_saved_is_lost_when_one_begins_anew() {
    const opened = await openPage(context, studio.address);
    const { page } = opened;
    const gallery = async () => { await page.click('#home'); await page.waitForSelector('#gallery:not([hidden])'); };
    const shows = async name => { await page.waitForFunction(n => window.studio?.name === n, name); await settled(page); };
    await page.waitForSelector('#shipped-cards button');
    assert.ok(await page.isHidden('#unsaved'));
    await page.click('#new');
    await shows('mine.pxm');
    const blank = await textOf(page);
    await page.fill('[aria-label="scale"]', '0.7');
    await page.evaluate(() => studio.editEnds());
    await page.fill('[aria-label="translate y"]', '0.25');
    const worked = await textOf(page);
    await gallery();
    assert.deepEqual(await page.$$eval('#unsaved-cards button', all => all.map(e => e.title)), ['mine.pxm']);
    await page.click('#new');
    await shows('mine_2.pxm');
    assert.equal(await textOf(page), blank);
    assert.match(await page.textContent('#toast'), /mine\.pxm is not saved yet/);
    // Another scene, and a file that is dropped, of a name that is taken.
    await gallery();
    await page.click('#own-cards [title="tetra.pxm"]');
    await shows('tetra.pxm');
    const drop = text => page.evaluate(words => {
      const data = new DataTransfer();
      data.items.add(new File([words], 'mine.pxm'));
      window.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
    }, text);
    const brought = readFileSync(new URL('fir.pxm', scenes), 'utf8');
    await drop(brought);
    await shows('mine_2.pxm');
    assert.equal(await textOf(page), brought);
    await page.waitForFunction(() => location.hash.includes('mine_2'));
    await page.goBack();
    await shows('tetra.pxm');
    await page.goForward();
    await shows('mine_2.pxm');
    assert.equal(await textOf(page), brought, 'what was brought is not saved either');
    // It is there as it was left, and so are its undo steps; after a reload of the tab, its text.
    await gallery();
    await page.click('#unsaved-cards [title="mine.pxm"]');
    await shows('mine.pxm');
    assert.equal(await textOf(page), worked);
    await page.click('#undo');
    assert.match(await textOf(page), /scale: 0\.7 rotate: z,3 translate: 0,0\.4,0/);
    await page.click('#undo');
    assert.equal(await textOf(page), blank);
    await page.click('#redo');
    await page.click('#redo');
    await gallery();
    await page.reload();
    await page.click('#unsaved-cards [title="mine.pxm"]');
    await shows('mine.pxm');
    assert.equal(await textOf(page), worked);
    await page.click('#save');
    await page.click('#save-form button.main');
    await page.waitForFunction(() => !studio.shipped);
    await gallery();
    assert.deepEqual(await page.$$eval('#unsaved-cards button', all => all.map(e => e.title)), ['mine_2.pxm']);
    // A file that is gone takes no changes along.
    await page.click('#own-cards [title="fir.pxm"]');
    await shows('fir.pxm');
    await page.evaluate(() => studio.edit(`${studio.text}# changed\n`));
    await gallery();
    rmSync(join(studio.folder, 'fir.pxm'));
    await page.click('#unsaved-cards [title="fir.pxm"]');
    await shows('fir.pxm');
    assert.equal(await textOf(page), `${brought}# changed\n`);
    await page.click('#save');
    await page.waitForFunction(() => studio.saved === studio.text);
    assert.equal(readFileSync(join(studio.folder, 'fir.pxm'), 'utf8'), `${brought}# changed\n`);
    writeFileSync(join(studio.folder, 'fir.pxm'), brought);
    return opened;
  },

  async a_field_of_one_number_takes_one_number() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    await page.evaluate(() => studio.edit('ifs a {\n    newmap scale: 0.5 rotate: y,30 translate: -0.3,0.4,0\n    newmap scale: 0.4\n}\n'));
    await page.click('.map-title >> nth=0');
    const [x, axis, weight] = ['[aria-label="translate x"]', '[aria-label="rotate axis"]', '[placeholder="auto"]'];
    const has = async line => assert.equal((await textOf(page)).split('\n')[1].trim(), line);
    const leave = () => page.focus('#tab-maps');
    // A decimal comma is a point, while it is typed and afterwards.
    await page.focus(x);
    for (const key of ['0', ',', '2', '5']) { await press(page, key); assert.equal(await page.getAttribute(x, 'aria-invalid'), null); }
    await has('newmap scale: 0.5 rotate: y,30 translate: 0.25,0.4,0');
    await leave();
    assert.equal(await page.inputValue(x), '0.25');
    // What is not one value is refused where it stands, and said.
    for (const wrong of ['0.1,0.2,0.3', '1 # 2', 'sqrt(2', '1)', '0.3 scale: 2', '1 }', '"a"', '(1,2),3']) {
      await page.fill(x, wrong);
      assert.equal(await page.getAttribute(x, 'aria-invalid'), 'true', wrong);
      await has('newmap scale: 0.5 rotate: y,30 translate: 0.25,0.4,0');
    }
    await leave();
    assert.equal(await page.inputValue(x), '0.25');
    assert.match(await page.textContent('#toast'), /“\(1,2\),3” is not one number/);
    await page.fill(x, '-sqrt(0,5)');
    await page.fill(x, '-(1+sqrt(4))/10');
    await has('newmap scale: 0.5 rotate: y,30 translate: -(1+sqrt(4))/10,0.4,0');
    await page.fill(x, '-0,3');
    await page.focus(weight);
    for (const key of ['1', ',', '5']) await press(page, key);  // the row is made anew under the first of them
    await has('newmap scale: 0.5 rotate: y,30 translate: -0.3,0.4,0 weight: 1.5');
    await page.fill(weight, '');
    await has('newmap scale: 0.5 rotate: y,30 translate: -0.3,0.4,0');
    // One types over the whole: with focus by key, by a click, and with a double click.
    await leave();
    for (const select of [() => page.focus(x), () => page.click(x), async () => { await page.click(x); await page.dblclick(x); }]) {
      await page.fill(x, '-0.3');
      await leave();
      await select();
      await page.keyboard.type('0.4');
      await has('newmap scale: 0.5 rotate: y,30 translate: 0.4,0.4,0');
    }
    await page.click(axis);
    await press(page, 'z');
    await has('newmap scale: 0.5 rotate: z,30 translate: 0.4,0.4,0');
    await page.fill(axis, 'yz');
    await has('newmap scale: 0.5 rotate: z,30 translate: 0.4,0.4,0');
    await leave();
    assert.equal(await page.inputValue(axis), 'z');
    // A second click puts the caret somewhere, as anywhere.
    await page.click(x);
    await page.waitForTimeout(700);
    await page.click(x, { position: { x: 3, y: 8 } });
    assert.equal(await page.$eval(x, e => e.selectionEnd - e.selectionStart), 0);
    await settled(page);
    return opened;
  },

  async a_png_says_what_was_saved_and_that_one_has_to_wait() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const says = text => page.waitForFunction(words => document.querySelector('#toast.shown')?.textContent.match(words), text);
    const size = await page.evaluate(() => `${studio.finished().columns}×${studio.finished().rows}`);
    let download = page.waitForEvent('download');
    await page.click('#png');
    assert.equal((await download).suggestedFilename(), 'tetra.png');
    await says(`^tetra\\.png is among your downloads: ${size} pixels\\.$`);
    let go;
    const held = new Promise(done => { go = done; });
    await page.route('**/api/png', async route => { await held; await route.continue(); });
    download = page.waitForEvent('download');
    await page.click('#png');
    await says('^Rendering tetra\\.png …$');
    // How far it is, as the program says.
    let share = 0.42;
    await page.route('**/api/progress', route => (route.request().postDataJSON().view.endsWith('-png') ? route.fulfill({ json: { share } }) : route.continue()));
    await says('^Rendering tetra\\.png … 42 %$');
    share = 0.87;
    await says('^Rendering tetra\\.png … 87 %$');
    await page.waitForTimeout(3500);
    assert.ok(await page.isVisible('#toast.shown'), 'it says so as long as one waits');
    go();
    await download;
    await says('^tetra\\.png is among your downloads');
    await page.click('#tab-text');
    await page.fill('#text', 'ifs {');
    await page.waitForSelector('#mistakes .mistake');
    await page.click('#png');
    await says('It is the last one without mistakes');
    return opened;
  },

  async the_way_to_a_plant_stays_folded_and_says_what_surprises() {
    const opened = await openPage(context, studio.address);
    const { page } = opened;
    await page.click('#new');
    await settled(page);
    const open = () => page.$eval('.hint', e => e.open);
    const hint = await page.textContent('.hint');
    for (const said of ['a mirrored copy, Map 3', 'turns the steps of its map into one tetrahedron; undo']) assert.ok(hint.includes(said), said);
    assert.ok(await open());
    await page.click('.hint summary');
    await page.waitForFunction(() => sessionStorage.getItem('pxm-hint-folded') === 'yes');
    await page.click('.adder >> text=rotate');
    assert.ok(!await open(), 'it is made anew, and stays folded');
    assert.match(await textOf(page), /newmap scale: 0\.85 rotate: z,3 translate: 0,0\.4,0 rotate: z,30/);
    // What it says of Mirror and of a corner is so.
    const before = await textOf(page);
    await page.click('.map-title >> nth=1');
    await page.click('.card.open button:text-is("Mirror")');
    assert.equal((await page.$$('.card')).length, 3);
    await page.click('#undo');
    await page.click('.map-title >> nth=1');
    await settled(page);
    await page.focus('#handles');
    await press(page, 'h', 'h', 'h', 'h');
    await press(page, 'ArrowRight');
    assert.match(await textOf(page), /tetrahedron: \(/);
    await page.click('#undo');
    assert.equal(await textOf(page), before);
    await page.reload();
    await settled(page);
    assert.ok(!await open());
    await page.click('.hint summary');
    await page.waitForFunction(() => sessionStorage.getItem('pxm-hint-folded') === '');
    await page.click('.map-title >> nth=0');
    assert.ok(await open());
    return opened;
  },

  async undo_says_what_it_undid() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const toast = () => page.textContent('#toast');
    await page.evaluate(() => { for (const text of ['ifs a {\n    newmap scale: 0.5\n}\n', 'ifs a {\n    newmap scale: 0.6\n}\n', 'ifs a {\n    newmap scale: 0.6\n    newmap scale: 0.4 translate: 0,1,0\n}\n']) { studio.edit(text, 'typed'); studio.editEnds(); } });
    await page.click('#undo');
    assert.equal(await toast(), 'Undone in line 3: newmap scale: 0.4 translate: 0,1,0 is gone.');
    await press(page, 'Control+z');
    assert.equal(await toast(), 'Undone in line 2: scale: 0.5 instead of scale: 0.6.');
    await press(page, 'Control+Shift+z');
    assert.equal(await toast(), 'Redone in line 2: scale: 0.6 instead of scale: 0.5.');
    await page.click('#redo');
    assert.equal(await toast(), 'Redone in line 3: newmap scale: 0.4 translate: 0,1,0 is there.');
    await settled(page);
    const version = await page.evaluate(() => studio.live.version);
    await press(page, 'Control+y');
    assert.equal(await toast(), 'There is nothing to redo.');
    await settled(page);
    assert.equal(await page.evaluate(() => studio.live.version), version, 'and nothing is rendered anew');
    // Whatever two texts are, the words name a line that there is, and pieces of them.
    const wrong = await page.evaluate(async () => {
      const { changeBetween } = await import('/changes.js');
      const bits = ['a: 1', '\n', ' ', 'b', '0.5', 'newmap', '#', ''];
      let seed = 7;
      const random = n => { seed = (seed * 1103515245 + 12345) % 2147483648; return Math.floor(seed / 65536) % n; };
      const text = () => Array.from({ length: random(9) }, () => bits[random(bits.length)]).join('');
      for (let i = 0; i < 5000; ++i) {
        const [before, after] = [text(), text()];
        const { line, was, is } = changeBetween(before, after);
        const flat = t => t.replace(/\s+/g, ' ');
        if (line < 1 || line > Math.max(before.split('\n').length, after.split('\n').length) || !flat(before).includes(was) || !flat(after).includes(is)) return [before, after, line, was, is];
      }
      return null;
    });
    assert.equal(wrong, null);
    return opened;
  },

  async facts_say_that_they_are_being_computed() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    let go, held = new Promise(done => { go = done; });
    await page.route('**/api/inspect', async route => { await held; await route.continue(); });
    await page.click('#tab-facts');
    await page.waitForSelector('#panel-facts .awaited:has-text("Computing what is known")');
    assert.equal(await page.$('#panel-facts dd'), null);
    go();
    await page.waitForSelector('#panel-facts dd');
    assert.equal(await page.$('#panel-facts .awaited'), null);
    // Of a text that has changed the old ones stand there, and it says that there will be others.
    held = new Promise(done => { go = done; });
    await page.evaluate(() => studio.edit(studio.text.replace(/scale: 0\.5/, 'scale: 0.45')));
    await page.waitForSelector('#panel-facts .awaited');
    assert.ok(await page.$('#panel-facts dd'));
    go();
    await page.waitForFunction(() => !document.querySelector('#panel-facts .awaited') && document.querySelector('#panel-facts dd'));
    // What is given up says so.
    await page.unroute('**/api/inspect');
    await page.route('**/api/inspect', route => route.fulfill({ contentType: 'application/json', body: '{"superseded": true, "stopping_ms": 0}' }));
    await page.evaluate(() => studio.edit(studio.text.replace(/scale: 0\.45/, 'scale: 0.4')));
    await page.waitForSelector('#panel-facts .awaited:has-text("Computing was stopped")');
    // Help speaks of what can be dragged.
    assert.match(await page.textContent('#help-dialog'), /drag what stands beside it sideways: ↔/);
    return opened;
  },

  async mistakes_are_marked_where_they_are_among_the_maps() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const write = async (words, more = '') => {
      await page.evaluate(text => studio.edit(text), `# a comment\nifs a {\n    newmap scale: 0.5\n    newmap ${words}\n}\n${more}`);
      await page.evaluate(() => studio.answered);
      await page.evaluate(() => studio.select(0, 1));
    };
    const marked = () => page.$$eval('#panel-maps [data-wrong]', all => all.map(e => e.ariaLabel ?? e.placeholder ?? (e.dataset.step ? `step ${e.dataset.step}` : `${e.textContent} of ${e.closest('button').textContent}`)));
    for (const [words, places] of Object.entries({
      'scale: foo': ['scale'],
      'scale: 0.5 rotate: y,foo': ['rotate degrees'],
      'scale: 0.5 translate: 1,1/0,0': ['translate y'],
      'scale: 0.5 translate: 1,2+,0': ['translate y'],
      'scale: 0.5 translate: 1,2': ['step 1'],
      'scale: 1.2': [],
    })) {
      await write(words);
      const [sign, ...rest] = await marked();
      assert.match(sign, /^mistake of Map 2mistake/, words);
      assert.deepEqual(rest, places, words);
      assert.ok(await page.isVisible('#mistakes'));
    }
    await write('scale: 0.5 weight: -1');
    assert.deepEqual((await marked()).slice(1), ['auto']);
    assert.match(await page.getAttribute('[placeholder="auto"]', 'title'), /must not be negative/);
    assert.equal(await page.getAttribute('[placeholder="auto"]', 'aria-invalid'), 'true');
    // Typed here, too; and no more of it once it is right.
    await page.fill('[placeholder="auto"]', '2');
    await page.waitForSelector('#mistakes', { state: 'hidden' });
    assert.deepEqual(await marked(), []);
    await page.fill('[aria-label="scale"]', 'nothing');
    await page.waitForSelector('[aria-label="scale"][aria-invalid="true"]');
    await page.fill('[aria-label="scale"]', '0.5');
    await page.waitForSelector('#mistakes', { state: 'hidden' });
    assert.deepEqual(await marked(), []);
    // What is wrong elsewhere is not said of a map.
    await write('scale: 0.5', 'camera { eye: }\n');
    assert.ok(await page.isVisible('#mistakes'));
    assert.deepEqual(await marked(), []);
    await page.evaluate(() => studio.undo());
    await settled(page);
    return opened;
  },

  async a_double_click_presses_nothing_that_came_under_the_pointer() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const before = `ifs a {\n${['0,0.5,0', '0.5,0,0', '-0.5,0,0', '0,0,0.5'].map(x => `    newmap scale: 0.4 translate: ${x}\n`).join('')}}\n`;
    await page.evaluate(text => { studio.edit(text); studio.select(0, 0); }, before);
    const count = () => page.$$eval('.card', all => all.length);
    const maps = await count();
    const x = await page.evaluate(() => { const [copy, title] = ['.card.open button[aria-label="Copy this map"]', '.map-title'].map(s => document.querySelector(s).getBoundingClientRect()); return (copy.left + copy.right) / 2 - title.left; });
    // The header of the second map, a line at a time down its height: its Copy is under the pointer once it
    // has slid up.
    for (let y = 4; y < 34; y += 6) {
      await page.evaluate(() => studio.select(0, 0));
      await page.dblclick('.map-title >> nth=1', { position: { x, y } });
      assert.equal(await textOf(page), before, `${y} pixels down the header`);
      assert.equal(await page.getAttribute('.map-title >> nth=1', 'aria-expanded'), 'true', 'it is open');
    }
    // One thing is done once: a double click deletes, and removes, one.
    await page.evaluate(() => studio.select(0, 0));
    await page.dblclick('.card.open button:text-is("Delete")');
    assert.equal(await count(), maps - 1);
    await page.click('#undo');
    await page.evaluate(() => studio.select(0, 0));
    const steps = await page.$$eval('.card.open .step', all => all.length);
    await page.dblclick('.card.open [aria-label^="remove"] >> nth=0');
    assert.equal(await page.$$eval('.card.open .step', all => all.length), steps - 1);
    await page.click('#undo');
    // Two clicks on what stays are two.
    await page.dblclick('[data-key="add"]');
    assert.equal(await count(), maps + 2);
    await page.evaluate(() => { studio.undo(); studio.undo(); });
    assert.equal(await textOf(page), before);
    return opened;
  },

  async wires_do_not_cover_the_picture() {
    const opened = await openPage(context, studio.address, '#scene=sunflower_field.pxm&from=pxm');
    const { page } = opened;
    await page.waitForFunction(() => window.studio?.checked);
    const marks = () => page.evaluate(() => {
      studio.handles.draw();
      const from = document.getElementById('handles');
      const copy = new OffscreenCanvas(from.width, from.height).getContext('2d', { willReadFrequently: true });
      copy.drawImage(from, 0, 0);
      return copy.getImageData(0, 0, from.width, from.height).data.reduce((n, v, i) => n + (i % 4 === 3 && v > 0 ? 1 : 0), 0);
    });
    assert.equal(await page.inputValue('#wires'), 'open', 'of 41 maps not all are drawn');
    assert.equal(await marks(), 0, 'and none while none is open');
    await page.selectOption('#wires', 'all');
    const all = await marks();
    assert.ok(all > 1000);
    await page.selectOption('#wires', 'open');
    await page.click('.map-title >> nth=0');
    const one = await marks();
    assert.ok(one > 0 && one < all, `${one} of ${all}`);
    await page.focus('#handles');
    await press(page, 'w');
    assert.equal(await page.inputValue('#wires'), 'none');
    assert.equal(await marks(), 0);
    // What is not drawn is not taken hold of.
    assert.equal(await page.evaluate(() => { for (let x = 0; x < 900; x += 5) for (let y = 0; y < 600; y += 5) if (studio.handles.hit(x, y) || studio.handles.nearest(x, y) >= 0) return true; return false; }), false);
    await press(page, 'h');
    assert.equal(await page.inputValue('#wires'), 'open', 'a handle is seen that is chosen');
    await page.click('#tab-facts');
    assert.ok(await page.isHidden('#wires-label'));
    await page.evaluate(() => { location.hash = 'scene=tetra.pxm'; });
    await page.waitForFunction(() => studio.name === 'tetra.pxm' && studio.base);
    await page.click('#tab-maps');
    assert.equal(await page.inputValue('#wires'), 'all', 'of five maps all are drawn');
    return opened;
  },

  async nothing_is_said_of_a_picture_that_is_no_longer_there() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    const word = () => page.textContent('#word');
    const timing = () => page.textContent('#timing');
    const click = async () => {
      await settled(page);
      await page.focus('#handles');
      await press(page, 'Enter');
      await page.waitForFunction(() => document.getElementById('word').textContent !== '');
    };
    await click();
    await press(page, 'ArrowLeft');
    assert.equal(await word(), '', 'the view is another');
    await click();
    await page.evaluate(() => studio.edit(studio.text.replace('0.5', '0.45'), 'panel'));
    assert.equal(await word(), '', 'the text is another');
    // An answer that comes too late is not about what is seen.
    await settled(page);
    let go;
    const held = new Promise(done => { go = done; });
    await page.route('**/api/pick', async route => { await held; await route.continue(); });
    const asked = page.waitForRequest('**/api/pick'), answered = page.waitForResponse('**/api/pick');
    await press(page, 'Enter');
    await asked;
    await press(page, 'ArrowLeft');
    go();
    await answered;
    await settled(page);
    assert.equal(await word(), '');
    await page.unroute('**/api/pick');
    await click();
    // While the next scene is awaited, nothing stands there of this one.
    assert.match(await timing(), /^\d+×\d+, /);
    await page.evaluate(() => {
      const { send } = WebSocket.prototype;
      const shown = new Promise(done => { window.show = done; });
      WebSocket.prototype.send = function (text) { shown.then(() => send.call(this, text)); };
      location.hash = 'scene=fir.pxm';
    });
    await page.waitForFunction(() => studio.name === 'fir.pxm' && studio.base);
    assert.equal(await word(), '');
    await page.waitForFunction(() => document.getElementById('timing').textContent === 'rendering …');
    await page.evaluate(() => window.show());
    await settled(page);
    assert.match(await timing(), /^\d+×\d+, /);
    return opened;
  },

  async a_scene_is_unsaved_only_where_something_would_be_lost() {
    const opened = await openPage(context, studio.address, '#scene=tetra.pxm&from=pxm&tab=text');
    const { page } = opened;
    await settled(page);
    const marked = () => page.$$eval('#scene-name .dirty', all => all.length);
    assert.equal(await marked(), 0, 'a scene of the gallery as it is');
    const text = await textOf(page);
    await page.fill('#text', `${text}# more\n`);
    assert.equal(await marked(), 1);
    assert.match(await page.title(), /^• /);
    await page.fill('#text', text);
    assert.equal(await marked(), 0, 'and as it is again');
    await page.evaluate(() => studio.place.begin());
    await page.waitForFunction(() => studio.name === 'mine.pxm' && studio.base);
    assert.equal(await marked(), 0, 'nothing has been made yet');
    await page.click('#tab-maps');
    await page.click('[data-key="add"]');
    assert.equal(await marked(), 1);
    await page.evaluate(() => studio.place.begin('brought.pxm', 'ifs a {\n    newmap scale: 0.5\n    newmap scale: 0.5 translate: 1,0,0\n}\n'));
    await page.waitForFunction(() => studio.name === 'brought.pxm' && studio.base);
    assert.equal(await marked(), 1, 'what was brought has no file');
    await settled(page);
    return opened;
  },

  async red_are_the_maps_of_a_system_that_does_not_contract() {
    const opened = await openPage(context, studio.address, '#scene=sunflower_field.pxm&from=pxm');
    const { page } = opened;
    await page.waitForFunction(() => window.studio?.checked && !studio.checking.runs);
    const badges = () => page.$$eval('.lip', all => all.map(e => ({ stretch: parseFloat(e.textContent.slice(1)), bad: e.classList.contains('bad'), near: e.classList.contains('near'), title: e.title })));
    const grown = (await badges()).filter(b => b.stretch >= 1.01);
    assert.ok(grown.length >= 2, 'soil and stalk');
    for (const b of grown) assert.ok(!b.bad && b.near && b.title.includes('alone does not shrink'), JSON.stringify(b));
    assert.ok((await badges()).every(b => !b.bad));
    const system = scale => `ifs a {\n    newmap scale: ${scale} translate: 0,0.5,0\n    newmap scale: 0.5\n}\n`;
    const write = async text => { await page.evaluate(t => studio.edit(t), text); await page.waitForFunction(() => !studio.checking.runs); };
    await write(system(1.1));
    assert.deepEqual((await badges()).map(b => b.bad), [true, false]);
    assert.ok(await page.isVisible('#mistakes'));
    // Another mistake does not make it well, nor does a good text leave it ill.
    await write(`${system(1.1)}camera { eye: }\n`);
    assert.deepEqual((await badges()).map(b => b.bad), [true, false]);
    await write(system(0.9));
    assert.deepEqual((await badges()).map(b => b.bad), [false, false]);
    await settled(page);
    return opened;
  },

  async the_machine_says_what_it_is_and_keeps_no_ray_of_another_picture() {
    const opened = await scene('tetra.pxm', 'machine');
    const { page } = opened;
    const panel = () => page.textContent('#panel-machine');
    assert.match(await panel(), /this computer's own processors render the scene/i);
    assert.match(await panel(), /Click a pixel of the picture/);
    assert.doesNotMatch(await panel(), /rendered by a simulated/);
    const follow = async () => {
      await settled(page);
      await page.focus('#handles');
      await press(page, 'Enter');
      await page.waitForSelector('#descent-tree:not([hidden]) .tree');
      assert.ok(await page.evaluate(() => studio.volumes.cells.length > 0));
    };
    const gone = async why => {
      await page.waitForSelector('#descent-tree', { state: 'hidden' });
      assert.equal(await page.evaluate(() => studio.volumes.cells.length), 0, why);
    };
    await follow();
    const said = await page.textContent('#descent-tree');
    for (const word of ['met a cell if', 'missed it if not', 'was opened', 'The number is']) assert.ok(said.includes(word), word);
    for (const title of await page.$$eval('.tree .cell', all => all.map(e => e.title))) assert.match(title, /\n[a-z ]+: [a-z]/);
    await press(page, 'ArrowLeft');
    assert.ok(await page.isVisible('#descent-tree'), 'one may turn it, and look at the volumes from beside');
    await page.selectOption('#model', '916');
    await gone('the model is another');
    await page.waitForSelector('[aria-label="How pixels are shared out"] button');
    assert.match(await panel(), /Click a pixel of the picture/);
    await follow();
    await page.click('[aria-label="How pixels are shared out"] button >> nth=1');
    await gone('pixels are shared out in another way');
    await follow();
    await page.setViewportSize({ width: 1100, height: 760 });
    await gone('the picture is of another size');
    await follow();
    await page.evaluate(() => studio.edit(studio.text.replace('0.5', '0.45')));
    await gone('the text is another');
    await settled(page);
    return opened;
  },

  async undo_speaks_of_maps_where_they_were_shaped() {
    const opened = await scene('fir.pxm');
    const { page } = opened;
    const begin = 'ifs a {\n    newmap scale: 0.5 translate: 0,0.4,0\n    newmap leaf scale: 0.4 rotate: z,30 translate: 0,1,0\n}\n';
    await page.evaluate(text => { studio.edit(text); studio.select(0, 1); }, begin);
    /// What undo says, and then redo.
    const says = async (undone, redone) => {
      await page.evaluate(() => studio.editEnds());
      const after = await textOf(page);
      assert.notEqual(after, begin);
      await page.click('#undo');
      assert.equal(await page.textContent('#toast'), `Undone. ${undone}`);
      assert.equal(await textOf(page), begin);
      await page.click('#redo');
      assert.equal(await page.textContent('#toast'), `Redone. ${redone}`);
      assert.equal(await textOf(page), after);
      await page.evaluate(text => { studio.edit(text); studio.select(0, 1); }, begin);
    };
    await page.fill('[data-key="1.2.1"]', '0.7');
    await says('Map 2 leaf: translate is 0, 1, 0 again.', 'Map 2 leaf: translate is 0, 0.7, 0 again.');
    await page.click('.adder >> text=scale');
    await says('Map 2 leaf: scale 0.5 is gone again.', 'Map 2 leaf: scale 0.5 is there again.');
    await page.click('[aria-label="remove rotate"]');
    await says('Map 2 leaf: rotate z, 30 is there again.', 'Map 2 leaf: rotate z, 30 is gone again.');
    await page.click('[aria-label="rotate earlier"]');
    await says('Map 2 leaf: its steps are scale, rotate, translate again.', 'Map 2 leaf: its steps are rotate, scale, translate again.');
    await page.click('.card.open button:text-is("Copy")');
    await says('Map 3 is gone again.', 'Map 3 is there again.');
    await page.evaluate(() => studio.select(0, 0));
    await page.click('.card.open button:text-is("Delete")');
    await says('Map 1 is there again.', 'Map 1 is gone again.');
    await page.evaluate(() => { studio.maps.graph.open = true; studio.maps.shape = ''; studio.maps.draw(); });
    await page.click('[data-key="graph.0.1"]');
    await says('What may stand in what is as it was.', 'What may stand in what is as it was.');
    // What was typed in the text is told as the text has it.
    await page.click('#tab-text');
    await page.fill('#text', begin.replace('0.4,0', '0.3,0'));
    await page.click('#undo');
    assert.equal(await page.textContent('#toast'), 'Undone in line 2: translate: 0,0.4,0 instead of translate: 0,0.3,0.');
    await settled(page);
    return opened;
  },

  async dialogs_say_which_folder() {
    const opened = await openPage(context, studio.address, '#scene=tetra.pxm&from=pxm');
    const { page } = opened;
    await settled(page);
    await page.click('#save');
    assert.ok((await page.textContent('#save-dialog label')).includes(studio.folder));
    await page.click('#save-cancel');
    await page.click('#export');
    assert.ok((await page.textContent('#export-dialog')).includes(studio.folder));
    await page.click('#export-cancel');
    return opened;
  },
};

/// Visible texts whose contrast is below 4.5, and edges of fields that are below 3 (runs in the page).
function contrasts() {
  const rgb = text => text.match(/[\d.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map(v => v / 255).map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = element => { for (let e = element; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] > 0.5) return c; } return [255, 255, 255]; };
  const ratio = (a, b) => { const [x, y] = [light(a), light(b)]; return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05); };
  const faint = [];
  const look = (element, what, contrast, least) => {
    window.faintest = Math.min(window.faintest ?? 99, contrast);
    if (contrast < least) faint.push(`${what} of ${element.tagName}#${element.id}.${element.className} "${element.textContent.trim().slice(0, 20)}": ${contrast.toFixed(2)}`);
  };
  let texts = 0;
  for (const element of (document.querySelector('dialog[open]') ?? document.body).querySelectorAll('*')) {
    if (element.id === 'text' || !element.offsetParent || element.disabled || element.namespaceURI.endsWith('svg')) continue;
    const style = getComputedStyle(element);
    const field = /^(INPUT|SELECT|TEXTAREA)$/.test(element.tagName);
    if (field && !['range', 'checkbox', 'color'].includes(element.type)) look(element, 'edge', ratio(rgb(style.borderTopColor), ground(element.parentElement)), 3);
    if (!field && ![...element.childNodes].some(n => n.nodeType === 3 && n.textContent.trim())) continue;
    ++texts;
    look(element, 'text', ratio(rgb(style.color), ground(element)), 4.5);
  }
  return { texts, faint };
}

let passed = 0, failed = 0;
try {
  for (const [name, test] of Object.entries(tests)) {
    if (only && !name.includes(only)) continue;
    const begin = Date.now();
    try {
      const opened = await test();
      assert.deepEqual(opened.complaints, [], `${name}: the browser has nothing to complain of`);
      await opened.page.close();
      console.log(`${name}: ${((Date.now() - begin) / 1000).toFixed(1)} s`);
      ++passed;
    } catch (error) {
      console.log(`${name} FAILED: ${error.stack}`);
      ++failed;
    }
  }
} finally {
  await browser.close();
  await studio.stop();
}
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
