// How long pages take from the start of loading until all is drawn: node measure-opening.mjs PAGE...
import { opened, startedBrowser } from "./support.mjs";

const TIMES = 7;

const browser = await startedBrowser();
for (const file of process.argv.slice(2)) {
  const seconds = [];
  for (let n = 0; n < TIMES; ++n) {
    const begun = performance.now();
    const { page, problems } = await opened(browser, file);
    seconds.push((performance.now() - begun) / 1000);
    if (problems.length > 0) throw new Error(problems.join("\n"));
    await page.close();
  }
  const told = seconds.map((each) => each.toFixed(2)).join(", ");
  console.log(`${file}: first ${seconds[0].toFixed(2)} s, then at least ${Math.min(...seconds).toFixed(2)} s (${told})`);
}
await browser.close();
