// Bundles the report page into one HTML file: node build.mjs NPM FOLDER
//
// Libraries are installed in FOLDER, as package-lock.json names them, and FOLDER/page.html is made.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readFileSync,
  utimesSync,
  writeFileSync,
} from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [npm, folder] = process.argv.slice(2);
const here = import.meta.dirname ?? new URL(".", import.meta.url).pathname;
const modules = join(folder, "node_modules");

/** Installs the libraries unless those of this lock file are there already. */
function install() {
  const lock = readFileSync(join(here, "package-lock.json"), "utf8");
  const installed = join(folder, "installed-lock.json");
  if (existsSync(installed) && readFileSync(installed, "utf8") === lock) return;
  mkdirSync(folder, { recursive: true });
  for (const name of ["package.json", "package-lock.json", ".npmrc"]) {
    copyFileSync(join(here, name), join(folder, name));
  }
  try {
    execFileSync(npm, ["ci", "--ignore-scripts", "--loglevel=error"], {
      cwd: folder,
      stdio: ["ignore", "ignore", "inherit"],
    });
  } catch {
    console.error(
      "WARNING: npm could not install what page/package-lock.json names (no network, no" +
        " registry?); the program is built without the page of zenosphere report",
    );
    writeFileSync(join(folder, "page.html"), "");
    utimesSync(join(folder, "page.html"), 0, 0); // so old that the next build tries again
    process.exit(0);
  }
  writeFileSync(installed, lock);
}

/** Minified text of one entry point and all it imports. */
async function bundled(entry) {
  const esbuild = createRequire(join(folder, "package.json"))("esbuild");
  const result = await esbuild.build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2022",
    nodePaths: [modules],
    legalComments: "none",
    charset: "utf8",
    logLevel: "warning",
  });
  return result.outputFiles[0].text.trim();
}

/** The licences of what is in the bundle, as they came with it; page/licences.txt is to say the same. */
function licences() {
  return ["three", "uplot"]
    .map((name) => {
      const { version } = JSON.parse(readFileSync(join(modules, name, "package.json"), "utf8"));
      return `${name} ${version}\n\n${readFileSync(join(modules, name, "LICENSE"), "utf8").trim()}`;
    })
    .join("\n\n\n");
}

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

install();
const script = await bundled("main.js");
const style = await bundled("style.css");
// Nothing but this program and this style may act in the page, whatever a run's file says.
const policy =
  `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)};` +
  " img-src data: blob:";
const page = readFileSync(join(here, "src", "page.html"), "utf8")
  .replace("@POLICY@", () => policy)
  .replace("@STYLE@", () => style)
  .replace("@LICENCES@", () => licences())
  .replace("@SCRIPT@", () => script);
writeFileSync(join(folder, "page.html"), page);
