// The graph of a system as a picture (Ch. 4): its maps in a round, and an arrow from each to every map
// that may stand in it. A click on a map, then on another one, allows or forbids that; so does a click
// on an arrow.
import { element } from './elements.js';
import { nameOf } from './graph_edits.js';

const svg = (tag, attributes, ...children) => {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
};

const half = 130, ring = 88, dot = 15;  // of the picture, in its own units

const placeOf = (index, count) => {
  const angle = 2 * Math.PI * index / count - Math.PI / 2;
  const far = count === 1 ? 0 : ring;
  return [far * Math.cos(angle), far * Math.sin(angle)];
};

/// An arrow from a circle to another, bent to its right so that the way back has a place; or round to
/// where it came from, outward.
function pathOf(from, to, count) {
  const [a, b] = [placeOf(from, count), placeOf(to, count)];
  if (from === to) {
    const out = count === 1 ? -Math.PI / 2 : Math.atan2(a[1], a[0]);
    const at = (turn, far) => `${a[0] + far * Math.cos(out + turn)} ${a[1] + far * Math.sin(out + turn)}`;
    return `M ${at(-0.7, dot)} C ${at(-0.8, 46)}, ${at(0.8, 46)}, ${at(0.62, dot + 3)}`;
  }
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]], far = Math.hypot(dx, dy);
  const middle = [(a[0] + b[0]) / 2 - dy * 0.14, (a[1] + b[1]) / 2 + dx * 0.14];
  const toward = (p, r) => { const l = Math.hypot(middle[0] - p[0], middle[1] - p[1]); return [p[0] + (middle[0] - p[0]) * r / l, p[1] + (middle[1] - p[1]) * r / l]; };
  const [s, e] = [toward(a, Math.min(dot, far / 3)), toward(b, Math.min(dot + 3, far / 3))];
  return `M ${s.join(' ')} Q ${middle.join(' ')} ${e.join(' ')}`;
}

/// `toggle(from, to)`; `chosen` is the map that was clicked first, or -1, and `choose(map)` tells it.
export function graphPicture(block, allowed, chosen, choose, toggle) {
  const count = block.maps.length;
  const spoken = (from, to) => `${nameOf(block, to)} inside ${nameOf(block, from)}`;
  const arrow = (from, to) => svg('g', { class: 'arrow', onclick: () => toggle(from, to) },
    svg('title', {}, `${spoken(from, to)}: click to forbid it`),
    svg('path', { d: pathOf(from, to, count), class: 'wide' }),
    svg('path', { d: pathOf(from, to, count), 'marker-end': 'url(#arrow-head)', class: from === chosen ? 'line from' : 'line' }));
  const press = map => (chosen < 0 ? choose(map) : toggle(chosen, map));
  const node = map => {
    const [x, y] = placeOf(map, count);
    return svg('g', { class: map === chosen ? 'node chosen' : 'node', tabindex: 0, role: 'button', 'data-node': map, 'aria-pressed': String(map === chosen),
      'aria-label': chosen < 0 ? `${nameOf(block, map)}: choose it` : `${spoken(chosen, map)}: ${allowed[chosen][map] ? 'forbid' : 'allow'}`,
      onclick: () => press(map), onkeydown: e => { if (e.key === 'Enter' || e.key === ' ') { e.preventDefault(); press(map); } else if (e.key === 'Escape') choose(-1); } },
    svg('circle', { cx: x, cy: y, r: dot }), svg('text', { x, y: y + 4, 'text-anchor': 'middle' }, nameOf(block, map).slice(0, 5)));
  };
  const all = block.maps.map((_, m) => m);
  return element('div', { class: 'graph-picture' },
    svg('svg', { viewBox: `${-half} ${-half} ${2 * half} ${2 * half}`, role: 'group', 'aria-label': 'The graph of the maps' },
      svg('defs', {}, svg('marker', { id: 'arrow-head', viewBox: '0 0 8 8', refX: 6, refY: 4, markerWidth: 7, markerHeight: 7, orient: 'auto-start-reverse' }, svg('path', { d: 'M 0 0 L 8 4 L 0 8 z' }))),
      ...all.flatMap(from => all.filter(to => allowed[from][to]).map(to => arrow(from, to))), ...all.map(node)),
    element('p', { class: 'note' }, chosen < 0 ? 'An arrow leads from a map to each that may stand in it. Click an arrow to forbid it; click a map, then another, to allow or forbid that.'
      : `Now click what may stand in ${nameOf(block, chosen)}, or may not.`,
    ...(chosen < 0 ? [] : [' ', element('button', { class: 'small', onclick: () => choose(-1) }, 'Done')])));
}
