// The page of a sweep in a real browser.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { assertQuiet, drawn, opened, startedBrowser, Workshop } from "./support.mjs";

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

  test("has three diagrams over two axes, and a choice for the third", async () => {
    for (const which of ["hit", "arrest", "false"]) assert.equal(await cells(which).count(), 6);
    assert.match(
      await cells("arrest").first().getAttribute("aria-label"),
      /^system\.restitution = 0\.1, system\.solids_volume_fraction = 0\.1: \d of 3 runs, \d+ % \(95 %: \d+ % to \d+ %\)$/,
    );
    const before = await cells("hit").first().getAttribute("data-point");
    await page.selectOption("#axis-collision-overlap", "guarded");
    assert.notEqual(await cells("hit").first().getAttribute("data-point"), before);
    await page.selectOption("#axis-collision-overlap", "rewind");
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
      /restitution = 0\.9, .*fraction = 0\.4, .*rewind/,
    );
    assert.equal(await page.locator("#point tbody tr").count(), 3);
    await page.click("#point button:text('run 22')");
    const shown = workshop
      .zenosphere("sweep", "show", "s.sqlite", "--run", "22")
      .replace(/^# Run.*\n\n/, "");
    assert.equal(await page.locator("#run-case .case").textContent(), shown);
    assert.equal(await page.locator(".chosen").count(), 3);
  });

  test("keys alone go from point to point and choose one", async () => {
    await page.focus("#diagram-hit [tabindex='0']");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Enter");
    await drawn(page);
    assert.match(
      await page.locator("#point h3").first().textContent(),
      /restitution = 0\.5, .*fraction = 0\.4/,
    );
  });
});
