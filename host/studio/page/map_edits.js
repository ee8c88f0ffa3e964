// Edits of maps as new texts: each changes the places it means and nothing else.
import { stepWords, valueOf } from './scene_tokens.js';
import { followed, identity, rotation, scaling, tetrahedronMap, translation } from './vectors.js';

export const splice = (text, start, end, put) => text.slice(0, start) + put + text.slice(end);

/// A number as one would write it: six significant digits, no zeros for nothing.
export const short = x => String(Number(Math.abs(x) < 1e-9 ? 0 : x.toPrecision(6)));

export const stepsOf = map => map.directives.filter(d => stepWords.includes(d.word));

/// Four points in parentheses.
function pointsOf(text, lets) {
  const points = [...text.matchAll(/\(([^()]*)\)/g)].map(m => m[1].split(',').map(x => valueOf(x, lets)));
  return points.length === 4 && points.every(p => p.length === 3) ? points : null;
}
export function cornersOf(step, lets) {
  const [from, to] = step.args.map(a => a.text).join(',').split('->').map(t => pointsOf(t, lets));
  return from && to ? { from, to } : null;
}

/// The affine map of a step; null where it cannot be told from the text alone.
export function stepMap(step, lets) {
  const values = step.args.map(a => valueOf(a.text, lets));
  switch (step.word) {
    case 'scale': return values.length === 1 || values.length === 3 ? scaling(values.length === 1 ? Array(3).fill(values[0]) : values) : null;
    case 'rotate': return /^[xyz]$/.test(step.args[0]?.text) ? rotation(step.args[0].text, values[1]) : null;
    case 'translate': return values.length === 3 ? translation(values) : null;
    case 'matrix': return values.length === 12 ? values : null;
    case 'tetrahedron': { const c = cornersOf(step, lets); return c && tetrahedronMap(c.from, c.to); }
    default: return null;
  }
}

/// All steps one after another; null if a step or a number is not known.
export function mapOf(map, lets) {
  let all = identity;
  for (const step of stepsOf(map)) {
    const one = stepMap(step, lets);
    if (!one || one.some(x => !Number.isFinite(x))) return null;
    all = followed(all, one);
  }
  return all;
}

const lineStart = (text, at) => text.lastIndexOf('\n', at - 1) + 1;
const indentOf = (text, at) => /^[ \t]*/.exec(text.slice(lineStart(text, at)))[0];
const standsAlone = (text, at) => text.slice(lineStart(text, at), at).trim() === '';

/// Puts a directive behind a place, on a line of its own where its neighbour has one.
function insertAfter(text, map, place, like, words) {
  const own = like && standsAlone(text, like.start);
  return splice(text, place, place, own ? `\n${indentOf(text, like.start)}${words}` : ` ${words}`);
}

export function setArgument(text, directive, index, value) {
  const { start, end } = directive.args[index];
  return splice(text, start, end, value);
}

/// A directive's values as a whole.
export const setValues = (text, directive, values) =>
  splice(text, directive.values.start, directive.values.end, (directive.values.start === directive.values.end ? ' ' : '') + values);

export const defaultStep = { scale: 'scale: 0.5', rotate: 'rotate: y,30', translate: 'translate: 0.2,0,0', matrix: 'matrix: 1,0,0, 0,1,0, 0,0,1, 0,0,0' };

export function addStep(text, map, words) {
  const last = stepsOf(map).at(-1);
  return insertAfter(text, map, last?.end ?? map.head, last, words);
}

/// What goes with a piece of text that is taken out: the blanks before it; or its line, if it was alone
/// there, with what is remarked behind it.
export function removalOf(text, { start, end }) {
  const from = lineStart(text, start);
  const rest = /^[ \t]*(#[^\n]*)?(?=\n|$)/.exec(text.slice(end));
  if (text.slice(from, start).trim() === '' && rest && from > 0) return { start: from - 1, end: end + rest[0].length };
  return { start: start - /[ \t]*$/.exec(text.slice(0, start))[0].length, end };
}
function removed(text, range) {
  const { start, end } = removalOf(text, range);
  return splice(text, start, end, '');
}
export const removeDirective = removed;

/// The step at `from` comes to stand at `to`; comments stay where they are.
export function moveStep(text, map, from, to) {
  const steps = stepsOf(map);
  const words = steps.map(s => text.slice(s.start, s.end));
  words.splice(to, 0, ...words.splice(from, 1));
  return steps.reduceRight((t, step, i) => splice(t, step.start, step.end, words[i]), text);
}

/// One step in place of all: the first makes room for it.
export function replaceSteps(text, map, words) {
  const steps = stepsOf(map);
  if (steps.length === 0) return addStep(text, map, words);
  const rest = steps.slice(1).reduceRight((t, step) => removed(t, step), text);
  return splice(rest, steps[0].start, steps[0].end, words);
}

export function addMap(text, block, words) {
  const last = block.maps.at(-1);
  if (!last) return splice(text, block.close, block.close, `    ${words}\n`);
  // Behind a comment on the line of the last map.
  const comment = /^[ \t]*#[^\n]*/.exec(text.slice(last.end));
  const place = last.end + (comment ? comment[0].length : 0);
  return splice(text, place, place, `\n${indentOf(text, last.start) || '    '}${words}`);
}

/// A copy behind the last map, without a name of its own.
export function copyMap(text, block, map, more = '') {
  const words = text.slice(map.head, map.end).replace(/#[^\n]*/g, '').trim().replace(/\s*\n\s*/g, ' ');
  return addMap(text, block, `newmap ${words}${more && ` ${more}`}`);
}

export const mirrored = axis => ({ x: 'scale: -1,1,1', y: 'scale: 1,-1,1', z: 'scale: 1,1,-1' })[axis];

/// Sets a directive that a map has once, or adds it.
export function setOnce(text, map, word, values) {
  const found = map.directives.find(d => d.word === word);
  if (found) return values === '' ? removed(text, found) : setValues(text, found, values);
  if (values === '') return text;
  const last = map.directives.at(-1);
  return insertAfter(text, map, last?.end ?? map.head, last, `${word}: ${values}`);
}

const corner = p => `(${p.map(short).join(',')})`;
export const tetrahedronStep = (from, to) => `tetrahedron: ${from.map(corner).join('')} -> ${to.map(corner).join('')}`;

/// Moves a map as a whole: its last translation grows, its tetrahedron goes along, or a step is added.
export function moveMap(text, map, lets, offset) {
  const last = stepsOf(map).at(-1);
  const sum = p => p.map((x, i) => x + offset[i]);
  if (last?.word === 'translate' && last.args.length === 3) {
    const now = last.args.map(a => valueOf(a.text, lets));
    if (now.every(Number.isFinite)) return setValues(text, last, sum(now).map(short).join(','));
  }
  const corners = last?.word === 'tetrahedron' ? cornersOf(last, lets) : null;
  if (corners) return splice(text, last.start, last.end, tetrahedronStep(corners.from, corners.to.map(sum)));
  return addStep(text, map, `translate: ${offset.map(short).join(',')}`);
}
