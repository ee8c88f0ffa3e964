// Which map may stand inside which (Ch. 4): a row a map, a box for every map that may come next in it.
import { element } from './elements.js';
import { graphOf, nameOf, setFollowers } from './graph_edits.js';

const most_maps = 24;  // more make a table that nobody reads

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
