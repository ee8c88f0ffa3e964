// Which system, map and field a mistake is of, whose line and column the program names.

const placeIn = (text, line, column) => text.split('\n').slice(0, line - 1).reduce((sum, l) => sum + l.length + 1, 0) + column - 1;
const holds = (place, { start, end }) => start <= place && place <= end;

/// The map that the words name, or in whose part of the block the place is; -1 if none.
function mapOf(block, place, message) {
  const named = /\bmap "?([A-Za-z_]\w*|\d+)/.exec(message)?.[1];
  const index = block.maps.findIndex((map, i) => named !== undefined && (map.name || String(i + 1)) === named);
  return index >= 0 ? index : block.maps.findLastIndex(map => map.start <= place);
}

/// { ifs, map, step, arg, word, message }: `step` counts among `steps(map)`, and `arg` in it; each -1 if
/// only what it stands in is known. Null for what is wrong elsewhere.
export function mistakePlace(text, outline, steps, { line, column, message }) {
  const place = placeIn(text, line, column);
  const ifs = outline.ifs.findIndex(block => block.start <= place && place <= block.close);
  const map = ifs < 0 ? -1 : mapOf(outline.ifs[ifs], place, message);
  if (map < 0) return null;
  const one = outline.ifs[ifs].maps[map];
  const word = one.directives.find(d => message.includes(`'${d.word}'`) || holds(place, d))?.word ?? '';
  const step = steps(one).findIndex(s => holds(place, s) || message.includes(`('${s.word}' `));
  const arg = step < 0 ? -1 : steps(one)[step].args.findIndex(a => holds(place, a));
  return { ifs, map, step, arg, word, message };
}
