// What the tests share: runs, their pages, and a browser to open them with.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

const CHECKOUT = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const PROGRAM = process.env.ZENOSPHERE ?? join(CHECKOUT, "build", "zenosphere");
const MODULES = process.env.PAGE_FOLDER ?? join(CHECKOUT, "build", "page");
const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";

/** A folder with runs and pages, gone after `remove`. */
export class Workshop {
  folder = mkdtempSync(join(tmpdir(), "zenosphere-page-"));

  remove() {
    rmSync(this.folder, { recursive: true });
  }

  zenosphere(...words) {
    return execFileSync(PROGRAM, words, {
      cwd: this.folder,
      encoding: "utf8",
      stdio: ["ignore", "pipe", "inherit"],
    });
  }

  /** The page of a run of a case (text, or the name of an example) with some keys changed. */
  page(name, source, changes = {}) {
    const text = source.includes("\n");
    const file = text
      ? join(this.folder, "case.toml")
      : join(CHECKOUT, "examples", `${source}.toml`);
    if (text) writeFileSync(file, source);
    const words = Object.entries(changes).flatMap(([key, value]) => ["--set", `${key}=${value}`]);
    this.zenosphere("run", file, "-o", `${name}.h5`, "--quiet", ...words);
    this.zenosphere("report", `${name}.h5`, "-o", `${name}.html`);
    return join(this.folder, `${name}.html`);
  }
}

/** Debian's Chromium without a screen, drawing 3-D on the processor. */
export async function startedBrowser() {
  const { chromium } = createRequire(join(MODULES, "package.json"))("playwright-core");
  return chromium.launch({
    executablePath: CHROMIUM,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
}

/** A workshop with a `browser`, both for the tests of one file. */
export function equipped() {
  const workshop = new Workshop();
  before(async () => {
    workshop.browser = await startedBrowser();
  });
  after(async () => {
    await workshop.browser?.close();
    workshop.remove();
  });
  return workshop;
}

/** A page that is open and drawn; `problems` collects what it complains of, and what it asks of a network. */
export async function opened(browser, file) {
  const page = await browser.newPage({ viewport: { width: 1500, height: 1000 } });
  const problems = [];
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on(
    "request",
    (request) => /^(file|blob|data):/.test(request.url()) || problems.push(request.url()),
  );
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready);
  await drawn(page);
  return { page, problems };
}

/** Waits until what was asked for is on the screen. */
export const drawn = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );

/**
 * How many pixels of a canvas there are of each kind: "paper" (white or transparent), "green" (in
 * the middle of viridis), "red" (vermilion), "other"; and all of them as one text.
 */
export const pixels = (page, selector) =>
  page.locator(selector).evaluate((canvas) => {
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    const found = { paper: 0, green: 0, red: 0, other: 0, text: "" };
    let sum = 0;
    for (let n = 0; n < data.length; n += 4) {
      const [r, g, b, opaque] = data.subarray(n, n + 4);
      const kind =
        opaque === 0 || (r > 250 && g > 250 && b > 250)
          ? "paper"
          : g > r + 25 && g > b + 15
            ? "green"
            : r > g + 60 && r > b + 60
              ? "red"
              : "other";
      ++found[kind];
      sum = (sum * 31 + r + 7 * g + 49 * b) % 1000000007;
    }
    found.text = String(sum);
    return found;
  });

/** Pixels by which a page is wider than its window. */
export const excess = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

/** The bytes that a way ("png", "svg", "csv") to save a part of a page gives, and their name. */
export async function saved(page, part, way) {
  await page.locator(`${part} .save summary`).click();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.locator(`${part} .save .${way}`).click(),
  ]);
  await page.keyboard.press("Escape");
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** Width and height of a PNG. */
export function sizeOfPng(bytes) {
  assert.equal(bytes.toString("latin1", 1, 4), "PNG");
  return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
}

/** Nothing was complained of, and nothing asked of a network. */
export const assertQuiet = (problems) => assert.deepEqual(problems, []);
