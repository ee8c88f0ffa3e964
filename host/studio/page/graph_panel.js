// Which map may stand inside which (Ch. 4): a row a map, a box for every map that may come next in it.
import { element } from './elements.js';
import { graphOf, nameOf, setFollowers } from './graph_edits.js';
import { graphPicture } from './graph_picture.js';

const most_maps = 24;    // more make a table that nobody reads
const most_drawn = 12;   // and a picture that nobody reads

/// `state.chosen` is the map of the picture that was clicked first, of `state.block`.
export function graphPanel(scene, edit, state, redraw) {
  const { text, outline, ifs } = scene();
  const block = outline.ifs[ifs];
  if (!block || block.maps.length === 0 || block.maps.length > most_maps) return null;
  const { allowed } = graphOf(block, text);
  if (state.block !== block.name || state.chosen >= block.maps.length) Object.assign(state, { block: block.name, chosen: -1 });
  /// Whether that is what it became: something has to stand in every map.
  const set = (from, to, is) => {
    const now = scene();
    const current = now.outline.ifs[now.ifs];
    const followers = graphOf(current, now.text).allowed[from].flatMap((was, m) => ((m === to ? is : was) ? [m] : []));
    if (followers.length === 0) return false;
    edit(setFollowers(now.text, current, from, followers));
    return true;
  };
  const box = (from, to) => element('input', { type: 'checkbox', checked: allowed[from][to], 'data-key': `graph.${from}.${to}`,
    'aria-label': `${nameOf(block, to)} inside ${nameOf(block, from)}`, title: `${nameOf(block, to)} inside ${nameOf(block, from)}`,
    onchange: event => { if (!set(from, to, event.target.checked)) event.target.checked = true; } });
  const choose = map => { state.chosen = map; redraw(); };
  const picture = block.maps.length > most_drawn ? null
    : graphPicture(block, allowed, state.chosen, choose, (from, to) => { if (!set(from, to, !allowed[from][to])) redraw(); });
  return element('details', { class: 'graph', open: state.open ?? allowed.some(row => row.includes(false)), ontoggle: e => { state.open = e.target.open; } },
    element('summary', {}, 'What may stand in what'), picture,
    element('div', { class: 'scroll' }, element('table', {},
      element('thead', {}, element('tr', {}, element('th', {}, 'in'), ...block.maps.map((_, m) => element('th', {}, nameOf(block, m))))),
      element('tbody', {}, ...block.maps.map((_, from) => element('tr', {}, element('th', { scope: 'row' }, nameOf(block, from)),
        ...block.maps.map((__, to) => element('td', {}, box(from, to)))))))));
}
