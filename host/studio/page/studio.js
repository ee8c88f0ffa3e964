// The page of pxm studio: one scene as text, as maps and as a picture, in step.
import * as cameras from './camera.js';
import { Checking } from './checking.js';
import { Editor } from './editor.js';
import { byId, element, magnificationText, number, shortWord, toast } from './elements.js';
import { Flight } from './flight.js';
import { Gallery } from './gallery.js';
import { Gestures } from './gestures.js';
import { Handles, referenceOf } from './handles.js';
import { dragged, History } from './history.js';
import { Live } from './live.js';
import { MachinePanel } from './machine_panel.js';
import { MapsPanel } from './maps_panel.js';
import * as saving from './saving.js';
import * as server from './server.js';
import { letsOf, outlineOf } from './scene_tokens.js';
import { identity } from './vectors.js';

const beginning = `# two copies of the whole: where do they stand?
ifs mine {
    newmap scale: 0.6 translate: 0,0.5,0 color: 0.2,0.6,0.3,0.4
    newmap scale: 0.5 rotate: z,40 translate: 0.5,-0.3,0 color: 0.8,0.7,0.2,0.4
}
`;
const tabs = ['maps', 'text', 'facts', 'machine'];
const trail_pause = 700;  // milliseconds between moves that are steps of the way back

class Studio {
  constructor(facts) {
    this.facts = facts;
    this.name = '';
    this.history = new History('');
    this.outline = outlineOf('');
    this.lets = new Map();
    this.checked = null;   // what the program said of the last good text
    this.goodText = '';
    this.camera = this.base = null;
    this.trail = [];
    this.machine = '';
    this.frame = 0;
    this.ifs = 0;
    this.map = -1;
    this.tab = 'maps';
    this.timings = [];  // of the last pictures, milliseconds
    this.makeParts();
    this.connect();
  }

  makeParts() {
    this.live = new Live(byId('picture'), () => this.shown(), event => this.pictured(event));
    this.checking = new Checking(this);
    this.editor = new Editor(text => this.edit(text, 'typing'));
    this.handles = new Handles(byId('handles'), () => this.shaping());
    this.flight = new Flight(this);
    this.gestures = new Gestures(byId('handles'), this);
    this.maps = new MapsPanel(byId('panel-maps'), () => this, (text, kind) => this.edit(text, kind), (ifs, map) => this.select(ifs, map));
    this.machines = new MachinePanel(byId('panel-machine'), this.facts.models, model => this.useMachine(model));
    this.gallery = new Gallery(this.facts, (name, shipped) => this.go({ scene: name, shipped }));
    new ResizeObserver(() => this.resized()).observe(byId('stage'));
  }

  get text() { return this.history.text; }

  // --- scenes ---------------------------------------------------------------------------------

  /// Shows what the address says.
  async arrive() {
    const wanted = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    const key = wanted.scene ? `${wanted.scene}|${wanted.from ?? ''}` : '';
    if (key !== this.arrivedAt) {
      this.arrivedAt = key;
      if (!wanted.scene) return this.showGallery();
      try {
        await this.load(wanted.scene, wanted.from === 'pxm');
      } catch (error) {
        toast(error.message, 'bad');
        this.arrivedAt = '';
        return this.showGallery();
      }
    }
    if (wanted.tab) this.choose(wanted.tab, false);
    if (this.base) {
      this.camera = cameras.fromAddress(wanted.view ?? '', this.base);
      this.cameraChanged();
    }
  }

  async load(name, shipped) {
    const file = shipped
      ? { text: this.dropped ?? this.facts.shipped.find(s => s.name === name)?.text ?? beginning, digest: '' }
      : await server.open(name);
    this.dropped = null;
    this.name = name;
    this.shipped = shipped;
    this.saved = file.text;
    this.digest = file.digest;
    const kept = this.keptText();
    Object.assign(this, { history: new History(file.text), checked: null, base: null, camera: null, trail: [], frame: 0, ifs: 0, map: -1, goodText: '' });
    if (kept !== null && kept !== file.text) this.history.put(kept);
    byId('gallery').hidden = true;
    byId('studio').hidden = false;
    byId('scene-tools').hidden = false;
    this.live.clear();
    this.flight.forget();
    this.live.fit(this.facts.limits);
    this.textChanged();
    await this.answered;
  }

