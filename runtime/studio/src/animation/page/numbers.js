// Numbers as text.

const MINUS = "\u2212";

/// A number with so many significant digits.
function digits(x, count = 5) {
  if (Number.isNaN(x)) return "–";
  if (!Number.isFinite(x)) return x > 0 ? "∞" : `${MINUS}∞`;
  const size = Math.abs(x);
  const plain = size === 0 || (size >= 1e-3 && size < 1e6);
  const text = plain ? x.toPrecision(count) : x.toExponential(count - 1);
  return text.replace("e+", "e").replaceAll("-", MINUS);
}

/// The nearest of 1, 2 and 5 times a power of ten above x.
function round125(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return [1, 2, 5, 10].find((k) => k * power >= x * (1 - 1e-9)) * power;
}

/// About `count` round numbers between low and high, with their texts.
function ticks(low, high, count) {
  const step = round125((high - low) / count);
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  const exponent = Math.floor(Math.log10(Math.max(Math.abs(low), Math.abs(high))));
  const text = exponent < -3 || exponent > 5
    ? (x) => x.toExponential(Math.max(0, exponent - Math.floor(Math.log10(step) + 1e-9))).replace("e+", "e")
    : (x) => x.toFixed(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  const all = [];
  for (let i = first; i <= last; i += 1) {
    const x = i === 0 ? 0 : i * step;
    all.push({ x, text: (x === 0 ? "0" : text(x)).replaceAll("-", MINUS) });
  }
  return all;
}

/// A time with digits enough to tell it from its neighbours.
const timeText = (t) => {
  const places = Math.max(0, 5 - Math.ceil(Math.log10(Math.max(tEnd - tStart, 1e-12))));
  return t.toFixed(Math.min(places, 12)).replaceAll("-", MINUS);
};
