// What all parts of the page look at together: a range of collisions, and a snapshot.
import { grouped } from "../shared/format.js";

/** A value with listeners. */
class Shared {
  #listeners = [];
  listen(listener) {
    this.#listeners.push(listener);
  }
  tell() {
    for (const listener of this.#listeners) listener(this);
  }
}

/** A range of collision numbers inside that of the log; or of times, which are not rounded. */
export class Selection extends Shared {
  static narrowest = 8;

  constructor(first, last, narrowest = Selection.narrowest, rounded = Math.round) {
    super();
    Object.assign(this, { narrowest, rounded });
    this.whole = { first, last: Math.max(last, first + narrowest) };
    Object.assign(this, { first: this.whole.first, last: this.whole.last });
  }

  /** A range of times, down to a billionth of the whole. */
  static ofTime(first, last) {
    return new Selection(first, last, (last - first) * 1e-9 || 1, (time) => time);
  }

  get isWhole() {
    return this.first === this.whole.first && this.last === this.whole.last;
  }

  /** Numbers that are none change nothing. */
  set(first, last) {
    if (!Number.isFinite(first + last)) return this.tell();
    const { whole } = this;
    let [low, high] = [Math.min(first, last), Math.max(first, last)].map(this.rounded);
    if (!(high - low >= this.narrowest)) high = low + this.narrowest;
    if (high > whole.last) [low, high] = [low - (high - whole.last), whole.last];
    this.first = Math.max(low, whole.first);
    this.last = high;
    this.tell();
  }

  reset() {
    this.set(this.whole.first, this.whole.last);
  }

  /** Moves by a part of what is shown. */
  pan(part) {
    const step = this.rounded((this.last - this.first) * part);
    const most = this.whole.last - this.last,
      least = this.whole.first - this.first;
    const move = Math.max(least, Math.min(most, step));
    this.set(this.first + move, this.last + move);
  }

  /** Shows `factor` as much, about a collision. */
  zoom(factor, about = (this.first + this.last) / 2) {
    this.set(about - (about - this.first) * factor, about + (this.last - about) * factor);
  }
}

/**
 * What becomes of a range that was typed: {first, last, why}.
 *
 * texts: of the two fields;  changed: 0 or 1, the one that was typed in. Where nothing can be shown
 * first and last are those of before; `why` tells what else than wanted was done, or is empty.
 */
export function wantedRange({ first, last, whole, narrowest }, texts, changed) {
  const before = { first, last };
  const wanted = texts.map((text) => (text.trim() === "" ? NaN : Number(text)));
  const typed = wanted[changed];
  const unchanged = (why) => ({ ...before, why: `${why}; the range is as it was.` });
  if (!Number.isInteger(typed)) return unchanged("A collision has a whole number");
  if (typed < whole.first)
    return unchanged(
      `There is no collision ${grouped(typed)}: the log begins at ${grouped(whole.first)}`,
    );
  if (typed > whole.last)
    return unchanged(
      `There is no collision ${grouped(typed)}: the log ends at ${grouped(whole.last)}`,
    );
  const [low, high] = wanted;
  if (high - low >= narrowest) return { first: low, last: high, why: "" };
  const width = high > low ? narrowest : last - first;
  const begin = Math.min(Math.max(changed ? high - width : low, whole.first), whole.last - width);
  const why =
    high > low
      ? `At least ${narrowest + 1} collisions are shown`
      : "A range ends after it begins: its other end was moved too";
  return { first: begin, last: begin + width, why: `${why}.` };
}

/** One of a number of things. */
export class Choice extends Shared {
  constructor(value) {
    super();
    this.value = value;
  }

  set(value) {
    if (value === this.value) return;
    this.value = value;
    this.tell();
  }
}