  showGallery() {
    this.name = '';
    byId('gallery').hidden = false;
    byId('studio').hidden = true;
    byId('scene-tools').hidden = true;
    byId('scene-name').textContent = '';
    document.title = 'pxm studio';
  }

  go({ scene, shipped }) {
    location.hash = new URLSearchParams({ scene, ...(shipped ? { from: 'pxm' } : {}) });
  }

  /// The view in the address, soon: a reload comes back to it.
  noteAddress() {
    clearTimeout(this.noting);
    this.noting = setTimeout(() => {
      if (!this.name || !this.camera) return;
      const view = cameras.toAddress(this.camera);
      const words = new URLSearchParams({ scene: this.name, ...(this.shipped ? { from: 'pxm' } : {}), ...(this.tab !== 'maps' ? { tab: this.tab } : {}), ...(view ? { view } : {}) });
      history.replaceState(null, '', `#${words}`);
    }, 300);
  }

  /// What was not saved survives a reload of this tab.
  keptText() { return sessionStorage.getItem(`pxm:${this.name}:${this.shipped}`); }
  keepText() {
    try { sessionStorage.setItem(`pxm:${this.name}:${this.shipped}`, this.text); } catch { /* there is no room */ }
  }

  // --- text -----------------------------------------------------------------------------------

  edit(text, kind = '') {
    if (text === this.text) return;
    this.history.put(text, kind);
    this.textChanged();
  }
  edited(text) { this.edit(text, dragged); }
  editEnds() { this.history.seal(); }
  undo() { this.history.undo(); this.textChanged(); }
  redo() { this.history.redo(); this.textChanged(); }

  textChanged() {
    this.outline = outlineOf(this.text);
    this.lets = letsOf(this.outline);
    this.ifs = Math.min(this.ifs, Math.max(0, this.outline.ifs.length - 1));
    const maps = this.outline.ifs[this.ifs]?.maps.length ?? 0;
    if (this.map >= maps) this.map = maps - 1;
    this.editor.set(this.text);
    this.maps.draw();
    this.handles.draw();
    this.keepText();
    byId('undo').disabled = !this.history.canUndo;
    byId('redo').disabled = !this.history.canRedo;
    this.drawName();
    this.answered = this.checking.check();
  }

  drawName() {
    const dirty = this.text !== this.saved || this.shipped;
    byId('scene-name').replaceChildren(this.name, dirty ? element('span', { class: 'dirty', title: 'Not saved' }, ' •') : '');
    document.title = `${this.text !== this.saved ? '• ' : ''}${this.name} – pxm studio`;
  }

  // --- picture --------------------------------------------------------------------------------

  shown() {
    return this.goodText === '' ? null : { name: this.name, text: this.goodText, frame: this.frame, machine: this.machine,
      settings: this.camera ? cameras.settingsOf(this.camera) : [], samples: Number(byId('samples').value) };
  }

  /// Exactly what is on the screen when all is done.
  finished() {
    return { ...this.shown(), ...this.live.wholeSize };
  }

  setCamera(camera, kind) {
    const now = performance.now();
    if (kind && now - (this.movedAt ?? -1e9) > trail_pause && kind !== 'back') {
      this.trail.push(this.camera);
      if (this.trail.length > 200) this.trail.shift();
    }
    this.movedAt = now;
    if (kind !== 'zoom') this.flight.forget();
    this.camera = camera;
    this.cameraChanged();
  }
  cameraChanged() {
    byId('magnification').textContent = magnificationText(cameras.magnification(this.camera) / cameras.magnification(this.base));
    byId('back').disabled = this.trail.length === 0;
    this.live.change();
    this.handles.draw();
    this.noteAddress();
  }
  back() { if (this.trail.length > 0) this.setCamera(this.trail.pop(), 'back'); byId('back').disabled = this.trail.length === 0; }
  reset() { if (this.camera?.moved) this.setCamera(this.base, 'reset'); }
  zoomAt(x, y, factor) { this.flight.zoomAt(x, y, factor).catch(error => toast(error.message, 'bad')); }

