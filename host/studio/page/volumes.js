// Bounding volumes over the picture (Ch. 14): those of all cells of one level, or of the cells that one
// ray met.
import { lookOf } from './camera.js';
import { add, cross, followed, identity, inverse, length, point, scaled, subtract, unit } from './vectors.js';

export const most_cells = 600;  // drawn at once: more are not told apart, and take a frame longer than one notices
const round_sides = 96, rough_sides = 12;  // of the polygon that a ball's outline is drawn as
const most_edges = 1500;   // of all of them, so that a frame is drawn soon

/// Every word of maps of one level that the graph allows: { set, maps }, at most `most_cells`.
export function wordsOf(graph, level) {
  let cells = [{ set: graph.start, maps: [] }];
  for (let l = 0; l < level; ++l) {
    cells = cells.flatMap(c => graph.sets[c.set].maps.map(m => ({ set: graph.inside[m], maps: [...c.maps, m] })));
    if (cells.length > most_cells) return null;
  }
  return cells;
}

/// The set of what stands in the last map of a word.
export const setOf = (graph, maps) => (maps.length > 0 ? graph.inside[maps.at(-1)] : graph.start);

/// From a system's own coordinates to the cell of a word; the outermost map stands first.
export const mapOfWord = (matrices, maps) => maps.reduceRight((all, m) => followed(all, matrices[m]), identity);

/// The outline of a ball as `map` leaves it, seen by a camera: points of the world.
export function outlineOf(bounds, map, camera, sides = round_sides) {
  const back = inverse(map);
  if (!back) return null;
  const look = lookOf(camera);
  const eye = point(back, add(look, scaled(camera.away, camera.distance)));
  let to = subtract(eye, bounds.center), middle = bounds.center, radius = bounds.radius;
  if (camera.width === null) {
    const far = length(to);
    if (far <= radius) return null;  // one stands inside of it
    middle = add(middle, scaled(to, radius * radius / far / far));
    radius *= Math.sqrt(1 - (radius / far) ** 2);
  } else {
    to = subtract(point(back, add(look, camera.away)), point(back, look));
  }
  const axis = unit(to);
  const aside = unit(cross(axis, Math.abs(axis[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0])), other = cross(axis, aside);
  return Array.from({ length: sides }, (_, i) => {
    const angle = 2 * Math.PI * i / sides;
    return point(map, add(middle, add(scaled(aside, radius * Math.cos(angle)), scaled(other, radius * Math.sin(angle)))));
  });
}

const box_edges = [0, 1, 2].flatMap(axis => [0, 1, 2, 3].map(k => {
  const low = ((k >> axis) << (axis + 1)) | (k & ((1 << axis) - 1));
  return [low, low | (1 << axis)];
}));
export const cornersOfBox = ({ low, high }) =>
  Array.from({ length: 8 }, (_, i) => [0, 1, 2].map(axis => ((i >> axis) & 1 ? high : low)[axis]));

export class Volumes {
  /// `scene()`: { checked, camera, toScreen(world) } or null.
  constructor(scene) {
    this.scene = scene;
    this.level = -1;        // none
    this.kind = 'ball';
    this.cells = [];        // of a ray: { object, maps, what }
    this.chosen = null;     // of these, the one that is pointed at
  }

  /// Whether the level has more cells than are drawn.
  overflows() {
    const { ifs = [] } = this.scene()?.checked ?? {};
    return this.level > 0 && ifs.some(i => i.graph && wordsOf(i.graph, this.level) === null);
  }

  isEmpty() { return this.level < 0 && this.cells.length === 0; }

  draw(context) {
    const scene = this.scene();
    if (!scene) return;
    const drawn = this.level < 0 ? [] : scene.checked.objects.flatMap(object => {
      const ifs = scene.checked.ifs.find(i => i.name === object.ifs);
      return ifs?.graph ? (wordsOf(ifs.graph, this.level) ?? []).map(c => ({ object: object.name, maps: c.maps, what: 'level' })) : [];
    });
    this.sides = Math.max(rough_sides, Math.min(round_sides, Math.round(most_edges / (drawn.length + this.cells.length))));
    const cells = [...drawn, ...this.cells].filter(cell => cell !== this.chosen);
    for (const what of new Set(cells.map(cell => cell.what))) this.stroke(context, cells.filter(cell => cell.what === what).flatMap(cell => this.linesOf(cell, scene)), what);
    if (this.chosen) this.stroke(context, this.linesOf(this.chosen, scene), 'chosen');
  }

  linesOf(cell, scene) {
    const object = scene.checked.objects.find(o => o.name === cell.object);
    const ifs = object && scene.checked.ifs.find(i => i.name === object.ifs);
    if (!ifs?.graph) return [];
    const map = followed(mapOfWord(ifs.maps.map(m => m.matrix), cell.maps), object.matrix);
    const bounds = ifs.graph.sets[setOf(ifs.graph, cell.maps)];
    return (this.kind === 'box' ? this.boxLines(bounds, map, scene) : this.ballLines(bounds, map, scene)) ?? [];
  }

  /// All lines of a kind at once; what lies under them is darkened a little, if they are not very many.
  stroke(context, lines, what) {
    context.beginPath();
    for (const [a, b] of lines) { context.moveTo(a.x, a.y); context.lineTo(b.x, b.y); }
    context.lineWidth = what === 'chosen' ? 5 : 2.5;
    context.strokeStyle = 'rgba(0,0,0,0.5)';
    if (lines.length < 2 * most_edges) context.stroke();
    context.lineWidth = what === 'chosen' ? 2.5 : 1;
    context.strokeStyle = { chosen: '#ffc24d', missed: 'rgba(255,125,114,0.65)', level: 'rgba(127,224,180,0.85)' }[what] ?? 'rgba(140,190,255,0.9)';
    context.stroke();
  }

  ballLines(bounds, map, scene) {
    const outline = outlineOf(bounds, map, scene.camera, this.sides)?.map(scene.toScreen);
    return outline?.every(p => p.ahead > 0) ? outline.map((p, i) => [p, outline[(i + 1) % outline.length]]) : null;
  }
  boxLines(bounds, map, scene) {
    const corners = cornersOfBox(bounds).map(c => scene.toScreen(point(map, c)));
    return corners.every(p => p.ahead > 0) ? box_edges.map(([a, b]) => [corners[a], corners[b]]) : null;
  }
}
