// The maps of a system as cards, each with its steps (Sec. 9.2): what is typed, dragged or pressed here
// becomes an edit of the text.
import { element, number } from './elements.js';
import { graphOf, withoutMap, withRulesOfCopy } from './graph_edits.js';
import { graphPanel } from './graph_panel.js';
import * as edits from './map_edits.js';
import { mistakePlace } from './mistake_places.js';
import { oneAxis, oneValue, takesOne } from './number_field.js';
import { outlineOf, valueOf } from './scene_tokens.js';
import { lipschitz } from './vectors.js';

const labels = { scale: ['x', 'y', 'z'], translate: ['x', 'y', 'z'], rotate: ['', '°'] };
const pixel_steps = { scale: 0.005, translate: 0.005, rotate: 0.5, matrix: 0.005 };

const folded = 'pxm-hint-folded';

const hex = c => '#' + c.map(x => Math.round(255 * Math.min(1, Math.max(0, x))).toString(16).padStart(2, '0')).join('');
const weightOf = map => map?.directives.find(d => d.word === 'weight')?.args[0]?.text ?? '';
const fromHex = text => [1, 3, 5].map(i => Number((parseInt(text.slice(i, i + 2), 16) / 255).toFixed(3)));

export class MapsPanel {
  /// `scene` gives { text, outline, lets, ifs, map, checking }; `edit(text, kind)`, `select(ifs, map)`.
  constructor(place, scene, edit, select) {
    Object.assign(this, { place, scene, edit, select });
    this.shape = '';
    this.graph = { chosen: -1 };
    this.wrong = [];  // where the program found mistakes
  }

  draw() {
    const { outline, ifs, map } = this.scene();
    const shape = JSON.stringify([ifs, map, outline.ifs.map(block => [block.name, block.maps.map(m =>
      [m.name, m.directives.map(d => [d.word, d.args.length])]), graphOf(block, this.text()).allowed])]);
    if (shape !== this.shape) {
      const { dataset, selectionStart, selectionEnd } = document.activeElement ?? {};
      const { key: focus, node } = dataset ?? {};
      this.shape = shape;
      this.rebuild();
      this.refresh();
      const again = focus ? this.find(focus) : node ? this.place.querySelector(`[data-node="${node}"]`) : null;
      again?.focus();
      if (again?.type === 'text' && Number.isInteger(selectionStart)) again.setSelectionRange(selectionStart, selectionEnd);
    }
    this.refresh();
  }

  block() { const { outline, ifs } = this.scene(); return outline.ifs[ifs]; }
  mapAt(index) { return this.block().maps[index]; }
  stepsAt(index) { const map = this.block()?.maps[index]; return map ? edits.stepsOf(map) : []; }
  text() { return this.scene().text; }

  rebuild() {
    const { outline, ifs } = this.scene();
    if (outline.ifs.length === 0) {
      this.place.replaceChildren(element('p', { class: 'note' }, 'This scene has no maps of its own: they stand in a file that it includes, or it shows volumes only. Its text is in the next panel.'));
      return;
    }
    const head = element('div', { class: 'row' },
      outline.ifs.length > 1
        ? element('select', { 'aria-label': 'System', onchange: e => this.select(Number(e.target.value), 0) },
          ...outline.ifs.map((block, i) => element('option', { value: i, selected: i === ifs }, block.name)))
        : element('h2', {}, outline.ifs[ifs].name),
      element('span', { class: 'grow' }),
      element('button', { title: 'Another map', 'data-key': 'add', onclick: () => this.addMap() }, '+ Map'));
    const graph = graphPanel(this.scene, text => this.edit(text), this.graph, () => { this.shape = ''; this.draw(); });
    this.place.replaceChildren(head, ...this.hint(), ...this.block().maps.map((map, i) => this.card(map, i)), ...(graph ? [graph] : []));
  }

