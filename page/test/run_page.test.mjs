// The page of a run in a real browser.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import {
  assertQuiet,
  drawn,
  equipped,
  excess,
  opened,
  pixels,
  saved,
  sizeOfPng,
} from "./support.mjs";

const PLOTS = ["gap", "time", "flight", "speed", "temperature", "pairs", "cooling"];
const WITHOUT_LOG = ["temperature", "cooling"];

const workshop = equipped();

const ranges = (page) =>
  page
    .locator(".plot:not(#plot-cooling)") // whose axis is time
    .evaluateAll((plots) =>
      plots.map(({ dataset }) => [Number(dataset.first), Number(dataset.last)]),
    );

/** Of the name of each axis the part under which the picture is paper. */
const paperUnderAxes = (page) =>
  page.evaluate(() => {
    const canvas = document.querySelector(".stage canvas");
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0);
    const scale = canvas.width / canvas.clientWidth;
    return [...document.querySelectorAll(".names .axis:not([hidden])")].map((name) => {
      const angle = parseFloat(name.style.rotate) || 0;
      const [wide, high] = [name.offsetWidth, name.offsetHeight];
      let [all, paper] = [0, 0];
      for (let u = -wide / 2; u <= wide / 2; u += 2) {
        for (let v = -high / 2; v <= high / 2; v += 2) {
          const x = parseFloat(name.style.left) + u * Math.cos(angle) - v * Math.sin(angle);
          const y = parseFloat(name.style.top) + u * Math.sin(angle) + v * Math.cos(angle);
          const [r, g, b] = context.getImageData(x * scale, y * scale, 1, 1).data;
          ++all;
          if (r + g + b > 740) ++paper;
        }
      }
      return { text: name.textContent, paper: paper / all };
    });
  });

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

