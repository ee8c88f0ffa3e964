// What the page asks of the program. Every question has a number: of those of one kind the newest
// counts, and an older one is answered with null.
import { Line } from './line.js';
import { PictureParts } from './picture_parts.js';

/// Something that the program says is wrong; `mistakes` have their lines.
export class Refusal extends Error {
  constructor({ kind, message, mistakes }) {
    super(message);
    this.kind = kind;
    this.mistakes = mistakes;
  }
}

const page = [...crypto.getRandomValues(new Uint8Array(8))].map(b => b.toString(16).padStart(2, '0')).join('');
let serial = 0;

const gone = () => new Refusal({ kind: 'gone', message: 'The studio has ended. Start it again with pxm studio.', mistakes: [] });

async function ask(path, question) {
  let response;
  try {
    response = await fetch(path, question === undefined ? {} : {
      method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(question) });
  } catch {
    throw gone();
  }
  if (!response.ok) throw new Refusal({ kind: 'refused', message: (await response.text()).trim(), mistakes: [] });
  if (response.headers.get('Content-Type') !== 'application/json') return response;
  return judged(await response.json());
}

/// The answer, or null if it was overtaken.
function judged(answer) {
  if (answer.error) throw new Refusal(answer.error);
  if (!answer.superseded) return answer;
  if (answer.stopping_ms > 0) stops.push(answer.stopping_ms);
  if (stops.length > 200) stops.shift();
  return null;
}

/// How long work went on that was given up, milliseconds, as the program measured it.
export const stops = [];
export const lastStop = () => stops.at(-1) ?? null;

const textOf = bytes => new TextDecoder().decode(bytes);
const numbered = (kind, question) => ({ ...question, view: `${page}-${kind}`, serial: ++serial });

export const start = () => ask('/api/start');
export const open = name => ask('/api/open', { name });
export const save = (name, text, seen) => ask('/api/save', { name, text, seen });
export const check = scene => ask('/api/check', numbered('check', scene));
export const inspect = scene => ask('/api/inspect', numbered('inspect', scene));
export const pick = (picture, x, y) => ask('/api/pick', numbered('pick', { ...picture, x, y }));
export const pixel = (picture, x, y) => ask('/api/pixel', numbered('pixel', { ...picture, x, y }));

export const importFile = (name, data, entry) => ask('/api/import', numbered('import', { name, data, ...(entry === undefined ? {} : { entry }) }));
export const study = question => ask('/api/study', numbered('study', question));
export const exportFile = question => ask('/api/export', numbered('export', question));
/// How far the newest work of a kind is.
export const progress = kind => ask('/api/progress', { view: `${page}-${kind}` });
/// Gives up what the page has asked for: of one kind, or all of it.
export const stop = kind => ask('/api/leave', { view: `${page}-${kind}` });
export const stopAll = () => ask('/api/leave', { view: page });

const pictures = new Line('/api/picture', gone);

/// { head, pixels: ImageData, cycles: of the machine, Uint32Array, times }. `partly(parts)` hears
/// whenever a piece of it has come. `spare` is the pixels of a picture that nobody needs any more.
export async function picture(question, kind = 'picture', partly = () => {}, spare = null) {
  const times = { asked: performance.now() }, parts = new PictureParts(spare);
  const end = await pictures.ask(JSON.stringify(numbered(kind, question)), piece => {
    times.begun ??= performance.now();
    parts.add(piece);
    partly(parts);
    return parts.complete;
  });
  times.ended = performance.now();
  if (end && end.status !== 200) throw new Refusal({ kind: 'refused', message: textOf(end.bytes).trim(), mistakes: [] });
  const head = judged(end ? JSON.parse(textOf(end.bytes)) : parts.last());
  return head && { head, pixels: parts.pixels, cycles: parts.cycles, times };
}

export async function png(question, kind = 'png') {
  const response = await ask('/api/png', numbered(kind, question));
  return response && response.blob();
}

/// Tells the program that somebody is here for as long as a page is. A browser has six connections for
/// all tabs of a host: of several pages one keeps the line open for all, and another when that one goes.
export function stay(changed) {
  addEventListener('pagehide', () => {
    fetch('/api/leave', { method: 'POST', keepalive: true, headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ view: page }) }).catch(() => {});
  });
  navigator.locks.request('pxm-alive', () => new Promise(() => {
    const source = new EventSource(`/api/alive?view=${page}`);
    source.onopen = () => changed(true);
    source.onerror = () => changed(false);
  }));
}
