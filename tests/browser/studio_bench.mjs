// node studio_bench.mjs PXM SCENE: see bench/studio.
import { execFileSync } from 'node:child_process';
import { cpSync, readFileSync } from 'node:fs';
import { loadavg, cpus } from 'node:os';
import { join, resolve } from 'node:path';
import { openPlainPage } from './plain_page.mjs';
import { openPage, settled, startBrowser, startStudio, tasksWhile } from './studio.mjs';

const [program, scene] = process.argv.slice(2).map(p => resolve(p));
const turns = 40, crowd = 10_000, overtaken = 20;
const hash = '#scene=scene.pxm&tab=text', width = 1704, height = 900;
const median = list => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
const memory = pid => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1]) / 1024;
const pause = time => new Promise(done => setTimeout(done, time));

/// The stage as large as the picture is to be, whatever stands around it.
const resize = `{
  const s = document.getElementById('stage');
  s.style.flex = 'none'; s.style.width = '1280px'; s.style.height = '720px';
  document.getElementById('samples').value = '1';
}`;
const at_rest = 'Boolean(window.studio?.base) && !studio.checking.runs && studio.live.shown === studio.live.version && !studio.live.running';

/// A page that is let alone while it works: to be asked takes its time.
const rested = async page => { do await pause(120); while (!await page.evaluate(at_rest)); };

/// Turns, and `pxm render` with the same command after every fourth.
async function timesOfTurns(page, studio) {
  const first = [], ratios = [], since = [], parts = {};
  const note = (name, milliseconds) => { (parts[name] ??= []).push(milliseconds); };
  /// Where the time of a whole picture went, by both clocks.
  const explain = ({ took, times, seconds }, command) => {
    note('until the answer begins', times.begun - times.asked);
    note('until its last byte has come', times.ended - times.asked);
    note('until it is drawn', took);
    for (const [name, keys] of [['the program prepares', ['parse', 'compile', 'load']], ['renders', ['render']], ['makes bytes of pixels', ['encode']], ['all of it', ['total']]])
      note(name, 1000 * keys.reduce((sum, key) => sum + seconds[key], 0));
    note('pxm render renders', 1000 * command);
  };
  for (let i = 0; i < turns; ++i) {
    await page.evaluate("studio.timings.length = 0; document.getElementById('handles').focus()");
    await page.press(i % 8 < 4 ? 'ArrowRight' : 'ArrowUp');
    await rested(page);
    const { timings, command } = await page.evaluate("(async () => ({ timings: studio.timings, command: (await import('/command.js')).commandOf(studio.finished()) }))()");
    first.push(timings[0].since);
    const whole = timings.find(t => t.phase === 'whole');
    if (i % 4 !== 0) continue;
    execFileSync('/bin/sh', ['-c', `${command.replace(/^pxm/, '"$PXM"')} --stats stats.json --quiet`], { cwd: studio.folder, env: { ...process.env, PXM: program } });
    const { render } = JSON.parse(readFileSync(join(studio.folder, 'stats.json'), 'utf8')).seconds;
    ratios.push(whole.took / 1000 / render);
    since.push(whole.since / 1000 / render);
    explain(whole, render);
  }
  return { first, ratios, since, parts };
}

/// How soon there is room for the next picture, and how long the last one is worked on after that.
const timesOfOvertaken = page => page.evaluate(`(async () => {
  const server = await import('/server.js');
  const times = [];
  server.stops.length = 0;
  for (let i = 0; i < ${overtaken}; ++i) {
    const slow = server.picture({ ...studio.finished(), samples: 64 }).catch(() => null);
    await new Promise(done => setTimeout(done, 60));
    const begin = performance.now();
    await server.picture({ ...studio.finished(), columns: 8, rows: 8, samples: 1 });
    times.push(performance.now() - begin);
    await slow;
  }
  return { times, stops: server.stops };
})()`);

/// Megabytes of the program and of the page's heap, before and after many turns.
async function memoryOfTurns(page, pid) {
  const now = async () => {
    await page.ask('HeapProfiler.collectGarbage');
    return { program: memory(pid), page: (await page.ask('Runtime.getHeapUsage')).usedSize / 2 ** 20 };
  };
  const before = await now();
  await page.evaluate(`(async () => {
    const { orbited } = await import('/camera.js');
    for (let i = 0; i < ${crowd}; ++i) {
      studio.setCamera(orbited(studio.camera, 0.01, 0), 'bench');
      if (i % 20 === 0) await new Promise(done => setTimeout(done, 10));
    }
  })()`);
  await rested(page);
  return { before, after: await now() };
}

/// Of the page's thread while one drags. This page is watched, as the browser's trace tells of them.
async function tasksOfDrag(studio) {
  const { browser, context } = await startBrowser({ viewport: { width, height } });
  try {
    const { page } = await openPage(context, studio.address, hash);
    await settled(page);
    await page.evaluate(resize);
    await page.waitForFunction(() => studio.live.size.columns === 1280);
    await settled(page);
    return await tasksWhile(page, async () => {
      const box = await page.locator('#handles').boundingBox();
      await page.mouse.move(box.x + 12, box.y + 12);
      await page.mouse.down();
      for (let i = 1; i <= 60; ++i) await page.mouse.move(box.x + 12 + 2 * i, box.y + 12 + 20 * Math.sin(i / 5));
      await page.mouse.up();
    });
  } finally {
    await browser.close();
  }
}

const studio = await startStudio(program, folder => cpSync(scene, join(folder, 'scene.pxm')));
try {
  const page = await openPlainPage(studio.address + hash, width, height);
  await rested(page);
  await page.evaluate(resize);
  await rested(page);
  const size = await page.evaluate('studio.live.size');
  if (size.columns !== 1280 || size.rows !== 720) throw new Error(`the picture has ${size.columns}x${size.rows} pixels`);

  const { first, ratios, since, parts } = await timesOfTurns(page, studio);
  const { times, stops } = await timesOfOvertaken(page);
  const { before, after } = await memoryOfTurns(page, studio.child.pid);
  await page.close();
  const tasks = await tasksOfDrag(studio);

  console.log(`${cpus().length} processors, load ${loadavg()[0].toFixed(1)}`);
  console.log(`first picture after a turn, median: ${median(first).toFixed(0)} ms`);
  console.log(`whole picture over the render phase of pxm render, median: ${median(ratios).toFixed(2)}`);
  console.log(`the same from the turn on: ${median(since).toFixed(2)}`);
  for (const [name, list] of Object.entries(parts)) console.log(`  ${name}: ${median(list).toFixed(1)} ms`);
  console.log(`a picture that is overtaken makes room, median: ${median(times).toFixed(0)} ms`);
  console.log(`its work goes on after that, median of ${stops.length}: ${median(stops).toFixed(1)} ms, at most ${Math.max(...stops).toFixed(1)} ms`);
  console.log(`memory of the program before and after ${crowd} turns: ${before.program.toFixed(0)} and ${after.program.toFixed(0)} MB, of the page's heap: ${before.page.toFixed(1)} and ${after.page.toFixed(1)} MB`);
  console.log(`the longest of ${tasks.count} tasks of the page's thread while one drags: ${tasks.longest.toFixed(1)} ms${tasks.own_time ? ' of its own time' : ''}`);
} finally {
  await studio.stop();
}
