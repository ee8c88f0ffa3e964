// Which map may stand inside which (Ch. 4), as `follow` and `start` say it, and edits of that as new
// texts. Rules call maps by name or by number: where maps come and go, their numbers go along.
import { removalOf, splice } from './map_edits.js';

export const nameOf = (block, index) => block.maps[index].name || String(index + 1);

/// A map that a rule calls by its name or its number; -1 if there is none.
function indexOf(block, reference) {
  const text = reference.trim();
  const named = block.maps.findIndex(m => m.name === text);
  return named >= 0 ? named : /^\d+$/.test(text) && Number(text) <= block.maps.length ? Number(text) - 1 : -1;
}

/// { rules: of each map, allowed: [[bool]] }; without a rule every map may come next.
export function graphOf(block, text) {
  const rules = block.maps.map(() => []);
  for (const rule of block.rules.filter(r => r.word === 'follow')) {
    const words = text.slice(rule.values.start, rule.values.end).replace(/#[^\n]*/g, '');
    const [from, to] = words.split('->');
    const map = indexOf(block, from);
    if (map >= 0 && to !== undefined) rules[map].push({ rule, followers: to.split(',').map(r => indexOf(block, r)) });
  }
  const allowed = rules.map(list => block.maps.map((_, m) => list.length === 0 || list.some(r => r.followers.includes(m))));
  return { rules, allowed };
}

/// Several changes of places at once.
const changed = (text, changes) =>
  changes.sort((a, b) => b.start - a.start).reduce((t, { start, end, put }) => splice(t, start, end, put), text);

const ruleOf = (block, map, followers) => `follow: ${nameOf(block, map)} -> ${followers.map(m => nameOf(block, m)).join(', ')}`;

/// Where another rule goes: behind the last one, or behind the last map and its comment.
function placeOfRule(text, block) {
  const last = block.rules.at(-1)?.end ?? block.maps.at(-1).end;
  return last + (/^[ \t]*#[^\n]*/.exec(text.slice(last))?.[0].length ?? 0);
}

/// The text with the followers of one map as they shall be: one rule, or none where all may come.
export function setFollowers(text, block, map, followers) {
  const [first, ...others] = graphOf(block, text).rules[map].map(r => r.rule);
  const changes = others.map(rule => ({ ...removalOf(text, rule), put: '' }));
  const all = followers.length === block.maps.length;
  if (first) changes.push(all ? { ...removalOf(text, first), put: '' } : { start: first.start, end: first.end, put: ruleOf(block, map, followers) });
  else if (!all) {
    const place = placeOfRule(text, block);
    changes.push({ start: place, end: place, put: `\n    ${ruleOf(block, map, followers)}` });
  }
  return changed(text, changes);
}

/// References of a rule with their places: { map, start, end }, the one before the arrow first.
function referencesOf(text, block, rule) {
  const words = text.slice(rule.values.start, rule.values.end).replace(/#[^\n]*/g, c => ' '.repeat(c.length));
  return [...words.matchAll(/\w+/g)].map(m => ({ map: indexOf(block, m[0]), text: m[0],
    start: rule.values.start + m.index, end: rule.values.start + m.index + m[0].length }));
}

const listOf = references => references.map(r => r.text).join(', ');

/// The text without a map, and without it in the rules; numbers behind it become one less.
export function withoutMap(text, block, map) {
  const changes = [{ ...removalOf(text, block.maps[map]), put: '' }];
  for (const rule of block.rules) {
    const all = referencesOf(text, block, rule);
    const renumbered = r => ({ ...r, text: /^\d+$/.test(r.text) && r.map > map ? String(Number(r.text) - 1) : r.text });
    const [from, list] = rule.word === 'follow' ? [all[0], all.slice(1)] : [null, all];
    const left = list.filter(r => r.map !== map).map(renumbered);
    if (from?.map === map || left.length === 0) changes.push({ ...removalOf(text, rule), put: '' });
    else changes.push({ start: rule.values.start, end: rule.values.end, put: `${from ? `${renumbered(from).text} -> ` : ''}${listOf(left)}` });
  }
  return changed(text, changes);
}

/// The text in which the last map, a copy of `source`, may stand where that one may, and holds what that
/// one holds.
export function withRulesOfCopy(text, block, source) {
  const copy = block.maps.length - 1;
  const added = [], longer = [];
  for (const rule of block.rules) {
    const all = referencesOf(text, block, rule);
    const list = rule.word === 'follow' ? all.slice(1) : all;
    const holds = list.some(r => r.map === source);
    if (holds) longer.push({ start: list.at(-1).end, end: list.at(-1).end, put: `, ${nameOf(block, copy)}` });
    if (rule.word !== 'follow' || all[0]?.map !== source) continue;
    const followers = holds ? [...list, { text: nameOf(block, copy) }] : list;
    const place = placeOfRule(text, block);
    added.push({ start: place, end: place, put: `\n    follow: ${nameOf(block, copy)} -> ${listOf(followers)}` });
  }
  // Where a rule goes behind a list that becomes longer, it is put there first.
  return changed(text, [...added, ...longer]);
}
