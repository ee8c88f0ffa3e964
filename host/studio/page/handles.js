// Maps in the picture (Sec. 9.3): each as the image of one tetrahedron that stands for the whole. A
// corner, a face or the middle of the one that is selected can be dragged.
import { dragged, projected } from './camera.js';
import { cornersOf, mapOf, moveMap, replaceSteps, stepsOf, tetrahedronStep } from './map_edits.js';
import { add, direction, identity, inverse, lipschitz, point, scaled } from './vectors.js';

const faces = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]];  // each without the corner of its number
const edges = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
const most_wires = 12;  // maps of which all are drawn unless one asks for it: more cover the picture
const reach = 14;  // CSS pixels around a handle that mean it
const upright = [[0, 1, 0], [0, -1 / 3, -Math.sqrt(8) / 3], [Math.sqrt(2 / 3), -1 / 3, Math.sqrt(2) / 3], [-Math.sqrt(2 / 3), -1 / 3, Math.sqrt(2) / 3]];

/// A tetrahedron in the ball around a system, in numbers that are short enough to be written.
export function referenceOf(center, radius) {
  const digits = Math.max(0, 2 - Math.floor(Math.log10(radius)));
  return upright.map(v => add(center, scaled(v, radius)).map(x => Number(x.toFixed(Math.min(15, digits)))));
}

