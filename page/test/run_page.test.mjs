// The page of a run in a real browser.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { assertQuiet, drawn, equipped, opened, pixels } from "./support.mjs";

const PLOTS = ["gap", "time", "flight", "speed", "temperature", "pairs"];

const workshop = equipped();

const ranges = (page) =>
  page
    .locator(".plot")
    .evaluateAll((plots) =>
      plots.map(({ dataset }) => [Number(dataset.first), Number(dataset.last)]),
    );

/** Drags in a plot from one part of its width to another. */
async function drag(page, plot, from, to) {
  await page.locator(`#plot-${plot}`).scrollIntoViewIfNeeded();
  const { x, y, width, height } = await page.locator(`#plot-${plot} .u-over`).boundingBox();
  await page.mouse.move(x + from * width, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + to * width, y + height / 2, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
}

describe("the page of a true collapse", () => {
  let page, problems, file;
  before(async () => {
    file = workshop.page("collapse", "shear-e02");
    ({ page, problems } = await opened(workshop.browser, file));
  });
  after(() => assertQuiet(problems));

  test("is smaller than 5 MB and its data, and opens", async () => {
    const [open, ready] = await page.evaluate(() => [
      performance.timing.loadEventEnd - performance.timing.navigationStart,
      document.documentElement.dataset.ready,
    ]);
    const { size } = statSync(file);
    console.log(
      `page of 12 513 collisions: ${(size / 1e6).toFixed(1)} MB, loaded in ${open} ms (${ready} ms of it ours)`,
    );
    assert.ok(size < 5e6 + 5.4e6);
  });

  test("says in one sentence which pair repeats for ever", async () => {
    const text = await page.locator(".sentence").textContent();
    assert.match(text, /True collapse/);
    assert.match(text, /pair 2489\u20132526 repeats for ever/);
  });

  test("shows ink in every plot, and spheres", async () => {
    for (const plot of PLOTS) {
      const { other, red } = await pixels(page, `#plot-${plot} canvas`);
      assert.ok(other + red > 500, `${plot}: ${other + red} pixels`);
    }
    const spheres = await pixels(page, ".stage canvas");
    assert.ok(spheres.green > 2000 && spheres.red > 20, JSON.stringify(spheres));
  });

  test("names the spheres of the pair in the picture", async () => {
    assert.deepEqual(await page.locator(".names .pair").allTextContents(), ["2489", "2526"]);
  });

  test("tells values under the pointer, in every plot at once", async () => {
    await page.locator("#plot-gap .u-over").hover({ position: { x: 300, y: 60 } });
    await drawn(page);
    for (const plot of PLOTS.filter((name) => name !== "temperature")) {
      assert.match(
        await page.locator(`#plot-${plot} .readout`).textContent(),
        /collisions? [\d\u202f]+/,
        plot,
      );
    }
  });

  test("a brush in one plot selects the same range in all, and the reset button takes it back", async () => {
    const [[first, last]] = await ranges(page);
    await drag(page, "speed", 0.25, 0.5);
    const selected = await ranges(page);
    for (const range of selected) assert.deepEqual(range, selected[0]);
    const [begin, end] = selected[0].map((k) => (k - first) / (last - first));
    assert.ok(Math.abs(begin - 0.25) < 0.01 && Math.abs(end - 0.5) < 0.01, `${begin} ${end}`);
    assert.equal(
      await page.locator("#first-collision").inputValue(),
      String(Math.round(selected[0][0])),
    );
    await page.click("#reset");
    assert.deepEqual((await ranges(page))[5], [first, last]);
  });

  test("near the arrest one pair is left, and the clock does not move", async () => {
    await page.click("#plots button:text('arrest')");
    await page.locator("#plot-pairs .u-over").hover({ position: { x: 300, y: 60 } });
    await drawn(page);
    assert.match(
      await page.locator("#plot-pairs .readout").textContent(),
      /pair 2489\u20132526 \([\d\u202f]+ times/,
    );
    assert.match(await page.locator("#plot-flight .readout").textContent(), /clock does not move/);
    await page.click("#reset");
  });

  test("play goes through the snapshots, and moves their line in the plots", async () => {
    const moment = () => page.locator(".controls output").textContent();
    const [last, line] = [await moment(), await pixels(page, "#plot-time canvas")];
    await page.click("#play");
    assert.equal(await page.locator("#play").getAttribute("aria-pressed"), "true");
    await page.waitForFunction(() =>
      ["2", "3", "4", "5"].includes(document.querySelector("#snapshot").value),
    );
    assert.notEqual(await moment(), last);
    await page.click("#play");
    const paused = await moment();
    await page.waitForTimeout(600);
    assert.equal(await moment(), paused);
    assert.notEqual((await pixels(page, "#plot-time canvas")).text, line.text);
    await page.locator("#snapshot").fill("7");
  });

  test("the cluster alone hides all others", async () => {
    assert.ok((await pixels(page, ".stage canvas")).green > 2000);
    for (const show of ["alone", "moment"]) {
      await page.check(`input[value=${show}]`);
      await drawn(page);
      const { green, red, other } = await pixels(page, ".stage canvas");
      assert.ok(
        green === 0 && red > 2000 && other > 10000,
        JSON.stringify({ show, green, red, other }),
      );
    }
    await page.check("input[value=dots]");
  });

  test("spheres are coloured by speed, layer or collisions", async () => {
    await page.check("input[value=all]");
    const seen = new Set();
    for (const colour of ["speed", "layer", "collisions"]) {
      await page.selectOption("#spheres-colour", colour);
      await drawn(page);
      seen.add((await pixels(page, ".stage canvas")).text);
    }
    assert.equal(seen.size, 3);
    await page.check("input[value=dots]");
  });

  test("keys alone zoom, move and read a plot, choose a snapshot and turn the spheres", async () => {
    const [whole] = await ranges(page);
    await page.focus("#plot-gap");
    await page.keyboard.press("+");
    const [zoomed] = await ranges(page);
    assert.ok(zoomed[1] - zoomed[0] < 0.6 * (whole[1] - whole[0]));
    await page.keyboard.press("Shift+ArrowRight");
    assert.ok((await ranges(page))[0][0] > zoomed[0]);
    await page.keyboard.press("ArrowRight");
    assert.match(await page.locator("#plot-gap .readout").textContent(), /collision/);
    await page.keyboard.press("0");
    assert.deepEqual((await ranges(page))[0], whole);
    await page.focus("#snapshot");
    await page.keyboard.press("ArrowLeft");
    assert.match(await page.locator(".controls output").textContent(), /^7 of 8/);
    await page.focus(".stage canvas");
    await drawn(page);
    const before = await pixels(page, ".stage canvas");
    await page.keyboard.press("ArrowLeft");
    await drawn(page);
    assert.notEqual((await pixels(page, ".stage canvas")).text, before.text);
  });

  test("every control is reached by the tab key in the order of the page, has a name and shows its focus", async () => {
    await page.evaluate(() => scrollTo(0, 0));
    await page.mouse.click(3, 3); // the tab key goes on from here
    const reached = [];
    for (let n = 0; n < 24; ++n) {
      await page.keyboard.press("Tab");
      reached.push(
        await page.evaluate(() => {
          const { activeElement: at } = document;
          const named = at.getAttribute("aria-label") || at.labels?.length || at.textContent.trim();
          return {
            id: at.id || at.value || at.tagName,
            named: Boolean(named),
            top: at.getBoundingClientRect().top + scrollY,
            ring: getComputedStyle(at).outlineStyle,
          };
        }),
      );
    }
    const ids = reached.map(({ id }) => id);
    for (const id of [
      "first-collision",
      "reset",
      "plot-gap",
      "plot-pairs",
      "CANVAS",
      "play",
      "snapshot",
      "spheres-colour",
      "spheres-group",
      "dots",
    ]) {
      assert.ok(ids.includes(id), `${id} is not among ${ids}`);
    }
    assert.deepEqual(
      reached.filter(({ named }) => !named),
      [],
    );
    assert.deepEqual(
      reached.filter(({ ring }) => ring === "none"),
      [],
    );
    assert.ok(
      ids.indexOf("plot-gap") < ids.indexOf("plot-pairs") &&
        ids.indexOf("plot-pairs") < ids.indexOf("play"),
    );
  });

  test("tells the case, the version and the command, and carries the licences of its libraries", async () => {
    const text = await page.locator("#case").textContent();
    assert.match(text, /restitution = 0\.2/);
    assert.match(text, /build\/zenosphere run collapse\.toml -o collapse\.h5/);
    assert.match(text, new RegExp(workshop.zenosphere("--version").match(/\((.*)\)/)[1]));
    const licences = await page.locator("footer pre").textContent();
    assert.match(licences, /three [\d.]+\s+The MIT License/);
    assert.equal(
      licences,
      readFileSync(new URL("../licences.txt", import.meta.url), "utf8").trim(),
    );
  });
});

describe("the page of a run that left the hits behind", () => {
  let page, problems;
  before(async () => {
    const file = workshop.page("alarm", "shear-e06", { "run.collisions": 140000 });
    ({ page, problems } = await opened(workshop.browser, file));
  });
  after(() => assertQuiet(problems));

  test("says that the criterion was met and left", async () => {
    assert.match(
      await page.locator(".sentence").textContent(),
      /No arrest: this computation met the separation criterion and left it again/,
    );
  });

  test("keeps every collision near the first hit, though the log is too long to be kept", async () => {
    await page.locator("#plot-pairs .u-over").hover({ position: { x: 300, y: 60 } });
    assert.equal(await page.locator("#plot-pairs .readout").textContent(), "");
    await page.click("#plots button:text('first hit')");
    await page.locator("#plot-pairs .u-over").hover({ position: { x: 300, y: 60 } });
    await drawn(page);
    assert.match(
      await page.locator("#plot-pairs .readout").textContent(),
      /collision [\d\u202f]+: pair/,
    );
  });

  test("shows the row of the first hit exactly, with its ring of contacts", async () => {
    await page.check("input[value=moment]");
    await drawn(page);
    assert.equal(await page.locator(".names span").count(), 20);
    assert.match(
      await page.locator(".caption").first().textContent(),
      /exactly as they were at the first hit/,
    );
  });
});
