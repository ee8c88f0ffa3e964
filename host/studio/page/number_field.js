// Fields of one number, or of one expression: what they take, and that one types over the whole of it.
import { toast } from './elements.js';
import { tokensOf } from './scene_tokens.js';

const symbols = '+-*/(),';

/// What stands in the text for what was typed; null if that is not one value. A decimal comma is a point.
export function oneValue(typed) {
  const text = typed.trim().replaceAll('−', '-').replace(/^([+-]?\d*),(\d*)$/, (all, whole, part) => (part ? `${whole}.${part}` : whole));
  let depth = 0;
  for (const { kind, text: word } of tokensOf(text)) {
    if (!['blank', 'number', 'word'].includes(kind) && !(kind === 'symbol' && symbols.includes(word))) return null;
    depth += { '(': 1, ')': -1 }[word] ?? 0;
    if (depth < 0 || (word === ',' && depth === 0)) return null;
  }
  return text !== '' && depth === 0 ? text : null;
}

export const oneAxis = typed => (/^[xyz]$/i.test(typed.trim()) ? typed.trim().toLowerCase() : null);

/// With focus, and with a double click, the whole is selected: a minus sign, too.
function selectsWhole(field) {
  let fresh = false;
  field.addEventListener('focus', () => field.select());
  field.addEventListener('pointerdown', () => { fresh = document.activeElement !== field; });
  field.addEventListener('click', () => { if (fresh && field.selectionStart === field.selectionEnd) field.select(); fresh = false; });
  field.addEventListener('dblclick', () => field.select());
}

/// `put(value)` is called with what `read` makes of what is typed. What it refuses is not put; once the
/// field is left, it shows `now()`.
export function takesOne(field, read, put, now) {
  let refused = false;
  selectsWhole(field);
  field.addEventListener('input', () => {
    const value = read(field.value);
    field.removeAttribute('aria-invalid');
    refused = value === null && field.value.trim() !== '';
    if (value !== null) put(value);
    else if (refused) field.setAttribute('aria-invalid', 'true');
  });
  field.addEventListener('blur', () => {
    if (refused) toast(`“${field.value}” is not ${read === oneAxis ? 'x, y or z' : 'one number'}: nothing was changed.`, 'bad');
    if (refused) field.removeAttribute('aria-invalid');
    refused = false;
    field.value = now() ?? field.value;
  });
  return field;
}
