// The case, what ran it, and how to run it again.
import { download, element, section } from "./dom.js";

const UNKNOWN = "unknown";

/** Shell words that run the case again with the same program. */
export function commands(run) {
  const { git_hash: hash, program_version: version } = run.summary.file;
  const stem = run.name.replace(/\.h5$/, "").replace(/[^\w.-]/g, "_") || "run";
  const isDirty = hash.endsWith("-dirty");
  const checkout =
    hash === UNKNOWN || hash === ""
      ? [`# zenosphere ${version}`]
      : [
          `git checkout ${hash.replace(/-dirty$/, "")}${isDirty ? "   # and changes that were not committed" : ""}`,
          "scripts/build",
        ];
  return [...checkout, `build/zenosphere run ${stem}.toml -o ${stem}.h5`].join("\n");
}

export function caseSection(run) {
  const { program_version: version, git_hash: hash } = run.summary.file;
  const stem = run.name.replace(/\.h5$/, "");
  return section(
    "case",
    "The case, and how to run it again",
    element(
      "p",
      {},
      `Made by zenosphere ${version} (${hash}), compiled by ${run.compiler}. Save the case as `,
      download(run.resolved_case, `${stem}.toml`, `${stem}.toml`),
      "; the same program gives the same bits on every x86-64 machine.",
    ),
    element("pre", { class: "commands", tabindex: "0" }, commands(run)),
    element(
      "details",
      { open: true },
      element("summary", {}, "Resolved case: every key with the value used"),
      element("pre", { tabindex: "0" }, run.resolved_case),
    ),
    element(
      "details",
      {},
      element("summary", {}, "Case file as it was written"),
      element("pre", { tabindex: "0" }, run.case_text),
    ),
    element(
      "details",
      {},
      element("summary", {}, "Compiler flags"),
      element("pre", { tabindex: "0" }, run.compiler_flags),
    ),
  );
}

export const licencesSection = () =>
  element(
    "footer",
    {},
    element(
      "details",
      {},
      element("summary", {}, "This page uses three.js and uPlot; their licences"),
      element("pre", {}, document.getElementById("licences").textContent),
    ),
  );
