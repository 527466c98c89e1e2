// Numbers as text.

const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** Every digit that the double needs, with a true minus sign. */
export function exact(value) {
  return Number.isNaN(value) ? "not a number" : String(value).replaceAll("-", "−");
}

/** For the marks of an axis. */
export function brief(value) {
  return exact(Number(value.toPrecision(6)));
}

/** 10⁻⁸ for 1e-8; nothing for what is no power of ten. */
export function powerOfTen(value) {
  const exponent = Math.round(Math.log10(value));
  if (Math.abs(value / 10 ** exponent - 1) > 1e-9) return null;
  const digits = [...String(Math.abs(exponent))].map((digit) => superscripts[digit]).join("");
  return `10${exponent < 0 ? "⁻" : ""}${digits}`;
}

/** `time` with as many digits as tell the rows of a motion of that length apart. */
export function clockText(time, span) {
  const digits = Math.min(Math.max(3 - Math.floor(Math.log10(span || 1)), 0), 12);
  return time.toFixed(digits).replace("-", "−");
}
