// A studio in its own folder, with a page of it in a headless Chromium.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { skip } from './browser.mjs';

export const executablePath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(path => existsSync(path));

/// Starts `program studio` in a new folder; `fill(folder)` puts scenes there.
export async function startStudio(program, fill = () => {}, options = ['--no-browser']) {
  const folder = mkdtempSync(join(tmpdir(), 'pxm-studio-'));
  fill(folder);
  const child = spawn(program, ['studio', ...options], { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, DISPLAY: '', WAYLAND_DISPLAY: '' } });
  const said = { err: '' };
  child.stderr.on('data', data => { said.err += data; });
  const ended = new Promise(done => child.on('exit', code => done(code)));
  const address = await new Promise((done, failed) => {
    let out = '';
    child.stdout.on('data', data => { out += data; if (out.includes('\n')) done(out.trim()); });
    ended.then(() => failed(new Error(`pxm studio ended: ${said.err}`)));
  });
  const stop = async () => {
    child.kill('SIGTERM');
    await ended;
    rmSync(folder, { recursive: true, force: true });
  };
  return { address, folder, child, ended, said, stop };
}

export async function startBrowser(options = {}) {
  if (!executablePath) skip('no Chromium (apt-get install chromium)');
  let playwright;
  try {
    playwright = await import('playwright-core');
  } catch {
    skip('no playwright-core (npm install --prefix tests/browser)');
  }
  const browser = await playwright.chromium.launch({ executablePath, args: ['--no-sandbox'] });
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  return { browser, context };
}

/// A page, and what the browser complains of, or asks of anybody but the studio.
export async function openPage(context, address, hash = '') {
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  const complaints = [];
  const origin = new URL(address).origin;
  page.on('console', message => { if (['error', 'warning'].includes(message.type())) complaints.push(message.text()); });
  page.on('pageerror', error => complaints.push(String(error)));
  page.on('request', request => { if (!request.url().startsWith(origin) && !/^(blob|data):/.test(request.url())) complaints.push(`asks for ${request.url()}`); });
  await page.goto(address + hash);
  return { page, complaints };
}

/// Waits until nothing is being computed for the page.
export async function settled(page) {
  try {
    await page.waitForFunction(() => {
      const studio = window.studio;
      return studio && studio.base && !studio.checking.runs && !studio.flight.asking && studio.live.shown === studio.live.version && !studio.live.running;
    }, null, { polling: 50 });
  } catch (error) {
    const state = await page.evaluate(() => {
      const { base, checking, flight, live, name, text, goodText } = window.studio;
      return { name, checked: text === goodText, base: Boolean(base), checking: Boolean(checking.runs), wanted: checking.wanted, flight: flight.asking, shown: live.shown, version: live.version, running: live.running,
        mistakes: document.getElementById('mistakes').textContent, toast: document.getElementById('toast').textContent };
    });
    throw new Error(`the page does not come to rest: ${JSON.stringify(state)}`, { cause: error });
  }
}

/// The longest tasks of the page's thread while something is done, milliseconds of its own time.
export async function tasksWhile(page, work) {
  const session = await page.context().newCDPSession(page);
  const events = [];
  session.on('Tracing.dataCollected', ({ value }) => events.push(...value));
  await session.send('Tracing.start', { transferMode: 'ReportEvents', traceConfig: { includedCategories: ['toplevel', 'devtools.timeline', 'disabled-by-default-devtools.timeline'] } });
  await work();
  const complete = new Promise(done => session.once('Tracing.tracingComplete', done));
  await session.send('Tracing.end');
  await complete;
  await session.detach();
  const scripts = events.filter(e => e.name === 'FunctionCall' && e.args?.data?.url?.startsWith(new URL(page.url()).origin));
  const threads = new Set((scripts.length > 0 ? scripts : events.filter(e => e.name === 'FunctionCall')).map(e => `${e.pid} ${e.tid}`));
  const tasks = events.filter(e => e.name === 'RunTask' && e.ph === 'X' && threads.has(`${e.pid} ${e.tid}`));
  return { count: tasks.length, longest: Math.max(...tasks.map(e => (e.tdur ?? e.dur) / 1000)), own_time: tasks.some(e => e.tdur !== undefined) };
}

/// Pixels as one text, to compare: of the picture in the page, or of a PNG's bytes.
export const pixelsOf = (page, png = null) => page.evaluate(async base64 => {
  const source = base64 === null ? document.getElementById('picture')
    : await createImageBitmap(new Blob([Uint8Array.from(atob(base64), c => c.charCodeAt(0))], { type: 'image/png' }));
  const copy = new OffscreenCanvas(source.width, source.height);
  const context = copy.getContext('2d', { willReadFrequently: true });
  context.drawImage(source, 0, 0);
  const digest = await crypto.subtle.digest('SHA-256', context.getImageData(0, 0, copy.width, copy.height).data);
  return `${copy.width}x${copy.height} ${[...new Uint8Array(digest)].map(b => b.toString(16).padStart(2, '0')).join('')}`;
}, png && png.toString('base64'));
