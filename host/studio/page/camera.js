// Where one looks from. The point looked at is a decimal number of 70 places; the eye stands in a
// direction from it, at a distance; both together are what a scene's camera says with `look`, `eye`
// and `zoom`, to 10^30.
import * as decimal from './decimal.js';
import { add, cross, dot, length, scaled, subtract, turned, unit } from './vectors.js';

export const furthest = 1e30;  // docs/deep-zoom.md
const least = 1e-3;
const nearest_pole = 0.02;  // radians between the view and `up`

/// The camera that a checked scene has.
export function cameraOf(view) {
  const look = view.look.map(decimal.fromText);
  const offset = view.eye.map(decimal.fromText).map((x, i) => decimal.toNumber(x - look[i]));
  const reach = length(offset) || 1;
  return {
    look, reach, away: length(offset) > 0 ? unit(offset) : [0, 0, -1], distance: reach / view.zoom,
    up: view.up, halfWidth: view.half_width, width: view.orthographic, moved: false,
  };
}

export const magnification = camera => camera.reach / camera.distance;

/// Unit vectors of the picture, left-handed as the world is.
export function frameOf(camera) {
  const forward = scaled(camera.away, -1);
  let up = camera.up;
  if (length(cross(up, forward)) < 1e-9 * length(up)) up = [0, 0, 1];
  const right = unit(cross(up, forward));
  return { forward, right, up: cross(forward, right) };
}

/// Half of what the picture shows across, where it looks.
const halfAcross = camera =>
  camera.width === null ? camera.halfWidth * camera.distance : camera.width / 2 / magnification(camera);

const moved = (camera, change) => ({ ...camera, ...change, moved: true });

/// From the point looked at to the place under (x, y), where the picture's width goes from -1 to 1.
const offsetAt = (camera, x, y) => {
  const { right, up } = frameOf(camera);
  return scaled(add(scaled(right, x), scaled(up, y)), halfAcross(camera));
};

const shifted = (look, offset) => look.map((x, i) => x + decimal.fromNumber(offset[i]));

export function orbited(camera, aside, upward) {
  const axis = unit(camera.up);
  const { right } = frameOf(camera);
  const about = turned(camera.away, axis, aside);
  const angle = Math.acos(Math.min(1, Math.max(-1, dot(about, axis))));
  const wanted = Math.min(Math.PI - nearest_pole, Math.max(nearest_pole, angle - upward));
  return moved(camera, { away: unit(turned(about, turned(right, axis, aside), wanted - angle)) });
}

export const panned = (camera, x, y) =>
  moved(camera, { look: shifted(camera.look, scaled(offsetAt(camera, x, y), -1)) });

/// By a factor within what there is.
function allowed(camera, factor) {
  const now = magnification(camera);
  return Math.min(furthest / now, Math.max(least / now, factor));
}

/// Nearer to the point that is looked at.
export const dollied = (camera, factor) =>
  moved(camera, { distance: camera.distance / allowed(camera, factor) });

/// Nearer to a place that stays where it is in the picture: all of the view shrinks about it.
export function approached(camera, place, factor) {
  const f = allowed(camera, factor);
  const look = camera.look.map((x, i) => place[i] + decimal.times(x - place[i], 1 / f));
  return moved(camera, { look, distance: camera.distance / f });
}

/// The place under (x, y) as far away as what is looked at.
export const placeUnder = (camera, x, y) => shifted(camera.look, offsetAt(camera, x, y));

/// The same view, about a place that is as far away as this one: orbits and pans go by it.
export function pivoted(camera, place) {
  const eye = shifted(camera.look, scaled(camera.away, camera.distance));
  const ahead = dot(place.map((x, i) => decimal.toNumber(x - eye[i])), scaled(camera.away, -1));
  if (!(ahead > 0) || camera.width !== null) return camera;
  return { ...camera, look: shifted(eye, scaled(camera.away, -ahead)), distance: ahead };
}

/// What all points have in common; a camera is never changed, and seventy digits take their time.
const views = new WeakMap();
function viewOf(camera) {
  if (!views.has(camera)) views.set(camera, { ...frameOf(camera), look: camera.look.map(decimal.toNumber), offset: scaled(camera.away, camera.distance) });
  return views.get(camera);
}

/// The point looked at, as near as a double says it.
export const lookOf = camera => viewOf(camera).look;

/// Where a point of the world is in the picture, and how far ahead; coordinates as offsetAt's.
export function projected(camera, world) {
  const { forward, right, up, look, offset } = viewOf(camera);
  const from = subtract(subtract(world, look), offset);
  const ahead = dot(from, forward);
  const across = camera.width === null ? ahead * camera.halfWidth : halfAcross(camera);
  return { x: dot(from, right) / across, y: dot(from, up) / across, ahead };
}

/// What a drag by (x, y) means at a point that is so far ahead.
export function dragged(camera, ahead, x, y) {
  const { right, up } = frameOf(camera);
  const across = camera.width === null ? ahead * camera.halfWidth : halfAcross(camera);
  return scaled(add(scaled(right, x), scaled(up, y)), across);
}

const plain = x => decimal.toText(decimal.fromText(x.toPrecision(15)));

/// What `--set` says of it; nothing while it is the scene's own.
export function settingsOf(camera) {
  if (!camera.moved) return [];
  const eye = shifted(camera.look, scaled(camera.away, camera.reach));
  const digits = Math.min(decimal.places, 20 + Math.ceil(Math.log10(Math.max(1, magnification(camera)))));
  const cut = x => decimal.toText(x - x % 10n ** BigInt(decimal.places - digits));
  const cutEye = x => decimal.toText(x - x % 10n ** BigInt(decimal.places - 20));
  return [
    `camera.look=${camera.look.map(cut).join(',')}`,
    `camera.eye=${eye.map(cutEye).join(',')}`,
    `camera.zoom=${plain(magnification(camera))}`,
  ];
}

/// For the address, and back.
export const toAddress = camera => (camera.moved ? settingsOf(camera).map(s => s.slice(7)).join(';') : '');
export function fromAddress(text, base) {
  const values = Object.fromEntries(text.split(';').map(part => part.split('=')));
  if (!values.look || !values.eye || !(Number(values.zoom) > 0)) return base;
  const view = { look: values.look.split(','), eye: values.eye.split(','), zoom: Number(values.zoom),
    up: base.up, half_width: base.halfWidth, orthographic: base.width };
  if (view.look.length !== 3 || view.eye.length !== 3) return base;
  return { ...cameraOf(view), moved: true };
}
