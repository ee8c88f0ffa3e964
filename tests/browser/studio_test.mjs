// node studio_test.mjs PXM [PART OF A NAME] [every-decade|slowly]: what a person does with the studio works in a real browser.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { Person } from './person.mjs';
import { openPage, pixelsOf, settled, startBrowser, startStudio } from './studio.mjs';

const program = resolve(process.argv[2]);
const only = process.argv[3];
const every_decade = process.argv[4] === 'every-decade';  // of a flight is compared: minutes
const slowly = process.argv[4] === 'slowly';              // a person's time is waited for
const tetra = `# four copies, each half as large
ifs tetra {
    newmap top   # the first
        scale: 0.5
        translate: 0,0.5,0
    newmap scale: 0.5 translate: 0,-1/6,-sqrt(2)/3
    newmap scale: 0.5 translate: sqrt(6)/6,-1/6,sqrt(2)/6   # right
    newmap scale: 0.5 translate: -sqrt(6)/6,-1/6,sqrt(2)/6
}
`;

const fill = folder => {
  writeFileSync(join(folder, 'tetra.pxm'), tetra);
  writeFileSync(join(folder, 'wrong.pxm'), 'ifs wrong {\n    newmap scale: 0.5,0.5\n}\n');
  writeFileSync(join(folder, 'markup.pxm'), 'ifs a { newmap scale: "<img src=x onerror=window.stolen=1>" }\n# <script>window.stolen=1</script>\n');
  writeFileSync(join(folder, 'film.pxm'), tetra.replace('ifs tetra', 'animation { frames: 50 }\nifs tetra').replace('0,0.5,0', '0,0.4 + t/4,0'));
  mkdirSync(join(folder, 'deep'));
  for (const [name, from] of [['sponge', 'menger'], ['pound_sign', 'pound_sign']])
    writeFileSync(join(folder, 'deep', `${name}.pxm`), readFileSync(new URL(`../../scenes/${from}.pxm`, import.meta.url)));
};

const { browser, context } = await startBrowser();
const studio = await startStudio(program, fill);
const open = (hash = '') => openPage(context, studio.address, hash);
const textOf = page => page.inputValue('#text');
const canvas = page => page.locator('#handles').boundingBox();

async function scene(name, tab = 'maps') {
  const opened = await open(`#scene=${name}&tab=${tab}`);
  await settled(opened.page);
  return opened;
}

/// What the command on the clipboard renders, as pixels in the page.
async function rendered(page) {
  await page.click('#command');
  const command = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(command, /^pxm render /);
  execFileSync('/bin/sh', ['-c', `${command.replace(/^pxm/, '"$PXM"')} --no-scene`], { cwd: studio.folder, env: { ...process.env, PXM: program }, stdio: 'pipe' });
  return { command, file: readFileSync(join(studio.folder, /-o (\S+)$/.exec(command)[1])) };
}

async function samePicture(page) {
  await settled(page);
  const { command, file } = await rendered(page);
  const shown = await pixelsOf(page);
  const decoded = await pixelsOf(page, file);
  assert.equal(shown, decoded, `the page shows what this renders: ${command}`);
  return { command, file };
}

