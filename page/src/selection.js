// What all parts of the page look at together: a range of collisions, and a snapshot.

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

/** A range of collision numbers inside that of the log. */
export class Selection extends Shared {
  static narrowest = 8;

  constructor(first, last) {
    super();
    this.whole = { first, last: Math.max(last, first + Selection.narrowest) };
    Object.assign(this, this.whole);
  }

  get isWhole() {
    return this.first === this.whole.first && this.last === this.whole.last;
  }

  /** Numbers that are none change nothing. */
  set(first, last) {
    if (!Number.isFinite(first + last)) return this.tell();
    const { whole } = this;
    let [low, high] = [Math.min(first, last), Math.max(first, last)].map(Math.round);
    if (!(high - low >= Selection.narrowest)) high = low + Selection.narrowest;
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
    const step = Math.round((this.last - this.first) * part);
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
