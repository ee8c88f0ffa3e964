// The picture as a file, as large as one likes: rendered by the program while one sees how far it is,
// and given up when one wants.
import { byId, element, toast } from './elements.js';
import * as server from './server.js';

const look = 150;  // milliseconds between two looks at how far it is

export const nameOf = studio => studio.name.replace(/^.*\//, '').replace(/\.pxm$/, '.png');

export function download(blob, name) {
  const link = element('a', { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

export class Rendering {
  constructor(studio) {
    this.studio = studio;
    this.running = false;
    byId('render-form').addEventListener('submit', event => { event.preventDefault(); this.render(); });
    byId('render-cancel').addEventListener('click', () => this.cancel());
    byId('render-dialog').addEventListener('close', () => { if (this.running) this.cancel(); });
    byId('render-columns').addEventListener('input', () => this.keepShape());
  }

  open() {
    if (this.studio.goodText === '') return toast('There is no picture yet: mend the scene first.', 'bad');
    const { columns, rows } = this.studio.live.size;
    this.shape = rows / columns;
    byId('render-columns').value = columns;
    byId('render-rows').value = rows;
    this.say('');
    byId('render-dialog').showModal();
    return undefined;
  }

  keepShape() {
    const columns = Number(byId('render-columns').value);
    if (columns > 0) byId('render-rows').value = Math.max(1, Math.round(columns * this.shape));
  }

  say(text, bad = false) {
    byId('render-note').textContent = text;
    byId('render-note').classList.toggle('refused', bad);
  }

  async render() {
    if (this.running) return;
    this.running = true;
    byId('render-start').disabled = true;
    byId('render-share').hidden = false;
    const watch = setInterval(() => this.look(), look);
    try {
      const picture = await server.png({ ...this.studio.shown(), machine: '', columns: Number(byId('render-columns').value),
        rows: Number(byId('render-rows').value), samples: Number(byId('render-samples').value) }, 'file');
      if (picture && this.running) {
        download(picture, nameOf(this.studio));
        this.say(`${nameOf(this.studio)} is among your downloads.`);
      } else this.say('Given up.');
    } catch (error) {
      this.say(error.message, true);
    } finally {
      clearInterval(watch);
      this.running = false;
      byId('render-start').disabled = false;
      byId('render-share').hidden = true;
    }
  }

  async look() {
    const progress = await server.progress('file').catch(() => null);
    if (!this.running) return;
    const share = progress?.share ?? 0;
    byId('render-share').value = share;
    this.say(share > 0 ? `${Math.floor(100 * share)} %` : 'Preparing the scene …');
  }

  /// Ends the render, or closes the dialog where there is none.
  cancel() {
    if (!this.running) return byId('render-dialog').close();
    this.running = false;
    return server.stop('file');
  }
}
