// Elements of the page. Text is always set as text, so that nothing in a file acts as markup.

/**
 * A new element with attributes and children (elements or texts).
 *
 * An attribute whose name begins with "on" is a listener.
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

/** A button with a text and what it does. */
export const button = (text, onclick, attributes = {}) =>
  element("button", { type: "button", onclick, ...attributes }, text);

/** A section with a heading. */
export const section = (id, title, ...children) =>
  element(
    "section",
    { id, "aria-labelledby": `${id}-title` },
    element("h2", { id: `${id}-title` }, title),
    ...children,
  );

/** A table of rows; the first row is the head. */
export function table(rows, caption) {
  const [head, ...body] = rows;
  const made = element(
    "table",
    {},
    element("caption", {}, caption),
    element(
      "thead",
      {},
      element("tr", {}, ...head.map((cell) => element("th", { scope: "col" }, cell))),
    ),
    element(
      "tbody",
      {},
      ...body.map((row) =>
        element(
          "tr",
          {},
          ...row.map((cell, n) => element(n ? "td" : "th", n ? {} : { scope: "row" }, cell)),
        ),
      ),
    ),
  );
  return element(
    "div",
    { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
    made,
  );
}

/** A link that saves a text as a file. */
export const download = (text, file, label) =>
  element(
    "a",
    { download: file, href: URL.createObjectURL(new Blob([text], { type: "text/plain" })) },
    label,
  );
