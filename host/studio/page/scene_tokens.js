// A scene's text as tokens with their places, and as blocks, maps and steps (docs/scene-language.md).
// The page edits places of the text, so that comments and layout stay; what is right and what is wrong
// the program says.

const pattern = /(?<blank>[ \t\r\n]+)|(?<comment>#[^\n]*)|(?<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?<word>[A-Za-z_]\w*)|(?<string>"[^"\r\n]*"?)|(?<arrow>->)|(?<symbol>[^])/gy;

export const blockWords = new Set(['ifs', 'rifs', 'object', 'plane', 'texture', 'light', 'camera', 'image', 'render', 'animation', 'let', 'include']);
export const numberWords = new Set(['pi', 'phi', 'sqrt', 'sin', 'cos', 'tan', 'key']);
/// Steps that a map is made of.
export const stepWords = ['scale', 'rotate', 'translate', 'matrix', 'tetrahedron', 'blend'];

/// All tokens, comments and blanks too: what one paints.
export function tokensOf(text) {
  const tokens = [];
  for (const match of text.matchAll(pattern)) {
    const kind = Object.keys(match.groups).find(name => match.groups[name] !== undefined);
    tokens.push({ kind, text: match[0], start: match.index, end: match.index + match[0].length });
  }
  return tokens;
}

/// Reads on from one token to the next.
class Reader {
  constructor(text) {
    this.text = text;
    this.tokens = tokensOf(text).filter(t => t.kind !== 'blank' && t.kind !== 'comment');
    this.at = 0;
  }
  get next() { return this.tokens[this.at]; }
  is(text, ahead = 0) { return this.tokens[this.at + ahead]?.text === text; }
  take() { return this.tokens[this.at++]; }
  get done() { return this.at >= this.tokens.length; }
  /// The start of something at the top of the file: such words are directives where a colon follows.
  startsBlock() {
    return blockWords.has(this.next.text) && (!this.is(':', 1) || this.next.text === 'include');
  }
  /// Up to where `stop()` holds outside of all parentheses; the tokens that were passed.
  until(stop) {
    const passed = [];
    for (let depth = 0; !this.done && !(depth === 0 && stop());) {
      const token = this.take();
      depth += token.text === '(' ? 1 : token.text === ')' ? -1 : 0;
      passed.push(token);
    }
    return passed;
  }
}

const span = (tokens, at) => ({ start: tokens[0]?.start ?? at, end: tokens.at(-1)?.end ?? at });

/// Values with commas between them.
function argumentsOf(tokens, text) {
  const lists = [[]];
  let depth = 0;
  for (const token of tokens) {
    depth += token.text === '(' ? 1 : token.text === ')' ? -1 : 0;
    if (token.text === ',' && depth === 0) lists.push([]);
    else lists.at(-1).push(token);
  }
  return lists.filter(list => list.length > 0).map(list => {
    const { start, end } = span(list);
    return { start, end, text: text.slice(start, end) };
  });
}

function directive(reader) {
  const word = reader.take();
  const colon = reader.is(':') ? reader.take() : word;
  const values = reader.until(() => reader.is('}') || reader.is('newmap') ||
    (reader.next.kind === 'word' && reader.is(':', 1)));
  return { word: word.text, start: word.start, end: values.at(-1)?.end ?? colon.end,
    values: span(values, colon.end), args: argumentsOf(values, reader.text) };
}

function ifsBody(reader, block) {
  let map = null;
  while (!reader.done && !reader.is('}')) {
    if (reader.is('newmap')) {
      const word = reader.take();
      const name = reader.next?.kind === 'word' && !reader.is(':', 1) && !reader.is('newmap') ? reader.take() : null;
      map = { name: name?.text ?? '', start: word.start, head: (name ?? word).end, end: (name ?? word).end, directives: [] };
      block.maps.push(map);
    } else if (reader.next.kind === 'word') {
      const one = directive(reader);
      if (['follow', 'start'].includes(one.word)) block.rules.push(one);
      else if (map) { map.directives.push(one); map.end = one.end; }
    } else reader.take();
  }
}

/// { ifs: [{name, maps: [{name, directives: [{word, args}]}], rules}], lets: [[name, text]] }, each with
/// its place. A text with mistakes gives what can be found.
export function outlineOf(text) {
  const reader = new Reader(text);
  const outline = { ifs: [], lets: [], blocks: [] };
  while (!reader.done) {
    const first = reader.take();
    if (first.text === 'let') {
      const name = reader.take();
      if (reader.is('=')) reader.take();
      const { start, end } = span(reader.until(() => reader.startsBlock()));
      if (name && start !== undefined) outline.lets.push([name.text, text.slice(start, end)]);
    } else if (blockWords.has(first.text) && first.text !== 'include') {
      const name = reader.next?.kind === 'word' ? reader.take().text : '';
      if (!reader.is('{')) continue;
      const open = reader.take();
      const block = { kind: first.text, name, start: first.start, open: open.end, maps: [], rules: [] };
      if (['ifs', 'rifs'].includes(first.text)) { ifsBody(reader, block); outline.ifs.push(block); }
      else reader.until(() => reader.is('}'));
      block.close = reader.next?.start ?? text.length;
      block.end = reader.take()?.end ?? text.length;
      outline.blocks.push(block);
    }
  }
  return outline;
}

/// The number that an expression stands for; NaN if it depends on more than `lets`.
export function valueOf(expression, lets = new Map()) {
  const tokens = tokensOf(expression).filter(t => t.kind !== 'blank' && t.kind !== 'comment');
  let at = 0;
  const is = text => tokens[at]?.text === text;
  const radians = x => x * Math.PI / 180;
  const functions = { sqrt: Math.sqrt, sin: x => Math.sin(radians(x)), cos: x => Math.cos(radians(x)), tan: x => Math.tan(radians(x)) };
  const factor = () => {
    const token = tokens[at++];
    if (!token) return NaN;
    if (token.text === '-') return -factor();
    if (token.text === '+') return factor();
    if (token.text === '(') { const x = sum(); return tokens[at++]?.text === ')' ? x : NaN; }
    if (token.kind === 'number') return Number(token.text);
    if (lets.has(token.text)) return lets.get(token.text);
    if (functions[token.text]) return is('(') ? functions[token.text](factor()) : NaN;
    return { pi: Math.PI, phi: (1 + Math.sqrt(5)) / 2 }[token.text] ?? NaN;
  };
  const product = () => {
    let x = factor();
    while (is('*') || is('/')) x = tokens[at++].text === '*' ? x * factor() : x / factor();
    return x;
  };
  const sum = () => {
    let x = product();
    while (is('+') || is('-')) x = tokens[at++].text === '+' ? x + product() : x - product();
    return x;
  };
  const x = sum();
  return at === tokens.length ? x : NaN;
}

/// The numbers that `let`s stand for.
export function letsOf(outline) {
  const lets = new Map();
  for (const [name, text] of outline.lets) lets.set(name, valueOf(text, lets));
  return lets;
}
