// Colours that are told apart with every kind of colour vision.

/** Okabe & Ito's palette. */
export const INK = "#1b2a41",
  VERMILION = "#d55e00",
  BLUE = "#0072b2",
  SKY = "#56b4e9",
  GREEN = "#009e73",
  GREY = "#8a93a0";

// Viridis (Smith & van der Walt 2015) at tenths: lightness rises evenly, also in grey print.
const VIRIDIS = [
  0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c, 0x22a884, 0x44bf70, 0x7ad151,
  0xbddf26, 0xfde725,
];

/** Red, green and blue in [0, 1] of a value in [0, 1]. */
export function viridis(value) {
  const place = Math.min(Math.max(value, 0), 1) * (VIRIDIS.length - 1);
  const below = Math.min(Math.floor(place), VIRIDIS.length - 2);
  const part = place - below;
  return [16, 8, 0].map((shift) => {
    const [low, high] = [VIRIDIS[below], VIRIDIS[below + 1]].map((hex) => (hex >> shift) & 255);
    return (low + (high - low) * part) / 255;
  });
}

/** The same as a CSS colour. */
export const viridisCss = (value) =>
  `rgb(${viridis(value)
    .map((part) => Math.round(part * 255))
    .join(" ")})`;

/** Red, green and blue in [0, 1] of "#rrggbb". */
export const rgb = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
