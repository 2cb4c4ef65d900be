// The page of a sweep in a real browser.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import {
  assertQuiet,
  drawn,
  excess,
  opened,
  saved,
  sizeOfPng,
  startedBrowser,
  Workshop,
} from "./support.mjs";

const SWEEP = `[sweep]
seeds = 3
master_seed = 1

[case.system]
dimension = 2
spheres = 25
[case.start]
arrangement = "random"
granular_temperature = 1
[case.drive]
kind = "shear"
shear_rate = 1
[case.collapse]
window = 200
[case.run]
collisions = 4000

[axes]
"system.restitution" = [0.1, 0.5, 0.9]
"system.solids_volume_fraction" = [0.1, 0.4]
"collision.overlap" = ["rewind", "guarded"]
`;

describe("the page of a sweep", () => {
  const workshop = new Workshop();
  let browser, page, problems;
  before(async () => {
    writeFileSync(join(workshop.folder, "s.toml"), SWEEP);
    workshop.zenosphere("sweep", "s.toml", "--quiet", "--threads", "1");
    workshop.zenosphere("report", "s.sqlite", "-o", "s.html");
    browser = await startedBrowser();
    ({ page, problems } = await opened(browser, join(workshop.folder, "s.html")));
  });
  after(async () => {
    assertQuiet(problems);
    await browser?.close();
    workshop.remove();
  });

  const cells = (which) => page.locator(`#diagram-${which} [data-point]`);

  test("has four diagrams over two axes, and a choice for the third", async () => {
    for (const which of ["hit", "arrest", "left", "open"])
      assert.equal(await cells(which).count(), 6);
    assert.match(
      await cells("arrest").first().getAttribute("aria-label"),
      /^e = 0\.1, \u03c6 = 0\.1: \d of 3 runs, \d+ % \(95 %: \d+ % to \d+ %\)$/,
    );
    const before = await cells("hit").first().getAttribute("data-point");
    await page.selectOption("#axis-collision-overlap", "guarded");
    assert.notEqual(await cells("hit").first().getAttribute("data-point"), before);
    await page.selectOption("#axis-collision-overlap", "rewind");
  });

  test("axes have their symbols, and their keys in a title", async () => {
    const axis = page.locator("#diagram-hit .axis-name").first();
    assert.equal(await axis.locator("title").textContent(), "system.restitution");
    assert.match(await axis.textContent(), /Restitution e$/);
    const choice = page.locator("#axis-across option").first();
    assert.deepEqual(
      [await choice.textContent(), await choice.getAttribute("title")],
      ["e", "system.restitution"],
    );
    assert.match(
      await page.locator("header").textContent(),
      /e \(3\) \u00d7 \u03c6 \(2\) \u00d7 overlap \(2\)/,
    );
  });

  test("a diagram is saved as PNG, SVG and CSV", async () => {
    const csv = await saved(page, "#diagram-left", "csv");
    const [head, ...rows] = csv.bytes.toString().trim().split("\n");
    assert.equal(
      head,
      "system.restitution,system.solids_volume_fraction,collision.overlap,runs_with,runs,share,low,high",
    );
    assert.equal(rows.length, 6);
    assert.match(rows[0], /^0\.1,0\.1,rewind,\d,3,/);
    const svg = await saved(page, "#diagram-left", "svg");
    assert.equal(svg.name, "s-left.svg");
    assert.match(svg.bytes.toString(), /^<svg [\s\S]*hits, no arrest: left[\s\S]*fill="rgb\(/);
    const png = await saved(page, "#diagram-left", "png");
    assert.deepEqual(sizeOfPng(png.bytes), [3 * 470, 3 * 384]);
  });

  test("a narrow window is not scrolled sideways", async () => {
    await page.click("#diagram-arrest [data-point='0']");
    await page.setViewportSize({ width: 420, height: 900 });
    await drawn(page);
    assert.ok((await excess(page)) <= 0, `${await excess(page)}`);
    await page.setViewportSize({ width: 1500, height: 1000 });
    await drawn(page);
  });

  test("the axes can be exchanged", async () => {
    await page.selectOption("#axis-across", "collision.overlap");
    assert.equal(await cells("hit").count(), 4);
    assert.equal(await page.locator("#axis-system-restitution").count(), 1);
    await page.selectOption("#axis-across", "system.restitution");
    assert.equal(await cells("hit").count(), 6);
  });

  test("a click on a point shows its runs, and the case file that the program shows", async () => {
    await page.click("#diagram-arrest [data-point='10']");
    assert.match(
      await page.locator("#point h3").first().textContent(),
      /^e = 0\.9, \u03c6 = 0\.4, overlap = rewind$/,
    );
    assert.equal(await page.locator("#point tbody tr").count(), 3);
    await page.click("#point button:text('run 22')");
    const shown = workshop
      .zenosphere("sweep", "show", "s.sqlite", "--run", "22")
      .replace(/^# Run.*\n\n/, "");
    assert.equal(await page.locator("#run-case .case").textContent(), shown);
    assert.equal(await page.locator(".chosen").count(), 4);
  });

  test("findings of a store have diagrams, and are said of a run", async () => {
    const add = `import sqlite3
store = sqlite3.connect("s.sqlite")
there = {name for _, name, *_ in store.execute("PRAGMA table_info(run)")}
for name in ("first_finding", "finding", "sentence"):
    if "adjudication_" + name not in there:
        store.execute(f"ALTER TABLE run ADD COLUMN adjudication_{name} TEXT")
store.execute("UPDATE run SET adjudication_first_finding = 'near-collapse',"
              " adjudication_finding = 'singular', adjudication_sentence = 'Gaps fell.' WHERE run < 2")
store.commit()`;
    execFileSync("/usr/bin/python3", ["-c", add], { cwd: workshop.folder });
    workshop.zenosphere("report", "s.sqlite", "-o", "f.html");
    const { page: other, problems: complaints } = await opened(
      browser,
      join(workshop.folder, "f.html"),
    );
    const diagrams = await other.locator("figcaption").allTextContents();
    assert.deepEqual(diagrams.slice(4), ["first hits: near-collapse"]);
    const [first, second] = await other
      .locator("#diagram-finding-near-collapse [data-point]")
      .evaluateAll((cells) => cells.map((cell) => cell.getAttribute("aria-label")));
    assert.match(first, /: [12] of [12] runs, 100 %/);
    assert.match(second, /no run done/);
    await other.click("#diagram-finding-near-collapse [data-point='0']");
    assert.match(
      await other.locator("#run-case").textContent(),
      /First: near-collapse; the strongest of all: singular\. Gaps fell\./,
    );
    assertQuiet(complaints);
    await other.close();
  });

  test("keys alone go from point to point and choose one", async () => {
    await page.focus("#diagram-hit [tabindex='0']");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Enter");
    await drawn(page);
    assert.match(await page.locator("#point h3").first().textContent(), /^e = 0\.5, \u03c6 = 0\.4/);
  });
});
