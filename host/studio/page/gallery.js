// The scenes there are, as small pictures that the engine makes when they come into sight.
import { byId, element } from './elements.js';
import * as server from './server.js';

const thumbnail = { columns: 264, rows: 198, samples: 1, machine: '', settings: [] };
const patience = 8000;  // milliseconds for one of them

class Thumbnails {
  constructor() {
    this.queue = [];
    this.busy = false;
    this.seen = new IntersectionObserver(entries => {
      for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        this.seen.unobserve(entry.target);
        this.queue.push(entry.target);
      }
      this.work();
    }, { root: byId('gallery'), rootMargin: '200px' });
    this.jobs = new WeakMap();
  }
  add(card, job) { this.jobs.set(card, job); this.seen.observe(card); }
  async work() {
    if (this.busy) return;
    this.busy = true;
    for (let card; !this.paused && (card = this.queue.shift());) {
      const late = setTimeout(() => server.stop('thumbnail'), patience);
      try {
        const made = await this.jobs.get(card)();
        if (!made && this.paused) this.queue.unshift(card);
        else if (!made) card.querySelector('.why').textContent = 'takes long to prepare: open it to see it';
      } catch (error) { card.querySelector('.why').textContent = String(error.message).split('\n')[0]; }
      clearTimeout(late);
    }
    this.busy = false;
  }

  /// Whoever looks at a scene needs the program for that.
  pause() {
    this.paused = true;
    if (this.busy) server.stop('thumbnail').catch(() => {});
  }
  resume() {
    this.paused = false;
    this.work();
  }
}

export class Gallery {
  constructor(facts, open) {
    this.thumbnails = new Thumbnails();
    this.open = open;
    byId('folder').textContent = facts.folder;
    this.showOwn(facts.scenes);
    byId('shipped-cards').replaceChildren(...facts.shipped.map(scene =>
      this.card(scene.name, async () => scene.text, () => open(scene.name, true))));
  }

  showOwn(names) {
    byId('own').hidden = names.length === 0;
    byId('own-cards').replaceChildren(...names.map(name =>
      this.card(name, async () => (await server.open(name)).text, () => this.open(name, false))));
  }

  /// After something was saved: there is a scene more, or one looks otherwise.
  async renew() {
    try {
      this.showOwn((await server.start()).scenes);
    } catch { /* the studio has ended, and says so elsewhere */ }
  }

  /// What one has left without saving it.
  showUnsaved(scenes) {
    byId('unsaved').hidden = scenes.length === 0;
    byId('unsaved-cards').replaceChildren(...scenes.map(({ name, shipped, text }) =>
      this.card(name, async () => text, () => this.open(name, shipped))));
  }

  card(name, text, open) {
    const canvas = element('canvas', { width: thumbnail.columns, height: thumbnail.rows, 'aria-hidden': 'true' });
    const card = element('li', {}, element('button', { class: 'scene-card', onclick: open, title: name },
      canvas, element('span', { class: 'caption' }, name.replace(/\.pxm$/, '')), element('span', { class: 'why' })));
    this.thumbnails.add(card, async () => {
      const picture = await server.picture({ name, text: await text(), ...thumbnail }, 'thumbnail');
      if (picture) canvas.getContext('2d').putImageData(picture.pixels, 0, 0);
      if (picture) canvas.classList.add('made');
      return picture !== null;
    });
    return card;
  }
}
