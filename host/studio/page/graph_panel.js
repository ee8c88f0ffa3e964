// Which map may stand inside which (Ch. 4): a row a map, a box for every map that may come next in it.
import { element } from './elements.js';
import { splice } from './map_edits.js';

const most_maps = 24;  // more make a table that nobody reads

const nameOf = (block, index) => block.maps[index].name || String(index + 1);

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

/// The text with the followers of one map as they shall be: one rule, or none where all may come.
export function setFollowers(text, block, map, followers) {
  const { rules } = graphOf(block, text);
  const words = `follow: ${nameOf(block, map)} -> ${followers.map(m => nameOf(block, m)).join(', ')}`;
  const all = followers.length === block.maps.length;
  const [first, ...others] = rules[map].map(r => r.rule);
  let changed = text;
  for (const rule of others.reverse()) changed = withoutLine(changed, rule);
  if (first) return all ? withoutLine(changed, first) : splice(changed, first.start, first.end, words);
  if (all) return changed;
  const last = block.rules.at(-1)?.end ?? block.maps.at(-1).end;
  const comment = /^[ \t]*#[^\n]*/.exec(changed.slice(last));
  const place = last + (comment ? comment[0].length : 0);
  return splice(changed, place, place, `\n    ${words}`);
}

function withoutLine(text, { start, end }) {
  const from = text.lastIndexOf('\n', start - 1);
  const alone = from >= 0 && text.slice(from + 1, start).trim() === '' && /^[ \t]*(\n|$)/.test(text.slice(end));
  return alone ? splice(text, from, end, '') : splice(text, start, end, '');
}

export function graphPanel(scene, edit) {
  const { text, outline, ifs } = scene();
  const block = outline.ifs[ifs];
  if (!block || block.maps.length === 0 || block.maps.length > most_maps) return null;
  const { allowed } = graphOf(block, text);
  const box = (from, to) => element('input', { type: 'checkbox', checked: allowed[from][to], 'data-key': `graph.${from}.${to}`,
    'aria-label': `${nameOf(block, to)} inside ${nameOf(block, from)}`, title: `${nameOf(block, to)} inside ${nameOf(block, from)}`,
    onchange: event => {
      const now = scene();
      const current = now.outline.ifs[now.ifs];
      const row = graphOf(current, now.text).allowed[from].map((is, m) => (m === to ? event.target.checked : is));
      const followers = row.flatMap((is, m) => (is ? [m] : []));
      if (followers.length === 0) event.target.checked = true;  // something has to stand in every map
      else edit(setFollowers(now.text, current, from, followers));
    } });
  return element('details', { class: 'graph', open: allowed.some(row => row.includes(false)) }, element('summary', {}, 'What may stand in what'),
    element('div', { class: 'scroll' }, element('table', {},
      element('thead', {}, element('tr', {}, element('th', {}, 'in'), ...block.maps.map((_, m) => element('th', {}, nameOf(block, m))))),
      element('tbody', {}, ...block.maps.map((_, from) => element('tr', {}, element('th', { scope: 'row' }, nameOf(block, from)),
        ...block.maps.map((__, to) => element('td', {}, box(from, to)))))))));
}
