// Making elements. Texts are texts: nothing that comes from a scene is ever read as markup.

export const byId = id => document.getElementById(id);

/// element('button', { class: 'x', onclick: f, 'aria-label': 'y' }, 'text', child, ...)
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else if (typeof value === 'boolean') made.toggleAttribute(name, value);
    else if (value !== null && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children.filter(c => c !== null && c !== undefined));
  return made;
}

export const number = (x, digits = 4) => (Number.isFinite(x) ? String(Number(x.toPrecision(digits))) : '–');

/// 35 ms, or 1.2 s
export const duration = seconds => (seconds < 1 ? `${number(1000 * seconds, 2)} ms` : `${number(seconds, 3)} s`);

/// 12,345
export const grouped = x => Math.round(x).toLocaleString('en-US');

/// Puts a text there if it is another: whatever is put is laid out anew.
export function say(id, text) {
  const place = byId(id);
  if (place.textContent !== text) place.textContent = text;
}

/// As a power of ten where it is large.
export function magnificationText(x) {
  if (x < 1e5) return number(x, x < 100 ? 3 : 4);
  const exponent = Math.floor(Math.log10(x));
  return `${(x / 10 ** exponent).toFixed(1)}·10${String(exponent).replace(/\d/g, d => '⁰¹²³⁴⁵⁶⁷⁸⁹'[d])}`;
}

/// Maps with what repeats said once: 2 1 1 1 1 1 is 2 1(5).
export function shortWord(maps) {
  const runs = [];
  for (const map of maps) {
    if (runs.at(-1)?.map === map) ++runs.at(-1).count;
    else runs.push({ map, count: 1 });
  }
  return runs.map(({ map, count }) => (count > 3 ? `${map}(${count})` : Array(count).fill(map).join(' '))).join(' ');
}

let fading;
/// Of the kind 'wait' it stays until there is another.
export function toast(text, kind = '') {
  const place = byId('toast');
  place.textContent = text;
  place.className = `toast shown ${kind}`;
  clearTimeout(fading);
  if (kind !== 'wait') fading = setTimeout(() => place.classList.remove('shown'), kind === 'bad' ? 6000 : 3000);
}