  /// Whether this is the scene that one begins with.
  beginning() { return this.scene().shipped && /^# two copies of the whole/.test(this.text()); }

  /// For whoever begins with nothing: how a plant comes of it. Who folds it wants it so.
  hint() {
    if (!this.beginning()) return [];
    const step = (...words) => element('li', {}, ...words);
    return [element('details', { class: 'hint', open: !sessionStorage.getItem(folded), ontoggle: e => sessionStorage.setItem(folded, e.target.open ? '' : 'yes') }, element('summary', {}, 'How to make a plant'), element('ol', {},
      step('Map 1, below, is the plant without its lowest leaf: nearly the whole, turned a little and moved up. Map 2 is that leaf.'),
      step('Open Map 2 and press ', element('i', {}, 'Mirror'), ': that makes a mirrored copy, Map 3, the leaf on the other side.'),
      step('Press ', element('i', {}, '+ Map'), ' for the stem, then ', element('i', {}, 'x y z'), ' beside its scale, and make it 0.03, 0.35, 0.03.'),
      step('Make it yours: change any number, or drag the yellow handles in the picture. (A corner or a face that is dragged turns the steps of its map into one tetrahedron; undo, ', element('i', {}, '↶'), ' above, brings them back.)'),
      step(element('i', {}, 'Save PNG'), ' above keeps the picture, ', element('i', {}, 'Save'), ' the scene.')))];
  }

  addMap() {
    const count = this.block().maps.length;
    this.edit(edits.addMap(this.text(), this.block(), 'newmap scale: 0.5 translate: 0,0,0'));
    this.select(this.scene().ifs, count);
  }

  card(map, index) {
    const open = index === this.scene().map;
    const act = (label, title, edit, then) => element('button', {
      class: 'small', title, 'aria-label': title, 'data-key': `${index}.${title}`, 'data-once': '',
      onclick: () => { this.edit(edit()); if (then !== undefined) this.select(this.scene().ifs, then()); },
    }, label);
    const count = () => this.block().maps.length - 1;
    const title = element('button', { class: 'map-title', 'aria-expanded': String(open), 'data-key': `${index}.title`,
      'data-once': '', onclick: () => this.select(this.scene().ifs, open ? -1 : index) },
      element('span', { class: 'swatch', 'data-swatch': index }),
      element('span', {}, map.name ? `${index + 1} ${map.name}` : `Map ${index + 1}`),
      element('span', { class: 'lip', 'data-lip': index }));
    if (!open) return element('article', { class: 'card' }, title);
    return element('article', { class: 'card open' }, title,
      element('ol', { class: 'steps' }, ...edits.stepsOf(map).map((step, s) => this.step(index, step, s))),
      this.adder(index), this.looks(index),
      element('div', { class: 'row' },
        act('Copy', 'Copy this map', () => this.copied(index), count),
        act('Mirror', 'A mirrored copy, left to right', () => this.copied(index, edits.mirrored('x')), count),
        element('span', { class: 'grow' }),
        act('Delete', 'Delete this map', () => withoutMap(this.text(), this.block(), index), () => Math.max(0, index - 1))));
  }

  /// The text with a copy of a map, which stands in the graph as that one does.
  copied(index, more = '') {
    const text = edits.copyMap(this.text(), this.block(), this.mapAt(index), more);
    return withRulesOfCopy(text, outlineOf(text).ifs[this.scene().ifs], index);
  }

  step(index, step, s) {
    const key = `${index}.${s}`;
    const now = () => edits.stepsOf(this.mapAt(index));
    const move = to => { if (to >= 0 && to < now().length) this.edit(edits.moveStep(this.text(), this.mapAt(index), s, to)); };
    const row = element('li', { class: `step ${step.word}`, 'data-step': s },
      element('span', { class: 'grip', title: 'Drag to reorder', draggable: 'true' }, '⠿'),
      element('b', {}, step.word),
      element('div', { class: 'values' }, ...step.args.map((_, a) => this.field(index, s, a, step)), this.splitter(index, step, s)),
      element('span', { class: 'ends' },
        element('button', { class: 'small', title: 'Earlier', 'aria-label': `${step.word} earlier`, 'data-key': `${key}.up`, onclick: () => move(s - 1) }, '↑'),
        element('button', { class: 'small', title: 'Later', 'aria-label': `${step.word} later`, 'data-key': `${key}.down`, onclick: () => move(s + 1) }, '↓'),
        element('button', { class: 'small', title: 'Remove this step', 'aria-label': `remove ${step.word}`, 'data-key': `${key}.remove`, 'data-once': '',
          onclick: () => this.edit(edits.removeDirective(this.text(), now()[s])) }, '×')));
    row.addEventListener('dragstart', e => { e.dataTransfer.setData('text/plain', String(s)); e.dataTransfer.effectAllowed = 'move'; });
    row.addEventListener('dragover', e => e.preventDefault());
    row.addEventListener('drop', e => {
      e.preventDefault();
      const from = Number(e.dataTransfer.getData('text/plain'));
      if (Number.isInteger(from) && from !== s && from < now().length) this.edit(edits.moveStep(this.text(), this.mapAt(index), from, s));
    });
    return row;
  }

  /// One number for all directions becomes one for each.
  splitter(index, step, s) {
    if (step.word !== 'scale' || step.args.length !== 1) return null;
    return element('button', { class: 'small', title: 'A number for each direction, to squash or stretch', 'aria-label': 'scale x, y and z by themselves', 'data-key': `${index}.${s}.split`,
      onclick: () => { const now = edits.stepsOf(this.mapAt(index))[s]; this.edit(edits.setValues(this.text(), now, Array(3).fill(now.args[0].text).join(','))); } }, 'x y z');
  }

  field(index, s, a, step) {
    const name = labels[step.word]?.[step.args.length === 1 ? -1 : a] ?? '';
    const spoken = step.word === 'rotate' ? ['axis', 'degrees'][a] : name;
    const step_now = () => edits.stepsOf(this.mapAt(index))[s];
    const put = (value, kind) => this.edit(edits.setArgument(this.text(), step_now(), a, value), kind);
    const kind = `${index}.${s}.${a}`;
    const axis = step.word === 'rotate' && a === 0;
    const input = element('input', { 'data-key': kind, 'data-arg': kind, size: 6, spellcheck: 'false', autocomplete: 'off',
      'aria-label': `${step.word} ${spoken}`.trim(), class: axis ? 'axis' : '',
      onkeydown: e => this.nudge(e, step, put, kind) });
    const read = axis ? oneAxis : step.word in labels || step.word === 'matrix' ? oneValue : typed => typed.trim() || null;
    takesOne(input, read, value => put(value, kind), () => this.stepsAt(index)[s]?.args[a]?.text);
    const label = element('label', { class: 'value' }, element('span', { class: 'scrub', title: 'Drag sideways' }, name || (step.word === 'rotate' ? '' : '↔')), input);
    this.scrub(label.firstChild, () => valueOf(step_now().args[a].text, this.scene().lets), pixel_steps[step.word], x => put(edits.short(x), kind));
    return label;
  }

  /// Up and down change a number a little.
  nudge(event, step, put, kind) {
    const sign = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const value = valueOf(oneValue(event.target.value) ?? '', this.scene().lets);
    if (!sign || !pixel_steps[step.word] || !Number.isFinite(value)) return;
    event.preventDefault();
    const next = edits.short(value + sign * pixel_steps[step.word] * (event.shiftKey ? 10 : 2));
    event.target.value = next;
    put(next, kind);
  }

  scrub(place, value, step, put) {
    place.addEventListener('pointerdown', event => {
      const start = value();
      if (!step || !Number.isFinite(start)) return;
      event.preventDefault();
      place.setPointerCapture(event.pointerId);
      const move = e => put(start + (e.clientX - event.clientX) * step * (e.shiftKey ? 0.1 : 1));
      place.addEventListener('pointermove', move);
      place.addEventListener('lostpointercapture', () => place.removeEventListener('pointermove', move), { once: true });
    });
  }

  /// The plant that one begins with is flat: it turns about z.
  newStep(word) { return word === 'rotate' && this.beginning() ? 'rotate: z,30' : edits.defaultStep[word]; }

  adder(index) {
    return element('div', { class: 'row adder' }, element('span', { class: 'note' }, 'add'), ...Object.keys(edits.defaultStep).map(word =>
      element('button', { class: 'small', 'data-key': `${index}.add.${word}`,
        onclick: () => this.edit(edits.addStep(this.text(), this.mapAt(index), this.newStep(word))) }, word)));
  }

  /// Colour, how much of it, and weight.
  looks(index) {
    const color = () => edits.setOnce(this.text(), this.mapAt(index), 'color',
      [...fromHex(this.find(`${index}.color`).value), this.find(`${index}.share`).value].join(','));
    return element('div', { class: 'row looks' },
      element('label', { class: 'note' }, 'colour ', element('input', { type: 'color', 'data-key': `${index}.color`, oninput: () => {
        const share = this.find(`${index}.share`);
        if (Number(share.value) === 0) share.value = '0.5';
        this.edit(color(), `${index}.color`);
      } })),
      element('label', { class: 'note' }, 'how much ', element('input', { type: 'range', min: 0, max: 1, step: 0.05, 'data-key': `${index}.share`,
        oninput: () => this.edit(color(), `${index}.color`) })),
      element('label', { class: 'note', title: 'How often the chaos game takes it; pictures do not change' }, 'weight ', this.weight(index)));
  }

  weight(index) {
    const key = `${index}.weight`;
    return takesOne(element('input', { size: 4, placeholder: 'auto', 'data-key': key, autocomplete: 'off' }),
      typed => (typed.trim() ? oneValue(typed) : ''),
      value => this.edit(edits.setOnce(this.text(), this.mapAt(index), 'weight', value), key),
      () => weightOf(this.block()?.maps[index]));
  }

  find(key) { return this.place.querySelector(`[data-key="${key}"]`); }

  /// The values that changed, in the fields that nobody is typing into.
  refresh() {
    const { outline, ifs, map, lets } = this.scene();
    const block = outline.ifs[ifs];
    if (!block) return;
    block.maps.forEach((one, i) => {
      const whole = edits.mapOf(one, lets);
      const stretch = whole ? lipschitz(whole) : NaN;
      const badge = this.place.querySelector(`[data-lip="${i}"]`);
      const grows = stretch >= 1 && this.scene().checking.growing.includes(block.name);
      badge.textContent = Number.isFinite(stretch) ? `×${number(stretch, 3)}` : '';
      badge.title = grows ? 'It does not shrink, and so the maps do not lead to a picture' : stretch >= 1
        ? 'Its largest stretch: this map alone does not shrink, but one map after another does, as they may follow' : 'How much it shrinks: its largest stretch';
      badge.classList.toggle('bad', grows);
      badge.classList.toggle('near', stretch >= 0.95 && !grows);
      this.place.querySelector(`[data-swatch="${i}"]`).style.background = hex(this.colorOf(one));
    });
    if (map >= 0 && block.maps[map]) this.refreshCard(block.maps[map], map);
    this.showWrong();
  }

  /// Mistakes of the text as it is now.
  mark(mistakes) {
    const { outline } = this.scene();
    this.wrong = mistakes.map(m => mistakePlace(this.text(), outline, edits.stepsOf, m)).filter(m => m);
    this.showWrong();
  }

  /// At the field, if it is known, or at its step; and at the map in any case.
  showWrong() {
    for (const one of this.place.querySelectorAll('[data-wrong]')) {
      if (one.dataset.wrong === 'sign') one.remove();
      else ['data-wrong', 'aria-invalid', 'title'].forEach(name => one.removeAttribute(name));
    }
    for (const { ifs, map, step, arg, word, message } of this.wrong) {
      const badge = this.place.querySelector(`[data-lip="${map}"]`);
      if (ifs !== this.scene().ifs || !badge) continue;
      badge.before(element('span', { class: 'wrong', 'data-wrong': 'sign', title: message }, 'mistake'));
      const field = this.find(arg >= 0 ? `${map}.${step}.${arg}` : `${map}.${word}`) ?? this.place.querySelector(`.card.open [data-step="${step}"]`);
      if (!field || map !== this.scene().map) continue;
      Object.assign(field.dataset, { wrong: 'place' });
      field.setAttribute('title', message);
      if (field.tagName === 'INPUT') field.setAttribute('aria-invalid', 'true');
    }
  }

  colorOf(map) {
    const values = map.directives.find(d => d.word === 'color')?.args.map(a => valueOf(a.text, this.scene().lets)) ?? [];
    return values.length === 4 && values.every(Number.isFinite) ? values.slice(0, 3) : [0.9, 0.9, 0.9];
  }

  refreshCard(map, index) {
    const put = (key, value) => {
      const field = this.find(key);
      if (field && field !== document.activeElement && field.value !== value) field.value = value;
    };
    edits.stepsOf(map).forEach((step, s) => step.args.forEach((arg, a) => put(`${index}.${s}.${a}`, arg.text)));
    const color = map.directives.find(d => d.word === 'color')?.args.map(a => valueOf(a.text, this.scene().lets));
    put(`${index}.color`, hex(this.colorOf(map)));
    put(`${index}.share`, String(color?.[3] ?? 0));
    put(`${index}.weight`, weightOf(map));
  }
}
