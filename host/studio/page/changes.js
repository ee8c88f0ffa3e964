// What differs between two texts, in words: those of the text, or those of the panel of maps.
import { stepsOf } from './map_edits.js';

const most = 60;  // characters of a piece of text
const brief = text => { const words = text.trim().replace(/\s+/g, ' '); return words.length > most ? `${words.slice(0, most)} …` : words; };

/// { line, was, is }: the first line that differs, and the pieces that do, with the words they belong to.
export function changeBetween(before, after) {
  const least = Math.min(before.length, after.length);
  let start = 0, end = 0;
  while (start < least && before[start] === after[start]) ++start;
  while (end < least - start && before[before.length - 1 - end] === after[after.length - 1 - end]) ++end;
  const shared = before.slice(0, start), rest = before.slice(before.length - end);
  const piece = text => text.slice(start, text.length - end);
  const pieces = [piece(before), piece(after)];
  if (pieces.some(text => /^\S/.test(text))) start -= /(?:\w+:[ \t]*)?\S*$/.exec(shared)[0].length;
  if (pieces.some(text => /\S$/.test(text))) end -= /^\S*/.exec(rest)[0].length;
  const blanks = Math.min(...[before, after].map(text => /^\s*/.exec(piece(text))[0].length));
  return { line: before.slice(0, start + blanks).split('\n').length, was: brief(piece(before)), is: brief(piece(after)) };
}

/// Undone in line 3: scale: 0.6 instead of scale: 0.85.
export function told(what, before, after) {
  const { line, was, is } = changeBetween(before, after);
  if (was === is) return `${what} in line ${line}: blanks.`;
  return `${what} in line ${line}: ${is === '' ? `${was} is gone` : was === '' ? `${is} is there` : `${is} instead of ${was}`}.`;
}

const nameOf = (block, index) => (block.maps[index].name ? `Map ${index + 1} ${block.maps[index].name}` : `Map ${index + 1}`);
const wordsOf = one => `${one.word} ${one.args.map(a => a.text).join(', ')}`;
const said = (text, one) => text.slice(one.start, one.end);

/// What is another in one map, as its card shows it; null where that does not say it.
function toldOfMap(name, was, is) {
  const [before, after] = [was, is].map(({ text, map }) => map.directives.map(d => said(text, d)));
  const differ = (a, b) => a.findIndex((words, i) => words !== b[i]);
  if (before.length === after.length) {
    const at = differ(before, after), one = is.map.directives[at];
    const others = after.filter((words, i) => words !== before[i]).length;
    if (others === 1 && one.word === was.map.directives[at].word) return `${name}: ${one.word} is ${one.args.map(a => a.text).join(', ')} again.`;
  }
  const [less, more] = before.length < after.length ? [before, after] : [after, before];
  const at = differ(more, less);
  if (more.length === less.length + 1 && more.every((words, i) => i === at || words === less[i < at ? i : i - 1]))
    return less === before ? `${name}: ${wordsOf(is.map.directives[at])} is there again.` : `${name}: ${wordsOf(was.map.directives[at])} is gone again.`;
  const steps = stepsOf(is.map).map(s => s.word);
  return steps.length > 0 ? `${name}: its steps are ${steps.join(', ')} again.` : null;
}

/// Undone. Map 2: translate is 0, 0.4, 0 again. Null where the change was none of the maps of one system.
export function toldOfMaps(what, was, is) {
  if (was.outline.ifs.length !== is.outline.ifs.length) return null;
  const textOf = ({ text }, block) => text.slice(block.start, block.end);
  const changed = is.outline.ifs.flatMap((block, i) => (textOf(is, block) === textOf(was, was.outline.ifs[i]) ? [] : [i]));
  if (changed.length !== 1) return null;
  const [before, after] = [was, is].map(scene => ({ text: scene.text, block: scene.outline.ifs[changed[0]] }));
  const mapsOf = ({ text, block }) => block.maps.map(m => said(text, m));
  const [old, now] = [mapsOf(before), mapsOf(after)];
  const of = is.outline.ifs.length > 1 ? ` of ${after.block.name}` : '';
  const more = now.length - old.length;
  const at = (more > 0 ? now : old).findIndex((words, i) => words !== (more > 0 ? old : now)[i]);
  if (more === 1) return `${what}. ${nameOf(after.block, at)}${of} is there again.`;
  if (more === -1) return `${what}. ${nameOf(before.block, at)}${of} is gone again.`;
  if (more !== 0) return null;
  const others = now.filter((words, i) => words !== old[i]).length;
  if (others === 0) return `${what}. What may stand in what${of} is as it was.`;
  const words = others === 1 && toldOfMap(`${nameOf(after.block, at)}${of}`, { text: before.text, map: before.block.maps[at] }, { text: after.text, map: after.block.maps[at] });
  return words ? `${what}. ${words}` : null;
}