const tests = {
  async the_gallery_shows_every_scene_and_opens_one() {
    const { page, complaints } = await open();
    await page.waitForSelector('#own-cards canvas.made');
    const names = await page.$$eval('#own-cards .caption', c => c.map(e => e.textContent));
    assert.deepEqual(names, ['deep/pound_sign', 'deep/sponge', 'film', 'markup', 'tetra', 'wrong']);
    assert.ok((await page.$$('#shipped-cards li')).length > 10);
    assert.ok(!page.url().includes('token'), 'the token leaves the address');
    await page.click('#own-cards button[title="tetra.pxm"]');
    await settled(page);
    assert.equal(await page.textContent('#scene-name'), 'tetra.pxm');
    await page.goBack();
    assert.ok(await page.isVisible('#gallery'));
    return { page, complaints };
  },

  async the_picture_is_what_the_command_renders() {
    const opened = await scene('tetra.pxm', 'text');
    const { page } = opened;
    assert.doesNotMatch((await samePicture(page)).command, /--set/);
    const box = await canvas(page);
    await page.mouse.move(box.x + 300, box.y + 300);
    await page.mouse.down();
    await page.mouse.move(box.x + 380, box.y + 330, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.press('Shift+ArrowLeft');
    const { file } = await samePicture(page);
    const download = page.waitForEvent('download');
    await page.click('#png');
    assert.deepEqual(readFileSync(await (await download).path()), file, 'the PNG is the file that the command writes');
    await page.keyboard.press('Home');
    return opened;
  },

  async the_wheel_flies_to_1e30_and_back() {
    for (const [name, x, y] of [['tetra.pxm', 0.5, 0.45], ['deep/pound_sign.pxm', 0.5, 0.5], ['deep/sponge.pxm', 0.5, 0.5]]) {
      const opened = await scene(name, 'text');
      const { page } = opened;
      if (every_decade) {  // smaller pictures: there are ninety
        await page.setViewportSize({ width: 800, height: 560 });
        await settled(page);
      }
      const box = await canvas(page);
      const point = () => page.mouse.move(box.x + box.width * x, box.y + box.height * y);
      await point();
      const magnification = () => page.evaluate(() => studio.camera.reach / studio.camera.distance);
      let last = await magnification(), decade = every_decade ? 10 : 1e6, compared = 0;
      const begin = last;
      for (let i = 0; i < 240 && last / begin < 1e30 / 2 && last < 9e29; ++i) {
        await page.mouse.wheel(0, -400);
        await page.waitForFunction(m => studio.camera.reach / studio.camera.distance > m, last, { polling: 20 });
        last = await magnification();
        if (last < decade) continue;
        while (decade <= last) decade *= every_decade ? 10 : 1e8;
        await samePicture(page);
        ++compared;
        await point();
        const middle = await page.evaluate(() => studio.live.last.pixels.data.reduce((s, v, i) => s + (i % 4 === 3 ? 0 : Math.abs(v - studio.live.last.pixels.data[i % 4])), 0));
        assert.ok(middle > 0, `at ${last} there is something to see`);
      }
      assert.ok(last >= 4e29, `${name} came to ${last}`);
      assert.ok(compared >= (every_decade ? 29 : 3), `${name}: ${compared} pictures were compared`);
      if (every_decade) console.log(`  ${name}: ${compared} pictures on the way to ${last.toExponential(1)}`);
      await page.keyboard.press('Home');
      await page.click('#reset');
      await settled(page);
      assert.equal(await page.textContent('#magnification'), '1');
      if (name === 'deep/sponge.pxm') return opened;
      assert.deepEqual(opened.complaints, []);
      await page.close();
    }
    return undefined;
  },

  async back_leads_back_and_a_reload_stays() {
    const opened = await scene('tetra.pxm', 'text');
    const { page } = opened;
    const first = await pixelsOf(page);
    await page.focus('#handles');
    await page.keyboard.press('ArrowRight');
    await settled(page);
    const turned = await pixelsOf(page);
    assert.notEqual(turned, first);
    await page.waitForFunction(() => location.hash.includes('view='));
    await page.reload();
    await settled(page);
    assert.equal(await pixelsOf(page), turned);
    await page.focus('#handles');
    await page.waitForTimeout(800);
    await page.keyboard.press('ArrowUp');
    await settled(page);
    await page.keyboard.press('Backspace');
    await settled(page);
    assert.equal(await pixelsOf(page), turned);
    return opened;
  },

  async a_mistake_stands_at_its_line_and_the_picture_stays() {
    const opened = await scene('tetra.pxm', 'text');
    const { page } = opened;
    const before = await pixelsOf(page);
    await page.fill('#text', tetra.replace('translate: 0,0.5,0', 'translate: 0,0.5'));
    await page.waitForSelector('#mistakes .mistake');
    assert.match(await page.textContent('#mistakes'), /line 6/);
    assert.equal(await page.textContent('#gutter .bad'), '6\n');
    assert.equal(await pixelsOf(page), before);
    await page.fill('#text', tetra.replace('translate: 0,0.5,0', 'translate: 0,0.6,0'));
    await settled(page);
    assert.ok(await page.isHidden('#mistakes'));
    assert.notEqual(await pixelsOf(page), before);
    await page.focus('#handles');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await settled(page);
    assert.equal(await textOf(page), tetra);
    assert.equal(await pixelsOf(page), before);
    return opened;
  },

  async markup_is_text() {
    const opened = await open('#scene=markup.pxm&tab=text');
    await opened.page.waitForSelector('#mistakes .mistake');
    await opened.page.click('#tab-maps');
    assert.equal(await opened.page.evaluate(() => window.stolen), undefined);
    assert.equal((await opened.page.$$('#studio img')).length, 0);
    return opened;
  },

  async handles_and_steps_edit_the_text_and_comments_stay() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    await page.click('.map-title >> nth=0');
    const at = await page.evaluate(() => {
      const scene = studio.shaping();
      const corners = studio.handles.cornersIn(scene, 0).map(c => studio.handles.toScreen(scene.camera, c));
      return { corner: corners[1], middle: studio.handles.middle(corners) };
    });
    const box = await canvas(page);
    const drag = async (from, x, y) => {
      await page.mouse.move(box.x + from.x, box.y + from.y);
      await page.mouse.down();
      await page.mouse.move(box.x + from.x + x, box.y + from.y + y, { steps: 5 });
      await page.mouse.up();
    };
    await drag(at.middle, 30, 0);
    const movedText = await textOf(page);
    assert.match(movedText, /# the first\n {8}scale: 0\.5\n {8}translate: 0\.\d+,0\.\d+,-?0?\.?\d+/);
    await page.keyboard.press('Control+z');
    assert.equal(await textOf(page), tetra, 'a drag is undone at once');
    await drag(at.corner, 0, -25);
    assert.match(await textOf(page), /newmap top {3}# the first\n {8}tetrahedron: \(.*-> \(/);
    await settled(page);
    await page.keyboard.press('Control+z');
    await page.fill('[aria-label="translate y"]', '0.4');
    assert.equal(await textOf(page), tetra.replace('translate: 0,0.5,0', 'translate: 0,0.4,0'));
    await page.click('text=Mirror');
    assert.match(await textOf(page), /newmap scale: 0\.5 translate: 0,0\.4,0 scale: -1,1,1\n}/);
    assert.equal((await page.$$('.card')).length, 5);
    await page.click('text=Delete');
    assert.equal((await page.$$('.card')).length, 4);
    await settled(page);
    await agree(page);
    return opened;
  },

  async a_hundred_edits_keep_text_page_and_program_in_step() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    let seed = 20261130;
    const random = n => { seed = (Math.imul(seed, 1103515245) + 12345) >>> 0; return (seed >>> 8) % n; };
    const box = await canvas(page);
    /// Takes a handle of the map that is selected, if there is one, and drags it with the mouse.
    const drag = async () => {
      const at = await page.evaluate(wanted => {
        const s = studio.shaping();
        const seen = s && s.map >= 0 ? studio.handles.cornersIn(s, s.map)?.map(c => studio.handles.toScreen(s.camera, c)) : null;
        return seen?.every(c => c.ahead > 0) ? [...seen, studio.handles.middle(seen)][wanted] : null;
      }, random(5));
      if (!at || at.x < 40 || at.y < 40 || at.x > box.width - 60 || at.y > box.height - 60) return;
      await page.mouse.move(box.x + at.x, box.y + at.y);
      await page.mouse.down();
      await page.mouse.move(box.x + at.x + random(31) - 15, box.y + at.y + random(31) - 15, { steps: 3 });
      await page.mouse.up();
    };
    const type = async () => {
      const words = ['# a remark ', ' ', '\n', '#'];
      await page.evaluate(([word, at]) => {
        const lines = studio.text.split('\n');
        const field = document.getElementById('text');
        const line = at % lines.length;
        lines[line] += word.includes('#') && lines[line].includes('#') ? ' again' : word;
        field.value = lines.join('\n');
        field.dispatchEvent(new Event('input', { bubbles: true }));
      }, [words[random(4)], random(1000)]);
    };
    let accepted = 0, dragged = 0;
    for (let i = 0; i < 100; ++i) {
      const before = await textOf(page);
      const kind = random(12);
      if (kind >= 10) await drag();
      else if (kind === 9) await type();
      else await page.evaluate(([what, a, b]) => {
        const s = window.studio;
        const press = name => document.querySelector(`[data-key$="${name}"]`)?.click();
        const maps = s.outline.ifs[0].maps.length;
        if (s.map < 0 || s.map >= maps) s.select(0, a % maps);
        if (what === 0) s.select(0, a % maps);
        if (what === 1 && maps < 8) press('Copy this map');
        if (what === 2 && maps < 8) press('A mirrored copy, left to right');
        if (what === 3 && maps > 2) press('Delete this map');
        if (what === 4) press(`.add.${['scale', 'rotate', 'translate'][a % 3]}`);
        if (what === 5) { const fields = [...document.querySelectorAll('.scale input[data-arg], .translate input[data-arg]')]; if (fields.length) { const f = fields[a % fields.length]; f.value = String((b % 9 - 4) / 10 || 0.3); f.dispatchEvent(new Event('input')); } }
        if (what === 6) press('.down');
        if (what === 7) s.undo();
        if (what === 8) s.redo();
      }, [kind, random(1000), random(1000)]);
      await read(page);
      if (kind >= 10 && await textOf(page) !== before) ++dragged;
      if (await agree(page)) ++accepted;
      if (i % 10 === 9) await savedAgrees(page);
    }
    console.log(`  ${accepted} of the texts were right, ${dragged} handles were dragged`);
    assert.ok(accepted > 50 && dragged > 3);
    while (!await agree(page)) { await page.evaluate(() => studio.undo()); await read(page); }
    await savedAgrees(page);
    await samePicture(page);
    writeFileSync(join(studio.folder, 'tetra.pxm'), tetra);
    return opened;
  },

  async saving_asks_before_it_replaces_what_has_changed() {
    const opened = await scene('tetra.pxm', 'text');
    const { page } = opened;
    await page.fill('#text', `${tetra}# mine\n`);
    await page.keyboard.press('Control+s');
    await page.waitForFunction(() => studio.saved === studio.text);
    assert.equal(readFileSync(join(studio.folder, 'tetra.pxm'), 'utf8'), `${tetra}# mine\n`);
    writeFileSync(join(studio.folder, 'tetra.pxm'), `${tetra}# theirs\n`);
    await page.fill('#text', `${tetra}# mine again\n`);
    await page.keyboard.press('Control+s');
    await page.waitForSelector('#save-dialog[open]');
    assert.equal(readFileSync(join(studio.folder, 'tetra.pxm'), 'utf8'), `${tetra}# theirs\n`);
    await page.fill('#save-name', 'other.pxm');
    await page.click('#save-form button.main');
    await page.waitForFunction(() => studio.name === 'other.pxm');
    assert.equal(readFileSync(join(studio.folder, 'other.pxm'), 'utf8'), `${tetra}# mine again\n`);
    writeFileSync(join(studio.folder, 'other.pxm'), `${tetra}# a third\n`);
    await page.waitForFunction(() => location.hash.includes('scene=other.pxm'));
    await page.reload();
    await settled(page);
    assert.equal(await textOf(page), `${tetra}# a third\n`, 'what was saved is not kept beside its file');
    await page.fill('#text', `${tetra}# not saved\n`);
    await settled(page);
    await page.reload();
    await settled(page);
    assert.equal(await textOf(page), `${tetra}# not saved\n`);
    writeFileSync(join(studio.folder, 'tetra.pxm'), tetra);
    return opened;
  },

  async facts_and_machine_tell_what_they_know() {
    const opened = await scene('tetra.pxm', 'facts');
    const { page } = opened;
    await page.waitForSelector('#panel-facts dd');
    assert.match(await page.textContent('#panel-facts'), /similarity dimension2affinity/);
    await page.click('#tab-machine');
    await page.selectOption('#model', '964dX');
    await page.waitForSelector('.nodes i');
    assert.equal((await page.$$('.nodes i')).length, 64);
    await page.waitForSelector('[aria-label="How pixels are shared out"] button');  // the map fills before they are known
    const shares = await page.$$eval('[aria-label="How pixels are shared out"] button', b => b.map(e => parseFloat(e.textContent.replace(/^\D+/, ''))));
    assert.ok(shares[0] > 90 && shares.slice(1).every(s => s < shares[0]), `interleaving is the most even: ${shares}`);
    await settled(page);
    const box = await canvas(page);
    await page.mouse.click(box.x + box.width / 2, box.y + box.height * 0.45);
    await page.click('text=As text');
    await page.waitForSelector('#descent-dialog[open]');
    assert.match(await page.textContent('#descent'), /pixel \d+,\d+: ray from/);
    await page.keyboard.press('Escape');
    await page.evaluate(() => studio.edit(`${studio.text}render { heap: 65536 }\n`));
    await page.waitForSelector('#panel-machine .refused');
    assert.match(await page.textContent('#panel-machine .refused'), /z-?buffer|memory/i);
    return opened;
  },

  async a_phone_and_a_keyboard_are_enough() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    for (const width of [320, 390, 600, 760, 800, 900, 1000]) {
      await page.setViewportSize({ width, height: 844 });
      await settled(page);
      for (const panel of ['text', 'facts', 'machine', 'maps']) {
        await page.click(`#tab-${panel}`);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.ok(wide <= 0, `with ${panel} the page is ${wide} of ${width} pixels too wide`);
      }
    }
    await page.setViewportSize({ width: 390, height: 844 });
    await settled(page);
    const unnamed = await page.$$eval('button, input, select, textarea', all => all.filter(e => e.offsetParent && !(e.textContent.trim() || e.getAttribute('aria-label') || e.title || e.closest('label')?.textContent.trim())).map(e => e.outerHTML));
    assert.deepEqual(unnamed, [], 'everything that can be used has a name');
    await page.focus('#tab-maps');
    await page.keyboard.press('ArrowRight');
    assert.ok(await page.isVisible('#panel-text'));
    for (const scheme of ['dark', 'light']) {
      await page.emulateMedia({ colorScheme: scheme });
      const faint = await page.evaluate(contrastProblems);
      assert.deepEqual(faint, [], `${scheme}: texts can be read`);
    }
    return opened;
  },

  async the_graph_is_a_table() {
    const opened = await scene('tetra.pxm');
    const { page } = opened;
    await page.click('.graph summary');
    await page.uncheck('[aria-label="2 inside top"]');
    assert.match(await textOf(page), /# right\n.*\n {4}follow: top -> top, 3, 4\n}/);
    await settled(page);
    await agree(page);
    await page.check('[aria-label="2 inside top"]');
    assert.equal(await textOf(page), tetra);
    return opened;
  },

  async a_film_shows_the_frame_that_is_chosen() {
    const opened = await scene('film.pxm', 'text');
    const { page } = opened;
    const first = await pixelsOf(page);
    await page.fill('#frame', '40');
    await page.waitForFunction(() => studio.frame === 40);
    assert.match((await samePicture(page)).command, /--frames 40/);
    assert.notEqual(await pixelsOf(page), first);
    return opened;
  },

  async one_begins_with_nothing() {
    const opened = await open();
    const { page } = opened;
    await page.click('#new');
    await settled(page);
    assert.equal((await page.$$('.card')).length, 2);
    await page.click('#save');
    await page.click('#save-form button.main');
    await page.waitForFunction(() => studio.saved === studio.text && !studio.shipped);
    assert.match(readFileSync(join(studio.folder, 'mine.pxm'), 'utf8'), /ifs mine/);
    await page.click('#home');
    await page.waitForSelector('#own-cards [title="mine.pxm"]');  // without a reload
    return opened;
  },

  async what_the_page_says_leads_from_nothing_to_a_plant() {
    const opened = await open();
    const { page } = opened;
    await page.evaluate(() => sessionStorage.clear());
    const person = new Person(page, { waits: slowly });
    await person.read('#gallery .lead');
    await person.click('#new');
    await settled(page);
    const hint = await person.read('.hint');
    for (const said of ['Open Map 2 and press Mirror', '+ Map', 'x y z', '0.03, 0.35, 0.03', 'Save PNG'])
      assert.ok(hint.includes(said), `it says ${said}`);
    await person.click('.map-title >> nth=1');
    await person.click('.card.open button:text-is("Mirror")');
    await person.click('button:text-is("+ Map")');
    await person.click('.card.open button:text-is("x y z")');
    await person.type('.card.open [aria-label="scale x"]', '0.03');
    await person.next('0.35');
    await person.next('0.03');
    await settled(page);
    assert.equal((await page.$$('.card')).length, 4);
    // And a change of one's own: it bends the other way.
    await person.click('.map-title >> nth=0');
    await person.type('.card.open [aria-label="rotate degrees"]', '-3');
    await settled(page);
    assert.ok(await page.isHidden('#mistakes'));
    const download = page.waitForEvent('download');
    await person.click('#png');
    assert.equal(readFileSync(await (await download).path()).subarray(1, 4).toString(), 'PNG');
    console.log(`  ${person.spent.toFixed(0)} s, of them ${person.counted.toFixed(0)} s of a person's reading, thinking and typing, ${slowly ? 'waited for' : 'counted'}`);
    assert.ok(person.spent < 180, 'within three minutes');
    // A plant stands up: green, higher than wide, widest below its middle.
    const { width, height, below, above, green } = await page.evaluate(() => {
      const { pixels } = studio.live.last, at = (x, y) => pixels.data.subarray(4 * (y * pixels.width + x));
      const [r, g, b] = at(0, 0);
      let [left, right, top, bottom, green, all] = [1e9, 0, 1e9, 0, 0, 0];
      const rows = new Array(pixels.height).fill(0);
      for (let y = 0; y < pixels.height; ++y)
        for (let x = 0; x < pixels.width; ++x) {
          const c = at(x, y);
          if (c[0] === r && c[1] === g && c[2] === b) continue;
          [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
          ++rows[y]; ++all;
          if (c[1] > c[2]) ++green;
        }
      const middle = Math.round((top + bottom) / 2), sum = (a, z) => rows.slice(a, z).reduce((s, n) => s + n, 0);
      return { width: right - left, height: bottom - top, above: sum(top, middle), below: sum(middle, bottom), green: green / all };
    });
    assert.ok(height > width && below > above && green > 0.8, JSON.stringify({ width, height, below, above, green }));
    return opened;
  },

  async the_program_ends_when_the_page_is_closed() {
    const mortal = await startStudio(program, fill, []);
    const { page } = await openPage(context, mortal.address, '#scene=tetra.pxm');
    await settled(page);
    assert.match(mortal.said.err, /ends 15 seconds after its last page is closed/);
    await page.reload();
    await settled(page);
    const begin = Date.now();
    await page.close();
    assert.equal(await mortal.ended, 0);
    const waited = (Date.now() - begin) / 1000;
    assert.ok(waited > 10 && waited < 40, `it waited ${waited} s`);
    await mortal.stop();
    return undefined;
  },

  async what_the_page_computes_itself_is_right() {
    const opened = await scene('tetra.pxm');
    const problems = await opened.page.evaluate(lawsOfModules);
    assert.deepEqual(problems, []);
    return opened;
  },

  async strangers_are_refused_and_the_page_is_quiet() {
    const opened = await scene('tetra.pxm');
    const origin = new URL(studio.address).origin;
    const stranger = await browser.newContext();
    const page = await stranger.newPage();
    assert.equal((await page.goto(`${origin}/`)).status(), 401);
    assert.equal((await page.goto(`${origin}/?token=${'0'.repeat(32)}`)).status(), 401);
    // A page of another site, with this studio's cookie in the same browser.
    const elsewhere = await context.newPage();
    await elsewhere.route('http://evil.example/**', route => route.fulfill({ contentType: 'text/html', body: '<p>hello' }));
    await elsewhere.goto('http://evil.example/');
    const stolen = await elsewhere.evaluate(async address => {
      const tried = [];
      for (const init of [{}, { credentials: 'include' }, { method: 'POST', body: '{}', credentials: 'include', mode: 'no-cors' }]) {
        try { const r = await fetch(`${address}/api/start`, init); tried.push(r.type === 'opaque' ? 'nothing' : await r.text()); } catch { tried.push('nothing'); }
      }
      return tried;
    }, origin);
    assert.deepEqual(stolen, ['nothing', 'nothing', 'nothing']);
    await elsewhere.close();
    await stranger.close();
    return opened;
  },
};

/// Waits until the program has read the text; of pictures that overlap very much one need not see all.
const read = page => page.waitForFunction(() => studio.base && !studio.checking.runs && !studio.handles.drag, null, { polling: 20 });

/// The maps that the page has are those that the program reads from its text.
async function agree(page) {
  const [own, theirs, text, field] = await page.evaluate(async () => {
    const { mapOf } = await import('/map_edits.js');
    const s = window.studio;
    return [s.outline.ifs[0].maps.map(m => mapOf(m, s.lets)), s.checked.ifs[0].maps.map(m => m.matrix), s.text === s.goodText, document.getElementById('text').value === s.text];
  });
  assert.ok(field, 'the field has the text');
  if (!text) {  // it does not contract: the program has refused it, and says so
    assert.ok(await page.isVisible('#mistakes'));
    return false;
  }
  assert.equal(own.length, theirs.length);
  own.forEach((map, i) => map.forEach((x, k) => assert.ok(Math.abs(x - theirs[i][k]) < 1e-9, `map ${i + 1}, number ${k}: ${x}, ${theirs[i][k]}`)));
  return true;
}

/// Saves the scene and has the program print what it reads there: what is printed is read as the same,
/// and is printed the same again.
async function savedAgrees(page) {
  if (await page.evaluate(() => studio.text !== studio.goodText)) return;
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => studio.saved === studio.text);
  const name = await page.evaluate(() => studio.name);
  assert.equal(readFileSync(join(studio.folder, name), 'utf8'), await page.evaluate(() => studio.text), 'the file has the text');
  const print = file => execFileSync(program, ['check', file, '--format'], { cwd: studio.folder, encoding: 'utf8' });
  const once = print(name);
  writeFileSync(join(studio.folder, 'printed_again.pxm'), once);
  assert.equal(print('printed_again.pxm'), once, 'what is printed is read as the same scene');
  rmSync(join(studio.folder, 'printed_again.pxm'));
}

