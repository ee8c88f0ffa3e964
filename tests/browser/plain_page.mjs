// A page in a headless Chromium that nobody watches: playwright-core listens to every request, which takes
// the time of those who are measured.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { executablePath } from './studio.mjs';

/// The page at an address, in a window of `width` x `height`.
export async function openPlainPage(address, width, height) {
  const profile = mkdtempSync(join(tmpdir(), 'pxm-chromium-'));
  const child = spawn(executablePath, ['--headless=new', '--no-sandbox', '--no-first-run', '--hide-scrollbars', '--mute-audio', '--disable-background-networking', '--disable-component-update', '--disable-extensions', '--disable-sync',
    `--window-size=${width},${height}`, `--user-data-dir=${profile}`, '--remote-debugging-pipe', 'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const waiting = new Map();
  let last = 0, unread = '';
  child.stdio[4].setEncoding('utf8').on('data', text => {
    const messages = (unread + text).split('\0');
    unread = messages.pop();
    for (const { id, result, error } of messages.map(m => JSON.parse(m))) {
      const { done, failed } = waiting.get(id) ?? {};
      waiting.delete(id);
      if (error) failed?.(new Error(error.message));
      else done?.(result);
    }
  });
  const send = (method, params = {}, sessionId = undefined) => new Promise((done, failed) => {
    waiting.set(++last, { done, failed });
    child.stdio[3].write(`${JSON.stringify({ id: last, method, params, sessionId })}\0`);
  });
  const { targetInfos } = await send('Target.getTargets');
  const { sessionId } = await send('Target.attachToTarget', { targetId: targetInfos.find(t => t.type === 'page').targetId, flatten: true });
  const ask = (method, params) => send(method, params, sessionId);

  /// What an expression is, waited for, in the page.
  const evaluate = async expression => {
    const { result, exceptionDetails } = await ask('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  };
  /// A key as a keyboard sends it, which has no character.
  const press = async key => {
    for (const type of ['rawKeyDown', 'keyUp']) await ask('Input.dispatchKeyEvent', { type, key, code: key, windowsVirtualKeyCode: { ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40 }[key] });
  };
  const close = async () => {
    const ended = new Promise(done => child.on('exit', done));
    await send('Browser.close');
    await ended;
    rmSync(profile, { recursive: true, force: true });
  };
  await ask('Page.navigate', { url: address });
  return { ask, evaluate, press, close };
}
