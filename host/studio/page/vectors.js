// Vectors of three numbers and affine maps in the thesis' form: a point is a row, x' = x M, and a map
// is twelve numbers, three rows of its linear part and the translation.

export const add = (a, b) => a.map((x, i) => x + b[i]);
export const subtract = (a, b) => a.map((x, i) => x - b[i]);
export const scaled = (a, s) => a.map(x => x * s);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = a => Math.hypot(...a);
export const unit = a => (length(a) > 0 ? scaled(a, 1 / length(a)) : [0, 0, 1]);

/// Turns a vector about a unit axis, by radians.
export function turned(v, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  const along = dot(axis, v) * (1 - c), side = cross(axis, v);
  return v.map((x, i) => x * c + side[i] * s + axis[i] * along);
}

export const identity = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];

export const direction = (m, v) => [0, 1, 2].map(c => v[0] * m[c] + v[1] * m[3 + c] + v[2] * m[6 + c]);
export const point = (m, p) => add(direction(m, p), m.slice(9));

/// First `a`, then `b`.
export const followed = (a, b) => [
  ...direction(b, a.slice(0, 3)), ...direction(b, a.slice(3, 6)), ...direction(b, a.slice(6, 9)),
  ...point(b, a.slice(9))];

export const determinant = m => dot(m.slice(0, 3), cross(m.slice(3, 6), m.slice(6, 9)));

/// Null if the map squashes space flat.
export function inverse(m) {
  const [a, b, c] = [m.slice(0, 3), m.slice(3, 6), m.slice(6, 9)];
  const d = determinant(m);
  if (Math.abs(d) < 1e-300) return null;
  const columns = [cross(b, c), cross(c, a), cross(a, b)].map(v => scaled(v, 1 / d));
  const linear = [0, 1, 2].flatMap(r => columns.map(v => v[r]));
  return [...linear, ...scaled(direction([...linear, 0, 0, 0], m.slice(9)), -1)];
}

/// The map that takes each corner of one tetrahedron to that of another; null if the first is flat.
export function tetrahedronMap(from, to) {
  const edges = t => [...subtract(t[1], t[0]), ...subtract(t[2], t[0]), ...subtract(t[3], t[0])];
  const back = inverse([...edges(from), ...from[0]]);
  return back && followed(back, [...edges(to), ...to[0]]);
}

/// How much longer the map can make a vector: its largest singular value (Sec. 16.2).
export function lipschitz(m) {
  const rows = [m.slice(0, 3), m.slice(3, 6), m.slice(6, 9)];
  const a = rows.map(r => rows.map(s => dot(r, s)));
  const p = a[0][1] ** 2 + a[0][2] ** 2 + a[1][2] ** 2;
  const q = (a[0][0] + a[1][1] + a[2][2]) / 3;
  const spread = a.reduce((sum, row, i) => sum + (row[i] - q) ** 2, 2 * p);
  if (spread === 0) return Math.sqrt(Math.max(0, q));
  const r = Math.sqrt(spread / 6);
  const b = a.map((row, i) => row.map((x, j) => (x - (i === j ? q : 0)) / r));
  const half = dot(b[0], cross(b[1], b[2])) / 2;
  return Math.sqrt(Math.max(0, q + 2 * r * Math.cos(Math.acos(Math.min(1, Math.max(-1, half))) / 3)));
}

const radians = degrees => degrees * Math.PI / 180;

export const scaling = ([x, y, z]) => [x, 0, 0, 0, y, 0, 0, 0, z, 0, 0, 0];
export const translation = t => [1, 0, 0, 0, 1, 0, 0, 0, 1, ...t];
/// z turns +x toward +y, x turns +y toward +z, y turns +z toward +x.
export function rotation(axis, degrees) {
  const c = Math.cos(radians(degrees)), s = Math.sin(radians(degrees));
  const linear = { x: [1, 0, 0, 0, c, s, 0, -s, c], y: [c, 0, -s, 0, 1, 0, s, 0, c], z: [c, s, 0, -s, c, 0, 0, 0, 1] };
  return [...linear[axis], 0, 0, 0];
}