  /// From -1 to 1 over the picture's width; up is positive.
  toPicture(x, y) {
    const { clientWidth: w, clientHeight: h } = byId('handles');
    return [2 * x / w - 1, (h - 2 * y) / w];
  }

  pixelAt(x, y) {
    const { clientWidth: w, clientHeight: h } = byId('handles');
    const { columns, rows } = this.live.wholeSize;
    const clamp = (v, most) => Math.min(most - 1, Math.max(0, Math.floor(v)));
    return [clamp(x / w * columns, columns), clamp(y / h * rows, rows)];
  }

  async pickAt(x, y) {
    const answer = await server.pick({ ...this.finished(), machine: '' }, ...this.pixelAt(x, y));
    if (answer) this.showWord(answer.cell);
    return answer?.cell ?? null;
  }

  showWord(cell) {
    const word = cell ? `${cell.object}: ${shortWord(cell.word) || '(whole)'}` : 'the background';
    byId('word').textContent = word.length > 120 ? `… ${word.slice(-118)}` : word;
    byId('word').title = cell ? `${cell.word.length} maps deep, ${number(cell.distance)} away\n${cell.object}: ${cell.word.join(' ')}` : word;
  }

  async clicked(x, y) {
    try {
      const nearest = this.tab === 'maps' ? this.handles.nearest(x, y) : -1;
      if (nearest >= 0 && nearest !== this.map) return this.select(this.ifs, nearest);
      if (this.tab === 'machine') {
        const answer = await server.pixel(this.finished(), ...this.pixelAt(x, y));
        if (!answer) return undefined;
        byId('descent').textContent = answer.text;
        return byId('descent-dialog').showModal();
      }
      await this.pickAt(x, y);
    } catch (error) {
      toast(error.message, 'bad');
    }
    return undefined;
  }

  hovered(hit) { byId('handles').style.cursor = hit ? 'move' : ''; }

  /// What the handles need, where there is something to shape.
  shaping() {
    const block = this.outline.ifs[this.ifs];
    const known = this.checked?.ifs.find(i => i.name === block?.name);
    if (this.tab !== 'maps' || !block || !this.camera || !known?.radius || cameras.magnification(this.camera) > 1e5) return null;
    const object = this.checked.objects.find(o => o.ifs === block.name);
    if (!this.handles.drag) this.reference = referenceOf(known.center, known.radius);
    return { text: this.text, block, map: this.map, lets: this.lets, camera: this.camera, reference: this.reference, place: object?.matrix ?? identity };
  }

  select(ifs, map) {
    this.ifs = ifs;
    this.map = map;
    this.maps.draw();
    this.handles.draw();
  }

  pictured(event) {
    byId('busy').hidden = event.kind !== 'picture' || event.phase !== 'coarse';
    if (event.kind === 'refused') {
      if (this.machine) this.machines.refuse(event.error.message);
      if (event.error.kind === 'scene') this.checking.showMistakes(event.error);
      else toast(event.error.message, 'bad');
    }
    if (event.kind !== 'picture') return;
    document.documentElement.dataset.phase = event.phase;
    const { statistics, warnings } = event.picture.head;
    if (event.phase !== 'coarse') {
      const seconds = statistics.seconds.render;
      byId('timing').textContent = `${event.picture.pixels.width}×${event.picture.pixels.height}, ${number(seconds * 1000, 3)} ms`;
      byId('timing').title = `${statistics.engine}, ${statistics.numeric}, ${statistics.intersect.method}: ${statistics.intersect.because}`;
      if (warnings.trim() && this.text === this.goodText) this.checking.showMistakes(null, warnings.trim());
      if (this.machine) this.machines.show(event.picture, this.machine);
    }
    this.timings.push({ phase: event.phase, took: event.took, since: event.since, render: statistics.seconds.render });
    if (this.timings.length > 500) this.timings.shift();
  }

