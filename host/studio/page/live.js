// The live picture: small at once, then whole, then smooth. What has begun to be small is shown; what
// is finer than that is given up as soon as anything changes. Where the whole picture comes as soon as a
// small one should, there is no small one; where it takes long, its parts are shown as they come.
import * as server from './server.js';

const quick = 45, easy = 20;  // milliseconds that a small picture may take, and when it may be larger
const at_once = 55, enough = 100;  // that the last whole picture took, for no small one to come first; and when that was wrong
const pace = 100;             // between two looks at the parts of a picture that takes long
const rest = 160;             // milliseconds without a change before samples are taken

const machine_pixels = 76_800;  // of a picture by the simulated machine

const pause = time => new Promise(done => setTimeout(done, time));

export class Live {
  /// `question()` is what to show: {name, text, settings, samples, machine, frame}; `told(event)` hears
  /// of every picture and of what is wrong, that there is another one to come ('changed'), and that there
  /// is none ('halted').
  constructor(canvas, question, told) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d', { alpha: false });
    this.small = document.createElement('canvas');
    this.question = question;
    this.told = told;
    this.version = 0;
    this.shown = -1;
    this.divisor = 4;
    this.wholeTook = Infinity;  // milliseconds, the last whole picture
    this.running = false;
    this.last = null;   // the picture that is shown whole
    this.spare = null;  // the pixels of the one before it
  }

  /// The canvas in device pixels, as many as the program gives. Whether it is of another size now.
  fit(most) {
    const box = this.canvas.parentElement.getBoundingClientRect();
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const wanted = [box.width * ratio, box.height * ratio].map(x => Math.max(16, Math.round(x)));
    const shrink = Math.min(1, most.side / Math.max(...wanted), Math.sqrt(most.pixels / (wanted[0] * wanted[1])));
    const [columns, rows] = wanted.map(x => Math.max(16, Math.floor(x * shrink)));
    if (columns === this.canvas.width && rows === this.canvas.height) return false;
    const old = this.canvas.width > 1 && this.last ? createCopy(this.canvas) : null;
    this.canvas.width = columns;
    this.canvas.height = rows;
    if (old) this.context.drawImage(old, 0, 0, columns, rows);
    this.change();
    return true;
  }

  /// Nothing of another scene stays.
  clear() {
    this.last = null;
    this.wholeTook = Infinity;
    this.told({ kind: 'halted' });
    this.context.fillStyle = getComputedStyle(this.canvas).getPropertyValue('--stage');
    this.context.fillRect(0, 0, this.canvas.width, this.canvas.height);
  }

  get size() { return { columns: this.canvas.width, rows: this.canvas.height }; }

  /// Of the picture that is made in the end: the machine's is smaller.
  get wholeSize() {
    const { columns, rows } = this.size;
    const shrink = this.question()?.machine ? Math.min(1, Math.sqrt(machine_pixels / (columns * rows))) : 1;
    return { columns: Math.max(16, Math.round(columns * shrink)), rows: Math.max(16, Math.round(rows * shrink)) };
  }

  /// Something to show is another.
  change() {
    ++this.version;
    this.changed = performance.now();
    this.told({ kind: 'changed' });
    if (!this.running) this.run();
    else if (this.wake) this.wake();
  }

  /// Nothing more for what is to show now; what is shown stays.
  stop() {
    this.halted = this.version;
    this.told({ kind: 'halted' });
    if (this.wake) this.wake();
  }

  async run() {
    this.running = true;
    try {
      while (this.shown !== this.version) {
        await this.refine(this.version);
        if (this.halted === this.version) this.shown = this.version;
      }
    } finally {
      this.running = false;
    }
  }

  /// All steps for one version, until there is another.
  async refine(version) {
    if (!this.question()) {  // there is no scene yet
      this.shown = version;
      return;
    }
    const { columns, rows } = this.wholeSize;
    const fresh = () => version === this.version && this.halted !== version;
    try {
      const machine = Boolean(this.question().machine);
      const quickly = !machine && this.wholeTook < at_once;
      if (!machine && !quickly && !await this.coarse(columns, rows)) return;
      if (!fresh()) return;
      const begin = performance.now(), changed = this.changed;
      let picture = await this.whole({ columns, rows, samples: 1 }, fresh, quickly ? enough : 0);
      if (!machine) this.wholeTook = picture ? performance.now() - begin : Math.max(this.wholeTook, performance.now() - begin);
      if (!picture) return;
      this.show(picture, fresh() ? 'whole' : 'coarse', begin, changed);
      if (!fresh()) return;
      const samples = this.question().samples;
      if (samples !== 1 && !this.question().machine) {
        await this.sleep(rest - (performance.now() - this.changed));
        if (!fresh()) return;
        picture = await this.whole({ columns, rows, samples }, fresh);
        if (!picture || !fresh()) return;
        this.show(picture, 'smooth', begin, changed);
      }
      this.shown = version;
      this.told({ kind: 'done' });
    } catch (error) {
      this.shown = version;  // the last good picture stays
      this.told({ kind: 'refused', error });
    }
  }

  async coarse(columns, rows) {
    const size = [columns, rows].map(x => Math.max(8, Math.round(x / this.divisor)));
    const begin = performance.now(), changed = this.changed;
    const picture = await server.picture({ ...this.question(), columns: size[0], rows: size[1], samples: 1 });
    if (!picture) return false;
    this.stretch(picture.pixels, true);
    const took = performance.now() - begin;
    if (took > quick) this.divisor = Math.min(12, this.divisor * 1.25);
    if (took < easy) this.divisor = Math.max(2, this.divisor * 0.8);
    this.told({ kind: 'picture', phase: 'coarse', picture, took, since: performance.now() - changed });
    return true;
  }

  /// A whole picture; null as soon as there is a change, but not before `patience` milliseconds. The
  /// next question makes the program stop working on this one.
  async whole(more, fresh, patience = 0) {
    const begin = performance.now();
    let looked = begin;
    const asked = server.picture({ ...this.question(), ...more }, 'picture', parts => {
      const now = performance.now();
      if (now - looked < pace || !fresh()) return;
      looked = now;
      this.showParts(parts);
    }, this.spare);
    this.spare = null;
    asked.catch(() => {});  // what is wrong with a picture that nobody waits for
    const woken = new Promise(done => { this.wake = () => setTimeout(done, Math.max(0, begin + patience - performance.now()), null); });
    const picture = await Promise.race([asked, woken]);
    this.wake = null;
    return this.halted === this.version ? null : picture;
  }

  async sleep(time) {
    if (time <= 0) return;
    await Promise.race([pause(time), new Promise(done => { this.wake = done; })]);
    this.wake = null;
  }

  stretch(pixels, smooth) {
    this.small.width = pixels.width;
    this.small.height = pixels.height;
    this.small.getContext('2d').putImageData(pixels, 0, 0);
    this.context.imageSmoothingEnabled = smooth;
    this.context.drawImage(this.small, 0, 0, this.canvas.width, this.canvas.height);
  }

  /// `begin`: when it was asked for; `changed`: when what it shows became another.
  show(picture, phase, begin, changed) {
    const { pixels } = picture;
    if (pixels.width === this.canvas.width && pixels.height === this.canvas.height) this.context.putImageData(pixels, 0, 0);
    else this.stretch(pixels, false);
    const now = performance.now();
    if (phase !== 'coarse') [this.spare, this.last] = [this.last?.pixels ?? null, picture];
    this.told({ kind: 'picture', phase, picture, took: now - begin, since: now - changed });
  }

  /// What has come of a picture, over a smaller one of the same.
  showParts({ pixels, fresh }) {
    const blocks = fresh.splice(0);
    if (pixels?.width !== this.canvas.width || pixels.height !== this.canvas.height) return;
    for (const block of blocks) this.context.putImageData(pixels, 0, 0, ...block);
  }
}

function createCopy(canvas) {
  const copy = document.createElement('canvas');
  copy.width = canvas.width;
  copy.height = canvas.height;
  copy.getContext('2d').drawImage(canvas, 0, 0);
  return copy;
}
