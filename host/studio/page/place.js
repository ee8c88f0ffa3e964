// Where the page is: which scene it shows, from which view, as its address has it; and the texts that were
// not saved, which stay when one leaves them.
import * as cameras from './camera.js';
import { byId, element, toast } from './elements.js';
import { History } from './history.js';
import * as server from './server.js';
import { Unsaved } from './unsaved.js';

const settled = 300;  // milliseconds after a change before it stands in the address
const beginning = `# two copies of the whole: where do they stand?
ifs mine {
    newmap scale: 0.85 rotate: z,3 translate: 0,0.4,0 color: 0.2,0.6,0.3,0.4
    newmap scale: 0.4 rotate: z,50 translate: 0,0.4,0 color: 0.8,0.7,0.2,0.4
}
`;

export class Place {
  constructor(studio) {
    this.studio = studio;
    this.scene = null;  // that is shown, and where it is from; '' is the gallery
    this.dropped = null;
    this.unsaved = new Unsaved();
  }

  /// Shows what the address says.
  async arrive() {
    const { studio } = this;
    const wanted = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    const scene = wanted.scene ? `${wanted.scene}|${wanted.from ?? ''}` : '';
    if (scene !== this.scene) {
      this.scene = scene;
      if (!wanted.scene) return this.showGallery();
      try {
        await this.load(wanted.scene, wanted.from === 'pxm');
      } catch (error) {
        toast(error.message, 'bad');
        this.scene = '';
        return this.showGallery();
      }
    }
    if (wanted.tab) studio.choose(wanted.tab, false);
    if (studio.tab === 'machine') studio.useMachine(studio.facts.models.find(m => m.name === wanted.machine)?.name ?? '');
    if (wanted.frame) await studio.setFrame(Math.min(Number(wanted.frame) || 0, Number(byId('frame').max)));
    if (studio.base) {
      studio.forgetWord();
      studio.camera = cameras.fromAddress(wanted.view ?? '', studio.base);
      studio.cameraChanged();
    }
    return undefined;
  }

  /// `shipped`: it comes with pxm, or from nowhere, and has no file yet.
  async load(name, shipped) {
    const { studio } = this;
    const key = Unsaved.key(name, shipped), kept = this.unsaved.textOf(key);
    const file = shipped
      ? { text: this.dropped ?? studio.facts.shipped.find(s => s.name === name)?.text ?? beginning, digest: '' }
      : await server.open(name).catch(error => { if (kept === null) throw error; return { text: '', digest: '' }; });  // its file is gone, its text is not
    this.brought = this.dropped !== null;
    this.dropped = null;
    studio.gallery.thumbnails.pause();
    Object.assign(studio, { name, shipped, saved: file.text, digest: file.digest, history: this.unsaved.historyOf(key) ?? new History(file.text),
      checked: null, base: null, camera: null, trail: [], frame: 0, ifs: 0, map: file.text === beginning ? 0 : -1, goodText: '' });
    if (kept !== null) studio.history.put(kept);
    byId('panel-facts').replaceChildren(element('p', { class: 'note awaited' }, 'Facts come once the scene has been read.'));
    byId('gallery').hidden = true;
    byId('studio').hidden = false;
    byId('scene-tools').hidden = false;
    studio.showFrame();
    studio.live.clear();
    studio.flight.forget();
    studio.endDescent();
    studio.handles.chosen = '';
    studio.checking.growing = [];
    studio.live.fit(studio.facts.limits);
    studio.textChanged();
    await studio.answered;
  }

  showGallery() {
    this.studio.name = '';
    this.studio.gallery.showUnsaved(this.unsaved.list());
    this.studio.gallery.thumbnails.resume();
    byId('gallery').hidden = false;
    byId('studio').hidden = true;
    byId('scene-tools').hidden = true;
    byId('scene-name').textContent = '';
    document.title = 'pxm studio';
  }

  go(scene, shipped) {
    const address = String(new URLSearchParams({ scene, ...(shipped ? { from: 'pxm' } : {}) }));
    if (location.hash.slice(1) === address) this.arrive();
    else location.hash = address;
  }

  /// A new scene, with a text from elsewhere if there is one; never in the place of one that is not saved.
  begin(name = 'mine.pxm', text = null) {
    this.dropped = text;
    this.scene = '';
    let free = name;
    for (let i = 2; this.unsaved.has(Unsaved.key(free, true)); ++i) free = name.replace(/(\.pxm)?$/, `_${i}$1`);
    if (free !== name) toast(`${name} is not saved yet: it stays among all scenes. This is ${free}.`);
    this.go(free, true);
  }

  /// The scene has a file of that name now.
  saved(name) {
    this.scene = `${name}|`;
    this.keepText();
    this.note();
    this.studio.gallery.renew();
  }

  /// The view in the address, soon: a reload comes back to it.
  note() {
    clearTimeout(this.noting);
    this.noting = setTimeout(() => {
      const { name, shipped, tab, camera, machine, frame } = this.studio;
      if (!name || !camera) return;
      const view = cameras.toAddress(camera);
      const words = new URLSearchParams({ scene: name, ...(shipped ? { from: 'pxm' } : {}), ...(tab !== 'maps' ? { tab } : {}), ...(machine ? { machine } : {}), ...(frame > 0 ? { frame } : {}),
        ...(view ? { view } : {}) });
      history.replaceState(null, '', `#${words}`);
    }, settled);
  }

  keptAs() { return Unsaved.key(this.studio.name, this.studio.shipped); }

  /// What is saved is not kept: when its file is another one day, that is what is shown. What was brought
  /// from elsewhere has no file.
  keepText() {
    const { studio } = this;
    if (studio.text === studio.saved && !(this.brought && studio.shipped)) this.unsaved.forget(this.keptAs());
    else this.unsaved.keep(this.keptAs(), studio.history);
  }
}
