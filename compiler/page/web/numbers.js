// Numbers as text.

const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** 10⁻⁸ for −8. */
function power(exponent) {
  const digits = [...String(Math.abs(exponent))].map((digit) => superscripts[digit]).join("");
  return `10${exponent < 0 ? "⁻" : ""}${digits}`;
}

/** Every digit that the double needs, with a true minus sign. */
export function exact(value) {
  if (Number.isNaN(value)) return "not a number";
  const size = Math.abs(value);
  const plain = size === 0 || (size >= 1e-3 && size < 1e9) || !Number.isFinite(size);
  const [digits, exponent] = (plain ? String(value) : value.toExponential()).split("e");
  return digits.replace("-", "−") + (exponent ? `·${power(Number(exponent))}` : "");
}

/** For a mark of an axis whose marks are `step` apart: without the rounding of value = n step. */
export function brief(value, step) {
  const digits = Math.ceil(Math.log10(Math.abs(value / step) || 1)) + 3;
  return exact(Number(value.toPrecision(Math.min(Math.max(digits, 3), 15))));
}

/** 10⁻⁸ for 1e-8. */
export function powerOfTen(value) {
  return power(Math.round(Math.log10(value)));
}

/** `time` with as many digits as tell the rows of a motion of that length apart. */
export function clockText(time, span) {
  const digits = Math.min(Math.max(3 - Math.floor(Math.log10(span || 1)), 0), 12);
  return time.toFixed(digits).replace("-", "−");
}
