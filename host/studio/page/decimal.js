// Numbers with 70 decimals, as whole multiples of 10^-70: a camera that has flown to 10^30 stands at
// a place that no double can say.

export const places = 70;
export const one = 10n ** BigInt(places);

/// Of a decimal text, with or without an exponent.
export function fromText(text) {
  const match = /^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/.exec(text.trim());
  if (!match || match[2] + match[3] === '') return 0n;
  const digits = BigInt(match[2] + match[3]);
  const shift = places - match[3].length + Number(match[4] ?? 0);
  const size = shift >= 0 ? digits * 10n ** BigInt(shift) : digits / 10n ** BigInt(-shift);
  return match[1] === '-' ? -size : size;
}

export const fromNumber = x => (Number.isFinite(x) ? fromText(x.toExponential(17)) : 0n);

export function toNumber(x) {
  if (x === 0n) return 0;
  const digits = (x < 0n ? -x : x).toString();
  const size = Number(`${digits.slice(0, 18)}e${digits.length - Math.min(18, digits.length) - places}`);
  return x < 0n ? -size : size;
}

/// Without an exponent, and no more zeros than it takes.
export function toText(x) {
  const digits = (x < 0n ? -x : x).toString().padStart(places + 1, '0');
  const fraction = digits.slice(-places).replace(/0+$/, '');
  const text = digits.slice(0, -places) + (fraction ? `.${fraction}` : '');
  return x < 0n && text !== '0' ? `-${text}` : text;
}

/// Times a number; what is lost is in the 17th digit of the product.
export function times(x, factor) {
  const scale = 10n ** 17n;
  const exponent = factor === 0 ? 0 : Math.floor(Math.log10(Math.abs(factor)));
  const whole = BigInt(Math.round(factor / 10 ** exponent * 1e15)) * 100n;
  const product = x * whole / scale;
  return exponent >= 0 ? product * 10n ** BigInt(exponent) : product / 10n ** BigInt(-exponent);
}
