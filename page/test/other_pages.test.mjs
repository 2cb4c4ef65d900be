// Pages of other runs in a real browser.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { assertQuiet, drawn, equipped, excess, opened, pixels } from "./support.mjs";

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
      const { page, problems } = await opened(
        workshop.browser,
        workshop.page(name, source, changes),
      );
      const { green, other } = await pixels(page, ".stage canvas");
      assert.ok(green + other > 1000, `${name}: ${green + other} pixels`);
      await page.setViewportSize({ width: 420, height: 900 });
      await drawn(page);
      assert.ok((await excess(page)) <= 0, `${name}: ${await excess(page)} too wide`);
      assertQuiet(problems);
      await page.close();
    }
  });

  test("a disk is flat, and its edge is smooth", async () => {
    const changes = { "run.collisions": 50, "system.spheres": 16 };
    const { page } = await opened(
      workshop.browser,
      workshop.page("flat", "mcnamara-young-1994-2d-cooling", changes),
    );
    const found = await page.locator(".stage canvas").evaluate((canvas) => {
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const context = copy.getContext("2d");
      context.drawImage(canvas, 0, 0);
      const { data } = context.getImageData(0, 0, copy.width, copy.height);
      const counts = new Map();
      for (let n = 0; n < data.length; n += 4) {
        const colour = data.subarray(n, n + 3).join(" ");
        counts.set(colour, (counts.get(colour) ?? 0) + 1);
      }
      counts.delete("255 255 255");
      const sorted = [...counts.values()].sort((a, b) => b - a);
      const all = sorted.reduce((a, b) => a + b);
      return { flat: sorted.slice(0, 16).reduce((a, b) => a + b) / all, colours: sorted.length };
    });
    // Sixteen colours fill sixteen disks but for their rims and edges, which have many shades.
    assert.ok(found.flat > 0.6 && found.colours > 200, JSON.stringify(found));
    await page.close();
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
    const { page, problems } = await opened(
      workshop.browser,
      workshop.page("<b>hostile<b>", hostile),
    );
    assert.match(await page.title(), /hostile/);
    assert.equal(await page.locator("h1").textContent(), "<b>hostile<b>.h5");
    assert.match(await page.locator("#case").textContent(), /<\/script><script>document\.title/);
    assert.equal(await page.locator("img").count(), 0);
    assertQuiet(problems);
  });
});
