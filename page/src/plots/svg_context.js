// A drawing context that writes SVG: of CanvasRenderingContext2D what the plots use.

const escaped = (text) => String(text).replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);
const number = (value) => String(Math.round(value * 100) / 100);

/** Weight, size in pixels and family of a CSS font such as "600 13px sans-serif". */
function fontParts(font) {
  const [, weight, size, family] = font.match(/^(?:(\d+|bold) )?([\d.]+)px (.*)$/);
  return { weight: weight ?? "400", size: Number(size), family };
}

const ANCHORS = { left: "start", start: "start", center: "middle", right: "end", end: "end" };
const RISES = { top: 0.8, middle: 0.35, alphabetic: 0, bottom: -0.2 }; // of the size of the font

export class SvgContext {
  fillStyle = "#000";
  strokeStyle = "#000";
  lineWidth = 1;
  font = "10px sans-serif";
  textAlign = "start";
  textBaseline = "alphabetic";
  #dash = [];
  #move = [];
  #clip = 0; // number of the clip from 1 on, 0 for none
  #saved = [];
  #path = "";
  #parts = [];
  #clips = [];

  /** measured(font, text) -> width in pixels */
  constructor(width, height, measured) {
    Object.assign(this, { width, height, measured });
  }

  save() {
    const { fillStyle, strokeStyle, lineWidth, font, textAlign, textBaseline } = this;
    const style = { fillStyle, strokeStyle, lineWidth, font, textAlign, textBaseline };
    this.#saved.push({ style, dash: this.#dash, move: this.#move, clip: this.#clip });
  }
  restore() {
    const { style, dash, move, clip } = this.#saved.pop();
    Object.assign(this, style);
    [this.#dash, this.#move, this.#clip] = [dash, move, clip];
  }
  setLineDash(lengths) {
    this.#dash = lengths;
  }
  translate(x, y) {
    this.#move = [...this.#move, `translate(${number(x)} ${number(y)})`];
  }
  rotate(angle) {
    this.#move = [...this.#move, `rotate(${number((angle * 180) / Math.PI)})`];
  }

  beginPath() {
    this.#path = "";
  }
  moveTo(x, y) {
    this.#path += `M${number(x)} ${number(y)}`;
  }
  lineTo(x, y) {
    this.#path += `${this.#path ? "L" : "M"}${number(x)} ${number(y)}`;
  }
  closePath() {
    this.#path += "Z";
  }
  rect(x, y, width, height) {
    this.#path += rectangle(x, y, width, height);
  }
  /** A whole circle, whatever the angles. */
  arc(x, y, radius) {
    const half = (way) => `a${number(radius)} ${number(radius)} 0 1 0 ${number(way * radius)} 0`;
    this.#path += `M${number(x - radius)} ${number(y)}${half(2)}${half(-2)}Z`;
  }
  clip() {
    this.#clips.push({ path: this.#path, move: this.#move.join(" ") });
    this.#clip = this.#clips.length;
  }

  fill() {
    this.#add("path", this.#path, `fill="${escaped(this.fillStyle)}"`);
  }
  stroke() {
    const dash = this.#dash.length ? ` stroke-dasharray="${this.#dash.map(number).join(" ")}"` : "";
    const stroke = `stroke="${escaped(this.strokeStyle)}" stroke-width="${number(this.lineWidth)}"`;
    this.#add("path", this.#path, `fill="none" ${stroke}${dash}`);
  }
  fillRect(x, y, width, height) {
    this.#add("path", rectangle(x, y, width, height), `fill="${escaped(this.fillStyle)}"`);
  }
  fillText(text, x, y) {
    const { weight, size, family } = fontParts(this.font);
    const font = `font-size="${number(size)}" font-weight="${weight}" font-family="${escaped(family)}"`;
    const place = `x="${number(x)}" y="${number(y + RISES[this.textBaseline] * size)}"`;
    const anchor = `text-anchor="${ANCHORS[this.textAlign]}"`;
    const attributes = `${place} ${anchor} ${font} fill="${escaped(this.fillStyle)}"`;
    this.#add("text", escaped(text), attributes);
  }
  measureText(text) {
    return { width: this.measured(this.font, text) };
  }

  /** Paths of one look that follow each other become one. */
  #add(kind, content, look) {
    const move = this.#move.join(" ");
    const last = this.#parts.at(-1);
    const isSame = last?.look === look && last.move === move && last.clip === this.#clip;
    if (kind === "path" && last?.kind === kind && isSame) last.content += content;
    else this.#parts.push({ kind, content, look, move, clip: this.#clip });
  }

  toString() {
    const clips = this.#clips.map(
      ({ path, move }, n) =>
        `<clipPath id="clip${n + 1}"><path d="${path}"${moved(move)}/></clipPath>`,
    );
    const parts = this.#parts.map(({ kind, content, look, move, clip }) => {
      const made =
        kind === "path"
          ? `<path d="${content}" ${look}${moved(move)}/>`
          : `<text ${look}${moved(move)}>${content}</text>`;
      return clip ? `<g clip-path="url(#clip${clip})">${made}</g>` : made; // the clip is not moved
    });
    const [wide, high] = [number(this.width), number(this.height)];
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" width="${wide}" height="${high}" ` +
      `viewBox="0 0 ${wide} ${high}">\n` +
      `<defs>${clips.join("")}</defs>\n${parts.join("\n")}\n</svg>\n`
    );
  }
}

const moved = (move) => (move ? ` transform="${move}"` : "");
const rectangle = (x, y, width, height) =>
  `M${number(x)} ${number(y)}h${number(width)}v${number(height)}h${number(-width)}Z`;
