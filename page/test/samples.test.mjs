// What a run has accumulated, in its page, in a real browser.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { assertQuiet, drawn, equipped, excess, opened, pixels, saved } from "./support.mjs";

const DISKS = `
[system]
dimension = 2
spheres = 200
restitution = 0.9
solids_volume_fraction = 0.4
[start]
arrangement = "random"
granular_temperature = 1
seed = 1
[drive]
kind = "shear"
shear_rate = 1
[run]
time = 20
[measure]
after_time = 5
sampling_interval = 0.25
[output]
collision_log = "none"
`;
const workshop = equipped();

describe("what a run has accumulated", () => {
  let page, problems;
  before(async () => {
    ({ page, problems } = await opened(workshop.browser, workshop.page("disks", DISKS)));
    await page.locator("#samples").scrollIntoViewIfNeeded();
    await drawn(page);
  });
  after(() => assertQuiet(problems));

  for (const name of ["radial", "velocities", "fraction", "velocity", "temperature"]) {
    test(`has a curve: ${name}`, async () => {
      const { other, red } = await pixels(page, `#samples-${name} canvas`);
      assert.ok(other + red > 300, `${other + red} pixels`);
    });
  }

  // Disks that are far apart are independent of each other: g = 1, within some per cent.
  test("has a radial distribution that goes to one", async () => {
    const { bytes } = await saved(page, "#samples-radial", "csv");
    const rows = bytes.toString().trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
    assert.ok(rows[0][1] > 1.5, `g at contact: ${rows[0][1]}`);
    const far = rows.slice(-50).map(([, g]) => g);
    assert.ok(Math.abs(far.reduce((sum, g) => sum + g) / 50 - 1) < 0.03);
  });

  test("has the profile that the shear imposes", async () => {
    const { name, bytes } = await saved(page, "#samples-velocity", "csv");
    assert.equal(name, "disks-profile-velocity.csv");
    const rows = bytes.toString().trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
    const [first, last] = [rows[0], rows.at(-1)];
    assert.ok(Math.abs((last[1] - first[1]) / (last[0] - first[0]) - 1) < 0.1);
  });

  test("does not make the page wider than its window", async () => {
    assert.equal(await excess(page), 0);
  });
});
