// How numbers are written.

const SPACE = "\u202f"; // narrow, no break
const MINUS = "\u2212";
const RAISED = {
  "-": "\u207b",
  0: "\u2070",
  1: "\u00b9",
  2: "\u00b2",
  3: "\u00b3",
  4: "\u2074",
  5: "\u2075",
  6: "\u2076",
  7: "\u2077",
  8: "\u2078",
  9: "\u2079",
};

export const DASH = "\u2013";

/** 12345678 as 12 345 678. */
export const grouped = (number) => String(Math.round(number)).replace(/\B(?=(\d{3})+$)/g, SPACE);

/** An exponent as 10 with raised digits. */
export const power = (exponent) =>
  `10${[...String(exponent)].map((digit) => RAISED[digit]).join("")}`;

/** A real number in at most `digits` significant digits; a dash where there is none. */
export function short(number, digits = 4) {
  if (number === null || number === undefined || Number.isNaN(number)) return DASH;
  if (number === 0) return "0";
  const size = Math.abs(number);
  if (size >= 1e-3 && size < 1e6)
    return String(Number(number.toPrecision(digits))).replace("-", MINUS);
  const [mantissa, exponent] = number.toExponential(digits - 1).split("e");
  const factor = String(Number(mantissa)).replace("-", MINUS);
  return factor === "1" ? power(Number(exponent)) : `${factor}\u00b7${power(Number(exponent))}`;
}

/**
 * A number with its standard error as physicists write it: 1.139(2) is 1.139 +- 0.002.
 *
 * The error has one digit, or two where the first is a 1; where none is known it is left out.
 */
export function uncertain(value, error) {
  if (typeof value !== "number" || !(error > 0) || !Number.isFinite(error)) return short(value, 5);
  const first = Math.floor(Math.log10(error));
  const place = error / 10 ** first < 1.95 ? first - 1 : first;
  const exponent = Math.floor(Math.log10(Math.max(Math.abs(value), error)));
  const shift = exponent >= -4 && exponent < 6 && place <= 0 ? 0 : exponent;
  const decimals = Math.max(shift - place, 0);
  const units = Math.round(error / 10 ** (shift - decimals));
  const digits = (value / 10 ** shift).toFixed(decimals).replace("-", MINUS);
  return `${digits}(${units})${shift ? `\u00b7${power(shift)}` : ""}`;
}

/** A pair as 1–2; beyond the spheres are the walls. */
export function pairName([i, j], spheres) {
  if (j < spheres) return `${i}${DASH}${j}`;
  return `${i}${DASH}${j === spheres ? "lower" : "upper"} wall`;
}

/** "1 sphere", "2 spheres". */
export const count = (number, word) => `${grouped(number)} ${word}${number === 1 ? "" : "s"}`;
