// The simulated machine: what each node did for the picture, and what other ways to share out its
// pixels would have cost.
import { byId, element, grouped, number } from './elements.js';

const partitions = {
  interleaved: (x, y, s, n) => (y % n.rows) * n.columns + x % n.columns,
  blocks: (x, y, s, n) => Math.floor(y * n.rows / s.rows) * n.columns + Math.floor(x * n.columns / s.columns),
  rows: (x, y, s, n) => Math.floor(y * n.columns * n.rows / s.rows),
  columns: (x, y, s, n) => Math.floor(x * n.columns * n.rows / s.columns),
};

/// The cycles of each node if pixels were shared out so.
export function shareOf(cycles, size, nodes, partition) {
  const sums = new Float64Array(nodes.columns * nodes.rows);
  const owner = partitions[partition];
  for (let y = 0, i = 0; y < size.rows; ++y)
    for (let x = 0; x < size.columns; ++x, ++i) sums[owner(x, y, size, nodes)] += cycles[i];
  return sums;
}
export function efficiencyOf(sums) {
  const most = Math.max(...sums);
  return most > 0 ? sums.reduce((a, b) => a + b, 0) / sums.length / most : 1;
}

/// From dark to light, the same order in grey.
const heat = share => {
  const stops = [[34, 23, 71], [110, 30, 110], [200, 60, 80], [245, 140, 50], [252, 225, 120]];
  const at = Math.min(stops.length - 1.001, Math.max(0, share) * (stops.length - 1));
  const i = Math.floor(at), f = at - i;
  return `rgb(${stops[i].map((c, k) => Math.round(c + (stops[i + 1][k] - c) * f)).join(',')})`;
};

export class MachinePanel {
  /// `choose(model)`: '' is native; `shared()` hears that pixels are shared out in another way. `more` are
  /// parts that stand below.
  constructor(place, models, { choose, shared }, more = []) {
    Object.assign(this, { place, models, choose, shared, partition: 'interleaved', quantity: 'cycles', picture: null, model: '', why: '' });
    this.top = element('div');
    this.place.replaceChildren(this.top, ...more);
    this.draw();
  }

  show(picture, model) { Object.assign(this, { picture, model, why: '' }); this.draw(); }
  /// What the nodes have done so far: [[cycles, pixels], ...].
  working(nodes) {
    const model = this.models.find(m => m.name === this.model);
    if (!model || this.picture?.cycles || nodes.length !== model.columns * model.rows) return;
    const done = nodes.reduce((sum, n) => sum + n[1], 0);
    this.quantity = 'cycles';
    this.rest(element('p', { class: 'note', role: 'status' }, `The machine is at work: ${grouped(done)} pixels so far.`), this.map(nodes.map(n => n[0]), model, 'filling'));
  }

  /// What the machine cannot do: a memory is too small, the scene is wrong.
  refuse(why) { Object.assign(this, { picture: null, why }); this.draw(); }

  /// Everything under the choice of a model; what others have put there stays last.
  rest(...parts) {
    const focus = document.activeElement?.id;
    this.top.replaceChildren(this.head(), element('p', { class: 'note' }, 'Click a pixel of the picture, and its ray\'s descent is shown below: the cells that it met, and those that it missed.'), ...parts);
    if (focus && this.top.querySelector(`#${focus}`)) byId(focus).focus();
  }

  head() {
    return element('div', { class: 'row' }, element('label', {}, 'render on ',
      element('select', { id: 'model', onchange: e => { this.model = e.target.value; this.choose(this.model); } },
        element('option', { value: '', selected: this.model === '' }, 'this computer'),
        ...this.models.map(m => element('option', { value: m.name, selected: m.name === this.model }, `${m.name}, ${m.columns} × ${m.rows} nodes`)))));
  }

  draw() {
    const picture = this.model ? this.picture : null;
    if (!picture?.cycles) {
      const text = this.why ? this.why : this.model ? 'The machine is at work …' : 'Now this computer\'s own processors render the scene. Choose a model, and a simulated Pixel Machine of 1987 renders it: an array of nodes, each a signal processor with 36 KB of fast memory. You see what every node has to do. Its pictures are smaller, as a node needs thousands of cycles a pixel.';
      this.rest(element('p', { class: this.why ? 'note refused' : 'note' }, text));
      return;
    }
    const statistics = picture.head.statistics;
    const model = this.models.find(m => m.name === this.model);
    const size = { columns: picture.pixels.width, rows: picture.pixels.height };
    const sums = shareOf(picture.cycles, size, model, this.partition);
    const shown = this.quantity === 'heap' ? Float64Array.from(statistics.nodes.map(n => n.heap_peak)) : sums;
    this.rest(this.choices(picture, size, model), this.map(shown, model), this.numbers(statistics, sums, picture), this.memory(statistics));
  }

