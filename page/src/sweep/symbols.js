// Short names of a case's keys, as in the figures of the Python package.

const NAMES = {
  "system.restitution": ["e", "Restitution e"],
  "system.solids_volume_fraction": ["\u03c6", "Solids volume fraction \u03c6"],
  "system.spheres": ["N", "Number of spheres N"],
  "drive.shear_rate": ["\u03b3\u0307", "Shear rate \u03b3\u0307"],
};

/** Its symbol, or its last word. */
export const symbol = (key) => NAMES[key]?.[0] ?? key.split(".").at(-1).replaceAll("_", " ");

/** Its name on an axis. */
export const axisName = (key) => NAMES[key]?.[1] ?? key;