  useMachine(model) {
    this.machine = model;
    this.machines.show(null, model);
    this.live.change();
  }

  resized() {
    if (byId('studio').hidden) return;
    this.live.fit(this.facts.limits);
    this.handles.draw();
  }

  // --- page -----------------------------------------------------------------------------------

  choose(tab, focus = true) {
    if (!tabs.includes(tab)) return;
    this.tab = tab;
    for (const name of tabs) {
      const button = byId(`tab-${name}`);
      button.setAttribute('aria-selected', String(name === tab));
      button.tabIndex = name === tab ? 0 : -1;
      byId(`panel-${name}`).hidden = name !== tab;
    }
    if (focus) byId(`tab-${tab}`).focus();
    if (tab === 'text') this.editor.draw();
    if (tab === 'facts' && this.checked && this.checking.factsOld) this.checking.inspect();
    if (tab !== 'machine' && this.machine) this.useMachine('');
    if (tab === 'machine') this.machines.draw();
    this.handles.draw();
    this.noteAddress();
  }

  connect() {
    const press = (id, action) => byId(id).addEventListener('click', action);
    press('undo', () => this.undo());
    press('redo', () => this.redo());
    press('save', () => saving.save(this));
    press('command', () => saving.copyCommand(this));
    press('png', () => saving.savePng(this));
    press('back', () => this.back());
    press('reset', () => this.reset());
    press('help', () => byId('help-dialog').showModal());
    press('theme', () => this.changeTheme());
    for (const tab of tabs) press(`tab-${tab}`, () => this.choose(tab));
    byId('samples').addEventListener('change', () => this.live.change());
    byId('frame').addEventListener('input', event => {
      this.frame = Number(event.target.value);
      byId('frame-number').textContent = event.target.value;
      this.checking.check();
    });
    press('new', () => this.go({ scene: 'mine.pxm', shipped: true }));
    addEventListener('dragover', event => { if (event.dataTransfer.types.includes('Files')) event.preventDefault(); });
    addEventListener('drop', event => saving.takeDropped(this, event));
    addEventListener('hashchange', () => this.arrive());
    addEventListener('keydown', event => this.key(event));
    document.querySelector('.tabs').addEventListener('keydown', event => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (step) this.choose(tabs[(tabs.indexOf(this.tab) + step + tabs.length) % tabs.length]);
    });
  }

  key(event) {
    const command = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    const typing = /^(input|textarea|select)$/i.test(event.target.tagName);
    if (!this.name && key !== '?') return;
    if (command && key === 'z') event.shiftKey ? this.redo() : this.undo();
    else if (command && key === 'y') this.redo();
    else if (command && key === 's') saving.save(this);
    else if (key === '?' && !typing) byId('help-dialog').showModal();
    else return;
    event.preventDefault();
  }

  changeTheme() {
    const dark = getComputedStyle(document.documentElement).colorScheme !== 'light';
    document.documentElement.dataset.theme = dark ? 'light' : 'dark';
    localStorage.setItem('pxm-theme', document.documentElement.dataset.theme);
  }
}

async function begin() {
  const theme = localStorage.getItem('pxm-theme');
  if (theme) document.documentElement.dataset.theme = theme;
  // The token is in the cookie now: nobody should read it in the address.
  const hash = location.hash;
  history.replaceState(null, '', location.pathname + hash);
  const facts = await server.start();
  server.stay(here => document.documentElement.classList.toggle('gone', !here));
  const studio = new Studio(facts);
  if (!hash && facts.scene) history.replaceState(null, '', `#${new URLSearchParams({ scene: facts.scene })}`);
  await studio.arrive();
  window.studio = studio;
}

begin().catch(error => {
  document.body.append(element('p', { class: 'mistakes' }, error.message));
});