/// Laws of the page's modules (runs in the page).
async function lawsOfModules() {
  const [decimal, vectors, camera, tokens, edits] = await Promise.all(['decimal', 'vectors', 'camera', 'scene_tokens', 'map_edits'].map(name => import(`/${name}.js`)));
  const problems = [];
  const law = (what, holds) => { if (!holds) problems.push(what); };
  for (const text of ['0', '-0.125', '12345678901234567890.000000000000000000000000000000000000000000000000000001'])
    law(`${text} is written as it is read`, decimal.toText(decimal.fromText(text)) === text);
  for (const x of [0, 1.5, -3e-30, 1e20, 0.1]) law(`${x} there and back`, Math.abs(decimal.toNumber(decimal.fromNumber(x)) - x) <= 1e-16 * Math.abs(x));
  law('a product', decimal.toNumber(decimal.times(decimal.fromText('3e-40'), 0.5)) === 1.5e-40);
  const map = vectors.followed(vectors.followed(vectors.scaling([0.5, 0.7, -0.2]), vectors.rotation('y', 33)), vectors.translation([1, 2, 3]));
  const back = vectors.followed(map, vectors.inverse(map));
  law('an inverse', back.every((x, i) => Math.abs(x - vectors.identity[i]) < 1e-12));
  law('the largest singular value', Math.abs(vectors.lipschitz(map) - 0.7) < 1e-12);
  let view = camera.cameraOf({ eye: ['0.4', '0.5', '-3'], look: ['0', '0', '0'], up: [0, 1, 0], half_width: 0.36, orthographic: null, zoom: 1 });
  law('a view that was not moved says nothing', camera.settingsOf(view).length === 0);
  const place = ['0.1', '0.2', '0.3'], exact = place.map(decimal.fromText);
  const before = camera.projected(view, place.map(Number));
  for (let i = 0; i < 10; ++i) view = camera.approached(view, exact, 3);
  const after = camera.projected(view, place.map(Number));
  law('what one flies to stays where it is', Math.abs(before.x - after.x) + Math.abs(before.y - after.y) < 1e-6);
  law('and comes nearer', Math.abs(after.ahead * 3 ** 10 / before.ahead - 1) < 1e-6);
  const seen = camera.fromAddress(camera.toAddress(view), view);
  law('the address says the view', Math.abs(camera.projected(seen, place.map(Number)).x - after.x) < 1e-4);
  const turned = camera.orbited(camera.orbited(view, 0.3, 0.1), -0.3, -0.1);
  law('to turn and to turn back', vectors.length(vectors.subtract(turned.away, view.away)) < 1e-9);
  law('expressions', Math.abs(tokens.valueOf('-2*cos(72)/third + sqrt(3)', new Map([['third', 1 / 3]])) - (Math.sqrt(3) - 6 * Math.cos(72 * Math.PI / 180))) < 1e-12);
  law('what is no expression', Number.isNaN(tokens.valueOf('1 +')) && Number.isNaN(tokens.valueOf('x')));
  const text = 'ifs a { # one\n  newmap b scale: 0.5 translate: 1/2,0,0 # two\n newmap scale: 1/3\n}\n';
  law('tokens are the text', tokens.tokensOf(text).map(t => t.text).join('') === text);
  const outline = tokens.outlineOf(text);
  law('maps are found', outline.ifs[0].maps.length === 2 && outline.ifs[0].maps[0].name === 'b');
  law('an edit changes its place', edits.setArgument(text, outline.ifs[0].maps[0].directives[1], 0, '0.25') === text.replace('1/2', '0.25'));
  const { PictureParts } = await import('/picture_parts.js');
  // 70 columns and 3 rows in two blocks, of rows without, with few and with nothing but other colours.
  const said = new TextEncoder().encode('{"engine":"native"}'), red = 0xff0000ff, blue = 0xffff0000;
  const columns = 70, rows = 3, pixels = Array.from({ length: columns * rows }, (_, i) => (i < columns ? red : i >= 2 * columns ? blue + i : i % 7 < 2 ? blue : red));
  const shorts = (...numbers) => [...new Uint8Array(Uint16Array.from(numbers).buffer)], words = numbers => [...new Uint8Array(Uint32Array.from(numbers).buffer)];
  const blockOf = (left, width, ground, machine) => {
    const bits = [], others = [], cycles = [];
    for (let row = 0; row < rows; ++row) {
      for (let x = 0; x < width; ++x) {
        const at = row * columns + left + x;
        if (x % 32 === 0) bits.push(0);
        cycles.push(at);
        if (pixels[at] === ground) continue;
        bits[bits.length - 1] += 2 ** (x % 32);
        others.push(pixels[at]);
      }
    }
    return [...shorts(left, 0, width, rows), ...words([ground, others.length, ...bits, ...others, ...(machine ? cycles : [])])];
  };
  for (const machine of [0, 1]) {
    const bytes = [...shorts(columns, rows, machine, 0), ...blockOf(64, 6, blue, machine), ...blockOf(0, 64, red, machine), ...words([0, 0, 0, said.length]), ...said];
    for (const length of [1, 2, 3, 5, 7, 16, 1000]) {
      const parts = new PictureParts(new ImageData(new Uint8ClampedArray(4 * columns * rows).fill(7), columns, rows));
      let complete = 0;
      for (let at = 0; at < bytes.length; at += length) {
        parts.add(Uint8Array.from(bytes.slice(at, at + length)));
        complete += parts.complete ? 1 : 0;
      }
      law(`a picture that comes by ${length} bytes`, [...new Uint32Array(parts.pixels.data.buffer)].join() === pixels.join() && complete === 1 &&
        (machine ? [...parts.cycles].every((n, i) => n === i) : parts.cycles === null) && parts.last().engine === 'native' && parts.fresh.length === 2);
    }
  }
  const graph = await import('/graph_edits.js');
  const rules = 'ifs a {\n    newmap one scale: 0.5\n    newmap scale: 0.4   # two\n    newmap scale: 0.3\n    follow: one -> 2, 3\n    follow: 2 -> one  # only\n    follow: 3 -> 3\n    start: one, 3\n}\n';
  const rulesOf = t => tokens.outlineOf(t).ifs[0];
  const table = t => graph.graphOf(rulesOf(t), t).allowed.map(row => row.map(Number).join('')).join(' ');
  law('rules are read', table(rules) === '011 100 001');
  law('numbers go along when a map goes', graph.withoutMap(rules, rulesOf(rules), 1) ===
    'ifs a {\n    newmap one scale: 0.5\n    newmap scale: 0.3\n    follow: one -> 2\n    follow: 2 -> 2\n    start: one, 2\n}\n');
  const copied = edits.copyMap(rules, rulesOf(rules), rulesOf(rules).maps[2]);
  const ruled = graph.withRulesOfCopy(copied, rulesOf(copied), 2);
  law('a copy stands where its model does', table(ruled) === '0111 1000 0011 0011' && ruled.includes('start: one, 3, 4\n    follow: 4 -> 3, 4\n}'));
  return problems;
}

