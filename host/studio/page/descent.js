// One ray's descent as a tree: which cells it met, which it missed, and where it ended (Ch. 13). What
// `--pixel` prints is read line by line.
import { byId, element } from './elements.js';

const most_rows = 3000;
const meanings = {
  met: 'the ray meets the volume around this cell', missed: 'the ray goes past the volume around this cell, so that nothing in it is looked at',
  opened: 'the ray meets the volume around this cell, and was tried on the cells in it', known: 'this cell was opened before, by other maps',
  shown: 'this cell is what is seen', 'given up': 'the ray could not be followed any deeper here', dropped: 'there was no room for this cell', restarted: 'from here the ray began again',
};
const events = { meets: 'met', misses: 'missed', opens: 'opened', knows: 'known', shows: 'shown', 'gives up at': 'given up', drops: 'dropped', 'restarts after': 'restarted' };

/// { head, end, cells: [{ what, object, word, key, exit, diameter }] } of the ray from the eye.
export function readDescent(text) {
  const lines = text.split('\n');
  const head = lines.find(l => l.startsWith('pixel ')) ?? '';
  const cells = new Map();
  let eye = true;
  for (const line of lines) {
    if (/^(mirror|light) ray/.test(line)) eye = false;
    const match = eye && /^(meets|misses|opens|knows|shows|gives up at|drops|restarts after) +(\d+) +(\S+) +(\S+) +(\S+) +(\S+) {2}([^:]*):(.*)$/.exec(line);
    if (!match) continue;
    const [, event, , key, exit, diameter, , object, words] = match;
    const word = words.trim() ? words.trim().split(' ') : [];
    const name = JSON.stringify([object, word]);
    const cell = cells.get(name) ?? { object, word, key: '-', exit: '-', diameter: '-' };
    cell.what = events[event];
    if (key !== '-') Object.assign(cell, { key, exit });
    if (diameter !== '-') cell.diameter = diameter;
    cells.set(name, cell);
    if (cells.size >= most_rows) break;
  }
  return { head, end: lines.find(l => l.startsWith('ended by')) ?? '', cells: [...cells.values()] };
}

/// Cells under those that they stand in: { cell, children }.
export function treeOf(cells) {
  const nodes = new Map(cells.map(cell => [JSON.stringify([cell.object, cell.word]), { cell, children: [] }]));
  const roots = [];
  for (const node of nodes.values()) {
    const { object, word } = node.cell;
    const above = word.length > 0 ? nodes.get(JSON.stringify([object, word.slice(0, -1)])) : null;
    (above?.children ?? roots).push(node);
  }
  return roots;
}

export class Descent {
  /// `point(cell)` draws what is pointed at; null: nothing. `close()` takes the volumes away.
  constructor(place, point, close) {
    Object.assign(this, { place, point, close });
  }

  clear() { this.place.hidden = true; this.place.replaceChildren(); }

  show(text) {
    const { head, end, cells } = readDescent(text);
    const opened = cells.filter(c => c.what !== 'missed').length;
    this.place.hidden = false;
    this.place.replaceChildren(
      element('div', { class: 'row' }, element('h2', {}, 'One ray\'s descent'), element('span', { class: 'grow' }),
        element('button', { class: 'small', onclick: () => { byId('descent').textContent = text; byId('descent-dialog').showModal(); } }, 'As text'),
        element('button', { class: 'small', onclick: () => this.close() }, 'Close')),
      element('p', { class: 'note' }, `${head.split(':')[0].replace('pixel', 'Pixel')}: ${opened} cells met, ${cells.length - opened} missed; ${end.split(';')[0]}. Point at a cell to see its volume.`),
      element('p', { class: 'note' }, 'The ray met a cell if it runs through the volume around it, and missed it if not. Of those that it met the nearest was opened first, until one was small enough to be shown; what is in an opened cell, one map deeper, stands below it. The number is how far along the ray the volume begins.'),
      element('ul', { class: 'tree' }, ...treeOf(cells).map(node => this.row(node))));
    return cells;
  }

  row({ cell, children }) {
    const label = cell.word.length > 0 ? cell.word.at(-1) : cell.object;
    const point = () => this.point(cell);
    const name = element('button', { class: `cell ${cell.what === 'missed' ? 'missed' : cell.what === 'shown' ? 'shown' : ''}`,
      title: `${cell.object}: ${cell.word.join(' ')}\n${cell.what}: ${meanings[cell.what]}${cell.key === '-' ? '' : `, from ${cell.key} to ${cell.exit} of the ray`}${cell.diameter === '-' ? '' : `, diameter ${cell.diameter}`}`,
      onclick: point, onfocus: point, onpointerenter: point },
    element('b', {}, label), ` ${cell.what}`, cell.key === '-' ? '' : element('span', { class: 'far' }, ` ${Number(cell.key).toPrecision(4)}`));
    if (children.length === 0) return element('li', {}, name);
    return element('li', {}, element('details', { open: children.some(c => c.children.length > 0 || c.cell.what !== 'missed') },
      element('summary', {}, name), element('ul', {}, ...children.map(child => this.row(child)))));
  }
}
