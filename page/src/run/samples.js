// What a run has accumulated while it went on: radial distribution, velocities, profiles.
import { curvePlot } from "../plots/curve_plot.js";
import { element, section } from "../shared/dom.js";
import { grouped, short } from "../shared/format.js";

/** The section, or nothing where a run has accumulated nothing. */
export function samplesSection(run) {
  const { samples } = run;
  if (!samples) return [];
  const plots = [...radial(run, samples), ...velocities(run, samples), ...profiles(run, samples)];
  if (!plots.length) return [];
  return [
    section(
      "samples",
      "Structure and velocities",
      element(
        "p",
        { class: "hint" },
        `Of ${grouped(samples.samples)} samples, time ${short(samples.from_time, 6)} to ` +
          `${short(samples.to_time, 6)}. zenosphere analyse tells them with their errors, and more.`,
      ),
      ...plots,
    ),
  ];
}

function radial(run, { radial_distribution: found }) {
  if (!found) return [];
  return [
    curvePlot({
      id: "samples-radial",
      title: "Radial distribution g(r)",
      run,
      stem: ["radial-distribution"],
      scale: "from zero",
      x: { label: "Distance r (diameters)", name: "r", values: found.r },
      curves: [{ name: "g(r)", values: found.g }],
    }),
  ];
}

function velocities(run, { velocity_distribution: found }) {
  if (!found) return [];
  return [
    curvePlot({
      id: "samples-velocities",
      title: "Distribution of a velocity component",
      run,
      stem: ["velocity-distribution"],
      scale: "logarithmic",
      x: { label: "Velocity over \u221a(T/m)", name: "v", values: found.component },
      curves: [
        { name: "measured", values: found.density.map((each) => each || null) },
        { name: "Maxwell", values: found.maxwell },
      ],
    }),
  ];
}

const PROFILES = [
  ["solids_volume_fraction", "fraction", "Solids volume fraction", "from zero"],
  ["velocity", "velocity", "Velocity along x (diameters/time)"],
  [
    "granular_temperature",
    "temperature",
    "Granular temperature (diameter\u00b2/time\u00b2)",
    "from zero",
  ],
];

function profiles(run, { profiles: found }) {
  if (!found || found.y.length < 3) return [];
  return PROFILES.map(([key, id, title, scale]) =>
    curvePlot({
      id: `samples-${id}`,
      title: `${title} against ${found.axis}`,
      run,
      stem: ["profile", id],
      scale,
      x: { label: `Place ${found.axis} (diameters)`, name: found.axis, values: found.y },
      curves: [{ name: title.split(" (")[0].toLowerCase(), values: found[key] }],
    }),
  );
}
