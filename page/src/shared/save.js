// Saves what is shown as files: pictures and numbers.
import { button, element } from "./dom.js";

/** Offers a blob to be saved under a name. */
function save(blob, name) {
  const link = element("a", { download: name, href: URL.createObjectURL(blob) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const saveText = (text, type, name) => save(new Blob([text], { type }), name);
const saveCanvas = (canvas, name) =>
  new Promise((done) =>
    canvas.toBlob((blob) => {
      save(blob, name);
      done();
    }, "image/png"),
  );

/** A name for a file, of words that may hold anything. */
export const fileStem = (...words) =>
  words
    .join("-")
    .replace(/\.(h5|sqlite)\b/g, "")
    .replace(/[^\w.-]+/g, "_");

const field = (value) => {
  const text = value === null || value === undefined || Number.isNaN(value) ? "" : String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

/** Rows of values as CSV: all digits of a number, nothing where there is none. */
export const csv = (head, rows) =>
  [head, ...rows].map((row) => [...row].map(field).join(",")).join("\n") + "\n";

/**
 * Buttons behind a word. ways: {png() -> canvas, svg() -> text, csv() -> text}, those there are;
 * what: of which, for those who hear the page.
 */
export function saveMenu(what, stem, ways) {
  const actions = {
    png: ["PNG", async () => saveCanvas(await ways.png(), `${stem()}.png`)],
    svg: ["SVG", () => saveText(ways.svg(), "image/svg+xml", `${stem()}.svg`)],
    csv: ["CSV", () => saveText(ways.csv(), "text/csv", `${stem()}.csv`)],
  };
  const buttons = Object.keys(ways).map((way) =>
    button(actions[way][0], actions[way][1], { class: way }),
  );
  const menu = element(
    "details",
    {
      class: "save",
      onkeydown: (event) => {
        event.stopPropagation(); // keys of the plot around it
        if (event.key === "Escape") menu.open = false;
      },
      onfocusout: (event) => {
        if (!menu.contains(event.relatedTarget)) menu.open = false;
      },
    },
    element("summary", { "aria-label": `Save: ${what}` }, "Save"),
    element("span", { class: "row" }, ...buttons),
  );
  return menu;
}
