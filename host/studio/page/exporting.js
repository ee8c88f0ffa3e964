// The scene for other programs: its cells or its systems as a file below the studio's folder, written
// by the program while one sees how far it is, and given up when one wants.
import { byId, toast } from './elements.js';
import * as server from './server.js';

const look = 150;                   // milliseconds between two looks at how far it is
const systems = ['aifs', 'flame'];  // formats that hold no cells

export class Exporting {
  constructor(studio) {
    this.studio = studio;
    this.running = false;
    this.replaces = null;  // a name that was said to be there already
    byId('export-form').addEventListener('submit', event => { event.preventDefault(); this.export(); });
    byId('export-cancel').addEventListener('click', () => this.cancel());
    byId('export-dialog').addEventListener('close', () => { if (this.running) this.cancel(); });
    byId('export-format').addEventListener('change', () => this.choose());
    byId('export-end').addEventListener('change', () => this.choose());
    byId('export-name').addEventListener('input', () => { this.replaces = null; });
  }

  get format() { return byId('export-format').value; }

  open() {
    if (this.studio.goodText === '') return toast('There is nothing to export yet: mend the scene first.', 'bad');
    byId('export-name').value = this.studio.name.replace(/\.pxm$/, `.${this.format}`);
    this.say('');
    this.choose();
    byId('export-dialog').showModal();
    return undefined;
  }

  /// The name says the format, and what ends a cell has its field.
  choose() {
    const name = byId('export-name'), end = byId('export-end').value;
    name.value = name.value.replace(/(\.[a-z]+)?$/, `.${this.format}`);
    byId('export-cells').hidden = systems.includes(this.format);
    byId('export-levels-label').hidden = end !== 'levels';
    byId('export-detail-label').hidden = end !== 'detail';
    this.replaces = null;
  }

  say(text, bad = false) {
    byId('export-note').textContent = text;
    byId('export-note').classList.toggle('refused', bad);
  }

  question() {
    const { name, text, frame } = this.studio.shown();
    const file = byId('export-name').value.trim(), end = byId('export-end').value;
    const cells = systems.includes(this.format) || end === 'scene' ? {} : { [end]: Number(byId(`export-${end}`).value) };
    return { name, text, frame, file, replaces: this.replaces === file, ...cells };
  }

  async export() {
    if (this.running) return;
    this.running = true;
    byId('export-start').disabled = true;
    byId('export-share').hidden = false;
    const watch = setInterval(() => this.look(), look), question = this.question();
    try {
      const answer = await server.exportFile(question);
      if (!answer || !this.running) this.say('Given up. Nothing was written.');
      else if (answer.exported) this.say(`${question.file} is written. ${answer.messages}`.trim());
      else {
        this.replaces = question.file;
        this.say(`${question.file} is there already. Export again to replace it.`);
      }
    } catch (error) {
      this.say(error.message, true);
    } finally {
      clearInterval(watch);
      this.running = false;
      byId('export-start').disabled = false;
      byId('export-share').hidden = true;
    }
  }

  async look() {
    const progress = await server.progress('export').catch(() => null);
    if (!this.running) return;
    const share = progress?.share ?? 0;
    byId('export-share').value = share;
    this.say(share > 0 ? `${Math.floor(100 * share)} %` : 'Preparing the cells …');
  }

  /// Ends the export, or closes the dialog where there is none.
  cancel() {
    if (!this.running) return byId('export-dialog').close();
    this.running = false;
    return server.stop('export');
  }
}
