// Pages of other runs in a real browser.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { assertQuiet, equipped, opened, pixels } from "./support.mjs";

const workshop = equipped();

describe("other pages", () => {
  test("one and two dimensions, walls, and runs without a log are shown", async () => {
    const cases = [
      ["rods", "mcnamara-young-1992-1d-cooling", { "run.collisions": 20000 }],
      ["disks", "mcnamara-young-1994-2d-cooling", { "run.collisions": 20000 }],
      [
        "walls",
        "rough-walls-2d-shear",
        { "run.collisions": 5000, "output.collision_log": '"none"' },
      ],
    ];
    for (const [name, source, changes] of cases) {
      const { page, problems } = await opened(workshop.browser, workshop.page(name, source, changes));
      const { green, other } = await pixels(page, ".stage canvas");
      assert.ok(green + other > 1000, `${name}: ${green + other} pixels`);
      assertQuiet(problems);
      await page.close();
    }
  });

  test("markup in a case file is shown, not obeyed", async () => {
    const hostile = `# </script><script>document.title = "owned"</script><img src=x onerror="document.title='owned'">
[system]
dimension = 2
spheres = 16
restitution = 0.9
solids_volume_fraction = 0.2
[start]
arrangement = "random"
granular_temperature = 1
seed = 1
[drive]
kind = "none"
[run]
collisions = 100
`;
    const { page, problems } = await opened(workshop.browser, workshop.page("<b>hostile<b>", hostile));
    assert.match(await page.title(), /hostile/);
    assert.equal(await page.locator("h1").textContent(), "<b>hostile<b>.h5");
    assert.match(await page.locator("#case").textContent(), /<\/script><script>document\.title/);
    assert.equal(await page.locator("img").count(), 0);
    assertQuiet(problems);
  });
});