/// Visible texts whose contrast is below 4.5 (runs in the page).
function contrastProblems() {
  const rgb = text => text.match(/[\d.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map(v => v / 255).map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = element => { for (let e = element; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] > 0.5) return c; } return [255, 255, 255]; };
  const faint = [];
  for (const element of document.querySelectorAll('header *, .side *, .strip *')) {
    if (element.id === 'text' || !element.offsetParent || element.disabled || ![...element.childNodes].some(n => n.nodeType === 3 && n.textContent.trim())) continue;
    const [a, b] = [light(rgb(getComputedStyle(element).color)), light(ground(element))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) faint.push(`${element.tagName}.${element.className} "${element.textContent.trim().slice(0, 20)}": ${contrast.toFixed(2)}`);
  }
  return faint;
}

let passed = 0;
try {
  for (const [name, test] of Object.entries(tests)) {
    if (only && !name.includes(only)) continue;
    const begin = Date.now();
    const opened = await test();
    if (opened) {
      assert.deepEqual(opened.complaints, [], `${name}: the browser has nothing to complain of`);
      await opened.page.close();
    }
    console.log(`${name}: ${((Date.now() - begin) / 1000).toFixed(1)} s`);
    ++passed;
  }
} finally {
  await browser.close();
  await studio.stop();
}
console.log(`${passed} passed, 0 failed`);
