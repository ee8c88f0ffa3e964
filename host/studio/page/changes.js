// What differs between two texts, in words.

const most = 60;  // characters of a piece of text
const brief = text => { const words = text.trim().replace(/\s+/g, ' '); return words.length > most ? `${words.slice(0, most)} …` : words; };

/// { line, was, is }: the first line that differs, and the pieces that do, with the words they belong to.
export function changeBetween(before, after) {
  const least = Math.min(before.length, after.length);
  let start = 0, end = 0;
  while (start < least && before[start] === after[start]) ++start;
  while (end < least - start && before[before.length - 1 - end] === after[after.length - 1 - end]) ++end;
  const shared = before.slice(0, start), rest = before.slice(before.length - end);
  const piece = text => text.slice(start, text.length - end);
  const pieces = [piece(before), piece(after)];
  if (pieces.some(text => /^\S/.test(text))) start -= /(?:\w+:[ \t]*)?\S*$/.exec(shared)[0].length;
  if (pieces.some(text => /\S$/.test(text))) end -= /^\S*/.exec(rest)[0].length;
  const blanks = Math.min(...[before, after].map(text => /^\s*/.exec(piece(text))[0].length));
  return { line: before.slice(0, start + blanks).split('\n').length, was: brief(piece(before)), is: brief(piece(after)) };
}

/// Undone in line 3: scale: 0.6 instead of scale: 0.85.
export function told(what, before, after) {
  const { line, was, is } = changeBetween(before, after);
  if (was === is) return `${what} in line ${line}: blanks.`;
  return `${what} in line ${line}: ${is === '' ? `${was} is gone` : was === '' ? `${is} is there` : `${is} instead of ${was}`}.`;
}
