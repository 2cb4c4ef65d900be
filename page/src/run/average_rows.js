// What a page shows of averages and of their series: rows of a table, and curves.
import { uncertain } from "../shared/format.js";

const AXES = "xyz";

/** Of the n-th axis. */
export const axisName = (n) => AXES[n];
const pairOfAxes = (n, dimension) => AXES[Math.floor(n / dimension)] + AXES[n % dimension];

/** What is shown of the averages: [key, symbol, unit, name of a component]. */
const ROWS = [
  ["granular_temperature", "granular temperature T", "(diameter/time)\u00b2"],
  ["temperature_diagonal", "component T", "(diameter/time)\u00b2", axisName],
  ["temperature_without_streak", "T without the streak", "(diameter/time)\u00b2"],
  ["streak_amplitude", "strongest streak", "diameter/time"],
  ["pressure", "pressure p", ""],
  ["pressure_tensor", "pressure tensor P", "", pairOfAxes],
  ["normal_stress_differences", "normal stress differences N", "of p", (n) => String(n + 1)],
  ["compressibility_factor", "compressibility factor", ""],
  ["collision_rate", "collision rate", "per sphere and time"],
  ["normal_speed", "normal speed of the collisions", "diameter/time"],
  ["dissipation", "dissipation", "per volume and time"],
  ["sonine_a2", "Sonine coefficient a\u2082", ""],
  ["rotational_temperature", "rotational temperature", ""],
];

/** Rows of the table: [[name, value with its error, unit], ...]. */
export function averageRows(averages, dimension) {
  const errors = averages.standard_error ?? {};
  return ROWS.flatMap(([key, name, unit, component]) => {
    if (averages[key] === null || averages[key] === undefined) return [];
    if (!component) return [[name, uncertain(averages[key], errors[key]), unit]];
    const values = averages[key].flat(),
      known = errors[key]?.flat() ?? [];
    return values.map((value, n) => [
      `${name}_${component(n, dimension)}`,
      uncertain(value, known[n]),
      unit,
    ]);
  });
}

/** The curves of a plot that a series has: [{name, values}, ...]. */
export function curvesOf(series, wanted) {
  const rows = series.time.length;
  return wanted.flatMap(([key, component, name]) => {
    const column = series.columns[key];
    if (!column) return [];
    const width = column.length / rows;
    if ((component ?? 0) >= width) return [];
    return [{ name, values: series.time.map((_, n) => column[n * width + (component ?? 0)]) }];
  });
}