/// How far ahead a triangle is under a place of the screen; null if it is not there.
function depthUnder([a, b, c], x, y) {
  const area = (p, q, r) => (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  const at = { x, y }, all = area(a, b, c);
  if (Math.abs(all) < 1) return null;
  const [u, v, w] = [area(at, b, c) / all, area(a, at, c) / all, area(a, b, at) / all];
  return u < 0 || v < 0 || w < 0 ? null : u * a.ahead + v * b.ahead + w * c.ahead;
}

export class Handles {
  /// `scene()` gives { text, block, map, lets, camera, reference, place, growing } (`place`: the object's
  /// matrix, `growing`: whether the system does not contract),
  /// or null where there is nothing to shape.
  constructor(canvas, scene, over) {
    this.canvas = canvas;
    this.scene = scene;
    this.over = over;  // draws more, above the maps: draw(context), isEmpty()
    this.drag = null;
    this.hovered = null;
    this.keyed = null;  // that arrow keys move: { map, corner }
    this.chosen = '';   // which maps somebody wants to be drawn; '' as long as nobody has said it
  }

  /// Which maps are drawn: 'all', the one that is 'open', or 'none'.
  wiresOf(count) { return this.chosen || (count > most_wires ? 'open' : 'all'); }
  /// The maps that are drawn, by their places in the system.
  drawnIn(scene) {
    const wires = this.wiresOf(scene.block.maps.length);
    return scene.block.maps.flatMap((_, i) => (wires === 'all' || (wires === 'open' && i === scene.map) ? [i] : []));
  }

  /// Once a frame: whoever asks the page for it has it laid out.
  measure() { return this.size = { w: this.canvas.clientWidth, h: this.canvas.clientHeight }; }

  /// CSS pixels; (0, 0) is at the top left.
  toScreen(camera, world) {
    const { w, h } = this.size ?? this.measure();
    const p = projected(camera, world);
    return { x: w / 2 * (1 + p.x), y: h / 2 - w / 2 * p.y, ahead: p.ahead };
  }

  /// The tetrahedron whose image a map is drawn as: that of its own step, or the one for all.
  referenceFor(scene, index) {
    const steps = stepsOf(scene.block.maps[index]);
    const own = steps.length === 1 && steps[0].word === 'tetrahedron' ? cornersOf(steps[0], scene.lets) : null;
    return own?.from ?? scene.reference;
  }

  cornersIn(scene, index) {
    const map = mapOf(scene.block.maps[index], scene.lets);
    return map && this.referenceFor(scene, index).map(c => point(scene.place, point(map, c)));
  }

  draw() {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const { w, h } = this.measure();
    const scene = this.scene();
    // A canvas that is cleared is shown anew, which costs as much as a part of the picture under it.
    const empty = !scene && this.over.isEmpty();
    if (empty && this.empty) return;
    this.empty = empty;
    if (this.canvas.width !== Math.round(w * ratio)) this.canvas.width = Math.round(w * ratio);
    if (this.canvas.height !== Math.round(h * ratio)) this.canvas.height = Math.round(h * ratio);
    const context = this.canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, w, h);
    if (scene) this.drawMaps(context, scene);
    this.over.draw(context);
  }

  drawMaps(context, scene) {
    const drawn = this.drawnIn(scene);
    if (drawn.length === 0) return;
    this.tetrahedron(context, scene.reference.map(c => this.toScreen(scene.camera, point(scene.place, c))), 'whole');
    for (const i of drawn) if (i !== scene.map) this.drawMap(context, scene, i, 'other');
    if (drawn.includes(scene.map)) this.drawMap(context, scene, scene.map, 'selected');
  }

  drawMap(context, scene, index, role) {
    const corners = this.cornersIn(scene, index);
    const grows = scene.growing && lipschitz(mapOf(scene.block.maps[index], scene.lets) ?? identity) >= 1;
    if (corners) this.tetrahedron(context, corners.map(c => this.toScreen(scene.camera, c)), role, grows);
  }

  tetrahedron(context, corners, role, grows = false) {
    if (corners.some(c => !(c.ahead > 0))) return;
    const path = () => {
      context.beginPath();
      for (const [a, b] of edges) { context.moveTo(corners[a].x, corners[a].y); context.lineTo(corners[b].x, corners[b].y); }
    };
    const selected = role === 'selected';
    context.setLineDash(role === 'whole' ? [3, 5] : []);
    context.lineJoin = 'round';
    path(); context.strokeStyle = 'rgba(0,0,0,0.55)'; context.lineWidth = selected ? 4 : 2.5; context.stroke();
    path(); context.strokeStyle = grows ? '#ff7d72' : selected ? '#ffc24d' : role === 'whole' ? 'rgba(255,255,255,0.55)' : 'rgba(140,190,255,0.7)';
    context.lineWidth = selected ? 2 : 1; context.stroke();
    context.setLineDash([]);
    if (!selected) return;
    const face = faces[(this.drag ?? this.keyed ?? this.hovered)?.corner - 5];
    if (face) this.fillFace(context, face.map(i => corners[i]));
    for (const [i, c] of [...corners, this.middle(corners)].entries()) {
      const size = this.keyed?.corner === i ? 9 : 6;
      context.beginPath();
      if (i === 4) context.rect(c.x - size, c.y - size, 2 * size, 2 * size); else context.arc(c.x, c.y, size, 0, 7);
      context.fillStyle = '#ffc24d'; context.strokeStyle = 'rgba(0,0,0,0.8)'; context.lineWidth = 2;
      context.fill(); context.stroke();
    }
  }

  fillFace(context, corners) {
    context.beginPath();
    corners.forEach(c => context.lineTo(c.x, c.y));
    context.closePath();
    context.fillStyle = 'rgba(255,194,77,0.35)';
    context.fill();
  }

  middle(corners) {
    const mean = k => corners.reduce((sum, c) => sum + c[k], 0) / corners.length;
    return { x: mean('x'), y: mean('y'), ahead: mean('ahead') };
  }

  /// What is under a place: { map, corner }, or null. 4 is the middle, and from 5 on are the faces
  /// opposite the corners: of those under the place the nearest to the eye.
  hit(x, y) {
    const scene = this.scene();
    if (!scene) return null;
    const far = p => Math.hypot(p.x - x, p.y - y);
    if (this.drawnIn(scene).includes(scene.map)) {
      const corners = this.cornersIn(scene, scene.map)?.map(c => this.toScreen(scene.camera, c));
      if (corners?.every(c => c.ahead > 0)) {
        const all = [...corners, this.middle(corners)];
        const nearest = all.reduce((best, c, i) => (far(c) < far(all[best]) ? i : best), 0);
        if (far(all[nearest]) <= reach) return { map: scene.map, corner: nearest };
        const under = faces.map((face, i) => ({ i, ahead: depthUnder(face.map(c => corners[c]), x, y) })).filter(f => f.ahead !== null);
        if (under.length > 0) return { map: scene.map, corner: 5 + under.reduce((a, b) => (b.ahead < a.ahead ? b : a)).i };
      }
    }
    return null;
  }

  /// The map whose tetrahedron's middle is nearest to a place, if it is near.
  nearest(x, y) {
    const scene = this.scene();
    if (!scene) return -1;
    let best = -1, least = 30;
    this.drawnIn(scene).forEach(i => {
      const corners = this.cornersIn(scene, i)?.map(c => this.toScreen(scene.camera, c));
      if (!corners?.every(c => c.ahead > 0)) return;
      const m = this.middle(corners), distance = Math.hypot(m.x - x, m.y - y);
      if (distance < least) [best, least] = [i, distance];
    });
    return best;
  }

  begin(hit, x, y) {
    const scene = this.scene();
    const from = this.referenceFor(scene, hit.map);
    const whole = mapOf(scene.block.maps[hit.map], scene.lets);
    const seen = this.cornersIn(scene, hit.map).map(c => this.toScreen(scene.camera, c));
    this.drag = { ...hit, x, y, scene, from, to: from.map(c => point(whole, c)), back: inverse(scene.place),
      ahead: hit.corner < 4 ? seen[hit.corner].ahead : hit.corner === 4 ? this.middle(seen).ahead : this.middle(faces[hit.corner - 5].map(i => seen[i])).ahead };
  }

  /// The text with the map where the pointer has taken it.
  moved(x, y) {
    const { scene, map, corner, from, to, back, ahead } = this.drag;
    const across = 2 / this.canvas.clientWidth;
    const world = dragged(scene.camera, ahead, (x - this.drag.x) * across, (this.drag.y - y) * across);
    const offset = back ? direction(back, world) : world;
    const block = scene.block.maps[map];
    if (corner === 4) return moveMap(scene.text, block, scene.lets, offset);
    const moves = i => (corner < 4 ? i === corner : faces[corner - 5].includes(i));
    return replaceSteps(scene.text, block, tetrahedronStep(from, to.map((c, i) => (moves(i) ? add(c, offset) : c))));
  }

  end() { this.drag = null; }

  // --- with keys --------------------------------------------------------------------------------

  /// The next handle of the selected map, or the one before it: what it is, in words; null if there is
  /// none.
  choose(step) {
    const scene = this.scene();
    if (!scene || scene.map < 0) return null;
    const count = 5 + faces.length, before = this.keyed?.map === scene.map ? this.keyed.corner : step > 0 ? 3 : 5;
    this.keyed = { map: scene.map, corner: (before + step + count) % count };
    this.draw();
    const { corner } = this.keyed;
    return corner < 4 ? `corner ${corner + 1}` : corner === 4 ? 'the whole' : `the face opposite corner ${corner - 4}`;
  }
  letGo() {
    this.keyed = null;
    this.draw();
  }
  /// The text with the chosen handle so many CSS pixels beside its place; null if none is chosen.
  nudged(x, y) {
    if (!this.keyed || this.scene()?.map !== this.keyed.map) return null;
    this.begin(this.keyed, 0, 0);
    const text = this.moved(x, y);
    this.end();
    return text;
  }
}
