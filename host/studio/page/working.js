// What the program is at, said over the picture once it takes a while, and a way to give it up.
import { byId, number, toast } from './elements.js';
import * as server from './server.js';

const patience = 600;  // milliseconds before anything is said
const look = 200;      // between two looks

export class Working {
  constructor(studio) {
    this.studio = studio;
    this.since = 0;
    byId('stop').addEventListener('click', () => this.stop());
    setInterval(() => this.look(), look);
  }

  get busy() { return this.studio.checking.runs !== null || this.studio.live.running; }

  async look() {
    const place = byId('working');
    if (!this.busy || !this.studio.name) {
      this.since = 0;
      place.hidden = true;
      return;
    }
    const now = performance.now();
    if (this.since === 0 || this.since < this.studio.live.changed) this.since = Math.max(now - look, this.studio.live.changed ?? 0);
    if (now - this.since < patience || this.asking) return;
    this.asking = true;
    try {
      const reads = this.studio.checking.runs !== null;
      const progress = reads ? null : await server.progress('picture');
      const share = progress?.share ?? 0;
      place.hidden = !this.busy;
      byId('working-text').textContent = reads ? 'Reading the scene …' : share > 0 ? `Rendering, ${Math.floor(100 * share)} %` : 'Preparing the scene …';
      byId('working-share').value = share;
      if (progress?.nodes?.length > 0) this.studio.machines.working(progress.nodes);
    } catch { /* the studio has ended, and says so elsewhere */ } finally {
      this.asking = false;
    }
  }

  /// All that this page has asked for. The last good picture stays.
  async stop() {
    const { studio } = this;
    studio.checking.stop();
    studio.live.stop();
    const begin = performance.now();
    await server.stopAll();
    byId('working').hidden = true;
    const took = server.lastStop();
    toast(`Stopped${took !== null ? `: the work ended ${number(took, 2)} ms later` : ''}. It goes on with the next change, or with the view.`);
    this.stopped = performance.now() - begin;
  }
}
