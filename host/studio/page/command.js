// The command line whose picture is the one that is shown, to the byte.

const word = text => (/^[\w./=,+@%:-]+$/.test(text) ? text : `'${text.replace(/'/g, `'\\''`)}'`);

/// `shown`: {name, text, settings, samples, machine, frame, columns, rows}.
export function commandOf(shown) {
  const words = ['pxm render', word(shown.name), `--size ${shown.columns}x${shown.rows}`];
  if (shown.machine) words.push(`--machine ${word(shown.machine)}`);
  if (shown.samples > 0) words.push(`--samples ${shown.samples}`);
  if (/\binclude\s*:|\bfile\s*:/.test(shown.text)) words.push('--allow .');
  if (shown.frame > 0) words.push(`--frames ${shown.frame}`);
  for (const setting of shown.settings) words.push(`--set ${word(setting)}`);
  words.push(`-o ${word(shown.name.replace(/^.*\//, '').replace(/\.pxm$/, '.png'))}`);
  return words.join(' ');
}
