// The page of pxm studio: one scene as text, as maps and as a picture, in step.
import { takeDropped, bring } from './bringing.js';
import * as cameras from './camera.js';
import { told, toldOfMaps } from './changes.js';
import { Checking } from './checking.js';
import { Descent } from './descent.js';
import { Editor } from './editor.js';
import { byId, duration, element, magnificationText, number, say, shortWord, toast } from './elements.js';
import { Exporting } from './exporting.js';
import { Flight } from './flight.js';
import { Gallery } from './gallery.js';
import { Gestures } from './gestures.js';
import { Handles, referenceOf } from './handles.js';
import { dragged, History, typed } from './history.js';
import { Live } from './live.js';
import { MachinePanel } from './machine_panel.js';
import { MapsPanel } from './maps_panel.js';
import { Place } from './place.js';
import { mindDoubleClicks } from './presses.js';
import { Rendering } from './rendering.js';
import * as saving from './saving.js';
import * as server from './server.js';
import { letsOf, outlineOf } from './scene_tokens.js';
import { StudyPanel } from './study_panel.js';
import { identity } from './vectors.js';
import { Volumes } from './volumes.js';
import { Working } from './working.js';

const tabs = ['maps', 'text', 'facts', 'machine'];
const word_title = 'The maps that lead to the cell that was clicked, outermost first';
const at_once = 60;       // milliseconds that a picture takes of which nothing is said before it is there
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
    this.wordsForgotten = this.descentsEnded = 0;
    this.timings = [];  // of the last pictures, milliseconds
    this.makeParts();
    this.connect();
    for (const place of document.querySelectorAll('.in-folder')) place.textContent = facts.folder;
  }

  makeParts() {
    this.live = new Live(byId('picture'), () => this.shown(), event => this.pictured(event));
    this.place = new Place(this);
    this.checking = new Checking(this);
    this.editor = new Editor(text => this.edit(text, typed));
    this.volumes = new Volumes(() => this.seen());
    this.handles = new Handles(byId('handles'), () => this.shaping(), this.volumes);
    this.flight = new Flight(this);
    this.gestures = new Gestures(byId('handles'), this);
    this.maps = new MapsPanel(byId('panel-maps'), () => this, (text, kind) => this.edit(text, kind), (ifs, map) => this.select(ifs, map));
    this.studies = new StudyPanel(() => this.shown());
    this.machines = new MachinePanel(byId('panel-machine'), this.facts.models, { choose: model => this.useMachine(model), shared: () => this.endDescent() }, [byId('descent-tree'), this.studies.place]);
    this.descent = new Descent(byId('descent-tree'), cell => this.pointAt(cell), () => this.endDescent());
    this.working = new Working(this);
    this.rendering = new Rendering(this);
    this.exporting = new Exporting(this);
    this.gallery = new Gallery(this.facts, (name, shipped) => this.place.go(name, shipped));
    new ResizeObserver(() => this.resized()).observe(byId('stage'));
  }

  get text() { return this.history.text; }

  // --- text -----------------------------------------------------------------------------------

  edit(text, kind = '') {
    if (text === this.text) return;
    this.history.put(text, kind);
    this.textChanged();
  }
  edited(text) { this.edit(text, dragged); }
  editEnds() { this.history.seal(); }
  undo() { this.step('Undone', this.history.undone, () => this.history.undo()); }
  redo() { this.step('Redone', this.history.redone, () => this.history.redo()); }
  /// `kind`: of the change that is undone or redone. It is told in the words of where it was made.
  step(what, kind, go) {
    const before = this.text, outline = this.outline;
    go();
    if (this.text === before) return toast(`There is nothing to ${what === 'Undone' ? 'undo' : 'redo'}.`);
    this.textChanged();
    const shaped = kind === typed ? null : toldOfMaps(what, { text: before, outline }, this);
    return toast(shaped ?? told(what, before, this.text));
  }

  textChanged() {
    this.outline = outlineOf(this.text);
    this.lets = letsOf(this.outline);
    this.forgetWord();
    this.endDescent();
    this.ifs = Math.min(this.ifs, Math.max(0, this.outline.ifs.length - 1));
    const maps = this.outline.ifs[this.ifs]?.maps.length ?? 0;
    if (this.map >= maps) this.map = maps - 1;
    this.editor.set(this.text);
    this.maps.draw();
    this.drawWires();
    this.handles.draw();
    this.place.keepText();
    byId('undo').disabled = !this.history.canUndo;
    byId('redo').disabled = !this.history.canRedo;
    this.drawName();
    this.answered = this.checking.check();
  }

  drawName() {
    const dirty = this.text !== this.saved || (this.shipped && this.place.brought);  // what was brought from elsewhere has no file
    byId('scene-name').replaceChildren(this.name, dirty ? element('span', { class: 'dirty', title: 'Not saved' }, ' •') : '');
    document.title = `${dirty ? '• ' : ''}${this.name} – pxm studio`;
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
    if (kind !== 'zoom') this.forgetWord();  // a flight goes on to the cell that it says
    this.camera = camera;
    this.cameraChanged();
  }
  cameraChanged() {
    say('magnification', magnificationText(cameras.magnification(this.camera) / cameras.magnification(this.base)));
    byId('back').disabled = this.trail.length === 0;
    this.live.change();
    this.handles.draw();
    this.place.note();
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
    const asked = this.wordsForgotten;
    const answer = await server.pick({ ...this.finished(), machine: '' }, ...this.pixelAt(x, y));
    if (answer && asked === this.wordsForgotten) this.showWord(answer.cell);
    return answer?.cell ?? null;
  }

  /// The picture is of something else, so that what was said of a pixel is no longer so, nor what will be
  /// answered to an earlier question.
  forgetWord() {
    ++this.wordsForgotten;
    say('word', '');
    byId('word').title = word_title;
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
        const ended = this.descentsEnded;
        const answer = await server.pixel({ ...this.finished(), samples: 1 }, ...this.pixelAt(x, y));
        if (!answer || ended !== this.descentsEnded) return undefined;
        return this.showDescent(answer.text);
      }
      await this.pickAt(x, y);
    } catch (error) {
      toast(error.message, 'bad');
    }
    return undefined;
  }

  /// Which maps are drawn over the picture; '' is as many as leave something of it to be seen.
  showWires(chosen) {
    this.handles.chosen = chosen;
    this.handles.keyed = null;
    this.drawWires();
    this.handles.draw();
  }
  drawWires() {
    byId('wires').value = this.handles.wiresOf(this.outline.ifs[this.ifs]?.maps.length ?? 0);
    byId('wires-label').hidden = this.tab !== 'maps' || this.outline.ifs.length === 0;
  }
  nextWires() {
    const [...ways] = byId('wires').options, now = byId('wires').selectedIndex;
    if (byId('wires-label').hidden) return toast('Wires are those of the panel Maps.');
    this.showWires(ways[(now + 1) % ways.length].value);
    return toast(`Wires: ${byId('wires').selectedOptions[0].textContent}.`);
  }

  /// For keys: the handles of the selected map in turn.
  chooseHandle(step) {
    if (byId('wires').value === 'none') this.showWires('open');
    if (this.tab === 'maps' && this.map < 0 && this.outline.ifs[this.ifs]?.maps.length > 0) this.select(this.ifs, 0);
    const what = this.handles.choose(step);
    toast(what ? `Map ${this.map + 1}, ${what}: arrow keys move it, Escape lets go.` : 'Handles are those of the map that is open in Maps.');
  }

  hovered(hit) {
    byId('handles').style.cursor = hit ? 'move' : '';
    if (hit?.corner === this.handles.hovered?.corner) return;
    this.handles.hovered = hit;
    this.handles.draw();
  }

  /// What volumes are drawn into.
  seen() {
    if (!this.checked || !this.camera || cameras.magnification(this.camera) > 1e5) return null;
    return { checked: this.checked, camera: this.camera, toScreen: world => this.handles.toScreen(this.camera, world) };
  }

  /// The cells of a ray, as the descent's words name them, over the picture.
  showDescent(text) {
    const cells = this.descent.show(text);
    this.volumes.cells = cells.filter(c => c.what !== 'missed').map(c => this.cellOf(c)).filter(c => c);
    this.volumes.chosen = null;
    this.handles.draw();
    byId('descent-tree').scrollIntoView({ block: 'nearest' });
  }
  /// The tree and its volumes are of one pixel of one picture; turned, they can still be looked at.
  endDescent() {
    ++this.descentsEnded;
    if (byId('descent-tree').hidden) return;
    this.descent.clear();
    Object.assign(this.volumes, { cells: [], chosen: null });
    this.handles.draw();
  }
  cellOf({ object, word, what }) {
    const shown = this.checked?.objects.find(o => o.name === object);
    const ifs = this.checked?.ifs.find(i => i.name === shown?.ifs);
    const maps = word.map(name => ifs?.maps.findIndex((m, i) => (m.name || String(i + 1)) === name));
    return ifs && maps.every(m => m >= 0) ? { object, maps, what } : null;
  }
  pointAt(cell) {
    this.volumes.chosen = cell && this.cellOf(cell);
    this.handles.draw();
  }

  /// What the handles need, where there is something to shape.
  shaping() {
    const block = this.outline.ifs[this.ifs];
    const known = this.checked?.ifs.find(i => i.name === block?.name);
    if (this.tab !== 'maps' || !block || !this.camera || !known?.radius || cameras.magnification(this.camera) > 1e5) return null;
    const object = this.checked.objects.find(o => o.ifs === block.name);
    if (!this.handles.drag) this.reference = referenceOf(known.center, known.radius);
    return { text: this.text, block, map: this.map, lets: this.lets, camera: this.camera, reference: this.reference, place: object?.matrix ?? identity,
      growing: this.checking.growing.includes(block.name) };
  }

  select(ifs, map) {
    this.ifs = ifs;
    this.map = map;
    this.maps.draw();
    this.drawWires();
    this.handles.letGo();
  }

  pictured(event) {
    if (event.kind === 'changed') return this.awaitPicture();
    if (event.kind !== 'picture' || event.phase !== 'coarse') this.awaiting = clearTimeout(this.awaiting);
    byId('busy').hidden = event.kind !== 'picture' || event.phase !== 'coarse';
    if (event.kind === 'halted' || event.kind === 'refused') this.showTiming('–');
    if (event.kind === 'refused') {
      if (this.machine) this.machines.refuse(event.error.message);
      if (event.error.kind === 'scene') this.checking.showMistakes(event.error);
      else toast(event.error.message, 'bad');
    }
    if (event.kind !== 'picture') return undefined;
    document.documentElement.dataset.phase = event.phase;
    const { statistics, warnings } = event.picture.head;
    if (event.phase !== 'coarse') {
      this.showTiming(`${event.picture.pixels.width}×${event.picture.pixels.height}, ${duration(statistics.seconds.render)}`,
        `${statistics.engine}, ${statistics.numeric}, ${statistics.intersect.method}: ${statistics.intersect.because}`);
      if (warnings.trim() && this.text === this.goodText) this.checking.showMistakes(null, warnings.trim());
      if (this.machine) this.machines.show(event.picture, this.machine);
    }
    this.timings.push({ phase: event.phase, took: event.took, since: event.since, render: statistics.seconds.render, seconds: statistics.seconds, times: event.picture.times });
    if (this.timings.length > 500) this.timings.shift();
    return undefined;
  }

  /// Says that there is a newer one to come, unless it is there at once: words are a frame of the whole
  /// page, for which the browser takes processors from those who render.
  awaitPicture() {
    this.awaiting ??= setTimeout(() => this.showTiming(this.goodText === '' ? '–' : 'rendering …'), at_once);
  }

  /// Of the picture that is whole; of none as long as there is a newer one to come.
  showTiming(text, title = 'How large the picture is, and how long its rays took') {
    say('timing', text);
    if (byId('timing').title !== title) byId('timing').title = title;
  }

  useMachine(model) {
    if (model === this.machine) return;
    this.machine = model;
    this.endDescent();
    this.machines.show(null, model);
    this.live.change();
    this.place.note();
  }

  setFrame(frame) {
    this.frame = frame;
    this.forgetWord();
    this.endDescent();
    this.showFrame();
    this.place.note();
    return this.checking.check();
  }
  showFrame() {
    byId('frame').value = this.frame;
    byId('frame-number').textContent = String(this.frame);
  }

  resized() {
    if (byId('studio').hidden) return;
    if (this.live.fit(this.facts.limits)) {
      this.endDescent();  // that pixel is another
      if (this.base) this.checking.check();  // and so is the scene's own view
    }
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
    if (tab !== 'machine' && this.volumes.cells.length > 0) this.endDescent();
    if (tab === 'machine') this.machines.draw();
    this.drawWires();
    this.handles.draw();
    this.place.note();
  }

  connect() {
    mindDoubleClicks(document);
    const press = (id, action) => byId(id).addEventListener('click', action);
    press('undo', () => this.undo());
    press('redo', () => this.redo());
    press('save', () => saving.save(this));
    press('command', () => saving.copyCommand(this));
    press('png', () => saving.savePng(this));
    press('back', () => this.back());
    press('reset', () => this.reset());
    press('render', () => this.rendering.open());
    press('export', () => this.exporting.open());
    press('open', () => byId('file').click());
    byId('file').addEventListener('change', event => { const [file] = event.target.files; event.target.value = ''; if (file) bring(this, file); });
    const volumes = () => {
      this.volumes.level = Number(byId('volume-level').value) - 1;
      this.volumes.kind = byId('volume-kind').value;
      byId('volume-number').textContent = this.volumes.level < 0 ? 'none' : `level ${this.volumes.level}${this.volumes.overflows() ? ': too many' : ''}`;
      this.handles.draw();
    };
    byId('volume-level').addEventListener('input', volumes);
    byId('volume-kind').addEventListener('change', volumes);
    byId('wires').addEventListener('change', event => this.showWires(event.target.value));
    press('help', () => byId('help-dialog').showModal());
    press('theme', () => this.changeTheme());
    for (const tab of tabs) press(`tab-${tab}`, () => this.choose(tab));
    byId('samples').addEventListener('change', () => this.live.change());
    byId('frame').addEventListener('input', event => this.setFrame(Number(event.target.value)));
    press('new', () => this.place.begin());
    addEventListener('dragover', event => { if (event.dataTransfer.types.includes('Files')) event.preventDefault(); });
    addEventListener('drop', event => takeDropped(this, event));
    addEventListener('hashchange', () => this.place.arrive());
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
  await studio.place.arrive();
  window.studio = studio;
}

begin().catch(error => {
  document.body.append(element('p', { class: 'mistakes' }, error.message));
});
