// The averages of a run in its page, in a real browser.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { assertQuiet, drawn, equipped, excess, opened, pixels, saved } from "./support.mjs";

const SHEARED = `
[system]
dimension = 3
spheres = 256
restitution = 0.8
solids_volume_fraction = 0.3
[start]
arrangement = "random"
granular_temperature = 1
seed = 1
[drive]
kind = "shear"
shear_rate = 2
[run]
time = 20
[measure]
after_time = 5
interval = 0.25
`;
const workshop = equipped();

describe("the averages of a sheared run", () => {
  let page, problems;
  before(async () => {
    ({ page, problems } = await opened(workshop.browser, workshop.page("sheared", SHEARED)));
    await page.locator("#averages").scrollIntoViewIfNeeded();
    await drawn(page);
  });
  after(() => assertQuiet(problems));

  test("begin with the sentence that says whether they are steady", async () => {
    assert.match(await page.locator("#averages .steady").textContent(), /steady from time 5 to 20/);
  });

  test("carry their errors", async () => {
    const table = await page.locator("#averages .scroll table").textContent();
    assert.match(table, /granular temperature T[\d.]+\(\d+\)/);
    assert.match(table, /pressure tensor P_xy\u2212[\d.]+\(\d+\)/);
    assert.match(table, /normal stress differences N_2/);
    assert.match(table, /Sonine coefficient a\u2082/);
  });

  for (const name of ["temperature", "pressure", "shear", "rate", "streaks"]) {
    test(`have a curve in time: ${name}`, async () => {
      const { other, red } = await pixels(page, `#series-${name} canvas`);
      assert.ok(other + red > 500, `${other + red} pixels`);
    });
  }

  test("can be saved as a table, with a row for each interval", async () => {
    const { name, bytes } = await saved(page, "#series-temperature", "csv");
    const lines = bytes.toString().trim().split("\n");
    assert.equal(name, "sheared-series-temperature.csv");
    assert.equal(lines[0], "time,T,along x,along y,along z");
    assert.equal(lines.length, 81);
    assert.equal(Number(lines[1].split(",")[0]), 0.25);
    const [, temperature, ...parts] = lines[80].split(",").map(Number);
    assert.ok(Math.abs(parts.reduce((sum, part) => sum + part) / 3 - temperature) < 1e-5);
  });

  test("do not make the page wider than its window", async () => {
    assert.equal(await excess(page), 0);
  });
});