describe("the page of an arrest", () => {
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
    assert.match(text, /Arrest: at collision/);
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
    for (const plot of PLOTS.filter((name) => !WITHOUT_LOG.includes(name))) {
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
    assert.deepEqual((await ranges(page)).at(-1), [first, last]);
  });

  test("a range that the log does not have is refused with the reason", async () => {
    const whole = await ranges(page);
    await page.fill("#first-collision", "999999");
    await page.press("#first-collision", "Enter");
    assert.equal(
      await page.locator(".why").textContent(),
      "There is no collision 999\u202f999: the log ends at 12\u202f513; the range is as it was.",
    );
    assert.deepEqual(await ranges(page), whole);
    assert.equal(await page.locator("#first-collision").inputValue(), "1");
    await page.fill("#first-collision", "12000");
    await page.press("#first-collision", "Enter");
    assert.equal(await page.locator(".why").textContent(), "");
    assert.deepEqual((await ranges(page))[0], [11999.5, 12513.5]);
    await page.click("#reset");
  });

  test("the temperature against the strain has a zoom of its own", async () => {
    const others = await ranges(page);
    await drag(page, "cooling", 0.5, 0.9);
    const { first, last } = await page.locator("#plot-cooling").evaluate(({ dataset }) => dataset);
    assert.ok(first > 0.2 && last < 0.65, `${first} ${last}`);
    assert.deepEqual(await ranges(page), others);
    await page.locator("#plot-cooling .u-over").dblclick();
    await page.locator("#plot-cooling .u-over").hover({ position: { x: 300, y: 60 } });
    await drawn(page);
    assert.match(
      await page.locator("#plot-cooling .readout").textContent(),
      /snapshot \d, collision [\d\u202f]+, time 0\.\d+: 0\.\d+/,
    );
  });

  test("each plot is saved as PNG and SVG with its axis named", async () => {
    for (const plot of PLOTS) {
      const svg = await saved(page, `#plot-${plot}`, "svg");
      assert.equal(svg.name, `collapse-${plot}.svg`);
      const text = svg.bytes.toString();
      assert.match(
        text,
        new RegExp(`>${plot === "cooling" ? "Strain" : "Collisions"}</text>`),
        plot,
      );
      assert.match(text, /collapse\.h5/);
      const count = await page.evaluate((source) => {
        const parsed = new DOMParser().parseFromString(source, "image/svg+xml");
        return parsed.querySelector("parsererror") ? -1 : parsed.querySelectorAll("text").length;
      }, text);
      assert.ok(count >= 6, `${plot}: ${count} texts`);
    }
    const { width, height } = await page.locator("#plot-gap canvas").boundingBox();
    const png = await saved(page, "#plot-gap", "png");
    assert.deepEqual(sizeOfPng(png.bytes), [2 * width, 2 * (height + 30)]);
  });

  test("the numbers of a plot are saved in all their digits", async () => {
    await page.fill("#first-collision", "1550");
    await page.press("#first-collision", "Enter");
    await page.fill("#last-collision", "1570");
    await page.press("#last-collision", "Enter");
    const { bytes } = await saved(page, "#plot-gap", "csv");
    const [head, ...rows] = bytes.toString().trim().split("\n");
    assert.equal(head, "collision,gap,hits");
    const words = ["--format", "csv-collisions", "-o", "c.csv", "--quiet"];
    workshop.zenosphere("export", "collapse.h5", ...words);
    const all = readFileSync(`${workshop.folder}/c.csv`, "utf8").trim().split("\n");
    const gap = all[0].split(",").findIndex((name) => name.startsWith("gap"));
    const wanted = all.filter((line) => Number(line.split(",")[0]) >= 1550).slice(0, 21);
    assert.deepEqual(
      rows.map((row) => row.split(",").slice(0, 2).map(Number)),
      wanted.map((line) => [line.split(",")[0], line.split(",")[gap]].map(Number)),
    );
    await page.click("#reset");
  });

  test("the spheres are saved with their names, twice as fine as on the screen", async () => {
    const { width, height } = await page.locator(".stage canvas").boundingBox();
    const { name, bytes } = await saved(page, ".sphere-view", "png");
    assert.equal(name, "collapse-snapshot-8.png");
    const size = sizeOfPng(bytes);
    assert.deepEqual(size, [2 * width, 2 * height].map(Math.round));
  });

  test("no sphere hides the name of an axis, wherever it is looked at from", async () => {
    await page.check("input[value=all]");
    await page.focus(".stage canvas");
    for (const keys of [[], ["ArrowLeft", "ArrowLeft", "ArrowUp"], Array(9).fill("ArrowRight")]) {
      for (const key of keys) await page.keyboard.press(key);
      await drawn(page);
      for (const { text, paper } of await paperUnderAxes(page))
        assert.ok(paper > 0.95, `${text}: ${paper} of it on paper`);
    }
    assert.deepEqual(
      (await paperUnderAxes(page)).map(({ text }) => text),
      ["x: flow", "y: gradient", "z: vorticity"],
    );
    await page.check("input[value=dots]");
  });

  test("a narrow window is not scrolled sideways", async () => {
    for (const width of [420, 320]) {
      await page.setViewportSize({ width, height: 900 });
      await drawn(page);
      assert.ok((await excess(page)) <= 0, `${await excess(page)} at ${width}`);
    }
    await page.setViewportSize({ width: 1500, height: 1000 });
    await drawn(page);
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
    for (let n = 0; n < 32; ++n) {
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

  test("shows which pairs collide before anybody zooms, though the log is too long to be kept", async () => {
    const { other, red } = await pixels(page, "#plot-pairs canvas");
    assert.ok(other > 3000 && red > 1000, `${other} ${red}`);
    await page.locator("#plot-pairs .u-over").hover({ position: { x: 300, y: 60 } });
    await drawn(page);
    assert.match(
      await page.locator("#plot-pairs .readout").textContent(),
      /collisions [\d\u202f]+\u2013[\d\u202f]+: /,
    );
  });

  test("keeps every collision near the first hit, though the log is too long to be kept", async () => {
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
