// Flying to what is under the pointer. The program says which cell that is and gives an exact point of
// the attractor in it; the view shrinks about that point, so that it stays under the pointer. Now and
// then, and when the pointer has moved, the program is asked again.
import { approached, magnification, pivoted, placeUnder } from './camera.js';
import * as decimal from './decimal.js';

const steady = 5;        // CSS pixels within which the pointer means the same place
const asked_again = 24;  // times nearer
const behind = 1.5;      // times as far as the target

export class Flight {
  /// `app`: camera, setCamera(camera, kind), pickAt(x, y) -> cell or null, toPicture(x, y) -> [-1..1].
  constructor(app) {
    this.app = app;
    this.target = null;
    this.waiting = 0;   // logarithm of the factor that waits for an answer
    this.asking = false;
  }

  forget() { this.target = null; }

  async zoomAt(x, y, factor) {
    const target = this.target;
    const steadily = target && Math.hypot(target.x - x, target.y - y) <= steady;
    if (steadily && (factor <= 1 || magnification(this.app.camera) < target.until)) {
      this.app.setCamera(approached(this.app.camera, target.place, factor), 'zoom');
      return;
    }
    this.waiting += Math.log(factor);
    this.at = { x, y };
    if (!this.asking) await this.ask();
  }

  /// What to fly to. Through a gap beside the target one sees what lies far behind it: while the
  /// pointer rests, the flight goes on to where it was going.
  placeOf(cell, camera, x, y) {
    const target = this.target;
    const rests = target && Math.hypot(target.x - x, target.y - y) <= steady;
    if (rests && !(cell?.point && cell.distance < camera.distance * behind)) return target.place;
    return cell?.point ? cell.point.map(decimal.fromText) : placeUnder(camera, ...this.app.toPicture(x, y));
  }

  async ask() {
    this.asking = true;
    try {
      while (this.waiting !== 0) {
        const { x, y } = this.at;
        const cell = await this.app.pickAt(x, y);
        let camera = this.app.camera;
        const place = this.placeOf(cell, camera, x, y);
        if (place !== this.target?.place && cell?.point) camera = pivoted(camera, place);
        const factor = Math.exp(this.waiting);
        this.waiting = 0;
        this.target = { x, y, place, until: magnification(camera) * asked_again };
        this.app.setCamera(approached(camera, place, factor), 'zoom');
      }
    } catch {
      this.waiting = 0;  // the scene is wrong at the moment: there is nothing to fly to
    } finally {
      this.asking = false;
    }
  }
}
