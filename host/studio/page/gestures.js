// What hands do on the picture: mouse, wheel, fingers and keys become turns, moves and zooms of the
// camera, and drags of handles.
import { dollied, orbited, panned } from './camera.js';

const click = 4;           // CSS pixels that a click may move
const turn = 0.006;        // radians a CSS pixel
const key_turn = 0.08, key_move = 0.1, key_zoom = 1.25, key_pixels = 6, key_far = 30;

export class Gestures {
  /// `app`: camera, setCamera(camera, kind), zoomAt(x, y, factor), clicked(x, y), back(), reset(),
  /// chooseHandle(step), nextWires(), handles, edited(text), editEnds(), hovered(hit). Places are CSS pixels of the canvas.
  constructor(canvas, app) {
    this.canvas = canvas;
    this.app = app;
    this.pointers = new Map();
    canvas.addEventListener('pointerdown', e => this.down(e));
    canvas.addEventListener('pointermove', e => this.move(e));
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, e => this.up(e));
    canvas.addEventListener('wheel', e => this.wheel(e), { passive: false });
    canvas.addEventListener('contextmenu', e => e.preventDefault());
    canvas.addEventListener('keydown', e => this.key(e));
    canvas.addEventListener('keyup', e => { if (app.handles.keyed && e.key.startsWith('Arrow')) app.editEnds(); });
  }

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  down(event) {
    if (!this.app.camera) return;  // the scene is wrong: there is nothing to look at
    const at = this.place(event);
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, { ...at, start: at, far: false, pans: event.button !== 0 || event.shiftKey });
    const hit = this.pointers.size === 1 && event.button === 0 && !event.shiftKey ? this.app.handles.hit(at.x, at.y) : null;
    if (hit) this.app.handles.begin(hit, at.x, at.y);
  }

  move(event) {
    const pointer = this.pointers.get(event.pointerId);
    const at = this.place(event);
    if (!pointer) return this.app.hovered(this.app.handles.hit(at.x, at.y));
    const by = { x: at.x - pointer.x, y: at.y - pointer.y };
    pointer.far = pointer.far || Math.hypot(at.x - pointer.start.x, at.y - pointer.start.y) > click;
    if (this.app.handles.drag) {
      if (pointer.far) this.app.edited(this.app.handles.moved(at.x, at.y));
    } else if (this.pointers.size === 2) this.pinch(event.pointerId, at);
    else if (pointer.far) this.drag(pointer.pans, by);
    if (pointer.far || this.pointers.size === 2) Object.assign(pointer, at);
  }

  drag(pans, by) {
    const across = 2 / this.canvas.clientWidth;
    this.app.setCamera(pans ? panned(this.app.camera, by.x * across, -by.y * across)
      : orbited(this.app.camera, by.x * turn, by.y * turn), 'drag');
  }

  pinch(id, at) {
    const other = [...this.pointers].find(([key]) => key !== id)[1];
    const before = this.pointers.get(id);
    other.far = before.far = true;
    const far = p => Math.max(10, Math.hypot(p.x - other.x, p.y - other.y));
    const across = 1 / this.canvas.clientWidth;
    const moved = panned(this.app.camera, (at.x - before.x) * across, (before.y - at.y) * across);
    this.app.setCamera(moved, 'drag');
    this.app.zoomAt((at.x + other.x) / 2, (at.y + other.y) / 2, far(at) / far(before));
  }

  up(event) {
    const pointer = this.pointers.get(event.pointerId);
    this.pointers.delete(event.pointerId);
    if (this.app.handles.drag) {
      this.app.handles.end();
      return this.app.editEnds();
    }
    if (pointer && !pointer.far && event.type === 'pointerup' && event.button === 0) this.app.clicked(pointer.x, pointer.y);
  }

  wheel(event) {
    event.preventDefault();
    if (!this.app.camera) return;
    const at = this.place(event);
    const lines = event.deltaMode === 1 ? 30 : event.deltaMode === 2 ? 400 : 1;
    this.app.zoomAt(at.x, at.y, Math.exp(-Math.max(-400, Math.min(400, event.deltaY * lines)) * 0.002));
  }

  nudge([x, y], pixels) {
    const text = this.app.handles.nudged(x * pixels, -y * pixels);
    if (text !== null) this.app.edited(text);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.app.camera) return;
    const { clientWidth: w, clientHeight: h } = this.canvas;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (arrows && this.app.handles.keyed) this.nudge(arrows, event.shiftKey ? key_far : key_pixels);
    else if (arrows && event.shiftKey) this.app.setCamera(panned(this.app.camera, -arrows[0] * key_move, -arrows[1] * key_move), 'key');
    else if (arrows) this.app.setCamera(orbited(this.app.camera, arrows[0] * key_turn, -arrows[1] * key_turn), 'key');
    else if (event.key === '+' || event.key === '=') this.app.zoomAt(w / 2, h / 2, key_zoom);
    else if (event.key === '-') this.app.zoomAt(w / 2, h / 2, 1 / key_zoom);
    else if (event.key === 'PageUp') this.app.setCamera(dollied(this.app.camera, key_zoom), 'key');
    else if (event.key === 'PageDown') this.app.setCamera(dollied(this.app.camera, 1 / key_zoom), 'key');
    else if (event.key === 'Home') this.app.reset();
    else if (event.key === 'Backspace') this.app.back();
    else if (event.key === 'Enter') this.app.clicked(w / 2, h / 2);
    else if (event.key.toLowerCase() === 'h') this.app.chooseHandle(event.shiftKey ? -1 : 1);
    else if (event.key.toLowerCase() === 'w') this.app.nextWires();
    else if (event.key === 'Escape' && this.app.handles.keyed) this.app.handles.letGo();
    else return;
    event.preventDefault();
  }
}