  choices(picture, size, model) {
    const button = (group, key, label, title) => element('button', { class: 'small', 'aria-pressed': String(this[group] === key), title, onclick: () => { this[group] = key; this.draw(); if (group === 'partition') this.shared(); } }, ...[label].flat());
    return element('div', {},
      element('p', { class: 'note' }, 'Pixels shared out to the nodes so, and how efficient that is:'),
      element('div', { class: 'partitions', role: 'group', 'aria-label': 'How pixels are shared out' }, ...Object.keys(partitions).map(key =>
        button('partition', key, [key, element('b', {}, `${number(100 * efficiencyOf(shareOf(picture.cycles, size, model, key)), 3)} %`)], 'The mean work of a node over that of the busiest'))),
      element('div', { class: 'row', role: 'group', 'aria-label': 'What is shown' }, element('span', { class: 'note' }, 'every node\'s'),
        button('quantity', 'cycles', 'cycles', 'Instruction cycles of 200 ns'), button('quantity', 'heap', 'heap peaks', 'The most cells in a node\'s heap, as it rendered')));
  }

  map(values, model, kind = '') {
    const most = Math.max(...values), least = Math.min(...values);
    const canvas = element('div', { class: `nodes ${kind}`, role: 'img', 'aria-label': `${model.columns} by ${model.rows} nodes, from ${grouped(least)} to ${grouped(most)} ${this.quantity}` });
    canvas.style.gridTemplateColumns = `repeat(${model.columns}, 1fr)`;
    canvas.append(...[...values].map((value, i) => {
      const cell = element('i', { title: `node ${i % model.columns},${Math.floor(i / model.columns)}: ${grouped(value)} ${this.quantity === 'heap' ? 'cells' : 'cycles'}` });
      cell.style.background = heat(most > 0 ? value / most : 0);
      return cell;
    }));
    return element('div', {}, canvas, element('p', { class: 'legend' }, '0', element('span', { class: 'ramp' }), `${grouped(most)} ${this.quantity === 'heap' ? 'cells' : 'cycles'}`));
  }

  numbers(statistics, sums, picture) {
    const most = Math.max(...sums);
    const second = statistics.cost_model.seconds_per_cycle;
    const peak = Math.max(...statistics.nodes.map(n => n.heap_peak));
    const alarms = Object.entries(statistics.alarms).filter(([, n]) => n > 0).map(([k, n]) => `${k}: ${grouped(n)}`).join(', ');
    const row = (name, value) => [element('dt', {}, name), element('dd', {}, value)];
    return element('dl', { class: 'facts' },
      ...row('the machine\'s time', `${number(most * second, 4)} s for ${picture.pixels.width} × ${picture.pixels.height}`),
      ...row('efficiency', `${number(100 * efficiencyOf(sums), 4)} %`),
      ...row('cycles a node', `${grouped(Math.min(...sums))} to ${grouped(most)}`),
      ...row('cycles in all', grouped(sums.reduce((a, b) => a + b, 0))),
      ...row('volumes tested', grouped(statistics.volumes_tested)),
      ...row('heap peak', `${peak} cells`),
      ...row('alarms', alarms || 'none'));
  }

  memory(statistics) {
    const bar = (name, use) => {
      const fill = element('i', { class: use.used_bytes > use.limit_bytes ? 'bad' : 'good' });
      fill.style.width = `${Math.min(100, 100 * use.used_bytes / use.limit_bytes)}%`;
      return element('div', { class: 'memory', title: `${grouped(use.used_bytes)} of ${grouped(use.limit_bytes)} bytes` }, element('span', {}, name), element('span', { class: 'gauge' }, fill));
    };
    const p = statistics.program;
    return element('section', {}, element('h2', {}, 'A node\'s memories'),
      ...Object.entries(statistics.memory).map(([name, use]) => bar(name.replace('_', ' '), use)),
      element('h2', {}, `Its program: ${grouped(p.modules_bytes)} bytes`),
      element('p', { class: 'note' }, p.modules.map(m => m.name).join(', ')),
      element('p', { class: 'note' }, `left out: ${p.left_out.map(m => m.name).join(', ')}`));
  }
}
